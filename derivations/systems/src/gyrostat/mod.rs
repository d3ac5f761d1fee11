//! The heavy gyrostat with a fixed point: a carrier that turns about O, and a rotor balanced about an axis fixed in it.
//!
//! # Overview
//! * [`bodies`]: the physical data, their energies and the acceleration energy of their mass points;
//! * [`admissible`]: conditions for data of bodies that can exist;
//! * [`routes`]: the equations of motion by independent principles;
//! * [`tensors`]: the two inertia tensors A and A*, principal axes, the weight;
//! * [`forms`]: the equations solved for the accelerations, in the axes of A and of A*, for runs;
//! * [`stationary`]: a paper's conditions of rotations about the vertical; all such rotations: `studies::stationary`;
//! * [`driven`]: a form with a motor, as the system of first-order equations that is integrated;
//! * [`momenta`]: the equations in the momenta, split into explicit sub-flows;
//! * [`lagrange`]: the symmetric top in closed form.
//!
//! Conventions: components in axes fixed in the carrier with origin O; w its angular velocity, v the unit vector of the
//! vertical *downwards*, l the unit vector of the rotor's axis, phi' the rotor's speed relative to the carrier, M the
//! torque about l that the carrier exerts on the rotor (motor and friction). SI units.
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
