//! The heavy gyrostat with a fixed point: a carrier that rotates about O, and a rotor that is balanced about an axis
//! fixed in the carrier.
//!
//! # Overview
//! * [`bodies`]: the physical data, their energies and the acceleration energy of their mass points;
//! * [`admissible`]: conditions on the data for which the bodies can exist;
//! * [`routes`]: the equations of motion by four independent principles;
//! * [`tensors`]: the two inertia tensors A and A*, their principal axes, and the weight;
//! * [`forms`]: the equations solved for the accelerations, in the axes of A and of A*, for numerical integration;
//! * [`stationary`]: a paper's conditions for rotations about the vertical; for all such rotations see
//!   `studies::stationary`;
//! * [`driven`]: a form combined with a motor, as the system of first-order equations that is integrated;
//! * [`momenta`]: Hamilton's equations in the momenta, split into explicit sub-flows;
//! * [`lagrange`]: the symmetric top in closed form.
//!
//! Conventions: components refer to axes fixed in the carrier with origin O. w is the carrier's angular velocity, v the
//! unit vector of the vertical *downwards*, l the unit vector of the rotor's axis, phi' the rotor's speed relative to
//! the carrier, and M the torque about l that the carrier exerts on the rotor (motor and friction). Units are SI.
//!
//! # References
//! Konosevich, Konosevich 2022 (Prikladnaya matematika i mekhanika 86, 6), sections 2, 4 and 5.

pub mod admissible;
pub mod bodies;
pub mod driven;
pub mod forms;
pub mod lagrange;
pub mod momenta;
pub mod routes;
pub mod stationary;
pub mod tensors;
mod vectors;

pub use bodies::{Carrier, Gyrostat, Rotor};
pub use routes::MotionInstant;
