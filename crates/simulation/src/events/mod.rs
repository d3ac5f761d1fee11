//! Laws that end, and laws that change: runs from event to event.

mod law_end;
mod switching;

pub use law_end::{Ending, Margin, Margins, of_leading, outside};
pub(crate) use switching::integrate;
pub use switching::{Passage, Segment, Switching};
