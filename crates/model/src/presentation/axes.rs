//! The axis along which each scalar constraint holds: a vector constraint is resolved into components.

use crate::equations::{constraints_of, held_of};
use crate::{Trace, Vector};
use symbolic::Sym;

/// For each scalar constraint, in the order of the equations, the axis of its component, such as `F3.x`; none of a scalar.
pub fn axes(trace: &Trace<'_>) -> Vec<Option<String>> {
    let constraints = 0..trace.model.constraints.len();
    let held = constraints.flat_map(|place| held_of(trace, place));
    held.map(|held| held.axis.map(|axis| written(trace, axis))).collect()
}

/// The sentences' name of every constraint, and the same with the axis of its component: constraint 1 `loop` along F3.x.
pub fn titles(trace: &Trace<'_>) -> Vec<(String, String)> {
    let titles = constraints_of(trace).into_iter().enumerate().map(|(place, constraint)| constraint.title(place));
    titles.zip(axes(trace)).map(|(title, axis)| (title.clone(), title + &along(axis.as_deref()))).collect()
}

/// ` along F3.x`; nothing of a scalar.
pub(super) fn along(axis: Option<&str>) -> String {
    axis.map_or_else(String::new, |axis| format!(" along {axis}"))
}

fn written(trace: &Trace<'_>, axis: Vector) -> String {
    let component = axis.components.iter().position(|component| *component == Sym::ONE).unwrap_or(0);
    format!("{}.{}", trace.model.frames[axis.frame.0].name, ["x", "y", "z"][component])
}
