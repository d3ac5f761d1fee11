//! Systems with constraints, in Cartesian coordinates of mass points.
//!
//! # Overview
//! A system is given in N coordinates x with masses m: T = 1/2 sum m_i x_i'^2. They are the Cartesian coordinates of
//! mass points, and of points that represent rigid bodies. A plane body of mass m and moment of inertia J about its
//! centre has the coordinates (x, y, c, s) with the masses (m, m, J, J) and c^2 + s^2 = 1; a body in space has its
//! centre and its axes. All equations are then algebraic: they have exact values at rational points, and angles occur
//! in charts only.
//!
//! * [`PointSystem`], [`Constrained`]: masses, forces and constraints, from which everything else is derived;
//! * [`Charted`]: coordinates q and quasi-velocities p that satisfy the constraints identically;
//! * [`rates`](mod@rates): constraints differentiated along a motion, and their Jacobian;
//! * [`contacts`]: frictional contacts, unilateral or bilateral;
//! * [`motion`]: velocities and accelerations from a chart.
//!
//! # Principles
//! Each principle determines the accelerations of a system; proofs for each system show that the results are equal.
//!
//! | principle | from | module |
//! |---|---|---|
//! | Lagrange, first kind | constraints, multipliers | [`multipliers`] |
//! | Newton | reactions along given directions | [`newton`] |
//! | Gauss | constraints, a minimum | [`gauss`] |
//! | Lagrange, second kind; Maggi | a chart, T(q, q') | [`second_kind`] |
//! | Appell | a chart, S'(p') | [`mod@appell`] |
//! | Shulgin | redundant coordinates, T*, with a correction term | [`redundant`], [`quasi`] |
//!
//! [`programmed`]: constraint stabilisation (Baumgarte and generalisations). [`servo`]: equations enforced by controls,
//! which are not reactions along the gradients. [`massless`]: multipliers for coordinates without mass.
//! [`gear_gupta_leimkuhler`]: a DAE of index 2 with multipliers for a constraint and its rate. [`energies`]: systems
//! given by L, D and Q in generalised coordinates, such as circuits. [`combining`]: decomposition of reactions with
//! friction. [`classify`]: classification of constraints.

pub mod appell;
pub mod classify;
pub mod combining;
pub mod contacts;
mod distribution;
pub mod energies;
pub mod gauss;
pub mod gear_gupta_leimkuhler;
pub mod massless;
pub mod motion;
pub mod multipliers;
pub mod newton;
pub mod programmed;
pub mod quasi;
pub mod rates;
pub mod redundant;
pub mod second_kind;
pub mod servo;

use field::{Analytic, Base, Over, Scalar, Tangent};

/// The time, coordinates and velocities of a system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<S, const N: usize> {
    /// The time t, s.
    pub time: S,
    /// The coordinates x.
    pub place: [S; N],
    /// The velocities x'.
    pub velocity: [S; N],
}

impl<S: Scalar, const N: usize> State<S, N> {
    /// The state with constant dual numbers, for derivatives with respect to other variables.
    pub fn fixed(self) -> State<Tangent<S>, N> {
        State {
            time: Tangent::fixed(self.time),
            place: self.place.map(Tangent::fixed),
            velocity: self.velocity.map(Tangent::fixed),
        }
    }
}

/// The residual of a constraint, by its kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Constraint<S> {
    /// Geometric: f(x, t) = 0.
    Geometric(S),
    /// Kinematic: phi(x, x', t) = 0, linear in x' or not. Virtual displacements are those of Chetaev: (dphi/dx').dx =
    /// 0.
    Kinematic(S),
}

impl<S> Constraint<S> {
    /// The residual.
    pub fn value(self) -> S {
        match self {
            Self::Geometric(value) | Self::Kinematic(value) => value,
        }
    }
}

/// A system with N coordinates, their masses, and applied forces.
pub trait PointSystem<const N: usize> {
    /// The scalar type of the parameters.
    type Given: Base;

    /// The positive mass m of each coordinate.
    fn masses<S: Over<Self::Given>>(&self) -> [S; N];

    /// The applied forces X.
    fn force<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [S; N];
}

/// A system with C constraints.
pub trait Constrained<const N: usize, const C: usize>: PointSystem<N> {
    /// The constraints in a fixed order. A geometric constraint must not depend on the velocity.
    fn constraints<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [Constraint<S>; C];
}

/// A system with K generalised coordinates q and R quasi-velocities p that satisfy its constraints identically.
pub trait Charted<const N: usize, const K: usize, const R: usize>: PointSystem<N> {
    /// The coordinates x = a(q, t).
    fn place<S: Over<Self::Given> + Analytic>(&self, time: S, q: [S; K]) -> [S; N];

    /// The rates q' = b(q, p, t).
    fn rates<S: Over<Self::Given> + Analytic>(&self, time: S, q: [S; K], p: [S; R]) -> [S; K];
}

/// The kinetic energy T = 1/2 sum m_i x_i'^2, J.
pub fn kinetic_energy<S: Scalar, const N: usize>(masses: [S; N], velocity: [S; N]) -> S {
    masses.into_iter().zip(velocity).fold(S::zero(), |sum, (m, v)| sum + m * v * v).half()
}
