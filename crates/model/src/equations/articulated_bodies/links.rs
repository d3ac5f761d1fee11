//! Links: bodies, and places without a mass between them, each after the one that it hangs on.
//!
//! Where the step from a place to another rests in the axes of a frame, both belong to one link with that frame. A body reaches from
//! its centre over such steps to its joint; the joint is a place of the link that carries it.

use super::places::{Place, Places, Step};
use crate::trace::{Trace, Vector};
use crate::{BodyId, FrameId, PointId, Turn};
use std::collections::HashMap;
use symbolic::Sym;

/// A link with the motion of its joint beside the link that carries it.
pub(super) struct Link {
    pub body: Option<BodyId>,
    /// The frame that turns with it; the ground's of a particle.
    pub frame: FrameId,
    /// The place whose velocity stands for the link's.
    pub joint: Place,
    /// None for the ground.
    pub parent: Option<usize>,
    /// Whether the link's turning is that of its parent and its own; else it is its own alone.
    pub is_carried: bool,
    /// The velocity of the joint beside the parent's place there, and the own turning.
    pub relative: [Vector; 2],
}

/// Links in their order.
pub(super) struct Links<'t, 'm> {
    trace: &'t Trace<'m>,
    places: Places<'t, 'm>,
    pub all: Vec<Link>,
    /// Links by a place that belongs to them.
    holders: HashMap<Place, Vec<usize>>,
}

impl<'t, 'm> Links<'t, 'm> {
    /// The links of all bodies.
    pub fn of(trace: &'t Trace<'m>) -> Self {
        let mut links = Links { trace, places: Places::of(trace), all: Vec::new(), holders: HashMap::new() };
        let mut order: Vec<usize> = (0..trace.model.bodies.len()).collect();
        let centre = |body: usize| trace.model.bodies[body].centre.map(|centre| links.places.of_point(centre));
        // a link stands after those that its joint belongs to: their places have fewer steps; bodies that only turn are carried by them
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

    /// The last place before the origin that belongs to a link with a frame and a place.
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

    /// Whether a step is not fixed in its frame.
    fn moves(&self, step: Step) -> bool {
        !self.velocity(step).is_zero()
    }

    /// A new link with a frame at a place.
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

    /// A new link of a body that only turns.
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

    /// The link that a joint belongs to, and the velocity of the joint there, along ways in the ground too.
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

    /// Whether a place stands still in the ground.
    fn is_at_rest(&self, place: Place) -> bool {
        let mut steps = self.places.path(place).filter_map(|place| self.places.step(place));
        steps.all(|step| step.way.frame == FrameId::GROUND && !self.moves(step))
    }

    /// The link that a point belongs to.
    pub fn holder(&self, point: PointId) -> Option<usize> {
        self.holder_of(self.places.of_point(point), FrameId::GROUND)
    }

    /// The link that a place belongs to; of several the one whose frame is the nearest above a frame.
    fn holder_of(&self, place: Place, frame: FrameId) -> Option<usize> {
        let above: Vec<FrameId> = std::iter::successors(Some(frame), |&frame| self.above(frame)).collect();
        let distance = |&place: &usize| above.iter().position(|above| *above == self.all[place].frame);
        self.holders_of(place).into_iter().min_by_key(|place| distance(place).unwrap_or(usize::MAX))
    }

    /// The links that a place belongs to: those that reach to it, and the one in whose frame its step rests.
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

    /// The own turning of a frame beside a link, and whether it is carried by that.
    fn turning(&self, frame: FrameId, parent: Option<usize>) -> (bool, Vector) {
        let beside = parent.map_or(FrameId::GROUND, |parent| self.all[parent].frame);
        let way: Vec<FrameId> = std::iter::successors(Some(frame), |&frame| self.above(frame)).collect();
        let is_carried = way.contains(&beside);
        let turns = way.into_iter().take_while(|frame| !is_carried || *frame != beside);
        let turning = turns.fold(Vector::ZERO, |sum, frame| self.trace.sum(self.turn_of(frame), sum));
        (is_carried, turning)
    }

    /// The angular velocity of a frame in the one that it turns in.
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

    /// The link of a body.
    pub fn of_body(&self, body: BodyId) -> Option<usize> {
        self.all.iter().position(|link| link.body == Some(body))
    }

    /// From the joint of the link that carries one to its own.
    pub fn arm(&self, link: &Link, parent: usize) -> Vector {
        self.places.between(self.all[parent].joint, link.joint)
    }

    /// From the joint of a link to a point.
    pub fn arm_to(&self, link: &Link, point: PointId) -> Vector {
        self.places.between(link.joint, self.places.of_point(point))
    }
}
