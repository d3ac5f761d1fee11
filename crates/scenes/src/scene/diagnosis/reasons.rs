//! Failures that follow directly from the reason for which the law of a run ended.

use super::samples::Samples;
use super::{accumulation, rank};
use crate::modes::reasons;
use crate::start::SingularPositions;
use simulation::events::{ACCUMULATE, POLE, TOO_MANY};
use simulation::{FailureKind, RunFailure};

/// The failure for the reason with which the law ended; `None` if the reason needs further diagnosis.
pub(super) fn named(run: &Samples<'_>) -> Option<RunFailure> {
    let why = run.trajectory.left?;
    let (at, _) = run.last();
    let contacts = &run.model().contacts;
    let names: Vec<String> = contacts.iter().enumerate().map(|(place, contact)| contact.title(place)).collect();
    let names = names.join(", ");
    let of = |kind, evidence: String, remedy: &str| Some(RunFailure { kind, at, evidence, remedy: remedy.to_owned() });
    match why {
        ACCUMULATE => Some(accumulation::zeno(run)),
        TOO_MANY => Some(accumulation::chattering(run)),
        why if SingularPositions::ends(why) => rank::lost(run),
        _ if contacts.is_empty() => None,
        reasons::NONE => of(
            FailureKind::NoContactMode,
            format!("neither sticking nor sliding nor opening of {names} is consistent with its own motion"),
            "`friction` below the critical value that `dalembert regimes` prints; or a spring and a damper as a [[force]] in the place of \
             the rigid contact",
        ),
        reasons::SEVERAL | reasons::CONTINUUM => of(
            FailureKind::SeveralContactModes,
            format!("more than one motion of {names} is possible from here"),
            "`dalembert regimes` lists them; a spring and a damper as a [[force]] in the place of a rigid contact chooses one",
        ),
        reasons::JAMS => of(
            FailureKind::Jam,
            format!("friction makes the reactions of {names} unbounded"),
            "`friction` below the critical value that `dalembert regimes` prints; or a spring and a damper as a [[force]] in the place of \
             the rigid contact",
        ),
        _ => None,
    }
}

/// The failure at a pole of the rates, for runs that no other diagnosis explains.
pub(super) fn unexplained(run: &Samples<'_>) -> Option<RunFailure> {
    (run.trajectory.left == Some(POLE)).then(|| RunFailure {
        kind: FailureKind::Pole,
        at: run.last().0,
        evidence: "a divisor of the rates passes through zero".to_owned(),
        remedy: "a law without this division, such as a distance with a small length added to it; or an [[event]] with `end = true` before \
                 it; `dalembert derive` prints the equations with their divisors"
            .to_owned(),
    })
}
