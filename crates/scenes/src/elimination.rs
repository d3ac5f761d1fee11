//! The way in which accelerations are found: by an elimination that is written down, or by a solve at each evaluation.

use crate::changing_laws::is_watched;
use model::equations::has_tree;
use model::{Model, Trace};
use symbolic::apart;

/// The way in which accelerations are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Elimination {
    /// By an elimination that is written down.
    Written,
    /// By a solve at each evaluation.
    Solved,
}

/// Systems with more unknowns, accelerations and multipliers together, are solved at each evaluation: the elimination grows with
/// their third power.
pub(crate) const MOST_WRITTEN: usize = 40;

/// Series of systems with at least so many unknowns solve for them. Measured at order 20 on chains of links, with a solve and written
/// down: 3 links 22 and 26 us, 6 links 76 and 114, 10 links 217 and 346, 20 links 1.7 and 2.7 ms.
pub(crate) const LEAST_SOLVED: usize = 5;

/// But not where the coefficients of fewer unknowns move: an elimination that is written down has constants in the place of the others.
/// The electromechanical drive has three of seven that move, and a step with a solve took 1.14 times as long; an induction machine has
/// four of five, and a step without one took 1.45 times as long.
pub(crate) const LEAST_MOVING: usize = 4;

/// Bodies in a tree with more constraints than these are solved for at each evaluation: closed loops are no tree.
const MOST_LOOPS: usize = 200;

/// Whether the elimination of a model goes over a tree of bodies, and grows as these.
pub(crate) fn is_tree(model: &Model) -> bool {
    model.constraints.len() <= MOST_LOOPS && apart(|| has_tree(&Trace::of(model)))
}

impl Elimination {
    /// The way of a model; one with conditions or events has its elimination written down.
    pub fn of(model: &Model) -> Self {
        let unknowns = model.speeds() + model.constraints.len();
        let is_short = || unknowns <= MOST_WRITTEN || is_tree(model);
        if is_watched(model) || is_short() { Elimination::Written } else { Elimination::Solved }
    }
}
