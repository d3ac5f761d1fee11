//! Stability of steps, published errors in derivations, steady rotations, servo constraints.

mod discrete;
mod museum;
mod selected;
mod servo;
