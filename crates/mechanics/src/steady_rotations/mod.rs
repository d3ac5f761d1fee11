//! Uniform rotations of a rigid body with spinning wheels about the vertical: all solutions, exactly.
//!
//! The body has a fixed point, the tensor M about it, a constant own angular momentum h in the body (spinning wheels),
//! and the weight vector G. It rotates uniformly with the angular velocity w about the direction v, fixed in the body
//! and in space, if and only if v is a critical point on the unit sphere of
//!
//!   W(v) = 1/2 w^2 v.M v + w h.v + G.v :    (w^2 M - lambda) v + w h + G = 0 ,    |v| = 1 ,
//!
//! with a multiplier lambda. Elimination gives one polynomial in lambda.
//!
//! # Overview
//! * [`Body`]: exact M, h, G; h may depend on one algebraic number;
//! * `spectrum`: (K - lambda) v + b = 0 as polynomials in lambda, and the eigenvalues whose eigenvectors are orthogonal
//!   to b ("unseen");
//! * [`Rotations`] ([`Body::rotations`]): all v for a given w;
//! * [`Selected`]: all (v, w) for a given angular momentum about the vertical ([`Body::at_momentum`]), and the folds,
//!   where rotations merge in saddle-node bifurcations ([`Body::folds`]);
//! * [`Census`] ([`Body::census`]): the number of rotations, for every w;
//! * [`followed()`]: continuation of a rotation along a path of data, with a proof.
//!
//! # Key results
//! In general there are two, four or six directions for a given w: one for lambda below and one above all eigenvalues,
//! and none or two in each gap between eigenvalues. If b is orthogonal to an eigenspace of K, there may be additional
//! pairs, circles or the whole sphere.
//!
//! # References
//! The equation in lambda is that of trust region methods (More, Sorensen 1983; "hard case").

mod body;
mod census;
mod krawczyk_path;
mod rotations;
mod selected;
mod spectrum;

pub use body::Body;
pub use census::{Census, SpeedInterval};
pub use krawczyk_path::{Data, EnclosedPoint, Path, count, followed, sharpened};
pub use rotations::{Kind, Rotations, Shape, SteadyRotation};
pub use selected::{Selected, Turning, Undecided};
