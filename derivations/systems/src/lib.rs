//! Mechanical and electromechanical systems: bodies, forces, constraints and energies, generic over the number.

pub mod crank_drive;
pub mod crank_slider;
pub mod disc;
pub mod elastic_governor;
pub mod governor;
pub mod gyrostat;
pub mod knife_edge;
pub mod ladder;
pub mod moving_pivot_pendulum;
pub mod painleve_klein;
pub mod prescribed_speed_point;
pub mod rod;
pub mod slender_rod;
pub mod steered_rod;
pub mod variable_inertia;
pub mod variable_top;
