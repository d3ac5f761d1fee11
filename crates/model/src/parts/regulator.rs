//! The criterion of an optimal regulator.

use crate::ScalarId;
use std::ops::Range;

/// Inputs that are chosen so that the integral of a cost is least, about the motion from the start.
///
/// Letters of the cost stand for deviations from that motion; it is a quadratic form of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Regulator {
    /// Places of the inputs that are chosen.
    pub inputs: Vec<usize>,
    /// The cost by the time, of coordinates, their rates and the inputs.
    pub cost: ScalarId,
    /// The cost of the deviation at the end of the horizon.
    pub last: Option<ScalarId>,
    /// In seconds; none: without an end.
    pub horizon: Option<f64>,
    /// Deviations at the start: the coordinate, 0 or 1 for its rate, and the value.
    pub displaced: Vec<(usize, usize, f64)>,
    /// The positions of the cost and of that of the end in the file.
    pub at: [Range<usize>; 2],
}
