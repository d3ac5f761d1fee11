//! Laws that end, and laws that change: runs from event to event.

mod law_end;
mod poles;
mod segments;

pub use law_end::{Ending, Margin, Margins, of_leading, outside};
pub(crate) use segments::integrate;
pub use segments::{Passage, Segment, Switching};
