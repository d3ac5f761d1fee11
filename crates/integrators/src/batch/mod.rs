//! Integration of a batch: many systems of one kind at once, one in each lane of a SIMD register.

mod ensemble;
mod lockstep;

pub use ensemble::{BatchSeries, BatchStep, Ensemble, Members, batch_order};
pub use lockstep::{BatchRungeKutta4, fuses};
