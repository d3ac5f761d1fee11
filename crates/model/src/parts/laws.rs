//! Laws of coordinates without inertia.

/// A combination of the laws of coordinates: speeds by their places, with factors.
pub(crate) type Combination = Vec<(usize, i64)>;

/// Why a law without inertia that changes is not solved for its speeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnsolvedLaw {
    /// It is not linear in the speeds that are sought.
    Nonlinear,
    /// A contact between bodies holds its speed.
    Contact,
    /// A programmed constraint, which need not hold, holds its speed.
    Programmed,
    /// It holds a condition and no speed, so that it would move a coordinate at once.
    OfPositions,
}
