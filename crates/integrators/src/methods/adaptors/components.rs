//! State vectors for the crate `differential-equations`.

use differential_equations::traits::State;
use std::cell::Cell;

/// A state vector with the dimension of the law, or padded with constant components.
pub(super) trait Components: State<f64> {
    fn of(values: &[f64]) -> Self;
    fn values(&self) -> &[f64];
    fn values_mut(&mut self) -> &mut [f64];
}

impl<const N: usize> Components for [f64; N] {
    fn of(values: &[f64]) -> Self {
        std::array::from_fn(|i| values.get(i).copied().unwrap_or(0.0))
    }

    fn values(&self) -> &[f64] {
        self
    }

    fn values_mut(&mut self) -> &mut [f64] {
        self
    }
}

/// A state vector of any dimension.
#[derive(Clone, Debug)]
pub(super) struct Vector(Vec<f64>);

thread_local! {
    /// The dimension of the states of this thread: the crate constructs zero states before it has seen a state.
    static LENGTH: Cell<usize> = const { Cell::new(0) };
}

impl Vector {
    /// Sets the dimension. Needed before a method is constructed and before each of its steps, since a law may run a
    /// method of its own.
    pub fn set_length(length: usize) {
        LENGTH.set(length);
    }
}

impl Components for Vector {
    fn of(values: &[f64]) -> Self {
        Vector(values.to_vec())
    }

    fn values(&self) -> &[f64] {
        &self.0
    }

    fn values_mut(&mut self) -> &mut [f64] {
        &mut self.0
    }
}

impl State<f64> for Vector {
    fn len(&self) -> usize {
        self.0.len()
    }

    fn get_component(&self, index: usize) -> f64 {
        self.0[index]
    }

    fn set_component(&mut self, index: usize, value: f64) {
        self.0[index] = value;
    }

    fn map_components_mut<F: FnMut(usize, &mut f64)>(&mut self, mut f: F) {
        self.0.iter_mut().enumerate().for_each(|(i, value)| f(i, value));
    }

    fn zeros_like(&self) -> Self {
        Vector(vec![0.0; self.0.len()])
    }

    fn zeros() -> Self {
        Vector(vec![0.0; LENGTH.get()])
    }

    fn mul_add_assign(&mut self, factor: f64, other: &Self) {
        self.0.iter_mut().zip(&other.0).for_each(|(own, other)| *own += factor * other);
    }

    fn add_scaled(&mut self, factor: f64, other: &Self) -> &mut Self {
        self.mul_add_assign(factor, other);
        self
    }

    fn scale_mut(&mut self, factor: f64) {
        self.0.iter_mut().for_each(|own| *own *= factor);
    }

    fn copy_from_state(&mut self, other: &Self) {
        self.0.clone_from(&other.0);
    }
}
