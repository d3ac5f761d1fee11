//! Runs of a problem, with the trajectory as named columns.

use super::problem::Row;
use super::singular_rows::interpolated;
use super::{Axes, Problem, Run};
use crate::events::{Cause, Passage};
use integrators::{
    Deviation, End, Failure, Lost, Method, Observer, Outcome, Record, Refusal, Span, StepHalvingCheck, Tolerance,
    check_by_step_halving,
};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// The settings of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    pub method: Method,
    pub tolerance: f64,
    pub axes: Axes,
    /// The number of output times after the start.
    pub samples: usize,
    /// The time limit of the run; rows up to then are kept.
    pub allowed: Duration,
    /// Whether the run continues beyond singular positions of its constraints, on the smooth branch of its motion.
    pub through_singular_positions: bool,
}

/// The result of a run, whether it reached its end or not.
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory {
    /// The column names: the states, then quantities computed from them.
    pub names: Vec<String>,
    pub times: Vec<f64>,
    /// One row for each time.
    pub rows: Vec<Vec<f64>>,
    /// The states of the law at these times; only for methods with a constant step.
    pub states: Vec<Vec<f64>>,
    /// The names of quantities that should stay zero: the change of each integral, and the largest residual of the
    /// constraints.
    pub checks: Vec<String>,
    /// The values of the checks at each time.
    pub checked: Vec<Vec<f64>>,
    /// The row of the last valid state.
    pub last: Vec<f64>,
    /// The outcome of the integration; where the validity of the law ended, up to that time.
    pub outcome: Outcome<f64>,
    /// The reason why the law is invalid after the last valid state, if it is.
    pub left: Option<&'static str>,
    /// For a law that changes: the start and the events.
    pub passages: Vec<Passage>,
}

impl Run {
    /// The settings of a run as given in the scene.
    pub fn choice(&self) -> Choice {
        Choice {
            method: self.method,
            tolerance: self.tolerance,
            axes: Axes::First,
            samples: self.samples,
            allowed: Duration::from_secs(300),
            through_singular_positions: self.through_singular_positions,
        }
    }
}

/// The time limit for the usual number of evaluations, and the longest time that counts as a limit.
const USUAL: Duration = Duration::from_secs(300);
const LONGEST: Duration = Duration::from_secs(86_400);

/// The budget of evaluations: increased in proportion to the time limit, if there is one above the usual.
fn evaluations(usual: u64, allowed: Duration) -> u64 {
    match allowed <= LONGEST {
        true => (usual as f64 * (allowed.as_secs_f64() / USUAL.as_secs_f64()).max(1.0)) as u64,
        false => usual,
    }
}

impl Problem {
    /// Runs the problem. `progress` receives the completed fraction after every step.
    pub fn simulate(&self, choice: &Choice, mut progress: impl FnMut(f64)) -> Trajectory {
        self.simulate_while(choice, |fraction| {
            progress(fraction);
            ControlFlow::Continue(())
        })
    }

    /// Runs the problem until `progress`, which receives the completed fraction after every step, stops it. Rows up to
    /// then are kept.
    pub fn simulate_while(&self, choice: &Choice, progress: impl FnMut(f64) -> ControlFlow<()>) -> Trajectory {
        let mut span = Span::new(0.0, self.span, &self.state)
            .with_even_outputs(choice.samples)
            .with_deadline(Instant::now() + choice.allowed);
        span.budget.evaluations = evaluations(span.budget.evaluations, choice.allowed);
        span.outputs.insert(0, 0.0);
        for invariant in &self.invariants {
            let first = (invariant.value)(0.0, &self.state);
            // a step beyond the validity of the law is not part of the run
            let value = move |time: f64, y: &[f64]| match self.outside(time, y) {
                Some(_) => first,
                None => (invariant.value)(time, y),
            };
            span = span.with_monitor(invariant.name, value);
            if let Some(size) = &invariant.size {
                span = span.beside(size);
            }
        }
        let mut kept = Kept {
            row: &*self.row,
            times: Vec::new(),
            rows: Vec::new(),
            states: choice.method.steps().map(|_| Vec::new()),
            problem: self,
            first: self.invariants.iter().map(|one| (one.value)(0.0, &self.state)).collect(),
            checked: Vec::new(),
            singular_positions: Vec::new(),
            between: None,
            broken_off: false,
            progress,
        };
        let tolerance = Tolerance::both(choice.tolerance);
        let (outcome, left) = match choice.through_singular_positions {
            true => self.integrate_through_singular_positions(choice.method, &tolerance, &span, &mut kept),
            false => self.integrate(choice.method, &tolerance, &span, &mut kept),
        };
        let Kept { times, rows, states, checked, singular_positions, between, .. } = kept;
        let states = states.unwrap_or_default();
        let last = match rows.last().filter(|_| between == Some(outcome.time)) {
            Some(interpolated) => interpolated.clone(),
            None => (self.row)(outcome.time, &outcome.state),
        };
        let mut passages = self.switching.as_ref().map_or_else(Vec::new, |switching| switching.passages());
        passages.extend(singular_positions);
        passages.sort_by(|one, other| one.time.total_cmp(&other.time));
        Trajectory {
            names: self.columns.clone(),
            times,
            rows,
            states,
            checks: self.checks(),
            checked,
            last,
            outcome,
            left,
            passages,
        }
    }
}

impl Problem {
    /// The names of the checks.
    fn checks(&self) -> Vec<String> {
        let invariants = self.invariants.iter().map(|one| format!("change of {}", one.name));
        invariants.chain(self.residual.as_ref().map(|_| "residual of constraints".to_owned())).collect()
    }

    /// The values of the checks at a state.
    fn checked(&self, first: &[f64], time: f64, state: &[f64]) -> Vec<f64> {
        let changes = self.invariants.iter().zip(first).map(|(one, first)| (one.value)(time, state) - first);
        changes.chain(self.residual.as_ref().map(|residual| residual(time, state))).collect()
    }

    /// Compares a run with constant steps that reached its end with runs of shorter steps, each with the time limit of
    /// `choice`. `None` for other runs. `goes_on` may stop the comparison.
    pub fn check_by_step_halving(
        &self,
        choice: &Choice,
        trajectory: &Trajectory,
        mut goes_on: impl FnMut() -> ControlFlow<()>,
    ) -> Option<StepHalvingCheck> {
        if !trajectory.outcome.reached() || trajectory.left.is_some() {
            return None;
        }
        let own = self.state.len() - self.metered;
        let judged = |states: &[Vec<f64>]| states.iter().map(|state| state[..own].to_vec()).collect();
        let record = Record { times: trajectory.times.clone(), states: judged(&trajectory.states) };
        check_by_step_halving(choice.method, &record, |method| {
            let mut span = Span::new(0.0, self.span, &self.state).with_deadline(Instant::now() + choice.allowed);
            span.outputs.clone_from(&record.times);
            let mut seen = Record::new();
            let mut told = Told { goes_on: &mut goes_on, broken_off: false };
            let tolerance = Tolerance::both(choice.tolerance);
            let mut observer = (&mut seen, &mut told);
            let (outcome, left) = match choice.through_singular_positions {
                true => self.integrate_through_singular_positions(method, &tolerance, &span, &mut observer),
                false => self.integrate(method, &tolerance, &span, &mut observer),
            };
            seen.states = judged(&seen.states);
            (outcome, seen, left)
        })
    }
}

/// An observer that stops a run on the caller's request.
struct Told<'a> {
    goes_on: &'a mut dyn FnMut() -> ControlFlow<()>,
    broken_off: bool,
}

impl Observer<f64> for Told<'_> {
    fn step(&mut self, _time: f64, _state: &[f64]) {
        self.broken_off |= (self.goes_on)().is_break();
    }

    fn enough(&self) -> bool {
        self.broken_off
    }
}

impl Trajectory {
    /// The index of the column with this name; `None` if there is none.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|known| known == name)
    }

    /// The reason why the run stopped before its end; `None` if it reached its end.
    pub fn stopped(&self) -> Option<String> {
        let failure = || self.outcome.failure().map(|failure| self.named(failure));
        let broken_off = || self.broken_off().then(|| "interrupted".to_owned());
        let left = self.left.map(|why| match self.has_begun() {
            true => format!("left its law: {why}"),
            false => format!("does not begin: {why}"),
        });
        left.or_else(broken_off).or_else(failure)
    }

    /// Whether the run made any step or passed any event.
    pub fn has_begun(&self) -> bool {
        self.outcome.time != 0.0 || self.outcome.work.steps > 0 || !self.passages.is_empty()
    }

    /// Whether an event ended the run before its span, as the scene demands.
    pub fn ends_before(&self, span: f64) -> bool {
        self.left.is_none() && self.outcome.reached() && self.outcome.time < span
    }

    /// The text of a failure, with the name of the state whose rate is undefined.
    fn named(&self, failure: Failure) -> String {
        let Failure::Refused(Refusal::RatesNotFinite { component }) = failure else { return failure.to_string() };
        let what = match self.names.get(component).filter(|_| component < self.outcome.state.len()) {
            Some(name) => format!("the rate of `{name}`"),
            // a further variable of the law, besides the state
            None => "the rate of a reaction or of a condition".to_owned(),
        };
        match self.outcome.time {
            0.0 => format!("refused: at the start {what} is not finite"),
            time => format!("left its law: where it begins anew at t = {time:.9} s, {what} is not finite"),
        }
    }

    /// The names of undefined values: columns at the end, and conserved quantities along the run.
    pub fn undefined(&self) -> Vec<&str> {
        let columns = self.names.iter().zip(&self.last).filter(|(_, value)| !value.is_finite());
        let lost = |deviation: &&Deviation| !(deviation.first.is_finite() && deviation.largest.is_finite());
        let kept = self.outcome.deviations.iter().filter(lost);
        columns.map(|(name, _)| name.as_str()).chain(kept.map(|deviation| deviation.name.as_str())).collect()
    }

    /// The conserved quantity that the run lost first, for a method with step size control. Runs with constant steps
    /// are checked by step halving instead, and have `None`, as a run that lost no quantity.
    pub fn lost(&self) -> Option<(&Deviation, Lost)> {
        // a run that ends within its last step is not lost beyond its end
        let within = |lost: Lost| Lost { at: lost.at.min(self.outcome.time), ..lost };
        let lost = self.outcome.deviations.iter().filter_map(|one| Some((one, within(one.lost?))));
        lost.filter(|_| self.states.is_empty()).min_by(|(_, one), (_, other)| one.at.total_cmp(&other.at))
    }

    /// Whether the caller stopped the run.
    pub fn broken_off(&self) -> bool {
        let told = matches!(self.outcome.end, End::Halted | End::Stopped(Failure::Interrupted { .. }));
        self.left.is_none() && told
    }
}

/// An observer that stores the rows and reports the progress.
struct Kept<'a, F> {
    row: &'a Row,
    times: Vec<f64>,
    rows: Vec<Vec<f64>>,
    /// The states, if requested.
    states: Option<Vec<Vec<f64>>>,
    problem: &'a Problem,
    /// The initial values of the integrals.
    first: Vec<f64>,
    checked: Vec<Vec<f64>>,
    /// The singular positions that were passed.
    singular_positions: Vec<Passage>,
    /// The time of the last sample near a singular position.
    between: Option<f64>,
    broken_off: bool,
    progress: F,
}

impl<F: FnMut(f64) -> ControlFlow<()>> Observer<f64> for Kept<'_, F> {
    fn sample(&mut self, time: f64, state: &[f64]) {
        self.times.push(time);
        self.rows.push((self.row)(time, state));
        self.checked.push(self.problem.checked(&self.first, time, state));
        if let Some(states) = &mut self.states {
            states.push(state.to_vec());
        }
    }

    fn sample_between(&mut self, time: f64, state: &[f64], nodes: &[(f64, Vec<f64>)]) {
        self.sample(time, state);
        if let Some(row) = self.rows.last_mut() {
            *row = interpolated(self.row, (time, state), nodes);
        }
        self.between = Some(time);
    }

    fn singular_position(&mut self, time: f64, state: &[f64], error: f64, nodes: &[(f64, Vec<f64>)]) {
        let what = format!(
            "singular position of the constraints, passed on the smooth branch of the motion (two Taylor series of it agree to {:.0e}); \
             other motions may follow too",
            error.max(f64::EPSILON)
        );
        let row = interpolated(self.row, (time, state), nodes);
        self.singular_positions.push(Passage {
            time,
            cause: Cause::SingularPosition,
            what,
            then: Some(String::new()),
            row,
        });
    }

    fn progress(&mut self, fraction: f64) {
        self.broken_off |= (self.progress)(fraction).is_break();
    }

    fn enough(&self) -> bool {
        self.broken_off
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_longer_time_limit_allows_more_evaluations_and_none_allows_the_usual_number() {
        let allowed = [1, 300, 3000, 1 << 30].map(|seconds| evaluations(1000, Duration::from_secs(seconds)));
        assert_eq!(allowed, [1000, 1000, 10_000, 1000]);
    }
}
