//! All stationary motions of a gyrostat with any motor, and the workbench's own page about them.
//!
//! # Overview
//! * [`energies`]: the quadratic form and the vectors that decide, from the bodies' energies;
//! * [`motor`]: every stationary speed, angle and current of any machine, and what it can bear;
//! * [`motions`]: both together, for a scene: every stationary motion for a given angular velocity or momentum;
//! * [`stability`]: what becomes of small deviations from each;
//! * [`branches`]: the cone of all of them, for pictures;
//! * `claims`: the theorems on which this rests.
//!
//! A stationary motion: the carrier turns with a constant w about the vertical v, fixed in it, and the rotor keeps its
//! relative speed. The carrier's equations ask that v be a critical point of W (`mechanics::uniform`); the rotor's that
//! the motor's moment vanish, friction included; the windings' that every current rest: at zero, unless a supply
//! feeds it.

pub mod branches;
pub mod energies;
pub mod motions;
pub mod motor;
pub mod stability;
