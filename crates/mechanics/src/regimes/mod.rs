//! Regimes of contacts with Coulomb friction: all consistent regimes at a state.
//!
//! # Overview
//! At a state the accelerations of K contacts are affine in their reactions, a = b + W lambda ([`Dry`]). A closed
//! contact separates, sticks or slips ([`Mode`]). A choice of modes for all contacts is a regime; it turns the laws of
//! contact and friction into linear equations and inequalities ([`conditions`](mod@conditions)). All regimes are
//! enumerated, and the result lists the consistent ones. There is no iteration and no regularisation.
//!
//! * [`dry`]: the free accelerations b and the response W, with the system's own constraints satisfied;
//! * [`mode`]: the modes of a contact, by its sliding velocity;
//! * [`conditions`](mod@conditions): the equations and inequalities of a regime;
//! * [`cramer`]: reactions and margins as quotients of polynomials, over any scalar type, for proofs and right-hand
//!   sides;
//! * [`reactions`]: the polyhedron of all reactions that a regime admits, including singular regimes;
//! * [`verdict`](mod@verdict): one consistent motion, none, several, or a continuum.
//!
//! # Motions and regimes
//!
//! The result counts motions, not regimes. Sticking with friction at its limit and slipping without acceleration are
//! one motion; different reactions of a statically indeterminate body are one motion too. Two consistent regimes count
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
