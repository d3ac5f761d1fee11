//! Electric motors: their laws, their data, and their forms for integration.
//!
//! # Overview
//! For authors of motors. The example derives the torque of a magnet from its energy.
//!
//! * [`Machine`]: the trait of a motor: energies and force laws, from which torque, currents, energies and power
//!   balance are derived;
//! * [`Motor`]: a motor for runs: its laws, recorded once as programs, and its data;
//! * [`catalogue`]: the motors of all linked crates, by name;
//! * [`machine_table`]: the table `[machine]` of a scene; [`text`]: motors whose laws are given in this table;
//! * [`Bench`]: a motor alone, with a fixed housing; [`WithSuppliedWork`]: a run of the bench with the work of the
//!   supply;
//! * [`Separable`]: laws that are sums of fields with known flows, for splitting methods; [`Kick`] is the motor's part.
//!
//! # Example
//! ```
//! use dalembert_motor::{Machine, RotorState, torque_and_current_rates};
//! use field::{Base, Circle, Over};
//!
//! /// A magnetised rotor in a field that turns at 100 rad/s: U = -b cos g.
//! struct Magnet<P> {
//!     b: P,
//! }
//!
//! impl<P: Base> Machine<P> for Magnet<P> {
//!     fn rotor(&self) -> RotorState {
//!         RotorState::AngleAndSpeed
//!     }
//!
//!     fn frame_speed(&self) -> P {
//!         P::int(100)
//!     }
//!
//!     fn field_energy<S: Over<P>>(&self, angle: Circle<S>) -> S {
//!         -S::lift(self.b) * angle.cos
//!     }
//!
//!     // no friction
//!     fn torque_law<S: Over<P>>(&self, _slip: S, _speed: S) -> S {
//!         S::zero()
//!     }
//! }
//!
//! // the torque is -U'(g): it pulls a rotor that leads back into the field
//! let (sin, cos) = 0.3_f64.sin_cos();
//! let torque = torque_and_current_rates(&Magnet { b: 2.0 }, Circle { cos, sin }, 0.0, &[], &mut []);
//! assert!((torque + 2.0 * sin).abs() < 1e-15);
//! ```

mod bench;
mod bench_pieces;
pub mod catalogue;
mod constant_speed;
mod exact_turns;
mod fixed_angle_laws;
mod free_rotor;
mod gauss4_scalar;
mod harmonics;
mod integrals;
mod kick;
mod laws;
mod load;
mod machine;
pub mod machine_table;
mod motor;
mod power_balance;
pub mod reading;
mod runaway;
mod separable;
mod steady_currents;
pub mod text;
mod text_motor;

pub use bench::Bench;
pub use bench_pieces::BenchFlows;
pub use catalogue::{Catalogue, Count, Entry, letter};
pub use constant_speed::ConstantSpeed;
pub use fixed_angle_laws::{FixedAngleMachine, Programmed, Programs};
pub use free_rotor::FreeRotor;
pub use gauss4_scalar::Rule;
pub use integrals::Conserved;
/// Registers a [`Catalogue`]: the motors of a crate, available wherever it is linked.
pub use inventory::submit;
pub use kick::{DecayRates, Kick, Law, Point, decay_quotient, has_known_flow, kick, solved};
pub use laws::{Expressions, Laws, TooLong, Winding};
pub use load::Loaded;
pub use machine::{
    Circuit, Machine, RotorState, electrical_power, is_fed, joule_heat, motional_torque, state_names, stored_energy,
    torque_and_circuit_rates, torque_and_current_rates,
};
pub use machine_table::NoModel;
pub use motor::Motor;
pub use power_balance::{Powered, WithSuppliedWork, supplied_power};
pub use runaway::{Driven, runaway};
pub use separable::{Separable, compiled};
pub use steady_currents::steady_currents;

use field::{Analytic, Base, Over};

/// A scalar type for the data of a motor: numbers, or symbols.
pub trait Datum: Base + Analytic + Over<f64> {}
impl<P: Base + Analytic + Over<f64>> Datum for P {}
