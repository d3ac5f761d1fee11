//! Reasons for which a motion does not continue, in words.

use crate::compiled_system::NotCompiled;

pub(super) const NO_LAW: &str =
    "no law holds after a condition changes: it would have to be kept at zero, and nothing keeps it there";
pub(crate) const NONE: &str = "no case of its conditions and contacts agrees with the motion that it gives";
pub(super) const NONE_AT_ONCE: &str = "no case of its conditions and diodes agrees with the speeds that it gives: a force or a voltage that meets neither \
                            inertia nor resistance would move a coordinate at once";
pub(crate) const SEVERAL: &str = "several motions go on from here, each by another case of its conditions or contacts: `regimes` lists them; more than three feet on a plane, or feet on a line, do not say what each of them carries";
pub(crate) const CONTINUUM: &str =
    "motions without end go on from here: at this friction the equations for the reactions are singular, and yet hold";
pub(super) const TOGETHER: &str = "several contacts in space rest together: sharing the load by the bounds of their friction does not hold them, and no directions are found in which they begin to slide";
pub(super) const TOO_MANY: &str =
    "so many conditions and contacts are at zero together that their cases are not tried: more than 20,000";
pub(crate) const JAMS: &str = "the equations for the reactions of its contacts become singular: friction makes the reactions grow beyond every bound";
pub(crate) const BROKEN: &str = "an event leaves a state that breaks a constraint";

pub(super) const STEPS_OVER_REST: &str = "the long steps of bader_deuflhard pass over the instant at which a contact in space comes to rest; radau_5, gauss:4 or rodas_4 find it";

/// The reason for which the law of a case does not hold.
pub(super) fn refused(reason: NotCompiled) -> &'static str {
    match reason {
        NotCompiled::NotHeld { .. } => NO_LAW,
        NotCompiled::Massless { .. } => "in this case nothing with inertia moves with a coordinate",
        NotCompiled::Redundant { .. } => "in this case its constraints depend on each other",
        _ => "the law of this case cannot be written down",
    }
}
