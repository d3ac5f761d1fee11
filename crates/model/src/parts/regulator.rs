//! The cost function of an optimal regulator.

use crate::ScalarId;
use std::ops::Range;

/// A linear-quadratic regulator: the inputs minimise the integral of a cost, for deviations from the motion that begins at the start.
///
/// The symbols in the cost are deviations from this motion; the cost is a quadratic form of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Regulator {
    /// The indices of the inputs that the regulator sets.
    pub inputs: Vec<usize>,
    /// The cost per unit time, a function of coordinates, their rates and the inputs.
    pub cost: ScalarId,
    /// The cost of the deviation at the end of the horizon.
    pub last: Option<ScalarId>,
    /// The horizon in seconds; `None` for an infinite one.
    pub horizon: Option<f64>,
    /// Initial deviations: the coordinate, 0 for it or 1 for its rate, and the value in SI units.
    pub displaced: Vec<(usize, usize, f64)>,
    /// The ranges of bytes of the two costs in the file.
    pub at: [Range<usize>; 2],
}
