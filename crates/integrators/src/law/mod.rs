//! Interfaces of laws y' = f(t, y) for integrators, with the further data that a law may provide.
//!
//! # Overview
//! * [`Ode`]: a law over one scalar type; [`System`]: over the three scalar types of a run;
//! * its Jacobian: by its own code ([`JacobianFn`]) or by forward differentiation ([`Jacobian`]);
//! * its Taylor coefficients ([`TaylorSeries`]);
//! * the flows of its pieces ([`Pieces`]), composed by a [`Splitting`];
//! * a law with constraints and multipliers ([`Index2Dae`]);
//! * the projection onto its invariants ([`Projection`]);
//! * the time intervals in which the law changes rapidly ([`StepBounds`]).

#[cfg(test)]
pub(crate) mod bell;
mod composition;
mod index2_dae;
pub(crate) mod jacobian;
mod pieces;
mod projection;
mod real;
mod series;
mod step_bounds;

pub use composition::Splitting;
pub use index2_dae::{Index2Dae, Index2DaeSystem};
pub use jacobian::{Jacobian, slope, variable};
pub use pieces::{Composed, Pieces};
pub use projection::Projection;
pub use real::Real;
pub use series::TaylorSeries;
pub use step_bounds::{FastInterval, StepBounds};

use field::{Batch, DoubleDouble, Scalar, Tangent};
use num_dual::DualSVec64;

/// The number of columns of a Jacobian that one evaluation gives.
pub const DIRECTIONS: usize = 8;

/// The scalar type for Jacobians: a value and its derivatives in eight directions.
pub type Dual8 = DualSVec64<DIRECTIONS>;

/// The scalar type for state-transition matrices: a value, and in each lane its derivative in one of eight directions.
pub type Variations = Tangent<Batch<DIRECTIONS>>;

/// A law y' = f(t, y) over one scalar type. The dimension is known at run time only.
pub trait Ode<S: Scalar> {
    /// The number n of components of y.
    fn dimension(&self) -> usize;

    /// Writes dy = f(t, y); both slices have n entries. Implementations must not allocate.
    fn rates(&self, t: S, y: &[S], dy: &mut [S]);
}

/// A law over the three scalar types: `f64` for the run, [`Dual8`] for its Jacobian, [`DoubleDouble`] for its
/// reference.
///
/// A type that is generic over `S: Over<f64> + Analytic` needs one more line, `impl System for Mine {}`. All other
/// methods are optional data of the law.
pub trait System: Ode<f64> + Ode<Dual8> + Ode<DoubleDouble> {
    /// Taylor series of the solutions in `f64`, if available.
    fn taylor(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        None
    }

    /// Taylor series of the solutions with their derivatives in eight directions, if available.
    fn taylor_variations(&self) -> Option<Box<dyn TaylorSeries<Variations> + '_>> {
        None
    }

    /// The Jacobian by code of its own, if available; otherwise the law is evaluated over [`Dual8`].
    fn jacobian_fn(&self) -> Option<Box<dyn JacobianFn + '_>> {
        None
    }

    /// The divisors, radicands and angles of the rates, if known.
    fn divisors(&self) -> Option<&dyn Divisors> {
        None
    }

    /// The time intervals in which the law changes rapidly, from its functions of the time alone.
    fn step_bounds(&self, _from: f64, _to: f64) -> StepBounds {
        StepBounds::default()
    }

    /// The size in bytes of the machine code of the rates in `f64`, including constants, if such code is generated at
    /// run time. For a law that solves linear equations it excludes the solve.
    fn code_size(&self) -> Option<usize> {
        None
    }

    /// The projection onto invariants, if each accepted step is to satisfy them.
    fn projection(&self) -> Option<&dyn Projection<f64>> {
        None
    }

    /// Taylor series of the solutions in double-double, if available.
    fn taylor_exact(&self) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        None
    }

    /// The composition of the flows of the pieces in `f64`, if the law has pieces.
    fn composed(&self, _splitting: Splitting) -> Option<Box<dyn Composed<f64> + '_>> {
        None
    }

    /// The composition of the flows of the pieces in double-double, if the law has pieces.
    fn composed_exact(&self, _splitting: Splitting) -> Option<Box<dyn Composed<DoubleDouble> + '_>> {
        None
    }
}

/// Functions of time and state at whose zeros a law may be undefined or discontinuous: divisors (of expressions, pivots
/// of an elimination, determinants); radicands of square roots, such as distances; and angles atan2(y, x), which jump
/// from pi to -pi.
pub trait Divisors {
    /// The numbers of divisors, radicands and angles, in this order.
    fn counts(&self) -> [usize; 3];

    /// Writes all values at (t, y); `out` has as many entries as the sum of the counts. Must not allocate.
    fn at(&self, t: f64, y: &[f64], out: &mut [f64]);
}

/// The derivatives of a law, by code of its own. Implementations must not allocate.
pub trait JacobianFn {
    /// Writes df/dy at (t, y): `matrix[i * n + j]` = df_i / dy_j.
    fn matrix(&mut self, t: f64, y: &[f64], matrix: &mut [f64]);

    /// Writes df/dt at (t, y): `slopes[i]` = df_i / dt. The default is zero, for an autonomous law.
    fn by_time(&mut self, _t: f64, _y: &[f64], slopes: &mut [f64]) {
        slopes.fill(0.0);
    }

    /// The size in bytes of the machine code of the matrix, including constants, if such code is generated at run time.
    fn code_size(&self) -> Option<usize> {
        None
    }
}

/// A scalar type in which a [`System`] can be integrated.
pub trait Working: Real {
    /// The law of a system over this type.
    fn law(system: &dyn System) -> &dyn Ode<Self>;

    /// The law of an index-2 DAE over this type.
    fn held(system: &dyn Index2DaeSystem) -> &dyn Index2Dae<Self>;

    /// Taylor series of the solutions over this type, if available.
    fn series(system: &dyn System) -> Option<Box<dyn TaylorSeries<Self> + '_>>;

    /// The projection onto invariants over this type, if there is one; none in double-double, since references are not
    /// projected.
    fn projection(system: &dyn System) -> Option<&dyn Projection<Self>>;

    /// The composition of the flows of the pieces over this type.
    fn composed(system: &dyn System, splitting: Splitting) -> Option<Box<dyn Composed<Self> + '_>>;
}

impl Working for f64 {
    fn law(system: &dyn System) -> &dyn Ode<f64> {
        system
    }

    fn held(system: &dyn Index2DaeSystem) -> &dyn Index2Dae<f64> {
        system
    }

    fn series(system: &dyn System) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        system.taylor()
    }

    fn projection(system: &dyn System) -> Option<&dyn Projection<f64>> {
        system.projection()
    }

    fn composed(system: &dyn System, splitting: Splitting) -> Option<Box<dyn Composed<f64> + '_>> {
        system.composed(splitting)
    }
}

impl Working for DoubleDouble {
    fn law(system: &dyn System) -> &dyn Ode<DoubleDouble> {
        system
    }

    fn held(system: &dyn Index2DaeSystem) -> &dyn Index2Dae<DoubleDouble> {
        system
    }

    fn series(system: &dyn System) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        system.taylor_exact()
    }

    fn projection(_system: &dyn System) -> Option<&dyn Projection<DoubleDouble>> {
        None
    }

    fn composed(system: &dyn System, splitting: Splitting) -> Option<Box<dyn Composed<DoubleDouble> + '_>> {
        system.composed_exact(splitting)
    }
}
