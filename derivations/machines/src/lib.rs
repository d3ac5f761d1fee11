//! Electric motors, each in one file of energies and force laws.
//!
//! # Overview
//! The motors form a hierarchy of models, from rotors without a motor ([`motor::ConstantSpeed`], [`motor::FreeRotor`])
//! to a motor with all bars of its damper winding: [`asynchronous`] and [`kloss`] (torque as a function of the slip),
//! [`synchronous`] (torque as a function of the angle), [`equivalent_windings`] (damper winding as two currents),
//! [`multi_current`] (all bars). Further motors are [`crossed_windings`] (asynchronous with two currents),
//! [`permanent_magnet`] and [`brushed`] (with a voltage supply). Each implements [`motor::Machine`].
//!
//! To add a motor, write one file here, its module line below, and its entry in the list. Alternatively, give its laws
//! as text in a scene, or a list in another crate.
//!
//! # Example
//! ```
//! use dalembert_machines as _;
//!
//! let names: Vec<&str> = motor::catalogue::entries().iter().map(|entry| entry.name).collect();
//! assert!(names.contains(&"synchronous") && names.contains(&"brushed"));
//! ```

pub mod asynchronous;
pub mod brushed;
pub mod crossed_windings;
pub mod equivalent_windings;
pub mod kloss;
pub mod multi_current;
pub mod permanent_magnet;
pub mod synchronous;

motor::submit! {
    motor::Catalogue {
        name: "dalembert",
        motors: &[
            &asynchronous::ENTRY,
            &kloss::ENTRY,
            &synchronous::ENTRY,
            &equivalent_windings::ENTRY,
            &multi_current::ENTRY,
            &crossed_windings::ENTRY,
            &permanent_magnet::ENTRY,
            &brushed::ENTRY,
        ],
    }
}
