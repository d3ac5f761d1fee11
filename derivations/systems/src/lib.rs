//! Mechanical and electromechanical systems: bodies, forces, constraints and energies, generic over the scalar type.
//!
//! # Example
//! ```
//! use dalembert_systems::moving_pivot_pendulum::MovingPivotPendulum;
//! use mechanics::constrained::PointSystem;
//!
//! // the same law over `f64`, and over expressions where it is proved
//! let swing = MovingPivotPendulum { mass: 2.0, length: 0.5, gravity: 9.81, speed: 1.0, acceleration: 0.0 };
//! assert_eq!(swing.masses::<f64>(), [2.0, 2.0]);
//! ```

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
