//! Laws that are sums of vector fields with known flows, for splitting methods.

/// A law as a sum of vector fields ("pieces"), each with a known flow.
pub trait Pieces<S> {
    /// A state, in coordinates in which the flows are computed.
    type Point;
    /// Precomputed data of a flow over one time length.
    type Substep;

    /// The number of pieces. Friction belongs into the first piece, whose negative sub-steps are the smallest.
    fn pieces(&self) -> usize;

    /// Converts a state of the law to a point.
    fn enter(&self, y: &[S]) -> Self::Point;

    /// Converts a point to a state of the law. Must not allocate.
    fn leave(&self, point: &Self::Point, y: &mut [S]);

    /// The data for the flow of a piece over `length`, which may be negative.
    fn substep(&self, piece: usize, length: S) -> Self::Substep;

    /// The largest decay rate in the first piece at a point, 1/s; zero where nothing decays.
    fn decay_rate(&self, _point: &Self::Point) -> f64 {
        0.0
    }

    /// Applies the flow of a piece; false where the flow does not exist for this length. Must not allocate.
    fn flow(&self, piece: usize, substep: &Self::Substep, point: &mut Self::Point) -> bool;
}

/// A splitting method for one law, as an object type.
pub trait Composed<S> {
    /// Sets the step size, which is negative for runs backwards in time.
    fn prepare(&mut self, step: S);

    /// Sets the state.
    fn enter(&mut self, y: &[S]);

    /// The largest decay rate in the first piece at the present state, 1/s.
    fn decay_rate(&self) -> f64;

    /// Makes one step; false where a flow does not exist.
    fn advance(&mut self) -> bool;

    /// Writes the present state.
    fn leave(&self, y: &mut [S]);
}
