//! Many systems of one kind at once, one in each lane of a wide register.

mod ensemble;
mod side_by_side;

pub use ensemble::{Ensemble, LaneSeries, LaneStep, Members, lanes_order};
pub use side_by_side::{SideBySide, fuses};
