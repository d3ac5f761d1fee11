//! An electric motor as a value.
//!
//! # Overview
//! * [`Machine`]: what a motor's file implements: energies, and laws of force; moment, currents, energies and power balance are derived
//!   from it;
//! * [`Motor`]: what runs: the laws of any of them, written down once as programs, and data;
//! * [`catalogue`]: the motors that have a name, whichever crate brings them;
//! * [`reading`]: the table `[machine]` of a scene; [`text`] is a motor whose laws stand there;
//! * [`Bench`]: a motor alone, its housing at rest; [`Metered`]: with the work of its supply;
//! * [`Separable`]: laws that are sums of fields whose flows are known, for splitting methods; [`Kick`] is the motor's part of them.

mod acting;
mod bench;
mod bench_pieces;
pub mod catalogue;
mod conserved;
mod harmonics;
mod kick;
mod laws;
mod loaded;
mod machine;
mod metered;
mod motor;
pub mod reading;
mod resting;
mod rule;
mod runaway;
mod separable;
pub mod text;
mod text_motor;

pub use acting::{Acting, Programmed, Programs};
pub use bench::Bench;
pub use bench_pieces::BenchFlows;
pub use catalogue::{Catalogue, Count, Entry, letter};
pub use conserved::Conserved;
/// Brings a [`Catalogue`]: motors of a crate, found wherever it is linked.
pub use inventory::submit;
pub use kick::{Fading, Kick, Law, Point, decay_quotient, has_known_flow, kick, solved};
pub use laws::{Expressions, Laws, TooLong, Winding};
pub use loaded::Loaded;
pub use machine::{
    Circuit, Machine, RotorState, drive, drive_circuits, heat, is_fed, motional_moment, state_names, stored_energy,
    supplied,
};
pub use metered::{Metered, Powered, feeding};
pub use motor::Motor;
pub use reading::NoModel;
pub use resting::resting_currents;
pub use rule::Rule;
pub use runaway::{Driven, runaway};
pub use separable::{Separable, compiled};

use field::{Analytic, Base, Over};

/// A field in which the data of a motor are given: numbers, or symbols that stand for them.
pub trait Datum: Base + Analytic + Over<f64> {}
impl<P: Base + Analytic + Over<f64>> Datum for P {}
