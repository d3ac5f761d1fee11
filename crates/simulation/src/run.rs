//! The table `[run]` of a scene: span, tolerance, method and outputs.

use super::methods;
use integrators::Method;
use reader::{At, Issue, Table};
use units::nearest;

/// The smallest tolerance in double precision.
const FINEST: f64 = 1e-14;
/// The largest number of output times.
const MOST_SAMPLES: usize = 1_000_000;
/// The memory in bytes for the rows of a run. With constant steps the states, and those of two shorter runs, are stored
/// too.
const ROOM: usize = 1 << 28;
/// The memory in bytes of an output time besides its numbers.
const BESIDE_NUMBERS: usize = 64;

/// The largest number of output times of a run, for rows of `columns` numbers.
pub fn most_samples(columns: usize) -> usize {
    (ROOM / (columns * size_of::<f64>() + BESIDE_NUMBERS)).min(MOST_SAMPLES)
}

/// The table `[run]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// The length of the run, s; it begins at time zero.
    pub span: f64,
    /// The number of output times after the start.
    pub samples: usize,
    /// The tolerance of a step: relative, and absolute in SI units.
    pub tolerance: f64,
    /// The method; Dormand-Prince 8(5,3) if the scene names none.
    pub method: Method,
    /// Whether the run continues beyond singular positions of its constraints, on the smooth branch of its motion.
    pub through_singular_positions: bool,
    /// The names of the states to show.
    pub outputs: Vec<String>,
}

/// Reads the table `run`. The names of `outputs` are compared with the names `known` of columns; `None`: they are not
/// checked. Faults are added to `issues`. `None` if the table is missing or has a fault.
pub fn read(top: &mut Table<'_>, issues: &mut Vec<Issue>, known: Option<&[String]>) -> Option<Run> {
    let mut table = top.table("run", "the span of time and the tolerance");
    let run = keys(&mut table, known.map_or(0, <[String]>::len));
    let outputs = table.texts("outputs", "[\"slip\"]");
    if let Some(known) = known {
        outputs.iter().for_each(|output| check_output(&mut table, output, known));
    }
    let sound = table.exists() && !table.has_issues();
    issues.extend(table.finish());
    let run = run.filter(|_| sound)?;
    Some(Run { outputs: outputs.into_iter().map(|output| output.value).collect(), ..run })
}

/// The default tolerance of a step.
const USUAL: f64 = 1e-8;

/// Reads all keys except `outputs`, for rows of `columns` numbers.
fn keys(table: &mut Table<'_>, columns: usize) -> Option<Run> {
    let span = table.scalar("span", "length of the run", "s");
    if span.value <= 0.0 {
        let issue = Issue::at(span.span, "`span` must be positive", format!("it is {} s", span.value));
        table.report(issue.accepted("a positive time is accepted, such as \"2 s\""));
    }
    let (most, mut kept) = (most_samples(columns), "number of instants that are kept".to_owned());
    if most < MOST_SAMPLES {
        kept += &format!(", each with {columns} numbers");
    }
    let samples = table.optional_count("samples", &kept, 1, most);
    let tolerance = table.optional_scalar("tolerance", "error allowed in a step", "1");
    if let Some(At { value, span }) = &tolerance
        && !table.has_issue_at(span)
        && let Err(wrong) = check_tolerance(*value)
    {
        let issue = Issue::at(span.clone(), "`tolerance` is out of range", wrong);
        table.report(issue.accepted(format!("from {FINEST:e} to below 1 is accepted, such as 1e-8")));
    }
    let method = table.optional_text("method", "name of a method");
    let method = method.map_or(Ok(Method::DormandPrince8), |At { value, span }| {
        methods::method(&value).map_err(|(wrong, accepted)| Issue::at(span, wrong, "not accepted").accepted(accepted))
    });
    let method = method.map_err(|issue| table.report(issue)).ok()?;
    let passes = "whether the run goes on beyond singular positions of its constraints, on the smooth branch";
    let through_singular_positions = table.flag("through_singular_positions", passes);
    Some(Run {
        span: span.value,
        samples: samples.map_or(200, |samples| samples.value),
        tolerance: tolerance.map_or(USUAL, |tolerance| tolerance.value),
        method,
        through_singular_positions,
        outputs: Vec::new(),
    })
}

/// Checks the range of a tolerance.
///
/// # Errors
/// The reason why it is not accepted.
pub fn check_tolerance(tolerance: f64) -> Result<(), String> {
    match tolerance {
        t if (FINEST..1.0).contains(&t) => Ok(()),
        t if t > 0.0 && t < FINEST => Err(format!("it is {t:e}, below the rounding of double precision")),
        t => Err(format!("it is {t}")),
    }
}

fn check_output(table: &mut Table<'_>, output: &At<String>, names: &[String]) {
    if names.contains(&output.value) {
        return;
    }
    let list = names.join(", ");
    let accepted = match nearest(&output.value, names.iter().map(String::as_str)) {
        Some(nearest) => format!("is `{nearest}` meant? Known: {list}"),
        None => format!("known: {list}"),
    };
    let title = format!("unknown output `{}`", output.value);
    table.report(Issue::at(output.span.clone(), title, "no state has this name").accepted(accepted));
}
