//! The projection onto the constraints for an ensemble member, with its parameters as inputs.

use super::ConstraintProjection;
use integrators::Projection;
use std::cell::RefCell;

/// The projection of one ensemble member.
pub(crate) struct OfMember<'a> {
    projection: &'a ConstraintProjection,
    /// The state, then the parameters of the member.
    inputs: RefCell<Vec<f64>>,
}

impl<'a> OfMember<'a> {
    /// The projection of the member with these parameters. `state` gives the dimension.
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
