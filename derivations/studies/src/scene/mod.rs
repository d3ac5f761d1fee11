//! Scenes with a motor: a system, a machine, parameters with units, an initial state and a span of time, read from a TOML file.
//!
//! # Overview
//! * [`Scene`]: the gyrostat with a motor, or a motor on the bench; every family is in [`AnyScene`](crate::AnyScene);
//! * [`bodies`], [`start`]: tables of a scene; that of the machine is read by [`motor::machine_table`];
//! * [`state`]: the initial state in the axes of either form of the equations, and results back in the axes of the data;
//! * `problem`: the initial value problem; `power_balance`: the problem with the work of the supply as a state; `configurations`:
//!   every form with every motor that the data allow;
//! * `model`: the scene as a model, for commands on equations;
//! * [`code`]: the right-hand side and its Jacobian as code of other languages.

pub mod bodies;
pub mod code;
mod configurations;
mod model;
mod power_balance;
mod problem;
mod runaway;
mod smooth;
pub mod start;
pub mod state;

pub use start::Start;

use motor::Motor;
use reader::{Family, Issue, Opening, Table};
use simulation::Run;
use systems::gyrostat::Gyrostat;

/// The mechanical system of a scene.
#[derive(Clone, Debug, PartialEq)]
pub enum Setup {
    /// A gyrostat with a motor between carrier and rotor.
    Gyrostat(Box<Gyrostat<f64>>),
    /// A motor alone: a housing at rest, and a rotor with this moment of inertia about its axis, kg m^2.
    Bench { axial: f64 },
}

/// A scene whose data are all admissible.
#[derive(Clone, Debug)]
pub struct Scene {
    pub title: String,
    /// A description of the motion, and its difficulty for a method.
    pub description: String,
    pub system: Setup,
    pub machine: Motor,
    /// The machine with all given data, from which other motor models can be made.
    pub given: Motor,
    pub start: Start,
    pub run: Run,
}

reader::submit! { reader::KnownSystems(<Scene as Family>::systems) }

impl Family for Scene {
    const KIND: &'static str = "a system with a motor";

    fn systems() -> Vec<(&'static str, &'static str)> {
        vec![
            ("gyrostat", "a heavy gyrostat with a fixed point and a motor that drives its rotor"),
            ("bench", "a motor alone, its housing at rest"),
        ]
    }

    fn read(opening: Opening, top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Self> {
        let Opening { title, description, system } = opening;
        // this table is read for ensembles only
        top.known(&["ensemble"]);
        let on_bench = system.value == "bench";
        let system = match on_bench {
            true => bodies::bench(top, issues).map(|axial| Setup::Bench { axial }),
            false => bodies::gyrostat(top, issues).map(|bodies| Setup::Gyrostat(Box::new(bodies))),
        };
        let machine = motor::machine_table::read(top, issues);
        let start = start::read(top, issues, on_bench, machine.as_ref());
        let outputs = machine.as_ref().map(|machine| state::outputs(on_bench, machine));
        let run = simulation::run::read(top, issues, outputs.as_deref());
        let (machine, system) = (machine?, system?);
        Some(Scene { title, description, system, given: machine.clone(), machine, start: start?, run: run? })
    }
}
