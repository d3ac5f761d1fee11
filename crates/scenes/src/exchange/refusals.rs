//! Features of a system that cannot be exported as explicit equations with events.

use crate::compiled_system::of_accelerations;
use model::Model;
use reader::Issue;

/// An issue for the first feature that cannot be exported, with its position in the file; `None` if all can.
pub(super) fn refused(model: &Model) -> Option<Issue> {
    let only_run = "`dalembert run` runs this system";
    if let Some(open) = model.parameters.iter().find(|parameter| parameter.value.is_none()) {
        let title = format!("the parameter `{}` has no value", open.name);
        return Some(
            Issue::at(open.at.clone(), title, "a unit alone").accepted("a number with its unit, such as \"2 kg\""),
        );
    }
    if let Some(contact) = model.contacts.first() {
        let kind = if contact.one_way.is_some() { "a diode or a freewheel" } else { "a contact" };
        let title = format!(
            "a system with {kind} cannot be exported: its reaction follows from cases, not from explicit equations"
        );
        let accepted = "a smooth law of its own, such as a spring with a damper; a contact that stays in touch may be a constraint";
        return Some(Issue::at(contact.at.clone(), title, "this one").accepted(accepted));
    }
    let implicit = model.impulses.first().or(model.algebraic_speeds.first()).copied();
    let implicit = implicit.or(model.unsolved_law.as_ref().map(|(coordinate, _)| *coordinate));
    if let Some(coordinate) = implicit {
        let coordinate = &model.coordinates[coordinate];
        let title = match model.impulses.is_empty() {
            true => format!(
                "the law of `{}`, which has no inertia, changes: it is implicit in each of its cases",
                coordinate.name
            ),
            false => "a load or an event that holds a reaction is implicit: the reaction depends on itself".to_owned(),
        };
        let label = "explicit equations do not hold this";
        return Some(Issue::at(coordinate.at.clone(), title, label).accepted(only_run));
    }
    of_accelerations(model).map(|at| {
        let title = "a condition of accelerations or reactions is implicit: they depend on the case that it chooses";
        Issue::at(at, title, "this one").accepted("conditions of coordinates, speeds and time")
    })
}
