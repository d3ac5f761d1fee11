//! Studies of mechanical and electromechanical systems: motions, stability, numerical stability, model reduction.
//!
//! # Overview
//! * [`stationary`]: all steady motions of a gyrostat with any motor, exactly;
//! * [`numerical_stability`]: numerical stability of steady motions;
//! * [`synchronism`]: a synchronous motor under load: synchronous and slipping motions;
//! * [`stabilisation`]: constraint stabilisation (Baumgarte's gains, projection): stability regions, errors and work,
//!   measured;
//! * [`failures`]: failures of numerical methods, with thresholds by theory and by runs;
//! * [`model_reduction`]: reduced models of a scene, their errors, and the cheapest sufficient one;
//! * [`conformance`]: checks of the general laws of motors;
//! * [`closed_forms`]: motions in closed form, by which runs and references are checked;
//! * [`long_runs`]: growth of errors over a million revolutions, measured by a closed form;
//! * [`regimes`], [`governors`]: data of figures;
//! * [`scene`]: a gyrostat or a bench with a motor, from a file; [`AnyScene`]: such a scene, or a model;
//! * [`knowledge`]: knowledge of single systems beyond their equations: closed forms, margins, reduced models;
//! * [`ensemble`]: ensembles: many systems of one kind with different data, run in batches.
//!
//! # Example
//! A synchronous motor given by text passes the checks of [`conformance`].
//! ```
//! use claims::finding::PropertyVerdict;
//! use dalembert_studies::conformance::conform;
//! use dalembert_studies::scene::Scene;
//! use reader::Family;
//!
//! let text = r#"
//! title = "A synchronous motor on a bench"
//! system = "bench"
//! [rotor]
//! axial = "1e-3 kg m^2"
//! [start]
//! rotor_speed = "30 rad/s"
//! [run]
//! span = "1 s"
//! [machine]
//! model = "text"
//! field_speed = "30 rad/s"
//! field_energy = "-b0*cos(g) - 1/2*b2*cos(2*g)"
//! torque_law = "-f*phi'"
//! [machine.parameters]
//! b0 = "0.8 N m"
//! b2 = "0.5 N m"
//! f = "4 mN m s"
//! "#;
//! let scene = Scene::parse("bench.toml", text).expect("it is a scene");
//! let findings = conform(&scene.machine);
//! assert!(findings.iter().all(|finding| !matches!(finding.verdict, PropertyVerdict::Fails(_))));
//! ```

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
