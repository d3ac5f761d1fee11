//! Work-precision comparison: every method on every formulation of a scene's equations with every model of its motor.
//!
//! # Overview
//! * [`Configuration`]: a formulation with a model; each family of scenes lists its own
//!   ([`IvpScene::ways`](crate::IvpScene::ways));
//! * [`Observed`]: the quantities common to all configurations; their errors are measured by the reference of the
//!   scene's own model. The error of a reduced model includes its modelling error, which no tolerance reduces;
//! * [`Atlas`]: the runs of all configurations, with errors, work and times;
//! * [`Hybrid`]: scenes whose law changes at events.

mod atlas;
mod configuration;
mod hybrid;
mod measured;

pub use atlas::{Atlas, Explored, Goal, Observed};
pub use configuration::{
    Configuration, Formulation, SharedHybridMotion as AcrossEvents, SharedIndex2Dae, Standing, Treated,
};
pub use hybrid::Hybrid;
pub use measured::{Trials, judged, judged_across_events};
