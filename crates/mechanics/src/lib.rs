//! The principles of mechanics over any field.
//!
//! # Overview
//! A system is given by its energies as laws generic over the scalar. Each principle turns them into equations of
//! motion by forward-mode differentiation ([`field::Tangent`]); none of them names a system or contains a formula of one.
//!
//! | principle | from | module |
//! |---|---|---|
//! | Lagrange II | L(q, q') | [`lagrange`] |
//! | Lagrange in quasi-velocities (Boltzmann, Hamel) | T(q, w), w = W(q) q' | [`hamel`] |
//! | Appell | the acceleration energy S of the mass points | [`appell`] |
//! | angular momentum | the moment of momentum of the mass points | [`momentum`] |
//!
//! For systems given by masses, forces and constraints in the coordinates of their mass points, [`constrained`] derives
//! the same and more from that one description: multipliers, reactions, Gauss' minimum, redundant coordinates.
//! [`regimes`] is not a principle: it finds which of the modes of rough contacts agree with the laws of friction.
//!
//! [`bellman`] does the same for optimal control: Riccati's equation from Bellman's. [`stability`] decides by Hurwitz;
//! [`linear_stability`] counts roots and signs exactly, singular cases included.
//! [`one_step_stability`] asks what a one-step method makes of that.
//!
//! Each returns *residuals*: expressions in accelerations that vanish along the motion. The right-hand side that runs is
//! one of the forms; that it makes every residual vanish is a claim, and is proved.

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
