//! Bodies whose inertia is given by a single moment of inertia, about the z axis of their frame.

use crate::{Body, Fault, FrameId, Inertia, Model, Trace, Turn};
use symbolic::apart;

/// Returns a fault for each of these bodies that also turns about another axis, since one moment of inertia does not determine this motion.
pub(super) fn tilted(model: &Model) -> Vec<Fault> {
    let may_tilt = |body: &Body| {
        matches!(body.inertia, Some(Inertia::Axial(_))) && body.frame.is_some_and(|frame| leaves_axis(model, frame))
    };
    if !model.bodies.iter().any(may_tilt) {
        return Vec::new();
    }
    let fault = |body: &&Body| {
        let title = format!(
            "`{}` turns about more than its z axis: one moment of inertia does not say how it resists",
            body.name
        );
        let accepted = "three moments, inertia = { principal = [\"A\", \"B\", \"C\"] }, along the axes of its frame; those of a ball are equal";
        Fault::at(body.inertia_at.clone(), title, "this is the moment about z", accepted)
    };
    apart(|| {
        let trace = Trace::of(model);
        let tilted = trace.tilted();
        model.bodies.iter().filter(|body| tilted.contains(&body.name.as_str())).map(|body| fault(&body)).collect()
    })
}

/// Returns whether a frame, or one of its parent frames, turns about another axis than z.
fn leaves_axis(model: &Model, frame: FrameId) -> bool {
    let mut next = Some(frame);
    while let Some((parent, turn)) = next.and_then(|frame| model.frames[frame.0].parent.as_ref()) {
        if !matches!(turn, Turn::About { axis: 2, .. }) {
            return true;
        }
        next = Some(*parent);
    }
    false
}
