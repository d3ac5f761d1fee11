//! The articulated-body algorithm (Featherstone 1983): accelerations of bodies in a tree, by one recursion to the ground and one back. The
//! cost is proportional to the number of bodies, plus the cost of closed loops.
//!
//! A link moves with the twist V = (w, v) at its joint, V = A V_parent + sum s_i u_i, with its own speeds u_i. Its inertia I and those of its
//! children, as far as their own speeds transmit them, form the articulated-body inertia. An own speed with direction s changes it to
//!
//!   d = s . I s ,    I - I s s^T I/d ,
//!
//! and in the parent link it is A^T I A. This is the factorisation M = L D L^T without forming M. Forces are passed to the ground by the first
//! recursion, accelerations outwards by the second. Constraints add J M^-1 J^T, solved in an order that preserves sparsity.

mod inertia;
mod links;
mod places;
mod residuals;

pub(crate) use residuals::{answers, residuals};

use crate::Material;
use crate::equations::{Equation, Singular, Solved, constraints_of, solve_sparse};
use crate::principles::loads::{by_energies, forces, torques};
use crate::trace::{Trace, Vector};
use inertia::{Inertia, Pair};
use links::{Link, Links};
use std::collections::HashMap;
use symbolic::{Sym, substitute_all};

/// An own speed of a link: its index among all speeds, the direction s in which it moves the link, I s, and 1/d.
struct Speed {
    place: usize,
    direction: Pair,
    taken: Pair,
    inverse: Sym,
}

/// The factors of the mass matrix, link by link.
struct ArticulatedBodies<'t, 'm> {
    trace: &'t Trace<'m>,
    links: Links<'t, 'm>,
    /// The own speeds of each link, the last one first.
    speeds: Vec<Vec<Speed>>,
}

/// Solves for accelerations and multipliers; `None` if the bodies do not form a tree in which each speed moves one joint, or if masses vary.
pub(crate) fn solved(trace: &Trace<'_>) -> Option<Solved> {
    let bodies = ArticulatedBodies::of(trace)?;
    if !trace.solid().is_empty() {
        return None;
    }
    let at_rest: Vec<(Sym, Sym)> = trace.accelerations.iter().map(|&symbol| (symbol, Sym::ZERO)).collect();
    let (wrenches, mut pushes) = bodies.loads()?;
    let constraints = constraints_of(trace);
    pushes.iter_mut().enumerate().for_each(|(speed, push)| *push -= by_energies(trace, speed));
    let flat: Vec<Sym> = wrenches.iter().flat_map(|pair| pair.0.concat()).chain(pushes).collect();
    let none = constraints.iter().map(|one| (one.multiplier, Sym::ZERO));
    let flat = substitute_all(&flat, &at_rest.iter().copied().chain(none).collect::<Vec<_>>());
    let (wrenches, pushes) = flat.split_at(6 * wrenches.len());
    let pair = |six: &[Sym]| Pair([[six[0], six[1], six[2]], [six[3], six[4], six[5]]]);
    // weights are represented by an upward acceleration of the ground
    let ground = trace.model.gravity.map_or(Vector::ZERO, |gravity| trace.vector(gravity).map(|part| -part));
    let free = bodies.solve(pushes, wrenches.chunks_exact(6).map(pair).collect(), ground);
    Some(bodies.with_constraints(free, &constraints))
}

/// Returns whether the algorithm applies to a model.
pub(crate) fn are_of(trace: &Trace<'_>) -> bool {
    ArticulatedBodies::of(trace).is_some()
}

impl<'t, 'm> ArticulatedBodies<'t, 'm> {
    /// Factorises the mass matrix; `None` if the bodies do not form a tree, or a speed moves no mass.
    fn of(trace: &'t Trace<'m>) -> Option<Self> {
        let energies = &trace.model.energies;
        // a system given by energies has no links
        if energies.kinetic.is_some() || energies.coenergy.is_some() || trace.speeds.is_empty() {
            return None;
        }
        let links = Links::of(trace);
        let directions = directions(trace, &links)?;
        let mut inertias: Vec<Inertia> = links
            .all
            .iter()
            .map(|link| match link.body.map(|body| &trace.model.bodies[body.0]) {
                None => Inertia::none(link.frame),
                Some(body) => {
                    let arm = body.centre.map_or(Vector::ZERO, |centre| links.arm_to(link, centre));
                    Inertia::of(trace, body, link.frame, arm)
                }
            })
            .collect();
        let mut speeds: Vec<Vec<Speed>> = links.all.iter().map(|_| Vec::new()).collect();
        for (place, link) in links.all.iter().enumerate().rev() {
            let mut inertia = inertias[place];
            for &(speed, direction) in &directions[place] {
                let taken = inertia.times(&direction);
                let resistance = direction.dot(&taken);
                if resistance == Sym::ZERO || resistance == Sym::UNDEFINED {
                    return None;
                }
                let inverse = Sym::ONE / resistance;
                inertia = inertia.without(&taken, inverse);
                speeds[place].push(Speed { place: speed, direction, taken, inverse });
            }
            if let Some(parent) = link.parent {
                let arm = links.arm(link, parent);
                let felt = inertia.carried(trace, link.is_carried, (links.all[parent].frame, arm));
                inertias[parent] = inertias[parent].and(&felt);
            }
        }
        Some(ArticulatedBodies { trace, links, speeds })
    }

    /// Returns the wrench of each link at zero accelerations (inertia minus forces), and the generalised forces that act on no link.
    fn loads(&self) -> Option<(Vec<Pair>, Vec<Sym>)> {
        let trace = self.trace;
        let mut wrenches: Vec<Pair> = self.links.all.iter().map(|link| self.inertial(link)).collect();
        let mut pushes = vec![Sym::ZERO; trace.speeds.len()];
        for force in forces(trace, false) {
            match self.bearer(force.at) {
                Some(place) => {
                    let arm = self.links.arm_to(&self.links.all[place], force.at.point);
                    self.add(&mut wrenches[place], place, [trace.cross(arm, force.is), force.is], -Sym::ONE);
                }
                None => self.project(&mut pushes, trace.material_velocity(force.at), force.is),
            }
        }
        for torque in torques(trace) {
            match self.links.all.iter().position(|link| link.frame == torque.on) {
                Some(place) => self.add(&mut wrenches[place], place, [torque.is, Vector::ZERO], -Sym::ONE),
                None => self.project(&mut pushes, trace.turning(torque.on), torque.is),
            }
        }
        Some((wrenches, pushes))
    }

    /// Adds the generalised forces of a load: its power on the given velocity, per speed.
    fn project(&self, pushes: &mut [Sym], velocity: Vector, load: Vector) {
        for (speed, push) in pushes.iter_mut().enumerate() {
            *push += self.trace.dot(load, self.trace.vector_by_speed(velocity, speed));
        }
    }

    /// Returns the link on which a load at a point acts; `None` if there is none.
    fn bearer(&self, Material { body, point }: Material) -> Option<usize> {
        match body {
            Some(body) => self.links.of_body(body).filter(|_| self.trace.model.bodies[body.0].centre.is_some()),
            None => self.links.holder(point),
        }
    }

    /// Returns the inertial wrench about the joint: the torque from m a and the rate of the angular momentum, and the force m a of the centre of mass.
    fn inertial(&self, link: &Link) -> Pair {
        let trace = self.trace;
        let Some(body) = link.body.map(|body| &trace.model.bodies[body.0]) else { return Pair::ZERO };
        let mut all = [Vector::ZERO; 2];
        if let (Some((mass, _, acceleration)), Some(centre)) = (trace.carried(body), body.centre) {
            all[1] = acceleration.map(|component| mass * component);
            all[0] = trace.cross(self.links.arm_to(link, centre), all[1]);
        }
        if let Some((inertia, turning)) = trace.turned(body) {
            all[0] = trace.sum(all[0], trace.vector_rate(trace.inertia_times(inertia, turning)));
        }
        Pair(all.map(|vector| trace.express(vector, link.frame)))
    }

    fn add(&self, wrench: &mut Pair, place: usize, load: [Vector; 2], factor: Sym) {
        let frame = self.links.all[place].frame;
        *wrench = wrench.and(factor, &Pair(load.map(|vector| self.trace.express(vector, frame))));
    }

    /// Transforms a wrench from a link to its parent.
    fn down(&self, link: &Link, parent: usize, Pair([torque, force]): &Pair) -> Pair {
        let trace = self.trace;
        let [torque, force] = [torque, force].map(|all| Vector { frame: link.frame, components: *all });
        let around = trace.cross(self.links.arm(link, parent), force);
        let torque = if link.is_carried { trace.sum(torque, around) } else { around };
        Pair([torque, force].map(|vector| trace.express(vector, self.links.all[parent].frame)))
    }

    /// Transforms the twist of the parent to a link that is rigidly carried.
    fn up(&self, link: &Link, parent: usize, twist: &Pair) -> Pair {
        let (trace, Pair([turning, velocity])) = (self.trace, twist);
        if twist.is_zero() {
            return Pair::ZERO;
        }
        let frame = self.links.all[parent].frame;
        let [turning, velocity] = [turning, velocity].map(|all| Vector { frame, components: *all });
        let velocity = trace.sum(velocity, trace.cross(turning, self.links.arm(link, parent)));
        let turning = if link.is_carried { turning } else { Vector::ZERO };
        Pair([turning, velocity].map(|vector| trace.express(vector, link.frame)))
    }

    /// Returns M^-1 (pushes - the generalised forces of the wrenches), with the given acceleration of the ground.
    fn solve(&self, pushes: &[Sym], mut wrenches: Vec<Pair>, ground: Vector) -> Vec<Sym> {
        let links = &self.links.all;
        let mut found = pushes.to_vec();
        for (place, link) in links.iter().enumerate().rev() {
            let mut wrench = wrenches[place];
            for speed in &self.speeds[place] {
                let left = (found[speed.place] - speed.direction.dot(&wrench)) * speed.inverse;
                found[speed.place] = left;
                wrench = wrench.and(left, &speed.taken);
            }
            if let Some(parent) = link.parent.filter(|_| !wrench.is_zero()) {
                wrenches[parent] = wrenches[parent].and(Sym::ONE, &self.down(link, parent, &wrench));
            }
        }
        let mut twists: Vec<Pair> = Vec::with_capacity(links.len());
        for (place, link) in links.iter().enumerate() {
            let mut twist = match link.parent {
                Some(parent) => self.up(link, parent, &twists[parent]),
                None => Pair([Vector::ZERO, ground].map(|vector| self.trace.express(vector, link.frame))),
            };
            for speed in self.speeds[place].iter().rev() {
                let value = found[speed.place] - speed.taken.dot(&twist) * speed.inverse;
                found[speed.place] = value;
                twist = twist.and(value, &speed.direction);
            }
            twists.push(twist);
        }
        found
    }

    /// Returns accelerations and multipliers, from the accelerations `free` without constraints.
    fn with_constraints(&self, free: Vec<Sym>, constraints: &[Equation]) -> Solved {
        if constraints.is_empty() {
            return Ok((free, Vec::new()));
        }
        let nothing = || vec![Pair::ZERO; self.links.all.len()];
        let moved: Vec<Vec<Sym>> =
            constraints.iter().map(|one| self.solve(&one.row, nothing(), Vector::ZERO)).collect();
        let dot = |a: &[Sym], b: &[Sym]| a.iter().zip(b).fold(Sym::ZERO, |sum, (&a, &b)| sum + a * b);
        let matrix: Vec<Vec<Sym>> =
            constraints.iter().map(|one| moved.iter().map(|column| dot(&one.row, column)).collect()).collect();
        let right: Vec<Sym> = constraints.iter().map(|one| -(one.bias + dot(&one.row, &free))).collect();
        let multipliers = solve_sparse(&matrix, &right).map_err(|constraint| Singular::Redundant { constraint })?;
        let accelerations = (0..free.len())
            .map(|i| moved.iter().zip(&multipliers).fold(free[i], |sum, (column, &lambda)| sum + column[i] * lambda))
            .collect();
        Ok((accelerations, multipliers))
    }
}

/// Returns the directions in which its own speeds move each link, the last speed first; `None` if a speed moves several joints, or none.
fn directions(trace: &Trace<'_>, links: &Links<'_, '_>) -> Option<Vec<Vec<(usize, Pair)>>> {
    let places: HashMap<Sym, usize> = trace.speeds.iter().enumerate().map(|(place, speed)| (*speed, place)).collect();
    let mut is_owned = vec![false; trace.speeds.len()];
    let mut all = Vec::new();
    for link in &links.all {
        let [velocity, turning] = link.relative;
        let components = [turning, velocity].map(|vector| trace.express(vector, link.frame));
        let letters = components.concat().into_iter().flat_map(Sym::symbols_of);
        let mut own: Vec<usize> = letters.filter_map(|symbol| places.get(&symbol).copied()).collect();
        own.sort_unstable();
        own.dedup();
        let mut directions = Vec::new();
        for speed in own {
            if std::mem::replace(&mut is_owned[speed], true) {
                return None;
            }
            let direction = Pair(components.map(|half| half.map(|component| trace.by_speed(component, speed))));
            let is_bent = |part: &Sym| part.symbols_of().iter().any(|one| places.contains_key(one));
            if direction.is_zero() || direction.0.concat().iter().any(is_bent) {
                return None;
            }
            directions.push((speed, direction));
        }
        directions.reverse();
        all.push(directions);
    }
    is_owned.into_iter().all(|owned| owned).then_some(all)
}
