//! What happened in a run, and why.

use super::stretch::Watched;
use integrators::{Failure, Happening};
use mechanics::regimes::{Condition, Direction, Face, Mode, Unfit};
use std::fmt;

/// Names of a system's contacts.
pub type Names<const K: usize> = [&'static str; K];

/// A line of the log: from here on, this regime.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry<const K: usize> {
    pub time: f64,
    /// Places and velocities, made exact.
    pub place: Vec<f64>,
    pub velocity: Vec<f64>,
    pub cause: Cause,
    pub regime: [Mode; K],
    /// Whether the regime determines its reactions; where it does not, the system rests.
    pub determined: bool,
    /// Normal and tangential reactions in the regime, N.
    pub reactions: [[f64; 2]; K],
    /// Work of friction and of the given forces until here, J.
    pub works: [f64; 2],
}

/// Why a regime was decided here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause {
    Start,
    /// A signal of the regime before fell, or touched zero; with the rate at which it did.
    Signal {
        watched: Watched,
        what: Happening,
        rate: f64,
    },
}

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ending<const K: usize> {
    /// At the end of its span.
    Reached,
    /// In motion, in a regime that does not determine its reactions: their work is unknown.
    Undetermined,
    /// A contact closes with a velocity: an impact, which is not modelled.
    TouchDown { contact: usize, speed: f64 },
    /// No regime is consistent.
    NoMotion,
    /// At least two motions are consistent.
    Several([Mode; K], [Mode; K]),
    /// A singular regime admits motions without end.
    Continuum([Mode; K]),
    /// The determinant of the regime vanishes: its reactions grow beyond every bound.
    Critical,
    /// All consistent regimes fail at once: the tie is of higher order than the rates of the margins tell.
    Tie,
    /// More events than the run allows, in ever shorter time.
    TooManyEvents,
    /// The state at the start is none.
    Unfit(Unfit),
    /// The state, the force or the constraints are not regular.
    Undefined,
    /// The end was reached, with an energy that is off by more than all energy that was there.
    Unbalanced,
    /// The integration failed.
    Failed(Failure),
    /// The observer had seen enough.
    BrokenOff,
}

/// A mode at a contact, in words.
pub fn describe<const K: usize>(names: &Names<K>, regime: &[Mode; K]) -> String {
    let word = |mode: Mode| match mode {
        Mode::Apart => "apart".to_owned(),
        Mode::Stick(face) => format!("sticks{}", side(face)),
        Mode::Slip(Direction::Forwards, face) => format!("slips forwards{}", side(face)),
        Mode::Slip(Direction::Backwards, face) => format!("slips backwards{}", side(face)),
    };
    names.iter().zip(regime).map(|(name, mode)| format!("{name} {}", word(*mode))).collect::<Vec<_>>().join(", ")
}

fn side(face: Face) -> &'static str {
    if face == Face::Front { "" } else { " (held from behind)" }
}

impl Watched {
    /// In words.
    pub fn describe<const K: usize>(&self, names: &Names<K>) -> String {
        match self {
            Watched::Condition(k, Condition::Presses) => format!("the normal reaction at {}", names[*k]),
            Watched::Condition(k, condition) => format!("the {condition} at {}", names[*k]),
            Watched::Sliding(k) => format!("sliding at {}", names[*k]),
            Watched::Gap(k) => format!("the gap at {}", names[*k]),
            Watched::Determinant => "the determinant of the regime".into(),
            Watched::Uniqueness => "the regime".into(),
            Watched::Rest => "the limits of friction".into(),
        }
    }
}

/// With six digits after the point, or as a power of ten where these would be no digits of it.
fn plain(value: f64) -> String {
    if value.abs() < 1e9 { format!("{value:.6}") } else { format!("{value:.6e}") }
}

impl Cause {
    /// In words.
    pub fn describe<const K: usize>(&self, names: &Names<K>) -> String {
        let Cause::Signal { watched, what, rate } = self else { return "start".into() };
        let verb = if *what == Happening::Touches { "touches zero" } else { "falls to zero" };
        let what = watched.describe(names);
        match watched {
            Watched::Condition(..) => format!("{what} {verb} (rate {})", plain(*rate)),
            Watched::Sliding(_) => format!("{what} stops (acceleration {})", plain(*rate)),
            Watched::Gap(_) => format!("{what} closes (velocity {})", plain(*rate)),
            Watched::Determinant => format!("{what} {verb}"),
            Watched::Uniqueness => format!("{what} is no longer the only motion"),
            Watched::Rest => format!("{what} no longer allow rest"),
        }
    }
}

impl<const K: usize> Ending<K> {
    /// In words.
    pub fn describe(&self, names: &Names<K>) -> String {
        match self {
            Self::Reached => "the end of the span".into(),
            Self::Undetermined => "in motion with more reactions than equations: they are not determined".into(),
            Self::TouchDown { contact, speed } => {
                format!("{} touches down with {speed:.6}: an impact, which is not modelled", names[*contact])
            }
            Self::NoMotion => "no regime is consistent: with Coulomb's law the state has no acceleration".into(),
            Self::Several(a, b) => {
                format!("several motions are consistent: {}; or {}", describe(names, a), describe(names, b))
            }
            Self::Continuum(a) => format!("motions without end are consistent with: {}", describe(names, a)),
            Self::Critical => "the determinant of the regime vanishes: the reactions grow beyond every bound".into(),
            Self::Tie => "all consistent regimes fail at once, and the rates of their margins do not decide".into(),
            Self::TooManyEvents => "more events than are allowed, in ever shorter time".into(),
            Self::Unfit(unfit) => unfit.to_string(),
            Self::Undefined => "the state has no defined acceleration".into(),
            Self::Unbalanced => {
                "the energy balance is open by more than all energy: the run does not follow its law".into()
            }
            Self::Failed(failure) => failure.to_string(),
            Self::BrokenOff => "interrupted".into(),
        }
    }
}

impl<const K: usize> fmt::Display for Entry<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "t = {:.9}: {:?}", self.time, self.regime)
    }
}
