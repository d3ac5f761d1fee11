//! Velocities and accelerations of the coordinates x from those of a chart.
//!
//! With x = a(q, t) and q' = b(q, p, t) the constraints of the chart hold, and x'' = drift + sum over j of p'_j X_j
//! with the fields X_j = dx'/dp_j. The X_j span the virtual displacements, after Chetaev if the constraints are
//! nonlinear in the velocities.

use super::{Charted, State};
use crate::differentiate::{along, fixed, unit};
use field::{Analytic, Over, Scalar, Tangent};

/// The kinematics of a system with a chart at (t, q, p).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<S, const N: usize, const R: usize> {
    /// The time t, the coordinates x and the velocities x'.
    pub state: State<S, N>,
    /// The acceleration x'' for p' = 0.
    pub drift: [S; N],
    /// The fields X_j = dx'/dp_j = dx''/dp'_j.
    pub fields: [[S; N]; R],
}

impl<S: Scalar, const N: usize, const R: usize> Motion<S, N, R> {
    /// Evaluates the kinematics at (t, q, p), by three evaluations along the motion and one for each p.
    pub fn at<Q, const K: usize>(system: &Q, time: S, q: [S; K], p: [S; R]) -> Self
    where
        Q: Charted<N, K, R>,
        S: Over<Q::Given> + Analytic,
    {
        let moving = along(q, system.rates(time, q, p));
        Motion {
            state: State { time, place: system.place(time, q), velocity: velocity(system, time, q, p) },
            drift: velocity(system, Tangent::variable(time), moving, fixed(p)).map(|v| v.slope),
            fields: std::array::from_fn(|j| {
                velocity(system, Tangent::fixed(time), fixed(q), along(p, unit(j))).map(|v| v.slope)
            }),
        }
    }

    /// The acceleration x'' for the rates p'.
    pub fn acceleration(&self, rates: [S; R]) -> [S; N] {
        std::array::from_fn(|i| (0..R).fold(self.drift[i], |sum, j| sum + rates[j] * self.fields[j][i]))
    }

    /// The generalised forces of a force: its products with the fields X_j.
    pub fn generalised(&self, force: [S; N]) -> [S; R] {
        self.fields.map(|field| (0..N).fold(S::zero(), |sum, i| sum + force[i] * field[i]))
    }

    /// The kinematics with constant dual numbers, for derivatives with respect to other variables.
    pub fn fixed(self) -> Motion<Tangent<S>, N, R> {
        Motion { state: self.state.fixed(), drift: fixed(self.drift), fields: self.fields.map(fixed) }
    }
}

/// The velocities x' at (t, q, p), over any scalar type.
pub fn velocity<Q, S, const N: usize, const K: usize, const R: usize>(
    system: &Q,
    time: S,
    q: [S; K],
    p: [S; R],
) -> [S; N]
where
    Q: Charted<N, K, R>,
    S: Over<Q::Given> + Analytic,
{
    system.place(Tangent::variable(time), along(q, system.rates(time, q, p))).map(|x| x.slope)
}
