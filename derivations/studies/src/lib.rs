//! Studies of mechanical and electromechanical systems: motions, stability, steps of methods, smaller models.
//!
//! # Overview
//! * [`stationary`]: all stationary motions of a gyrostat with any motor, exactly;
//! * [`numerical_stability`]: numerical stability of steady motions;
//! * [`synchronism`]: a synchronous motor under load, in step and out of it;
//! * [`stabilisation`]: constraint stabilisation (Baumgarte's gains, projection): stability regions, errors and work, measured;
//! * [`failures`]: every way in which methods fail, with its threshold by theory and by runs;
//! * [`model_reduction`]: smaller models under the one of a scene, the error of each, the cheapest that suffices;
//! * [`conformance`]: rules for every motor, whoever wrote it;
//! * [`closed_forms`]: motions in closed form, against which runs and references are measured;
//! * [`long_runs`]: growth of errors over a million revolutions, measured against a closed form;
//! * [`regimes`], [`governors`]: maps and series for pictures;
//! * [`scene`]: a gyrostat or a bench with a motor, from a file; [`AnyScene`]: such a scene, or a model;
//! * [`knowledge`]: facts about single text systems beyond their equations: closed forms, ends, smaller models;
//! * [`ensemble`]: ensembles: many systems of one kind with different data, run in batches.

mod any_scene;
pub mod closed_forms;
pub mod conformance;
pub mod ensemble;
pub mod failures;
pub mod governors;
pub mod knowledge;
pub mod long_runs;
pub mod model_reduction;
pub mod numerical_stability;
pub mod regimes;
pub mod scene;
pub mod stabilisation;
pub mod stationary;
pub mod synchronism;

pub use any_scene::AnyScene;
