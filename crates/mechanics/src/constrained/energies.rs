//! Systems given by energies in generalised coordinates, with geometric constraints.
//!
//! L(t, q, q'), Rayleigh's dissipation function D, forces Q and constraints f(q, t) = 0 give
//! d/dt dL/dq' - dL/dq = Q - dD/dq' + J^T lambda, that is M q'' = F + J^T lambda with M = d^2L/dq'^2 and J = df/dq.
//! An electric charge is a generalised coordinate too: its mass is an inductance, its stiffness the inverse of a
//! capacitance.

use super::State;
use super::multipliers::Reaction;
use super::programmed::Violation;
use crate::definite::{NotDefinite, solve};
use crate::differentiate::{along, fixed, gradient, unit};
use crate::lagrange::rheonomic;
use field::{Analytic, Base, Over, Scalar, Tangent};

/// A system with N generalised coordinates, given by energies, and C constraints.
pub trait Energies<const N: usize, const C: usize> {
    /// The scalar type of the parameters.
    type Given: Base;

    /// The Lagrangian L(t, q, q'), quadratic in q' with a positive definite form.
    fn lagrangian<S: Over<Self::Given> + Analytic>(&self, time: S, q: [S; N], dq: [S; N]) -> S;

    /// Rayleigh's dissipation function D(t, q, q'), which gives the forces -dD/dq'.
    fn dissipation<S: Over<Self::Given> + Analytic>(&self, time: S, q: [S; N], dq: [S; N]) -> S;

    /// The generalised forces Q(t, q, q').
    fn force<S: Over<Self::Given> + Analytic>(&self, time: S, q: [S; N], dq: [S; N]) -> [S; N];

    /// The constraints f(q, t).
    fn constraints<S: Over<Self::Given> + Analytic>(&self, time: S, q: [S; N]) -> [S; C];
}

/// The residuals f and f' at t, q, q'. Needs no derivatives with respect to the coordinates.
pub fn violation<Q: Energies<N, C>, S: Over<Q::Given> + Analytic, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
) -> Violation<S, C> {
    let moved = system.constraints(Tangent::variable(at.time), along(at.place, at.velocity));
    Violation { value: moved.map(|f| f.value), rate: moved.map(|f| f.slope) }
}

/// The terms of the equations of motion M q'' = F + J^T lambda at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instant<S, const N: usize, const C: usize> {
    /// The mass matrix M.
    pub mass: [[S; N]; N],
    /// The forces F: M q'' without constraints.
    pub force: [S; N],
    /// The constraints and their derivatives.
    pub kinematics: Kinematics<S, N, C>,
}

/// The constraints at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kinematics<S, const N: usize, const C: usize> {
    /// The Jacobian J = df/dq.
    pub rows: [[S; N]; C],
    /// The residuals f.
    pub value: [S; C],
    /// The rates f' = J q' + df/dt.
    pub rate: [S; C],
    /// f'' for q'' = 0.
    pub curvature: [S; C],
}

impl<S: Scalar, const N: usize, const C: usize> Kinematics<S, N, C> {
    /// Evaluates the constraints of a system at t, q, q'.
    pub fn of<Q: Energies<N, C>>(system: &Q, at: &State<S, N>) -> Self
    where
        S: Over<Q::Given> + Analytic,
    {
        let State { time, place: q, velocity: dq } = *at;
        let columns: [[S; C]; N] =
            std::array::from_fn(|i| system.constraints(Tangent::fixed(time), along(q, unit(i))).map(|f| f.slope));
        let twice = |x: S, rate: S| Tangent::moving(Tangent::moving(x, rate), Tangent::fixed(rate));
        let moved = system.constraints(twice(time, S::one()), std::array::from_fn(|i| twice(q[i], dq[i])));
        Kinematics {
            rows: std::array::from_fn(|k| std::array::from_fn(|i| columns[i][k])),
            value: moved.map(|f| f.value.value),
            rate: moved.map(|f| f.value.slope),
            curvature: moved.map(|f| f.slope.slope),
        }
    }

    /// The residuals f and f'.
    pub fn violation(&self) -> Violation<S, C> {
        Violation { value: self.value, rate: self.rate }
    }
}

impl<S: Scalar, const N: usize, const C: usize> Instant<S, N, C> {
    /// Evaluates the equations of motion of a system at t, q, q'.
    pub fn of<Q: Energies<N, C>>(system: &Q, at: &State<S, N>) -> Self
    where
        S: Over<Q::Given> + Analytic,
    {
        let State { time, place: q, velocity: dq } = *at;
        let still = rheonomic(|t, q, dq| system.lagrangian(t, q, dq), time, q, dq, [S::zero(); N]);
        let lost = gradient(|dq| system.dissipation(Tangent::fixed(time), fixed(q), dq), dq);
        let given = system.force(time, q, dq);
        Instant {
            mass: mass(system, at),
            force: std::array::from_fn(|i| given[i] - lost[i] - still[i]),
            kinematics: Kinematics::of(system, at),
        }
    }

    /// The accelerations and multipliers for which f'' = `wanted`.
    ///
    /// # Errors
    /// [`NotDefinite`] with the index of the first coordinate without mass, or of the first constraint that depends on
    /// those before it.
    pub fn leading_to(&self, wanted: [S; C]) -> Result<Reaction<S, N, C>, NotDefinite> {
        let free = self.free()?;
        let missing =
            std::array::from_fn(|k| wanted[k] - self.kinematics.curvature[k] - dot(self.kinematics.rows[k], free));
        let (multipliers, change) = self.least(missing)?;
        Ok(Reaction { acceleration: std::array::from_fn(|i| free[i] + change[i]), multipliers })
    }

    /// The smallest change d of q, q' or q'' in the metric of M with J d = `missing`: d = M^-1 J^T mu.
    ///
    /// # Errors
    /// [`NotDefinite`] with the index of the first coordinate without mass, or of the first constraint that depends on
    /// those before it.
    pub fn change(&self, missing: [S; C]) -> Result<[S; N], NotDefinite> {
        self.least(missing).map(|(_, change)| change)
    }

    /// The accelerations M^-1 F without constraints.
    ///
    /// # Errors
    /// [`NotDefinite`] with the index of the first coordinate without mass.
    pub fn free(&self) -> Result<[S; N], NotDefinite> {
        solve(self.mass, self.force)
    }

    /// M^-1 J^T, as one row of N accelerations for each unit multiplier.
    ///
    /// # Errors
    /// [`NotDefinite`] with the index of the first coordinate without mass.
    pub fn pushes(&self) -> Result<[[S; N]; C], NotDefinite> {
        let mut pushes = [[S::zero(); N]; C];
        for (push, row) in pushes.iter_mut().zip(self.kinematics.rows) {
            *push = solve(self.mass, row)?;
        }
        Ok(pushes)
    }

    /// The multipliers mu and the change d = M^-1 J^T mu with J d = `missing`.
    fn least(&self, missing: [S; C]) -> Result<([S; C], [S; N]), NotDefinite> {
        let pushes = self.pushes()?;
        let multipliers = solve(self.kinematics.rows.map(|row| pushes.map(|push| dot(row, push))), missing)?;
        let change = std::array::from_fn(|i| (0..C).fold(S::zero(), |sum, k| sum + multipliers[k] * pushes[k][i]));
        Ok((multipliers, change))
    }
}

/// The mass matrix M = d^2L/dq'^2.
fn mass<Q: Energies<N, C>, S: Over<Q::Given> + Analytic, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
) -> [[S; N]; N] {
    let now = Tangent::fixed(Tangent::fixed(at.time));
    let entry = |i: usize, j: usize| {
        let varied = std::array::from_fn(|k| {
            Tangent::moving(Tangent::moving(at.velocity[k], one(k == j)), Tangent::fixed(one(k == i)))
        });
        system.lagrangian(now, fixed(fixed(at.place)), varied).slope.slope
    };
    let half: [[S; N]; N] =
        std::array::from_fn(|i| std::array::from_fn(|j| if j <= i { entry(i, j) } else { S::zero() }));
    std::array::from_fn(|i| std::array::from_fn(|j| if j <= i { half[i][j] } else { half[j][i] }))
}

fn one<S: Scalar>(yes: bool) -> S {
    if yes { S::one() } else { S::zero() }
}

fn dot<S: Scalar, const N: usize>(a: [S; N], b: [S; N]) -> S {
    (0..N).fold(S::zero(), |sum, i| sum + a[i] * b[i])
}

/// The energy q'.dL/dq' - L, which is conserved under no other forces if L does not depend on time.
pub fn energy<Q: Energies<N, C>, S: Over<Q::Given> + Analytic, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
) -> S {
    let State { time, place, velocity } = *at;
    let momentum = gradient(|dq| system.lagrangian(Tangent::fixed(time), fixed(place), dq), velocity);
    dot(momentum, velocity) - system.lagrangian(time, place, velocity)
}

/// The power q'.(Q - dD/dq'): the rate of the energy if the constraints hold and L does not depend on time.
pub fn power<Q: Energies<N, C>, S: Over<Q::Given> + Analytic, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
) -> S {
    let State { time, place, velocity } = *at;
    let lost = gradient(|dq| system.dissipation(Tangent::fixed(time), fixed(place), dq), velocity);
    let given = system.force(time, place, velocity);
    dot(std::array::from_fn(|i| given[i] - lost[i]), velocity)
}

/// A system with minimal coordinates.
pub trait Reducible<const N: usize, const C: usize, const K: usize>: Energies<N, C> {
    /// The coordinates q = a(s, t), which satisfy the constraints for every s.
    fn place<S: Over<Self::Given> + Analytic>(&self, time: S, s: [S; K]) -> [S; N];
}

/// The system in its minimal coordinates, without constraints.
#[derive(Clone, Copy, Debug)]
pub struct Reduced<'a, Q, const N: usize, const C: usize>(pub &'a Q);

impl<Q, const N: usize, const C: usize> Reduced<'_, Q, N, C> {
    /// The coordinates q and speeds q' at t, s, s'.
    pub fn motion<S: Over<Q::Given> + Analytic, const K: usize>(
        &self,
        time: S,
        s: [S; K],
        ds: [S; K],
    ) -> ([S; N], [S; N])
    where
        Q: Reducible<N, C, K>,
    {
        let moved = self.0.place(Tangent::variable(time), along(s, ds));
        (moved.map(|q| q.value), moved.map(|q| q.slope))
    }
}

impl<Q: Reducible<N, C, K>, const N: usize, const C: usize, const K: usize> Energies<K, 0> for Reduced<'_, Q, N, C> {
    type Given = Q::Given;

    fn lagrangian<S: Over<Self::Given> + Analytic>(&self, time: S, s: [S; K], ds: [S; K]) -> S {
        let (q, dq) = self.motion(time, s, ds);
        self.0.lagrangian(time, q, dq)
    }

    fn dissipation<S: Over<Self::Given> + Analytic>(&self, time: S, s: [S; K], ds: [S; K]) -> S {
        let (q, dq) = self.motion(time, s, ds);
        self.0.dissipation(time, q, dq)
    }

    fn force<S: Over<Self::Given> + Analytic>(&self, time: S, s: [S; K], ds: [S; K]) -> [S; K] {
        let (q, dq) = self.motion(time, s, ds);
        let force = self.0.force(time, q, dq);
        std::array::from_fn(|j| {
            let direction = self.0.place(Tangent::fixed(time), along(s, unit(j))).map(|q| q.slope);
            dot(force, direction)
        })
    }

    fn constraints<S: Over<Self::Given> + Analytic>(&self, _time: S, _s: [S; K]) -> [S; 0] {
        []
    }
}
