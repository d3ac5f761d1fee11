//! The method by which accelerations are computed: symbolic elimination, or linear equations solved numerically at each evaluation.

use crate::changing_laws::is_watched;
use model::equations::has_tree;
use model::{Model, Trace};
use symbolic::apart;

/// The method by which accelerations are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Elimination {
    /// Explicit expressions by symbolic elimination.
    Written,
    /// Linear equations, solved numerically at each evaluation.
    Solved,
}

/// Systems with more unknowns than this (accelerations and multipliers together) are solved numerically: the length of an elimination
/// grows with the third power of their number.
pub(crate) const MOST_WRITTEN: usize = 40;

/// Taylor series of systems with at least this many unknowns solve linear equations for them. Time of a series of order 20 on chains of
/// links, solved and eliminated: 3 links 22 and 26 us, 6 links 76 and 114 us, 10 links 217 and 346 us, 20 links 1.7 and 2.7 ms.
pub(crate) const LEAST_SOLVED: usize = 5;

/// Series solve linear equations only if at least this many unknowns have variable coefficients; an elimination turns the others into
/// constants. With three of seven (electromechanical drive) a step with a solve took 1.14 times as long; with four of five (induction
/// machine) a step without one took 1.45 times as long.
pub(crate) const LEAST_MOVING: usize = 4;

/// A model with more constraints than this does not count as a tree: constraints close loops between bodies.
const MOST_LOOPS: usize = 200;

/// True if accelerations can be eliminated along a tree of bodies, with a length linear in their number.
pub(crate) fn is_tree(model: &Model) -> bool {
    model.constraints.len() <= MOST_LOOPS && apart(|| has_tree(&Trace::of(model)))
}

impl Elimination {
    /// The method for a model. A model with conditions or events is always eliminated symbolically.
    pub fn of(model: &Model) -> Self {
        let unknowns = model.speeds() + model.constraints.len();
        let is_short = || unknowns <= MOST_WRITTEN || is_tree(model);
        if is_watched(model) || is_short() { Elimination::Written } else { Elimination::Solved }
    }
}
