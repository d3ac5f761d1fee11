//! The work of a judgement, counted before it begins.

use crate::Model;
use std::fmt;

/// The kind of test that is tried, and the counts from which its time and memory follow.
#[derive(Clone, Debug, PartialEq)]
pub struct Work {
    /// The statement that is judged.
    pub subject: String,
    /// Different parts of all differences.
    pub operations: usize,
    /// Points of prime fields; none where the degree is too high for them.
    pub points: Option<usize>,
    /// The bound of the degree of a difference, as a quotient of polynomials.
    pub degree: f64,
    /// Whether normal forms follow, with a product of polynomials for each operation.
    pub by_normal_form: bool,
}

/// Seconds of one operation at one point, and bytes of one operation with its place in the graph and its values: measured on chains
/// with 20 and with 50 links.
const SECONDS_AT_A_POINT: f64 = 1.2e-8;
const BYTES: f64 = 150.0;

/// Seconds of the square of the operations of a normal form: the longest of the foreign problems and of chains.
const SECONDS_OF_NORMAL_FORM: f64 = 1.0e-7;
const BYTES_OF_NORMAL_FORM: f64 = 2.5e4;

impl Work {
    /// Seconds that it takes on a processor of today, at most for points and about so for normal forms.
    pub fn seconds(&self) -> f64 {
        let operations = self.operations as f64;
        let at_points = SECONDS_AT_A_POINT * operations * (2.0 + self.points.unwrap_or(0) as f64);
        at_points + if self.by_normal_form { SECONDS_OF_NORMAL_FORM * operations * operations } else { 0.0 }
    }

    /// Bytes of the expressions with their values, or with their normal forms.
    pub fn bytes(&self) -> f64 {
        self.operations as f64 * if self.by_normal_form { BYTES_OF_NORMAL_FORM } else { BYTES }
    }
}

/// Seconds and bytes that all principles take to form the equations of a model, by the square of its speeds times its bodies: measured on
/// chains of 20 and 50 links in space, the longest of all models of their size.
pub fn forming(model: &Model) -> (f64, f64) {
    let (speeds, bodies) = (model.speeds() as f64, model.bodies.len().max(1) as f64);
    let size = speeds * speeds * bodies;
    (SECONDS_TO_FORM * size, BYTES_TO_FORM * size)
}

const SECONDS_TO_FORM: f64 = 3.0e-5;
const BYTES_TO_FORM: f64 = 4.0e3;

impl fmt::Display for Work {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: ", self.subject)?;
        match (self.by_normal_form, self.points) {
            (true, _) => write!(f, "normal forms of {} operations", self.operations)?,
            (false, Some(points)) => write!(
                f,
                "{} operations at {points} random points of prime fields, degree below 2^{:.0}",
                self.operations,
                self.degree.log2().ceil()
            )?,
            (false, None) => write!(f, "{} operations, of a degree too high for prime fields", self.operations)?,
        }
        write!(f, "; about {:.1} s and {:.0} MB", self.seconds(), (self.bytes() / 1e6).max(1.0))
    }
}
