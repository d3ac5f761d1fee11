//! Stability limits of the step size, as roots of equations for a method's one-step map.
//!
//! The map is that of [`Scheme`]; for explicit methods it is the integrator's own step over symbolic expressions.

use crate::stabilisation::schemes::Scheme;
use algebra::real::{Polynomial, Root};
use field::{Rational, Scalar};
use symbolic::{Hypotheses, Sym, normal, univariate};

/// The numerator of an expression as a polynomial in an unknown, divided by its roots at zero; `None` without rational
/// coefficients.
pub fn numerator(expression: Sym, unknown: Sym) -> Option<Polynomial> {
    let above = normal(expression, &Hypotheses::none()).ok()?.numerator();
    let mut dense = univariate(above, unknown).ok()?;
    // a root at zero is no limit
    let first = dense.iter().position(|c| *c != Rational::int(0)).unwrap_or(0);
    dense.drain(..first);
    Polynomial::from_rationals(&dense)
}

/// The smallest positive root of an expression.
pub fn first_positive(expression: Sym, unknown: Sym) -> Option<Root> {
    let zero = Root::rational(Rational::int(0))?;
    let roots = numerator(expression, unknown)?.real_roots();
    roots.into_iter().find(|root| root.compare(&zero).is_gt())
}

/// The value of a rational root: known as such, or equal to its nearest float.
pub fn rational(root: &Root) -> Option<Rational> {
    let near = || Some(Rational::exactly(root.to_f64()));
    let is_root = |value: &Rational| Root::rational(*value).is_some_and(|other| root.compare(&other).is_eq());
    root.as_rational().or_else(near).filter(is_root)
}

/// The largest product h a for which a method is stable for y' = -a y, a > 0: the first at which the amplification
/// factor is 1 or -1. `None` for an A-stable method.
pub fn fading(scheme: Scheme) -> Option<Root> {
    let beta = Sym::symbol("beta");
    let [factor] = scheme.step([[-beta]], [Sym::int(1)]).ok()?;
    let sides = [Sym::int(1), Sym::int(-1)].into_iter().filter_map(|side| first_positive(factor - side, beta));
    sides.reduce(|a, b| if a.compare(&b).is_lt() { a } else { b })
}

/// The largest step size for which solutions of y'' = -a y, a > 0, do not grow: the first at which the determinant of a
/// step is 1. `None` if there is no such step size.
pub fn swinging(scheme: Scheme, square: Rational) -> Option<Root> {
    let kappa = Sym::symbol("kappa");
    let [[a, b], [c, d]] = scheme.transition(Sym::ZERO, kappa).ok()?;
    let most = first_positive(a * d - b * c - Sym::int(1), kappa)?.as_rational()?;
    // h^2 a = kappa
    Polynomial::from_rationals(&[-most, Rational::int(0), square])?.real_roots().pop()
}

#[cfg(test)]
mod tests {
    use super::{fading, swinging};
    use crate::stabilisation::schemes::Scheme;
    use field::{Rational, Scalar};

    #[test]
    fn the_classical_bounds_come_out() {
        let one = Rational::int(1);
        let value = |root: Option<algebra::real::Root>| root.map(|root| (root.to_f64() * 1e6).round() / 1e6);
        assert_eq!(value(fading(Scheme::Euler)), Some(2.0));
        assert_eq!(value(fading(Scheme::RungeKutta4)), Some(2.785294));
        assert_eq!(value(fading(Scheme::BackwardEuler)), None);
        assert_eq!(value(swinging(Scheme::Euler, one)), None);
        assert_eq!(value(swinging(Scheme::RungeKutta4, one)), Some(2.828427));
    }
}
