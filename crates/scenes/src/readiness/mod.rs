//! The start and the law of a model for a run, or the reason for which there is none, with its place in the file.

mod unmet_start;

pub(crate) use unmet_start::unmet_at;

use crate::branch::in_words;
use crate::compiled_system::{CompiledSystem, NotCompiled};
use crate::equilibrium::{Equilibrium, NoEquilibrium, equilibrium};
use crate::first_motion::{inertia_for, massless, missing, with_unsolved_law};
use crate::modes::{Modes, Refused};
use crate::refused_start::not_started;
use crate::row_units::measured;
use crate::start::{Completed, complete_algebraic_speeds, consistent, with_algebraic_speeds};
use crate::zero_divisor;
use model::equations::{constraints_of, dependent_everywhere};
use model::{Fault, Implied, Model, StartSpeed, StartValue, Trace, titles};
use reader::Issue;
use std::ops::Range;
use std::sync::Arc;
use symbolic::Dimension;

/// The fault of a file without the table `[run]`, placed at the end of the file.
pub(crate) fn without_run(text: &str) -> Issue {
    let end = text.trim_end().len();
    let issue = Issue::at(end..end, "the table [run] is missing", "the file ends here");
    issue.accepted("[run] with span = \"10 s\"; `derive` and `prove` need none")
}

/// The fault of a system whose equations cannot be compiled for a run.
pub(crate) fn refused(model: &Model, reason: &NotCompiled) -> Issue {
    without_law(model, reason, "this system cannot run")
}

/// The fault of a system whose equations cannot be compiled, at its place in the file; `what` begins the message and names the task that
/// failed.
pub fn without_law(model: &Model, reason: &NotCompiled, what: &str) -> Issue {
    if matches!(reason, NotCompiled::Massless { .. } | NotCompiled::Undefined { .. })
        && let Some(issue) = massless(model)
    {
        return issue;
    }
    if matches!(reason, NotCompiled::Undefined { .. }) {
        if let Some(issue) = zero_divisor::found(model) {
            return issue;
        }
        if let Some(redundant) = model.implied.first() {
            let title =
                format!("{what}: its law contains reactions, and {} follows from other constraints", redundant.title);
            let at = model.constraints.get(redundant.of[0]).map_or(0..0, |constraint| constraint.at.clone());
            let issue = Issue::at(at, title, "the reactions of these constraints are not determined");
            return issue.accepted("the system without this constraint: its motion is the same");
        }
    }
    let (place, label, accepted) = place_of(model, reason);
    Issue::at(place, format!("{what}: {reason}"), label).accepted(accepted)
}

/// A completed start and the law of the motion from it.
pub(crate) struct Ready {
    /// The completed state at the start: coordinates, then speeds, in SI units.
    pub start: Vec<f64>,
    pub system: Arc<CompiledSystem>,
    /// The fault if no motion, or more than one, continues from the start.
    pub without_motion: Option<Issue>,
}

/// Completes the start and compiles the law of the motion from it; removes redundant constraints from the model.
pub(crate) fn ready(model: &mut Arc<Model>) -> Result<Ready, Issue> {
    if let Some(issue) = with_unsolved_law(model) {
        return Err(issue);
    }
    // the start comes first: it removes redundant constraints, which would make the law singular
    let mut start = independent_start(Arc::make_mut(model))?;
    let model = &*model;
    let system = match Modes::of(model, &[], &[]).first(&start) {
        Ok(system) => system,
        Err(why @ Refused::Motion { .. }) => {
            let issue = not_started(model, why);
            let system = Arc::new(CompiledSystem::without_motion(model).map_err(|_| issue.clone())?);
            return Ok(Ready { start, system, without_motion: Some(issue) });
        }
        Err(why) => return Err(not_started(model, why)),
    };
    match missing(model, &system, &start).or_else(|| with_algebraic_speeds(model, &system, &mut start)) {
        Some(issue) => Err(issue),
        None => Ok(Ready { start, system, without_motion: None }),
    }
}

/// The state at time zero, coordinates then speeds, in SI units. Values of the file are completed so that constraints hold; if the file
/// asks for an equilibrium, the state is that equilibrium.
///
/// # Errors
/// If the given values violate a constraint that the free ones cannot restore, or no equilibrium is found; with the place in the file.
pub fn start_of(model: &Model) -> Result<Vec<f64>, Issue> {
    completed(model).map(|completed| completed.state)
}

pub(crate) fn completed(model: &Model) -> Result<Completed, Issue> {
    let completed = match &model.equilibrium {
        None => consistent(model),
        Some(_) => consistent(&at_rest(model)?),
    };
    let mut completed = completed.map_err(|unmet| unmet_at(model, unmet))?;
    complete_algebraic_speeds(model, &mut completed.state);
    Ok(completed)
}

/// The state at time zero, as [`start_of`]. Removes the equations of redundant constraints from the model, since their reactions are not
/// unique, and adds a warning for each.
///
/// # Errors
/// As for [`start_of`].
pub fn independent_start(model: &mut Model) -> Result<Vec<f64>, Issue> {
    let completed = completed(model)?;
    leave_out(model, &completed);
    Ok(completed.state)
}

/// Removes the equations of constraints that are redundant at `state` (coordinates, then speeds), where the model may start.
///
/// # Errors
/// If the state violates a constraint, or the model cannot start there for another reason; with the place in the file.
pub fn independent_at(model: &mut Model, state: &[f64]) -> Result<(), Issue> {
    let found = consistent(&starting(model, state)).map_err(|unmet| unmet_at(model, unmet))?;
    leave_out(model, &found);
    Ok(())
}

/// Removes the equations of the redundant constraints that were found, and adds a warning for each.
pub(crate) fn leave_out(model: &mut Model, Completed { state, implied }: &Completed) {
    if implied.is_empty() {
        return;
    }
    let (titles, everywhere) = symbolic::apart(|| {
        let trace = Trace::of(model);
        let titles = titles(&trace).into_iter().map(|(_, title)| title);
        let titles = constraints_of(&trace).into_iter().map(|one| (one.of, one.at)).zip(titles).collect::<Vec<_>>();
        (titles, dependent_everywhere(&trace, implied))
    });
    for ((of, at), title) in titles.into_iter().filter(|((of, _), _)| implied.contains(of)) {
        let branch = (!everywhere.contains(&of)).then(|| in_words(model, state));
        model.implied.push(Implied { of, title: title.clone(), branch: branch.clone() });
        let title = match branch {
            None => format!("{title} follows from other constraints"),
            Some(start) => format!("{title} follows from other constraints for positions near the start, {start}"),
        };
        let label =
            "its reaction is shown as zero, since the division of the load among these constraints is not determined";
        let accepted = "without it the motion is the same";
        model.warnings.push(Fault { span: at, title, label: label.to_owned(), accepted: accepted.to_owned() });
    }
}

/// The fault of a system whose law or start is not fixed, for a task `what` that needs a single law; placed at the event, contact, condition
/// or equilibrium.
pub(crate) fn changes(model: &Model, what: &str) -> Issue {
    let event = model.events.first().map(|event| (event.at.clone(), "this system has an event", "an event"));
    let condition = || {
        Some((model.switch_places.first()?.clone(), "the law of this system changes at a condition", "this condition"))
    };
    let equilibrium = || {
        Some((model.equilibrium.clone()?, "the start of this system is an equilibrium that is searched for", "here"))
    };
    let contact =
        || Some((model.contacts.first()?.at.clone(), "the law of this system changes with a contact", "this one"));
    let found = event.or_else(contact).or_else(condition).or_else(equilibrium);
    let (at, why, label) = found.unwrap_or((0..0, "the law of this system changes", "in this file"));
    let issue = Issue::at(at, format!("{what}: {why}"), label);
    issue.accepted("a system with one law and a start of numbers; `run` runs this one")
}

/// The equilibrium near the coordinates of the start; every coordinate may change, and speeds of the start are ignored.
///
/// # Errors
/// If no equilibrium is found, with the residual that remains; or if the law changes at conditions or contacts.
pub fn equilibrium_of(model: &Model) -> Result<Equilibrium, Issue> {
    sought(model, true)
}

/// The model with the equilibrium near its start as the start. Currents are the only speeds that may differ from zero.
fn at_rest(model: &Model) -> Result<Model, Issue> {
    let is_current = |start: &StartSpeed| model.quasi_velocities[start.of].dimension == Dimension::current();
    if let Some(start) = model.start_speeds.iter().find(|start| start.value != 0.0 && !is_current(start)) {
        let name = &model.quasi_velocities[start.of].name;
        let issue = Issue::at(start.at.clone(), "an equilibrium has no speeds", format!("{name} is not zero"));
        return Err(issue.accepted("speeds that are zero or left out; without `equilibrium` any speeds are accepted"));
    }
    Ok(starting(model, &sought(model, false)?.state))
}

fn sought(model: &Model, all: bool) -> Result<Equilibrium, Issue> {
    equilibrium(model, all).map_err(|why| {
        let at = model.equilibrium.clone().unwrap_or_default();
        match why {
            NoEquilibrium::NotCompiled(NotCompiled::Changes) => changes(model, "an equilibrium cannot be computed"),
            NoEquilibrium::NotCompiled(reason) => refused(model, &reason),
            NoEquilibrium::AtCondition { switch } => {
                let place = model.switch_places[switch].clone();
                let issue = Issue::at(place, "an equilibrium at which a condition changes is not supported yet", "this condition");
                issue.accepted(
                    "a guess of one at which no condition of `if`, `sign`, `abs`, `min`, `max` and `table` is zero; `run` runs to rest",
                )
            }
            NoEquilibrium::Moves { speed } => {
                let issue = Issue::at(at, "an equilibrium has no speeds", format!("{speed} is not zero"));
                issue.accepted("speeds that are zero or left out; without `equilibrium` any speeds are accepted")
            }
            NoEquilibrium::Driven { constraint, residual, unit } => {
                let title = format!("there is no equilibrium: {constraint} moves the system");
                let label = format!("at rest it is {}, in every position", measured(residual, &unit));
                let accepted = "a constraint that holds at rest, such as that of a belt that does not move; a steady motion is no equilibrium: it \
                                starts from its speeds";
                Issue::at(at, title, label).accepted(accepted)
            }
            NoEquilibrium::NotFound { equation, residual, unit, is_moved } => {
                let residual = measured(residual, &unit);
                let label = format!("{equation} leaves {residual} at the best point that was found");
                let issue = Issue::at(at, "no equilibrium is found near this start", label);
                issue.accepted(match is_moved {
                    true => "coordinates nearer to one, written as guesses so that they may move: \"guess 0.3 rad\"",
                    false => {
                        "a force that holds it at rest, such as that of a spring or a brake; a steady motion is no equilibrium: it starts \
                         from its speeds"
                    }
                })
            }
        }
    })
}

/// The model that starts from `state`: coordinates, then speeds.
pub fn starting(model: &Model, state: &[f64]) -> Model {
    let n = model.positions();
    let value =
        |(place, &value): (usize, &f64)| StartValue { coordinate: place % n, order: place / n, value, is_guess: false };
    let mut starting = model.clone();
    starting.start_speeds.clear();
    starting.start = state.iter().enumerate().map(value).collect();
    starting
}

/// The place in the file of the cause of a failed compilation, with a label and the accepted values.
fn place_of(model: &Model, reason: &NotCompiled) -> (Range<usize>, &'static str, &'static str) {
    let equations = "`dalembert derive` writes its equations down without running them";
    let coordinate = |name: &str| model.coordinates.iter().find(|one| one.name == name).map(|one| one.at.clone());
    let (place, label, accepted) = match reason {
        NotCompiled::Open { what: "parameter", name } => {
            let place = model.parameters.iter().find(|one| one.name == *name).map(|one| one.at.clone());
            (place, "a unit alone", "a number with its unit, such as \"2 kg\"; `derive` and `prove` need none")
        }
        NotCompiled::Open { name, .. } => {
            let place = model.inputs.iter().find(|one| one.name == *name).map(|one| one.at.clone());
            (
                place,
                "a unit alone",
                "u = { unit = \"N\", value = \"(2 N)*sin(t*(3 rad/s))\" }; `derive` and `prove` need none",
            )
        }
        NotCompiled::Massless { coordinate: name } => {
            let speed = model.coordinates.iter().position(|one| one.name == *name);
            (coordinate(name), "this coordinate", inertia_for(model, speed.unwrap_or(usize::MAX)))
        }
        NotCompiled::OfAccelerations { at } => (
            Some(at.clone()),
            "this one",
            "conditions of coordinates, speeds and time; sqrt(r^2) is the size of a reaction r",
        ),
        NotCompiled::NotHeldContact { contact } => {
            (model.contacts.get(*contact).map(|one| one.at.clone()), "this contact", equations)
        }
        NotCompiled::Changes if !model.contacts.is_empty() => {
            (model.contacts.first().map(|one| one.at.clone()), "a contact", equations)
        }
        NotCompiled::NotHeld { switch } => (model.switch_places.get(*switch).cloned(), "this condition", equations),
        _ => (None, "in this file", equations),
    };
    (place.unwrap_or(0..0), label, accepted)
}
