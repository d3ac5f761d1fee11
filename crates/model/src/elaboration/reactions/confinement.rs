//! Checks that reactions do not occur where they have no meaning: in constraints, energies, inertias, quasi-velocities, assignments of events and gravity.

use super::ReactionLetter;
use crate::elaboration::Elaborator;
use crate::elaboration::parts::reached;
use crate::{Fault, Zero};
use std::ops::Range;

/// Returns the fault of an item that contains a reaction.
pub(super) fn fault(what: &str, at: Range<usize>) -> Fault {
    let accepted = "reactions in [[force]], [[torque]], [definitions] for these, [outputs], and `when` of [[event]]";
    Fault::at(at, format!("{what} holds a reaction"), "here", accepted)
}

impl Elaborator<'_> {
    /// Reports reactions in expressions that determine the motion and thereby the reactions themselves.
    pub(in crate::elaboration) fn confine_reactions(&mut self) {
        let letters: Vec<usize> = self.reaction_letters.iter().filter_map(|one| Some(one.letter?.0)).collect();
        let Some(ReactionLetter { at, .. }) = self.reaction_letters.first() else { return };
        if !self.faults.is_empty() {
            return;
        }
        let model = &self.model;
        let constraints = model.constraints.iter().flat_map(|constraint| {
            let (Zero::Scalar(crate::ScalarId(zero)) | Zero::Vector(crate::VectorId(zero))) = constraint.zero;
            let parts = constraint.gains.iter().flatten().map(|gain| gain.0).chain([zero]);
            parts.map(|part| ("a constraint", part, constraint.at.clone())).collect::<Vec<_>>()
        });
        let energies = [
            ("the kinetic energy", model.energies.kinetic),
            ("the potential energy", model.energies.potential),
            ("the dissipation", model.energies.dissipation),
            ("the co-energy", model.energies.coenergy),
        ];
        let energies = energies.into_iter().filter_map(|(what, energy)| Some((what, energy?.0, at.clone())));
        let masses = model.bodies.iter().flat_map(|body| {
            let inertia = crate::elaboration::rates::moments(body)
                .into_iter()
                .map(|id| ("an inertia", id.0, body.inertia_at.clone()));
            let mass = body.mass.map(|mass| ("a mass", mass.0, body.mass_at.clone()));
            mass.into_iter().chain(inertia).collect::<Vec<_>>()
        });
        let speeds = model.quasi_velocities.iter().map(|speed| ("a quasi-velocity", speed.is.0, speed.at.clone()));
        let set = model.events.iter().flat_map(|event| {
            let assigned = event.set.iter().map(|set| ("what an event sets", set.is.0, event.at.clone()));
            assigned.collect::<Vec<_>>()
        });
        let gravity = model.gravity.map(|gravity| ("gravity", gravity.0, at.clone()));
        let all = constraints.chain(energies).chain(masses).chain(speeds).chain(set).chain(gravity);
        let holds = |part: usize| {
            let held = reached(model, vec![part]);
            letters.iter().any(|&letter| held[letter])
        };
        let wrong = |(what, part, at): (&str, usize, Range<usize>)| holds(part).then(|| fault(what, at));
        let faults: Vec<Fault> = all.filter_map(wrong).collect();
        self.faults.extend(faults);
    }
}
