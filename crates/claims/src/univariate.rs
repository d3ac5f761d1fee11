//! Polynomials in one unknown with rational coefficients, for refutations of existence.

use algebra::real::Polynomial;
use field::Rational;
use num_traits::Zero;
use symbolic::{Sym, coefficients};

/// The expression as a polynomial in the unknown; `None` where it has other symbols or is not a polynomial.
pub(crate) fn polynomial(expression: Sym, unknown: Sym) -> Option<Polynomial> {
    let mut dense = Vec::new();
    for (exponents, coefficient) in coefficients(expression, &[unknown]).ok()? {
        let place = *exponents.first()? as usize;
        dense.resize(dense.len().max(place + 1), Rational::zero());
        dense[place] = coefficient.as_constant()?;
    }
    Polynomial::from_rationals(&dense)
}

/// Whether the common complex roots of all polynomials are exactly zero: their greatest common divisor is a power of the
/// unknown.
pub(crate) fn vanish_at_zero_alone(all: Vec<Polynomial>) -> bool {
    let divisor = all.into_iter().fold(Polynomial::default(), |divisor, p| divisor.gcd(&p));
    divisor.coefficients().iter().filter(|c| !c.is_zero()).count() == 1
}
