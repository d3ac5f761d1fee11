//! A law without changes, as a [`Switching`] system.

use super::{Segment, Switching};
use crate::law::Law;
use integrators::{Event, Signal, Switches};
use std::sync::Arc;

/// A law that is valid over the whole run.
pub(crate) struct OneLaw(pub Arc<dyn Law>);

impl Switching for OneLaw {
    fn begin(&self, _time: f64, _state: &mut [f64]) -> Result<Segment, &'static str> {
        let law = Arc::clone(&self.0);
        Ok(Segment { law, followed: 0, longest_first: None, switches: Box::new(NoSwitches) })
    }

    fn pass(&self, _event: &Event, _state: &mut [f64]) -> Result<Option<Segment>, &'static str> {
        Ok(None)
    }
}

/// Switches without any signal.
struct NoSwitches;

impl Switches for NoSwitches {
    fn count(&self) -> usize {
        0
    }

    fn signals(&self, _time: f64, _state: &[f64], _out: &mut [Signal]) {}
}
