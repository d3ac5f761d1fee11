//! The Gear-Gupta-Leimkuhler formulation: a DAE of index 2 with multipliers for both f = 0 and f' = 0.
//!
//!   q' = v + M^-1 J^T mu,   v' = M^-1 (F + J^T lambda),   0 = f(q, t),   0 = J v + df/dt
//!
//! On the exact motion mu = 0; in numerical steps it compensates the error in f. The index is 2 instead of the 3 of
//! Lagrange's equations with f = 0. Both multipliers act along M^-1 J^T, which is the least change in the metric of the
//! mass.
//!
//! Source: Gear, Gupta, Leimkuhler: Automatic integration of Euler-Lagrange equations with constraints (1985).

use super::State;
use super::energies::{Energies, Instant};
use super::programmed::Violation;
use crate::definite::NotDefinite;
use field::{Analytic, Over, Scalar};

/// The terms of the equations at an instant, for any multipliers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extended<S, const N: usize, const C: usize> {
    /// The velocities v.
    pub velocity: [S; N],
    /// The accelerations M^-1 F without constraints.
    pub free: [S; N],
    /// M^-1 J^T, as a row of N accelerations for each of the C constraints.
    pub pushes: [[S; N]; C],
    /// The residuals f and f'.
    pub violation: Violation<S, C>,
}

impl<S: Scalar, const N: usize, const C: usize> Extended<S, N, C> {
    /// Evaluates the equations of a system at t, q, v.
    ///
    /// # Errors
    /// [`NotDefinite`] with the index of the first coordinate without mass.
    pub fn of<Q: Energies<N, C>>(system: &Q, at: &State<S, N>) -> Result<Self, NotDefinite>
    where
        S: Over<Q::Given> + Analytic,
    {
        let instant = Instant::of(system, at);
        Ok(Extended {
            velocity: at.velocity,
            free: instant.free()?,
            pushes: instant.pushes()?,
            violation: instant.kinematics.violation(),
        })
    }

    /// The rates q' and v' for the multipliers mu and lambda.
    pub fn rates(&self, mu: [S; C], lambda: [S; C]) -> ([S; N], [S; N]) {
        let pushed = |start: [S; N], by: [S; C]| -> [S; N] {
            std::array::from_fn(|i| (0..C).fold(start[i], |sum, k| sum + by[k] * self.pushes[k][i]))
        };
        (pushed(self.velocity, mu), pushed(self.free, lambda))
    }
}
