//! Observers of a run.

/// Receives the states of a run at the requested outputs, and its progress. All methods have an empty default.
pub trait Observer<S> {
    /// Called with the state at a requested output.
    fn sample(&mut self, _time: f64, _state: &[S]) {}

    /// Called with the state after each accepted step.
    fn step(&mut self, _time: f64, _state: &[S]) {}

    /// Called before [`Observer::step`] if the method's step is a polynomial: `_state_at` gives the state at any time
    /// of the step.
    fn between(&mut self, _begin: f64, _end: f64, _state_at: &dyn Fn(f64, &mut [S])) {}

    /// As [`Observer::sample`], near a singular position of the constraints, where reactions computed from the state
    /// are inaccurate: they may be interpolated between the states `_nodes` (time, state) on both sides.
    fn sample_between(&mut self, time: f64, state: &[S], _nodes: &[(f64, Vec<S>)]) {
        self.sample(time, state);
    }

    /// Called when the motion has passed a singular position of the constraints on its smooth branch. `_error` is the
    /// difference of two Taylor series beyond the position, relative to the largest component; `_nodes` are states on
    /// both sides.
    fn singular_position(&mut self, _time: f64, _state: &[S], _error: f64, _nodes: &[(f64, Vec<S>)]) {}

    /// Called after every accepted step with the completed fraction of the span.
    fn progress(&mut self, _fraction: f64) {}

    /// Whether the run should end after the present step.
    fn enough(&self) -> bool {
        false
    }
}

/// An observer that does nothing.
impl<S> Observer<S> for () {}

/// An observer that stores the samples.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record<S> {
    pub times: Vec<f64>,
    /// One state for each time.
    pub states: Vec<Vec<S>>,
}

impl<S> Record<S> {
    /// A record without samples.
    pub fn new() -> Self {
        Record { times: Vec::new(), states: Vec::new() }
    }
}

impl<S: Clone> Observer<S> for Record<S> {
    fn sample(&mut self, time: f64, state: &[S]) {
        self.times.push(time);
        self.states.push(state.to_vec());
    }
}

/// An observer that calls a closure with every sample.
pub struct Samples<F>(pub F);

impl<S, F: FnMut(f64, &[S])> Observer<S> for Samples<F> {
    fn sample(&mut self, time: f64, state: &[S]) {
        (self.0)(time, state);
    }
}

/// An observer that calls a closure with the completed fraction, for a progress bar.
pub struct Progress<F>(pub F);

impl<S, F: FnMut(f64)> Observer<S> for Progress<F> {
    fn progress(&mut self, fraction: f64) {
        (self.0)(fraction);
    }
}

/// An observer that records the largest magnitude of every component over all steps.
#[derive(Clone, Debug)]
pub struct Sizes(pub Vec<f64>);

impl Observer<f64> for Sizes {
    fn step(&mut self, _: f64, state: &[f64]) {
        self.0.iter_mut().zip(state).for_each(|(size, y)| *size = size.max(y.abs()));
    }
}

/// Two observers at once.
impl<S, A: Observer<S>, B: Observer<S>> Observer<S> for (A, B) {
    fn sample(&mut self, time: f64, state: &[S]) {
        self.0.sample(time, state);
        self.1.sample(time, state);
    }

    fn step(&mut self, time: f64, state: &[S]) {
        self.0.step(time, state);
        self.1.step(time, state);
    }

    fn sample_between(&mut self, time: f64, state: &[S], nodes: &[(f64, Vec<S>)]) {
        self.0.sample_between(time, state, nodes);
        self.1.sample_between(time, state, nodes);
    }

    fn singular_position(&mut self, time: f64, state: &[S], error: f64, nodes: &[(f64, Vec<S>)]) {
        self.0.singular_position(time, state, error, nodes);
        self.1.singular_position(time, state, error, nodes);
    }

    fn progress(&mut self, fraction: f64) {
        self.0.progress(fraction);
        self.1.progress(fraction);
    }

    fn enough(&self) -> bool {
        self.0.enough() || self.1.enough()
    }
}

impl<S, T: Observer<S> + ?Sized> Observer<S> for &mut T {
    fn sample(&mut self, time: f64, state: &[S]) {
        (**self).sample(time, state);
    }

    fn step(&mut self, time: f64, state: &[S]) {
        (**self).step(time, state);
    }

    fn sample_between(&mut self, time: f64, state: &[S], nodes: &[(f64, Vec<S>)]) {
        (**self).sample_between(time, state, nodes);
    }

    fn singular_position(&mut self, time: f64, state: &[S], error: f64, nodes: &[(f64, Vec<S>)]) {
        (**self).singular_position(time, state, error, nodes);
    }

    fn progress(&mut self, fraction: f64) {
        (**self).progress(fraction);
    }

    fn enough(&self) -> bool {
        (**self).enough()
    }
}
