//! The Gear-Gupta-Leimkuhler formulation, a DAE of index 2: f = 0 and f' = 0, each with a multiplier of its own.
//!
//!   q' = v + M^-1 J^T mu,   v' = M^-1 (F + J^T lambda),   0 = f(q, t),   0 = J v + df/dt
//!
//! On the exact motion mu = 0; in steps it compensates the error of the method in f. The equations have index 2: one
//! differentiation fewer than Lagrange's with f = 0 alone. Both multipliers push along the reactions, which is the least
//! change by the metric of the mass.
//!
//! Source: Gear, Gupta, Leimkuhler: Automatic integration of Euler-Lagrange equations with constraints (1985).

use super::State;
use super::energies::{Energies, Instant};
use super::programmed::Violation;
use crate::definite::NotDefinite;
use field::{Analytic, Over, Scalar};

/// The equations at an instant, before multipliers are chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extended<S, const N: usize, const C: usize> {
    /// v
    pub velocity: [S; N],
    /// M^-1 F
    pub free: [S; N],
    /// (M^-1 J^T)^T: a row of N numbers for each of C constraints
    pub pushes: [[S; N]; C],
    /// f and f'
    pub violation: Violation<S, C>,
}

impl<S: Scalar, const N: usize, const C: usize> Extended<S, N, C> {
    /// Evaluates the extended equations of a system at t, q, v.
    ///
    /// # Errors
    /// [`NotDefinite`] names the first coordinate without mass.
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

    /// q' and v' with the multipliers mu of the places and lambda of the velocities.
    pub fn rates(&self, mu: [S; C], lambda: [S; C]) -> ([S; N], [S; N]) {
        let pushed = |start: [S; N], by: [S; C]| -> [S; N] {
            std::array::from_fn(|i| (0..C).fold(start[i], |sum, k| sum + by[k] * self.pushes[k][i]))
        };
        (pushed(self.velocity, mu), pushed(self.free, lambda))
    }
}
