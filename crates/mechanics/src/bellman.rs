//! Optimal control of a linear system with a quadratic criterion: Bellman's equation, and Riccati's equation from it.
//!
//! For x' = A x + b u and the criterion integral of w(x) + s u^2 dt, with w(x) = sum of w_i x_i^2, Bellman's function
//! is
//!
//!   B(x, u) = dV/dt + grad V . (A x + b u) + w(x) + s u^2 ,   V = sum over i, j of C_ij x_i x_j .
//!
//! Its minimum over u is at the optimal control, and is zero there. For any u, dV/dt along the motion is B - w - s u^2
//! with B = s (u - u_opt)^2. The criterion is therefore V at the start minus V at the end plus the integral of B. The
//! condition V = 0 (or the terminal cost) holds at the end time, not at the start.

use crate::differentiate::{fixed, gradient, unit};
use field::{Scalar, Tangent};

/// A linear system with its quadratic criterion, at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regulator<S, const N: usize> {
    /// The matrix A.
    pub matrix: [[S; N]; N],
    /// The vector b.
    pub control: [S; N],
    /// The weights w_i.
    pub weights: [S; N],
    /// The weight s of the control, not zero.
    pub price: S,
}

impl<S: Scalar, const N: usize> Regulator<S, N> {
    /// B without dV/dt, at a state and a control; `value` is the matrix C of V.
    pub fn bellman(&self, value: [[S; N]; N], x: [S; N], u: S) -> S {
        let slope = gradient(|y| quadratic(value.map(fixed), y), x);
        (0..N).fold(self.price * u.squared(), |sum, i| {
            let rate = (0..N).fold(self.control[i] * u, |rate, j| rate + self.matrix[i][j] * x[j]);
            sum + slope[i] * rate + self.weights[i] * x[i].squared()
        })
    }

    /// The control u that minimises B: the root of its derivative, which is affine in u.
    pub fn optimal(&self, value: [[S; N]; N], x: [S; N]) -> S {
        let lifted = self.fixed();
        // the outer derivative is with respect to u, the inner one with respect to x
        let slope = |u: Tangent<S>| {
            let twice = lifted.fixed().bellman(value.map(fixed).map(fixed), fixed(fixed(x)), Tangent::variable(u));
            twice.slope
        };
        let at_zero = slope(Tangent::variable(S::zero()));
        -at_zero.value / at_zero.slope
    }

    /// The rate C' by Bellman's equation: minus half the second derivatives of the minimum of B.
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

    /// The regulator with constant dual numbers, for derivatives with respect to other variables.
    pub fn fixed(&self) -> Regulator<Tangent<S>, N> {
        Regulator {
            matrix: self.matrix.map(fixed),
            control: fixed(self.control),
            weights: fixed(self.weights),
            price: Tangent::fixed(self.price),
        }
    }
}

/// The quadratic form V(x) = sum over i, j of C_ij x_i x_j.
pub fn quadratic<S: Scalar, const N: usize>(matrix: [[S; N]; N], x: [S; N]) -> S {
    (0..N).fold(S::zero(), |sum, i| (0..N).fold(sum, |sum, j| sum + matrix[i][j] * x[i] * x[j]))
}
