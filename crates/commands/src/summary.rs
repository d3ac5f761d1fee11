//! The summary of a run, as text or as one JSON object.

use integrators::{Failure, Lost, StepHalvingCheck, StepHalvingVerdict, Traits};
use serde_json::{Map, Value, json};
use simulation::events::Passage;
use simulation::problem::unit_of_invariant;
use simulation::{Axes, Choice, IvpScene, RunFailure, Trajectory};
use std::fmt::Write;

/// The summary of a run, as text or JSON.
pub struct Summary<'a> {
    pub scene: &'a dyn IvpScene,
    pub choice: &'a Choice,
    /// The form of the equations, where the scene has several.
    pub form: Option<Axes>,
    pub trajectory: &'a Trajectory,
    pub told: &'a simulation::RunNotes,
    /// For a method with constant steps: the comparison with a run with half the step size.
    pub beside: Option<StepHalvingCheck>,
    /// Initial values that were changed such that constraints are satisfied or the system is in equilibrium.
    pub completed: &'a [(String, f64)],
}

impl Summary<'_> {
    /// The summary as a JSON object: `{time, state, work, invariants, model, method, ...}`.
    pub fn json(&self) -> String {
        let Summary { scene, choice, form, trajectory, told, beside, completed } = self;
        let outcome = &trajectory.outcome;
        let named = |row: &[f64]| -> Map<String, Value> {
            trajectory.names.iter().zip(row).map(|(name, value)| (name.clone(), json!(value))).collect()
        };
        let event = |passage: &Passage| {
            let mut event = passed(passage);
            event["state"] = named(&passage.row).into();
            event
        };
        let invariants: Map<String, Value> = outcome
            .deviations
            .iter()
            .map(|d| (d.name.clone(), json!({ "first": d.first, "largest_deviation": d.largest, "at": d.at })))
            .collect();
        let work = outcome.work;
        let object = json!({
            "time": outcome.time,
            "state": named(&trajectory.last),
            "work": {
                "evaluations": work.rates,
                "jacobians": work.jacobians,
                "factorisations": work.factorisations,
                "steps": work.steps,
                "rejected": work.rejected,
                "outputs": work.outputs,
            },
            "invariants": invariants,
            "model": scene.model(),
            "method": choice.method.to_string(),
            "form": form.map(|axes| axes.to_string()),
            "tolerance": choice.tolerance,
            "made_by": made_by(),
            "reached": outcome.reached(),
            "stopped": trajectory.stopped(),
            "undefined": trajectory.undefined(),
            "lost": trajectory.lost().map(|(own, Lost { at, size })| json!({ "name": own.name, "at": at, "size": size })),
            "events": trajectory.passages.iter().map(event).collect::<Vec<_>>(),
            "theory": told.theory,
            "diagnosis": told.diagnosis,
            "failures": told.failures.iter().map(failed).collect::<Vec<_>>(),
            "steps": beside.map(judged),
            "completed_start": completed.iter().map(|(name, value)| (name.clone(), json!(value))).collect::<Map<_, _>>(),
            "closed_form": told.closed_form.map(|(what, deviation)| json!({ "what": what, "deviation": deviation })),
        });
        format!("{object:#}\n")
    }

    /// The summary as text.
    pub fn text(&self) -> String {
        let Summary { scene, choice, form, trajectory, told, beside, completed } = self;
        let outcome = &trajectory.outcome;
        let mut text = format!("{}\n\n", scene.title());
        let mut line = |name: &str, value: String| {
            // writing to a string cannot fail
            let _ = writeln!(text, "{name:<20} {value}");
        };
        let form = form.map_or_else(String::new, |axes| format!(", {axes} form"));
        line("model", scene.model().to_owned());
        let tolerance = match choice.method.traits() {
            Traits { adaptive: false, implicit: false, .. } => String::new(),
            _ => format!(", tolerance {:e}", choice.tolerance),
        };
        line("method", format!("{}{tolerance}{form}", choice.method));
        if !completed.is_empty() {
            let value = |(name, value): &(String, f64)| format!("{name} = {}", self.measured(name, *value));
            line("start", format!("completed: {}", completed.iter().map(value).collect::<Vec<_>>().join(", ")));
        }
        line("work", outcome.work.to_string());
        told.theory.iter().for_each(|said| line("theory", said.clone()));
        told_passages(&trajectory.passages).iter().for_each(|told| line("event", told.line()));
        let stopped = trajectory.stopped();
        match (&stopped, &told.diagnosis) {
            (None, None) => line("reached", format!("t = {} s", rounded(outcome.time))),
            (None, Some(end)) => line("reached", format!("t = {} s: {end}", rounded(outcome.time))),
            (Some(why), _) => {
                line("stopped", format!("{why}; the last good state is at t = {} s", rounded(outcome.time)))
            }
        }
        beside.iter().for_each(|beside| line("steps", beside.to_string()));
        if let (Some(_), Some(diagnosis)) = (&stopped, &told.diagnosis) {
            line("diagnosis", diagnosis.clone());
        }
        if matches!(outcome.failure(), Some(Failure::TooManyEvaluations { .. })) {
            line("remedy", MORE_EVALUATIONS.to_owned());
        }
        for failure in &told.failures {
            line("failure", failure.to_string());
            line("remedy", failure.remedy.clone());
        }
        for (name, value) in trajectory.names.iter().zip(&trajectory.last).filter(|(name, _)| self.shown(name)) {
            line(&format!("  {name}"), self.measured(name, *value));
        }
        for deviation in &outcome.deviations {
            let unit = match unit_of_invariant(&deviation.name) {
                "" => String::new(),
                unit => format!(" {unit}"),
            };
            let kept = match trajectory.lost() {
                _ if !deviation.largest.is_finite() => format!("without a value at t = {} s", rounded(deviation.at)),
                Some((own, Lost { at, size })) if own.name == deviation.name => format!(
                    "lost at t = {at:.9} s, where its change passed a hundredth of its size, {size:.1e}{unit}; in all it changed by at most {:.1e}{unit}. \
                     From there on the numbers are no motion of this system; a finer tolerance keeps it, or shows where the law ends",
                    deviation.largest
                ),
                _ => format!("changed by at most {:.1e}{unit}", deviation.largest),
            };
            line(&deviation.name, format!("{}{unit}, {kept}", readable(deviation.first)));
        }
        if let Some((what, deviation)) = told.closed_form {
            let off = if deviation.is_finite() { format!("{deviation:.1e}") } else { UNDEFINED.to_owned() };
            line("closed form", format!("off by {off} from {what}"));
        }
        let undefined = trajectory.undefined();
        if !undefined.is_empty() {
            line("undefined", format!("{}: the law gives no number there", undefined.join(", ")));
        }
        text
    }

    /// The value of a quantity with its unit.
    fn measured(&self, name: &str, value: f64) -> String {
        let unit = self.scene.unit(name);
        if unit == "1" || !value.is_finite() { readable(value) } else { format!("{} {unit}", readable(value)) }
    }

    /// Whether a state is one of the scene's outputs; true for every state of a scene without a list of outputs.
    fn shown(&self, name: &str) -> bool {
        let outputs = &self.scene.run().outputs;
        outputs.is_empty() || outputs.iter().any(|output| output == name)
    }
}

/// A failure of a run as JSON, with its remedy.
pub fn failed(RunFailure { kind, at, evidence, remedy }: &RunFailure) -> Value {
    json!({ "kind": kind.name(), "at": at, "evidence": evidence, "remedy": remedy })
}

/// The comparison with half the step size as JSON, with the number of its evaluations.
fn judged(beside: StepHalvingCheck) -> Value {
    let (apart, from, why) = match beside.verdict {
        StepHalvingVerdict::Converges { apart } => (Some(apart), None, None),
        StepHalvingVerdict::Departs { from } => (None, Some(from), None),
        StepHalvingVerdict::Stops { at, why } => (None, Some(at), Some(why)),
        StepHalvingVerdict::Undecided => (None, None, None),
    };
    json!({ "said": beside.verdict.name(), "follows": apart.is_some(), "apart": apart, "from": from, "why": why,
            "evaluations": beside.work.rates })
}

/// The version of the program and the processor, on which the last digits depend through fused multiplication.
fn made_by() -> String {
    let (processor, system) = (std::env::consts::ARCH, std::env::consts::OS);
    let rounds = if integrators::fuses() { "fused" } else { "unfused" };
    format!("{}:{processor}-{system}-{rounds}", env!("CARGO_PKG_VERSION"))
}

/// An event of a run as JSON.
pub fn passed(Passage { time, what, then, .. }: &Passage) -> Value {
    json!({ "time": time, "what": what, "then": then })
}

/// The largest number of events that are shown; of a longer list the first and the last events are shown.
const MOST_SHOWN: usize = 20;

/// The last decimal of shown times, s.
const SHOWN_TIME: f64 = 1e-9;

/// An event that is shown, or the number of events that are not.
pub enum EventReport<'a> {
    Passage(&'a Passage),
    LeftOut(usize),
}

/// The events of a run that are shown, with the number of those left out in between.
pub fn told_passages(passages: &[Passage]) -> Vec<EventReport<'_>> {
    let left_out = passages.len().saturating_sub(MOST_SHOWN);
    if left_out == 0 {
        return passages.iter().map(EventReport::Passage).collect();
    }
    let (first, rest) = passages.split_at(MOST_SHOWN / 2);
    let mut last = &rest[left_out..];
    // of events that repeat at the limit of their times the last one is shown
    while let [one, next, ..] = last
        && one.what == next.what
        && next.time - one.time < SHOWN_TIME
    {
        last = &last[1..];
    }
    let left_out = rest.len() - last.len();
    let last = last.iter().map(EventReport::Passage);
    first.iter().map(EventReport::Passage).chain([EventReport::LeftOut(left_out)]).chain(last).collect()
}

impl EventReport<'_> {
    /// The line of the event, without the word `event` before it.
    pub fn line(&self) -> String {
        match self {
            EventReport::Passage(Passage { time, what, then, .. }) => {
                let then = then.as_ref().filter(|then| !then.is_empty());
                let then = then.map_or_else(String::new, |then| format!(": {then}"));
                format!("t = {time:.9} s: {what}{then}")
            }
            EventReport::LeftOut(count) => format!("... {count} more; --format json shows all"),
        }
    }
}

/// The text for a quantity that is not finite.
const UNDEFINED: &str = "undefined";

/// The remedy for a run that reached its limit of evaluations.
const MORE_EVALUATIONS: &str = "a time limit above 300 s allows more evaluations in proportion, --seconds 3000 ten times as many; a coarser \
                                tolerance, or an implicit method (--method radau_5) of a stiff system, needs fewer";

/// A time rounded to twelve significant digits, since sums of steps leave rounding errors.
fn rounded(time: f64) -> f64 {
    format!("{time:.11e}").parse().unwrap_or(time)
}

/// A number with nine decimals, or in scientific notation where these would be inaccurate.
fn readable(value: f64) -> String {
    if !value.is_finite() {
        return UNDEFINED.to_owned();
    }
    if value == 0.0 || (1e-4..1e7).contains(&value.abs()) { format!("{value:.9}") } else { format!("{value:.9e}") }
}
