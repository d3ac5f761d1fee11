//! Stability of stationary motions, exactly.
//!
//! # Overview
//! * [`state`]: stationary motions and deviations from them;
//! * [`linear`]: the first approximation and the second variation of the energy, by differentiation, over any field;
//! * [`approximation`]: both for a scene's gyrostat and motor, written down once and run over fractions and enclosures;
//! * [`verdict`]: the closed set of answers, and the theorems behind them; [`judged`]: one with what it rests on;
//! * [`judge`]: of a scene's motions, with enclosures fine enough, and with fractions where all is rational;
//! * [`family`]: circles and spheres of motions as curves that fractions parametrise; [`critical`]: the functions on them one
//!   of which vanishes where a verdict changes; [`along`]: the verdicts, arc by arc; [`symmetry`]: where one member stands for all;
//! * [`reduced`]: the two classical gyrostats in three unknowns, for theorems, maps and pictures;
//! * [`cone`]: the same for every point of the cone, exactly;
//! * [`map`]: where rotation about the axis of everything is stable, over two speeds; [`plane`]: over any two data
//!   ([`datum`]); [`region`]: of every motion of any gyrostat, judged at nodes and followed between them;
//! * `claims`: the theorems, in letters: structural zeros, polynomials, what motors have in common, closed forms.

pub mod along;
pub mod approximation;
mod claims;
pub mod cone;
pub mod critical;
pub mod datum;
pub mod family;
pub mod judge;
pub mod judged;
pub mod linear;
pub mod map;
pub mod plane;
pub mod reduced;
pub mod region;
pub mod state;
pub mod symmetry;
pub mod verdict;

pub use along::Along;
pub use approximation::Approximation;
pub use judged::Judged;
pub use linear::{Integral, Linear};
pub use state::Place;
pub use verdict::{Reason, Verdict};

use ::claims::Paper;

/// The page in the ledger.
pub const PAPER: Paper = Paper {
    key: "stability",
    title: "Stability of the stationary motions of a gyrostat with a motor",
    citation: "The workbench's own page, in the letters of B. I. Konosevich, Yu. B. Konosevich 2022, section 6, whose paper leaves stability open. Theorems: E. J. Routh 1877; A. M. Lyapunov 1892; A. Ostrowski, H. Schneider 1962; E. E. Zajac 1964.",
    summary: r"Every motor enters the characteristic equation through one function, its operational stiffness $Z(z)$: $A'\det A\,z^2p_f(z)+Z(z)\det A^*p_c(z)=0$, where $p_f$ and $p_c$ belong to the classical gyrostats with a free rotor and with a rotor of constant speed ($Z=0$ and $Z=\infty$). Evenly spaced bars and their two equivalent windings have one $Z$. Without currents, $Z=K+dz$, the conditions of asymptotic stability ask for $K>0$, $d>0$ and for inequalities in which neither stands: stability does not depend on how strong the motor is. The energy at fixed integrals decides for every motor at once: what is stable by gyroscopic forces alone, at constant speed, a real motor makes unstable, unless it does not feel it. An upright gyrostat is held by its rotor along the vertical if $(A'\Omega)^2>\Gamma(\sqrt{A_1^*}+\sqrt{A_2^*})^2$, by a rotor across it never. On a circle of motions no tilt lowers the energy where $A_1^*>A_3^*$, and all members but those with $b=0$ are unstable at constant speed where $A_1^*<A_3^*$.",
    entries: &[
        "law",
        "zeros",
        "energy",
        "constant-speed",
        "motor",
        "currents",
        "damping",
        "axis",
        "balanced",
        "rest",
        "family",
    ],
    page: claims::page,
};
