//! Newton's and Euler's equations of every body, with the loads of the joints between them as unknowns.
//!
//! A body, with the load F at its joint J from its parent, and those of the joints above it on itself, opposite, moves by
//!
//!   m a_C     = F + sum F_given - sum F_above
//!   (I w)'    = T + (J - C) x F + sum (T_given + (P - C) x F_given) - sum (T_above + (J_above - C) x F_above)
//!
//! six equations for a body, three for a particle, and of a body without a centre those of its turning alone. From the last bodies
//! down they give every load. The reaction of a constraint is lambda times its wrench, by the sign convention M u' + h = J^T lambda.

mod tree;
mod wrenches;

use crate::equations::{constraints_of, held_of, vanishes};
use crate::principles::loads::{FrameTorque, PointForce, forces, torques};
use crate::{BodyId, PointId, Trace, Vector, Zero};
use symbolic::Sym;
use tree::{Link, Tree};
use wrenches::Wrench;

/// The load that a joint carries: from the parent on the body.
#[derive(Clone, Copy, Debug)]
struct Load {
    /// Sum of forces.
    force: Vector,
    /// The torque of the forces about the joint.
    torque: Vector,
}

/// All bodies with the loads of their joints.
pub(crate) struct Joints<'t, 'm> {
    trace: &'t Trace<'m>,
    tree: Tree<'t, 'm>,
    loads: Vec<Load>,
    /// Symbol of each multiplier, and the coordinates along which it acts by name.
    along: Vec<(Sym, Vec<(usize, Sym)>)>,
}

impl<'t, 'm> Joints<'t, 'm> {
    /// Solves the equations of all bodies, from the last ones down.
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

    /// The power of all loads on the motions that the joints admit, per speed: with the reactions of constraints, and zero along
    /// every motion but for loads along coordinates.
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

    /// The force and, about the joint, the torque that the parent of a body exerts on it; the force is none without a centre.
    pub fn load(&self, body: BodyId) -> (Option<Vector>, Vector) {
        let place = self.tree.links.iter().position(|link| link.body == Some(body));
        place.map_or((None, Vector::ZERO), |place| {
            let Load { force, torque } = self.loads[place];
            (self.tree.links[place].joint.map(|_| force), torque)
        })
    }

    /// A coordinate that moves several joints and stands in a constraint as a letter: it is not determined on which of them its
    /// reaction acts.
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

/// Every body with a centre, the body that its joint hangs it on, none for the ground, and the place of the joint.
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

/// m (a_C - g), and its torque about the joint with that of the turning, (I w)'.
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

/// Pairs of the power of a reaction where it acts, per speed and multiplier, and the derivative of its constraint's rate by that speed, which
/// is equal to it; `None` if a constraint has no reaction of its own.
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

/// The multiplier of every scalar equation, with its wrench.
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
