//! Critical friction coefficients in closed form.

use field::{Circle, Scalar};

/// The critical friction of two masses on a massless rod, k = m/m1: (k + cos^2) / (sin cos).
pub fn two_masses<S: Scalar>(k: S, Circle { cos, sin }: Circle<S>) -> S {
    (k + cos.squared()) / (sin * cos)
}

/// The critical friction of a rod with the moment of inertia m l^2 / kappa about its centre: (1 + kappa cos^2) / (kappa
/// sin cos).
pub fn rod<S: Scalar>(kappa: S, Circle { cos, sin }: Circle<S>) -> S {
    (S::one() + kappa * cos.squared()) / (kappa * sin * cos)
}
