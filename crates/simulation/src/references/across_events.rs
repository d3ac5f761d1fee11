//! A motion across events to all digits, by two methods.
//!
//! A run in `f64` gives the laws and, to its digits, the times of their changes. Each law is smooth, also beyond its end. Two
//! methods of
//! different families follow the laws in double-double, each on its own: an event is the zero of its signal, found by Newton's method
//! on the instant. Times have two parts as well (`flow`).
//!
//! The run decides once which law goes on. An event that is decided by a tie has no more digits than the tie.

use super::INSTANTS;
use super::flow::Means;
use field::{DoubleDouble, decimal};
use integrators::{ENOUGH_DIGITS, Failure, Method, Reference, Span, Work, difference, shared_digits};
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
    /// The state as it is integrated; the places alone where velocities have no bound.
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
    /// The run does not begin, or ends by a state that no signal shows; in words.
    Ends(String),
    /// Two methods share fewer digits than a reference needs.
    FewDigits {
        digits: f64,
    },
    /// Bounces without end are taken for ended.
    LastBounce {
        time: f64,
    },
    /// An event there has no signal that falls through zero.
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
                write!(
                    f,
                    "the event at t = {time:.9} s has no signal that passes through zero, so that its time is not known to more digits"
                )
            }
            Unknown::LastBounce { time } => {
                write!(f, "infinitely many bounces end at t = {time:.9} s, and a reference needs each of them")
            }
            Unknown::FewDigits { digits } => {
                write!(
                    f,
                    "two methods agree to {digits:.1} digits of the motion, and a reference needs {ENOUGH_DIGITS}"
                )
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

/// Two methods of different families. With more stages Gauss' steps are longer than its error estimate judges well: where a rod
/// straightens they changed a conserved quantity, 2e-15, by 1e-28 with 12 stages and by 1e-24 with 16; with 8 by 4e-31.
const METHODS: [Method; 2] = [Method::Gauss { stages: 8 }, Method::GraggBulirschStoer];

/// A time and the state at it.
pub type At = (DoubleDouble, Vec<DoubleDouble>);

/// The motion as one method found it.
pub struct Followed {
    /// The states at the instants.
    pub states: Vec<Vec<DoubleDouble>>,
    /// The states at the events, and at an end before the span's. Where velocities grow without bound the places alone.
    pub events: Vec<At>,
}

/// The motion on which two methods agree, and each event in words: the event, and the law that goes on.
///
/// # Errors
/// Where a method does not follow the motion.
pub fn agreed(
    times: Vec<f64>,
    sizes: Vec<f64>,
    allowed: Duration,
    follow: impl Fn(Means) -> Result<(Followed, Means), Unknown>,
    words: impl Fn(usize) -> [String; 2],
) -> Result<Exact, Unknown> {
    let by = |method: Method| {
        let deadline = Instant::now() + allowed / 2;
        follow(Means { method, sizes: sizes.clone(), deadline, work: Work::default() })
    };
    let ((first, one), (second, other)) = (by(METHODS[0])?, by(METHODS[1])?);
    let digits = shared_digits(apart(&first, &second, &sizes));
    let event = |(place, (time, state)): (usize, At)| {
        let [what, regime] = words(place);
        Event { time, state, what, regime }
    };
    let events = first.events.into_iter().enumerate().map(event).collect();
    let work = [one.work, other.work];
    Ok(Exact { reference: Reference { times, states: first.states, digits, sizes, methods: METHODS, work }, events })
}

/// Equidistant instants of a run: to its end, or to shortly before an earlier one.
pub fn instants(start: &[f64], time: f64, is_whole: bool) -> Vec<f64> {
    let horizon = if is_whole { time } else { rounded_down(time) };
    Span::<f64>::new(0.0, horizon, start).with_even_outputs(INSTANTS).outputs
}

/// The largest relative difference, of states and of times.
fn apart(one: &Followed, other: &Followed, sizes: &[f64]) -> f64 {
    let states = |of: &Followed| -> Vec<Vec<DoubleDouble>> {
        of.states.iter().chain(of.events.iter().map(|(_, state)| state)).cloned().collect()
    };
    let times = one.events.iter().zip(&other.events).map(|((a, _), (b, _))| ((*a - *b).hi() / a.hi()).abs());
    times.fold(difference(&states(one), &states(other), sizes), f64::max)
}

/// A number of two digits below: the last instant that is compared before a motion ends.
fn rounded_down(time: f64) -> f64 {
    let unit = 10.0_f64.powf(time.log10().floor() - 1.0);
    let below = (time / unit).floor();
    // short numbers are written shortly
    format!("{:.12e}", below * unit).parse().unwrap_or(below * unit)
}
