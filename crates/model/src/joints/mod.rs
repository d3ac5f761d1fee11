//! The Newton-Euler equations of every body, with the joint loads as unknowns.
//!
//! Let a body have the load F, T at its joint J from its parent, and let F_above, T_above be the loads that it exerts on its children at their joints. Then
//!
//!   m a_C     = F + sum F_given - sum F_above
//!   (I w)'    = T + (J - C) x F + sum (T_given + (P - C) x F_given) - sum (T_above + (J_above - C) x F_above)
//!
//! These are six equations for a body, three for a particle, and three rotational ones for a body without a centre of mass. Solved from the outermost bodies
//! inwards, they give every load. The reaction of a constraint is lambda times its wrench, with the sign convention M u' + h = J^T lambda.

mod tree;
mod wrenches;

use crate::equations::{constraints_of, held_of, vanishes};
use crate::principles::loads::{FrameTorque, PointForce, forces, torques};
use crate::{BodyId, PointId, Trace, Vector, Zero};
use symbolic::Sym;
use tree::{Link, Tree};
use wrenches::Wrench;

/// The load of a joint, exerted by the parent on the body.
#[derive(Clone, Copy, Debug)]
struct Load {
    /// The force in N.
    force: Vector,
    /// The torque about the joint in N m.
    torque: Vector,
}

/// All bodies with their joint loads.
pub(crate) struct Joints<'t, 'm> {
    trace: &'t Trace<'m>,
    tree: Tree<'t, 'm>,
    loads: Vec<Load>,
    /// For each multiplier, the coordinates that occur by name in its constraint, with the derivative of the constraint by each.
    along: Vec<(Sym, Vec<(usize, Sym)>)>,
}

impl<'t, 'm> Joints<'t, 'm> {
    /// Solves the equations of all bodies, from the outermost bodies inwards.
    pub fn of(trace: &'t Trace<'m>) -> Self {
        let mut tree = Tree::of(trace);
        let mut given: Vec<(Option<usize>, PointForce)> = Vec::new();
        let mut turning: Vec<(Option<usize>, FrameTorque)> = Vec::new();
        for force in forces(trace, false) {
            given.push((tree.bearer(force.at), force));
        }
        for torque in torques(trace) {
            turning.push((tree.turned(torque.on), torque));
        }
        let mut along = Vec::new();
        for (multiplier, wrench) in reactions(trace) {
            let scaled = |vector: Vector| vector.map(|component| multiplier * component);
            for (at, is) in wrench.forces {
                given.push((tree.bearer(at), PointForce { at, is: scaled(is) }));
            }
            for (on, is) in wrench.torques {
                turning.push((tree.turned(on), FrameTorque { on, is: scaled(is) }));
            }
            along.push((multiplier, wrench.along));
        }
        let mut joints = Joints { trace, tree, loads: Vec::new(), along };
        joints.solve(&given, &turning);
        joints
    }

    fn solve(&mut self, given: &[(Option<usize>, PointForce)], turning: &[(Option<usize>, FrameTorque)]) {
        let (trace, links) = (self.trace, &self.tree.links);
        let rest = Load { force: Vector::ZERO, torque: Vector::ZERO };
        self.loads = vec![rest; links.len()];
        let about = |joint: Option<PointId>, at: PointId, force: Vector| match joint {
            Some(joint) => trace.cross(trace.between(joint, at), force),
            None => Vector::ZERO,
        };
        let minus = |a: Vector, b: Vector| trace.sum(a, b.map(|component| -component));
        for (place, link) in links.iter().enumerate().rev() {
            let mut load = trace.sum_loads(self.loads[place], inertia(trace, link));
            for (_, PointForce { at, is }) in given.iter().filter(|(bearer, _)| *bearer == Some(place)) {
                load.force = minus(load.force, *is);
                load.torque = minus(load.torque, about(link.joint, at.point, *is));
            }
            for (_, FrameTorque { is, .. }) in turning.iter().filter(|(bearer, _)| *bearer == Some(place)) {
                load.torque = minus(load.torque, *is);
            }
            self.loads[place] = load;
            if let Some(parent) = link.parent {
                let moved = link.joint.map_or(Vector::ZERO, |joint| about(links[parent].joint, joint, load.force));
                let carried = Load { force: load.force, torque: trace.sum(load.torque, moved) };
                self.loads[parent] = trace.sum_loads(self.loads[parent], carried);
            }
        }
    }

    /// Returns the generalised force of all joint loads, per speed. It contains the reactions of constraints, and vanishes along every
    /// motion, except for generalised forces along coordinates.
    pub fn residual(&self) -> Vec<Sym> {
        let (trace, tree) = (self.trace, &self.tree);
        let minus = |a: Vector, b: Vector| trace.sum(a, b.map(|component| -component));
        let mut residual = vec![Sym::ZERO; trace.speeds.len()];
        for (place, (link, load)) in tree.links.iter().zip(&self.loads).enumerate() {
            let relative =
                link.joint.map(|joint| minus(tree.velocity(Some(place), joint), tree.velocity(link.parent, joint)));
            let turning = minus(tree.turning(Some(place)), tree.turning(link.parent));
            for (i, sum) in residual.iter_mut().enumerate() {
                if let Some(relative) = relative {
                    *sum += trace.dot(load.force, trace.vector_by_speed(relative, i));
                }
                *sum += trace.dot(load.torque, trace.vector_by_speed(turning, i));
            }
        }
        for (multiplier, along) in &self.along {
            for (coordinate, slope) in along {
                residual[*coordinate] -= *multiplier * *slope;
            }
        }
        residual
    }

    /// Returns the force, and the torque about the joint, that the parent exerts on a body. The force is `None` for a body without a centre of mass.
    pub fn load(&self, body: BodyId) -> (Option<Vector>, Vector) {
        let place = self.tree.links.iter().position(|link| link.body == Some(body));
        place.map_or((None, Vector::ZERO), |place| {
            let Load { force, torque } = self.loads[place];
            (self.tree.links[place].joint.map(|_| force), torque)
        })
    }

    /// Returns a coordinate that moves several joints and occurs by name in a constraint: it is then not determined at which joint the reaction
    /// acts.
    pub fn unplaced(&self) -> Option<usize> {
        let (trace, tree) = (self.trace, &self.tree);
        let moves = |coordinate: usize, place: usize| {
            let link = &tree.links[place];
            let parts = |link_place: Option<usize>| {
                let linear = link.joint.map_or(Vector::ZERO, |joint| tree.velocity(link_place, joint));
                [linear, tree.turning(link_place)]
            };
            let (own, below) = (parts(Some(place)), parts(link.parent));
            let relative = own.into_iter().zip(below);
            let slopes = relative.map(|(own, below)| {
                let slope = |vector| trace.vector_by_speed(vector, coordinate);
                trace.sum(slope(own), slope(below).map(|component| -component))
            });
            slopes.flat_map(|slope| slope.components).any(|component| !vanishes(component))
        };
        let letters = self.along.iter().flat_map(|(_, along)| along.iter().map(|(coordinate, _)| *coordinate));
        letters
            .into_iter()
            .find(|&coordinate| (0..tree.links.len()).filter(|&place| moves(coordinate, place)).count() > 1)
    }
}

/// Returns for every body with a centre of mass its parent body (`None` for the ground) and the point of its joint.
pub(crate) fn joints(trace: &Trace<'_>) -> Vec<(BodyId, Option<BodyId>, PointId)> {
    let links = Tree::of(trace).links;
    let of_link = |link: &Link| Some((link.body?, link.parent.and_then(|parent| links[parent].body), link.joint?));
    let mut joints: Vec<(BodyId, Option<BodyId>, PointId)> = links.iter().filter_map(of_link).collect();
    joints.sort_by_key(|(body, ..)| *body);
    joints
}

impl Trace<'_> {
    fn sum_loads(&self, a: Load, b: Load) -> Load {
        Load { force: self.sum(a.force, b.force), torque: self.sum(a.torque, b.torque) }
    }
}

/// Returns the inertial load m (a_C - g), and its torque about the joint plus (I w)'.
fn inertia(trace: &Trace<'_>, link: &Link) -> Load {
    let mut load = Load { force: Vector::ZERO, torque: Vector::ZERO };
    let Some(body) = link.body.map(|body| &trace.model.bodies[body.0]) else { return load };
    if let (Some((mass, _, acceleration)), Some(centre), Some(joint)) = (trace.carried(body), body.centre, link.joint) {
        let falling = trace.model.gravity.map_or(Vector::ZERO, |gravity| trace.vector(gravity));
        let felt = trace.sum(acceleration, falling.map(|component| -component));
        load.force = felt.map(|component| mass * component);
        load.torque = trace.cross(trace.between(joint, centre), load.force);
    }
    if let Some((inertia, turning)) = trace.turned(body) {
        let rate = trace.vector_rate(trace.inertia_times(inertia, turning));
        load.torque = trace.sum(load.torque, rate);
    }
    load
}

/// Returns, per multiplier and speed, the power of the reaction per unit of multiplier and speed, and the derivative of the constraint's rate by the speed. Both
/// must be equal. Returns `None` if a constraint has no reaction.
pub(crate) fn powers_of_reactions(trace: &Trace<'_>) -> Option<Vec<(Sym, Sym)>> {
    let wrenches = reactions(trace);
    let mut pairs = Vec::new();
    for constraint in constraints_of(trace) {
        let (_, wrench) = wrenches.iter().find(|(multiplier, _)| *multiplier == constraint.multiplier)?;
        for (i, &slope) in constraint.row.iter().enumerate() {
            let by_forces = wrench.forces.iter().map(|(at, is)| {
                let velocity = trace.material_velocity(*at);
                trace.dot(*is, trace.vector_by_speed(velocity, i))
            });
            let by_torques =
                wrench.torques.iter().map(|(on, is)| trace.dot(*is, trace.vector_by_speed(trace.turning(*on), i)));
            let by_name = wrench.along.iter().filter(|(coordinate, _)| *coordinate == i).map(|(_, slope)| *slope);
            let power = by_forces.chain(by_torques).chain(by_name).fold(Sym::ZERO, |sum, each| sum + each);
            pairs.push((power, slope));
        }
    }
    Some(pairs)
}

/// Returns the multiplier and the wrench of every scalar constraint equation.
fn reactions(trace: &Trace<'_>) -> Vec<(Sym, Wrench)> {
    let mut all = Vec::new();
    for (place, constraint) in trace.model.constraints.iter().enumerate() {
        for held in held_of(trace, place) {
            let level = trace.level_of(held.zero);
            let wrench = match (constraint.zero, held.axis) {
                (Zero::Scalar(zero), _) => wrenches::of_scalar(trace, zero, level),
                (Zero::Vector(zero), Some(axis)) => wrenches::along_axis(trace, zero, axis, level),
                (Zero::Vector(_), None) => Wrench::default(),
            };
            all.push((Trace::multiplier([place, held.component]), wrench));
        }
    }
    all
}
