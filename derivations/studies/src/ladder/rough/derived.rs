//! The models of rough contacts, from a scene's own system: each runs once, which tells its regimes.

use super::super::Loss;
use super::super::along::Along;
use super::super::followed::looks;
use super::super::rung::Lower;
use super::{HeldThrough, Model, OWN, Piece, RoughLadder, Row};
use crate::friction::course::{names, row};
use crate::friction::held::Held;
use crate::friction::log::Names;
use crate::friction::run::{Plan, run};
use crate::friction::smoothed::Smoothed;
use crate::friction::stretch::{Stretch, parts};
use crate::friction::{Ending, ForRough, RoughScene};
use integrators::{Method, Samples, Tolerance};
use mechanics::constrained::contacts::Contacts;
use mechanics::constrained::{State, kinetic_energy};
use mechanics::regimes::{Mode, Sizes};
use std::sync::Arc;

/// The tolerance of the runs that tell when events are.
const CLOCK: f64 = 1e-10;
/// Events of a run.
const EVENTS: usize = 1000;
/// What is dropped with the friction.
const PARAMETER: &str = "work of friction over the energy that moves";

/// The ladder of a scene.
pub(super) fn of(scene: &RoughScene) -> RoughLadder {
    scene.apply(Derived { scene })
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
        let (system, rough, span) = (*system, self.scene.system, self.scene.plan.end);
        let shown: Arc<Row> = Arc::new(move |time: f64, y: &[f64]| {
            row(&rough, &system, &parts::<f64, N>(time, y), [y[2 * N], y[2 * N + 1]])
        });
        let fine = self.scene.plan.tolerance.relative;
        let subject = Subject { start, contacts, span, fine, row: Arc::clone(&shown) };
        let y0 = [&start.place[..], &start.velocity[..], &[0.0; 2]].concat();
        let (own, regimes) = subject.model(OWN, String::new(), Loss::Own, system);
        let held = subject.held(system, &own, &regimes, &y0);
        let all = system.contacts(0.0, start.place);
        let with_friction: Vec<usize> = (0..K).filter(|&k| all[k].friction != 0.0).collect();
        let energy = kinetic_energy(system.masses(), start.velocity);
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
            let (mut lower, _) = subject.model(&name, dropped, loss, Smoothed { system, smooth });
            // works are of all contacts together
            lower.small = (chosen.len() == with_friction.len()).then(|| share_of_friction(&own, energy));
            if never_matters(&own, &lower, &chosen) {
                lower.loss = Loss::Nothing { claim: None };
            }
            lower
        });
        let smooth = smooth.collect();
        let columns = names(&rough, &contacts);
        RoughLadder { columns, span, start: y0, row: shown, own, held, smooth }
    }
}

/// The largest work of friction over the energy that moves: that of the start with what the given forces add.
fn share_of_friction(own: &Model, energy: f64) -> f64 {
    let works = || own.states.iter().filter_map(|(_, y)| y.last_chunk::<2>());
    let friction = works().map(|[friction, _]| friction.abs()).fold(0.0, f64::max);
    friction / works().map(|[_, given]| given.abs()).fold(energy, |sum, given| f64::max(sum, energy + given))
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
    /// The scene's own tolerance.
    fine: f64,
    row: Arc<Row>,
}

impl<const N: usize, const K: usize> Subject<N, K> {
    /// A model with its run, and the regimes of that.
    fn model<Q, const C: usize>(&self, name: &str, dropped: String, loss: Loss, system: Q) -> (Model, Vec<Regime<K>>)
    where
        Q: Contacts<N, C, K, Given = f64> + Copy + Send + Sync + 'static,
    {
        let (start, span, shown) = (self.start, self.span, Arc::clone(&self.row));
        let looks: Vec<f64> = looks(span).collect();
        let plan = move |method: Method, tolerance: f64, evaluations: Option<u64>, times: &[f64]| Plan {
            method,
            tolerance: Tolerance::both(tolerance),
            end: span,
            outputs: times.to_vec(),
            most_events: EVENTS,
            allowed: None,
            evaluations,
        };
        let mut states = Vec::new();
        let mut keep = Samples(|time: f64, y: &[f64]| states.push((time, y.to_vec())));
        let found = run(&system, &start, &plan(Method::DormandPrince8, CLOCK, None, &looks), &mut keep);
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
        let course = match found.ending {
            Ending::Reached => Ok(pieces),
            // close to where no motion is left the tolerance decides what is met
            _ => Err(run(&system, &start, &plan(Method::DormandPrince8, self.fine, None, &looks), &mut ())
                .ending
                .describe(&self.contacts)),
        };
        let go = move |method: Method, tolerance: f64, most: u64, times: &[f64]| {
            let mut along = Along::of(|time: f64, y: &[f64]| shown(time, y));
            let found = run(&system, &start, &plan(method, tolerance, Some(most), times), &mut along);
            let evaluations = found.work.rates;
            ((found.ending == Ending::Reached).then(|| along.run(evaluations)), evaluations)
        };
        let evaluations = found.work.rates;
        (
            Model { name: name.to_owned(), dropped, loss, small: None, run: Box::new(go), course, states, evaluations },
            regimes,
        )
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
        let law = Lower::other(&only.law).law().ok_or("it is too long to be recorded")?;
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
