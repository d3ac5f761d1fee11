//! The ladder of rough contacts: friction with all its regimes, one regime held through, contacts without friction.
//!
//! The richer law is one smooth law between two events and has others before and after. When these are, its own run tells, and
//! with that it is y' = F(t, y), F changing at known times; there y has no jump, and neither has the error of a lower motion
//! against it, though its rate has. So the error is carried as everywhere, law after law, from the events of either run to the
//! next. Only if the richer run were not at hand would the times of its events move with the error.
//!
//! A regime that the run never leaves is its motion: that is tested at steps and between them, and not proved.

use super::Loss;
use super::carried::carried;
use super::choose::Models;
use super::estimate::{Carrying, Estimate};
use super::plan::{Go, Runnable};
use super::receipt::{Line, Verdict};
use super::rung::Lower;
use super::watched::{Watched, largest};
use crate::friction::RoughScene;
use crate::friction::held::Margin;
use simulation::{Axes, CompiledLaw, Law, SymbolicLaw};
use std::sync::Arc;

mod derived;

/// The models of a scene with rough contacts.
pub struct RoughLadder {
    columns: Vec<String>,
    span: f64,
    start: Vec<f64>,
    row: Arc<Row>,
    own: Model,
    /// Its one regime by itself; or why it cannot be held.
    held: Result<HeldThrough, String>,
    smooth: Vec<Model>,
}

/// The name of the scene's own model.
const OWN: &str = "friction";

type Row = dyn Fn(f64, &[f64]) -> Vec<f64> + Send + Sync;

/// A time with a state.
type At = (f64, Vec<f64>);

/// A model with all its regimes.
struct Model {
    name: String,
    dropped: String,
    loss: Loss,
    /// The work of the friction that it lacks over the energy that moves, on the run with friction.
    small: Option<f64>,
    /// Across its events.
    run: Box<Go<'static>>,
    /// The regimes that it goes through; or why it does not reach its end.
    course: Result<Vec<Piece>, String>,
    /// Its states at the even instants at which errors are looked at.
    states: Vec<At>,
    evaluations: u64,
}

impl Model {
    fn across(&self, span: f64) -> Runnable<'_> {
        Runnable::new(Axes::First, span, |method, tolerance, most, times| (self.run)(method, tolerance, most, times))
    }
}

/// A regime of a run, as a law of its own.
struct Piece {
    until: f64,
    law: Arc<dyn SymbolicLaw>,
    /// Which contacts are apart.
    apart: Vec<bool>,
    /// Why it ends.
    cause: String,
}

/// The one regime of a run.
struct HeldThrough {
    law: Arc<dyn Law>,
    margin: Margin,
    /// What comes closest to failing.
    closest: String,
}

impl RoughLadder {
    /// Of a scene.
    pub fn of(scene: &RoughScene) -> Self {
        derived::of(scene)
    }

    /// The largest difference of a model's run from that with friction, relative to the sizes; none where there is no run.
    pub fn difference(&self, line: usize, watched: &Watched) -> Option<f64> {
        let model = &self.smooth.get(line.checked_sub(2)?)?;
        let row = |(time, state): &At| (self.row)(*time, state);
        let pair = |(low, own): (&At, &At)| watched.off(&row(low), &row(own));
        let all = model.course.is_ok().then(|| model.states.iter().zip(&self.own.states).map(pair));
        Some(all?.fold(0.0, f64::max))
    }

    /// What a model without some friction is off, to second order, by the errors that are carried.
    fn estimate(&self, lower: &Model, watched: &Watched, tolerance: f64) -> Result<Estimate, String> {
        let outputs = watched.columns.len();
        let (own, low) = match (&self.own.course, &lower.course) {
            (Ok(own), Ok(low)) => (own, low),
            (Err(why), _) | (_, Err(why)) => return Err(why.clone()),
        };
        if !matches!(lower.loss, Loss::Small { .. }) {
            return Ok(Estimate::nothing(outputs));
        }
        let long = || "the law of its error is too long to be recorded".to_owned();
        let laws: Option<Vec<(f64, CompiledLaw)>> = side_by_side(own, low)
            .map(|(until, own, low)| Some((until, carried(&own.law, &Lower::other(&low.law))?)))
            .collect();
        let n = self.start.len();
        let start = self.start.iter().copied().chain(vec![0.0; 2 * n]).collect();
        let carrying = Carrying { watched, lift: &|_, z| z.to_vec(), row: &*self.row, small: &|_, _| None, kept: n };
        let found = carrying.estimate(&laws.ok_or_else(long)?, start, &watched.states, tolerance, f64::INFINITY);
        found.map(|found| Estimate { small: lower.small, ..found }).map_err(|failure| failure.to_string())
    }
}

/// The regimes of two runs, cut at the events of both.
fn side_by_side<'a>(own: &'a [Piece], low: &'a [Piece]) -> impl Iterator<Item = (f64, &'a Piece, &'a Piece)> {
    let mut ends: Vec<f64> = own.iter().chain(low).map(|piece| piece.until).collect();
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    let at = |pieces: &'a [Piece], end: f64| pieces.iter().find(|piece| piece.until >= end);
    ends.into_iter().filter_map(move |end| Some((end, at(own, end)?, at(low, end)?)))
}

impl Models for RoughLadder {
    fn columns(&self) -> &[String] {
        &self.columns
    }

    fn watched(&self, names: &[String]) -> Result<(Watched, u64), String> {
        self.own.course.as_ref().map_err(Clone::clone)?;
        let states = || std::iter::once((0.0, &self.start)).chain(self.own.states.iter().map(|(time, y)| (*time, y)));
        let rows: Vec<Vec<f64>> = states().map(|(time, y)| (self.row)(time, y)).collect();
        let sizes = (0..self.start.len()).map(|i| largest(states().map(|(_, y)| y[i]))).collect();
        let spent = self.smooth.iter().chain([&self.own]).map(|model| model.evaluations).sum();
        Ok((Watched::of(&self.columns, names, &rows, sizes), spent))
    }

    fn lines(&self, watched: &Watched, tolerance: f64) -> (Vec<Line>, u64) {
        let (states, mut spent) = (self.start.len(), 0);
        let nothing = || Estimate::nothing(watched.columns.len());
        let held = self.held.as_ref();
        let mut lines = vec![
            Line::own(OWN, states, watched.columns.len()),
            Line {
                name: "regime held".to_owned(),
                dropped: match held {
                    Ok(held) => format!("the watch for events; what comes closest to one is {}", held.closest),
                    Err(_) => "the watch for events".to_owned(),
                },
                loss: held.map_or(Loss::Held { margin: 0.0, at: 0.0 }, |held| Loss::Held {
                    margin: held.margin.least,
                    at: held.margin.at,
                }),
                states,
                verdict: if held.is_ok() { Verdict::Suffices } else { Verdict::NotHeld },
                asked_as: None,
                model: held.map(|_| nothing()).map_err(Clone::clone),
                choice: None,
            },
        ];
        for lower in &self.smooth {
            let model = self.estimate(lower, watched, tolerance);
            spent += model.as_ref().map_or(0, |model| model.evaluations);
            lines.push(Line {
                name: lower.name.clone(),
                dropped: lower.dropped.clone(),
                loss: lower.loss,
                states,
                verdict: Verdict::of(&model, tolerance),
                model,
                asked_as: None,
                choice: None,
            });
        }
        (lines, spent)
    }

    fn forms(&self, line: usize) -> Vec<Runnable<'_>> {
        let of_law = |law: &Arc<dyn Law>| {
            let row = |time: f64, y: &[f64]| (self.row)(time, y);
            Runnable::of_law(Axes::First, Arc::clone(law), self.start.clone(), self.span, row, |_, _| false)
        };
        let one = match (line, &self.held) {
            (0, _) => Some(self.own.across(self.span)),
            (1, held) => held.as_ref().ok().map(|held| of_law(&held.law)),
            _ => self.smooth.get(line - 2).map(|model| model.across(self.span)),
        };
        one.into_iter().collect()
    }
}
