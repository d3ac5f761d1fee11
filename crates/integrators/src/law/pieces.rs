//! Laws that are a sum of fields with known flows.

/// A law as a sum of fields, each with a flow that is known.
pub trait Pieces<S> {
    /// A state in the coordinates of the pieces.
    type Point;
    /// The data of a piece for a length of time, computed once and used in every flow of that length.
    type Substep;

    /// The number of pieces. The first has the smallest negative sub-steps: friction belongs there.
    fn pieces(&self) -> usize;

    /// Converts a state of the law.
    fn enter(&self, y: &[S]) -> Self::Point;

    /// Converts to a state of the law. Must not allocate.
    fn leave(&self, point: &Self::Point, y: &mut [S]);

    /// The data of a piece for a length of time, which may be negative.
    fn substep(&self, piece: usize, length: S) -> Self::Substep;

    /// The largest decay rate in the first piece at a point, 1/s; zero where nothing decays.
    fn decay_rate(&self, _point: &Self::Point) -> f64 {
        0.0
    }

    /// Flows along a piece; false where no point is reached. Must not allocate.
    fn flow(&self, piece: usize, substep: &Self::Substep, point: &mut Self::Point) -> bool;
}

/// A composition at work, with the type of its pieces erased.
pub trait Composed<S> {
    /// The length of the steps from now on, negative for backwards.
    fn prepare(&mut self, step: S);

    /// Takes a state of the law.
    fn enter(&mut self, y: &[S]);

    /// The largest rate of decay in the first piece at the present state.
    fn decay_rate(&self) -> f64;

    /// Makes one step; false where no point is reached.
    fn advance(&mut self) -> bool;

    /// The state of the law.
    fn leave(&self, y: &mut [S]);
}
