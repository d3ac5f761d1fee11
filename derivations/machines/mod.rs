//! Electric motors: one file each, of energies and laws of force.
//!
//! # Overview
//! The models form a ladder, from a rotor that simply turns to one with every bar of its damper:
//! [`constant_speed`], [`free_rotor`], [`asynchronous`] and [`kloss`] (moment a function of slip), [`synchronous`]
//! (moment a function of the angle), [`equivalent_windings`] (damper as two currents), [`multi_current`] (all bars).
//! Beside it stand [`crossed_windings`] (asynchronous with two currents), [`permanent_magnet`] and [`brushed`] (fed by a
//! voltage).
//! [`Machine`] is what each implements; moment, currents, energies and power balance are derived from it.
//!
//! To add a motor: one file here, and one line in the list below; or its laws as [`text`] in a scene.

mod acting;
mod bench;
mod bench_pieces;
mod borrowed;
mod bound;
mod conserved;
mod kick;
mod loaded;
mod machine;
mod metered;
mod quantity;
mod resting;
mod rule;
mod runaway;
pub mod text;

pub use acting::{Acting, Programmed, Programs};
pub use bench::Bench;
pub use bench_pieces::BenchFlows;
pub use bound::{Allowed, Bound};
pub use conserved::{Conserved, ConservedBy};
pub use kick::{Kick, Law, Point, decay_quotient, fading_slip, fastest_current, has_known_flow, kick, solved};
pub use loaded::Loaded;
pub use machine::{
    Circuit, Machine, RotorState, drive, drive_circuits, heat, is_fed, motional_moment, state_names, stored_energy,
    supplied,
};
pub use metered::{Metered, Powered, feeding};
pub use quantity::Quantity;
pub use resting::resting_currents;
pub use rule::Rule;
pub use runaway::{Driven, Runaway};

use field::{Analytic, Base, Over};
use std::sync::Arc;
use text::{Laws, OfAngle, OfSpeed, Text};

/// A field in which the data of a machine are given: numbers, or symbols that stand for them.
pub trait Datum: Base + Analytic + Over<f64> {}
impl<P: Base + Analytic + Over<f64>> Datum for P {}

/// Where the data of a machine come from: a scene file, a test, or names as symbols.
pub trait Source<P = f64> {
    /// Why a datum could not be had.
    type Error;
    /// A parameter in SI units.
    fn quantity(&mut self, quantity: &Quantity) -> Result<P, Self::Error>;
    /// A whole number of at least one.
    fn count(&mut self, name: &'static str, meaning: &'static str) -> Result<usize, Self::Error>;
    /// The laws of a motor that is written there.
    fn laws(&mut self) -> Option<Arc<Laws>> {
        None
    }
}

/// A machine that can be named in a scene file.
pub trait Catalogued: Machine<f64> + Sized {
    /// One line for lists and reports.
    const SUMMARY: &'static str;
    /// The same machine with its parameters in another field.
    type Over<P: Datum>: Machine<P>;
    /// Reads the parameters.
    fn read<P: Datum, E>(source: &mut impl Source<P, Error = E>) -> Result<Self::Over<P>, E>;
}

/// What can be done with any machine, written once for all of them.
pub trait ForMachine {
    type Output;
    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> Self::Output;
}

macro_rules! machines {
    ($(mod $module:ident : $machine:ident;)*) => {
        $(pub mod $module;)*

        /// Every machine by the name that scene files use; one that is written in a scene knows its slip or its angle.
        #[derive(Clone, Debug)]
        pub enum AnyMachine {
            $($machine($module::$machine<f64>),)*
            TextOfSpeed(Text<f64, OfSpeed>),
            TextOfAngle(Text<f64, OfAngle>),
        }

        impl AnyMachine {
            /// (name, summary) of each.
            pub const LIST: &'static [(&'static str, &'static str)] =
                &[$((stringify!($module), <$module::$machine<f64> as Catalogued>::SUMMARY)),*];

            /// Reads the machine of a name; `None` where there is no such machine.
            pub fn read<E>(name: &str, source: &mut impl Source<Error = E>) -> Option<Result<Self, E>> {
                match name {
                    $(stringify!($module) => Some(<$module::$machine<f64> as Catalogued>::read(source).map(Self::$machine)),)*
                    text::NAME => source.laws().map(|laws| Self::written(laws, |quantity| source.quantity(quantity))),
                    _ => None,
                }
            }

            /// A motor with laws from a text and parameters from a source.
            ///
            /// # Errors
            /// Those of the source.
            pub fn written<E>(
                laws: Arc<Laws>,
                source: impl FnMut(&Quantity) -> Result<f64, E>,
            ) -> Result<Self, E> {
                match laws.rotor() {
                    RotorState::AngleAndSpeed => Text::new(laws, source).map(Self::TextOfAngle),
                    RotorState::Speed | RotorState::Prescribed => Text::new(laws, source).map(Self::TextOfSpeed),
                }
            }

            /// The name that scene files use.
            pub fn name(&self) -> &'static str {
                match self {
                    $(Self::$machine(_) => stringify!($module),)*
                    Self::TextOfSpeed(_) | Self::TextOfAngle(_) => text::NAME,
                }
            }

            /// Applies a task that works for any machine.
            pub fn apply<T: ForMachine>(self, task: T) -> T::Output {
                match self {
                    $(Self::$machine(machine) => task.apply(machine),)*
                    Self::TextOfSpeed(machine) => task.apply(machine),
                    Self::TextOfAngle(machine) => task.apply(machine),
                }
            }
        }
    };
}

machines! {
    mod constant_speed: ConstantSpeed;
    mod free_rotor: FreeRotor;
    mod asynchronous: Asynchronous;
    mod kloss: Kloss;
    mod synchronous: Synchronous;
    mod equivalent_windings: EquivalentWindings;
    mod multi_current: MultiCurrent;
    mod crossed_windings: CrossedWindings;
    mod permanent_magnet: PermanentMagnet;
    mod brushed: Brushed;
}
