//! Elements and torques about the axes of frames, each at the joint where it acts.

use super::Geometry;
use super::figure::{Figure, Symbolic};
use model::geometry::Action;
use nalgebra::{DMatrix, DVector, Vector3};

/// Singular values below this part of the largest one are taken for zero.
const RANK: f64 = 1e-9;

/// Places that are apart by less than this part of the size of a system are one.
const SAME: f64 = 1e-6;

/// A torsion spring or a rotary dashpot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotary {
    pub joint: Joint,
    /// The axis of both frames: x, y or z.
    pub axis: usize,
    /// A spring or a dashpot.
    pub action: Action,
}

/// Where two frames turn beside each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    pub frames: [usize; 2],
    /// A point that is fixed in both, where there is one.
    pub at: Option<Spot>,
    /// The bodies that turn with the frames; none with the ground.
    pub bodies: [Option<usize>; 2],
}

/// A point from a place of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    pub place: usize,
    /// The way from that place, along the axes of a frame.
    pub way: Vector3<f64>,
    pub frame: usize,
}

impl Spot {
    /// The point in a figure.
    pub fn in_figure(&self, figure: &Figure) -> Vector3<f64> {
        let [x, y, z] = figure.frames[self.frame];
        figure.places[self.place] + self.way.x * x + self.way.y * y + self.way.z * z
    }
}

impl Geometry {
    /// Springs and dashpots about axes.
    pub(super) fn rotaries_of(&self, symbolic: &Symbolic, samples: &[Figure]) -> Vec<Rotary> {
        let one = |torsion: &model::geometry::Torsion| {
            let frames = torsion.frames.map(|frame| frame.0);
            Rotary { joint: self.joint(frames, samples), axis: torsion.axis, action: torsion.action }
        };
        symbolic.torsions.iter().map(one).collect()
    }

    /// The joint of each torque.
    pub(super) fn couples_of(&self, symbolic: &Symbolic, samples: &[Figure]) -> Vec<Joint> {
        symbolic.couples.iter().map(|frames| self.joint(frames.map(|frame| frame.0), samples)).collect()
    }

    /// Where two frames turn beside each other.
    fn joint(&self, frames: [usize; 2], samples: &[Figure]) -> Joint {
        let shared = self.shared_place(frames).map(|place| Spot { place, way: Vector3::zeros(), frame: frames[0] });
        let at = shared.or_else(|| self.pivot(frames, samples));
        Joint { frames, at, bodies: frames.map(|frame| self.body_in(frame)) }
    }

    /// A place that is fixed in two frames, or that a constraint keeps at one in the other.
    fn shared_place(&self, frames: [usize; 2]) -> Option<usize> {
        let [first, second] = frames.map(|frame| self.fixed_in(frame));
        let shared = first.iter().copied().filter(|place| second.contains(place));
        let meet = |place: &usize| second.iter().any(|other| self.meets(*place, *other));
        shared.min_by_key(|place| self.names[*place].is_empty()).or_else(|| first.iter().copied().find(meet))
    }

    /// The place about which a frame turns in another: one that is fixed in both, else the centre of its body.
    pub(super) fn axle(&self, frames: [usize; 2]) -> Option<usize> {
        self.shared_place(frames).or_else(|| self.centre_in(frames[1]))
    }

    /// The point that is fixed in two frames, where they turn about one: a place of the first, and the way from there along its axes.
    ///
    ///   a + R p = b + S q  at every sample for some p and q,
    ///
    /// with places a, b that are fixed in the frames, whose axes are the columns of R, S. About one axis p and q are those that lie nearest.
    fn pivot(&self, frames: [usize; 2], samples: &[Figure]) -> Option<Spot> {
        let [one, other] = frames.map(|frame| self.anchor(frame));
        let (one, other) = (one?, other?);
        let mut matrix = DMatrix::zeros(3 * samples.len(), 6);
        let mut apart = DVector::zeros(3 * samples.len());
        for (number, at) in samples.iter().enumerate() {
            for axis in 0..3 {
                matrix.view_mut((3 * number, axis), (3, 1)).copy_from(&at.frames[frames[0]][axis]);
                matrix.view_mut((3 * number, 3 + axis), (3, 1)).copy_from(&-at.frames[frames[1]][axis]);
            }
            apart.rows_mut(3 * number, 3).copy_from(&(at.places[other] - at.places[one]));
        }
        let decomposed = matrix.clone().svd(true, true);
        let least = RANK * decomposed.singular_values.amax();
        // frames that keep an angle have no one point about which they turn
        if decomposed.rank(least) < 5 {
            return None;
        }
        let found = decomposed.solve(&apart, least).ok()?;
        let is_fixed = (matrix * &found - apart).amax() <= SAME * self.size;
        let way = Vector3::new(found[0], found[1], found[2]);
        is_fixed.then_some(Spot { place: one, way, frame: frames[0] })
    }

    /// A place that is fixed in a frame.
    fn anchor(&self, frame: usize) -> Option<usize> {
        self.centre_in(frame).or_else(|| self.fixed_in(frame).first().copied())
    }

    /// The centre of a body that turns with a frame.
    fn centre_in(&self, frame: usize) -> Option<usize> {
        self.centre(self.body_in(frame)?)
    }

    /// A body that turns with a frame.
    fn body_in(&self, frame: usize) -> Option<usize> {
        let turns = |body: &model::Body| body.frame.is_some_and(|own| self.turning[own.0] == self.turning[frame]);
        self.model.bodies.iter().position(turns).filter(|_| self.turning[frame] != 0)
    }

    /// The places that are fixed in a frame together.
    fn fixed_in(&self, frame: usize) -> Vec<usize> {
        match self.turning[frame] {
            0 => self.ground.clone(),
            turned => {
                self.links.iter().filter(|link| link.frame == turned).flat_map(|link| link.places.clone()).collect()
            }
        }
    }

    /// Whether two places are one at the start.
    fn meets(&self, one: usize, other: usize) -> bool {
        (self.at_start[one] - self.at_start[other]).norm() <= SAME * self.size
    }
}
