//! The tree of bodies, determined by the points from which their centres of mass are defined.
//!
//! The definition of a centre of mass is a path of points to the origin. The first point on the path that is fixed in another body, or in the ground, connects
//! the body to this parent. The joint is the last point of the path, before the parent, that is still fixed in the body itself: the pin of a link,
//! or the centre of a cart on its rail. A body without a centre of mass is connected through the parents of its frame.
//! Loaded points and frames that belong to no body are massless links.

use crate::equations::vanishes;
use crate::{BodyId, FrameId, Material, Model, PointId, Trace, Vector};

/// A body, or a massless point or frame, with the joint to its parent.
#[derive(Clone, Debug)]
pub(super) struct Link {
    pub body: Option<BodyId>,
    pub frame: Option<FrameId>,
    pub centre: Option<PointId>,
    /// The index of the parent link; `None` for the ground.
    pub parent: Option<usize>,
    /// The point of the joint; `None` without a centre.
    pub joint: Option<PointId>,
}

/// All links, parents first.
pub(super) struct Tree<'t, 'm> {
    trace: &'t Trace<'m>,
    pub links: Vec<Link>,
}

impl<'t, 'm> Tree<'t, 'm> {
    /// Builds the tree of a model's bodies.
    pub fn of(trace: &'t Trace<'m>) -> Self {
        let model = trace.model;
        let mut order: Vec<BodyId> = (0..model.bodies.len()).map(BodyId).collect();
        // parents are nearer to the ground; a body without a centre of mass is no parent of one with a centre
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

    /// Adds a link with a centre.
    fn join(&mut self, body: Option<BodyId>, frame: Option<FrameId>, centre: PointId) -> usize {
        let link = Link { body, frame, centre: Some(centre), parent: None, joint: Some(centre) };
        let model = self.trace.model;
        let joint = path(model, centre).take_while(|&point| self.is_fixed(&link, point)).last();
        let parent = path(model, centre).find_map(|point| self.holding(point)).flatten();
        self.links.push(Link { parent, joint, ..link });
        self.links.len() - 1
    }

    /// Adds a link that only rotates.
    fn turn(&mut self, body: Option<BodyId>, frame: Option<FrameId>) -> usize {
        let parent =
            frame.and_then(|frame| above(self.trace.model, frame).skip(1).find_map(|above| self.turning_with(above)));
        self.links.push(Link { body, frame, centre: None, parent, joint: None });
        self.links.len() - 1
    }

    fn turning_with(&self, frame: FrameId) -> Option<usize> {
        self.links.iter().position(|link| link.frame == Some(frame))
    }

    /// Returns the first link in which a point is fixed: `Some(None)` for the ground, `None` if there is no such link.
    fn holding(&self, point: PointId) -> Option<Option<usize>> {
        if is_zero(self.trace.velocity(point)) {
            return Some(None);
        }
        let at_centre = self.links.iter().position(|link| link.centre == Some(point));
        at_centre.or_else(|| self.links.iter().position(|link| self.is_fixed(link, point))).map(Some)
    }

    /// Returns whether a point is fixed in a link.
    fn is_fixed(&self, link: &Link, point: PointId) -> bool {
        let Some(centre) = link.centre else { return false };
        let arm = self.trace.between(centre, point);
        centre == point || is_zero(link.frame.map_or(arm, |frame| self.trace.rate_seen(arm, frame)))
    }

    /// Returns the link on which a load at a point acts: the named body if it has a centre, otherwise the first link in which the point is fixed, otherwise a new
    /// link at the point. Returns `None` for the ground.
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

    /// Returns the link on which a torque on a frame acts; `None` for the ground.
    pub fn turned(&mut self, frame: FrameId) -> Option<usize> {
        if frame == FrameId::GROUND {
            return None;
        }
        Some(self.turning_with(frame).unwrap_or_else(|| self.turn(None, Some(frame))))
    }

    /// Returns the velocity of the point of a link that coincides with `point`.
    pub fn velocity(&self, link: Option<usize>, point: PointId) -> Vector {
        let Some(Link { frame, centre: Some(centre), .. }) = link.map(|link| &self.links[link]) else {
            return Vector::ZERO;
        };
        let arm = self.trace.between(*centre, point);
        let around = frame.map_or(Vector::ZERO, |frame| self.trace.cross(self.trace.turning(frame), arm));
        self.trace.sum(self.trace.velocity(*centre), around)
    }

    /// Returns the angular velocity of a link; zero for a particle.
    pub fn turning(&self, link: Option<usize>) -> Vector {
        link.and_then(|link| self.links[link].frame).map_or(Vector::ZERO, |frame| self.trace.turning(frame))
    }
}

/// Returns a point and the points from which it is defined, down to the origin.
fn path(model: &Model, point: PointId) -> impl Iterator<Item = PointId> + '_ {
    std::iter::successors(Some(point), |point| model.points[point.0].base.map(|(base, _)| base))
}

/// Returns a frame and its parents, down to the ground.
fn above(model: &Model, frame: FrameId) -> impl Iterator<Item = FrameId> + '_ {
    std::iter::successors(Some(frame), |frame| model.frames[frame.0].parent.map(|(parent, _)| parent))
}

fn is_zero(vector: Vector) -> bool {
    vector.components.into_iter().all(vanishes)
}
