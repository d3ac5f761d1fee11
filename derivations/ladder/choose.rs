//! The cheapest rung, method and form that meet a tolerance in the outputs that matter, and the receipt.

use super::estimate::{Estimate, Watched};
use super::plan::{FINEST, Plan, Run, Runnable, plans};
use super::switching::Schedule;
use super::{Ladder, Loss};
use crate::scene::{Axes, Stored};
use integrators::{Failure, taking_turns};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// What is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Wish {
    /// Relative to the size of each output.
    pub tolerance: f64,
    pub outputs: Vec<String>,
    /// For the times, and before that for where to switch; nothing of either where it is zero.
    pub allowed: Duration,
}

/// The share of the tolerance that the model may take; the method has the rest.
const OF_MODEL: f64 = 0.5;
/// The method's share, with room for what its pilots do not tell.
const OF_METHOD: f64 = 0.1;
/// Where the second order is more than this share of the first, the estimate is no estimate.
const BELIEVED: f64 = 0.5;
/// Errors below this share of what is allowed need no belief.
const MINUTE: f64 = 1e-3;
/// Plans of a rung that are timed.
const TIMED: usize = 3;
/// A finer run tells the method's error: their tolerances apart.
const FINER: f64 = 1e-2;
/// A smaller model for less than this share of the run is not worth switching to.
const WORTH_WHILE: f64 = 0.1;
/// Evaluations of a run.
const MOST: u64 = 5_000_000;

/// A rung as the receipt has it.
#[derive(Clone, Debug)]
pub struct Line {
    pub name: &'static str,
    pub dropped: String,
    pub loss: Loss,
    pub states: usize,
    /// The largest value of its small parameter along its run.
    pub small: Option<f64>,
    pub model: Result<Estimate, Failure>,
    /// Why it is not taken, where it cannot be.
    pub verdict: Verdict,
    /// The best run of it.
    pub choice: Option<Choice>,
}

/// Whether a rung serves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It does.
    Suffices,
    /// Its error is estimated above what is allowed.
    TooFar,
    /// The second order is not small: nothing is promised.
    NotBelieved,
    /// The carried error did not reach the end.
    NotCarried,
    /// No method reached the end.
    NotRun,
}

/// A run.
#[derive(Clone, Debug)]
pub struct Choice {
    pub plan: Plan,
    pub evaluations: u64,
    /// The median, s; taken side by side with all others.
    pub seconds: Option<f64>,
    /// Model and method: an estimate.
    pub promised: f64,
    /// By the reference that is kept, where there is one.
    pub measured: Option<f64>,
    /// Rows at the instants.
    pub rows: Vec<(f64, Vec<f64>)>,
}

/// What was chosen and why.
#[derive(Clone, Debug)]
pub struct Receipt {
    pub watched: Watched,
    pub tolerance: f64,
    /// From the scene's own model down.
    pub lines: Vec<Line>,
    /// The line that was taken; none where none serves.
    pub taken: Option<usize>,
    /// Evaluations of all pilots, estimates and runs; the transition matrices of a schedule come on top.
    pub deciding: u64,
    /// What all of that took, s, the schedule too; taking times on top is for the receipt.
    pub took: f64,
    /// Names of a row.
    pub columns: Vec<String>,
}

impl Receipt {
    /// Time of the scene's own model by its best method over that of the one taken.
    pub fn saved(&self) -> Option<f64> {
        let seconds = |line: &Line| line.choice.as_ref().and_then(|choice| choice.seconds);
        Some(seconds(self.lines.first()?)? / seconds(&self.lines[self.taken?])?)
    }

    /// What deciding took in runs of the scene's own model.
    pub fn worth(&self) -> Option<f64> {
        Some(self.took / self.lines.first()?.choice.as_ref()?.seconds?)
    }

    /// The run from which on it has paid to decide; none where nothing is saved.
    pub fn pays_from(&self) -> Option<u64> {
        let saved = 1.0 - 1.0 / self.saved()?;
        (saved > 0.0).then_some((self.worth()? / saved).ceil() as u64)
    }
}

/// Chooses. What is promised is the model's estimate, first and second order, and the distance of the run from a finer one;
/// none of these is a bound. Ladders are those of one scene, in each form that it has.
///
/// # Errors
/// Where the scene's own law does not reach its end even coarsely.
pub fn choose(ladders: &[Ladder], kept: Option<&Stored>, wish: &Wish) -> Result<Receipt, Failure> {
    let (ladder, begin) = (&ladders[0], Instant::now());
    let (watched, mut deciding) = ladder.watched(&wish.outputs)?;
    let exact = kept.filter(|kept| kept.serves(&ladder.own)).map(|kept| reference_rows(ladder, kept));
    let mut lines = vec![Line {
        name: ladder.model,
        dropped: String::new(),
        loss: Loss::Own,
        states: ladder.own.state.len(),
        small: None,
        model: Ok(Estimate::nothing(watched.columns.len())),
        verdict: Verdict::Suffices,
        choice: None,
    }];
    for rung in &ladder.rungs {
        let model = ladder.estimate(rung, &watched, wish.tolerance);
        deciding += model.as_ref().map_or(0, |model| model.evaluations);
        let verdict = match &model {
            Err(_) => Verdict::NotCarried,
            Ok(model) if model.second > BELIEVED * model.first.max(MINUTE * wish.tolerance) => Verdict::NotBelieved,
            Ok(model) if model.promised() > OF_MODEL * wish.tolerance => Verdict::TooFar,
            Ok(_) => Verdict::Suffices,
        };
        lines.push(Line {
            name: rung.name,
            dropped: rung.dropped.clone(),
            loss: rung.loss,
            states: rung.start.len(),
            small: ladder.small(rung),
            model,
            verdict,
            choice: None,
        });
    }
    let mut tried: Vec<Tried> = Vec::new();
    for (at, line) in lines.iter_mut().enumerate() {
        if line.verdict != Verdict::Suffices {
            continue;
        }
        let found = plans(&forms(ladders, at), &watched, OF_METHOD * wish.tolerance);
        deciding += found.first().map_or(0, |plan| plan.spent);
        if found.is_empty() {
            line.verdict = Verdict::NotRun;
        }
        tried.extend(found.into_iter().take(TIMED).map(|plan| Tried { line: at, plan, switching: None }));
    }
    let mixed = mix(ladder, &watched, &mut lines, &tried, wish);
    tried.extend(mixed);
    let go = |one: &Tried, finer: f64| {
        let tolerance = (one.plan.tolerance * finer).max(FINEST);
        match &one.switching {
            Some((rung, schedule, low)) => {
                let sides = [(one.plan.method, tolerance), (low.method, (low.tolerance * finer).max(FINEST))];
                ladder.run_switching(&ladder.rungs[*rung], schedule, sides, MOST)
            }
            None => {
                runnable(&ladders[form(one.plan.axes)], one.line, one.plan.axes).run(one.plan.method, tolerance, MOST).0
            }
        }
    };
    // a pilot may have been the run
    let mut found = |one: &Tried, finer: f64| {
        let known = one.plan.known(one.plan.tolerance * finer).filter(|_| one.switching.is_none());
        known.cloned().or_else(|| go(one, finer).inspect(|run| deciding += run.evaluations))
    };
    let (ended, finer): (Vec<Option<Run>>, Vec<Option<Run>>) =
        tried.iter().map(|one| (found(one, 1.0), found(one, FINER))).unzip();
    let took = begin.elapsed().as_secs_f64();
    let times = taking_turns(tried.len(), wish.allowed, |at| ended[at].is_some() && go(&tried[at], 1.0).is_some());
    // costs of different kinds are not compared: without all times, evaluations decide
    let timed = times.iter().zip(&ended).all(|(time, run)| time.is_some() || run.is_none());
    for (((one, run), finer), time) in tried.into_iter().zip(ended).zip(finer).zip(times) {
        let line = &mut lines[one.line];
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
        let (plan, evaluations, rows) = (one.plan, run.evaluations, run.rows);
        let choice = Choice { plan, evaluations, seconds, promised, measured, rows };
        if line.choice.as_ref().is_none_or(|known| cost(&choice) < cost(known)) {
            line.choice = Some(choice);
        }
    }
    let serving = (0..lines.len()).filter_map(|at| Some((at, cost(lines[at].choice.as_ref()?))));
    let taken = serving.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(at, _)| at);
    let (tolerance, columns) = (wish.tolerance, ladder.own.columns.clone());
    Ok(Receipt { watched, tolerance, lines, taken, deciding, took, columns })
}

/// A plan of a line, and where the run switches to a rung with a plan of its own.
struct Tried {
    line: usize,
    plan: Plan,
    switching: Option<(usize, Schedule, Plan)>,
}

/// The rung that does not suffice for the whole run but for the largest part of it, with the richest that does for the rest:
/// a line of its own, last. Where a smaller model suffices for the whole run nothing is switched: those below it are hardly
/// smaller.
fn mix(ladder: &Ladder, watched: &Watched, lines: &mut Vec<Line>, tried: &[Tried], wish: &Wish) -> Option<Tried> {
    // the law that the rungs are derived from is the exact one next to the scene's own, or that
    let rich = usize::from(ladder.lumping.is_some());
    let plan = tried.iter().find(|one| one.line == rich)?.plan.clone();
    // transition matrices come from series, which stiff windings would keep short
    let whole = |line: &Line| line.verdict == Verdict::Suffices && matches!(line.loss, Loss::Small { .. });
    if plan.method.traits().implicit || lines.iter().any(whole) {
        return None;
    }
    let far = |line: &Line| matches!(line.verdict, Verdict::TooFar | Verdict::NotBelieved);
    let course = ladder.course(watched, Some(Instant::now() + wish.allowed)).ok()?;
    let unfit = ladder.rungs.iter().enumerate().filter(|(at, _)| far(&lines[at + 1]));
    let schedules = unfit.filter_map(|(at, rung)| {
        let schedule = ladder.schedule(rung, &course, OF_MODEL * wish.tolerance)?;
        (schedule.share() >= WORTH_WHILE).then_some((at, schedule))
    });
    let (at, schedule) = schedules.max_by(|a, b| a.1.share().total_cmp(&b.1.share()))?;
    let forms = forms(std::slice::from_ref(ladder), at + 1);
    let low = plans(&forms, watched, OF_METHOD * wish.tolerance).into_iter().next()?;
    let spans = schedule.spans().into_iter().map(|(from, to)| format!("{from:.3} to {to:.3} s"));
    let (rung, name) = (&ladder.rungs[at], lines[rich].name);
    let first = schedule.promised;
    lines.push(Line {
        name: "switching",
        dropped: format!("{name}, and from {} {}", spans.collect::<Vec<_>>().join(", "), rung.name.replace('_', " ")),
        loss: rung.loss,
        states: ladder.start.len(),
        small: None,
        model: Ok(Estimate { first, ..Estimate::nothing(watched.columns.len()) }),
        verdict: Verdict::Suffices,
        choice: None,
    });
    Some(Tried {
        line: lines.len() - 1,
        plan: Plan { axes: Axes::First, ..plan },
        switching: Some((at, schedule, low)),
    })
}

const AXES: [Axes; 2] = [Axes::First, Axes::Second];

/// The place of a form among the ladders.
fn form(axes: Axes) -> usize {
    AXES.iter().position(|known| *known == axes).unwrap_or(0)
}

/// A line of the receipt in every form.
fn forms(ladders: &[Ladder], line: usize) -> Vec<Runnable<'_>> {
    ladders.iter().zip(AXES).map(|(ladder, axes)| runnable(ladder, line, axes)).collect()
}

/// Time where all were taken, else evaluations.
fn cost(choice: &Choice) -> f64 {
    choice.seconds.unwrap_or(choice.evaluations as f64)
}

/// A line of the receipt in a form.
fn runnable(ladder: &Ladder, line: usize, axes: Axes) -> Runnable<'_> {
    let span = ladder.own.span;
    match line.checked_sub(1).and_then(|rung| ladder.rungs.get(rung)) {
        None => Runnable {
            axes,
            law: Arc::clone(&ladder.own.law),
            start: ladder.own.state.clone(),
            span,
            row: Box::new(|time, y| (ladder.own.row)(time, y)),
        },
        Some(rung) => Runnable {
            axes,
            law: Arc::clone(&rung.law),
            start: rung.start.clone(),
            span,
            row: Box::new(|time, z| ladder.row(time, &rung.lifted(time, z, ladder.start.len()))),
        },
    }
}

/// The exact motion, as rows.
fn reference_rows(ladder: &Ladder, kept: &Stored) -> Vec<Vec<f64>> {
    let times = kept.reference.times.iter().zip(&kept.reference.states);
    times
        .map(|(time, state)| {
            let state: Vec<f64> = state.iter().map(|y| y.hi()).collect();
            (ladder.own.row)(*time, &state)
        })
        .collect()
}
