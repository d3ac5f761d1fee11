//! Mechanical and electromechanical systems as text: TOML files are read as models, compiled and run.
//!
//! # Overview
//! The crate is for programs that read a system from a file. The example reads a pendulum, and a file with a wrong unit.
//!
//! * [`ModelScene`]: a file with `[coordinates]`, read and checked; all commands that run scenes accept it;
//! * [`SystemText`], [`derivation`]: the equations of motion of a file, derived by a principle;
//! * [`text`]: the tables of a file as a [`model::Source`];
//! * [`exchange`]: the system as a functional mock-up unit, and as code of other languages;
//! * [`linearisation`]: x' = A x + B w about a point; [`equilibrium()`]: an equilibrium near a guess;
//! * [`parse_ensemble`]: a file with the table `[ensemble]`: many runs, each with its own parameters and start;
//! * [`CompiledSystem`]: the equations of motion as machine code, as Taylor series, and over all number types.
//!
//! # Example
//! ```
//! use dalembert_scenes::{Task, parse_titled};
//!
//! let text = r#"
//! title = "A pendulum"
//! gravity = "-(9.81 m/s^2)*N.y"
//! parameters = { m = "1 kg", l = "0.5 m" }
//! coordinates = { a = "rad" }
//! bodies = { bob = { centre = "O + l*(sin(a)*N.x - cos(a)*N.y)", mass = "m" } }
//! "#;
//! let (title, model) = parse_titled("pendulum.toml", text, Task::Vary).expect("it is a system");
//! assert_eq!((title.as_str(), model.speeds()), ("A pendulum", 1));
//! // an error is reported with its place
//! let error = parse_titled("pendulum.toml", &text.replace("m/s^2", "m/s"), Task::Vary).expect_err("no acceleration");
//! assert!(error.to_string().contains("pendulum.toml:3"));
//! ```

mod admissible;
mod branch;
mod changing_laws;
mod coinciding_points;
mod compiled_system;
pub mod conformance;
mod conservation;
mod constraint_projection;
pub mod derivation;
mod elimination;
mod ensemble;
mod equilibrium;
pub mod exchange;
mod failure_entry;
mod first_motion;
mod formulations;
pub mod geometry;
mod hybrid;
mod implicit;
mod inductances;
mod integrals;
pub mod inverse;
mod kernel;
mod known_as;
mod layout;
mod letters;
pub mod linearisation;
mod modes;
mod motion_matrix;
mod motions;
mod named_systems;
mod no_system;
mod other_values;
mod parametric_law;
mod power_balance;
mod program;
mod quoted_keys;
mod readiness;
mod refused_start;
mod regimes;
pub mod regulator;
mod residual_differential;
mod row_units;
mod scene;
mod size;
mod spread_values;
mod start;
pub mod steady_motions;
mod structural_index;
mod system_text;
pub mod text;
mod warnings;
mod zero_divisor;

/// Registers a [`NamedSystem`] in every program that links the calling crate.
pub use inventory::submit;

pub use compiled_system::{CompiledSystem, NotCompiled};
pub use conservation::keeps_energy;
pub use ensemble::{parse_ensemble, parse_ensemble_with};
pub use equilibrium::{Equilibrium, NoEquilibrium, equilibrium};
pub use failure_entry::{FailureEntry, TriedEntry};
pub use integrals::SceneWithIntegrals;
pub use modes::{Case, CriticalFriction, Face, Margin, Mode, Motions, Phase, Regime, Regimes};
pub use motions::{PrescribedMotion, parse_prescribed, read_prescribed};
pub use named_systems::{NamedSystem, with_tables};
pub use no_system::with_ways_to_a_system;
pub use readiness::{equilibrium_of, independent_at, independent_start, start_of, starting, without_law};
pub use regimes::regimes;
pub use row_units::{unit_of, unit_of_rate};
pub use scene::{Given, ModelScene, register};
pub use size::{Task, too_large};
pub use start::{Completed, Open, Unmet, consistent};
pub use system_text::{
    SystemText, completed_start, completed_start_of, parse_titled, parse_with_source, read_model, read_titled,
    read_with_source, set_values,
};
pub use warnings::Warn;
