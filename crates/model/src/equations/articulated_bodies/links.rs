//! Links of the tree: bodies, and massless points between them. Parents precede their children.
//!
//! If the displacement between two points is constant in the axes of a frame, both points belong to one link with that frame. A body extends from
//! its centre of mass over such displacements to its joint; the joint is a point of the parent link.

use super::places::{Place, Places, Step};
use crate::trace::{Trace, Vector};
use crate::{BodyId, FrameId, PointId, Turn};
use std::collections::HashMap;
use symbolic::Sym;

/// A link, and the motion of its joint relative to the parent link.
pub(super) struct Link {
    pub body: Option<BodyId>,
    /// The frame in which the link is fixed; the ground's frame for a particle.
    pub frame: FrameId,
    /// The reference point of the link.
    pub joint: Place,
    /// The index of the parent link; `None` for the ground.
    pub parent: Option<usize>,
    /// Whether the angular velocity of the link is that of its parent plus its own; otherwise it is only its own.
    pub is_carried: bool,
    /// The velocity of the joint relative to the parent link, and the own angular velocity.
    pub relative: [Vector; 2],
}

/// The links, parents first.
pub(super) struct Links<'t, 'm> {
    trace: &'t Trace<'m>,
    places: Places<'t, 'm>,
    pub all: Vec<Link>,
    /// For each point, the links to which it belongs.
    holders: HashMap<Place, Vec<usize>>,
}

impl<'t, 'm> Links<'t, 'm> {
    /// Builds the links of all bodies.
    pub fn of(trace: &'t Trace<'m>) -> Self {
        let mut links = Links { trace, places: Places::of(trace), all: Vec::new(), holders: HashMap::new() };
        let mut order: Vec<usize> = (0..trace.model.bodies.len()).collect();
        let centre = |body: usize| trace.model.bodies[body].centre.map(|centre| links.places.of_point(centre));
        // sorted by the number of displacements to the centre of mass, so that parents precede children; bodies without a centre of mass come last
        order.sort_by_cached_key(|&body| {
            let steps = centre(body).map(|centre| links.places.path(centre).count());
            (steps.is_none(), steps, body)
        });
        for body in order {
            let known = &trace.model.bodies[body];
            match known.centre {
                Some(centre) => {
                    let centre = links.places.of_point(centre);
                    links.join(Some(BodyId(body)), known.frame.unwrap_or(FrameId::GROUND), centre)
                }
                None => links.turn(BodyId(body), known.frame.unwrap_or(FrameId::GROUND)),
            };
        }
        links
    }

    /// Returns the joint of a link: the last point on the way to the origin that is fixed in the link's frame.
    fn joint(&self, frame: FrameId, place: Place) -> Place {
        let mut joint = place;
        while let Some(step) = self.places.step(joint) {
            if step.way.frame != frame || frame == FrameId::GROUND || self.moves(step) {
                break;
            }
            joint = step.from;
        }
        joint
    }

    fn velocity(&self, step: Step) -> Vector {
        step.way.map(|component| self.trace.rate_of(component))
    }

    /// Returns whether a displacement varies in its frame.
    fn moves(&self, step: Step) -> bool {
        !self.velocity(step).is_zero()
    }

    /// Adds a link with a frame and a point.
    fn join(&mut self, body: Option<BodyId>, frame: FrameId, at: Place) -> usize {
        let joint = self.joint(frame, at);
        let (parent, velocity) = self.carried(joint, frame);
        let (is_carried, turning) = self.turning(frame, parent);
        let link = Link { body, frame, joint, parent, is_carried, relative: [velocity, turning] };
        let place = self.all.len();
        self.all.push(link);
        let own: Vec<Place> = self.places.path(at).take_while(|&own| own != joint).chain([joint]).collect();
        own.into_iter().for_each(|own| self.holders.entry(own).or_default().push(place));
        place
    }

    /// Adds a link for a body that only rotates.
    fn turn(&mut self, body: BodyId, frame: FrameId) -> usize {
        let above = std::iter::successors(Some(frame), |&frame| self.above(frame));
        let mut above = above.take_while(|above| *above != FrameId::GROUND);
        let parent = above.find_map(|above| self.all.iter().position(|link| link.frame == above));
        let joint = parent.map_or(Places::ORIGIN, |parent: usize| self.all[parent].joint);
        let (is_carried, turning) = self.turning(frame, parent);
        self.all.push(Link { body: Some(body), frame, joint, parent, is_carried, relative: [Vector::ZERO, turning] });
        self.all.len() - 1
    }

    fn above(&self, frame: FrameId) -> Option<FrameId> {
        self.trace.model.frames[frame.0].parent.map(|(parent, _)| parent)
    }

    /// Returns the parent link of a joint, and the velocity of the joint relative to it.
    fn carried(&mut self, joint: Place, frame: FrameId) -> (Option<usize>, Vector) {
        let (mut at, mut velocity) = (joint, Vector::ZERO);
        loop {
            if self.is_at_rest(at) {
                return (None, velocity);
            }
            if let Some(holder) = self.holder_of(at, frame) {
                return (Some(holder), velocity);
            }
            let Some(step) = self.places.step(at) else { return (None, velocity) };
            velocity = self.trace.sum(velocity, self.velocity(step));
            let (own, holders) = (step.way.frame, self.holders_of(step.from));
            if own == FrameId::GROUND && holders.is_empty() {
                at = step.from;
                continue;
            }
            let holder = holders.into_iter().find(|&known| self.all[known].frame == own);
            return (Some(holder.unwrap_or_else(|| self.join(None, own, step.from))), velocity);
        }
    }

    /// Returns whether a point is fixed in the ground.
    fn is_at_rest(&self, place: Place) -> bool {
        let mut steps = self.places.path(place).filter_map(|place| self.places.step(place));
        steps.all(|step| step.way.frame == FrameId::GROUND && !self.moves(step))
    }

    /// Returns the link to which a point belongs.
    pub fn holder(&self, point: PointId) -> Option<usize> {
        self.holder_of(self.places.of_point(point), FrameId::GROUND)
    }

    /// Returns the link to which a point belongs; among several, the one whose frame is the nearest ancestor of `frame`.
    fn holder_of(&self, place: Place, frame: FrameId) -> Option<usize> {
        let above: Vec<FrameId> = std::iter::successors(Some(frame), |&frame| self.above(frame)).collect();
        let distance = |&place: &usize| above.iter().position(|above| *above == self.all[place].frame);
        self.holders_of(place).into_iter().min_by_key(|place| distance(place).unwrap_or(usize::MAX))
    }

    /// Returns the links to which a point belongs: those that extend to it, and the one in whose frame its displacement is constant.
    fn holders_of(&self, place: Place) -> Vec<usize> {
        let mut all = self.holders.get(&place).cloned().unwrap_or_default();
        if let Some(step) =
            self.places.step(place).filter(|step| step.way.frame != FrameId::GROUND && !self.moves(*step))
        {
            let own = |&link: &usize| self.all[link].frame == step.way.frame;
            all.extend(self.holders_of(step.from).into_iter().filter(own));
        }
        all
    }

    /// Returns whether a frame is carried by the parent link, and the angular velocity that it adds.
    fn turning(&self, frame: FrameId, parent: Option<usize>) -> (bool, Vector) {
        let beside = parent.map_or(FrameId::GROUND, |parent| self.all[parent].frame);
        let way: Vec<FrameId> = std::iter::successors(Some(frame), |&frame| self.above(frame)).collect();
        let is_carried = way.contains(&beside);
        let turns = way.into_iter().take_while(|frame| !is_carried || *frame != beside);
        let turning = turns.fold(Vector::ZERO, |sum, frame| self.trace.sum(self.turn_of(frame), sum));
        (is_carried, turning)
    }

    /// Returns the angular velocity of a frame relative to its parent frame.
    fn turn_of(&self, frame: FrameId) -> Vector {
        let trace = self.trace;
        let mut components = [Sym::ZERO; 3];
        match trace.model.frames[frame.0].parent {
            None => {}
            Some((_, Turn::About { axis, angle })) => components[axis] = trace.rate_of(trace.scalar(angle)),
            Some((_, Turn::Free { number })) => {
                let first = trace.model.free_speed(number);
                components = std::array::from_fn(|axis| trace.speeds[first + axis]);
            }
        }
        Vector { frame, components }
    }

    /// Returns the link of a body.
    pub fn of_body(&self, body: BodyId) -> Option<usize> {
        self.all.iter().position(|link| link.body == Some(body))
    }

    /// Returns the vector from the joint of the parent to the joint of a link.
    pub fn arm(&self, link: &Link, parent: usize) -> Vector {
        self.places.between(self.all[parent].joint, link.joint)
    }

    /// Returns the vector from the joint of a link to a point.
    pub fn arm_to(&self, link: &Link, point: PointId) -> Vector {
        self.places.between(link.joint, self.places.of_point(point))
    }
}
