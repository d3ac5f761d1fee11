//! Diagnosis of accumulating events: Zeno behaviour, where event times converge to a limit, and chattering, thousands of events in succession.

use super::samples::Samples;
use simulation::events::Cause;
use simulation::{FailureKind, RunFailure};
use std::collections::BTreeSet;

/// Gaps between events below this fraction of the time are rounding errors.
const ROUNDING: f64 = 1e-9;

/// Number of events at the end of a run that are examined.
const LOOKED_AT: usize = 100;

/// The failure of a run whose event times converge to a limit; the evidence has the median ratio of successive gaps.
pub(super) fn zeno(run: &Samples<'_>) -> RunFailure {
    let (at, _) = run.last();
    let gaps: Vec<f64> = gaps(run).into_iter().filter(|gap| *gap > ROUNDING * at).collect();
    let mut factors: Vec<f64> = gaps.windows(2).map(|two| two[1] / two[0]).filter(|factor| *factor < 1.0).collect();
    factors.sort_by(f64::total_cmp);
    let shrink = factors
        .get(factors.len() / 2)
        .map_or_else(String::new, |factor| format!("; each gap between them is {factor:.4} of the one before"));
    RunFailure {
        kind: FailureKind::Zeno,
        at,
        evidence: format!("the times of {} have this limit{shrink}", names(run)),
        remedy: "a [[contact]] with `restitution` in the place of an event that sets a speed: the body then rests after its last rebound; or an \
                 [[event]] with `end = true`"
            .to_owned(),
    }
}

/// The failure of a run with thousands of events in succession.
pub(super) fn chattering(run: &Samples<'_>) -> RunFailure {
    let gaps = gaps(run);
    let count = gaps.len().min(LOOKED_AT);
    let mean = gaps.iter().rev().take(count).sum::<f64>() / count.max(1) as f64;
    RunFailure {
        kind: FailureKind::Chattering,
        at: run.last().0,
        evidence: format!("{} follow each other, the last {count} every {mean:.1e} s", names(run)),
        remedy: remedy(run).to_owned(),
    }
}

/// A remedy for the kind of the last events.
fn remedy(run: &Samples<'_>) -> &'static str {
    let last = || run.trajectory.passages.iter().skip(1).rev().take(LOOKED_AT).map(|passage| passage.cause);
    let are_all = |cause: Cause| last().all(|own| own == cause);
    if are_all(Cause::Contact) {
        "a smaller `restitution`, or `impact = \"moreau\"` at each of these contacts, so that their impacts end; or a run that ends before"
    } else if are_all(Cause::Condition) {
        "a law without this switching, such as its mean over a period; or a shorter run"
    } else {
        "the two laws as one expression `if(s > 0, a, b)` in the place of events: where both drive s back to zero the run stays there (a \
         sliding mode); or a wider dead band"
    }
}

/// Times between successive events in seconds, without the start.
fn gaps(run: &Samples<'_>) -> Vec<f64> {
    let times: Vec<f64> = run.trajectory.passages.iter().skip(1).map(|passage| passage.time).collect();
    times.windows(2).map(|two| two[1] - two[0]).collect()
}

/// The descriptions of the last events, each once.
fn names(run: &Samples<'_>) -> String {
    let last = run.trajectory.passages.iter().skip(1).rev().take(LOOKED_AT);
    let names: BTreeSet<&str> = last.map(|passage| passage.what.as_str()).collect();
    match names.is_empty() {
        true => "the events at the start".to_owned(),
        false => names.into_iter().collect::<Vec<_>>().join(" and "),
    }
}
