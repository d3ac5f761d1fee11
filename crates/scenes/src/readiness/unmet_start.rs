//! Faults of starts that do not satisfy the constraints, each with its place in the file.

use super::refused;
use crate::row_units::measured;
use crate::start::{Open, Unmet};
use crate::zero_divisor;
use model::Model;
use model::equations::Level;
use reader::Issue;
use std::ops::Range;

/// The fault of a start at which the constraints fail for the reason `unmet`.
pub(crate) fn unmet_at(model: &Model, unmet: Unmet) -> Issue {
    match unmet {
        Unmet::Open(open) => match open.residual {
            None => zero_divisor::found(model).unwrap_or_else(|| match open.is_rate {
                true => without_gradient(open.at.clone(), &open.name),
                false => inconsistent(model, &open),
            }),
            Some(_) => inconsistent(model, &open),
        },
        Unmet::Redundant { at, name } => {
            let title = format!("{name} depends on other constraints at the start");
            let issue = Issue::at(
                at,
                title,
                "singular position: the constraint is independent at neighbouring positions, but not here",
            );
            issue.accepted("another start; or constraints that are independent")
        }
        Unmet::Idle { at, name } => {
            let title = format!("{name} has no effect at the start");
            let issue = Issue::at(at, title, "every derivative of it by coordinates and speeds is zero there");
            issue.accepted(
                "another start, since links in one line and a crank at its dead point are singular positions; \
                 or an expression that coordinates move: x - y, and not its square",
            )
        }
        Unmet::Multiple { at, name } => {
            let title = format!("the gradient of {name} is zero wherever the constraint holds");
            let issue = Issue::at(at, title, "no reaction can enforce it; it is a square, or a sum of squares");
            issue.accepted(
                "its root: x - y in the place of (x - y)^2, a in the place of 1 - cos(a); of a sum of squares a list of its roots, \
                 zero = [\"x\", \"y\"]",
            )
        }
        Unmet::Jumping { at, name } => without_gradient(at, &name),
        Unmet::Locked { at, name } => {
            let title = format!("{name} cannot hold in this position");
            let issue = Issue::at(at, title, "no rates of coordinates give it here; in neighbouring positions some do");
            issue.accepted(match model.constraints.iter().any(|constraint| constraint.gains.is_none()) {
                true => {
                    "another position, or fewer quasi-velocities in [start]: here the constraints and the others determine it"
                }
                false => {
                    "another position: three angles of rotation are not defined where their first and third axes coincide, and \
                     spherical angles are not at the pole; or a frame that turns freely, F = \"N free\""
                }
            })
        }
        Unmet::Gains { at, level, found } => {
            let (kind, accepted) = match level {
                Level::Position => {
                    ("positions needs two gains", "gains = [\"2*a\", \"b^2\"]: f'' + 2 a f' + b^2 f = 0")
                }
                Level::Speed => ("speeds needs one gain", "gains = [\"a\"]: f' + a f = 0"),
            };
            let label = if found == 1 { "one is given".to_owned() } else { format!("{found} are given") };
            Issue::at(at, format!("a programmed constraint of {kind}"), label).accepted(accepted)
        }
        Unmet::Piecewise(at) => {
            let issue = Issue::at(at, "a constraint that changes at a condition is not supported yet", "this one");
            issue.accepted("constraints without `if`, `sign`, `abs`, `min`, `max` and `table`")
        }
        Unmet::Fixed { at } => {
            let title = "this constraint holds no coordinate and no speed";
            let issue = Issue::at(at, title, "no motion changes its value");
            issue.accepted(
                "an expression of coordinates, of speeds, or of both; a relation between parameters is no constraint",
            )
        }
        Unmet::Contradiction { at, residual, unit } => {
            let [one, other] = at.clone().map(|at| {
                if let Some(place) = model.contacts.iter().position(|contact| contact.at == at) {
                    return model.contacts[place].title(place);
                }
                let place = model.constraints.iter().position(|constraint| constraint.at == at);
                let name = place.and_then(|place| model.constraints[place].name.as_ref());
                let number = place.map_or_else(String::new, |place| format!(" {}", place + 1));
                format!("constraint{number}{}", name.map_or_else(String::new, |name| format!(" `{name}`")))
            });
            let [_, at] = at;
            let label = format!("its value is {}, not zero, wherever {one} holds", measured(residual, &unit));
            let issue = Issue::at(at, format!("{other} contradicts {one}"), label);
            issue.accepted("constraints that some position meets together: leave one of the two out, or mend it")
        }
        Unmet::NotCompiled(reason) => refused(model, &reason),
    }
}

/// The fault of a constraint whose gradient does not exist where the constraint holds.
fn without_gradient(at: Range<usize>, name: &str) -> Issue {
    let title = format!("{name} has no derivative where it holds");
    let label = "its gradient does not exist there, like that of the norm of a vector at zero";
    Issue::at(at, title, label).accepted(
        "the vector itself, which is one constraint for each component: zero = \"Q - S\" in the place of norm(Q - S) and of distance(Q, S)",
    )
}

/// The fault of a constraint that the completed start still violates.
fn inconsistent(model: &Model, open: &Open) -> Issue {
    let Open { at, name, residual, unit, is_rate, moved, given, others, level } = open;
    let list = |names: &[String]| names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let rate = if *is_rate { "its rate is" } else { "its value is" };
    if let [first, ..] = moved.as_slice() {
        let title = match others.as_slice() {
            [] => format!("{name} was not met from this start"),
            [other] => format!("no start was found that satisfies {name} and {other}"),
            [_, _, ..] => format!("no start was found that satisfies {name} together with the other constraints"),
        };
        let moved = list(moved);
        let label = match residual {
            Some(residual) => {
                format!("its value is {} after {moved} was adjusted, not zero", measured(*residual, unit))
            }
            None => format!("it has no value where the adjustment of {moved} ended"),
        };
        let fixed = given_speeds(model);
        let alone = if others.is_empty() {
            ""
        } else {
            "constraints that hold together, since these may contradict each other; or "
        };
        let accepted = match (level, fixed.as_slice()) {
            (Level::Speed, [_, ..]) => {
                format!("fewer or other speeds in [start], which gives {}", list(&fixed))
            }
            _ => format!(
                "{alone}another guess in [start], such as {} = \"guess {}\", nearer to a position at which the constraints hold; or other given values",
                key(first),
                match model.free.iter().any(|frame| model.frames[frame.0].name == *first) {
                    true => "20 deg about z",
                    false => "...",
                }
            ),
        };
        return Issue::at(at.clone(), title, label).accepted(accepted);
    }
    let what = if *level == Level::Position { "the coordinates" } else { "the speeds" };
    let title = format!("{name} does not hold at the start");
    let own = model.start_speeds.iter().find(|start| start.at == *at);
    if let (Some(own), Some(residual), [_, ..]) = (own, residual, given.as_slice()) {
        let label = format!("{} by {}, which [start] gives too", measured(residual + own.value, unit), list(given));
        let accepted = "one of them: rates that [start] leaves out are completed so that its quasi-velocities hold";
        return Issue::at(at.clone(), title, label).accepted(accepted);
    }
    let label = match residual {
        Some(residual) => format!("{rate} {} with {what} in [start], not zero", measured(*residual, unit)),
        None => format!("it has no value with {what} in [start]"),
    };
    Issue::at(at.clone(), title, label).accepted(
        "values in [start] that agree; one that is left out, or written as \"guess 0.3 rad\", is completed so that constraints hold",
    )
}

/// The names of speeds and quasi-velocities whose values the table `[start]` fixes.
fn given_speeds(model: &Model) -> Vec<String> {
    let names = model.state_names();
    let given = model.start.iter().filter(|start| start.order == 1 && !start.is_guess);
    let speeds = given.map(|start| names[model.positions() + start.coordinate].0.clone());
    let quasi = model.start_speeds.iter().map(|start| model.quasi_velocities[start.of].name.clone());
    speeds.chain(quasi).collect()
}

/// The name as a key of TOML, in quotes where it needs them.
fn key(name: &str) -> String {
    let is_bare = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    if is_bare { name.to_owned() } else { format!("\"{name}\"") }
}
