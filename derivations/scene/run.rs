//! How long, how exactly and by which method a scene runs.

use super::issue::{Issue, nearest};
use super::methods;
use super::read::{At, Table};
use super::state::{ROTOR_SPEED, names};
use crate::machines::AnyMachine;
use integrators::Method;

/// The finest tolerance that double precision leaves room for.
const FINEST: f64 = 1e-14;
/// More instants than anyone looks at.
pub const MOST_SAMPLES: usize = 1_000_000;

/// The table `[run]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// How long, s; from time zero.
    pub span: f64,
    /// How many instants are kept, beside the start.
    pub samples: usize,
    /// Of a step, relative, and absolute in SI units.
    pub tolerance: f64,
    /// Dormand-Prince 8(5,3) where the scene names none.
    pub method: Method,
    /// What to look at, by the names of the states.
    pub outputs: Vec<String>,
}

/// Reads it.
pub fn read(top: &mut Table<'_>, issues: &mut Vec<Issue>, on_bench: bool, machine: Option<&AnyMachine>) -> Option<Run> {
    let mut table = top.table("run", "the span of time and the tolerance");
    let span = table.scalar("span", "length of the run", "s");
    if span.value <= 0.0 {
        let issue = Issue::at(span.span, "`span` must be positive", format!("it is {} s", span.value));
        table.report(issue.accepted("a positive time is accepted, such as \"2 s\""));
    }
    let samples = table.optional_count("samples", "number of instants that are kept", 1, MOST_SAMPLES);
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
    let outputs = table.texts("outputs", "[\"slip\"]");
    if let Some(machine) = machine {
        for output in &outputs {
            check_output(&mut table, output, &names(on_bench, machine));
        }
    }
    let method = method.map_err(|issue| table.report(issue)).ok();
    let sound = table.exists() && !table.has_issues();
    issues.extend(table.finish());
    let method = method.filter(|_| sound)?;
    Some(Run {
        span: span.value,
        samples: samples.map_or(200, |samples| samples.value),
        tolerance: tolerance.map_or(1e-8, |tolerance| tolerance.value),
        method,
        outputs: outputs.into_iter().map(|output| output.value).collect(),
    })
}

/// Why a tolerance cannot be worked with.
pub fn check_tolerance(tolerance: f64) -> Result<(), String> {
    match tolerance {
        t if (FINEST..1.0).contains(&t) => Ok(()),
        t if t > 0.0 && t < FINEST => Err(format!("it is {t:e}, below the rounding of double precision")),
        t => Err(format!("it is {t}")),
    }
}

fn check_output(table: &mut Table<'_>, output: &At<String>, states: &[String]) {
    let known = || states.iter().map(String::as_str).chain([ROTOR_SPEED]);
    if known().any(|name| name == output.value) {
        return;
    }
    let list = known().collect::<Vec<_>>().join(", ");
    let accepted = match nearest(&output.value, known()) {
        Some(nearest) => format!("is `{nearest}` meant? Known: {list}"),
        None => format!("known: {list}"),
    };
    let title = format!("unknown output `{}`", output.value);
    table.report(Issue::at(output.span.clone(), title, "no state has this name").accepted(accepted));
}
