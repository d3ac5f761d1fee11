//! Electric motors: one file each, of energies and laws of force.
//!
//! # Overview
//! The models form a ladder, from a rotor that simply turns to one with every bar of its damper:
//! [`constant_speed`], [`free_rotor`], [`asynchronous`] and [`kloss`] (moment a function of slip), [`synchronous`]
//! (moment a function of the angle), [`equivalent_windings`] (damper as two currents), [`multi_current`] (all bars).
//! Beside it stand [`crossed_windings`] (asynchronous with two currents), [`permanent_magnet`] and [`brushed`] (fed by a
//! voltage).
//! [`Machine`] is what each implements; moment, currents, energies and power balance are derived from it.
//! [`Motor`] is what runs: the laws of any of them, written down once as programs, and data.
//!
//! To add a motor: one file here, its line below, and one in the [`catalogue`]; or its laws as [`text`] in a scene; or its
//! entry in a program of one's own ([`catalogue::add`]).

mod acting;
pub mod asynchronous;
mod bench;
mod bench_pieces;
pub mod brushed;
pub mod catalogue;
mod conserved;
pub mod constant_speed;
pub mod crossed_windings;
pub mod equivalent_windings;
pub mod free_rotor;
mod harmonics;
mod kick;
pub mod kloss;
mod laws;
mod loaded;
mod machine;
mod metered;
mod motor;
pub mod multi_current;
pub mod permanent_magnet;
mod resting;
mod rule;
mod runaway;
mod separable;
pub mod synchronous;
pub mod text;

pub use acting::{Acting, Programmed, Programs};
pub use bench::Bench;
pub use bench_pieces::BenchFlows;
pub use catalogue::{Count, Entry, letter};
pub use conserved::Conserved;
pub use kick::{Fading, Kick, Law, Point, decay_quotient, has_known_flow, kick, solved};
pub use laws::{Expressions, Laws, TooLong, Winding};
pub use loaded::Loaded;
pub use machine::{
    Circuit, Machine, RotorState, drive, drive_circuits, heat, is_fed, motional_moment, state_names, stored_energy,
    supplied,
};
pub use metered::{Metered, Powered, feeding};
pub use motor::Motor;
pub use resting::resting_currents;
pub use rule::Rule;
pub use runaway::{Driven, runaway};
pub use separable::{Separable, compiled};

use field::{Analytic, Base, Over};

/// A field in which the data of a motor are given: numbers, or symbols that stand for them.
pub trait Datum: Base + Analytic + Over<f64> {}
impl<P: Base + Analytic + Over<f64>> Datum for P {}
