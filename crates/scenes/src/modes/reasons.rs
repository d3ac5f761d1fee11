//! Reasons for which a motion does not continue, in words.

use crate::compiled_system::NotCompiled;

pub(super) const NO_LAW: &str = "no law holds after a condition changes: both cases drive the condition back to zero, but no force or constraint can keep it there";
pub(crate) const NONE: &str = "no combination of cases of conditions and contacts is consistent with its own motion";
pub(super) const NONE_AT_ONCE: &str = "no combination of cases of conditions and diodes is consistent with its speeds: a force or voltage acts on a coordinate \
                            without inertia and resistance, which would jump";
pub(crate) const SEVERAL: &str = "several motions are possible from here, with different cases of conditions or contacts: `regimes` lists them. With more than three feet on a plane, or feet on a line, the load of each foot is not determined";
pub(crate) const CONTINUUM: &str = "infinitely many motions are possible from here: at this friction the equations for the reactions are singular but solvable";
pub(super) const TOGETHER: &str = "several contacts in space are at rest: friction with the least-squares distribution cannot hold them, and no directions were found in which they begin to slide";
pub(super) const TOO_MANY: &str = "too many conditions and contacts are at zero together: they have more than 20,000 combinations of cases, which are not tried";
pub(crate) const JAMS: &str =
    "the equations for the reactions of the contacts become singular: friction makes the reactions unbounded (jam)";
pub(crate) const BROKEN: &str = "the state after an event violates a constraint";

pub(super) const STEPS_OVER_REST: &str = "the long steps of bader_deuflhard pass over the instant at which a contact in space comes to rest; radau_5, gauss:4 or rodas_4 find it";

/// The sentence for a mode whose equations cannot be compiled.
pub(super) fn refused(reason: NotCompiled) -> &'static str {
    match reason {
        NotCompiled::NotHeld { .. } => NO_LAW,
        NotCompiled::Massless { .. } => "in this case a coordinate has no inertia",
        NotCompiled::Redundant { .. } => "in this case the constraints are linearly dependent",
        _ => "the equations of this case cannot be formed",
    }
}
