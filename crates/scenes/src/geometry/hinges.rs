//! Elements and torques about the axes of frames, each at the joint where it acts.

use super::Geometry;
use super::figure::Symbolic;
use model::geometry::Action;

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
    /// A place that is fixed in both, else the centre of the second; none where no place tells it.
    pub at: Option<usize>,
    /// A body that turns with the second frame, else with the first.
    pub body: Option<usize>,
}

impl Geometry {
    /// Springs and dashpots about axes.
    pub(super) fn rotaries_of(&self, symbolic: &Symbolic) -> Vec<Rotary> {
        let one = |torsion: &model::geometry::Torsion| {
            let frames = torsion.frames.map(|frame| frame.0);
            Rotary { joint: self.joint(frames), axis: torsion.axis, action: torsion.action }
        };
        symbolic.torsions.iter().map(one).collect()
    }

    /// The joint of each torque.
    pub(super) fn couples_of(&self, symbolic: &Symbolic) -> Vec<Joint> {
        symbolic.couples.iter().map(|frames| self.joint(frames.map(|frame| frame.0))).collect()
    }

    /// Where two frames turn beside each other.
    pub(super) fn joint(&self, frames: [usize; 2]) -> Joint {
        let [first, second] = frames.map(|frame| self.fixed_in(frame));
        let shared = first.iter().copied().filter(|place| second.contains(place));
        // two places that a constraint keeps together
        let meet = |place: &usize| second.iter().any(|other| self.meets(*place, *other));
        let at = shared.min_by_key(|place| self.names[*place].is_empty()).or_else(|| first.iter().copied().find(meet));
        let body = frames.iter().rev().find_map(|frame| self.body_in(*frame));
        Joint { frames, at: at.or_else(|| self.centre(self.body_in(frames[1])?)), body }
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
        (self.at_start[one] - self.at_start[other]).norm() <= 1e-6 * self.size
    }
}
