//! The motion in a mode as symbolic expressions.

use super::algebraic::Parted;
use super::contacts::PARTS;
use super::held::held;
use super::mode::Mode;
use crate::compiled_system::NotCompiled;
use model::Trace;
use symbolic::Sym;

/// Expressions of the motion in a mode over the symbols of the state.
pub(crate) struct ModeMotion {
    /// The rates of all speeds.
    pub accelerations: Vec<Sym>,
    /// The multipliers of all constraints.
    pub multipliers: Vec<Sym>,
    /// The normal reaction and the friction along each tangent, for each contact.
    pub reactions: Vec<[Sym; PARTS]>,
    /// The determinant of the equations for the reactions.
    pub determinant: Sym,
    /// The value of each switch: 1, 0, or the value for which the condition stays at zero.
    pub switches: Vec<Sym>,
    /// The switches; for a switch at its bound the value that it would have without the bound.
    pub parts: Vec<Sym>,
    /// Symbols of algebraic speeds, with their expressions.
    pub speeds: Vec<(Sym, Sym)>,
    /// Symbols of implicit algebraic speeds, each with an equation as an expression equal to zero.
    pub implicit: Vec<(Sym, Sym)>,
}

impl ModeMotion {
    /// The motion of a model in a mode.
    ///
    /// # Errors
    /// The equations of the mode have no solution.
    pub(crate) fn of(trace: &Trace<'_>, mode: &Mode) -> Result<Self, NotCompiled> {
        held(trace, mode, Parted::of(trace)?)
    }
}
