//! Laws of coordinates without inertia.

/// A linear combination of the laws of coordinates, as pairs (index of the speed, integer factor).
pub(crate) type Combination = Vec<(usize, i64)>;

/// The reason why a case-dependent law without inertia is not solved for its speeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnsolvedLaw {
    /// The law is nonlinear in the unknown speeds.
    Nonlinear,
    /// A contact between bodies depends on the speed.
    Contact,
    /// A stabilised (programmed) constraint contains the speed.
    Programmed,
    /// The law contains a condition and no speed, so that a coordinate would jump.
    OfPositions,
}
