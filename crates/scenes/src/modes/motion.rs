//! The motion in a mode, over symbols.

use super::algebraic::Parted;
use super::contacts::PARTS;
use super::held::held;
use super::mode::Mode;
use crate::compiled_system::NotCompiled;
use model::Trace;
use symbolic::Sym;

/// Accelerations in a mode, and the values of the switches.
pub(crate) struct ModeMotion {
    pub accelerations: Vec<Sym>,
    pub multipliers: Vec<Sym>,
    /// Normal and tangential reaction of each contact.
    pub reactions: Vec<[Sym; PARTS]>,
    /// The determinant of the equations for the reactions.
    pub determinant: Sym,
    /// 1, 0, or the value that keeps the condition at zero.
    pub switches: Vec<Sym>,
    /// Each switch; for a switch at its bound, the share that it would have without the bound.
    pub parts: Vec<Sym>,
    /// Letters of algebraic speeds, with their expressions.
    pub speeds: Vec<(Sym, Sym)>,
    /// Letters of algebraic speeds without an expression, with sums that must be zero.
    pub implicit: Vec<(Sym, Sym)>,
}

impl ModeMotion {
    pub(crate) fn of(trace: &Trace<'_>, mode: &Mode) -> Result<Self, NotCompiled> {
        held(trace, mode, Parted::of(trace)?)
    }
}
