//! Systems with constraints, in the coordinates of their mass points.
//!
//! # Overview
//! A system is given in N coordinates x with masses m: T = 1/2 sum m_i x_i'^2. They are the Cartesian coordinates of
//! mass points, and of the points that stand for a rigid body. A plane body of mass m and moment of inertia J about its
//! centre is (x, y, c, s) with the masses (m, m, J, J) and c^2 + s^2 = 1; a body in space is its centre and its axes.
//! Everything is then algebraic: every law has exact values at rational points, and angles occur in charts only.
//!
//! * [`PointSystem`], [`Constrained`]: masses, forces and constraints, from which everything else is derived;
//! * [`Charted`]: coordinates q and quasi-velocities p that satisfy the constraints identically;
//! * [`rates`](mod@rates): constraints differentiated along a motion, their matrix;
//! * [`contacts`]: rough curves that the system touches, from one side or from both;
//! * [`motion`]: velocities and accelerations by a chart.
//!
//! # Principles
//! Each principle turns a system into accelerations; a proof for each system shows that they are equal.
//!
//! | principle | from | module |
//! |---|---|---|
//! | Lagrange I | constraints, multipliers | [`multipliers`] |
//! | Newton | reactions along given directions | [`newton`] |
//! | Gauss | constraints, a minimum | [`gauss`] |
//! | Lagrange II, Maggi | a chart, T(q, q') | [`second_kind`] |
//! | Appell | a chart, S'(p') | [`mod@appell`] |
//! | Shulgin | redundant coordinates, T*; with the term it loses | [`redundant`], [`quasi`] |
//!
//! [`programmed`]: constraint stabilisation (Baumgarte and generalisations): multipliers that lead violated constraints by a
//! prescribed law. [`servo`]: equations that controls keep, across their gradients; [`massless`]: multipliers where
//! coordinates have no mass. [`gear_gupta_leimkuhler`]: a constraint and its rate, each with a multiplier of its own, a
//! DAE of index 2. [`energies`] is for systems that are given by L, D and Q in generalised coordinates instead, such as
//! circuits. [`combining`] splits reactions with friction; [`classify`] classifies constraints.

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

/// An instant of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<S, const N: usize> {
    /// t, s
    pub time: S,
    /// x
    pub place: [S; N],
    /// x'
    pub velocity: [S; N],
}

impl<S: Scalar, const N: usize> State<S, N> {
    /// The same instant with constant numbers, for derivatives by something else.
    pub fn fixed(self) -> State<Tangent<S>, N> {
        State {
            time: Tangent::fixed(self.time),
            place: self.place.map(Tangent::fixed),
            velocity: self.velocity.map(Tangent::fixed),
        }
    }
}

/// The value of a constraint, of one of two kinds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Constraint<S> {
    /// f(x, t) = 0
    Geometric(S),
    /// phi(x, x', t) = 0, linear in x' or not; its virtual displacements are those of Chetaev, (dphi/dx').dx = 0.
    Kinematic(S),
}

impl<S> Constraint<S> {
    /// The value, of either kind.
    pub fn value(self) -> S {
        match self {
            Self::Geometric(value) | Self::Kinematic(value) => value,
        }
    }
}

/// N coordinates with masses and given forces.
pub trait PointSystem<const N: usize> {
    /// The field of the parameters.
    type Given: Base;

    /// m, the mass that belongs to each coordinate; positive.
    fn masses<S: Over<Self::Given>>(&self) -> [S; N];

    /// X, the given forces.
    fn force<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [S; N];
}

/// A system with C constraints that hold as equations.
pub trait Constrained<const N: usize, const C: usize>: PointSystem<N> {
    /// The constraints in a fixed order. A geometric one must not depend on the velocity.
    fn constraints<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [Constraint<S>; C];
}

/// Generalised coordinates q (K of them) and quasi-velocities p (R of them): the constraints for which the chart is made
/// hold for all their values.
pub trait Charted<const N: usize, const K: usize, const R: usize>: PointSystem<N> {
    /// x = a(q, t)
    fn place<S: Over<Self::Given> + Analytic>(&self, time: S, q: [S; K]) -> [S; N];

    /// q' = b(q, p, t)
    fn rates<S: Over<Self::Given> + Analytic>(&self, time: S, q: [S; K], p: [S; R]) -> [S; K];
}

/// T = 1/2 sum m_i x_i'^2, J.
pub fn kinetic_energy<S: Scalar, const N: usize>(masses: [S; N], velocity: [S; N]) -> S {
    masses.into_iter().zip(velocity).fold(S::zero(), |sum, (m, v)| sum + m * v * v).half()
}
