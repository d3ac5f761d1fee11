//! Work against precision: every method on every formulation of a scene's equations with every model of its motor.
//!
//! # Overview
//! * [`Configuration`]: a formulation with a model; each family of scenes lists its own ([`IvpScene::ways`](crate::IvpScene::ways));
//! * [`Observed`]: the quantities that all ways have, for comparing their errors by the reference of the scene's own
//!   model. A smaller model is measured by this reference too: no tolerance brings its error below that of the model
//!   itself;
//! * [`Atlas`]: the runs of all ways, their errors, work and times;
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
