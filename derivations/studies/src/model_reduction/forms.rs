//! The models of a scene with one initial value problem, in every form of its equations.

use super::choose::{MOST, Mixed, Models, OF_METHOD};
use super::estimate::Estimate;
use super::first_run::FirstRun;
use super::models::across_events;
use super::outputs::Watched;
use super::plan::{self, COARSE, FINEST, Plan, Runnable};
use super::receipt::{Line, OF_MODEL, Sufficiency, Wish};
use super::switching::LOOKING;
use super::trial::Trial;
use super::{Hierarchy, Loss, ReducedModel};
use integrators::Method;
use simulation::{Axes, Law, Stored};
use std::cell::RefCell;
use std::sync::Arc;
use std::time::Instant;

/// The hierarchies of models of a scene, one for each form, and the stored reference motion, if any.
pub struct Forms {
    pub ladders: Vec<Hierarchy>,
    pub kept: Option<Stored>,
    /// The first run of the scene's own model, once made.
    pub(super) pilot: RefCell<Option<FirstRun>>,
}

impl Forms {
    /// The forms with these hierarchies; the first form comes first.
    pub fn of(ladders: Vec<Hierarchy>, kept: Option<Stored>) -> Self {
        Forms { ladders, kept, pilot: RefCell::new(None) }
    }
}

/// The name of a run with several models.
pub const SWITCHING: &str = "switching";
const AXES: [Axes; 2] = [Axes::First, Axes::Second];
/// The text instead of an estimate, for a model whose error is measured by its run.
pub(super) const BY_ITS_RUN: &str = "known only from its run";
/// A reduced model is not worth switching to for less than this fraction of the run.
const WORTH_WHILE: f64 = 0.1;
/// A reduced model is not worth switching to if its run over the whole span takes more than this fraction of the full
/// model's work.
const CHEAPER: f64 = 0.7;

impl Models for Forms {
    fn columns(&self) -> &[String] {
        &self.ladders[0].own.columns
    }

    fn watched(&self, names: &[String]) -> Result<(Watched, u64), String> {
        let own = self.ladders[0].of_run();
        let (pilot, spent) = FirstRun::of(own)?;
        let watched = pilot.watched(own, names);
        self.pilot.replace(Some(pilot));
        Ok((watched, spent))
    }

    fn lines(&self, watched: &Watched, _tolerance: f64) -> (Vec<Line>, u64) {
        let ladder = &self.ladders[0];
        let own = Line::own(&ladder.model, ladder.own.state.len(), watched.columns.len());
        let smaller = ladder.models.iter().map(|reduced| Line {
            name: reduced.name.to_owned(),
            dropped: reduced.dropped.clone(),
            loss: reduced.loss,
            states: reduced.start.len(),
            model: match reduced.is_exact() {
                true => Ok(Estimate::nothing(watched.columns.len())),
                false => Err(BY_ITS_RUN.to_owned()),
            },
            verdict: Sufficiency::Suffices,
            asked_as: (reduced.shows.is_empty() || reduced.shows_all(&watched.names)).then(|| reduced.name.to_owned()),
            choice: None,
        });
        (std::iter::once(own).chain(smaller).collect(), 0)
    }

    fn start(&self, line: usize) -> Option<(&dyn Law, &[f64])> {
        let ladder = self.ladders.first()?;
        Some(match line.checked_sub(1).and_then(|reduced| ladder.models.get(reduced)) {
            None => (&*ladder.own.law, &ladder.own.state),
            Some(reduced) => (&*reduced.law, &reduced.start),
        })
    }

    fn forms(&self, line: usize) -> Vec<Runnable<'_>> {
        let mut forms: Vec<Runnable<'_>> =
            self.ladders.iter().zip(AXES).map(|(ladder, axes)| runnable(ladder, line, axes)).collect();
        if let (0, Some(pilot), Some(form)) = (line, &*self.pilot.borrow(), forms.first_mut()) {
            form.knows(pilot.method, COARSE, pilot.run.clone());
        }
        forms
    }

    fn code_size(&self, line: usize) -> Option<usize> {
        let ladder = self.ladders.first()?;
        line.checked_sub(1)
            .map_or(ladder.of_run().law.code_size(), |reduced| ladder.models.get(reduced)?.law.code_size())
    }

    fn exact(&self) -> Option<Vec<Vec<f64>>> {
        let ladder = &self.ladders[0];
        let kept = self.kept.as_ref().filter(|kept| kept.serves(&ladder.own))?;
        let row = |(time, state): (&f64, &Vec<field::DoubleDouble>)| {
            let state: Vec<f64> = state.iter().map(|y| y.hi()).collect();
            (ladder.own.row)(*time, &state)
        };
        Some(kept.reference.times.iter().zip(&kept.reference.states).map(row).collect())
    }

    /// A switching run: the reduced model that suffices on the largest part of the run, and the full model elsewhere.
    /// `None` where a reduced model suffices for the whole run: models below it are hardly smaller.
    fn mixed(&self, watched: &Watched, lines: &[Line], tried: &[Trial], wish: &Wish) -> Option<Mixed<'_>> {
        let ladder = &self.ladders[0];
        // the reduced models are derived from the law with lumped windings, if there is one, else from the scene's own
        // law
        let rich = usize::from(ladder.lumping.is_some());
        let plan = Plan { axes: Axes::First, ..tried.iter().find(|trial| trial.line == rich)?.plan.clone() };
        // switching is not used for a stiff law; and finding the intervals costs more than a short run
        let whole = |line: &Line| line.verdict == Sufficiency::Suffices && matches!(line.loss, Loss::Small { .. });
        let short = plan.foretold < LOOKING as f64;
        if wish.allowed.is_zero() || short || plan.method.traits().implicit || lines.iter().any(whole) {
            return None;
        }
        let far = |line: &Line| matches!(line.verdict, Sufficiency::TooFar | Sufficiency::NotBelieved);
        let worth = |at: usize, reduced: &ReducedModel| reduced.lower.kept.is_some() && cheaper(ladder, at + 1, rich);
        let unfit = ladder.models.iter().enumerate().filter(|(at, _)| far(&lines[at + 1]));
        let unfit: Vec<(usize, &ReducedModel)> = unfit.filter(|(at, reduced)| worth(*at, reduced)).collect();
        if unfit.is_empty() {
            return None;
        }
        let course = ladder.course(watched, Some(Instant::now() + wish.allowed)).ok()?;
        let schedules = unfit.into_iter().filter_map(|(at, reduced)| {
            let schedule = ladder.schedule(reduced, &course, OF_MODEL * wish.tolerance)?;
            (schedule.share() >= WORTH_WHILE).then_some((at, schedule))
        });
        let (at, schedule) = schedules.max_by(|a, b| a.1.share().total_cmp(&b.1.share()))?;
        let low = plan::plan(&[runnable(ladder, at + 1, Axes::First)], watched, OF_METHOD * wish.tolerance)?;
        let spans = schedule.spans().into_iter().map(|(from, to)| format!("{from:.3} to {to:.3} s"));
        let (reduced, name) = (&ladder.models[at], &lines[rich].name);
        let line = Line {
            name: SWITCHING.to_owned(),
            dropped: format!("{name}, and from {} {}", spans.collect::<Vec<_>>().join(", "), reduced.name),
            loss: reduced.loss,
            states: ladder.start.len(),
            model: Ok(Estimate { first: schedule.promised, ..Estimate::nothing(watched.columns.len()) }),
            asked_as: None,
            verdict: Sufficiency::Suffices,
            choice: None,
        };
        let sides = [(plan.method, plan.tolerance), (low.method, low.tolerance)];
        let go = move |finer: f64, times: &[f64]| {
            let sides = sides.map(|(method, tolerance)| (method, (tolerance * finer).max(FINEST)));
            ladder.run_switching(reduced, &schedule, sides, MOST, times)
        };
        Some(Mixed { line, plan, go: Box::new(go) })
    }
}

/// Whether a model is so much cheaper than the full one that running it on a part can pay. Work is evaluations times
/// states of a run over the whole span, by a method without series.
fn cheaper(ladder: &Hierarchy, line: usize, rich: usize) -> bool {
    let work = |line: usize| {
        let states = line.checked_sub(1).map_or(ladder.own.state.len(), |reduced| ladder.models[reduced].start.len());
        let (run, evaluations) = runnable(ladder, line, Axes::First).run(Method::DormandPrince8, COARSE, MOST, None);
        run.map(|_| evaluations as f64 * states as f64)
    };
    matches!((work(line), work(rich)), (Some(low), Some(rich)) if low < CHEAPER * rich)
}

/// A line of the receipt in a form.
fn runnable(ladder: &Hierarchy, line: usize, axes: Axes) -> Runnable<'_> {
    let span = ladder.own.span;
    match line.checked_sub(1).and_then(|reduced| ladder.models.get(reduced)) {
        None if ladder.own.switching.is_some() => across_events(axes, ladder.of_run()),
        None => {
            let own = ladder.of_run();
            let outside = |time: f64, y: &[f64]| own.outside(time, y).is_some();
            Runnable::of_law(axes, Arc::clone(&own.law), own.state.clone(), span, |time, y| (own.row)(time, y), outside)
        }
        Some(reduced) => {
            let lifted = move |time: f64, z: &[f64]| reduced.lifted(time, z, ladder.start.len());
            let outside = move |time: f64, z: &[f64]| ladder.left(time, &lifted(time, z)).is_some();
            let row = move |time: f64, z: &[f64]| ladder.row(time, &lifted(time, z));
            Runnable::of_law(axes, Arc::clone(&reduced.law), reduced.start.clone(), span, row, outside)
        }
    }
}
