//! The stability function of a one-step method.

use field::{Rational, Scalar};
use nalgebra::Complex;

/// R(z) = P(z)/Q(z): the amplification factor of a step of length 1 for y' = z y. Coefficients begin with the constant;
/// P(0) = Q(0) = 1.
#[derive(Clone, Debug, PartialEq)]
pub struct StabilityFunction {
    pub numerator: Vec<Rational>,
    pub denominator: Vec<Rational>,
}

impl StabilityFunction {
    /// ln|R| at z = (re, im), and its derivative with respect to the logarithm of the step size, Re(z R'/R).
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

    /// The relative energy change |R(i x)|^2 - 1 of an oscillation in a step over the phase angle x (rad). Cancelling
    /// terms are summed as fractions: small changes keep their digits.
    pub fn energy_change(&self, x: f64) -> f64 {
        let (terms, low) = self.balance();
        // Re i^m
        let on_axis = |term: &Vec<Rational>| {
            term.iter().enumerate().fold(Rational::int(0), |sum, (m, c)| match m % 4 {
                0 => sum + *c,
                2 => sum - *c,
                _ => sum,
            })
        };
        let change =
            terms.iter().rev().fold(0.0, |value, term| value * x + on_axis(term).to_f64()) * x.powi(low as i32);
        let z = Complex::new(0.0, x);
        let below = self.denominator.iter().rev().fold(Complex::new(0.0, 0.0), |value, c| value * z + c.to_f64());
        change / below.norm_sqr()
    }

    /// |P(x u)|^2 - |Q(x u)|^2 for |u| = 1 as sum x^k c_km Re u^m: the coefficients c, without zeros at both ends of k,
    /// and the power of x that was divided out.
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

#[cfg(test)]
mod tests {
    use super::StabilityFunction;
    use field::{Rational, Scalar};

    #[test]
    fn an_oscillation_loses_the_energy_of_the_closed_form_of_runge_and_kutta() {
        let coefficients = [1, 1, 2, 6, 24].map(|n| Rational::new(1, n)).to_vec();
        let function = StabilityFunction { numerator: coefficients, denominator: vec![Rational::int(1)] };
        for x in [1e-3_f64, 0.1, 1.0] {
            let closed = -x.powi(6) / 72.0 + x.powi(8) / 576.0;
            assert!((function.energy_change(x) / closed - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn the_midpoint_rule_keeps_the_energy_of_an_oscillation() {
        let half = Rational::new(1, 2);
        let function = StabilityFunction {
            numerator: vec![Rational::int(1), half],
            denominator: vec![Rational::int(1), Rational::int(0) - half],
        };
        assert_eq!(function.energy_change(0.7), 0.0);
    }
}
