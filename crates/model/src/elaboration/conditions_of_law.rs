//! Conditions that the law contains. Conditions in outputs only are replaced by step functions.

use super::parts::reached;
use crate::arena::{Part, Scalar};
use crate::{Energies, Inertia, Model, ScalarId, Trace, Turn, Zero};
use symbolic::{Sym, apart};

/// Removes the switches that the law does not contain.
pub(super) fn keep_those_of_law(model: &mut Model) {
    if model.switches.is_empty() {
        return;
    }
    let in_law = parts_of_law(model);
    let mut stays = vec![false; model.switches.len()];
    for (part, in_law) in model.arena.parts.iter().zip(in_law) {
        if let Part::Scalar(Scalar::Switch(switch, _)) = part {
            stays[*switch] |= in_law;
        }
    }
    for part in &mut model.arena.parts {
        if let Part::Scalar(Scalar::Switch(switch, at_zero)) = *part
            && !stays[switch]
        {
            *part = Part::Scalar(Scalar::Step(model.switches[switch], at_zero));
        }
    }
    let all: Vec<usize> = (0..stays.len()).collect();
    renumber(model, &all, &stays);
}

/// Gives switches with equal expressions, such as those of `x` and `x - 0`, one number: they have one letter, hence one case.
pub(super) fn share_equal(model: &mut Model) {
    // expressions that hold letters of equal switches are equal only once these are one
    while model.switches.len() > 1 {
        let first: Vec<usize> = apart(|| {
            let trace = Trace::of(model);
            let conditions: Vec<Sym> = model.switches.iter().map(|&switch| trace.scalar(switch)).collect();
            let first = |(place, is): (usize, &Sym)| conditions.iter().position(|known| known == is).unwrap_or(place);
            conditions.iter().enumerate().map(first).collect()
        });
        let stays: Vec<bool> = first.iter().enumerate().map(|(place, first)| place == *first).collect();
        if stays.iter().all(|stays| *stays) {
            return;
        }
        renumber(model, &first, &stays);
    }
}

/// Replaces each switch by another one, and keeps some of them.
fn renumber(model: &mut Model, by: &[usize], stays: &[bool]) {
    let left = |switch: usize| stays[..switch].iter().filter(|stays| **stays).count();
    for part in &mut model.arena.parts {
        if let Part::Scalar(Scalar::Switch(switch, at_zero)) = *part {
            *part = Part::Scalar(Scalar::Switch(left(by[switch]), at_zero));
        }
    }
    let mut kept = stays.iter();
    model.switches.retain(|_| kept.next() == Some(&true));
    let mut kept = stays.iter();
    model.switch_places.retain(|_| kept.next() == Some(&true));
    let mut kept = stays.iter();
    model.switch_units.retain(|_| kept.next() == Some(&true));
}

/// Returns for each node whether the motion depends on it: through bodies, frames, points, forces, constraints, contacts, events or
/// quasi-velocities.
fn parts_of_law(model: &Model) -> Vec<bool> {
    let mut open: Vec<usize> = Vec::new();
    let scalars = |ids: &[ScalarId], open: &mut Vec<usize>| open.extend(ids.iter().map(|id| id.0));
    for frame in &model.frames {
        if let Some((_, Turn::About { angle, .. })) = frame.parent {
            open.push(angle.0);
        }
    }
    open.extend(model.points.iter().filter_map(|point| point.base.map(|(_, way)| way.0)));
    for body in &model.bodies {
        open.extend(body.mass.map(|mass| mass.0));
        match &body.inertia {
            Some(Inertia::Axial(moment) | Inertia::OfShaft { moment, .. }) => open.push(moment.0),
            Some(Inertia::Tensor { entries, .. }) => open.extend(entries.iter().flatten().map(|entry| entry.0)),
            None => {}
        }
    }
    let Energies { kinetic, potential, dissipation, coenergy } = model.energies;
    let energies = [kinetic, potential, dissipation, coenergy];
    open.extend(model.gravity.map(|gravity| gravity.0));
    open.extend(energies.into_iter().flatten().map(|energy| energy.0));
    open.extend(model.forces.iter().map(|force| match force {
        crate::Force::On { is, .. } => is.0,
        crate::Force::Between { is, .. } => is.0,
    }));
    open.extend(model.torques.iter().map(|torque| match torque {
        crate::Torque::On { is, .. } | crate::Torque::Between { is, .. } => is.0,
    }));
    open.extend(model.generalised.iter().map(|force| force.is.0));
    open.extend(model.generalised.iter().filter_map(|force| match force.along {
        crate::Along::Expression(speed) => Some(speed.0),
        _ => None,
    }));
    for constraint in &model.constraints {
        open.push(match constraint.zero {
            Zero::Scalar(zero) => zero.0,
            Zero::Vector(zero) => zero.0,
        });
        scalars(constraint.gains.as_deref().unwrap_or_default(), &mut open);
    }
    for contact in &model.contacts {
        scalars(&[contact.gap], &mut open);
        scalars(&contact.slides, &mut open);
        open.extend(contact.friction.into_iter().chain(contact.restitution).map(|number| number.0));
    }
    for event in &model.events {
        open.push(event.when.0);
        open.extend(event.set.iter().map(|assignment| assignment.is.0));
    }
    open.extend(model.quasi_velocities.iter().map(|speed| speed.is.0));
    reached(model, open)
}
