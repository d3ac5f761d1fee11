//! Runs across events: laws whose validity ends, and laws that change.

mod continuation;
mod law_end;
mod one_law;
mod poles;
mod segments;
mod trail;

pub use law_end::{Ending, Margin, Margins, of_leading, outside};
pub(crate) use one_law::OneLaw;
pub use poles::POLE;
pub(crate) use segments::integrate;
pub use segments::{ACCUMULATE, Cause, Passage, Segment, Switching, TOO_MANY};
