//! Entries of the catalogue of failures as text: a scene with the table `[failure]`, whose threshold is an expression of its parameters.
//!
//! ```toml
//! [failure]
//! name = "bounces"                         # as `dalembert failures` calls it
//! title = "a ball that bounces to rest"
//! why = "..."
//! advice = "..."
//! vary = "span"                            # or "step", or a parameter, or a value of the start
//! holds_at = "1 s"
//! fails_at = "5 s"
//! of = "the time of the last rebound"
//! threshold = "sqrt(2*h/g)*(1 + e)/(1 - e)"
//! while = "y + (1 mm)"                     # positive while the run holds; may be left out
//! expects = "Zeno"                         # the name of the failure that a run shows; may be left out
//! ```
//!
//! A run holds where it reaches its end, shows no failure of the kind that is expected, and `while` stays positive after the start. The
//! measured threshold lies between a run that holds and one that does not.

mod measurement;
mod reading;

pub use measurement::TriedEntry;

use crate::scene::ModelScene;
use field::Rational;
use simulation::FailureKind;

/// The names under which the expressions of an entry are outputs of its scene.
const THRESHOLD: &str = "failure_threshold";
const MARGIN: &str = "failure_margin";

/// An entry of the catalogue.
#[derive(Debug)]
pub struct FailureEntry {
    pub name: String,
    pub title: String,
    pub why: String,
    pub advice: String,
    /// The quantity that has the threshold.
    pub of: String,
    /// The threshold as written in the file.
    pub formula: String,
    /// The threshold for the data of the file as a fraction, where it is one with few digits.
    pub exact: Option<Rational>,
    /// The threshold for the data of the file as text, with its roots and functions.
    pub written: String,
    /// The threshold in SI units.
    pub threshold: f64,
    /// The unit of the threshold; empty for a pure number.
    pub unit: String,
    /// The relative accuracy of the measured threshold is one over this number.
    pub within: u32,
    /// The condition under which a run holds, as the file has it.
    pub margin: Option<String>,
    /// The failure that the run at `fails_at` must show.
    pub expects: Option<FailureKind>,
    /// Two values in SI units: a run holds at the first one and fails at the second one.
    pub between: [f64; 2],
    varies: Varied,
    scene: ModelScene,
}

/// The number that is varied.
#[derive(Clone, Debug, PartialEq)]
enum Varied {
    /// The constant step of the method.
    Step,
    /// The length of the run.
    Span,
    /// A parameter, a coordinate or a speed at the start.
    Value(String),
}
