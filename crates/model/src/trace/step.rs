//! Step functions for conditions in outputs, on which the law does not depend.

use crate::arena::AtZero;
use field::{Analytic, Elementary, Over, Rational};
use symbolic::Sym;

/// The factor c of the step function below: tanh(c x) is one for every x above 1e-298.
const STEEP: f64 = 1e300;

/// Returns (1 + T)/2 with T = tanh(c x) and a very large c: 1 or 0, and 1/2 at zero. The term 1 - T^2, which is 1 only at zero, changes the value at zero to 1 or 0. The
/// derivative is zero except at zero.
pub(super) fn step(x: Sym, at_zero: AtZero) -> Sym {
    let large = Sym::lift(Rational::exactly(STEEP));
    let steep = (large * x).elementary(Elementary::Tanh, large * x);
    let twice = match at_zero {
        AtZero::Half => Sym::ONE + steep,
        AtZero::On => Sym::ONE + steep + (Sym::ONE - steep * steep),
        AtZero::Off => steep + steep * steep,
    };
    twice / (Sym::ONE + Sym::ONE)
}
