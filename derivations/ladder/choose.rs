//! The cheapest rung, method and form that meet a tolerance in the outputs that matter.

use super::plan::{FINEST, Plan, Run, Runnable, plans};
use super::receipt::{Choice, Line, Receipt, Verdict, Wish};
use super::watched::Watched;
use integrators::taking_turns;
use std::time::{Duration, Instant};

/// The method's share of the tolerance, with room for what its pilots do not tell.
pub(super) const OF_METHOD: f64 = 0.1;
/// Plans of a rung that are timed.
const TIMED: usize = 3;
/// A finer run tells the method's error: their tolerances apart.
const FINER: f64 = 1e-2;
/// Evaluations of a run.
pub(super) const MOST: u64 = 5_000_000;

/// What is chosen between: the models of a scene, its own first.
pub trait Models {
    /// The names of a row.
    fn columns(&self) -> &[String];

    /// What deriving the models took.
    fn made(&self) -> Duration;

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

/// A run of several models.
pub struct Mixed<'a> {
    pub line: Line,
    pub plan: Plan,
    /// At tolerances finer by a factor; `None` where it does not reach its end.
    pub go: Box<dyn Fn(f64) -> Option<Run> + 'a>,
}

/// Chooses. What is promised is the model's estimate, first and second order, and the distance of the run from a finer one;
/// none of these is a bound.
///
/// # Errors
/// Why the scene's own model does not reach its end even coarsely.
pub fn choose(models: &dyn Models, wish: &Wish) -> Result<Receipt, String> {
    let begin = Instant::now();
    let (watched, mut deciding) = models.watched(&wish.outputs)?;
    let (mut lines, spent) = models.lines(&watched, wish.tolerance);
    deciding += spent;
    let forms: Vec<Vec<Runnable<'_>>> = (0..lines.len()).map(|line| models.forms(line)).collect();
    let mut tried: Vec<(usize, Plan)> = Vec::new();
    for (at, line) in lines.iter_mut().enumerate() {
        if line.verdict != Verdict::Suffices {
            continue;
        }
        let found = plans(&forms[at], &watched, OF_METHOD * wish.tolerance);
        deciding += found.first().map_or(0, |plan| plan.spent);
        if found.is_empty() {
            line.verdict = Verdict::NotRun;
        }
        tried.extend(found.into_iter().take(TIMED).map(|plan| (at, plan)));
    }
    let mixed = models.mixed(&watched, &lines, &tried, wish).map(|mixed| {
        tried.push((lines.len(), mixed.plan));
        lines.push(mixed.line);
        mixed.go
    });
    let own = forms.len();
    let go = |(line, plan): &(usize, Plan), finer: f64| match &mixed {
        Some(mixed) if *line == own => mixed(finer),
        _ => {
            let form = forms[*line].iter().find(|form| form.axes == plan.axes)?;
            form.run(plan.method, (plan.tolerance * finer).max(FINEST), MOST).0
        }
    };
    // a pilot may have been the run
    let mut found = |one: &(usize, Plan), finer: f64| {
        let known = one.1.known(one.1.tolerance * finer).filter(|_| one.0 != own);
        known.cloned().or_else(|| go(one, finer).inspect(|run| deciding += run.evaluations))
    };
    let (ended, finer): (Vec<Option<Run>>, Vec<Option<Run>>) =
        tried.iter().map(|one| (found(one, 1.0), found(one, FINER))).unzip();
    let took = (begin.elapsed() + models.made()).as_secs_f64();
    let times = taking_turns(tried.len(), wish.allowed, |at| ended[at].is_some() && go(&tried[at], 1.0).is_some());
    // costs of different kinds are not compared: without all times, evaluations decide
    let timed = times.iter().zip(&ended).all(|(time, run)| time.is_some() || run.is_none());
    let exact = models.exact();
    for ((((line, plan), run), finer), time) in tried.into_iter().zip(ended).zip(finer).zip(times) {
        let line = &mut lines[line];
        let (Some(run), Some(finer), Ok(model)) = (run, finer, &line.model) else { continue };
        let apart = |rows: &mut dyn Iterator<Item = f64>| rows.fold(0.0, f64::max);
        let method = apart(&mut run.rows.iter().zip(&finer.rows).map(|((_, row), (_, finer))| watched.off(row, finer)));
        let measured = exact
            .as_ref()
            .map(|exact| apart(&mut run.rows.iter().zip(exact).map(|((_, row), exact)| watched.off(row, exact))));
        let promised = model.promised() + method;
        if promised > wish.tolerance {
            continue;
        }
        let seconds = time.filter(|_| timed).map(|time| time.seconds);
        let choice = Choice { plan, evaluations: run.evaluations, seconds, promised, measured, rows: run.rows };
        if line.choice.as_ref().is_none_or(|known| cost(&choice) < cost(known)) {
            line.choice = Some(choice);
        }
    }
    let serving = (0..lines.len()).filter_map(|at| Some((at, cost(lines[at].choice.as_ref()?))));
    let taken = serving.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(at, _)| at);
    let (tolerance, columns) = (wish.tolerance, models.columns().to_vec());
    Ok(Receipt { watched, tolerance, lines, taken, deciding, took, columns })
}

/// Time where all were taken, else evaluations.
fn cost(choice: &Choice) -> f64 {
    choice.seconds.unwrap_or(choice.evaluations as f64)
}
