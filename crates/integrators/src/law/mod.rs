//! Laws as methods need them: y' = f(t, y), and further data that a law may offer.
//!
//! # Overview
//! * [`Ode`] over one field, [`System`] over the three of a computation;
//! * its Jacobian: code of its own ([`JacobianFn`]) or forward differentiation ([`Jacobian`]);
//! * its Taylor coefficients ([`TaylorSeries`]);
//! * the flows of its pieces ([`Pieces`]), in the order of a [`Splitting`];
//! * a law that multipliers hold to constraints ([`Index2Dae`]);
//! * the projection onto equations that its motions keep ([`Projection`]);
//! * the times about which it changes fast by itself ([`StepBounds`]).

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

/// The field in which a Jacobian is computed: a value and its derivatives in eight directions.
pub type Dual8 = DualSVec64<DIRECTIONS>;

/// The field of a state-transition matrix: a value in every lane, and in each lane the derivative in one of eight directions.
pub type Variations = Tangent<Batch<DIRECTIONS>>;

/// y' = f(t, y) over one field, with a dimension known at run time (a machine has as many bars as its file says).
pub trait Ode<S: Scalar> {
    /// The number of components of y.
    fn dimension(&self) -> usize;

    /// dy = f(t, y). Both slices have the system's dimension. Must not allocate: it is called millions of times.
    fn rates(&self, t: S, y: &[S], dy: &mut [S]);
}

/// One law over the three fields of a computation: the run, its Jacobian, its reference.
///
/// A system generic over `S: Over<f64> + Analytic` needs one more line, `impl System for Mine {}`. A system whose
/// expression graph is at hand may offer its Taylor coefficients too.
pub trait System: Ode<f64> + Ode<Dual8> + Ode<DoubleDouble> {
    /// A source of Taylor coefficients in `f64`, where there is one.
    fn taylor(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        None
    }

    /// A source of Taylor coefficients with their derivatives in eight directions, where there is one.
    fn taylor_variations(&self) -> Option<Box<dyn TaylorSeries<Variations> + '_>> {
        None
    }

    /// The law's Jacobian as code of its own, where there is one; otherwise the law is run over [`Dual8`].
    fn jacobian_fn(&self) -> Option<Box<dyn JacobianFn + '_>> {
        None
    }

    /// The divisors, radicands and angles of its rates, where they are known.
    fn divisors(&self) -> Option<&dyn Divisors> {
        None
    }

    /// The intervals of time in which the law changes fast by itself, from its functions of the time alone.
    fn step_bounds(&self, _from: f64, _to: f64) -> StepBounds {
        StepBounds::default()
    }

    /// Bytes of the machine code of its rates in `f64`, with the constants in it, where such code is made at run time. For a
    /// law that solves linear equations at each evaluation it is the code of the equations, without the solve.
    fn code_size(&self) -> Option<usize> {
        None
    }

    /// The projection onto equations that its motions keep, where each accepted step is to end on them.
    fn projection(&self) -> Option<&dyn Projection<f64>> {
        None
    }

    /// A source of Taylor coefficients in double-double, where there is one.
    fn taylor_exact(&self) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        None
    }

    /// The flows of the law's pieces composed in `f64`, where the law has pieces.
    fn composed(&self, _splitting: Splitting) -> Option<Box<dyn Composed<f64> + '_>> {
        None
    }

    /// The flows of the law's pieces composed in double-double, where the law has pieces.
    fn composed_exact(&self, _splitting: Splitting) -> Option<Box<dyn Composed<DoubleDouble> + '_>> {
        None
    }
}

/// Functions of time and state at whose zeros a law may have no value, or jump: divisors, which are those of its expressions, the pivots of
/// an elimination, a determinant; radicands, at whose zeros roots have a corner, such as a distance; and angles atan2(y, x), which jump from
/// pi to -pi.
pub trait Divisors {
    /// The number of divisors, which stand first, of radicands, and of angles.
    fn counts(&self) -> [usize; 3];

    /// The values of all at (t, y); `out` has the sum of all counts. Must not allocate.
    fn at(&self, t: f64, y: &[f64], out: &mut [f64]);
}

/// The derivatives of a law. Neither may allocate.
pub trait JacobianFn {
    /// `matrix[i * n + j]` = df_i / dy_j at (t, y).
    fn matrix(&mut self, t: f64, y: &[f64], matrix: &mut [f64]);

    /// `slopes[i]` = df_i / dt at (t, y): zero for a law that does not depend on time.
    fn by_time(&mut self, _t: f64, _y: &[f64], slopes: &mut [f64]) {
        slopes.fill(0.0);
    }

    /// Bytes of the machine code of the matrix, with the constants in it, where such code is made at run time.
    fn code_size(&self) -> Option<usize> {
        None
    }
}

/// A field in which a [`System`] can be integrated.
pub trait Working: Real {
    /// The law of a system, seen in this field.
    fn law(system: &dyn System) -> &dyn Ode<Self>;

    /// The law of a held system, seen in this field.
    fn held(system: &dyn Index2DaeSystem) -> &dyn Index2Dae<Self>;

    /// The system's source of Taylor coefficients in this field.
    fn series(system: &dyn System) -> Option<Box<dyn TaylorSeries<Self> + '_>>;

    /// The projection onto equations that the system's motions keep, where steps in this field end on it: references do
    /// without.
    fn projection(system: &dyn System) -> Option<&dyn Projection<Self>>;

    /// The system's pieces composed in this field.
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
