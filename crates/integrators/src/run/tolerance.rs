//! The tolerance: the largest estimated error of an accepted step.

use crate::Real;

/// A step is accepted if in every component i its estimated error is at most
/// absolute_i + relative * max(|y_i| before, |y_i| after).
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerance {
    pub relative: f64,
    pub absolute: Absolute,
}

/// The absolute part of a tolerance.
#[derive(Clone, Debug, PartialEq)]
pub enum Absolute {
    /// One number for every component.
    Same(f64),
    /// One number for each component: for states with components of different units and sizes.
    Each(Vec<f64>),
}

impl Tolerance {
    /// A tolerance with one number, relative and absolute.
    pub fn both(tolerance: f64) -> Self {
        Tolerance { relative: tolerance, absolute: Absolute::Same(tolerance) }
    }

    /// A tolerance relative to a typical size of each component, and to its present size. `sizes` has one entry for each
    /// state.
    pub fn scaled(tolerance: f64, sizes: &[f64]) -> Self {
        let absolute = sizes.iter().map(|size| tolerance * size).collect();
        Tolerance { relative: tolerance, absolute: Absolute::Each(absolute) }
    }

    /// The absolute part for component i.
    #[inline]
    pub fn absolute(&self, i: usize) -> f64 {
        match &self.absolute {
            Absolute::Same(same) => *same,
            Absolute::Each(each) => each.get(i).copied().unwrap_or(0.0),
        }
    }

    /// The allowed error of component i if its magnitude is `size`.
    #[inline]
    pub fn allowed(&self, i: usize, size: f64) -> f64 {
        self.absolute(i) + self.relative * size
    }

    /// The largest component of the error of a step from the state `before` to `after`, in units of the allowed error;
    /// `error` maps the index of a component to its error. A step with a norm above 1 is rejected. NaN
    /// where the error or the state is NaN.
    pub fn norm<S: Real>(&self, before: &[S], after: &[S], error: impl Fn(usize) -> f64) -> f64 {
        let mut largest = 0.0_f64;
        for (i, (a, b)) in before.iter().zip(after).enumerate() {
            let share = (error(i) / self.allowed(i, a.approx().abs().max(b.approx().abs()))).abs();
            if !(share.is_finite() && b.finite()) {
                return f64::NAN;
            }
            largest = largest.max(share);
        }
        largest
    }
}
