//! The diagnosis of a run of a text system: failures by their standard names, each with evidence and a remedy.
//!
//! # Overview
//! * `samples`: the sampled states of a run, with interpolation between them;
//! * `reasons`: failures that follow from the reason for which a law ended;
//! * `inertia`: singular charts and mass matrices; `rank`: dependent constraints;
//! * `stiffness`: step sizes limited by stability; `growth`: unbounded motions; `domain`: functions that leave their domain; `overflow`:
//!   exponentials beyond the range of double precision;
//! * `drift`: residuals of constraints; `accumulation`: converging event times; `missed_events`, `pulses`: events and short forces between
//!   samples.
//!
//! All diagnoses are computed from samples after the run, at no cost during the run.

mod accumulation;
mod domain;
mod drift;
mod growth;
mod inertia;
mod missed_events;
mod overflow;
mod pulses;
mod rank;
mod reasons;
mod samples;
mod stiffness;

use crate::scene::ModelScene;
use samples::Samples;
use simulation::{Choice, RunFailure, Trajectory};

/// All failures of a run; none if it was interrupted.
pub(super) fn failures(scene: &ModelScene, choice: &Choice, trajectory: &Trajectory) -> Vec<RunFailure> {
    if trajectory.broken_off() {
        return Vec::new();
    }
    let run = Samples::of(scene, choice, trajectory);
    let has_stopped = trajectory.stopped().is_some();
    let cause = match has_stopped {
        true => reasons::named(&run)
            .or_else(|| domain::crossed(&run))
            .or_else(|| overflow::found(&run))
            .or_else(|| inertia::singular(&run))
            .or_else(|| rank::lost(&run))
            .or_else(|| stiffness::found(&run))
            .or_else(|| growth::found(&run))
            .or_else(|| domain::left(&run))
            .or_else(|| reasons::unexplained(&run)),
        false if run.is_laborious() => inertia::singular(&run),
        false => None,
    };
    let cause = cause.or_else(|| if has_stopped { None } else { stiffness::hidden(&run) });
    cause.into_iter().chain(drift::found(&run)).chain(missed_events::found(&run)).chain(pulses::missed(&run)).collect()
}
