//! The reasons for which steady motions are not searched for, with their places in the file.

use super::steady_box::number;
use crate::exit::{Exit, placed};
use ::scenes::steady_motions::NoSteadyMotions;
use ::scenes::without_law;
use model::{Entry, Model, Source, Text};
use reader::Issue;
use std::ops::Range;
use std::path::Path;

/// The refusal of a search in a system, with the place in its source.
pub fn refused(path: &Path, (model, source): (&Model, Option<&Source>), why: NoSteadyMotions) -> Exit {
    unsought(path, reason(model, source, why))
}

/// The refusal for a fault of the system, shown at its place in the file, or for a fault of the options.
pub(super) fn unsought(path: &Path, issue: Issue) -> Exit {
    match issue.span {
        Some(_) => placed(path, issue),
        None => Exit::refused(format!("{}: {}", path.display(), issue.title)),
    }
}

/// The reason for a refusal, with its place in the text where it has one.
pub fn reason(model: &Model, source: Option<&Source>, why: NoSteadyMotions) -> Issue {
    let told = |why: String| Issue { span: None, title: why, label: String::new(), help: None };
    match why {
        NoSteadyMotions::At { values, why } => {
            let at: Vec<String> = values.iter().map(|(name, value)| format!("{name} = {}", number(*value))).collect();
            let issue = reason(model, source, *why);
            Issue { title: format!("at {}: {}", at.join(", "), issue.title), ..issue }
        }
        NoSteadyMotions::NotCompiled(reason) => without_law(model, &reason, "steady motions cannot be sought"),
        NoSteadyMotions::OfSpeeds { at } => {
            let label = "it depends on speeds nonlinearly, or is stabilised by gains";
            Issue::at(at, "steady motions are not sought with this constraint", label).accepted(format!(
                "constraints of positions, and up to six that are linear in the speeds, quasi-velocities among them; {NEAR}"
            ))
        }
        NoSteadyMotions::Changes => told(format!(
            "some of its speeds have no inertia, and equations of their own determine them: steady motions are not sought there; {NEAR}"
        )),
        NoSteadyMotions::Contacts { at } => {
            let label = "a diode, a freewheel, a guide that the coordinates keep, or a contact that slides in two directions or on two sides";
            Issue::at(at, "steady motions are not sought with this contact", label).accepted(format!(
                "contacts that coordinates can open, and friction as a force with `sign` of a speed; {NEAR}"
            ))
        }
        NoSteadyMotions::ManyConditions { conditions, most } => told(format!(
            "its law has {conditions} conditions, which have more than {most} combinations of cases; fewer conditions are accepted"
        )),
        NoSteadyMotions::FreeFrame { why } => told(format!(
            "a frame turns freely, and steady motions are not sought here: {why}; a frame with an axis, or with three angles, is accepted"
        )),
        NoSteadyMotions::OfTime => of_time(source),
        NoSteadyMotions::Singular => told("no coordinate moves a mass or an inertia".to_owned()),
        NoSteadyMotions::Empty { coordinate } => told(format!(
            "neither inertia nor a force belongs to `{coordinate}`, so that its equation of motion is 0 = 0; other values of the parameters, or a \
             range that leaves these out, are accepted"
        )),
        NoSteadyMotions::Undefined { why } => told(format!("its equations have no values: {why}")),
        NoSteadyMotions::Unknown { name, nearest, accepted } => told(unknown(&name, nearest, &accepted)),
        NoSteadyMotions::Sought { name, value } => {
            let aside = 0.01 * if value == 0.0 { 1.0 } else { value.abs() };
            told(format!(
                "one value of `{name}`, {}, is not accepted: an equation determines `{name}`, and a number meets it only to rounding; a range is \
                 accepted (--range \"{name}={}..{}\"), and --along over a parameter",
                number(value),
                number(value - aside),
                number(value + aside)
            ))
        }
        NoSteadyMotions::WithoutRange { names } => {
            let options: Vec<String> = names.iter().map(|name| format!("--range \"{name}=-1..1\"")).collect();
            told(format!(
                "{} {} a range in SI units, such as {}; only an angle that occurs in cosines and sines alone needs none",
                listed(&names),
                if names.len() == 1 { "needs" } else { "need" },
                options.join(" ")
            ))
        }
        NoSteadyMotions::Unequal { counts: [equations, unknowns], idle } => told(format!(
            "its equations, {equations}, are more than its unknowns, {unknowns}: there is a steady motion only by chance; a value for {} \
             (--range NAME=VALUE) chooses among them",
            listed(&idle)
        )),
    }
}

/// The remedy where the search is not possible: a command that finds one equilibrium.
const NEAR: &str = "`linearise --about equilibrium` finds one equilibrium near the start";

fn listed(names: &[String]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// The message about a range of a name that is not an unknown.
fn unknown(name: &str, nearest: Option<String>, accepted: &[String]) -> String {
    let all = if accepted.is_empty() { "none".to_owned() } else { listed(accepted) };
    if accepted.contains(&format!("{name}'")) {
        return format!(
            "--range {name}: `{name}` is cyclic: no equation depends on it at these values of the parameters, so that it may have any value; its speed `{name}'` may have a range"
        );
    }
    if name.strip_suffix('\'').is_some_and(|coordinate| accepted.iter().any(|own| own == coordinate)) {
        return format!(
            "--range {name}: `{name}` is zero in a steady motion, since equations depend on its coordinate; ranges are accepted of: {all}"
        );
    }
    let meant = nearest.map_or_else(|| ";".to_owned(), |nearest| format!("; is `{nearest}` meant?"));
    format!("--range {name}: no unknown of the search is called `{name}`{meant} ranges are accepted of: {all}")
}

/// The refusal of a system that depends on time, with the place at which the time enters.
fn of_time(source: Option<&Source>) -> Issue {
    let title = "steady motions are searched for only in systems that do not depend on time";
    let accepted = "expressions without `t`; a frame that turns at a constant rate is accepted where the forces do not depend on its angle, as \
                    about the vertical under gravity";
    match source.and_then(place_of_time) {
        Some(at) => Issue::at(at, title, "the time enters the equations by this").accepted(accepted),
        None => Issue { span: None, title: format!("{title}; accepted: {accepted}"), label: String::new(), help: None },
    }
}

/// The place of the first expression with the time: in loads and constraints, then in points, then in frames.
fn place_of_time(source: &Source) -> Option<Range<usize>> {
    let values = |entries: &'_ [Entry]| entries.iter().map(|entry| entry.value.clone()).collect::<Vec<Text>>();
    let loads = source.forces.iter().chain(&source.torques).map(|load| load.is.clone());
    let inputs = source.inputs.iter().filter_map(|input| input.value.clone());
    let drives = source.drives.iter().flat_map(|drive| {
        drive
            .torque
            .iter()
            .chain(drive.windings.iter().filter_map(|one| one.supply.as_ref()))
            .cloned()
            .collect::<Vec<_>>()
    });
    let centres = source.bodies.iter().filter_map(|body| body.centre.clone());
    let all: Vec<Text> = source
        .gravity
        .iter()
        .cloned()
        .chain(values(&source.energies))
        .chain(loads)
        .chain(source.constraints.iter().flat_map(|one| one.zero.clone()))
        .chain(inputs)
        .chain(drives)
        .chain(values(&source.definitions))
        .chain(values(&source.points))
        .chain(centres)
        .chain(values(&source.frames))
        .collect();
    all.into_iter().find_map(|text| time_in(&text.text).map(|place| text.part(&(place..place + 1))))
}

/// The position of the letter `t` as a word in a text, in bytes.
fn time_in(text: &str) -> Option<usize> {
    let is_part = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || matches!(c, '_' | '.' | '\''));
    text.char_indices()
        .find(|&(at, c)| {
            c == 't' && !is_part(text[..at].chars().next_back()) && !is_part(text[at + 1..].chars().next())
        })
        .map(|(at, _)| at)
}

#[cfg(test)]
mod tests {
    use super::{time_in, unknown};

    #[test]
    fn the_time_is_a_letter_of_its_own() {
        assert_eq!(time_in("N turned w*t about y"), Some(11));
        assert_eq!(time_in("sin(t)"), Some(4));
        assert_eq!(time_in("theta' + P.t + t' + t_1"), None);
    }

    #[test]
    fn a_name_that_is_no_unknown_comes_with_those_that_are() {
        let all = ["x".to_owned(), "phi'".to_owned()];
        assert!(unknown("x'", Some("x".to_owned()), &all).contains("zero in a steady motion"));
        assert!(unknown("phi", None, &all).contains("is cyclic"));
        let told = unknown("y", Some("x".to_owned()), &all);
        assert!(told.contains("is `x` meant? ranges are accepted of: `x`, `phi'`"), "{told}");
        assert!(unknown("q", None, &all).contains("called `q`; ranges are accepted of: `x`, `phi'`"));
    }
}
