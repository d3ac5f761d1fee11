//! The equations |v| = 1 and of the momentum about the vertical, as polynomials in s = 1/w with polynomials in x as
//! coefficients.

use super::Momentum;
use crate::steady_rotations::Body;
use crate::steady_rotations::spectrum::{Spectrum, along, dot, scaled};
use algebra::real::{Number, Polynomial};

/// The equation |v| = 1: the coefficients of the powers of s, beginning with the constant.
pub(super) fn length(spectrum: &Spectrum) -> Vec<Polynomial> {
    let [h, g] = [&spectrum.numerators[0], &spectrum.numerators[1]];
    let q = &spectrum.seen;
    trimmed(vec![-&(q * q), Polynomial::default(), dot(h, h), scaled(&dot(h, g), &Number::from(2)), dot(g, g)])
}

/// The equation p = w v.M v + h.v, in the same form.
pub(super) fn balance(body: &Body, spectrum: &Spectrum, momentum: &Momentum) -> Vec<Polynomial> {
    let [h, g] = [&spectrum.numerators[0], &spectrum.numerators[1]];
    let x = Polynomial::from_integers([0, 1]);
    let zero = Polynomial::default;
    let balance = [&x * &spectrum.seen, zero(), zero(), along(h, &body.weight), along(g, &body.weight)];
    let mut balance: Vec<_> = balance.iter().map(|p| scaled(p, &momentum.denominator)).collect();
    balance[1] = scaled(&spectrum.seen, &-&momentum.numerator);
    trimmed(balance)
}

/// The equation without vanishing leading coefficients.
pub(super) fn trimmed(mut equation: Vec<Polynomial>) -> Vec<Polynomial> {
    while equation.last().is_some_and(Polynomial::is_zero) {
        equation.pop();
    }
    equation
}
