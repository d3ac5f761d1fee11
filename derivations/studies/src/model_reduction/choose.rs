//! The cheapest reduced model, method and form that meet a tolerance in the outputs that matter.
//!
//! What is cheap is counted in evaluations of the law, and never timed: the same scene has the same choice on any machine.

use super::Loss;
use super::outputs::Watched;
use super::plan::{FINEST, Plan, Runnable, between, by_kind, error_at, plans};
use super::receipt::{Choice, Line, Receipt, Sufficiency, Wish, Work, cheapest};
use super::run_rows::Run;
use super::sampled_run::instants;
use integrators::taking_turns;
use std::cell::RefCell;

/// The method's share of the tolerance, with room for what its pilots do not tell.
pub(super) const OF_METHOD: f64 = 0.3;
/// A finer run tells the method's error: their tolerances apart.
const FINER: f64 = 1e-2;
/// The least power of the tolerance with which errors are believed to go.
const LEAST_SLOPE: f64 = 0.5;
/// Runs of the scene's own model that trying smaller ones may cost: those that are too far off end early.
const PRICE: f64 = 2.0;
/// A simplification that costs more than this share of the scene's own model saves too little.
const WORTH: f64 = 0.8;
/// Errors below this are rounding.
const ROUNDED: f64 = 1e-15;
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

    /// Whether the error of a line's model is told by its run beside that of the scene's own; else the line has an estimate that
    /// is promised.
    fn is_compared(&self, _line: usize) -> bool {
        false
    }

    /// Bytes of the code of a line's law, where it is known: what an evaluation costs.
    fn code_size(&self, _line: usize) -> Option<usize> {
        None
    }

    /// Whether a line's law asks for an implicit method.
    fn is_stiff(&self, _line: usize) -> bool {
        false
    }

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

/// Chooses among the models that a run takes by name. What is promised is the model's error, estimated to first and second order
/// or seen beside a run of the scene's own model, and the method's, each the largest of the whole run; none of these is a bound.
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
        if line.verdict != Sufficiency::Suffices || models.is_compared(at) {
            continue;
        }
        let found = plans(&forms[at], &watched, OF_METHOD * wish.tolerance);
        deciding += found.first().map_or(0, |plan| plan.spent);
        if found.is_empty() {
            line.verdict = Sufficiency::NotRun;
        }
        tried.extend(found.into_iter().take(1).map(|plan| (at, plan)));
    }
    let run_of = |(line, plan): &(usize, Plan), finer: f64, times: Option<&[f64]>| {
        let form = forms[*line].iter().find(|form| form.axes == plan.axes)?;
        form.run(plan.method, (plan.tolerance * finer).max(FINEST), MOST, times).0
    };
    let mut runs: Vec<Option<(Run, f64)>> = Vec::new();
    for (line, plan) in &mut tried {
        let (of_line, of_plan) = (*line, plan.clone());
        let at =
            |tolerance: f64, times: &[f64]| run_of(&(of_line, Plan { tolerance, ..of_plan.clone() }), 1.0, Some(times));
        let (run, spent) = settled(plan, &watched, wish.tolerance, at);
        deciding += spent;
        runs.push(run);
    }
    let compared = compared(models, &mut lines, &forms, &watched, wish, tried.first().zip(runs.first()), &mut deciding);
    tried.extend(compared.iter().map(|(line, plan, ..)| (*line, plan.clone())));
    runs.extend(compared.into_iter().map(|(_, _, run, off)| Some((run, off))));
    let own = forms.len();
    let mixed = models.mixed(&watched, &lines, &tried, wish).map(|mixed| {
        tried.push((lines.len(), mixed.plan));
        lines.push(mixed.line);
        mixed.go
    });
    let go = |one: &(usize, Plan), finer: f64, times: Option<&[f64]>| match &mixed {
        Some(mixed) if one.0 == own => {
            mixed(finer, times.map_or_else(|| instants(span).collect(), <[f64]>::to_vec).as_slice())
        }
        _ => run_of(one, finer, times),
    };
    if mixed.is_some() {
        let run = tried.last().and_then(|one| {
            let run = go(one, 1.0, None).inspect(|run| deciding += run.evaluations)?;
            let finer = go(one, FINER, Some(&run.times())).inspect(|run| deciding += run.evaluations)?;
            let off = run.apart(&finer, &watched)?;
            Some((run, off))
        });
        runs.push(run);
    }
    let times = taking_turns(tried.len(), wish.allowed, |at| runs[at].is_some() && go(&tried[at], 1.0, None).is_some());
    let exact = models.exact();
    for (((line, plan), run), time) in tried.into_iter().zip(runs).zip(times) {
        let Some((run, method)) = run else { continue };
        let estimated = match (&lines[line].model, line < own && models.is_compared(line)) {
            (_, true) => 0.0,
            (Ok(model), false) => model.promised(),
            (Err(_), false) => continue,
        };
        let promised = estimated + method;
        // what is no number is promised to nobody
        if promised.is_nan() || promised > wish.tolerance {
            continue;
        }
        let rows = run.at_instants(span);
        let measured = exact
            .as_ref()
            .map(|exact| rows.iter().zip(exact).map(|((_, row), exact)| watched.off(row, exact)).fold(0.0, f64::max));
        let (evaluations, seconds) = (run.evaluations, time.map(|time| time.seconds));
        let work = Work { evaluations, code: models.code_size(line) };
        lines[line].choice = Some(Choice { plan, work, seconds, promised, measured, rows });
    }
    let taken = cheapest(&lines, |line| line.asked_as.is_some());
    let (tolerance, columns) = (wish.tolerance, models.columns().to_vec());
    Ok(Receipt { watched, tolerance, lines, taken, deciding, columns })
}

/// The run of a plan with the error of its method, and the evaluations that this took. Where both pilots are coarser the error is
/// told by the slope of theirs; where that is not believed, or too large, a finer run tells it, or takes its place.
fn settled(
    plan: &mut Plan,
    watched: &Watched,
    most: f64,
    go: impl Fn(f64, &[f64]) -> Option<Run>,
) -> (Option<(Run, f64)>, u64) {
    let mut spent = 0;
    let mut made = |tolerance: f64, times: &[f64]| go(tolerance, times).inspect(|run| spent += run.evaluations);
    let known = plan.known(plan.tolerance).cloned();
    let run = known.clone().or_else(|| made(plan.tolerance, &plan.pilots[1].run.times()));
    let Some(run) = run else { return (None, spent) };
    let factor = between(plan.method);
    let [coarse, fine] = &plan.pilots;
    let by_pilots = match (known, coarse.run.apart(&run, watched), fine.run.apart(&run, watched)) {
        (Some(_), ..) => Some(plan.error_at(plan.tolerance)),
        // the finer pilot stands for the exact motion, with its own error
        (None, _, Some(off)) if plan.tolerance > fine.tolerance => Some(factor * off + plan.error_at(fine.tolerance)),
        (None, Some(of_coarse), Some(of_fine)) => {
            let slope = (of_coarse / of_fine).ln() / (coarse.tolerance / fine.tolerance).ln();
            (slope >= LEAST_SLOPE).then(|| error_at(factor * of_fine, plan.tolerance / fine.tolerance))
        }
        _ => None,
    };
    if let Some(error) = by_pilots.filter(|error| *error <= most) {
        return (Some((run, error.max(ROUNDED))), spent);
    }
    let finer = (plan.tolerance * FINER).max(FINEST);
    let Some(better) = made(finer, &run.times()) else { return (by_pilots.map(|error| (run, error)), spent) };
    let Some(off) = run.apart(&better, watched).map(|off| (factor * off).max(ROUNDED)) else { return (None, spent) };
    if off <= most {
        return (Some((run, off)), spent);
    }
    let error = error_at(off, finer / plan.tolerance);
    plan.tolerance = finer;
    (Some((better, error)), spent)
}

/// Simplifications run beside the scene's own model, the most promising first, as long as deciding may cost that: each with its
/// distance from it and the error of that.
fn compared(
    models: &dyn Models,
    lines: &mut [Line],
    forms: &[Vec<Runnable<'_>>],
    watched: &Watched,
    wish: &Wish,
    own: Option<(&(usize, Plan), &Option<(Run, f64)>)>,
    deciding: &mut u64,
) -> Vec<(usize, Plan, Run, f64)> {
    let Some(((0, plan), Some((run, error)))) = own else { return Vec::new() };
    let size = |line: usize| models.code_size(line).map_or(1.0, |bytes| bytes as f64);
    let share = |line: usize| if models.code_size(line).is_some() { size(line) / size(0) } else { 1.0 };
    let mut order: Vec<usize> = (0..forms.len())
        .filter(|&line| models.is_compared(line) && lines[line].verdict == Sufficiency::Suffices)
        .collect();
    // exact ones first, then those that leave out the most
    order.sort_by_key(|&line| (matches!(lines[line].loss, Loss::Small { .. }), lines[line].states));
    let times = run.times();
    let mut found: Vec<(usize, Plan, Run, f64)> = Vec::new();
    let mut left = PRICE * run.evaluations as f64;
    for line in order {
        let is_exact = !matches!(lines[line].loss, Loss::Small { .. });
        // what leaves out less than one that serves saves less
        let served = found.iter().any(|(known, ..)| lines[*known].states <= lines[line].states);
        let Some(form) = forms[line].first().filter(|_| left > 0.0 && !served) else {
            lines[line].verdict = Sufficiency::NotTried;
            continue;
        };
        let is_stiff = models.is_stiff(line);
        let fewer = lines[line].states as f64 / lines[0].states as f64;
        // where it is as stiff, or as smooth, only a shorter law is cheaper; an implicit method saves with its states too
        let costs = match (is_stiff, plan.method.traits().implicit) {
            (true, true) => share(line) * fewer,
            (false, false) if fewer == 1.0 => share(line),
            _ => 0.0,
        };
        if costs > WORTH {
            lines[line].verdict = Sufficiency::NotCheaper;
            continue;
        }
        let most = (WORTH * run.evaluations as f64 / share(line)) as u64;
        let mut tolerance = plan.tolerance.min(finest_of(wish));
        let mut judged = Sufficiency::NotCheaper;
        for _ in 0..if is_exact { 2 } else { 1 } {
            let mut is_too_far = false;
            let near = run.near(watched, (wish.tolerance - error) / between(plan.method));
            let mut by = |implicit: bool| {
                by_kind(implicit, |method| {
                    let serves = RefCell::new(|time: f64, row: &[f64]| {
                        is_too_far |= !near(time, row);
                        !is_too_far
                    });
                    let most = most.min((left / share(line)).max(0.0) as u64);
                    let serves = |time: f64, row: &[f64]| (serves.borrow_mut())(time, row);
                    let (ran, spent) = form.run_while((method, tolerance, most), &times, &serves);
                    let cost = (spent as f64 * share(line)).ceil();
                    left -= cost;
                    *deciding += cost as u64;
                    (ran, spent)
                })
            };
            // transients may be slow at the start, and not later
            let other = || plan.method.traits().implicit && !is_stiff;
            let ran = match by(is_stiff) {
                None if other() => by(true),
                ran => ran,
            };
            if let Some((method, ran)) = ran
                && let Some(off) = run.apart(&ran, watched)
            {
                let off = between(method) * off + error;
                if off > wish.tolerance {
                    judged = Sufficiency::TooFar;
                    break;
                }
                found.push((line, Plan { method, tolerance, ..plan.clone() }, ran, off));
                judged = Sufficiency::Suffices;
                break;
            }
            if !is_too_far {
                break;
            }
            judged = Sufficiency::TooFar;
            tolerance = (tolerance * FINER).max(FINEST);
        }
        lines[line].verdict = judged;
    }
    found
}

/// The tolerance at which a method usually keeps its share of what is allowed.
fn finest_of(wish: &Wish) -> f64 {
    (0.1 * OF_METHOD * wish.tolerance).max(FINEST)
}
