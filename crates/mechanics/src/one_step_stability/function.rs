//! The stability function of a method.

use field::{Rational, Scalar};
use nalgebra::Complex;

/// R(z) = P(z)/Q(z): what a step makes of y' = z y in a unit of time. Coefficients from the constant upwards, P(0) = Q(0) = 1.
#[derive(Clone, Debug, PartialEq)]
pub struct StabilityFunction {
    pub numerator: Vec<Rational>,
    pub denominator: Vec<Rational>,
}

impl StabilityFunction {
    /// ln|R| at z = (re, im), and how fast it changes with the logarithm of the step, Re(z R'/R).
    pub fn growth(&self, [re, im]: [f64; 2]) -> (f64, f64) {
        let z = Complex::new(re, im);
        let zero = Complex::new(0.0, 0.0);
        // a polynomial and its derivative
        let of = |coefficients: &[Rational]| {
            let terms = coefficients.iter().rev().map(|c| c.to_f64());
            terms.fold((zero, zero), |(value, slope), c| (value * z + c, slope * z + value))
        };
        let ((above, above_slope), (below, below_slope)) = (of(&self.numerator), of(&self.denominator));
        ((above / below).norm().ln(), (z * (above_slope / above - below_slope / below)).re)
    }

    /// |P(x u)|^2 - |Q(x u)|^2 for |u| = 1 as sum x^k c_km Re u^m: the coefficients c, trimmed at both ends of k,
    /// and the power of x that was divided by.
    pub(super) fn balance(&self) -> (Vec<Vec<Rational>>, usize) {
        let degree = self.numerator.len().max(self.denominator.len()).saturating_sub(1);
        let of = |c: &[Rational], i: usize| c.get(i).copied().unwrap_or(Rational::int(0));
        let mut terms = vec![vec![Rational::int(0); degree + 1]; 2 * degree + 1];
        for i in 0..=degree {
            for j in 0..=degree {
                terms[i + j][i.abs_diff(j)] += of(&self.numerator, i) * of(&self.numerator, j)
                    - of(&self.denominator, i) * of(&self.denominator, j);
            }
        }
        let vanishes = |term: &Vec<Rational>| term.iter().all(|c| c.sign() == Some(0));
        while terms.last().is_some_and(vanishes) {
            terms.pop();
        }
        let low = terms.iter().take_while(|term| vanishes(term)).count();
        (terms.split_off(low), low)
    }
}
