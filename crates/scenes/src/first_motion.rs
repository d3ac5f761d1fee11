//! Diagnosis of starts at which accelerations are undetermined. Accelerations u' and multipliers λ solve
//!
//!   [ M  J^T ] [   u'    ]   [ -h ]
//!   [ J   0  ] [ -lambda ] = [ -c ]
//!
//! A null vector of this matrix is a motion without inertia that satisfies the constraints: the system lacks an inertia, or the start is
//! a singularity of the coordinates, such as the pole for the azimuth of spherical angles.

use crate::coinciding_points;
use crate::compiled_system::{CompiledSystem, NotCompiled};
use crate::modes::{Case, Mode};
use crate::motion_matrix::MotionMatrix;
use crate::structural_index::differentiations;
use crate::zero_divisor;
use integrators::Ode;
use model::{Coordinate, Model, Parameter, Trace, UnsolvedLaw};
use reader::Issue;
use std::ops::Range;
use symbolic::apart;

/// The reason for which accelerations are not finite at `start` (coordinates, then speeds); `None` if they are.
pub fn missing(model: &Model, system: &CompiledSystem, start: &[f64]) -> Option<Issue> {
    let mut rates = vec![0.0; start.len()];
    Ode::<f64>::rates(system, 0.0, start, &mut rates);
    if rates.iter().all(|rate| rate.is_finite()) {
        return None;
    }
    let n = model.speeds();
    let matrix = MotionMatrix::of(model, &system.mode)?;
    let terms = matrix.at(0.0, start)?;
    let moved = |speed: usize| moved(model, speed);
    let has_no_value = without_value(&terms.matrix).is_some() || without_value(&terms.right[..n]).is_some();
    if has_no_value && let Some(issue) = zero_divisor::found(model) {
        return Some(issue);
    }
    if let Some(place) = without_value(&terms.matrix) {
        let (name, at) = moved((place % terms.size).min(n - 1));
        let title = format!("the inertia of `{name}` has no value at the start");
        return Some(Issue::at(at, title, "of this coordinate").accepted(NO_NUMBER));
    }
    if let Some(place) = without_value(&terms.right[..n]) {
        let (name, at) = moved(place);
        if let Some([one, other]) = coinciding_points::of_forces(model, start).first() {
            let title = format!(
                "a force acts between {one} and {other}, which coincide at the start: it has no direction there"
            );
            return Some(Issue::at(at, title, "its acceleration would be no number").accepted(
                "points apart at the start; or, of bodies on one line, a force along a coordinate: `along = \"x\"` in the place of `between`",
            ));
        }
        let title = format!("the forces on `{name}` have no value at the start");
        return Some(Issue::at(at, title, "its acceleration would be no number").accepted(NO_NUMBER));
    }
    let (name, at) = moved(largest(&terms.free(n)?));
    let elsewhere: Vec<f64> = start.iter().zip(1..).map(|(part, place)| part + 0.1 * f64::from(place)).collect();
    let there = matrix.at(0.0, &elsewhere).filter(|terms| without_value(&terms.matrix).is_none());
    if let Some(direction) = there.and_then(|terms| terms.free(n)) {
        return Some(resisted_by_nothing(model, &direction));
    }
    let title = format!("the acceleration of `{name}` is not determined at the start");
    let issue = Issue::at(at, title, "in this position no mass moves when it changes");
    Some(issue.accepted(
        "another start, or other coordinates: spherical angles are not defined at the pole, three angles of rotation are not where their first and third axes coincide",
    ))
}

/// The advice for expressions without a value.
const NO_NUMBER: &str = "another start: a division by zero, `unit` of a zero vector, a force between points that coincide, \
                         `ln` or `sqrt` of a negative number, and numbers beyond 1.8e308 in SI units have no value";

/// An issue for a direction without inertia at the start, with all conditions positive; `None` if the mass matrix has no value there or
/// there is no such direction.
pub(crate) fn massless(model: &Model) -> Option<Issue> {
    let mode = Mode { cases: vec![Case::On; model.switches.len()], phases: Vec::new() };
    let terms = MotionMatrix::of(model, &mode)?.at(0.0, &model.start_state())?;
    let direction = without_value(&terms.matrix).is_none().then(|| terms.free(model.speeds()))??;
    Some(resisted_by_nothing(model, &direction))
}

/// An issue for a coordinate without inertia whose law changes at a condition or a contact and cannot be solved for its speed.
pub(crate) fn with_unsolved_law(model: &Model) -> Option<Issue> {
    let (place, why) = model.unsolved_law?;
    let (name, at) = moved(model, place);
    let (why, label, accepted) = match why {
        UnsolvedLaw::Nonlinear => (
            "it changes at a condition and is not linear in the speeds without inertia",
            "the law of this coordinate",
            "an inductance or an inertia along it; a law that is linear in speeds in each case; or one that holds no `if`, `sign`, `abs`, \
             `min`, `max`, `table` and no diode",
        ),
        UnsolvedLaw::Contact => (
            "it changes at a condition, and a contact between bodies holds its speed",
            "the law of this coordinate",
            "a mass or an inertia that moves with it",
        ),
        UnsolvedLaw::Programmed => (
            "it changes at a condition, and a programmed constraint holds its speed",
            "the law of this coordinate",
            "a constraint that holds, without `programmed`; or an inertia along it",
        ),
        UnsolvedLaw::OfPositions => (
            "it holds a condition and no speed, so that it would move at once where the condition changes",
            "the law of this coordinate",
            "a resistance or a damper along it, or an inertia",
        ),
    };
    let title =
        format!("this system cannot run: nothing has inertia along `{name}`, and its law cannot be solved: {why}");
    Some(Issue::at(at, title, label).accepted(accepted))
}

/// The issue for a direction of speeds with neither inertia nor a constraint: one speed, or a combination of several.
fn resisted_by_nothing(model: &Model, direction: &[f64]) -> Issue {
    let (name, at) = moved(model, largest(direction));
    let size = direction[largest(direction)].abs();
    let first = direction.iter().find(|part| part.abs() > PART * size).map_or(1.0, |part| part.signum());
    let names = &model.state_names()[model.positions()..];
    let parts = direction.iter().map(|part| part / (first * size)).zip(names).filter(|(part, _)| part.abs() > PART);
    let parts = parts.map(|(part, (name, unit))| {
        let rounded: f64 = format!("{part:.5e}").parse().unwrap_or(part);
        format!("{name} = {rounded} {unit}")
    });
    let parts: Vec<String> = parts.collect();
    let (why, label) = match parts.as_slice() {
        [_] => (NotCompiled::Massless { coordinate: name }.to_string(), "this coordinate"),
        several => (
            format!("no mass and no inertia resists the speeds {} together", several.join(", ")),
            "this coordinate moves in that combination",
        ),
    };
    let title = format!("this system cannot run: {why}");
    if let ([_], Some(parameter)) = (parts.as_slice(), vanishing(model, largest(direction))) {
        let label = format!("`{}` is zero, and no other inertia moves with it", parameter.name);
        return Issue::at(parameter.at.clone(), title, label).accepted(
            "a value that is not zero, small if it must be; an inertia or an inductance that is left out of the energies: of a circuit \
             without one, dissipation = \"R/2*q'^2\" and a force along q",
        );
    }
    if let [_] = parts.as_slice()
        && let Some(count) = differentiations(model, largest(direction))
    {
        let (name, at) = moved(model, largest(direction));
        let title = format!(
            "this system cannot run: the index of its differential-algebraic equations is {}; at most 3 is accepted",
            count + 1
        );
        let label = format!(
            "the law of `{name}` does not hold it, and determines it only after it is differentiated {count} times"
        );
        return Issue::at(at, title, label).accepted(format!(
            "`{name}` as an input with `value`, an expression of the state; its law as a [[constraint]], whose reaction then keeps it; or `dalembert inverse`, which has the forces for a motion"
        ));
    }
    Issue::at(at, title, label).accepted(inertia_for(model, largest(direction)))
}

/// The parameter with the value zero that is the inertia along a speed, if there is one.
fn vanishing(model: &Model, speed: usize) -> Option<&Parameter> {
    let held: Vec<usize> = apart(|| {
        let trace = Trace::of(model);
        let inertia = trace.by_speed(trace.by_speed(trace.kinetic_and_coenergy(), speed), speed).symbols_of();
        (0..model.parameters.len()).filter(|&place| inertia.contains(&trace.parameters[place])).collect()
    });
    held.into_iter().map(|place| &model.parameters[place]).find(|parameter| parameter.value == Some(0.0))
}

/// A remedy for a speed without inertia, in words.
pub(crate) fn inertia_for(model: &Model, speed: usize) -> &'static str {
    let is_charge = |of: &Coordinate| of.dimension == symbolic::Dimension::current() * symbolic::Dimension::time();
    match model.coordinates.get(speed) {
        Some(coordinate) if is_charge(coordinate) => {
            "an inductance of its current, coenergy = \"L/2*q'^2\"; a resistance or a capacitor; or a constraint that determines it"
        }
        _ => "a body that moves with it, a damper or a spring on it, or a constraint that determines it",
    }
}

/// Components below this part of the largest are rounding errors.
const PART: f64 = 1e-9;

/// The name of the coordinate of a speed, and its byte range in the file; for a free frame the name of the speed, and an empty range.
fn moved(model: &Model, speed: usize) -> (String, Range<usize>) {
    match model.coordinates.get(speed) {
        Some(coordinate) => (coordinate.name.clone(), coordinate.at.clone()),
        None => (model.state_names()[model.positions() + speed].0.clone(), 0..0),
    }
}

/// The index of the first entry that is not finite.
fn without_value(row: &[f64]) -> Option<usize> {
    row.iter().position(|entry| !entry.is_finite())
}

/// The index of the entry with the largest absolute value.
fn largest(direction: &[f64]) -> usize {
    let larger =
        |best: usize, (place, part): (usize, &f64)| if part.abs() > direction[best].abs() { place } else { best };
    direction.iter().enumerate().fold(0, larger)
}
