//! What a synchronous motor does under load: in step, out of it, and from where it comes into step.
//!
//! # Overview
//! * [`loaded`]: the motor alone, its load a state that rests;
//! * [`branches`]: all that it can do for ever under every load, with stability: angles in step up to the pull-out, and
//!   slipping turn after turn;
//! * [`pull_in`]: where the slipping begins;
//! * [`energy`]: what holds a rotor that is in step;
//! * [`basin`]: which starts come into step, on the bench and in a gyrostat;
//! * [`maps`]: the share of them over load and damping, over load and bars;
//! * `claims`: what of this is proved, as a page of the workbench's own.
//!
//! Pull-out is the load at which the angles in step end. Pull-in is the least load under which the rotor can slip for ever,
//! turn after turn alike. Between the two both are stable, and it is the start that decides.

pub mod basin;
pub mod branches;
pub mod energy;
pub mod loaded;
pub mod maps;
pub mod pull_in;
