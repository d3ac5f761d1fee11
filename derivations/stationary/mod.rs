//! All stationary motions of a gyrostat with any motor, and the workbench's own page about them.
//!
//! # Overview
//! * [`energies`]: the quadratic form and the vectors that decide, from the bodies' energies;
//! * [`motor`]: every stationary speed, angle and current of any machine, and what it can bear;
//! * [`motions`]: both together, for a scene: every stationary motion for a given angular velocity or momentum;
//! * [`stability`]: what becomes of small deviations from each;
//! * [`branches`]: the cone of all of them, for pictures;
//! * `claims`: the theorems on which this rests.
//!
//! A stationary motion: the carrier turns with a constant w about the vertical v, fixed in it, and the rotor keeps its
//! relative speed. The carrier's equations ask that v be a critical point of W (`mechanics::uniform`); the rotor's that
//! the motor's moment vanish, friction included; the windings' that every current rest: at zero, unless a supply
//! feeds it.

pub mod branches;
mod claims;
pub mod energies;
pub mod motions;
pub mod motor;
pub mod stability;

use ::claims::Paper;

/// The page in the ledger.
pub const PAPER: Paper = Paper {
    key: "stationary",
    title: "All stationary motions of a gyrostat with a motor",
    citation: "The workbench's own page. The conditions are those of B. I. Konosevich, Yu. B. Konosevich 2022, section 6; the equation for the multiplier is that of trust regions (J. J. More, D. C. Sorensen 1983).",
    summary: r"For a given angular velocity $\omega$ the stationary directions are the critical points of $W=\frac12\omega^2\,\nu\cdot M\nu+\omega\,h\cdot\nu+G\cdot\nu$ on the sphere. With a multiplier $\lambda$ they are the real roots of one polynomial in $\lambda$, in general of degree six: one below and one above all eigenvalues of $\omega^2M$, none or two in each gap. Where $b=\omega h+G$ is orthogonal to an eigenspace, pairs, circles or the sphere come in addition. The number of roots gives the kind of each point: minimum, saddle, maximum. With the vertical momentum given, $\omega$ is eliminated too. Folds, where two motions merge, are common roots of two polynomials; between them the number of motions is constant.",
    entries: &["gradient", "multiplier", "gaps", "beyond", "kind", "momentum", "idle", "motor"],
    page: claims::page,
};
