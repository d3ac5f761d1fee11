//! Systems given by energies in generalised coordinates, with geometric constraints between these.
//!
//! L(t, q, q'), Rayleigh's dissipation function D, forces Q and constraints f(q, t) = 0 give
//! d/dt dL/dq' - dL/dq = Q - dD/dq' + J^T lambda, that is M q'' = F + J^T lambda with M = d^2L/dq'^2 and J = df/dq.
//! A charge is a coordinate as an angle is; its mass is an inductance, its stiffness the inverse of a capacitance.

use super::State;
use super::multipliers::Reaction;
use super::programmed::Violation;
use crate::definite::{NotDefinite, solve};
use crate::differentiate::{along, fixed, gradient, unit};
use crate::lagrange::rheonomic;
use field::{Analytic, Base, Over, Scalar, Tangent};

/// N coordinates with energies, C constraints between them.
pub trait Energies<const N: usize, const C: usize> {
    /// The field of the parameters.
    type Given: Base;

    /// L(t, q, q'), of the second degree in q' with a positive definite form.
    fn lagrangian<S: Over<Self::Given> + Analytic>(&self, time: S, q: [S; N], dq: [S; N]) -> S;

    /// D(t, q, q'): forces -dD/dq'.
    fn dissipation<S: Over<Self::Given> + Analytic>(&self, time: S, q: [S; N], dq: [S; N]) -> S;

    /// Q(t, q, q')
    fn force<S: Over<Self::Given> + Analytic>(&self, time: S, q: [S; N], dq: [S; N]) -> [S; N];

    /// f(q, t)
    fn constraints<S: Over<Self::Given> + Analytic>(&self, time: S, q: [S; N]) -> [S; C];
}

/// f and f' of a system at t, q, q', without derivatives by the coordinates.
pub fn violation<Q: Energies<N, C>, S: Over<Q::Given> + Analytic, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
) -> Violation<S, C> {
    let moved = system.constraints(Tangent::variable(at.time), along(at.place, at.velocity));
    Violation { value: moved.map(|f| f.value), rate: moved.map(|f| f.slope) }
}

/// The terms of the equations of motion at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instant<S, const N: usize, const C: usize> {
    /// M
    pub mass: [[S; N]; N],
    /// F: the value of M q'' without constraints
    pub force: [S; N],
    /// The constraints and their derivatives.
    pub kinematics: Kinematics<S, N, C>,
}

/// The constraints at an instant, without masses and forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kinematics<S, const N: usize, const C: usize> {
    /// J
    pub rows: [[S; N]; C],
    /// f
    pub value: [S; C],
    /// f' = J q' + df/dt
    pub rate: [S; C],
    /// f'' at q'' = 0
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

    /// f and f'.
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

    /// Accelerations and multipliers with which f'' is as wanted.
    ///
    /// # Errors
    /// [`NotDefinite`] names the first coordinate without mass, or the first constraint that depends on those before it.
    pub fn leading_to(&self, wanted: [S; C]) -> Result<Reaction<S, N, C>, NotDefinite> {
        let free = self.free()?;
        let missing =
            std::array::from_fn(|k| wanted[k] - self.kinematics.curvature[k] - dot(self.kinematics.rows[k], free));
        let (multipliers, change) = self.least(missing)?;
        Ok(Reaction { acceleration: std::array::from_fn(|i| free[i] + change[i]), multipliers })
    }

    /// The least change d of q, q' or q'', measured by M, with J d = `missing`: reactions alone cause it.
    ///
    /// # Errors
    /// As for [`Self::leading_to`].
    pub fn change(&self, missing: [S; C]) -> Result<[S; N], NotDefinite> {
        self.least(missing).map(|(_, change)| change)
    }

    /// M^-1 F: q'' without constraints.
    ///
    /// # Errors
    /// [`NotDefinite`] names the first coordinate without mass.
    pub fn free(&self) -> Result<[S; N], NotDefinite> {
        solve(self.mass, self.force)
    }

    /// M^-1 J^T, one row for each constraint: the accelerations by a unit of each multiplier.
    ///
    /// # Errors
    /// As for [`Self::free`].
    pub fn pushes(&self) -> Result<[[S; N]; C], NotDefinite> {
        let mut pushes = [[S::zero(); N]; C];
        for (push, row) in pushes.iter_mut().zip(self.kinematics.rows) {
            *push = solve(self.mass, row)?;
        }
        Ok(pushes)
    }

    /// mu and d = M^-1 J^T mu with J d = missing.
    fn least(&self, missing: [S; C]) -> Result<([S; C], [S; N]), NotDefinite> {
        let pushes = self.pushes()?;
        let multipliers = solve(self.kinematics.rows.map(|row| pushes.map(|push| dot(row, push))), missing)?;
        let change = std::array::from_fn(|i| (0..C).fold(S::zero(), |sum, k| sum + multipliers[k] * pushes[k][i]));
        Ok((multipliers, change))
    }
}

/// M = d^2L/dq'^2
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

/// q'.dL/dq' - L: the energy, where L does not depend on time and its part of first degree does no work.
pub fn energy<Q: Energies<N, C>, S: Over<Q::Given> + Analytic, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
) -> S {
    let State { time, place, velocity } = *at;
    let momentum = gradient(|dq| system.lagrangian(Tangent::fixed(time), fixed(place), dq), velocity);
    dot(momentum, velocity) - system.lagrangian(time, place, velocity)
}

/// q'.(Q - dD/dq'): the rate of the energy where the constraints hold and L does not depend on time.
pub fn power<Q: Energies<N, C>, S: Over<Q::Given> + Analytic, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
) -> S {
    let State { time, place, velocity } = *at;
    let lost = gradient(|dq| system.dissipation(Tangent::fixed(time), fixed(place), dq), velocity);
    let given = system.force(time, place, velocity);
    dot(std::array::from_fn(|i| given[i] - lost[i]), velocity)
}

/// Fewer coordinates that keep the constraints.
pub trait Reducible<const N: usize, const C: usize, const K: usize>: Energies<N, C> {
    /// q = a(s, t), which satisfies the constraints for every s.
    fn place<S: Over<Self::Given> + Analytic>(&self, time: S, s: [S; K]) -> [S; N];
}

/// The system in those coordinates: no constraint is left.
#[derive(Clone, Copy, Debug)]
pub struct Reduced<'a, Q, const N: usize, const C: usize>(pub &'a Q);

impl<Q, const N: usize, const C: usize> Reduced<'_, Q, N, C> {
    /// q and q' at t, s, s'.
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
