//! The tree of bodies, by the paths of points on which their centres are found.
//!
//! From the centre of a body its path leads over the points that it is found from to the origin. The first point there that is fixed
//! in another body, or in the ground, joins it to that: its parent. The joint stands at the last point of the path before that at
//! which the body is itself still fixed: the pin of a link, the centre of a cart on its rail. A body without a centre is joined by
//! the frames that its own frame turns in. Points and frames that carry a load and belong to no body are links without a mass.

use crate::equations::vanishes;
use crate::{BodyId, FrameId, Material, Model, PointId, Trace, Vector};

/// A body, or a point or a frame without a mass, with the joint to its parent.
#[derive(Clone, Debug)]
pub(super) struct Link {
    pub body: Option<BodyId>,
    pub frame: Option<FrameId>,
    pub centre: Option<PointId>,
    /// None for the ground.
    pub parent: Option<usize>,
    /// The place of the joint; none without a centre.
    pub joint: Option<PointId>,
}

/// All links, each after its parent.
pub(super) struct Tree<'t, 'm> {
    trace: &'t Trace<'m>,
    pub links: Vec<Link>,
}

impl<'t, 'm> Tree<'t, 'm> {
    /// The bodies of a model.
    pub fn of(trace: &'t Trace<'m>) -> Self {
        let model = trace.model;
        let mut order: Vec<BodyId> = (0..model.bodies.len()).map(BodyId).collect();
        // a parent stands nearer to the ground; those without a centre are parents of none that has one
        order.sort_by_key(|body| {
            let frame = model.bodies[body.0].frame.map_or(0, |frame| above(model, frame).count());
            let centre = model.bodies[body.0].centre.map(|centre| path(model, centre).count());
            (centre.is_none(), centre, frame, *body)
        });
        let mut tree = Tree { trace, links: Vec::new() };
        for body in order {
            let known = &model.bodies[body.0];
            match known.centre {
                Some(centre) => tree.join(Some(body), known.frame, centre),
                None => tree.turn(Some(body), known.frame),
            };
        }
        tree
    }

    /// A new link at a centre.
    fn join(&mut self, body: Option<BodyId>, frame: Option<FrameId>, centre: PointId) -> usize {
        let link = Link { body, frame, centre: Some(centre), parent: None, joint: Some(centre) };
        let model = self.trace.model;
        let joint = path(model, centre).take_while(|&point| self.is_fixed(&link, point)).last();
        let parent = path(model, centre).find_map(|point| self.holding(point)).flatten();
        self.links.push(Link { parent, joint, ..link });
        self.links.len() - 1
    }

    /// A new link that only turns.
    fn turn(&mut self, body: Option<BodyId>, frame: Option<FrameId>) -> usize {
        let parent =
            frame.and_then(|frame| above(self.trace.model, frame).skip(1).find_map(|above| self.turning_with(above)));
        self.links.push(Link { body, frame, centre: None, parent, joint: None });
        self.links.len() - 1
    }

    fn turning_with(&self, frame: FrameId) -> Option<usize> {
        self.links.iter().position(|link| link.frame == Some(frame))
    }

    /// The first link in which a point is fixed; the inner none stands for the ground, the outer for no link at all.
    fn holding(&self, point: PointId) -> Option<Option<usize>> {
        if is_zero(self.trace.velocity(point)) {
            return Some(None);
        }
        let at_centre = self.links.iter().position(|link| link.centre == Some(point));
        at_centre.or_else(|| self.links.iter().position(|link| self.is_fixed(link, point))).map(Some)
    }

    /// Whether a point moves with a link.
    fn is_fixed(&self, link: &Link, point: PointId) -> bool {
        let Some(centre) = link.centre else { return false };
        let arm = self.trace.between(centre, point);
        centre == point || is_zero(link.frame.map_or(arm, |frame| self.trace.rate_seen(arm, frame)))
    }

    /// The link that a load at a point acts on: the body that is named, which carries its points, else the first that the point is fixed
    /// in, else one of the point's own; none for the ground.
    pub fn bearer(&mut self, Material { body, point }: Material) -> Option<usize> {
        let named = self.links.iter().position(|link| link.body.is_some() && link.body == body);
        if let Some(named) = named.filter(|&named| self.links[named].centre.is_some()) {
            return Some(named);
        }
        match self.holding(point) {
            Some(held) => held,
            None => Some(self.join(None, None, point)),
        }
    }

    /// The link that a torque on a frame acts on; none for the ground.
    pub fn turned(&mut self, frame: FrameId) -> Option<usize> {
        if frame == FrameId::GROUND {
            return None;
        }
        Some(self.turning_with(frame).unwrap_or_else(|| self.turn(None, Some(frame))))
    }

    /// The velocity of a link at a point.
    pub fn velocity(&self, link: Option<usize>, point: PointId) -> Vector {
        let Some(Link { frame, centre: Some(centre), .. }) = link.map(|link| &self.links[link]) else {
            return Vector::ZERO;
        };
        let arm = self.trace.between(*centre, point);
        let around = frame.map_or(Vector::ZERO, |frame| self.trace.cross(self.trace.turning(frame), arm));
        self.trace.sum(self.trace.velocity(*centre), around)
    }

    /// The angular velocity of a link; none of a particle.
    pub fn turning(&self, link: Option<usize>) -> Vector {
        link.and_then(|link| self.links[link].frame).map_or(Vector::ZERO, |frame| self.trace.turning(frame))
    }
}

/// A point and those that it is found from, to the origin.
fn path(model: &Model, point: PointId) -> impl Iterator<Item = PointId> + '_ {
    std::iter::successors(Some(point), |point| model.points[point.0].base.map(|(base, _)| base))
}

/// A frame and those that it turns in, to the ground.
fn above(model: &Model, frame: FrameId) -> impl Iterator<Item = FrameId> + '_ {
    std::iter::successors(Some(frame), |frame| model.frames[frame.0].parent.map(|(parent, _)| parent))
}

fn is_zero(vector: Vector) -> bool {
    vector.components.into_iter().all(vanishes)
}
