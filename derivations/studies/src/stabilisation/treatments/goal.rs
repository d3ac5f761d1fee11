//! The motion for the comparison of treatments: span, start, exact solution, and errors of a run.

use crate::stabilisation::law::{Stabilised, state};
use crate::stabilisation::regions::MECHANISM;
use field::{Analytic, DoubleDouble, Over};
use integrators::{Failure, Observer, Span, System, reference};
use mechanics::constrained::energies::{Reduced, violation};
use systems::crank_slider::CrankSlider;

/// The span, s: the crank starts at 0.7 rad with 6 rad/s and makes about nine turns.
pub const SPAN: f64 = 10.0;
pub(super) const START: [f64; 2] = [0.7, 6.0];
const OUTPUTS: usize = 100;

/// The law in a minimal coordinate.
pub(super) fn reduced() -> impl System {
    const REDUCED: Reduced<'static, CrankSlider<f64>, 2, 1> = Reduced(&MECHANISM);
    Stabilised::<_, 1, 0> { system: &REDUCED, damping: 0.0, stiffness: 0.0 }
}

/// The full state (q, q') from the minimal coordinate and its rate.
pub(super) fn whole<S: Over<f64> + Analytic>(s: &[S]) -> [S; 4] {
    let (q, dq) = Reduced(&MECHANISM).motion(S::zero(), [s[0]], [s[1]]);
    [q[0], q[1], dq[0], dq[1]]
}

/// The span with its outputs.
pub(super) fn span(start: &[f64]) -> Span<'static, f64> {
    Span::new(0.0, SPAN, start).with_even_outputs(OUTPUTS)
}

/// The exact motion at the outputs.
pub struct Goal {
    states: Vec<[f64; 4]>,
    sizes: [f64; 4],
}

impl Goal {
    /// The reference motion, computed in the minimal coordinate.
    ///
    /// # Errors
    /// [`Failure`] of the reference.
    pub fn new() -> Result<Self, Failure> {
        let exact = reference(&reduced(), &span(&START))?;
        let states: Vec<[f64; 4]> =
            exact.states.iter().map(|s| whole::<DoubleDouble>(s).map(|value| value.hi())).collect();
        let sizes = std::array::from_fn(|i| states.iter().map(|s| s[i].abs()).fold(0.0, f64::max));
        Ok(Goal { states, sizes })
    }

    /// An observer that measures the errors of a run.
    pub(super) fn watch(&self, minimal: bool) -> Watch<'_> {
        Watch { goal: self, minimal, seen: 0, drift: 0.0, rate_drift: 0.0, error: 0.0 }
    }
}

/// An observer of the constraint after each step, and of the error at the outputs.
pub(super) struct Watch<'a> {
    goal: &'a Goal,
    /// Whether the state is that of the minimal coordinate.
    minimal: bool,
    seen: usize,
    pub drift: f64,
    pub rate_drift: f64,
    pub error: f64,
}

impl Watch<'_> {
    fn whole(&self, y: &[f64]) -> [f64; 4] {
        if self.minimal { whole(y) } else { std::array::from_fn(|i| y[i]) }
    }
}

impl Observer<f64> for Watch<'_> {
    fn step(&mut self, _time: f64, y: &[f64]) {
        let found = violation(&MECHANISM, &state::<f64, 2>(0.0, &self.whole(y)));
        self.drift = self.drift.max(found.value[0].abs());
        self.rate_drift = self.rate_drift.max(found.rate[0].abs());
    }

    fn sample(&mut self, _time: f64, y: &[f64]) {
        let all = self.whole(y);
        if let Some(right) = self.goal.states.get(self.seen) {
            let errors = (0..4).map(|i| (all[i] - right[i]).abs() / self.goal.sizes[i]);
            self.error = errors.fold(self.error, f64::max);
        }
        self.seen += 1;
    }
}
