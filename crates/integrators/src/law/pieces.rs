//! Laws that are a sum of fields with known flows.

/// A law as a sum of fields, each with a flow that is known.
pub trait Pieces<S> {
    /// A state in the coordinates in which the pieces flow.
    type Point;
    /// What a piece wants to know of a length of time before it flows for it, again and again.
    type Lapse;

    /// How many pieces there are. The first goes back least: friction belongs there.
    fn pieces(&self) -> usize;

    /// From a state of the law.
    fn enter(&self, y: &[S]) -> Self::Point;

    /// To a state of the law. Must not allocate.
    fn leave(&self, point: &Self::Point, y: &mut [S]);

    /// What a piece wants to know of a length of time, which may be negative.
    fn lapse(&self, piece: usize, length: S) -> Self::Lapse;

    /// The fastest rate at which anything fades in the first piece at a point; zero where nothing does.
    fn fading(&self, _point: &Self::Point) -> f64 {
        0.0
    }

    /// Flows; false where no point is reached. Must not allocate.
    fn flow(&self, piece: usize, lapse: &Self::Lapse, point: &mut Self::Point) -> bool;
}

/// A composition at work, its pieces forgotten.
pub trait Composed<S> {
    /// The length of the steps from now on, negative for backwards.
    fn prepare(&mut self, step: S);

    /// Takes a state of the law.
    fn enter(&mut self, y: &[S]);

    /// How fast anything fades in the first piece where the composition stands.
    fn fading(&self) -> f64;

    /// One step; false where it leads nowhere.
    fn advance(&mut self) -> bool;

    /// The state of the law.
    fn leave(&self, y: &mut [S]);
}
