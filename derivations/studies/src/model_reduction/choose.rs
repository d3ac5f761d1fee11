//! The cheapest reduced model, method and form that meet a tolerance in the outputs of interest.
//!
//! The cost is counted in evaluations of the law, not timed: the choice for a scene is equal on all computers.

use super::comparison::Comparison;
use super::outputs::Watched;
use super::plan::{FINEST, Plan, Runnable, plan};
use super::receipt::{Choice, Line, Receipt, Sufficiency, Wish, Work, cheapest};
use super::run_rows::Run;
use super::sampled_run::instants;
use super::trial::Trial;
use integrators::interleaved;
use simulation::Law;

/// The method's share of the tolerance, with a margin for errors that its pilot runs do not show.
pub(super) const OF_METHOD: f64 = 0.3;
/// The ratio of the tolerances of a run and of the finer run that measures its error.
pub(super) const FINER: f64 = 1e-2;
/// Errors below this are rounding.
pub(super) const ROUNDED: f64 = 1e-15;
/// The largest number of evaluations of a run.
pub(super) const MOST: u64 = 5_000_000;

/// The models of a scene to choose from, its own first.
pub trait Models {
    /// The names of the outputs in a row.
    fn columns(&self) -> &[String];

    /// The outputs with these names and their sizes, from a coarse run of the scene's own model; and the number of its
    /// evaluations.
    ///
    /// # Errors
    /// The reason why that run does not reach its end.
    fn watched(&self, names: &[String]) -> Result<(Watched, u64), String>;

    /// A line with a verdict for each model; and the number of evaluations for the verdicts.
    fn lines(&self, watched: &Watched, tolerance: f64) -> (Vec<Line>, u64);

    /// The model of a line in every form.
    fn forms(&self, line: usize) -> Vec<Runnable<'_>>;

    /// The code size of a line's law in bytes, if known: a measure of the cost of an evaluation.
    fn code_size(&self, _line: usize) -> Option<usize> {
        None
    }

    /// The law of a line with its initial state, if known before a run.
    fn start(&self, _line: usize) -> Option<(&dyn Law, &[f64])> {
        None
    }

    /// Whether a line's law changes at events, each of which restarts the method.
    fn changes(&self, _line: usize) -> bool {
        false
    }

    /// The stored reference motion as rows at the output times, if any.
    fn exact(&self) -> Option<Vec<Vec<f64>>> {
        None
    }

    /// A run that switches between models, as the last line. `_tried` are the trials of the lines, the cheapest first.
    fn mixed(&self, _watched: &Watched, _lines: &[Line], _tried: &[Trial], _wish: &Wish) -> Option<Mixed<'_>> {
        None
    }
}

/// A run with all tolerances multiplied by a factor, with rows at these times; `None` where it does not reach its end.
pub type Finer<'a> = dyn Fn(f64, &[f64]) -> Option<Run> + 'a;

/// A run with several models.
pub struct Mixed<'a> {
    pub line: Line,
    pub plan: Plan,
    pub go: Box<Finer<'a>>,
}

/// Chooses among the models that a run can select by name. The error estimate is the error of the method plus, for a
/// reduced model, its distance from the run of the scene's own model, each the largest over the run; neither is a
/// bound.
///
/// # Errors
/// The reason why even a coarse run of the scene's own model does not reach its end, or an output that is undefined on
/// the way.
pub fn choose(models: &dyn Models, wish: &Wish) -> Result<Receipt, String> {
    let (watched, mut deciding) = models.watched(&wish.outputs)?;
    if let Some((name, time)) = &watched.without_value {
        return Err(format!("the output {name} has no value at t = {time} s; leave it out"));
    }
    let (mut lines, spent) = models.lines(&watched, wish.tolerance);
    deciding += spent;
    let forms: Vec<Vec<Runnable<'_>>> = (0..lines.len()).map(|line| models.forms(line)).collect();
    let span = forms.iter().flatten().map(|form| form.span).fold(0.0, f64::max);
    let mut tried: Vec<Trial> = Vec::new();
    let own = plan(&forms[0], &watched, OF_METHOD * wish.tolerance).and_then(|plan| {
        deciding += plan.spent;
        Trial::of_plan((0, plan), &watched, wish.tolerance, |plan, times| {
            run_of(&forms[0], plan, times).inspect(|run| deciding += run.evaluations)
        })
    });
    match own {
        None => lines[0].verdict = Sufficiency::NotRun,
        Some(own) => {
            let (models, forms, tolerance) = (models, &forms, wish.tolerance);
            let (watched, before) = (&watched, deciding);
            let mut comparison = Comparison { models, forms, watched, tolerance, own: &own, before, spent: 0 };
            let others = comparison.trials(&mut lines);
            deciding += comparison.spent;
            tried.push(own);
            tried.extend(others);
        }
    }
    let mixed = models.mixed(&watched, &lines, &tried, wish);
    let switching = mixed.and_then(|Mixed { line, plan, go }| {
        let run = go(1.0, &instants(span).collect::<Vec<_>>()).inspect(|run| deciding += run.evaluations)?;
        let finer = go(FINER, &run.times()).inspect(|run| deciding += run.evaluations)?;
        let model = line.model.as_ref().map_or(f64::INFINITY, |model| model.promised());
        let error = run.apart(&finer, &watched)? + model;
        tried.push(Trial { line: lines.len(), plan, run, error });
        lines.push(line);
        Some(go)
    });
    let own = forms.len();
    let go = |trial: &Trial| match &switching {
        Some(go) if trial.line == own => go(1.0, &instants(span).collect::<Vec<_>>()),
        _ => run_of(&forms[trial.line], &trial.plan, &instants(span).collect::<Vec<_>>()),
    };
    let times = interleaved(tried.len(), wish.allowed, |at| go(&tried[at]).is_some());
    let exact = models.exact();
    for (Trial { line, plan, run, error: promised }, time) in tried.into_iter().zip(times) {
        // a NaN is no estimate
        if promised.is_nan() || promised > wish.tolerance {
            continue;
        }
        let rows = run.at_instants(span);
        let measured = exact
            .as_ref()
            .map(|exact| rows.iter().zip(exact).map(|((_, row), exact)| watched.off(row, exact)).fold(0.0, f64::max));
        let work = Work { evaluations: run.evaluations, code: models.code_size(line) };
        let seconds = time.map(|time| time.seconds);
        lines[line].choice = Some(Choice { plan, work, seconds, promised, measured, rows });
    }
    let taken = cheapest(&lines, |line| line.asked_as.is_some());
    let (tolerance, columns) = (wish.tolerance, models.columns().to_vec());
    Ok(Receipt { watched, tolerance, lines, taken, deciding, columns })
}

/// The run of a plan, with rows at these times.
fn run_of(forms: &[Runnable<'_>], plan: &Plan, times: &[f64]) -> Option<Run> {
    let form = forms.iter().find(|form| form.axes == plan.axes)?;
    form.run(plan.method, plan.tolerance.max(FINEST), MOST, Some(times)).0
}
