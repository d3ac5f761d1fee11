//! Many systems of one kind at once, one in each lane of a wide register.

mod ensemble;
mod lockstep;

pub use ensemble::{Ensemble, LaneSeries, LaneStep, Members, lanes_order};
pub use lockstep::{SideBySide, fuses};
