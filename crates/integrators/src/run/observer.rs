//! Observers of a run.

/// Shown the state at the requested outputs, and the progress of the run. All methods have an empty default.
pub trait Observer<S> {
    /// The state at a requested output.
    fn sample(&mut self, _time: f64, _state: &[S]) {}

    /// The state after an accepted step, at any time.
    fn step(&mut self, _time: f64, _state: &[S]) {}

    /// Before [`Observer::step`], where the method's step is a polynomial: the state at any time from the step's
    /// beginning to its end.
    fn between(&mut self, _begin: f64, _end: f64, _state_at: &dyn Fn(f64, &mut [S])) {}

    /// As [`Observer::sample`], beside a singular position of the constraints, where reactions at the state are not accurate: they may be
    /// interpolated between states at times on either side.
    fn sample_between(&mut self, time: f64, state: &[S], _nodes: &[(f64, Vec<S>)]) {
        self.sample(time, state);
    }

    /// A singular position of the constraints, passed on the smooth branch of the motion, with the difference of two Taylor series of it
    /// behind the position, relative to the largest component, and the states on either side.
    fn singular_position(&mut self, _time: f64, _state: &[S], _error: f64, _nodes: &[(f64, Vec<S>)]) {}

    /// The fraction of the span that is done, after every accepted step.
    fn progress(&mut self, _fraction: f64) {}

    /// Whether the observer has seen enough: the run then halts after the step that it was just shown.
    fn enough(&self) -> bool {
        false
    }
}

/// An observer that does nothing.
impl<S> Observer<S> for () {}

/// An observer that keeps the samples.
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

/// An observer that calls a closure with the fraction done: for a progress bar.
pub struct Progress<F>(pub F);

impl<S, F: FnMut(f64)> Observer<S> for Progress<F> {
    fn progress(&mut self, fraction: f64) {
        (self.0)(fraction);
    }
}

/// An observer that keeps the largest magnitude of every component.
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
