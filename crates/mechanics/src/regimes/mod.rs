//! Regimes of contacts with Coulomb's friction: every consistent one, at one state, under any load.
//!
//! # Overview
//! At a state the accelerations of K contacts are affine in their reactions, a = b + W lambda ([`Dry`]). A contact that
//! is closed either separates, sticks or slips ([`Mode`]); a choice for each contact is a regime, which turns the
//! laws of contact and friction into linear equations and inequalities ([`conditions`](mod@conditions)). Nothing is
//! minimised, iterated or regularised: every regime is examined, and the answer lists the consistent ones.
//!
//! * [`dry`]: the free accelerations b and the response W, the system's own constraints kept;
//! * [`mode`]: the modes of a contact, by its sliding velocity;
//! * [`conditions`](mod@conditions): the equations and the inequalities of a regime;
//! * [`cramer`]: reactions and margins as quotients of polynomials, over any field: for proofs and right-hand sides;
//! * [`reactions`]: all reactions that a regime admits, a polyhedron, also where its equations are singular;
//! * [`verdict`](mod@verdict): unique, none, several, or a continuum.
//!
//! # What is counted
//!
//! Motions, not names. Sticking with friction at its limit and slipping without acceleration are one motion; two
//! sets of reactions of a body with more supports than it needs are one motion too. Two consistent regimes are counted
//! as several motions only if some acceleration differs.

pub mod conditions;
pub mod cramer;
pub mod dry;
pub mod mode;
pub mod posed;
pub mod reactions;
pub mod sign;
pub mod verdict;

pub use conditions::{Condition, Form, conditions, equations};
pub use dry::{Dry, Seen};
pub use mode::{Direction, Face, Mode, Sizes, Touch, Unfit, touches};
pub use posed::{Unposed, posed};
pub use sign::Ordered;
pub use verdict::{Consistency, Found, consistent, verdict};
