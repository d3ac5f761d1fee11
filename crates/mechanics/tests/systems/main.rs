//! Steps and stability, the museum of derivations, uniform rotations, servo constraints.

mod discrete;
mod museum;
mod selected;
mod servo;
