//! What is answered: the motions, each with its stability, and why none is missing.

use crate::stationary::stability::{Along, Judged};
use algebra::real::Enclosure;
use mechanics::steady_rotations::{Kind, Shape, Undecided};
use nalgebra::Vector3;

/// All that goes with one case.
pub struct Answer {
    /// As [`super::Case::value`].
    pub value: f64,
    pub found: Vec<Found>,
    pub certificate: Certificate,
}

/// Why none is missing.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// Of the polynomial whose real roots were isolated, and their number.
    pub degree: usize,
    pub roots: usize,
    /// Their number by Sturm's theorem, where it was counted again.
    pub again: Option<usize>,
    /// Minima - saddles + maxima, 2 on a sphere.
    pub morse: Option<i32>,
    /// What may hide further motions: then completeness is not claimed.
    pub undecided: Option<Undecided>,
}

/// Of a family: what it is, and what becomes of small deviations from its members.
#[derive(Clone, Debug)]
pub struct Members {
    /// of a circle: its radius, and the axis about which it lies
    pub circle: Option<(f64, Vector3<f64>)>,
    /// for each angle of a motor in step, else once
    pub along: Vec<Along>,
}

/// A stationary motion, or a connected family of them.
#[derive(Clone, Debug)]
pub struct Found {
    pub shape: Shape,
    pub kind: Kind,
    /// lambda, N m, where it was isolated for a given angular velocity: the ends of its interval
    pub multiplier: Option<[f64; 2]>,
    /// v in the axes of the data, enclosed; of a circle its centre
    pub enclosed: [Enclosure; 3],
    /// v of the motion, or of one of the family
    pub direction: Vector3<f64>,
    /// w, rad/s
    pub speed: f64,
    /// phi', rad/s
    pub rotor_speed: f64,
    /// the angular momentum about the vertical, N m s
    pub momentum: f64,
    /// what becomes of small deviations: for each angle of a motor in step, else once; of a family in `family`
    pub stability: Vec<Judged>,
    pub family: Option<Members>,
    /// the largest rate of the equations that run, at this state and every angle of the rotor, rad/s^2, A/s
    pub residual: f64,
}

impl Certificate {
    /// Whether none is missing, proved.
    pub fn is_complete(&self) -> bool {
        self.undecided.is_none()
            && self.again.is_none_or(|again| again == self.roots)
            && self.morse.is_none_or(|sum| sum == 2)
    }
}
