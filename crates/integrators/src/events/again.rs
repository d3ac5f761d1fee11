//! Repeated integration within a step, to locate events.

use super::gap::Gap;
use super::{Instant, Switches};
use crate::methods::taylor::{Taylor, taylor_order};
use crate::{Method, Span, System, TaylorSeries, Tolerance, Work, integrate};

/// The largest number of iterations. Bisection gains one bit per iteration, and a double has fewer bits than this.
const MOST_TRIALS: usize = 120;

/// A gap must be narrower than this fraction of the interval for its chord to replace the motion.
const NARROW: f64 = 1e-4;

/// The change of the function across such a gap must be smaller than this fraction of its change over the interval.
const SMOOTH: f64 = 1e-2;

/// The law may be undefined within the step if the square of a distance is below this value.
const BESIDE: f64 = 0.02;

/// The budget of evaluations for a part of a step: `PATIENCE` times (`PATIENCE` plus the number of states).
const PATIENCE: u64 = 50;

/// Computes states within a step of a run by a second integration from the beginning of the step.
pub(super) struct Again<'a> {
    pub system: &'a dyn System,
    pub method: Method,
    pub tolerance: &'a Tolerance,
    pub switches: &'a dyn Switches,
    pub evaluations: u64,
    /// The Taylor series of the motion with its expansion point, for methods that provide one.
    pub series: Option<Box<dyn TaylorSeries<f64> + 'a>>,
    pub expanded_at: Option<f64>,
    /// Whether the motion could not be computed at or beyond the last root.
    pub is_blocked: bool,
    /// The work of the repeated integrations.
    pub extra: Work,
}

impl Again<'_> {
    /// The state and signals at `time`, integrated from an earlier instant in the same step; `None` where this
    /// integration fails.
    pub fn at(&mut self, step: &Instant, from: &Instant, time: f64) -> Option<Instant> {
        let mut instant = from.clone();
        if time == from.time {
            return Some(instant);
        }
        if let Some(series) = &mut self.series {
            if self.expanded_at != Some(step.time) {
                let order = taylor_order(self.tolerance.relative);
                series.expand(step.time, &step.state, order);
                self.extra.rates += order as u64;
                self.expanded_at = Some(step.time);
            }
            let mut state = from.state.clone();
            series.sum(time - step.time, &mut state);
            if let Some(projection) = self.system.projection() {
                projection.project(time, &mut state);
            }
            instant.move_to(self.switches, time, &state);
            return Some(instant);
        }
        // a part of a step needs few evaluations; near a singularity no budget would suffice
        let most = self.evaluations.min(PATIENCE * (from.state.len() as u64 + PATIENCE));
        let span = || Span::new(from.time, time, &from.state).with_evaluations(most);
        let run = |span: &Span<'_, f64>| integrate(self.system, self.method, self.tolerance, span, &mut ());
        let mut outcome = run(&span().within_step());
        self.extra = self.extra + outcome.work;
        if !outcome.reached() {
            outcome = run(&span());
            self.extra = self.extra + outcome.work;
        }
        if !outcome.reached() {
            return self.by_series(from, time);
        }
        instant.move_to(self.switches, time, &outcome.state);
        Some(instant)
    }

    /// The instant by the Taylor series of the motion, where a distance may vanish: the stages of other methods would
    /// lie close to the singularity of the law. `None` where the law has no series, or a series with branches.
    fn by_series(&self, from: &Instant, time: f64) -> Option<Instant> {
        if !from.signals.iter().any(|signal| signal.pace.near > 0.0 && signal.value <= BESIDE) {
            return None;
        }
        let series = self.system.taylor().filter(|series| !series.has_branches())?;
        let (mut state, mut taylor) = (from.state.clone(), Taylor::new(series, self.tolerance));
        taylor.propagate(from.time, time, &mut state).ok()?;
        if let Some(projection) = self.system.projection() {
            projection.project(time, &mut state);
        }
        let mut instant = from.clone();
        instant.move_to(self.switches, time, &state);
        Some(instant)
    }

    /// The zero of a function of the signals which is nonnegative at the beginning, by Newton's method with bisection
    /// as a safeguard. Returns the zero and the last instant at which the function was positive. Where the motion
    /// cannot be integrated close to the zero, as at a coordinate singularity, the zero of the chord across that gap is
    /// returned. With `ends_above`, an instant that cannot be computed counts as beyond the zero. `step` is the start of
    /// the step, `from` and `end` are the ends of the search; `function` returns the value and its rate (1/s). `None` if
    /// the integration fails otherwise.
    pub fn root(
        &mut self,
        step: &Instant,
        [from, end]: [&Instant; 2],
        ends_above: bool,
        function: impl Fn(&Instant) -> (f64, f64),
    ) -> Option<[Instant; 2]> {
        let (mut low, mut high) = (from.time, end.time);
        let (mut best, mut before, mut beyond) = (end.clone(), from.clone(), end.clone());
        let mut gap: Option<Gap> = None;
        self.is_blocked = false;
        for trial in 0..MOST_TRIALS {
            let (value, rate) = function(&best);
            if value == 0.0 {
                return Some([best, before]);
            }
            if value > 0.0 {
                low = best.time;
                before.clone_from(&best);
            } else if (best.time - from.time).abs() < (high - from.time).abs() {
                high = best.time;
                beyond.clone_from(&best);
            }
            gap = gap.filter(|gap| gap.is_between(low, high));
            let closest = f64::EPSILON * best.time.abs().max((end.time - from.time).abs());
            let newton = best.time - value / rate;
            let inside = (newton - low) * (newton - high) < 0.0;
            let next = match &gap {
                Some(gap) => gap.beside(low, high),
                // regular bisections ensure convergence where Newton's method is slow
                None if inside && trial % 8 != 7 => newton,
                None => low + 0.5 * (high - low),
            };
            if gap.as_ref().is_some_and(|gap| gap.is_settled(low, high, closest)) {
                break;
            }
            if next == low || next == high {
                // no double lies between; a signal that jumps has its new value beyond
                let found = if ends_above { before.clone() } else { beyond };
                return Some([found, before]);
            }
            if gap.is_none() && inside && (next - best.time).abs() <= closest {
                return Some([best, before]);
            }
            match self.at(step, from, next) {
                Some(found) => best = found,
                None if ends_above => {
                    high = next;
                    self.is_blocked = true;
                }
                None => gap = Some(Gap::with(gap, next)),
            }
        }
        let [left, right] = [&before, &beyond].map(|at| function(at).0);
        let is_bracketed = left > 0.0 && right <= 0.0;
        // if the motion jumps across the gap, the states on its two sides belong to different motions
        let change = (function(from).0 - function(end).0).abs();
        let is_narrow = (high - low).abs() <= NARROW * (end.time - from.time).abs() && left - right <= SMOOTH * change;
        match gap {
            None => Some([best, before]),
            Some(_) => (is_bracketed && is_narrow).then(|| [self.on_chord([&before, &beyond], function), before]),
        }
    }

    /// The instant at the zero of the chord of a function; the state is interpolated linearly.
    fn on_chord(&self, [a, b]: [&Instant; 2], function: impl Fn(&Instant) -> (f64, f64)) -> Instant {
        let (left, right) = (function(a).0, function(b).0);
        let part = if left > right { left / (left - right) } else { 1.0 };
        let between = |a: f64, b: f64| a + part * (b - a);
        let state: Vec<f64> = a.state.iter().zip(&b.state).map(|(&a, &b)| between(a, b)).collect();
        let mut instant = b.clone();
        instant.move_to(self.switches, between(a.time, b.time), &state);
        instant
    }
}
