//! The linear equations about a steady motion, and the comparison of their stability condition with a printed one.

use crate::linear_motion::{Characteristic, LinearMotion};
use crate::refutation::Refutation;
use symbolic::Sym;

/// The citation of the theorem on the roots of a polynomial.
pub(crate) const HURWITZ: &str = "A. Hurwitz, Math. Ann. 46 (1895), 273-284: all roots have negative real parts where, and only where, all principal minors \
    of the matrix of coefficients are positive; with even powers alone the squares of the roots must be negative numbers, each of its own";

/// The linear equations about a steady motion, and their characteristic polynomial.
pub(crate) struct LinearEquations {
    /// Expressions that vanish along every motion.
    pub equations: Vec<Sym>,
    /// The indices of the coordinates that are constant.
    pub resting: Vec<usize>,
    /// The unknown of the polynomial.
    pub root: Sym,
    /// The factor with which the determinant becomes a polynomial.
    pub scale: Sym,
    /// The coefficients by ascending powers, after division by the power of the zero roots.
    pub coefficients: Vec<Sym>,
    /// The number of zero roots.
    pub neutral: u32,
}

impl LinearEquations {
    pub fn of(linear: &LinearMotion, found: Characteristic) -> Self {
        let Characteristic { root, scale, coefficients, neutral } = found;
        let LinearMotion { equations, resting, .. } = linear;
        LinearEquations { equations: equations.clone(), resting: resting.clone(), root, scale, coefficients, neutral }
    }
}

/// A positive ratio of two conditions, and the even power of a known condition (by its index) by which the ratio was divided.
pub(crate) struct Multiple {
    pub ratio: Sym,
    pub square: Option<(usize, i32)>,
}

/// The comparison of the condition on the eigenvalues with the printed one.
pub(crate) enum Comparison {
    /// The condition on the eigenvalues is a positive multiple of the printed one.
    Same(Multiple),
    /// The conditions differ at this point.
    Other(Refutation),
}
