//! Reference solutions in double-double, by two methods that agree: of one law, across events, and stored in files.

mod across_events;
mod flow;
mod stored;

pub use across_events::{At, Event, Exact, Followed, Unknown, agreed, instants};
pub use flow::Means;
pub use stored::{Owner, Stored, decimals, place};

use crate::Problem;
use integrators::{Failure, Reference, Span, reference};
use std::time::{Duration, Instant};

/// The number of output times, besides the start, at which motions are compared. It is small, since steps in
/// double-double must end at outputs.
pub(crate) const INSTANTS: usize = 8;

impl Problem {
    /// The reference solution from which errors are measured, at 8 output times besides the start. The computation ends after the time `allowed`.
    /// It measures no times, so that several references can be computed in parallel.
    ///
    /// # Errors
    /// [`Failure`] if a method fails, the two methods do not agree, or the time is over.
    pub fn reference(&self, allowed: Duration) -> Result<Reference, Failure> {
        reference(&*self.law, &self.instants().with_deadline(Instant::now() + allowed))
    }

    fn instants(&self) -> Span<'static, f64> {
        Span::new(0.0, self.span, &self.state).with_even_outputs(INSTANTS)
    }
}
