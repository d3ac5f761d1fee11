//! Reference solutions across events, by two methods that agree.
//!
//! A run in `f64` gives the sequence of laws and, approximately, the times of their changes. Each law is smooth, also
//! beyond its end. Two methods of different families then integrate the laws in double-double, independently: the time
//! of an event is the zero of its signal, located by Newton's method, as a double-double number (`flow`).
//!
//! The sequence of laws is that of the run in `f64`. An event that is decided by a tie is determined only to the
//! accuracy of the tie.

use super::INSTANTS;
use super::flow::Means;
use field::{DoubleDouble, decimal};
use integrators::{ENOUGH_DIGITS, Failure, Method, Reference, Span, Work, difference, shared_digits};
use std::fmt;
use std::time::{Duration, Instant};

/// A reference solution across events.
#[derive(Clone, Debug)]
pub struct Exact {
    /// The states at output times up to the end, or to shortly before an earlier end of the motion.
    pub reference: Reference,
    pub events: Vec<Event>,
}

/// An event with the accuracy of the reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    pub time: DoubleDouble,
    /// The state after integration; only the coordinates where velocities are unbounded.
    pub state: Vec<DoubleDouble>,
    pub what: String,
    /// The subsequent regime; empty at an end.
    pub regime: String,
}

impl Event {
    /// The time of the event (s) with `places` decimal places.
    pub fn instant(&self, places: usize) -> String {
        decimal(self.time, places).unwrap_or_default()
    }
}

/// The reason why there is no reference.
#[derive(Clone, Debug, PartialEq)]
pub enum Unknown {
    /// The run does not begin, or ends in a state that no signal indicates; the text gives the reason.
    Ends(String),
    /// The two methods agree on fewer digits than a reference needs.
    FewDigits {
        digits: f64,
    },
    /// A sequence of infinitely many bounces, which a run treats as ended.
    LastBounce {
        time: f64,
    },
    /// An event at that time has no signal that falls through zero.
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

/// Two methods of different families. With more stages the steps of Gauss' method become too long for its error
/// estimate: where a rod straightens, a conserved quantity of 2e-15 changed by 1e-28 with 12 stages, by 1e-24 with 16,
/// and by 4e-31 with 8.
const METHODS: [Method; 2] = [Method::Gauss { stages: 8 }, Method::GraggBulirschStoer];

/// A time and the state then.
pub type At = (DoubleDouble, Vec<DoubleDouble>);

/// The motion as computed by one method.
pub struct Followed {
    /// The states at the output times.
    pub states: Vec<Vec<DoubleDouble>>,
    /// The states at the events, and at an early end; only the coordinates where velocities grow without bound.
    pub events: Vec<At>,
}

/// The motion on which two methods agree, at the output times `times` (s). `sizes` has the size of each state. Each method
/// gets half of the time `allowed`. `follow` computes the motion by the given means, and returns them with the work done.
/// `words` gives two texts for each event: the event, and the subsequent law.
///
/// # Errors
/// [`Unknown`] where a method fails, or the two do not agree.
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

/// Equidistant output times of a run (s) from the state `start`: up to `time` if `is_whole`, else to shortly before `time`,
/// at which the motion ends.
pub fn instants(start: &[f64], time: f64, is_whole: bool) -> Vec<f64> {
    let horizon = if is_whole { time } else { rounded_down(time) };
    Span::<f64>::new(0.0, horizon, start).with_even_outputs(INSTANTS).outputs
}

/// The largest relative difference of states and times.
fn apart(one: &Followed, other: &Followed, sizes: &[f64]) -> f64 {
    let states = |of: &Followed| -> Vec<Vec<DoubleDouble>> {
        of.states.iter().chain(of.events.iter().map(|(_, state)| state)).cloned().collect()
    };
    let times = one.events.iter().zip(&other.events).map(|((a, _), (b, _))| ((*a - *b).hi() / a.hi()).abs());
    times.fold(difference(&states(one), &states(other), sizes), f64::max)
}

/// The time rounded down to two digits: the last output time before a motion ends.
fn rounded_down(time: f64) -> f64 {
    let unit = 10.0_f64.powf(time.log10().floor() - 1.0);
    let below = (time / unit).floor();
    // the shortest decimal form
    format!("{:.12e}", below * unit).parse().unwrap_or(below * unit)
}
