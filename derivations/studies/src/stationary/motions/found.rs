//! The steady motions of a scene, each with its stability, and the certificate of completeness.

use crate::stationary::stability::{Along, Judged};
use algebra::real::Enclosure;
use mechanics::steady_rotations::{Kind, Shape, Undecided};
use nalgebra::Vector3;

/// The steady motions of one case.
pub struct Answer {
    /// As [`super::Case::value`].
    pub value: f64,
    pub found: Vec<Found>,
    pub certificate: Certificate,
}

/// The evidence that no motion is missing.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// The degree of the polynomial whose real roots were isolated; `roots` is their number.
    pub degree: usize,
    pub roots: usize,
    /// The number of real roots by Sturm's theorem, if it was counted independently.
    pub again: Option<usize>,
    /// Minima - saddles + maxima, which is 2 on a sphere.
    pub morse: Option<i32>,
    /// The reason why further motions may exist; completeness is then not claimed.
    pub undecided: Option<Undecided>,
}

/// A connected family of motions, with the stability of its members.
#[derive(Clone, Debug)]
pub struct Members {
    /// The radius and the axis of a circle of directions.
    pub circle: Option<(f64, Vector3<f64>)>,
    /// The verdicts along the family: one for each angle of a synchronous motor, otherwise one.
    pub along: Vec<Along>,
}

/// A steady motion, or a connected family of them.
#[derive(Clone, Debug)]
pub struct Found {
    pub shape: Shape,
    pub kind: Kind,
    /// The ends of the interval, N m, in which lambda was isolated for a given angular velocity.
    pub multiplier: Option<[f64; 2]>,
    /// The enclosure of v in the axes of the data; for a circle that of its centre.
    pub enclosed: [Enclosure; 3],
    /// The direction v of the motion, or of a member of the family.
    pub direction: Vector3<f64>,
    /// The angular velocity w, rad/s.
    pub speed: f64,
    /// The rotor's relative speed phi', rad/s.
    pub rotor_speed: f64,
    /// The angular momentum about the vertical, N m s.
    pub momentum: f64,
    /// The stability, once for each angle of a synchronous motor, otherwise once; that of a family is in `family`.
    pub stability: Vec<Judged>,
    pub family: Option<Members>,
    /// The largest rate by the compiled equations at this state, over all angles of the rotor, rad/s^2, A/s.
    pub residual: f64,
}

impl Certificate {
    /// Whether completeness is proved.
    pub fn is_complete(&self) -> bool {
        self.undecided.is_none()
            && self.again.is_none_or(|again| again == self.roots)
            && self.morse.is_none_or(|sum| sum == 2)
    }
}
