//! Joints at which torsion springs, rotary dashpots and torques act.

use super::Geometry;
use super::figure::{Figure, Symbolic};
use model::geometry::Action;
use nalgebra::{DMatrix, DVector, Vector3};

/// Singular values below this part of the largest count as zero.
const RANK: f64 = 1e-9;

/// Points whose distance is below this part of the size of the system coincide.
const SAME: f64 = 1e-6;

/// A torsion spring or a rotary dashpot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotary {
    /// The joint where it acts.
    pub joint: Joint,
    /// The index of the common axis of both frames: 0, 1, 2 for x, y, z.
    pub axis: usize,
    /// A spring or a dashpot.
    pub action: Action,
}

/// A joint: two frames that rotate relative to each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Indices of the frames.
    pub frames: [usize; 2],
    /// The point that is fixed in both frames, if there is one.
    pub at: Option<Spot>,
    /// The bodies that turn with the frames; `None` for the ground.
    pub bodies: [Option<usize>; 2],
}

/// A point that is fixed in a frame: position of a point of the model plus a vector in the axes of the frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// The index of the point of the model.
    pub place: usize,
    /// The vector from that point, m, in the axes of `frame`.
    pub way: Vector3<f64>,
    /// The index of the frame.
    pub frame: usize,
}

impl Spot {
    /// The position of the point in a figure, m.
    pub fn in_figure(&self, figure: &Figure) -> Vector3<f64> {
        let [x, y, z] = figure.frames[self.frame];
        figure.places[self.place] + self.way.x * x + self.way.y * y + self.way.z * z
    }
}

impl Geometry {
    /// All torsion springs and rotary dashpots.
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

    /// The joint of two frames.
    fn joint(&self, frames: [usize; 2], samples: &[Figure]) -> Joint {
        let shared = self.shared_place(frames).map(|place| Spot { place, way: Vector3::zeros(), frame: frames[0] });
        let at = shared.or_else(|| self.pivot(frames, samples));
        Joint { frames, at, bodies: frames.map(|frame| self.body_in(frame)) }
    }

    /// A point that is fixed in both frames, or fixed in the first and coincident at the start with a point of the second.
    fn shared_place(&self, frames: [usize; 2]) -> Option<usize> {
        let [first, second] = frames.map(|frame| self.fixed_in(frame));
        let shared = first.iter().copied().filter(|place| second.contains(place));
        let meet = |place: &usize| second.iter().any(|other| self.meets(*place, *other));
        shared.min_by_key(|place| self.names[*place].is_empty()).or_else(|| first.iter().copied().find(meet))
    }

    /// The centre of rotation of a frame relative to another: the point fixed in both, else the centre of its body.
    pub(super) fn axle(&self, frames: [usize; 2]) -> Option<usize> {
        self.shared_place(frames).or_else(|| self.centre_in(frames[1]))
    }

    /// The point that is fixed in two frames, if there is one: a point a of the first, plus a vector p in its axes. Least squares for
    ///
    ///   a + R p = b + S q  at every sample,
    ///
    /// where the points a, b are fixed in the frames, whose axes are the columns of R, S. For a rotation about an axis the solution is
    /// the one of least norm.
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
        // frames without relative rotation have no centre of rotation; rank 5 is rotation about an axis
        if decomposed.rank(least) < 5 {
            return None;
        }
        let found = decomposed.solve(&apart, least).ok()?;
        let is_fixed = (matrix * &found - apart).amax() <= SAME * self.size;
        let way = Vector3::new(found[0], found[1], found[2]);
        is_fixed.then_some(Spot { place: one, way, frame: frames[0] })
    }

    /// A point that is fixed in a frame: the centre of a body if possible.
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

    /// All points that are fixed in a frame.
    fn fixed_in(&self, frame: usize) -> Vec<usize> {
        match self.turning[frame] {
            0 => self.ground.clone(),
            turned => {
                self.links.iter().filter(|link| link.frame == turned).flat_map(|link| link.places.clone()).collect()
            }
        }
    }

    /// True if two points coincide at the start.
    fn meets(&self, one: usize, other: usize) -> bool {
        (self.at_start[one] - self.at_start[other]).norm() <= SAME * self.size
    }
}
