//! The projection onto the constraints for an ensemble member, whose parameters are inputs.

use super::ConstraintProjection;
use integrators::Projection;
use std::cell::RefCell;

/// The projection onto the constraints for an ensemble member.
pub(crate) struct OfMember<'a> {
    projection: &'a ConstraintProjection,
    /// The state, then the parameters.
    inputs: RefCell<Vec<f64>>,
}

impl<'a> OfMember<'a> {
    /// A state of the member, and its parameters.
    pub fn new(projection: &'a ConstraintProjection, state: &[f64], parameters: &[f64]) -> Self {
        OfMember { projection, inputs: RefCell::new([state, parameters].concat()) }
    }
}

impl Projection<f64> for OfMember<'_> {
    fn project(&self, t: f64, y: &mut [f64]) -> bool {
        let mut inputs = self.inputs.borrow_mut();
        let (state, _) = inputs.split_at_mut(y.len());
        state.copy_from_slice(y);
        let moved = self.projection.project(t, &mut inputs);
        y.copy_from_slice(&inputs[..y.len()]);
        moved
    }
}
