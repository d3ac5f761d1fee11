//! The derived vectors of a model, each on a line, along the axes in which it was computed.

use super::reading::Reading;
use super::{is_sum, reading_of};
use crate::joints::joints;
use crate::principles::loads::{forces, torques};
use crate::{Defined, FrameId, Material, Moves, PointId, Trace, Turn, Vector};
use num_traits::Zero;
use std::fmt;
use symbolic::Sym;

/// A derived vector of a model, or a line of text about one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DerivedVector {
    /// The name, such as `velocity(P)`; for a line of text the whole line.
    pub name: String,
    /// The vector by components along the axes of a frame, as text and in LaTeX; `None` for a line of text.
    pub value: Option<[String; 2]>,
}

impl fmt::Display for DerivedVector {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.value {
            Some([text, _]) => write!(f, "{} = {text}", self.name),
            None => write!(f, "{}", self.name),
        }
    }
}

/// Returns the derived vectors as lines of text.
pub fn vectors(trace: &Trace<'_>) -> Vec<String> {
    derived_vectors(trace).iter().map(DerivedVector::to_string).collect()
}

/// Returns the angular velocity of every frame; position, velocity and acceleration of every named point and of every
/// other centre of mass; vectors of definitions; forces and torques, one for each point or frame on which they
/// act, including weights; then the joint of every body, about which the torque of its joint load is taken.
pub fn derived_vectors(trace: &Trace<'_>) -> Vec<DerivedVector> {
    let (model, mut reading) = (trace.model, reading_of(trace));
    let mut lines = Vec::new();
    let said = |line: String| DerivedVector { name: line, value: None };
    for (at, frame) in model.frames.iter().enumerate().skip(1) {
        let name = format!("angular_velocity({})", frame.name);
        lines.push(named(name, trace, &mut reading, trace.turning(FrameId(at))));
        if let Some((parent, Turn::Free { .. })) = frame.parent {
            let (parent, name) = (&model.frames[parent.0].name, &frame.name);
            lines.push(said(format!("{name}.Rxy = {parent}.x . {name}.y, and so on: direction cosines")));
        }
    }
    for (at, point) in model.points.iter().enumerate() {
        if !point.name.is_empty() && point.base.is_some() {
            let at = PointId(at);
            let vectors = [trace.position(at), trace.velocity(at), trace.acceleration(at)];
            lines.extend(motion(&point.name, vectors, |name, vector| named(name, trace, &mut reading, vector)));
        }
    }
    for (name, defined) in &model.definitions {
        match *defined {
            Defined::Vector(vector) => {
                lines.push(named(name.clone(), trace, &mut reading, trace.vector(vector)));
            }
            Defined::Point { base, way, moves } => {
                let way = way.map_or(Vector::ZERO, |way| trace.vector(way));
                let rate = trace.vector_rate(way);
                let position = trace.sum(trace.position(base), way);
                let rates = [
                    trace.sum(trace.velocity(base), rate),
                    trace.sum(trace.acceleration(base), trace.vector_rate(rate)),
                ];
                let vectors = [position, rates[0], rates[1]];
                let told = motion(name, vectors, |name, vector| named(name, trace, &mut reading, vector));
                lines.extend(told.into_iter().take(if moves == Moves::ByCoordinates { 3 } else { 1 }));
            }
        }
    }
    for body in &model.bodies {
        if let Some(centre) = body.centre.filter(|centre| model.points[centre.0].name.is_empty()) {
            let all = [trace.position(centre), trace.velocity(centre), trace.acceleration(centre)];
            let titles = ["centre of NAME - O", "velocity(NAME)", "acceleration(NAME)"];
            for (title, vector) in titles.into_iter().zip(all) {
                lines.push(named(title.replace("NAME", &body.name), trace, &mut reading, vector));
            }
        }
    }
    let given = forces(trace, false).len();
    for (number, force) in forces(trace, true).into_iter().enumerate() {
        let place = place(trace, force.at, |way| of(trace, &mut reading, way));
        let kind = if number < given { "force on" } else { "weight of" };
        let is = force.is.map(|part| with_masses(trace, part));
        lines.push(named(format!("{kind} {place}"), trace, &mut reading, is));
    }
    for torque in torques(trace) {
        let frame = &model.frames[torque.on.0].name;
        lines.push(named(format!("torque on {frame}"), trace, &mut reading, torque.is));
    }
    for (body, parent, at) in joints(trace) {
        let parent = parent.map_or("the ground", |parent| model.bodies[parent.0].name.as_str());
        let at = point(trace, at, |way| of(trace, &mut reading, way));
        lines.push(said(format!("joint of {} to {parent}: at {at}", model.bodies[body.0].name)));
    }
    lines
}

/// Returns a vector with its name.
fn named(name: String, trace: &Trace<'_>, reading: &mut Reading, vector: Vector) -> DerivedVector {
    let parts = parts(reading, vector);
    let frame = &trace.model.frames[vector.frame.0].name;
    let axes_of_latex = ["x", "y", "z"].map(|axis| format!(r"\mathbf{{{}}}_{axis}", frame.replace('_', r"\_")));
    let latex = sum(&parts, |part| part.decimal_latex(), [r"\,", r"\left(", r"\right)"], &axes_of_latex);
    DerivedVector { name, value: Some([text(frame, &parts), latex]) }
}

/// The nonzero components, each with its axis.
type Parts = Vec<(Sym, usize)>;

fn parts(reading: &mut Reading, vector: Vector) -> Parts {
    let components = vector.components.iter().enumerate().map(|(axis, component)| (reading.of(*component), axis));
    components.filter(|(component, _)| !component.is_zero()).collect()
}

/// Returns a vector as text, along the axes of its frame.
pub(super) fn of(trace: &Trace<'_>, reading: &mut Reading, vector: Vector) -> String {
    text(&trace.model.frames[vector.frame.0].name, &parts(reading, vector))
}

fn text(frame: &str, parts: &Parts) -> String {
    let axes = ["x", "y", "z"].map(|axis| format!("{frame}.{axis}"));
    sum(parts, |part| part.decimal_text(), ["*", "(", ")"], &axes)
}

/// Returns components before their axes as a sum; `times`, `open` and `close` are the sign of a product and the parentheses.
fn sum(parts: &Parts, write: impl Fn(Sym) -> String, [times, open, close]: [&str; 3], axes: &[String; 3]) -> String {
    let mut text = String::new();
    for &(component, axis) in parts {
        let (plain, written) = (component.decimal_text(), write(component));
        let (sign, size) = match (plain.strip_prefix('-'), written.strip_prefix('-')) {
            (Some(plain), Some(rest)) if !is_sum(plain) => ("-", rest.to_owned()),
            _ if is_sum(&plain) => ("", format!("{open}{written}{close}")),
            _ => ("", written),
        };
        text += match (text.is_empty(), sign) {
            (true, sign) => sign,
            (false, "-") => " - ",
            (false, _) => " + ",
        };
        let axis = &axes[axis];
        text += &if size == "1" { axis.clone() } else { format!("{size}{times}{axis}") };
    }
    if text.is_empty() { "0".to_owned() } else { text }
}

/// Returns position, velocity and acceleration of a point, with names.
fn motion(
    name: &str,
    vectors: [Vector; 3],
    mut named: impl FnMut(String, Vector) -> DerivedVector,
) -> Vec<DerivedVector> {
    let titles = [format!("{name} - O"), format!("velocity({name})"), format!("acceleration({name})")];
    titles.into_iter().zip(vectors).map(|(title, vector)| named(title, vector)).collect()
}

/// Returns the name of a point, or its position vector.
fn point(trace: &Trace<'_>, at: PointId, of: impl FnOnce(Vector) -> String) -> String {
    match trace.model.points[at.0].name.as_str() {
        "" => match of(trace.position(at)) {
            way if way == "0" => "O".to_owned(),
            way => way.strip_prefix('-').map_or_else(|| format!("O + {way}"), |rest| format!("O - {rest}")),
        },
        name => name.to_owned(),
    }
}

/// Returns a description of a force's target: a body at a point, or only the body for its centre of mass.
fn place(trace: &Trace<'_>, Material { body, point: at }: Material, of: impl FnOnce(Vector) -> String) -> String {
    let bodies = &trace.model.bodies;
    let of_centre = bodies.iter().find(|body| body.centre == Some(at)).filter(|_| body.is_none());
    let body = body.map(|body| &bodies[body.0]);
    match (body, of_centre) {
        (Some(body), _) if body.centre == Some(at) => body.name.clone(),
        (Some(body), _) => format!("{} at {}", body.name, point(trace, at, of)),
        (None, Some(body)) => body.name.clone(),
        (None, None) => point(trace, at, of),
    }
}

/// Substitutes variable masses by their expressions.
fn with_masses(trace: &Trace<'_>, component: Sym) -> Sym {
    trace.with_masses(&[component])[0]
}
