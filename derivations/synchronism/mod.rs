//! What a synchronous motor does under load: in step, out of it, and from where it comes into step.
//!
//! # Overview
//! * [`loaded`]: the motor alone, its load a state that rests;
//! * [`branches`]: all that it can do for ever under every load, with stability: angles in step up to the pull-out, and
//!   slipping turn after turn;
//! * [`pull_in`]: where the slipping begins;
//! * [`energy`]: what holds a rotor that is in step;
//! * [`basin`]: which starts come into step, on the bench and in a gyrostat;
//! * [`maps`]: the share of them over load and damping, over load and bars;
//! * `claims`: what of this is proved, as a page of the workbench's own.
//!
//! Pull-out is the load at which the angles in step end. Pull-in is the least load under which the rotor can slip for ever,
//! turn after turn alike. Between the two both are stable, and it is the start that decides.

pub mod basin;
pub mod branches;
mod claims;
pub mod energy;
pub mod loaded;
pub mod maps;
pub mod pull_in;

use ::claims::Paper;

/// The page in the ledger.
pub const PAPER: Paper = Paper {
    key: "synchronism",
    title: "Synchronism of a motor under load",
    citation: "The workbench's own page. The motors are those of B. I. Konosevich, Yu. B. Konosevich 2022, sections 3 and 4; the equation of the motor without currents is that of F. Tricomi 1933, the work along the separatrix V. K. Melnikov's 1963.",
    summary: r"A rotor under a further load $M$ keeps an angle where $b_0\sin\gamma=-(M+f\Omega)$. The angles on both branches merge at $\cos\gamma=0$, a fold: one eigenvalue passes through zero there, whatever the windings. $V=\frac12A'\dot\gamma^2-b_0\cos\gamma+\sum\frac12L_ki_k^2+(M+f\Omega)\gamma$ never grows, so that a rotor with less of it than both neighbouring balances stays between them. To the first order in friction a rotor can slip for ever from $M+f\Omega=\frac4\pi f\sqrt{b_0/A'}$ on. In a gyrostat the rotor moves as one with the moment of inertia $1/(1/A'+l\cdot A^{-1}l)$.",
    entries: &["fold", "energy", "separatrix", "carrier"],
    page: claims::page,
};
