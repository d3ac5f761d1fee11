//! The principles of mechanics over any scalar type.
//!
//! # Overview
//! For programs that derive equations of motion and prove statements about them. A system is given by its energies, as functions generic
//! over the number type. Each principle turns the energies into equations of motion by forward-mode differentiation ([`field::Tangent`]).
//! The crate contains no particular system.
//!
//! | principle | from | module |
//! |---|---|---|
//! | Lagrange, second kind | L(q, q') | [`lagrange`] |
//! | Lagrange in quasi-velocities (Boltzmann, Hamel) | T(q, w), w = W(q) q' | [`hamel`] |
//! | Appell | the acceleration energy S of the mass points | [`appell`] |
//! | angular momentum | the angular momentum of the mass points | [`momentum`] |
//!
//! For systems given by masses, forces and constraints in the coordinates of their mass points, [`constrained`] derives
//! multipliers, reactions, the equations by Gauss' principle and those in redundant coordinates from one description.
//! [`regimes`] finds the contact modes that are consistent with Coulomb's law of friction.
//!
//! [`bellman`] derives Riccati's equation of optimal control from Bellman's. [`stability`] decides asymptotic stability
//! by Hurwitz' determinants; [`linear_stability`] counts roots and signs exactly, including singular cases.
//! [`one_step_stability`] gives the linear stability of a one-step method on a steady motion.
//!
//! Each principle returns *residuals*: functions of the accelerations that vanish along the motion. Claims of the
//! ledger prove that the right-hand side of a run makes every residual vanish.
//!
//! # Example
//! ```
//! use dalembert_mechanics::lagrange::lagrange;
//! use field::{Scalar, Tangent};
//!
//! // a mass of 2 kg on a spring of 8 N/m: 2 x'' + 8 x vanishes along the motion
//! let residual = |x: f64, acceleration: f64| {
//!     lagrange(
//!         |[x]: [Tangent<Tangent<f64>>; 1], [v]| v * v - Tangent::<Tangent<f64>>::int(4) * x * x,
//!         [x], [0.0], [acceleration],
//!     )
//! };
//! assert_eq!(residual(0.5, -2.0), [0.0]);
//! assert_eq!(residual(0.5, 0.0), [4.0]);
//! ```

pub mod appell;
pub mod bellman;
pub mod constrained;
pub mod definite;
pub mod differentiate;
pub mod hamel;
pub mod lagrange;
pub mod linear_stability;
pub mod mass;
pub mod momentum;
pub mod one_step_stability;
pub mod regimes;
pub mod rotation;
pub mod stability;
pub mod steady_rotations;
