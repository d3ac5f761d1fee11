//! The dual-weighted error of a reduced model by transition matrices: contributions along the run, for each output.
//!
//! The run is divided into intervals. Over each interval the full law starts on the lifted motion and deviates from it
//! by the local defect D_k = y(t_(k+1); Y_k) - Y_(k+1); its transition matrix is P_k. To first order the error at the
//! end of the interval K is
//!
//!   e = sum_k P_K ... P_(k+1) D_k + P_K ... P_0 e_0 ,
//!
//! For an output q.y the weights q P_K ... P_(k+1) of all D_k follow from one backward pass. To first order this error
//! equals that of [`error_propagation`](super::error_propagation); in addition it shows which intervals need the full
//! model.

use super::outputs::Watched;
use super::sampled_run::INSTANTS;
use super::{Hierarchy, ReducedModel};
use integrators::{Failure, Record, Span, Tolerance, integrate, transition};
use integrators::{Method, System};

/// The contributions of the intervals to an error.
#[derive(Clone, Debug, PartialEq)]
pub struct Shares {
    /// The ends of the intervals, s.
    pub times: Vec<f64>,
    /// `parts[i][k]`: the contribution of interval k to the final error of output i, relative to its size.
    pub parts: Vec<Vec<f64>>,
    /// The contribution of the initial distance from the lifted motion, for each output.
    pub start: Vec<f64>,
    /// The error of each output at each output time, relative to its size.
    pub errors: Vec<Vec<f64>>,
}

impl Hierarchy {
    /// The contributions of `stretches` intervals, a multiple of the number of output times.
    ///
    /// # Errors
    /// [`Failure`] of a run, or for a full law without Taylor series.
    pub fn shares(
        &self,
        reduced: &ReducedModel,
        watched: &Watched,
        rich: &dyn System,
        stretches: usize,
        tolerance: f64,
    ) -> Result<Shares, Failure> {
        let n = self.start.len();
        let span = Span::new(0.0, self.own.span, &reduced.start).with_even_outputs(stretches);
        let mut record = Record::new();
        let outcome = integrate(&*reduced.law, Method::DormandPrince8, &Tolerance::both(tolerance), &span, &mut record);
        if let Some(failure) = outcome.failure() {
            return Err(failure);
        }
        let times: Vec<f64> = std::iter::once(0.0).chain(record.times.iter().copied()).collect();
        let states = std::iter::once(&reduced.start).chain(&record.states);
        let lifted: Vec<Vec<f64>> = times.iter().zip(states).map(|(time, z)| reduced.lifted(*time, z, n)).collect();
        let mut found: Vec<(Vec<f64>, Vec<f64>)> = Vec::new();
        for k in 0..stretches {
            let flown = transition(rich, &Tolerance::both(tolerance), (times[k], times[k + 1]), &lifted[k])?;
            let defect = flown.state.iter().zip(&lifted[k + 1]).map(|(y, lifted)| y - lifted).collect();
            found.push((flown.matrix, defect));
        }
        let first: Vec<f64> = self.start.iter().zip(&lifted[0]).map(|(y, lifted)| y - lifted).collect();
        let weights = |end: usize| -> Vec<Vec<f64>> {
            let outputs = watched.columns.iter().zip(&watched.sizes);
            outputs.map(|(&column, size)| self.output(column, *size, times[end], &lifted[end])).collect()
        };
        let back = |mut weight: Vec<f64>, end: usize| {
            let mut parts = vec![0.0; end];
            for k in (0..end).rev() {
                let (matrix, defect) = &found[k];
                parts[k] = dot(&weight, defect);
                weight = (0..n).map(|j| (0..n).map(|i| weight[i] * matrix[i * n + j]).sum()).collect();
            }
            (parts, dot(&weight, &first))
        };
        let (parts, start): (Vec<_>, Vec<_>) =
            weights(stretches).into_iter().map(|weight| back(weight, stretches)).unzip();
        let mut errors = vec![Vec::new(); watched.columns.len()];
        for instant in 1..=INSTANTS {
            let end = stretches * instant / INSTANTS;
            for (errors, weight) in errors.iter_mut().zip(weights(end)) {
                let (parts, start) = back(weight, end);
                errors.push(parts.iter().sum::<f64>() + start);
            }
        }
        Ok(Shares { times: times[1..].to_vec(), parts, start, errors })
    }

    /// The gradient q of an output, relative to its size, by differences: rows are affine in the state.
    pub(super) fn output(&self, column: usize, size: f64, time: f64, state: &[f64]) -> Vec<f64> {
        let mut moved = state.to_vec();
        let slope = |j: usize, moved: &mut Vec<f64>| {
            let mut value = |by: f64| {
                moved[j] = state[j] + by;
                let value = self.row(time, moved)[column];
                moved[j] = state[j];
                value
            };
            let by = state[j].abs().max(1.0);
            (value(by) - value(-by)) / (2.0 * by * size)
        };
        (0..state.len()).map(|j| slope(j, &mut moved)).collect()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
