//! An entry of the catalogue of failures: a scene file with the table `[failure]`, whose threshold is an expression of the parameters.
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
//! while = "y + (1 mm)"                     # positive while the run counts as successful; may be left out
//! expects = "Zeno"                         # the name of the failure that a run shows; may be left out
//! ```
//!
//! A run holds if it reaches its end, shows no failure of the expected kind, and `while` stays positive after the start. The measured
//! threshold lies between a run that holds and one that does not.

mod measurement;
mod reading;

pub use measurement::TriedEntry;

use crate::scene::ModelScene;
use field::Rational;
use simulation::FailureKind;

/// Names of the outputs that are added to the scene for the expressions `threshold` and `while`.
const THRESHOLD: &str = "failure_threshold";
const MARGIN: &str = "failure_margin";

/// An entry of the catalogue of failures.
#[derive(Debug)]
pub struct FailureEntry {
    /// The name in `dalembert failures`.
    pub name: String,
    /// The failure in one line.
    pub title: String,
    /// The reason for which the failure must occur.
    pub why: String,
    /// A remedy, in one sentence.
    pub advice: String,
    /// The quantity of which `threshold` is a value, in words.
    pub of: String,
    /// The threshold as written in the file.
    pub formula: String,
    /// The exact threshold for the data of the file, if it is a fraction with few digits.
    pub exact: Option<Rational>,
    /// The exact threshold for the data of the file as text, with roots and functions.
    pub written: String,
    /// The threshold in SI units.
    pub threshold: f64,
    /// The unit of the threshold; empty for a pure number.
    pub unit: String,
    /// The reciprocal of the relative accuracy of the measured threshold.
    pub within: u32,
    /// The expression `while` as written in the file; it is positive as long as a run holds.
    pub margin: Option<String>,
    /// The kind of failure that the run at `fails_at` must show.
    pub expects: Option<FailureKind>,
    /// Two values of the varied number in SI units: a run holds at the first and fails at the second.
    pub between: [f64; 2],
    varies: Varied,
    scene: ModelScene,
}

/// The number that is varied.
#[derive(Clone, Debug, PartialEq)]
enum Varied {
    /// The constant step of the method.
    Step,
    /// The time span of the run.
    Span,
    /// The parameter, or the coordinate or speed at the start, with this name.
    Value(String),
}
