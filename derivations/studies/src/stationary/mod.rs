//! All steady motions of a gyrostat with any motor, with their stability, exactly.
//!
//! # Overview
//! * [`energies`]: the quadratic form and the vectors of W, from the bodies' energies;
//! * [`motor`]: every steady speed, angle and current of any machine, and its pull-out torque;
//! * [`motions`]: every steady motion of a scene for a given angular velocity or angular momentum;
//! * [`stability`]: the stability of each;
//! * [`branches`]: the cone of all axes of rotation, for figures.
//!
//! In a steady motion the carrier rotates with a constant w about the vertical v, fixed in the carrier, and the rotor
//! has a constant relative speed. By the carrier's equations v is a critical point of W
//! (`mechanics::steady_rotations`). By the rotor's equation the motor's torque, including friction, vanishes. By the
//! equations of the windings every current is constant: zero without a supply.

pub mod branches;
pub mod energies;
pub mod motions;
pub mod motor;
pub mod stability;
