//! The governor near its programme, omega2 = omega2_0 + zeta, rho = rho_0 + rho': the equations of motion, and their
//! linearisation in (zeta, rho', z = rho'') by differentiation of Appell's equations.

use super::Governor;
use field::{Analytic, Base, Over, Scalar, Tangent};
use mechanics::constrained::PointSystem;
use mechanics::constrained::appell::rates;
use mechanics::constrained::motion::Motion;
use mechanics::definite::NotDefinite;
use mechanics::differentiate::{along, unit};

impl<P: Base> Governor<P> {
    /// The rates (omega2', rho', rho'') at (omega2, rho, rho'), with a force along the axle, N, in addition to that of
    /// the data.
    ///
    /// # Errors
    /// [`NotDefinite`] if an inertia or mass that determines the accelerations is zero.
    pub fn released<S: Over<P> + Analytic>(
        &self,
        time: S,
        [speed, rho, drift]: [S; 3],
        control: S,
    ) -> Result<[S; 3], NotDefinite> {
        let zero = S::zero();
        let motion: Motion<S, 7, 2> = Motion::at(self, time, [zero, zero, zero, rho], [speed, drift]);
        let mut force = self.force(&motion.state);
        force[6] += control;
        let [spin, push] = rates(self, &motion, force)?;
        Ok([spin, drift, push])
    }

    /// The linearisation x' = A x + b u1 about a state.
    ///
    /// # Errors
    /// [`NotDefinite`] if an inertia or mass that determines the accelerations is zero.
    pub fn linearised<S: Over<P> + Analytic>(
        &self,
        time: S,
        state: [S; 3],
    ) -> Result<LinearisedEquations<S>, NotDefinite>
    where
        Tangent<S>: Over<P>,
    {
        let still = Tangent::fixed(S::zero());
        let mut matrix = [[S::zero(); 3]; 3];
        for j in 0..3 {
            let column = self.released(Tangent::fixed(time), along(state, unit(j)), still)?;
            for (row, rate) in matrix.iter_mut().zip(column) {
                row[j] = rate.slope;
            }
        }
        let control = Tangent::variable(S::zero());
        let by_control = self.released(Tangent::fixed(time), state.map(Tangent::fixed), control)?;
        Ok(LinearisedEquations { matrix, control: by_control.map(|rate| rate.slope) })
    }
}

/// The linearised equations x' = A x + b u.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearisedEquations<S> {
    /// The matrix A.
    pub matrix: [[S; 3]; 3],
    /// The vector b.
    pub control: [S; 3],
}

impl<S: Scalar> LinearisedEquations<S> {
    /// The product A x.
    pub fn apply(&self, x: [S; 3]) -> [S; 3] {
        self.matrix.map(|row| (0..3).fold(S::zero(), |sum, j| sum + row[j] * x[j]))
    }
}
