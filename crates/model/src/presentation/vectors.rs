//! The vectors that a model is made of, each on a line, in the axes in which it was formed.

use super::reading::Reading;
use super::{is_sum, reading_of};
use crate::joints::joints;
use crate::principles::loads::{forces, torques};
use crate::{Defined, FrameId, Material, Moves, PointId, Trace, Turn, Vector};
use num_traits::Zero;
use symbolic::Sym;

/// The angular velocity of every frame; position, velocity and acceleration of every point of `[points]` and of definitions, and of
/// every centre of mass that is no such point; vectors of definitions; forces and torques, one for each point or frame that they act
/// on, weights beside them; then the joint of every body, about which its torque is.
pub fn vectors(trace: &Trace<'_>) -> Vec<String> {
    let (model, mut reading) = (trace.model, reading_of(trace));
    let mut lines = Vec::new();
    for (at, frame) in model.frames.iter().enumerate().skip(1) {
        lines.push(format!(
            "angular_velocity({}) = {}",
            frame.name,
            of(trace, &mut reading, trace.turning(FrameId(at)))
        ));
        if let Some((parent, Turn::Free { .. })) = frame.parent {
            let (parent, name) = (&model.frames[parent.0].name, &frame.name);
            lines.push(format!("{name}.Rxy = {parent}.x . {name}.y, and so on: direction cosines"));
        }
    }
    for (at, point) in model.points.iter().enumerate() {
        if !point.name.is_empty() && point.base.is_some() {
            let at = PointId(at);
            lines.extend(motion(
                &point.name,
                [trace.position(at), trace.velocity(at), trace.acceleration(at)],
                |vector| of(trace, &mut reading, vector),
            ));
        }
    }
    for (name, defined) in &model.definitions {
        match *defined {
            Defined::Vector(vector) => {
                lines.push(format!("{name} = {}", of(trace, &mut reading, trace.vector(vector))));
            }
            Defined::Point { base, way, moves } => {
                let way = way.map_or(Vector::ZERO, |way| trace.vector(way));
                let rate = trace.vector_rate(way);
                let position = trace.sum(trace.position(base), way);
                let rates = [
                    trace.sum(trace.velocity(base), rate),
                    trace.sum(trace.acceleration(base), trace.vector_rate(rate)),
                ];
                let told = motion(name, [position, rates[0], rates[1]], |vector| of(trace, &mut reading, vector));
                lines.extend(told.into_iter().take(if moves == Moves::ByCoordinates { 3 } else { 1 }));
            }
        }
    }
    for body in &model.bodies {
        if let Some(centre) = body.centre.filter(|centre| model.points[centre.0].name.is_empty()) {
            let all = [trace.position(centre), trace.velocity(centre), trace.acceleration(centre)];
            let told = all.map(|vector| of(trace, &mut reading, vector));
            let titles = ["centre of NAME - O", "velocity(NAME)", "acceleration(NAME)"];
            let titled =
                titles.iter().zip(told).map(|(title, is)| format!("{} = {is}", title.replace("NAME", &body.name)));
            lines.extend(titled);
        }
    }
    let given = forces(trace, false).len();
    for (number, force) in forces(trace, true).into_iter().enumerate() {
        let is = of(trace, &mut reading, force.is.map(|part| with_masses(trace, part)));
        let place = place(trace, force.at, |way| of(trace, &mut reading, way));
        let kind = if number < given { "force on" } else { "weight of" };
        lines.push(format!("{kind} {place} = {is}"));
    }
    for torque in torques(trace) {
        let frame = &model.frames[torque.on.0].name;
        lines.push(format!("torque on {frame} = {}", of(trace, &mut reading, torque.is)));
    }
    for (body, parent, at) in joints(trace) {
        let parent = parent.map_or("the ground", |parent| model.bodies[parent.0].name.as_str());
        let at = point(trace, at, |way| of(trace, &mut reading, way));
        lines.push(format!("joint of {} to {parent}: at {at}", model.bodies[body.0].name));
    }
    lines
}

/// A vector by the axes of its frame.
pub(super) fn of(trace: &Trace<'_>, reading: &mut Reading, vector: Vector) -> String {
    let frame = &trace.model.frames[vector.frame.0].name;
    let mut text = String::new();
    for (component, axis) in vector.components.iter().zip(["x", "y", "z"]) {
        let component = reading.of(*component);
        if component.is_zero() {
            continue;
        }
        let written = component.decimal_text();
        let (sign, size) = match written.strip_prefix('-') {
            Some(rest) if !is_sum(rest) => ("-", rest.to_owned()),
            _ if is_sum(&written) => ("", format!("({written})")),
            _ => ("", written),
        };
        text += match (text.is_empty(), sign) {
            (true, sign) => sign,
            (false, "-") => " - ",
            (false, _) => " + ",
        };
        text += &if size == "1" { format!("{frame}.{axis}") } else { format!("{size}*{frame}.{axis}") };
    }
    if text.is_empty() { "0".to_owned() } else { text }
}

/// Position, velocity and acceleration of a point by its name.
fn motion(name: &str, vectors: [Vector; 3], mut of: impl FnMut(Vector) -> String) -> Vec<String> {
    let titles = [format!("{name} - O"), format!("velocity({name})"), format!("acceleration({name})")];
    titles.into_iter().zip(vectors).map(|(title, vector)| format!("{title} = {}", of(vector))).collect()
}

/// A point by its name, or by its position vector.
fn point(trace: &Trace<'_>, at: PointId, of: impl FnOnce(Vector) -> String) -> String {
    match trace.model.points[at.0].name.as_str() {
        "" => match of(trace.position(at)) {
            way if way == "0" => "O".to_owned(),
            way => way.strip_prefix('-').map_or_else(|| format!("O + {way}"), |rest| format!("O - {rest}")),
        },
        name => name.to_owned(),
    }
}

/// The receiver of a force: a body at a point, its centre by the body alone.
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

/// A component with the values of masses that vary.
fn with_masses(trace: &Trace<'_>, component: Sym) -> Sym {
    trace.with_masses(&[component])[0]
}
