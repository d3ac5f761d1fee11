//! Estimates of the cost of a check before it is run.

use crate::Model;
use std::fmt;

/// The kind of a check, and the counts from which its time and memory are estimated.
#[derive(Clone, Debug, PartialEq)]
pub struct Work {
    /// The statement that is checked.
    pub subject: String,
    /// The number of distinct subexpressions of all differences.
    pub operations: usize,
    /// The number of points of prime fields; `None` if the degree is too high.
    pub points: Option<usize>,
    /// A bound of the degree of a difference, as a quotient of polynomials.
    pub degree: f64,
    /// Whether normal forms are computed, with a product of polynomials for each operation.
    pub by_normal_form: bool,
}

/// Seconds per operation and point, and bytes per operation with its node and its values; measured on chains
/// with 20 and 50 links.
const SECONDS_AT_A_POINT: f64 = 1.2e-8;
const BYTES: f64 = 150.0;

/// Seconds per squared number of operations of a normal form; the largest value measured on chains and on problems from the literature.
const SECONDS_OF_NORMAL_FORM: f64 = 1.0e-7;
const BYTES_OF_NORMAL_FORM: f64 = 2.5e4;

impl Work {
    /// Returns the estimated seconds on a current processor: an upper bound for tests at points, an approximation for normal forms.
    pub fn seconds(&self) -> f64 {
        let operations = self.operations as f64;
        let at_points = SECONDS_AT_A_POINT * operations * (2.0 + self.points.unwrap_or(0) as f64);
        at_points + if self.by_normal_form { SECONDS_OF_NORMAL_FORM * operations * operations } else { 0.0 }
    }

    /// Returns the estimated bytes of the expressions with their values, or with their normal forms.
    pub fn bytes(&self) -> f64 {
        self.operations as f64 * if self.by_normal_form { BYTES_OF_NORMAL_FORM } else { BYTES }
    }
}

/// Returns the estimated seconds and bytes in which all principles form the equations of a model: proportional to the squared number of speeds
/// times the number of bodies. Measured on chains of 20 and 50 links in space, which take longest among models of equal size.
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
                "{} operations at {points} random points modulo large random primes, degree below 2^{:.0}",
                self.operations,
                self.degree.log2().ceil()
            )?,
            (false, None) => {
                write!(f, "{} operations, of a degree too high for points modulo primes", self.operations)?
            }
        }
        write!(f, "; about {:.1} s and {:.0} MB", self.seconds(), (self.bytes() / 1e6).max(1.0))
    }
}
