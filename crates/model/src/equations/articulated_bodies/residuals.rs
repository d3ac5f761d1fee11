//! Residuals of the equations of motion by recursion over the tree of bodies, for arbitrary accelerations z:
//!
//!   r = Q - (M z + h) .

use super::{ArticulatedBodies, Pair, Vector};
use crate::equations::{Equation, Solved};
use crate::principles::loads::by_energies;
use crate::trace::Trace;
use symbolic::Sym;

/// Returns the residuals without constraint reactions; `None` if the bodies do not form a tree, or if masses vary.
pub(crate) fn residuals(trace: &Trace<'_>) -> Option<Vec<Sym>> {
    ArticulatedBodies::of(trace).filter(|_| trace.solid().is_empty())?.residuals()
}

/// Returns accelerations and multipliers for the given generalised forces, with bodies at rest and without gravity.
pub(crate) fn answers(trace: &Trace<'_>, pushes: &[Sym], constraints: &[Equation]) -> Option<Solved> {
    let bodies = ArticulatedBodies::of(trace)?;
    let nothing = vec![Pair::ZERO; bodies.links.all.len()];
    Some(bodies.with_constraints(bodies.solve(pushes, nothing, Vector::ZERO), constraints))
}

impl ArticulatedBodies<'_, '_> {
    fn residuals(&self) -> Option<Vec<Sym>> {
        let (trace, links) = (self.trace, &self.links.all);
        let (mut wrenches, mut residuals) = self.loads()?;
        let gravity = trace.model.gravity.map_or(Vector::ZERO, |gravity| trace.vector(gravity));
        for (place, link) in links.iter().enumerate().filter(|_| !gravity.is_zero()) {
            let body = link.body.map(|body| &trace.model.bodies[body.0]);
            if let Some((mass, centre)) = body.and_then(|body| body.mass.zip(body.centre)) {
                let weight = gravity.map(|component| trace.scalar(mass) * component);
                let around = trace.cross(self.links.arm_to(link, centre), weight);
                self.add(&mut wrenches[place], place, [around, weight], -Sym::ONE);
            }
        }
        for (speed, residual) in residuals.iter_mut().enumerate() {
            *residual -= by_energies(trace, speed);
        }
        for (place, link) in links.iter().enumerate().rev() {
            let wrench = wrenches[place];
            for speed in &self.speeds[place] {
                residuals[speed.place] -= speed.direction.dot(&wrench);
            }
            if let Some(parent) = link.parent.filter(|_| !wrench.is_zero()) {
                wrenches[parent] = wrenches[parent].and(Sym::ONE, &self.down(link, parent, &wrench));
            }
        }
        Some(residuals)
    }
}
