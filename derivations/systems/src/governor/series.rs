//! The programme as a power series in a small parameter: rho rho' = eps (k1 + k2 rho), rho = sum eps^i rho_i(t).
//!
//! Each order is a quadrature, rho_0 rho_n' = [n = 1] k1 + k2 rho_(n-1) - sum over 0 < i < n of rho_i rho'_(n-i). If
//! the torques are polynomials in time, so are the rho_i, and the quadratures are exact for every scalar type.

use super::{Gearing, Governor};
use field::{Base, Scalar};

/// The data eps, k1(t), k2(t) of rho' = eps (k1/rho + k2); the polynomials are given by coefficients of ascending
/// powers of time.
#[derive(Clone, Debug, PartialEq)]
pub struct Programme<P> {
    pub epsilon: P,
    pub of_second: Vec<P>,
    pub of_first: Vec<P>,
}

impl<P: Base> Governor<P> {
    /// The law of the programme for a prescribed speed of the second shaft; `None` for two discs, where the first lever
    /// arm varies and the law has another form.
    pub fn small_parameter(&self, speed: P) -> Option<Programme<P>> {
        let Gearing::Drum { radius } = self.gearing else { return None };
        let [first, _, wheel] = self.inertia;
        let square = self.radius.squared();
        let [by_first, by_second] = self.moments.map(|moment| vec![moment.start, moment.growth]);
        Some(Programme {
            epsilon: P::one() / (speed * (wheel + first * square / radius.squared())),
            of_second: by_second.into_iter().map(|moment| square * moment).collect(),
            of_first: by_first.into_iter().map(|moment| square * moment / radius).collect(),
        })
    }
}

impl<P: Scalar> Programme<P> {
    /// The coefficients rho_0, ..., rho_order as polynomials in time.
    pub fn series(&self, start: P, order: usize) -> Vec<Vec<P>> {
        let mut terms = vec![vec![start]];
        for n in 1..=order {
            let mut rate = product(&self.of_first, &terms[n - 1]);
            if n == 1 {
                add(&mut rate, &self.of_second, P::one());
            }
            for i in 1..n {
                add(&mut rate, &product(&terms[i], &derivative(&terms[n - i])), -P::one());
            }
            terms.push(integral(&rate, start));
        }
        terms
    }

    /// The partial sums of the series at an instant, up to each order.
    pub fn approximations(&self, start: P, order: usize, time: P) -> Vec<P> {
        let mut power = P::one();
        let mut sum = P::zero();
        self.series(start, order)
            .iter()
            .map(|term| {
                sum += power * value(term, time);
                power *= self.epsilon;
                sum
            })
            .collect()
    }
}

fn value<P: Scalar>(polynomial: &[P], at: P) -> P {
    polynomial.iter().rev().fold(P::zero(), |sum, &coefficient| sum * at + coefficient)
}

fn product<P: Scalar>(a: &[P], b: &[P]) -> Vec<P> {
    let mut product = vec![P::zero(); (a.len() + b.len()).saturating_sub(1)];
    for (i, &x) in a.iter().enumerate() {
        for (j, &y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    product
}

fn add<P: Scalar>(sum: &mut Vec<P>, term: &[P], factor: P) {
    sum.resize(sum.len().max(term.len()), P::zero());
    for (total, &each) in sum.iter_mut().zip(term) {
        *total += factor * each;
    }
}

fn derivative<P: Scalar>(polynomial: &[P]) -> Vec<P> {
    polynomial.iter().enumerate().skip(1).map(|(power, &coefficient)| P::int(power as i64) * coefficient).collect()
}

/// The integral of the polynomial from 0, divided by `divisor`.
fn integral<P: Scalar>(polynomial: &[P], divisor: P) -> Vec<P> {
    let terms = polynomial.iter().enumerate();
    let raised = terms.map(|(power, &coefficient)| coefficient / (divisor * P::int(power as i64 + 1)));
    std::iter::once(P::zero()).chain(raised).collect()
}
