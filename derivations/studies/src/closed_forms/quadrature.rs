//! Equations u'^2 = f(u) with a polynomial f of degree four, solved by elliptic functions.
//!
//! With f = a u^4 + 4 b u^3 + 6 c u^2 + 4 d u + e, u(0) = u0, u'(0) = s and Weierstrass' function P of the invariants
//!
//!   g2 = a e - 4 b d + 3 c^2 ,    g3 = a c e + 2 b c d - c^3 - a d^2 - b^2 e
//!
//! the solution is (Whittaker and Watson, A Course of Modern Analysis, 20.6)
//!
//!   u = u0 + (-s P' + 1/2 f'(u0) (P - f''(u0)/24) + f(u0) f'''(u0)/24) / (2 (P - f''(u0)/24)^2 - f(u0) f''''/48) .
//!
//! No root of f is computed, and multiple roots need no separate case.

use super::weierstrass::{Lattice, Weierstrass};
use integrators::Real;

/// A solution of u'^2 = f(u).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadrature<S> {
    start: S,
    speed: S,
    /// Taylor coefficients of f at the start: f, f', f''/2, f'''/6, f''''/24.
    expansion: [S; 5],
    lattice: Lattice<S>,
}

impl<S: Real> Quadrature<S> {
    /// The solution from the coefficients of f, the lowest first, and (u, u') at time zero with u'^2 = f(u).
    pub fn new(f: [S; 5], start: S, speed: S) -> Self {
        let derivative = |k: i64| {
            (k..5).rev().fold(S::zero(), |sum, i| {
                // i! / (i - k)! / k!
                let choices = (0..k).fold(S::one(), |product, j| product * S::ratio(i - j, j + 1));
                sum * start + f[i as usize] * choices
            })
        };
        let [e, d, c, b, a] = [f[0], f[1] * S::ratio(1, 4), f[2] * S::ratio(1, 6), f[3] * S::ratio(1, 4), f[4]];
        let g2 = a * e - S::int(4) * b * d + S::int(3) * c * c;
        let g3 = a * c * e + S::int(2) * b * c * d - c * c * c - a * d * d - b * b * e;
        let expansion = [0, 1, 2, 3, 4].map(derivative);
        Quadrature { start, speed, expansion, lattice: Lattice::new(g2, g3) }
    }

    /// The value u at a time, s.
    pub fn at(&self, time: S) -> S {
        let [f, f1, f2, f3, f4] = self.expansion;
        let Some(Weierstrass { value, slope }) = self.lattice.at(time) else { return self.start };
        let p = value - f2 * S::ratio(1, 12);
        let numerator = f1.half() * p - self.speed * slope + f * f3 * S::ratio(1, 4);
        self.start + numerator / (S::int(2) * p * p - (f * f4).half())
    }

    /// The period of u, s; infinite for a motion that tends to an equilibrium.
    pub fn period(&self) -> S {
        self.lattice.period
    }
}
