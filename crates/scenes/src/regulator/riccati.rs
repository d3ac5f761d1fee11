//! Riccati's equation of the linear-quadratic regulator.
//!
//! For x' = A x + B u and the cost w = x^T Q x + 2 x^T N u + u^T R u, Bellman's function V = x^T P x satisfies
//!
//!   0 = min over u of (dV/dt + w) ,    u = -K x ,    K = R^-1 (B^T P + N^T) ,
//!   -P' = A^T P + P A - (P B + N) R^-1 (P B + N)^T + Q .

use nalgebra::DMatrix;

/// The matrices A, B of linear equations and Q, N, R of the cost at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// A, states by states; states are in SI units.
    pub a: DMatrix<f64>,
    /// B, states by inputs.
    pub b: DMatrix<f64>,
    /// Q, states by states.
    pub state: DMatrix<f64>,
    /// N, states by inputs.
    pub mixed: DMatrix<f64>,
    /// R, inputs by inputs.
    pub input: DMatrix<f64>,
}

/// Largest number of Newton's iterations for the algebraic equation, and of iterations for the matrix sign before.
const NEWTON: usize = 12;
const SIGNS: usize = 100;

/// Relative change between iterates at which the iteration for the matrix sign has converged.
const CONVERGED: f64 = 1e-13;

impl Stage {
    /// The gains K = R^-1 (B^T P + N^T) for P = `value`; `None` if R is singular.
    pub fn gains(&self, value: &DMatrix<f64>) -> Option<DMatrix<f64>> {
        self.input.clone().lu().solve(&(self.b.transpose() * value + self.mixed.transpose()))
    }

    /// The time derivative P' by Riccati's equation; `None` if R is singular.
    pub fn rate(&self, value: &DMatrix<f64>) -> Option<DMatrix<f64>> {
        let gains = self.gains(value)?;
        let moved = self.a.transpose() * value;
        let spent = (value * &self.b + &self.mixed) * gains;
        Some(spent - &moved - moved.transpose() - &self.state)
    }

    /// The Hamiltonian matrix H of the optimal motion: (x; p)' = H (x; p) with p = P x. `None` if R is singular.
    pub fn hamiltonian(&self) -> Option<DMatrix<f64>> {
        let n = self.a.nrows();
        let inverse = self.input.clone().try_inverse()?;
        let a = &self.a - &self.b * &inverse * self.mixed.transpose();
        let state = &self.state - &self.mixed * &inverse * self.mixed.transpose();
        let mut all = DMatrix::zeros(2 * n, 2 * n);
        all.view_mut((0, 0), (n, n)).copy_from(&a);
        all.view_mut((0, n), (n, n)).copy_from(&(-&self.b * &inverse * self.b.transpose()));
        all.view_mut((n, 0), (n, n)).copy_from(&-state);
        all.view_mut((n, n), (n, n)).copy_from(&-a.transpose());
        Some(all)
    }

    /// The solution P of the algebraic Riccati equation for which A - B K is stable; `None` if none is found.
    ///
    /// The stable subspace of H follows from the matrix sign function (Roberts 1980), and Newton's iterations (Kleinman 1968) refine the
    /// solution to rounding errors.
    pub fn lasting(&self) -> Option<DMatrix<f64>> {
        let n = self.a.nrows();
        let mut sign = self.hamiltonian()?;
        for _ in 0..SIGNS {
            let other = sign.clone().try_inverse()?;
            let scale = (other.norm() / sign.norm()).sqrt();
            let next = (&sign * scale + other / scale) * 0.5;
            let change = (&next - &sign).norm();
            sign = next;
            if change <= CONVERGED * sign.norm() {
                break;
            }
        }
        // the stable subspace (1; P) is the kernel of sign + 1
        let unit = DMatrix::<f64>::identity(n, n);
        let (mut left, mut right) = (DMatrix::zeros(2 * n, n), DMatrix::zeros(2 * n, n));
        left.view_mut((0, 0), (n, n)).copy_from(&sign.view((0, n), (n, n)));
        left.view_mut((n, 0), (n, n)).copy_from(&(sign.view((n, n), (n, n)) + &unit));
        right.view_mut((0, 0), (n, n)).copy_from(&-(sign.view((0, 0), (n, n)) + unit));
        right.view_mut((n, 0), (n, n)).copy_from(&-sign.view((n, 0), (n, n)));
        let mut value = left.svd(true, true).solve(&right, f64::EPSILON).ok()?;
        for _ in 0..NEWTON {
            value = (&value + value.transpose()) * 0.5;
            let gains = self.gains(&value)?;
            let closed = &self.a - &self.b * &gains;
            let mixed = &self.mixed * &gains;
            let cost = &self.state - &mixed - mixed.transpose() + gains.transpose() * &self.input * &gains;
            let next = lyapunov(&closed, &cost)?;
            let change = (&next - &value).norm();
            value = next;
            if change <= f64::EPSILON * value.norm() {
                break;
            }
        }
        value.iter().all(|entry| entry.is_finite()).then_some((&value + value.transpose()) * 0.5)
    }

    /// The largest entry of P' by Riccati's equation, relative to the largest entry of A^T P and Q; zero for an exact solution.
    pub fn residual(&self, value: &DMatrix<f64>) -> Option<f64> {
        let size = (self.a.transpose() * value).amax().max(self.state.amax());
        Some(self.rate(value)?.amax() / size)
    }
}

/// The solution X of Lyapunov's equation F^T X + X F + C = 0, with F = `closed` and C = `cost`; `None` if it is not unique.
fn lyapunov(closed: &DMatrix<f64>, cost: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = closed.nrows();
    let unit = DMatrix::<f64>::identity(n, n);
    let transposed = closed.transpose();
    let all = unit.kronecker(&transposed) + transposed.kronecker(&unit);
    let right = DMatrix::from_column_slice(n * n, 1, (-cost).as_slice());
    let found = all.full_piv_lu().solve(&right)?;
    Some(DMatrix::from_column_slice(n, n, found.as_slice()))
}
