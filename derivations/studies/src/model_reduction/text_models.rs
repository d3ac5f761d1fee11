//! The models of a text model: its own, known reduced ones, and simplifications found in its equations.

use super::choose::{Mixed, Models};
use super::estimate::Estimate;
use super::first_run::FirstRun;
use super::forms::BY_ITS_RUN;
use super::models::across_events;
use super::outputs::Watched;
use super::plan::{Runnable, SLOWER, fastest_at};
use super::receipt::{Line, OF_MODEL, Sufficiency, Wish};
use super::reduced_model::Lifted;
use super::simplification::candidates::{Candidate, Facts, candidates};
use super::simplification::linear_error::{Distance, Weights};
use super::simplification::{Simplification, SimplifiedScene};
use super::trial::Trial;
use super::{Forms, Hierarchy, Loss};
use simulation::models::Modelled;
use simulation::{Axes, Law, Problem, Stored};
use std::cell::OnceCell;
use std::sync::Arc;

/// The largest code size of a law, bytes, for which each of its parameters is tried at zero.
const MOST_CODE: usize = 20_000;
/// A law is shorter if its code is at most this fraction of that of the scene's own law.
const SHORTER: f64 = 0.8;
/// Estimates are not made if they cost more than this fraction of a coarse run.
const WORTH: f64 = 1.0;
/// A first-order estimate above this multiple of the allowed error rejects a model without a run.
const DOUBT: f64 = 10.0;
const OF_RIGID: &str = "the deflection of this element relative to the motion";
const OF_ELEMENT: &str = "the part of this element relative to the others";

/// The scene with its models.
pub struct TextModels {
    scene: Arc<dyn Modelled>,
    /// The scene's own model, and reduced ones known by name.
    known: Forms,
    /// The simplifications found, each with its problem.
    found: OnceCell<Vec<Simplified>>,
}

/// A simplification with its problem.
struct Simplified {
    candidate: Candidate,
    is_exact: bool,
    scene: SimplifiedScene,
    problem: Problem,
}

impl TextModels {
    /// The models of a scene, with its stored reference, if any.
    pub fn of(scene: &Arc<dyn Modelled>, kept: Option<Stored>) -> Self {
        let known = Forms::of(vec![Hierarchy::of_model(&**scene)], kept);
        TextModels { scene: Arc::clone(scene), known, found: OnceCell::new() }
    }

    fn own(&self) -> &Problem {
        &self.known.ladders[0].own
    }

    /// The simplifications: exact ones first, then those that neglect the most.
    fn simplified(&self, watched: &Watched) -> Vec<Simplified> {
        let own = self.own();
        let mut found: Vec<(Candidate, bool)> = Vec::new();
        if self.scene.is_written() && own.residual.is_none() {
            let pilot = self.known.pilot.borrow();
            let along = pilot.as_ref().map_or(&[][..], |pilot| &pilot.along);
            let shown = self.scene.states_behind(&watched.names);
            let written = self.scene.symbolic_law();
            let names = &own.columns[..own.state.len()];
            let facts = Facts { written: &*written, law: &*own.law, names, along, shown: &shown };
            let (exact, beyond) = candidates(&facts);
            if exact.has_own_law() {
                found.push((Candidate { simplification: exact, parameter: "", value: None }, true));
            }
            found.extend(beyond.into_iter().map(|one| (one, false)));
        }
        // each element that is neglected, or made rigid, compiles a law
        let may_save = watched.stiff || own.switching.is_some() || self.scene.is_written();
        if may_save && own.law.code_size().is_none_or(|bytes| bytes <= MOST_CODE) {
            let elements = self.scene.parameters().into_iter().filter(|one| self.scene.value(&one.name) != Some(0.0));
            for element in elements {
                let name = vec![element.name.into_owned()];
                let rigid = Simplification { rigid: name.clone(), ..Simplification::default() };
                found.push((Candidate { simplification: rigid, parameter: OF_RIGID, value: None }, false));
                let without = Simplification { without: name, ..Simplification::default() };
                found.push((Candidate { simplification: without, parameter: OF_ELEMENT, value: None }, false));
            }
        }
        let fastest = fastest_at(&*own.law, &own.state);
        let simplified = |(candidate, is_exact): (Candidate, bool)| {
            let scene = SimplifiedScene::of(&self.scene, &candidate.simplification).ok()?;
            let problem = scene.whole_problem();
            let shows = watched.columns.iter().all(|&column| !scene.hides(column));
            let is_shorter = match (problem.law.code_size(), own.law.code_size()) {
                (Some(code), Some(own)) => code as f64 <= SHORTER * own as f64,
                _ => false,
            };
            // neglecting an element saves by less stiffness, fewer events, or shorter code
            let has_fewer_events = own.switching.is_some() && problem.switching.is_none();
            let is_slower = || fastest_at(&*problem.law, &problem.state) < SLOWER * fastest;
            let is_simpler = match candidate.simplification.rigid.is_empty() {
                true => candidate.simplification.has_own_law() || watched.stiff || is_shorter || has_fewer_events,
                false => is_slower(),
            };
            (shows && is_simpler).then_some(Simplified { candidate, is_exact, scene, problem })
        };
        found.into_iter().filter_map(simplified).collect()
    }

    /// The number of simplifications that are not exact.
    fn approximate(&self) -> usize {
        self.found.get().map_or(0, |found| found.iter().filter(|one| !one.is_exact).count())
    }

    /// Whether estimates cost less than the run along which they are made; otherwise the models are run.
    fn is_worth_estimates(&self, pilot: &FirstRun) -> bool {
        let (own, count) = (self.own(), self.approximate());
        let cost = || Weights::cost(&*own.law, pilot.along.len(), count);
        own.switching.is_none() && count > 0 && cost() as f64 <= WORTH * pilot.run.evaluations as f64
    }

    /// The first-order error of each simplification along times and states of a run of the scene's own model, `None`
    /// where undefined; `None` for all if the run has too few points, or the law changes at events.
    pub fn estimates(&self, watched: &Watched, along: &[(f64, Vec<f64>)]) -> Option<Vec<Option<Estimate>>> {
        let found = self.found.get_or_init(|| self.simplified(watched));
        let weights = self.own().switching.is_none().then(|| Weights::along(&*self.own().law, along)).flatten()?;
        Some(found.iter().map(|one| self.estimate(&weights, one, watched)).collect())
    }

    /// The first-order error of a simplification along a run.
    fn estimate(&self, weights: &Weights, one: &Simplified, watched: &Watched) -> Option<Estimate> {
        let own = self.own();
        let states = own.state.len();
        let all: Vec<usize> = (0..states).collect();
        let reduced = one.scene.reduced();
        let whole =
            |time: f64, z: &[f64]| reduced.map_or_else(|| z.to_vec(), |reduced| reduced.lifted(time, z, states));
        let kept = reduced.and_then(|reduced| reduced.lower.kept.as_deref()).unwrap_or(&all);
        if kept.len() != one.problem.state.len() {
            return None;
        }
        let lower = Lifted { lift: &whole, law: &*one.problem.law, kept, start: &one.problem.state };
        let errors = weights.errors(&lower, &*own.law)?;
        let mut found = Estimate::nothing(watched.columns.len());
        for Distance { time, state, error } in errors {
            let lifted: Vec<f64> = state.iter().zip(&error).map(|(y, e)| y - e).collect();
            let (row, other) = ((own.row)(time, state), (own.row)(time, &lifted));
            for (each, (&column, size)) in found.each.iter_mut().zip(watched.columns.iter().zip(&watched.sizes)) {
                let off = (row[column] - other[column]).abs() / size;
                if off.is_nan() {
                    return None;
                }
                *each = each.max(off);
                if off > found.first {
                    (found.first, found.at) = (off, time);
                }
            }
        }
        found.small = one.candidate.value;
        Some(found)
    }
}

impl Models for TextModels {
    fn columns(&self) -> &[String] {
        &self.own().columns
    }

    fn watched(&self, names: &[String]) -> Result<(Watched, u64), String> {
        self.known.watched(names)
    }

    fn lines(&self, watched: &Watched, tolerance: f64) -> (Vec<Line>, u64) {
        let (mut lines, mut spent) = self.known.lines(watched, tolerance);
        let found = self.found.get_or_init(|| self.simplified(watched));
        let estimates =
            self.known.pilot.borrow().as_ref().filter(|pilot| self.is_worth_estimates(pilot)).and_then(|pilot| {
                spent += Weights::cost(&*self.own().law, pilot.along.len(), self.approximate());
                self.estimates(watched, &pilot.along)
            });
        for (at, one) in found.iter().enumerate() {
            let model = match (&estimates, one.is_exact) {
                (_, true) => Ok(Estimate::nothing(watched.columns.len())),
                (Some(estimates), false) => estimates[at].clone().ok_or_else(|| BY_ITS_RUN.to_owned()),
                (None, false) => Err(BY_ITS_RUN.to_owned()),
            };
            let verdict = match &model {
                Ok(model) if model.first > DOUBT * OF_MODEL * tolerance => Sufficiency::TooFar,
                _ => Sufficiency::Suffices,
            };
            let Candidate { simplification, parameter, .. } = &one.candidate;
            let name = simplification.to_string();
            lines.push(Line {
                asked_as: Some(name.clone()),
                name,
                dropped: simplification.dropped(),
                loss: if one.is_exact { Loss::Nothing { claim: None } } else { Loss::Small { parameter } },
                states: one.problem.state.len(),
                model,
                verdict,
                choice: None,
            });
        }
        (lines, spent)
    }

    fn forms(&self, line: usize) -> Vec<Runnable<'_>> {
        let known = self.known.ladders[0].models.len() + 1;
        match line.checked_sub(known) {
            None => self.known.forms(line),
            Some(place) => {
                let found = self.found.get().and_then(|found| found.get(place));
                found.map(|one| across_events(Axes::First, &one.problem)).into_iter().collect()
            }
        }
    }

    fn start(&self, line: usize) -> Option<(&dyn Law, &[f64])> {
        let known = self.known.ladders[0].models.len() + 1;
        match line.checked_sub(known) {
            None => self.known.start(line),
            Some(place) => self.found.get()?.get(place).map(|one| (&*one.problem.law, &one.problem.state[..])),
        }
    }

    fn changes(&self, line: usize) -> bool {
        let known = self.known.ladders[0].models.len() + 1;
        let found = line.checked_sub(known).and_then(|place| self.found.get()?.get(place));
        found.map_or(line == 0, |one| one.problem.switching.is_some()) && self.own().switching.is_some()
    }

    fn code_size(&self, line: usize) -> Option<usize> {
        let known = self.known.ladders[0].models.len() + 1;
        match line.checked_sub(known) {
            None => self.known.code_size(line),
            Some(place) => self.found.get()?.get(place)?.problem.law.code_size(),
        }
    }

    fn exact(&self) -> Option<Vec<Vec<f64>>> {
        self.known.exact()
    }

    fn mixed(&self, watched: &Watched, lines: &[Line], tried: &[Trial], wish: &Wish) -> Option<Mixed<'_>> {
        let known = self.known.ladders[0].models.len() + 1;
        (lines.len() == known).then(|| self.known.mixed(watched, lines, tried, wish)).flatten()
    }
}
