//! Motions to all digits, by two methods that agree: of one law, across events, and kept in files.

mod across_events;
mod flow;
mod stored;

pub use across_events::{At, Event, Exact, Followed, Unknown, agreed, instants};
pub use flow::Means;
pub use stored::{Owner, Stored, decimals, place};

use crate::Problem;
use integrators::{Failure, Reference, Span, reference};
use std::time::{Duration, Instant};

/// The number of times, beside the start, at which motions are compared: few, for landing on them costs every method
/// steps.
pub(crate) const INSTANTS: usize = 8;

impl Problem {
    /// The reference solution against which errors are measured. It is not timed: those of many problems may be
    /// computed at once.
    ///
    /// # Errors
    /// Where a method stopped, or the two do not agree.
    pub fn reference(&self, allowed: Duration) -> Result<Reference, Failure> {
        reference(&*self.law, &self.instants().with_deadline(Instant::now() + allowed))
    }

    fn instants(&self) -> Span<'static, f64> {
        Span::new(0.0, self.span, &self.state).with_even_outputs(INSTANTS)
    }
}
