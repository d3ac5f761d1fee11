//! Mechanical systems.

pub mod crank_drive;
pub mod crank_slider;
pub mod disc;
pub mod elastic_governor;
pub mod governor;
pub mod growth;
pub mod gyrostat;
pub mod kept_speed;
pub mod knife_edge;
pub mod ladder;
pub mod painleve_klein;
pub mod rod;
pub mod slender_rod;
pub mod steered_rod;
pub mod swing;
pub mod variable_top;
