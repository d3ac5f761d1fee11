//! Diagnosis of dependent constraints: their Jacobian loses rank at a position.

use super::samples::Samples;
use crate::start::{Dependence, KeptConstraints, SingularPositions};
use simulation::{FailureKind, RunFailure};

/// If steps have collapsed, the constraints are dependent where the least singular value of J is below this multiple of that at the start.
const LOST: f64 = 1e-3;

/// The multiple for runs whose law ended at a position already known as singular.
const KEPT: f64 = 0.1;

const THROUGH: &str = "`through_singular_positions = true` under [run], by which the run goes on along the smooth branch of its motion; or ";

const UNKNOWN: &str =
    "no smooth branch of the motion, on which no event falls into this position, was found behind it; ";

const UNIQUE: &str = "`run`, which goes on along the smooth branch of the motion, where this command needs the one motion that the equations determine; or ";

const REMEDIES: &str = "a dimension that differs by a ten-thousandth leads past on one branch; or a start from which the motion turns before; \
     or an [[event]] with `end = true` before this position";

/// The failure of a run that stopped at a position where constraints become dependent.
pub(super) fn lost(run: &Samples<'_>) -> Option<RunFailure> {
    let left = run.trajectory.left;
    let is_named = left.is_some_and(SingularPositions::ends);
    if left.is_some() && !is_named {
        return None;
    }
    let kept = KeptConstraints::of(run.model());
    let (time, state) = run.last();
    let Dependence { titles, moved, least } = kept.dependence(time, state)?;
    let at_start = kept.dependence(0.0, &run.scene.start)?.least;
    // at full rank, another divisor of the law is zero, such as an inertia
    if least > if is_named { KEPT } else { LOST } * at_start {
        return None;
    }
    let place = (0..run.model().positions()).filter(|place| moved.contains(place));
    let place: Vec<String> = place.map(|place| run.told(place, state[place])).collect();
    let place = if place.is_empty() { String::new() } else { format!(" at {}", place.join(", ")) };
    let ways = match (run.scene.run.through_singular_positions, run.choice.through_singular_positions) {
        (_, true) => UNKNOWN,
        (true, false) => UNIQUE,
        (false, false) => THROUGH,
    };
    Some(RunFailure {
        kind: FailureKind::DependentConstraints,
        at: time,
        evidence: format!(
            "{} {}{place}: the least singular value of their Jacobian is {:.1e} of that at the start",
            titles.join(", "),
            if titles.len() > 1 { "depend on each other" } else { "loses its direction" },
            least / at_start
        ),
        remedy: format!("{ways}{REMEDIES}"),
    })
}
