//! Differential-algebraic equations of index 2: laws with constraints and multipliers.

use super::Dual8;
use field::{DoubleDouble, Scalar};

/// The equations y' = f(t, y) + B(t, y) z, 0 = g(t, y) over one scalar type. Implementations must not allocate.
pub trait Index2Dae<S: Scalar> {
    /// The numbers of components of y and of z.
    fn sizes(&self) -> (usize, usize);

    /// dy = f(t, y) + B(t, y) z.
    fn rates(&self, t: S, y: &[S], z: &[S], dy: &mut [S]);

    /// Writes dy = f(t, y), and the columns of B one after the other.
    fn parts(&self, t: S, y: &[S], dy: &mut [S], columns: &mut [S]);

    /// Writes the residuals g(t, y).
    fn constraints(&self, t: S, y: &[S], g: &mut [S]);
}

/// An index-2 DAE over the three scalar types of a run. A type that is generic over `S: Over<f64> + Analytic` needs one
/// more line, `impl Index2DaeSystem for Mine {}`.
pub trait Index2DaeSystem: Index2Dae<f64> + Index2Dae<Dual8> + Index2Dae<DoubleDouble> {}
