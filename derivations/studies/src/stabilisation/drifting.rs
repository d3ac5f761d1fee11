//! A monitor of drift off a constraint f = 0 after index reduction to f'' = 0.
//!
//! With f'' = 0 each step adds h f' to the violation f, and errors of the method in f' persist. The monitor sums h f'
//! along the run. If f leaves its bounds and this sum is most of its change, the constraint drifts: stabilisation or a
//! projection is missing, and a shorter step does not help for long. Otherwise the violation has another cause.

use integrators::Observer;
use std::fmt;

/// An observer of (f, f') after every step that halts the run when f leaves its bounds.
pub struct Drifting<F> {
    violation: F,
    allowed: f64,
    first: f64,
    /// The time and (f, f') after the previous step; `summed` is the sum of h f'.
    last: Option<(f64, [f64; 2])>,
    summed: f64,
    pub found: Option<Drift>,
}

/// A violation outside its bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift {
    /// The time, s.
    pub at: f64,
    /// The residual f, in its own unit; `come` is its change since the start.
    pub violation: f64,
    pub come: f64,
    /// The sum of h f'.
    pub summed: f64,
}

impl<F: Fn(&[f64]) -> [f64; 2]> Drifting<F> {
    /// A monitor that begins at a state and allows |f| up to a bound.
    pub fn new(violation: F, (time, start): (f64, &[f64]), allowed: f64) -> Self {
        let [first, rate] = violation(start);
        Drifting { violation, allowed, first, last: Some((time, [first, rate])), summed: 0.0, found: None }
    }
}

impl<F: Fn(&[f64]) -> [f64; 2]> Observer<f64> for Drifting<F> {
    fn step(&mut self, time: f64, state: &[f64]) {
        let now = (self.violation)(state);
        if let Some((before, [_, rate])) = self.last.replace((time, now)) {
            // the mean of both ends: a variation within a step is no drift
            self.summed += 0.5 * (time - before) * (rate + now[1]);
        }
        let [f, _] = now;
        if f.abs() > self.allowed && self.found.is_none() {
            self.found = Some(Drift { at: time, violation: f, come: f - self.first, summed: self.summed });
        }
    }

    fn enough(&self) -> bool {
        self.found.is_some()
    }
}

impl Drift {
    /// Whether the sum of h f' is most of the change of f.
    pub fn by_its_rate(&self) -> bool {
        (self.come - self.summed).abs() < 0.5 * self.come.abs()
    }

    /// The name of the failure, without numbers.
    pub fn name(&self) -> &'static str {
        if self.by_its_rate() { "the constraint drifts" } else { "the constraint is violated" }
    }
}

impl fmt::Display for Drift {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Drift { at, violation, come, summed } = self;
        let share = summed / come;
        write!(
            f,
            "{}: f = {violation:.1e} at t = {at:.4} s, of which its own rate summed up is {share:.3}",
            self.name()
        )?;
        if self.by_its_rate() {
            write!(f, "; only f'' = 0 is kept: stabilise by gains, project, or hold f and f' both")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::Drifting;
    use integrators::Observer;

    /// f = 1e-3 t, and an f that jumps.
    #[test]
    fn what_its_rate_explains_is_a_drift_and_what_comes_at_once_is_none() {
        let mut steady = Drifting::new(|y: &[f64]| [1e-3 * y[0], 1e-3], (0.0, &[0.0]), 5e-4);
        let mut sudden = Drifting::new(|y: &[f64]| [if y[0] > 0.35 { 1.0 } else { 0.0 }, 1e-9], (0.0, &[0.0]), 5e-4);
        for k in 1..=10 {
            let t = 0.1 * f64::from(k);
            steady.step(t, &[t]);
            sudden.step(t, &[t]);
        }
        let steady = steady.found.expect("it leaves its bounds");
        assert!(steady.by_its_rate() && (steady.at - 0.6).abs() < 1e-12, "{steady}");
        assert!(sudden.found.is_some_and(|found| !found.by_its_rate() && (found.at - 0.4).abs() < 1e-12));
    }
}
