//! Optimal control of a linear system under a quadratic criterion: Bellman's equation, and Riccati's equation derived
//! from it.
//!
//! For x' = A x + b u and the criterion, the integral of w(x) + s u^2 with w(x) = sum of w_i x_i^2, Bellman's function is
//!
//!   B(x, u) = dV/dt + grad V . (A x + b u) + w(x) + s u^2 ,   V = sum over i, j of C_ij x_i x_j .
//!
//! It is least at the optimal u, and zero there. Whatever u is, dV/dt along the motion is then B - w - s u^2 with B = s
//! (u - u_opt)^2: the criterion is V at the start less V at the end plus the integral of B. The condition V = 0 (or the
//! price of the end) therefore holds at the end of the time, never at its start.

use crate::differentiate::{fixed, gradient, unit};
use field::{Scalar, Tangent};

/// A linear system with its criterion at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regulator<S, const N: usize> {
    /// A
    pub matrix: [[S; N]; N],
    /// b
    pub control: [S; N],
    /// w_i
    pub weights: [S; N],
    /// s, not zero
    pub price: S,
}

impl<S: Scalar, const N: usize> Regulator<S, N> {
    /// B without dV/dt, at a state and a control.
    pub fn bellman(&self, value: [[S; N]; N], x: [S; N], u: S) -> S {
        let slope = gradient(|y| quadratic(value.map(fixed), y), x);
        (0..N).fold(self.price * u.squared(), |sum, i| {
            let rate = (0..N).fold(self.control[i] * u, |rate, j| rate + self.matrix[i][j] * x[j]);
            sum + slope[i] * rate + self.weights[i] * x[i].squared()
        })
    }

    /// The u at which B is least: the root of its derivative, which is affine in u.
    pub fn optimal(&self, value: [[S; N]; N], x: [S; N]) -> S {
        let lifted = self.fixed();
        // outside u varied, inside its derivative taken
        let slope = |u: Tangent<S>| {
            let twice = lifted.fixed().bellman(value.map(fixed).map(fixed), fixed(fixed(x)), Tangent::variable(u));
            twice.slope
        };
        let at_zero = slope(Tangent::variable(S::zero()));
        -at_zero.value / at_zero.slope
    }

    /// C' by Bellman's equation: minus half the second derivatives of the least B.
    pub fn riccati(&self, value: [[S; N]; N]) -> [[S; N]; N] {
        let (twice, value) = (self.fixed().fixed(), value.map(fixed).map(fixed));
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let x: [Tangent<Tangent<S>>; N] = std::array::from_fn(|k| {
                    let inner = Tangent::moving(S::zero(), unit::<S, N>(i)[k]);
                    Tangent::moving(inner, Tangent::fixed(unit::<S, N>(j)[k]))
                });
                -twice.bellman(value, x, twice.optimal(value, x)).slope.slope.half()
            })
        })
    }

    /// The same regulator with constant numbers, for derivatives by something else.
    pub fn fixed(&self) -> Regulator<Tangent<S>, N> {
        Regulator {
            matrix: self.matrix.map(fixed),
            control: fixed(self.control),
            weights: fixed(self.weights),
            price: Tangent::fixed(self.price),
        }
    }
}

/// V(x) = sum over i, j of C_ij x_i x_j.
pub fn quadratic<S: Scalar, const N: usize>(matrix: [[S; N]; N], x: [S; N]) -> S {
    (0..N).fold(S::zero(), |sum, i| (0..N).fold(sum, |sum, j| sum + matrix[i][j] * x[i] * x[j]))
}
