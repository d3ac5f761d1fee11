//! Motions across events to all digits that two methods share.
//!
//! # Overview
//! A run in `f64` tells the regimes and, to its digits, when they change. Each regime is one smooth law, also beyond its end. So
//! two methods of different families follow the regimes in double-double, each on its own (`follow`): an event is the zero of
//! its signal, found by Newton's method on the instant; the state there is made exact as in the run. Times have two parts
//! as well (`flow`). Where the determinant of a regime vanishes, that regime is slowed down by it (`slowed`).
//!
//! Which regime goes on is decided once, by the run. What is not known to more digits than a tie is told by, has no reference.

mod flow;
mod follow;
mod owner;
mod slowed;

pub use owner::Regimes;

use super::log::{Ending, Names, describe};
use super::run::{Plan, run};
use super::{ForRough, RoughScene};
use crate::scene::atlas::INSTANTS;
use field::{DoubleDouble, decimal};
use flow::Means;
use follow::{Followed, Follower};
use integrators::{Failure, Method, Reference, Sizes, Span, Work, difference, shared_digits};
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use std::fmt;
use std::time::{Duration, Instant};

/// A motion across its events.
#[derive(Clone, Debug)]
pub struct Exact {
    /// At instants up to the end, or to shortly before an earlier one.
    pub reference: Reference,
    pub events: Vec<Event>,
}

/// An event to all digits.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    pub time: DoubleDouble,
    /// As it is integrated; the places alone where velocities have no bound.
    pub state: Vec<DoubleDouble>,
    pub what: String,
    /// The regime that goes on; empty at an end.
    pub regime: String,
}

impl Event {
    /// The instant with so many places behind the point.
    pub fn instant(&self, places: usize) -> String {
        decimal(self.time, places).unwrap_or_default()
    }
}

/// Why a motion is not known to all digits.
#[derive(Clone, Debug, PartialEq)]
pub enum Unknown {
    /// It does not begin, or ends by a state that no signal tells; in words.
    Ends(String),
    /// What happens there has no signal that falls through zero.
    Blunt {
        time: f64,
    },
    Failed(Failure),
}

impl fmt::Display for Unknown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unknown::Ends(why) => f.write_str(why),
            Unknown::Blunt { time } => {
                write!(f, "what happens at t = {time:.9} s is told by a tie, and so not to more digits than that")
            }
            Unknown::Failed(failure) => failure.fmt(f),
        }
    }
}

impl From<Failure> for Unknown {
    fn from(failure: Failure) -> Self {
        Unknown::Failed(failure)
    }
}

/// Of different families. With more stages Gauss' steps are longer than it judges well: where a rod straightens they changed what is
/// conserved, 2e-15, by 1e-28 with 12 stages and by 1e-24 with 16; with 8 by 4e-31.
const METHODS: [Method; 2] = [Method::Gauss { stages: 8 }, Method::GraggBulirschStoer];

impl RoughScene {
    /// The motion to all digits, each of two methods in half of the time.
    ///
    /// # Errors
    /// Why it is not known.
    pub fn exact(&self, allowed: Duration) -> Result<Exact, Unknown> {
        self.apply(Exactly { scene: self, allowed })
    }
}

struct Exactly<'a> {
    scene: &'a RoughScene,
    allowed: Duration,
}

impl ForRough for Exactly<'_> {
    type Output = Result<Exact, Unknown>;

    fn apply<Q, const N: usize, const C: usize, const K: usize>(
        self,
        system: &Q,
        start: State<f64, N>,
        contacts: Names<K>,
    ) -> Result<Exact, Unknown>
    where
        Q: Contacts<N, C, K, Given = f64> + Copy + Send + Sync + 'static,
    {
        let y0 = [&start.place[..], &start.velocity[..], &[0.0; 2]].concat();
        let mut sizes = Sizes(y0.iter().map(|y| y.abs()).collect());
        let found = run(system, &start, &Plan::until(self.scene.plan.end), &mut sizes);
        let known = matches!(
            found.ending,
            Ending::Reached | Ending::TouchDown { .. } | Ending::Critical | Ending::Undetermined
        );
        if !known || found.entries.is_empty() {
            return Err(Unknown::Ends(found.ending.describe(&contacts)));
        }
        let reached = found.ending == Ending::Reached;
        let horizon = if reached { found.state.time } else { rounded_down(found.state.time) };
        let instants = Span::<f64>::new(0.0, horizon, &y0).with_even_outputs(INSTANTS).outputs;
        let sizes = of_kinds::<N>(&sizes.0);
        let follow = |method: Method| {
            let deadline = Instant::now() + self.allowed / 2;
            let means = Means { method, sizes: sizes.clone(), deadline, work: Work::default() };
            Follower { system, run: &found, start: &y0, instants: &instants, means }.follow()
        };
        let ((first, one), (second, other)) = (follow(METHODS[0])?, follow(METHODS[1])?);
        let digits = shared_digits(apart(&first, &second, &sizes));
        let events = first.events.into_iter().enumerate().map(|(place, (time, state))| {
            let next = found.entries.get(place + 1);
            let what = next.map_or_else(|| found.ending.describe(&contacts), |next| next.cause.describe(&contacts));
            let regime = next.map_or_else(String::new, |next| describe(&contacts, &next.regime));
            Event { time, state, what, regime }
        });
        let (methods, work) = (METHODS, [one.work, other.work]);
        let events = events.collect();
        Ok(Exact {
            reference: Reference { times: instants, states: first.states, digits, sizes, methods, work },
            events,
        })
    }
}

/// The sizes of places, velocities and works, each kind by itself: what is rounding beside its kind has the size of that.
fn of_kinds<const N: usize>(largest: &[f64]) -> Vec<f64> {
    let (places, rest) = largest.split_at(N);
    let (velocities, works) = rest.split_at(N);
    let of_kind = |kind: &[f64]| -> Vec<f64> {
        let whole = kind.iter().copied().fold(0.0, f64::max);
        let whole = if whole > 0.0 { whole } else { 1.0 };
        kind.iter().map(|size| if *size > ROUNDING * whole { *size } else { whole }).collect()
    };
    [places, velocities, works].map(of_kind).concat()
}

/// Beside the others of a kind nothing.
const ROUNDING: f64 = 1e-9;

/// The largest relative difference, of states and of times.
fn apart(one: &Followed, other: &Followed, sizes: &[f64]) -> f64 {
    let states = |of: &Followed| -> Vec<Vec<DoubleDouble>> {
        of.states.iter().chain(of.events.iter().map(|(_, state)| state)).cloned().collect()
    };
    let times = one.events.iter().zip(&other.events).map(|((a, _), (b, _))| ((*a - *b).hi() / a.hi()).abs());
    times.fold(difference(&states(one), &states(other), sizes), f64::max)
}

/// A number below, of two digits: the last instant that is compared before a motion ends.
fn rounded_down(time: f64) -> f64 {
    let unit = 10.0_f64.powf(time.log10().floor() - 1.0);
    let below = (time / unit).floor();
    // short numbers are written shortly
    format!("{:.12e}", below * unit).parse().unwrap_or(below * unit)
}
