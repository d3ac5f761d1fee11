//! Error estimates of reduced models: the propagated error at every step of the error equation, and at equidistant
//! times.

use super::error_propagation::carried;
use super::outputs::{Watched, largest};
use super::sampled_run::{COARSE, followed_at, followed_while, looks};
use super::{Hierarchy, ReducedModel};
use integrators::{Absolute, Failure, Record, Refusal, Tolerance};
use simulation::CompiledLaw;

/// The relative tolerance of the error equation, whose solution is needed to 1/100.
const CARRIED: f64 = 1e-4;
/// The required accuracy of the error, as a fraction of the allowed error.
const OF_ALLOWED: f64 = 1e-2;

/// The error estimate of a model: for each output the largest error over the run, relative to its size.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    pub each: Vec<f64>,
    /// The largest first-order error over the outputs.
    pub first: f64,
    /// The time of the largest error, s.
    pub at: f64,
    /// The largest second-order term; the estimate is not credible unless this is small compared with the first order.
    pub second: f64,
    /// The number of evaluations of the error equation.
    pub evaluations: u64,
    /// Times with the rows of the reduced model's run, corrected by the first-order error: one order more accurate,
    /// with unknown error.
    pub corrected: Vec<(f64, Vec<f64>)>,
    /// The largest value of the small parameter along the reduced model's run, where defined.
    pub small: Option<f64>,
    /// Whether the run was stopped because the error exceeds the allowed one: the estimate is then a lower bound of the
    /// estimated error.
    pub given_up: bool,
}

impl Estimate {
    /// The estimate of an exact model.
    pub fn nothing(outputs: usize) -> Self {
        Estimate {
            each: vec![0.0; outputs],
            first: 0.0,
            at: 0.0,
            second: 0.0,
            evaluations: 0,
            corrected: Vec::new(),
            small: None,
            given_up: false,
        }
    }

    /// The sum of first and second order, which is compared with tolerances.
    pub fn promised(&self) -> f64 {
        self.first + self.second
    }
}

/// The interpretation of a state (z, a, b) of the error equation: reduced model, first-order and second-order error.
pub(super) struct Carrying<'a> {
    pub watched: &'a Watched,
    /// The lift Y(t, z).
    pub lift: &'a dyn Fn(f64, &[f64]) -> Vec<f64>,
    /// The row of outputs from a state of the full law.
    pub row: &'a dyn Fn(f64, &[f64]) -> Vec<f64>,
    /// The small parameter at a state of the reduced model.
    pub small: &'a dyn Fn(f64, &[f64]) -> Option<f64>,
    /// The number of retained states.
    pub kept: usize,
}

impl Carrying<'_> {
    /// Integrates the error equation from a start, law after law, each to its end time. `sizes` of z scale the absolute
    /// tolerances of the integration, `tolerance` those of the errors. Stops at the first step or output time at which
    /// the estimate exceeds `most`.
    ///
    /// # Errors
    /// [`Failure`] of a run.
    pub fn estimate(
        &self,
        laws: &[(f64, CompiledLaw)],
        mut start: Vec<f64>,
        sizes: &[f64],
        tolerance: f64,
        most: f64,
    ) -> Result<Estimate, Failure> {
        let errors = || self.watched.states.iter().map(|size| OF_ALLOWED * tolerance * size);
        let absolute = sizes.iter().map(|size| CARRIED * size).chain(errors()).chain(errors()).collect();
        let allowed = Tolerance { relative: CARRIED, absolute: Absolute::Each(absolute) };
        let mut found = Estimate::nothing(self.watched.columns.len());
        found.small = (self.small)(0.0, &start[..self.kept]);
        let mut stiff = self.watched.stiff;
        let (mut from, end) = (0.0, laws.last().map_or(0.0, |(end, _)| *end));
        for (to, law) in laws {
            let mut outputs: Vec<f64> = looks(end).filter(|time| *time > from && time < to).collect();
            outputs.push(*to);
            let (before, mut last) = (found.clone(), from);
            let mut goes_on = |time: f64, state: &[f64]| {
                if time < last {
                    found = before.clone();
                }
                last = time;
                self.add(&mut found, time, state);
                found.promised() <= most
            };
            let (record, evaluations) =
                followed_while(law, &allowed, from, &outputs, &start, &mut stiff, &mut goes_on)?;
            found.evaluations += evaluations;
            if !found.promised().is_finite() {
                return Err(Failure::LeftTheNumbers { at: last });
            }
            found.given_up = found.promised() > most;
            if found.given_up {
                break;
            }
            start = record.states.into_iter().next_back().unwrap_or(start);
            from = *to;
        }
        Ok(found)
    }

    /// Updates the estimate by the errors at a time.
    fn add(&self, found: &mut Estimate, time: f64, state: &[f64]) {
        let (z, errors) = state.split_at(self.kept);
        let y = (self.lift)(time, z);
        let row = (self.row)(time, &y);
        let moved = |error: &[f64]| {
            let moved: Vec<f64> = y.iter().zip(error).map(|(y, e)| y + e).collect();
            (self.row)(time, &moved)
        };
        let (first, second) = (moved(&errors[..y.len()]), moved(&errors[y.len()..]));
        let Watched { columns, sizes, .. } = self.watched;
        // NaN if one of them is, which f64::max would hide
        let larger = |a: f64, b: f64| if a >= b || a.is_nan() { a } else { b };
        for (each, (&at, size)) in found.each.iter_mut().zip(columns.iter().zip(sizes)) {
            *each = larger(*each, (first[at] - row[at]).abs() / size);
            if larger(found.first, *each) != found.first {
                (found.first, found.at) = (*each, time);
            }
        }
        found.second = larger(found.second, self.watched.off(&second, &row));
        found.small = (self.small)(time, z).map(|value| value.max(found.small.unwrap_or(0.0)));
        if found.corrected.last().is_none_or(|(last, _)| *last < time) {
            found.corrected.push((time, first));
        }
    }
}

impl Hierarchy {
    /// The error estimate of a reduced model in the outputs, to a fraction of the tolerance.
    ///
    /// # Errors
    /// [`Failure`] of the run: the reduced model's motion may leave the domain of the full law.
    pub fn estimate(&self, reduced: &ReducedModel, watched: &Watched, tolerance: f64) -> Result<Estimate, Failure> {
        self.estimate_within(reduced, watched, tolerance, f64::INFINITY)
    }

    /// The error estimate of a reduced model, stopped at the first step or output time at which it exceeds `most`.
    ///
    /// # Errors
    /// [`Failure`] of the run: the reduced model's motion may leave the domain of the full law.
    pub fn estimate_within(
        &self,
        reduced: &ReducedModel,
        watched: &Watched,
        tolerance: f64,
        most: f64,
    ) -> Result<Estimate, Failure> {
        if reduced.is_exact() {
            return Ok(Estimate::nothing(watched.columns.len()));
        }
        let (n, span) = (self.start.len(), self.own.span);
        let law = carried(&self.written, &reduced.lower).ok_or(Failure::Refused(Refusal::NoSeries))?;
        let y0 = reduced.lifted(0.0, &reduced.start, n);
        let first = self.start.iter().zip(&y0).map(|(y, lifted)| y - lifted);
        let start = reduced.start.iter().copied().chain(first).chain(vec![0.0; n]).collect();
        let sizes: Vec<f64> = match &reduced.lower.kept {
            Some(places) => places.iter().map(|&place| watched.states[place]).collect(),
            // the sizes of other states come from a coarse run of the reduced model
            None => {
                let looks: Vec<f64> = looks(span).collect();
                let (coarse, _) = followed_at(&*reduced.law, &Tolerance::both(COARSE), &looks, &reduced.start)?;
                let states = || coarse.states.iter().chain([&reduced.start]);
                (0..reduced.start.len()).map(|i| largest(states().map(|state| state[i]))).collect()
            }
        };
        let carrying = Carrying {
            watched,
            lift: &|time, z| reduced.lifted(time, z, n),
            row: &|time, y| self.row(time, y),
            small: &|time, z| {
                let small = reduced.small.as_ref()?;
                let mut rates = vec![0.0; z.len()];
                reduced.law.rates(time, z, &mut rates);
                small(z, &rates)
            },
            kept: reduced.start.len(),
        };
        carrying.estimate(&[(span, law)], start, &sizes, tolerance, most)
    }

    /// The largest difference of the outputs, relative to their sizes, between the runs of a reduced model and of the
    /// law from which it is derived.
    pub fn difference(&self, reduced: &ReducedModel, low: &Record<f64>, rich: &Record<f64>, watched: &Watched) -> f64 {
        let at = |((time, z), y): ((&f64, &Vec<f64>), &Vec<f64>)| {
            let low = self.row(*time, &reduced.lifted(*time, z, self.start.len()));
            watched.off(&low, &self.row(*time, y))
        };
        low.times.iter().zip(&low.states).zip(&rich.states).map(at).fold(0.0, f64::max)
    }
}
