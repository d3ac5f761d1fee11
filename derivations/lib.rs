//! The content of the workbench: systems, machines (motors), the papers' equations as claims, scenes.
//!
//! # Overview
//! * [`systems`]: mechanical systems, as data of bodies and laws of energy;
//! * [`derive`](mod@derive): equations of motion by a chosen principle, for reading;
//! * [`closed_forms`]: motions that are known, by which runs and references are measured;
//! * [`conformance`]: what every motor must do, whoever wrote it;
//! * [`long_runs`]: how errors grow over a million revolutions, by a closed form;
//! * [`ensemble`]: many systems of one kind with data of their own, run side by side;
//! * [`ledger`](mod@ledger): every page of claims;
//! * [`AnyScene`]: a scene of any family;
//! * [`ladder`]: smaller models under the one of a scene, what each step loses, the cheapest that suffices;
//! * [`machines`]: electric motors, each one file of energies and laws of force;
//! * [`mechanisms`]: governors, drives, bodies that roll, by the names that scene files use;
//! * [`principles`]: the principles of mechanics, equal on every system: a page of claims of the workbench's own;
//! * [`scene`]: a system with a machine, data and an initial state, from a file;
//! * [`alphabet`](mod@alphabet): the letters of a page, with LaTeX and dimensions;
//! * [`papers`]: a paper a folder, its numbered equations as claims in the paper's own order and letters.
//! * [`failures`]: every way in which methods fail, with its threshold by theory and by runs;
//! * [`governors`]: stability and series of the friction governors, for pictures;
//! * [`phantom`]: what the steps of methods make of the stability of motions, as a page of claims and for scenes;
//! * [`regimes`]: when motion with friction is determined, as a page of claims;
//! * [`stabilisation`]: stabilised constraints in steps, as a page of claims;
//! * [`stationary`]: all stationary motions of a gyrostat with any motor, exactly;
//! * [`synchronism`]: a synchronous motor under load, in step and out of it.

pub mod alphabet;
mod any_scene;
pub mod closed_forms;
pub mod conformance;
pub mod derive;
pub mod ensemble;
mod exact_turns;
pub mod failures;
pub mod governors;
pub mod ladder;
pub mod ledger;
pub mod long_runs;
pub mod machines;
pub mod mechanisms;
pub mod papers;
pub mod phantom;
pub mod principles;
pub mod regimes;
pub mod scene;
pub mod stabilisation;
pub mod stationary;
pub mod synchronism;
pub mod systems;

/// The examples of the book compile and hold.
#[cfg(doctest)]
mod book {
    #[doc = include_str!("../book/src/principles.md")]
    struct Principles;
    #[doc = include_str!("../book/src/verdicts.md")]
    struct Verdicts;
    #[doc = include_str!("../book/src/bounds.md")]
    struct Bounds;
}

pub use any_scene::AnyScene;
