//! The Taylor method on a batch of systems of one kind: one system in each lane of a SIMD register, with its own time
//! and step size.
//!
//! Lanes are independent. When a member reaches the end of its run, the next member is loaded into its lane. The result
//! of a member depends neither on its lane nor on the members in the other lanes.

use crate::methods::taylor::reach;
use crate::{Failure, clock};
use field::Batch;
use pulp::{Arch, Simd, WithSimd};

/// Optimal order of the Taylor method in a batch, for a tolerance.
///
/// The model is that of [`taylor_order`](crate::taylor_order), with the cost of a step b + p + c p^2, where b = 3.5 and
/// c = 0.02 were measured for orders 8 to 28 on systems with 8 and 15 states. The optimum is near p = 3 + 0.78 L. The
/// code of a batch computes four orders at once; the result is the nearest multiple of four, at most 60.
pub fn batch_order(tolerance: f64) -> usize {
    let fours = (3.0 - 0.78 * tolerance.ln()) / 4.0;
    4 * (fours.round() as usize).clamp(1, 15)
}

/// Taylor series of L systems, which differ in their parameters, states and times.
pub trait BatchSeries<const L: usize> {
    /// Sets the parameters of the system in a lane.
    fn set(&mut self, lane: usize, parameters: &[f64]);

    /// The order of the series.
    fn order(&self) -> usize;

    /// Computes the Taylor coefficients of the solutions through (t, y) in all lanes.
    fn expand(&mut self, times: Batch<L>, states: &[Batch<L>]);

    /// The Taylor coefficients of order k of all states. Only the two highest orders are available.
    fn coefficients(&self, k: usize) -> &[Batch<L>];

    /// Evaluates the last series in every lane at its time h after the expansion point.
    fn sum(&self, h: Batch<L>, out: &mut [Batch<L>]);

    /// The longest step in each lane for which the series represents the law, see
    /// [`TaylorSeries::shown`](crate::TaylorSeries::shown).
    fn shown(&self) -> Batch<L> {
        Batch::all(f64::INFINITY)
    }
}

impl<T: BatchSeries<L> + ?Sized, const L: usize> BatchSeries<L> for Box<T> {
    fn set(&mut self, lane: usize, parameters: &[f64]) {
        (**self).set(lane, parameters);
    }

    fn order(&self) -> usize {
        (**self).order()
    }

    fn expand(&mut self, times: Batch<L>, states: &[Batch<L>]) {
        (**self).expand(times, states);
    }

    fn coefficients(&self, k: usize) -> &[Batch<L>] {
        (**self).coefficients(k)
    }

    fn sum(&self, h: Batch<L>, out: &mut [Batch<L>]) {
        (**self).sum(h, out);
    }

    fn shown(&self) -> Batch<L> {
        (**self).shown()
    }
}

/// Supplies the members of an ensemble, and receives their results.
pub trait Members {
    /// Writes parameters and initial state of the next member and returns its number; `None` where there are no more.
    fn next(&mut self, parameters: &mut [f64], state: &mut [f64]) -> Option<u64>;

    /// Whether [`leaves`](Self::leaves) must be called after each step.
    fn watches(&self) -> bool {
        false
    }

    /// The time within a step after which the law of the member is no longer valid; `None` where it is valid in the
    /// whole step.
    fn leaves(&mut self, _number: u64, _step: &BatchStep<'_>) -> Option<f64> {
        None
    }

    /// Whether [`project`](Self::project) must be called after each step.
    fn projects(&self) -> bool {
        false
    }

    /// Projects the state of a member onto its constraints and integrals if the residual exceeds rounding. Returns
    /// whether the state was changed.
    fn project(&mut self, _number: u64, _time: f64, _state: &mut [f64]) -> bool {
        false
    }

    /// Receives a member whose run has ended: its last valid state at the time `at`, the number of steps, and the
    /// failure if there was one.
    fn ended(&mut self, number: u64, state: &[f64], steps: u64, at: f64, failure: Option<Failure>);
}

/// The motion of a member over a step.
pub struct BatchStep<'a> {
    pub begin: f64,
    pub end: f64,
    /// The state at a time within the step.
    pub state_at: &'a dyn Fn(f64, &mut [f64]),
}

/// The Taylor method for L members at once. All runs go from time zero to one common end. A run allocates no memory.
#[derive(Clone, Debug)]
pub struct Ensemble<T, const L: usize> {
    source: T,
    /// The order of the series.
    order: usize,
    tolerance: f64,
    end: f64,
    most_steps: u64,
    states: Vec<Batch<L>>,
    /// Buffer for the states after a step.
    after: Vec<Batch<L>>,
    times: Batch<L>,
    steps: [u64; L],
    /// The number of the member in each lane.
    numbers: [Option<u64>; L],
    /// Buffer for the parameters of one member.
    parameters: Vec<f64>,
    state: Vec<f64>,
}

impl<T: BatchSeries<L>, const L: usize> Ensemble<T, L> {
    /// An ensemble for systems with `states` states and `parameters` parameters, from time zero to `end`.
    /// [`batch_order`] gives the best order of the source.
    pub fn new(source: T, tolerance: f64, end: f64, states: usize, parameters: usize) -> Self {
        Ensemble {
            order: source.order().max(2),
            source,
            tolerance,
            end,
            most_steps: u64::MAX,
            states: vec![Batch::all(0.0); states],
            after: vec![Batch::all(0.0); states],
            times: Batch::all(0.0),
            steps: [0; L],
            numbers: [None; L],
            parameters: vec![0.0; parameters],
            state: vec![0.0; states],
        }
    }

    /// Sets the largest number of steps of each member.
    pub fn with_most_steps(mut self, most_steps: u64) -> Self {
        self.most_steps = most_steps;
        self
    }

    /// Runs all members. If the clock of the process ends the run early, unfinished members are not reported.
    pub fn run(&mut self, members: &mut impl Members) {
        for lane in 0..L {
            self.admit(lane, members);
        }
        while self.numbers.iter().any(Option::is_some) && clock::over().is_none() {
            self.step(members);
        }
    }

    /// One step in every lane.
    fn step(&mut self, members: &mut impl Members) {
        self.source.expand(self.times, &self.states);
        let (last, before) = (self.source.coefficients(self.order), self.source.coefficients(self.order - 1));
        let reach = Reach { states: &self.states, last, before, order: self.order, tolerance: self.tolerance };
        let (reach, shown) = (Arch::new().dispatch(reach), self.source.shown());
        let (mut steps, mut nexts) = (Batch::all(0.0), [Ok(0.0); L]);
        for lane in (0..L).filter(|lane| self.numbers[*lane].is_some()) {
            // `min` would drop a NaN
            let reach = if shown.0[lane] < reach.0[lane] { shown.0[lane] } else { reach.0[lane] };
            nexts[lane] = self.next_time(lane, reach);
            steps.0[lane] = nexts[lane].map_or(0.0, |next| next - self.times.0[lane]);
        }
        self.source.sum(steps, &mut self.after);
        std::mem::swap(&mut self.states, &mut self.after);
        let mut ends = if members.watches() { self.leave(nexts, members) } else { std::array::from_fn(|_| None) };
        if members.projects() {
            self.project(nexts, members);
        }
        for (lane, next) in nexts.into_iter().enumerate() {
            let Some(number) = self.numbers[lane] else { continue };
            let lost = || self.states.iter().any(|y| !y.0[lane].is_finite());
            let failure = match next {
                Ok(next) if next == self.end && lost() => Some(Failure::LeftTheNumbers { at: self.times.0[lane] }),
                Ok(next) => {
                    (self.times.0[lane], self.steps[lane]) = (next, self.steps[lane] + 1);
                    None
                }
                Err(failure) => Some(failure),
            };
            if let (Some((end, state)), None) = (&mut ends[lane], failure) {
                members.project(number, *end, state);
                members.ended(number, state, self.steps[lane], *end, None);
                self.admit(lane, members);
                continue;
            }
            if failure.is_some() || self.times.0[lane] == self.end {
                // the state before the step is the last valid state of a member that failed
                let states = if failure.is_some() { &self.after } else { &self.states };
                self.state.iter_mut().zip(states).for_each(|(y, lanes)| *y = lanes.0[lane]);
                members.ended(number, &self.state, self.steps[lane], self.times.0[lane], failure);
                self.admit(lane, members);
            }
        }
    }

    /// Projects the states after this step onto their constraints and integrals.
    fn project(&mut self, nexts: [Result<f64, Failure>; L], members: &mut impl Members) {
        for (lane, next) in nexts.into_iter().enumerate() {
            let (Some(number), Ok(next)) = (self.numbers[lane], next) else { continue };
            self.state.iter_mut().zip(&self.states).for_each(|(y, lanes)| *y = lanes.0[lane]);
            if members.project(number, next, &mut self.state) {
                self.states.iter_mut().zip(&self.state).for_each(|(lanes, y)| lanes.0[lane] = *y);
            }
        }
    }

    /// Time and state at which members leave the range of validity of their laws within this step; `None` in the other
    /// lanes.
    fn leave(&self, nexts: [Result<f64, Failure>; L], members: &mut impl Members) -> [Option<(f64, Vec<f64>)>; L] {
        std::array::from_fn(|lane| {
            let (number, end, begin) = (self.numbers[lane]?, nexts[lane].ok()?, self.times.0[lane]);
            let state_at = |time: f64, state: &mut [f64]| {
                let mut lanes = vec![Batch::all(0.0); state.len()];
                self.source.sum(Batch::all(time - begin), &mut lanes);
                state.iter_mut().zip(lanes).for_each(|(part, lanes)| *part = lanes.0[lane]);
            };
            let left = members.leaves(number, &BatchStep { begin, end, state_at: &state_at })?;
            let mut state = vec![0.0; self.states.len()];
            state_at(left, &mut state);
            Some((left, state))
        })
    }

    /// The end of the next step of a lane, for the step size `reach` that its series allows.
    fn next_time(&self, lane: usize, reach: f64) -> Result<f64, Failure> {
        let at = self.times.0[lane];
        if reach.is_nan() {
            return Err(Failure::LeftTheNumbers { at });
        }
        if self.steps[lane] == self.most_steps {
            let allowed = self.most_steps.saturating_mul(self.order as u64);
            return Err(Failure::TooManyEvaluations { at, allowed });
        }
        let next = if reach >= self.end - at { self.end } else { at + reach };
        if next == at { Err(Failure::StepCollapsed { at, step: reach }) } else { Ok(next) }
    }

    fn admit(&mut self, lane: usize, members: &mut impl Members) {
        self.numbers[lane] = members.next(&mut self.parameters, &mut self.state);
        if self.numbers[lane].is_some() {
            self.source.set(lane, &self.parameters);
            self.states.iter_mut().zip(&self.state).for_each(|(lanes, y)| lanes.0[lane] = *y);
            (self.times.0[lane], self.steps[lane]) = (0.0, 0);
        }
    }
}

/// The step sizes that the series allow, one per lane; NaN where a coefficient is not finite.
struct Reach<'a, const L: usize> {
    states: &'a [Batch<L>],
    last: &'a [Batch<L>],
    before: &'a [Batch<L>],
    order: usize,
    tolerance: f64,
}

impl<const L: usize> WithSimd for Reach<'_, L> {
    type Output = Batch<L>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Batch<L> {
        // largest coefficients divided by the tolerance, and their sum, which detects values that are not finite
        let [mut s_last, mut s_before, mut sum] = [Batch::all(0.0); 3];
        for ((state, last), before) in self.states.iter().zip(self.last).zip(self.before) {
            for lane in 0..L {
                let share = 1.0 / (self.tolerance + self.tolerance * state.0[lane].abs());
                let (a, b) = (last.0[lane].abs() * share, before.0[lane].abs() * share);
                s_last.0[lane] = if a > s_last.0[lane] { a } else { s_last.0[lane] };
                s_before.0[lane] = if b > s_before.0[lane] { b } else { s_before.0[lane] };
                sum.0[lane] += a + b;
            }
        }
        let mut reaches = sum;
        for lane in 0..L {
            let far = reach(self.order, s_last.0[lane], s_before.0[lane]);
            reaches.0[lane] = if sum.0[lane].is_finite() { far } else { f64::NAN };
        }
        reaches
    }
}
