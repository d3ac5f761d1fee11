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
    /// 1, 0, or what keeps the condition at zero.
    pub switches: Vec<Sym>,
    /// Each switch, or its part of what keeps conditions at zero where that is beyond its bound.
    pub parts: Vec<Sym>,
    /// Letters of algebraic speeds, with what stands for them.
    pub speeds: Vec<(Sym, Sym)>,
    /// Letters of algebraic speeds for which no expression stands, with sums that these keep at zero.
    pub implicit: Vec<(Sym, Sym)>,
}

impl ModeMotion {
    pub(crate) fn of(trace: &Trace<'_>, mode: &Mode) -> Result<Self, NotCompiled> {
        held(trace, mode, Parted::of(trace)?)
    }
}
