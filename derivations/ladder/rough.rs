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
use super::estimate::{Carrying, Estimate, Watched, instants, largest};
use super::plan::{Go, Run, Runnable};
use super::receipt::{Line, Verdict};
use super::rung::{Lower, Straight, Written};
use crate::friction::course::{names, row};
use crate::friction::held::{Held, Margin};
use crate::friction::log::Names;
use crate::friction::run::{Plan, run};
use crate::friction::smoothed::Smoothed;
use crate::friction::stretch::{Stretch, parts};
use crate::friction::{Ending, ForRough, RoughScene};
use crate::scene::Axes;
use crate::scene::problem::Law;
use integrators::{Method, Samples, Tolerance};
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use mechanics::regimes::{Mode, Sizes};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// The tolerance of the runs that tell when events are.
const CLOCK: f64 = 1e-10;
/// Events of a run.
const EVENTS: usize = 1000;
/// What is dropped with the friction.
const PARAMETER: &str = "work of friction over the energy that moves";

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
    made: Duration,
}

type Row = dyn Fn(f64, &[f64]) -> Vec<f64> + Send + Sync;

/// A model with all its regimes.
struct Model {
    name: String,
    dropped: String,
    loss: Loss,
    /// Across its events.
    run: Box<Go<'static>>,
    /// The regimes that it goes through; or why it does not reach its end.
    course: Result<Vec<Piece>, String>,
    /// Its states at the instants.
    states: Vec<(f64, Vec<f64>)>,
    evaluations: u64,
}

impl Model {
    fn across(&self) -> Runnable<'_> {
        Runnable::new(Axes::First, |method, tolerance, most| (self.run)(method, tolerance, most))
    }
}

/// A regime of a run, as a law of its own.
struct Piece {
    until: f64,
    law: Arc<dyn Written>,
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
        scene.apply(Derived { scene })
    }

    /// The largest difference of a model's run from that with friction, relative to the sizes; none where there is no run.
    pub fn difference(&self, line: usize, watched: &Watched) -> Option<f64> {
        let model = &self.smooth.get(line.checked_sub(2)?)?;
        let pair = |((time, z), (_, y)): (&(f64, Vec<f64>), &(f64, Vec<f64>))| {
            watched.off(&(self.row)(*time, z), &(self.row)(*time, y))
        };
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
        let laws: Option<Vec<(f64, Straight)>> = side_by_side(own, low)
            .map(|(until, own, low)| Some((until, carried(&own.law, &Lower::other(&low.law))?)))
            .collect();
        let n = self.start.len();
        let start = self.start.iter().copied().chain(vec![0.0; 2 * n]).collect();
        let carrying = Carrying { watched, lift: &|_, z| z.to_vec(), row: &*self.row, small: &|_, _| None, kept: n };
        let found = carrying.estimate(&laws.ok_or_else(long)?, start, &watched.states, tolerance, f64::INFINITY);
        found.map_err(|failure| failure.to_string())
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

    fn made(&self) -> Duration {
        self.made
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
            Line::own(&self.own.name, states, watched.columns.len()),
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
                choice: None,
            });
        }
        (lines, spent)
    }

    fn forms(&self, line: usize) -> Vec<Runnable<'_>> {
        let of_law = |law: &Arc<dyn Law>| {
            let row = |time: f64, y: &[f64]| (self.row)(time, y);
            Runnable::of_law(Axes::First, Arc::clone(law), self.start.clone(), self.span, row)
        };
        let one = match (line, &self.held) {
            (0, _) => Some(self.own.across()),
            (1, held) => held.as_ref().ok().map(|held| of_law(&held.law)),
            _ => self.smooth.get(line - 2).map(Model::across),
        };
        one.into_iter().collect()
    }
}

struct Derived<'a> {
    scene: &'a RoughScene,
}

impl ForRough for Derived<'_> {
    type Output = RoughLadder;

    fn apply<Q, const N: usize, const C: usize, const K: usize>(
        self,
        system: &Q,
        start: State<f64, N>,
        contacts: Names<K>,
    ) -> RoughLadder
    where
        Q: Contacts<N, C, K, Given = f64> + Copy + Send + Sync + 'static,
    {
        let begin = Instant::now();
        let (system, rough, span) = (*system, self.scene.system, self.scene.plan.end);
        let shown: Arc<Row> = Arc::new(move |time: f64, y: &[f64]| {
            row(&rough, &system, &parts::<f64, N>(time, y), [y[2 * N], y[2 * N + 1]])
        });
        let subject = Subject { start, contacts, span, row: Arc::clone(&shown) };
        let y0 = [&start.place[..], &start.velocity[..], &[0.0; 2]].concat();
        let (own, regimes) = subject.model("friction", String::new(), Loss::Own, system);
        let held = subject.held(system, &own, &regimes, &y0);
        let all = system.contacts(0.0, start.place);
        let with_friction: Vec<usize> = (0..K).filter(|&k| all[k].friction != 0.0).collect();
        let each = with_friction.iter().map(|&k| vec![k]);
        let together = (with_friction.len() > 1).then(|| with_friction.clone());
        let smooth = each.chain(together).map(|chosen| {
            let smooth = std::array::from_fn(|k| chosen.contains(&k));
            let at: Vec<&str> = chosen.iter().map(|&k| contacts[k]).collect();
            let name = match chosen.len() == with_friction.len() {
                true => "no friction".to_owned(),
                false => format!("no friction at the {}", at.join(" and the ")),
            };
            let dropped = format!("the friction at the {}", at.join(" and the "));
            let loss = Loss::Small { parameter: PARAMETER };
            let (lower, _) = subject.model(&name, dropped, loss, Smoothed { system, smooth });
            match never_matters(&own, &lower, &chosen) {
                true => Model { loss: Loss::Nothing { claim: None }, ..lower },
                false => lower,
            }
        });
        let smooth = smooth.collect();
        let columns = names(&rough, &contacts);
        RoughLadder { columns, span, start: y0, row: shown, own, held, smooth, made: begin.elapsed() }
    }
}

/// Whether these contacts are apart all the time, and the laws without their friction are those with it, which is decided.
fn never_matters(own: &Model, lower: &Model, contacts: &[usize]) -> bool {
    let (Ok(own), Ok(lower)) = (&own.course, &lower.course) else { return false };
    let apart = |piece: &Piece| contacts.iter().all(|&k| piece.apart[k]);
    let same = |(own, lower): (&Piece, &Piece)| {
        own.until == lower.until && apart(own) && apart(lower) && Lower::other(&lower.law).is_exact(&*own.law)
    };
    own.len() == lower.len() && own.iter().zip(lower).all(same)
}

/// The modes of all contacts, and whether the system rests by more reactions than are determined.
type Regime<const K: usize> = ([Mode; K], bool);

/// A scene with its types, whatever friction it has.
struct Subject<const N: usize, const K: usize> {
    start: State<f64, N>,
    contacts: Names<K>,
    span: f64,
    row: Arc<Row>,
}

impl<const N: usize, const K: usize> Subject<N, K> {
    /// A model with its run, and the regimes of that.
    fn model<Q, const C: usize>(&self, name: &str, dropped: String, loss: Loss, system: Q) -> (Model, Vec<Regime<K>>)
    where
        Q: Contacts<N, C, K, Given = f64> + Copy + Send + Sync + 'static,
    {
        let (start, span, shown) = (self.start, self.span, Arc::clone(&self.row));
        let outputs: Vec<f64> = instants(span).collect();
        let plan = move |method: Method, tolerance: f64, evaluations: Option<u64>| Plan {
            method,
            tolerance: Tolerance::both(tolerance),
            end: span,
            outputs: outputs.clone(),
            most_events: EVENTS,
            allowed: None,
            evaluations,
        };
        let mut states = Vec::new();
        let mut keep = Samples(|time: f64, y: &[f64]| states.push((time, y.to_vec())));
        let found = run(&system, &start, &plan(Method::DormandPrince8, CLOCK, None), &mut keep);
        let (mut pieces, mut regimes) = (Vec::new(), Vec::new());
        for (place, entry) in found.entries.iter().enumerate() {
            let next = found.entries.get(place + 1);
            let until = next.map_or(span, |next| next.time);
            if until > entry.time {
                regimes.push((entry.regime, !entry.determined));
                pieces.push(Piece {
                    until,
                    law: Arc::new(Held { system, regime: entry.regime, rests: !entry.determined }),
                    apart: entry.regime.iter().map(|mode| *mode == Mode::Apart).collect(),
                    cause: next.map_or_else(String::new, |next| next.cause.describe(&self.contacts)),
                });
            }
        }
        let ending = found.ending;
        let course = if ending == Ending::Reached { Ok(pieces) } else { Err(ending.describe(&self.contacts)) };
        let go = move |method: Method, tolerance: f64, most: u64| {
            let mut rows = Vec::new();
            let mut keep = Samples(|time: f64, y: &[f64]| rows.push((time, shown(time, y))));
            let found = run(&system, &start, &plan(method, tolerance, Some(most)), &mut keep);
            let evaluations = found.work.rates;
            ((found.ending == Ending::Reached).then_some(Run { rows, evaluations }), evaluations)
        };
        let evaluations = found.work.rates;
        (Model { name: name.to_owned(), dropped, loss, run: Box::new(go), course, states, evaluations }, regimes)
    }

    /// The one regime of a run by itself, as straight-line code.
    fn held<Q, const C: usize>(
        &self,
        system: Q,
        own: &Model,
        regimes: &[Regime<K>],
        start: &[f64],
    ) -> Result<HeldThrough, String>
    where
        Q: Contacts<N, C, K, Given = f64> + Copy + Send + Sync + 'static,
    {
        let (only, (regime, rests)) = match (own.course.as_deref(), regimes) {
            (Ok([only]), [regime]) => (only, *regime),
            (Ok([first, ..]), _) => return Err(format!("left at {:.6} s: {}", first.until, first.cause)),
            _ => return Err("the model with friction has no run".to_owned()),
        };
        let law = Lower { plain: None, ..Lower::other(&only.law) }.law().ok_or("it is too long to be recorded")?;
        let speed = |y: &Vec<f64>| y[N..2 * N].iter().map(|v| v.abs()).sum::<f64>();
        let speed = own.states.iter().map(|(_, y)| speed(y)).fold(Sizes::of(&self.start).speed, f64::max);
        let force: [f64; N] = system.force(&self.start);
        let load = force.iter().map(|x| x.abs()).sum();
        let rough = system.contacts(0.0, self.start.place).map(|contact| contact.friction != 0.0);
        let stretch = Stretch { system: &system, regime, rough, rests, orientation: 1.0, speed, load };
        let none = "nothing is known of its margins";
        let margin = stretch.margin(start, self.span, CLOCK).ok_or(none)?;
        let closest =
            format!("{}, seen at {} steps and between them", margin.watched.describe(&self.contacts), margin.steps);
        (margin.least > 0.0).then_some(HeldThrough { law, margin, closest }).ok_or_else(|| none.to_owned())
    }
}
