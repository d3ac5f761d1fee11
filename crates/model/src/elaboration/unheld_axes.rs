//! Warnings about outputs with a reaction component of a vector constraint along an axis on which the constraint vanishes identically: there it has
//! no reaction.

use crate::arena::{Part, Vector};
use crate::equations::{held_of, vanishes};
use crate::{Entry, Fault, FrameId, Model, Source, Trace, Turn};
use symbolic::apart;

/// Returns a warning for each such output.
pub(super) fn unheld_axes(source: &Source, model: &Model) -> Vec<Fault> {
    let reactions: Vec<(usize, usize)> = model.arena.parts.iter().enumerate().filter_map(reaction).collect();
    if reactions.is_empty() {
        return Vec::new();
    }
    apart(|| {
        let trace = Trace::of(model);
        let mut warnings = Vec::new();
        for (part, constraint) in reactions {
            let name = model.constraints[constraint].name.as_deref().unwrap_or_default();
            for (frame, axis) in unheld(&trace, constraint) {
                let shown = outputs_with(model, part, Vector::Axis { frame, axis });
                let without = outputs_with(model, part, Vector::Zero);
                let differs = |place: usize| {
                    let (with, without) = (shown[place], without[place]);
                    with != without && !vanishes(with - without)
                };
                let asks = |entry: &&Entry| {
                    let place = model.outputs.iter().position(|output| output.name == entry.name.text);
                    place.is_some_and(differs)
                };
                let axis = format!("{}.{}", model.frames[frame.0].name, ["x", "y", "z"][axis]);
                for entry in source.outputs.iter().filter(asks) {
                    warnings.push(Fault::at(
                        entry.value.span(),
                        format!("the component of `{name}` along {axis} vanishes identically, and has no reaction"),
                        "this output requests it, and shows zero for it",
                        "a coordinate that could move there, so that the constraint holds it; or joint_force of the body",
                    ));
                }
            }
        }
        warnings
    })
}

/// Returns the index of a node that is the reaction of a vector constraint, and the constraint.
fn reaction((place, part): (usize, &Part)) -> Option<(usize, usize)> {
    match part {
        Part::Vector(Vector::Reaction { constraint }) => Some((place, *constraint)),
        _ => None,
    }
}

/// Returns the axes along which the components of a constraint vanish identically. The axis perpendicular to the plane of a planar system is omitted.
fn unheld(trace: &Trace<'_>, constraint: usize) -> Vec<(FrameId, usize)> {
    let axes: Vec<crate::Vector> = held_of(trace, constraint).into_iter().filter_map(|held| held.axis).collect();
    let Some(frame) = axes.first().map(|axis| axis.frame) else { return Vec::new() };
    let is_about_z = |frame: &crate::Frame| matches!(frame.parent, None | Some((_, Turn::About { axis: 2, .. })));
    let is_plane = trace.model.frames.iter().all(is_about_z);
    let is_held = |axis: usize| axes.contains(&crate::Vector::axis(frame, axis));
    let is_across = |axis: usize| is_plane && axis == 2;
    (0..3).filter(|&axis| !is_held(axis) && !is_across(axis)).map(|axis| (frame, axis)).collect()
}

/// Returns the outputs with a reaction replaced by another vector.
fn outputs_with(model: &Model, part: usize, vector: Vector) -> Vec<symbolic::Sym> {
    let mut other = model.clone();
    other.arena.parts[part] = Part::Vector(vector);
    let trace = Trace::of(&other);
    other.outputs.iter().map(|output| trace.scalar(output.is)).collect()
}
