//! Laws that end, and laws that change: runs from event to event.

mod law_end;
mod poles;
mod segments;

pub use law_end::{Ending, Margin, Margins, of_leading, outside};
pub use poles::POLE;
pub(crate) use segments::integrate;
pub use segments::{ACCUMULATE, Passage, Segment, Switching, TOO_MANY};
