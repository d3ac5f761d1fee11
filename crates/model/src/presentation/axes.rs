//! The axis of each scalar constraint. A vector constraint is resolved into components.

use crate::equations::{constraints_of, held_of};
use crate::{Trace, Vector};
use symbolic::Sym;

/// Returns the axis of each scalar constraint, such as `F3.x`, in the order of the equations; `None` for a constraint that is a scalar.
pub fn axes(trace: &Trace<'_>) -> Vec<Option<String>> {
    let constraints = 0..trace.model.constraints.len();
    let held = constraints.flat_map(|place| held_of(trace, place));
    held.map(|held| held.axis.map(|axis| written(trace, axis))).collect()
}

/// Returns the name of each constraint in sentences, without and with the axis of its component: "constraint 1 `loop` along F3.x".
pub fn titles(trace: &Trace<'_>) -> Vec<(String, String)> {
    let titles = constraints_of(trace).into_iter().enumerate().map(|(place, constraint)| constraint.title(place));
    titles.zip(axes(trace)).map(|(title, axis)| (title.clone(), title + &along(axis.as_deref()))).collect()
}

/// Returns ` along F3.x`; an empty text for a scalar constraint.
pub(super) fn along(axis: Option<&str>) -> String {
    axis.map_or_else(String::new, |axis| format!(" along {axis}"))
}

fn written(trace: &Trace<'_>, axis: Vector) -> String {
    let component = axis.components.iter().position(|component| *component == Sym::ONE).unwrap_or(0);
    format!("{}.{}", trace.model.frames[axis.frame.0].name, ["x", "y", "z"][component])
}
