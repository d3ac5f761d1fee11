//! The cheapest reduced model, method and form that meet a tolerance in the outputs that matter.
//!
//! What is cheap is counted in evaluations of the law, and never timed: the same scene has the same choice on any machine.

use super::outputs::Watched;
use super::plan::{FINEST, Plan, Runnable, plans};
use super::receipt::{Choice, Line, Receipt, Sufficiency, Wish, cheapest};
use super::run_rows::Run;
use super::sampled_run::instants;
use integrators::taking_turns;

/// The method's share of the tolerance, with room for what its pilots do not tell.
pub(super) const OF_METHOD: f64 = 0.1;
/// Plans of a reduced model that are run.
const TRIED: usize = 3;
/// A finer run tells the method's error: their tolerances apart.
const FINER: f64 = 1e-2;
/// Evaluations of a run.
pub(super) const MOST: u64 = 5_000_000;

/// What is chosen between: the models of a scene, its own first.
pub trait Models {
    /// The names of a row.
    fn columns(&self) -> &[String];

    /// The outputs of these names with their sizes, by a coarse run of the scene's own model; and its evaluations.
    ///
    /// # Errors
    /// Why that does not reach its end.
    fn watched(&self, names: &[String]) -> Result<(Watched, u64), String>;

    /// A line for each model, judged; and the evaluations that this took.
    fn lines(&self, watched: &Watched, tolerance: f64) -> (Vec<Line>, u64);

    /// A line's model in every form.
    fn forms(&self, line: usize) -> Vec<Runnable<'_>>;

    /// The exact motion as rows at the instants, where it is kept.
    fn exact(&self) -> Option<Vec<Vec<f64>>> {
        None
    }

    /// A run that switches between models: a line of its own, last. Plans are those of the lines, the cheapest first.
    fn mixed(&self, _watched: &Watched, _lines: &[Line], _plans: &[(usize, Plan)], _wish: &Wish) -> Option<Mixed<'_>> {
        None
    }
}

/// A run at tolerances finer by a factor, with rows at these times; `None` where it does not reach its end.
pub type Finer<'a> = dyn Fn(f64, &[f64]) -> Option<Run> + 'a;

/// A run of several models.
pub struct Mixed<'a> {
    pub line: Line,
    pub plan: Plan,
    pub go: Box<Finer<'a>>,
}

/// Chooses among the models that a run takes by name. What is promised is the model's estimate, first and second order, and
/// the distance of the run from a finer one, each the largest of the whole run; none of these is a bound.
///
/// # Errors
/// Why the scene's own model does not reach its end even coarsely.
pub fn choose(models: &dyn Models, wish: &Wish) -> Result<Receipt, String> {
    let (watched, mut deciding) = models.watched(&wish.outputs)?;
    let (mut lines, spent) = models.lines(&watched, wish.tolerance);
    deciding += spent;
    let forms: Vec<Vec<Runnable<'_>>> = (0..lines.len()).map(|line| models.forms(line)).collect();
    let span = forms.iter().flatten().map(|form| form.span).fold(0.0, f64::max);
    let mut tried: Vec<(usize, Plan)> = Vec::new();
    for (at, line) in lines.iter_mut().enumerate() {
        if line.verdict != Sufficiency::Suffices {
            continue;
        }
        let found = plans(&forms[at], &watched, OF_METHOD * wish.tolerance);
        deciding += found.first().map_or(0, |plan| plan.spent);
        if found.is_empty() {
            line.verdict = Sufficiency::NotRun;
        }
        tried.extend(found.into_iter().take(TRIED).map(|plan| (at, plan)));
    }
    let mixed = models.mixed(&watched, &lines, &tried, wish).map(|mixed| {
        tried.push((lines.len(), mixed.plan));
        lines.push(mixed.line);
        mixed.go
    });
    let own = forms.len();
    let go = |(line, plan): &(usize, Plan), finer: f64, times: Option<&[f64]>| match &mixed {
        Some(mixed) if *line == own => {
            mixed(finer, times.map_or_else(|| instants(span).collect(), <[f64]>::to_vec).as_slice())
        }
        _ => {
            let form = forms[*line].iter().find(|form| form.axes == plan.axes)?;
            form.run(plan.method, (plan.tolerance * finer).max(FINEST), MOST, times).0
        }
    };
    // a pilot may have been the run
    let mut found = |one: &(usize, Plan), finer: f64, times: Option<&[f64]>| {
        let known = one.1.known(one.1.tolerance * finer).filter(|_| one.0 != own);
        known.cloned().or_else(|| go(one, finer, times).inspect(|run| deciding += run.evaluations))
    };
    let runs: Vec<Option<(Run, f64)>> = tried
        .iter()
        .map(|one| {
            let run = found(one, 1.0, None)?;
            let finer = found(one, FINER, Some(&run.times()))?;
            let apart = run.apart(&finer, &watched)?;
            Some((run, apart))
        })
        .collect();
    let times = taking_turns(tried.len(), wish.allowed, |at| runs[at].is_some() && go(&tried[at], 1.0, None).is_some());
    let exact = models.exact();
    for (((line, plan), run), time) in tried.into_iter().zip(runs).zip(times) {
        let line = &mut lines[line];
        let (Some((run, method)), Ok(model)) = (run, &line.model) else { continue };
        let promised = model.promised() + method;
        // what is no number is promised to nobody
        if promised.is_nan() || promised > wish.tolerance {
            continue;
        }
        let rows = run.at_instants(span);
        let measured = exact
            .as_ref()
            .map(|exact| rows.iter().zip(exact).map(|((_, row), exact)| watched.off(row, exact)).fold(0.0, f64::max));
        let (evaluations, seconds) = (run.evaluations, time.map(|time| time.seconds));
        if line.choice.as_ref().is_none_or(|known| evaluations < known.evaluations) {
            line.choice = Some(Choice { plan, evaluations, seconds, promised, measured, rows });
        }
    }
    let taken = cheapest(&lines, |line| line.asked_as.is_some());
    let (tolerance, columns) = (wish.tolerance, models.columns().to_vec());
    Ok(Receipt { watched, tolerance, lines, taken, deciding, columns })
}
