//! The longest steps that a method bears, as roots of its own one-step map.
//!
//! The map is that of [`Scheme`], which for the explicit methods is the integrator's own step, run over expressions.

use crate::stabilisation::schemes::Scheme;
use field::{Rational, Scalar};
use symbolic::real::{Polynomial, Root};
use symbolic::{Hypotheses, Sym, coefficients, normal};

/// The numerator of an expression as a polynomial in an unknown; `None` where it is none with rational coefficients.
pub fn numerator(expression: Sym, unknown: Sym) -> Option<Polynomial> {
    let above = normal(expression, &Hypotheses::none()).ok()?.numerator();
    let mut dense = Vec::new();
    for (exponents, c) in coefficients(above, &[unknown]).ok()? {
        let place = *exponents.first()? as usize;
        dense.resize(dense.len().max(place + 1), Rational::int(0));
        dense[place] = c.as_constant()?;
    }
    Polynomial::from_rationals(&dense)
}

/// The least positive root of an expression.
pub fn first_positive(expression: Sym, unknown: Sym) -> Option<Root> {
    let zero = Root::rational(Rational::int(0))?;
    numerator(expression, unknown)?.real_roots().into_iter().find(|root| root.compare(&zero).is_gt())
}

/// The longest step with which a method lets y' = -a y fade, a > 0: where the factor of a step leaves the unit circle.
/// `None` where it never does.
pub fn fading(scheme: Scheme, rate: Rational) -> Option<Root> {
    let h = Sym::symbol("h");
    let [factor] = scheme.step([[-(Sym::constant(rate) * h)]], [Sym::int(1)]).ok()?;
    first_positive(factor * factor - Sym::int(1), h)
}

/// The longest step with which y'' = -a y, a > 0, does not grow: where the determinant of a step becomes 1 again.
/// `None` where there is none.
pub fn swinging(scheme: Scheme, square: Rational) -> Option<Root> {
    let h = Sym::symbol("h");
    let [[a, b], [c, d]] = scheme.transition(Sym::ZERO, Sym::constant(square) * h * h).ok()?;
    first_positive(a * d - b * c - Sym::int(1), h)
}

#[cfg(test)]
mod tests {
    use super::{fading, swinging};
    use crate::stabilisation::schemes::Scheme;
    use field::{Rational, Scalar};

    #[test]
    fn the_classical_bounds_come_out() {
        let one = Rational::int(1);
        let value = |root: Option<symbolic::real::Root>| root.map(|root| (root.to_f64() * 1e6).round() / 1e6);
        assert_eq!(value(fading(Scheme::Euler, one)), Some(2.0));
        assert_eq!(value(fading(Scheme::RungeKutta4, one)), Some(2.785294));
        assert_eq!(value(fading(Scheme::BackwardEuler, one)), None);
        assert_eq!(value(swinging(Scheme::Euler, one)), None);
        assert_eq!(value(swinging(Scheme::RungeKutta4, one)), Some(2.828427));
    }
}
