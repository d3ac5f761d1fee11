//! How far a lower model is off: the carried error at every step of the run that carries it, and at even instants besides.

use super::error_propagation::carried;
use super::outputs::{Watched, largest};
use super::sampled_run::{COARSE, followed_at, followed_while, looks};
use super::{Hierarchy, ReducedModel};
use integrators::{Absolute, Failure, Record, Refusal, Tolerance};
use simulation::CompiledLaw;

/// Relative, of an error that is carried: it is wanted to a hundredth of itself.
const CARRIED: f64 = 1e-4;
/// The error need not be known better than to this share of what is allowed.
const OF_ALLOWED: f64 = 1e-2;

/// What a model loses, estimated: relative to the sizes, the largest over the run, for each output.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    pub each: Vec<f64>,
    /// The largest of them.
    pub first: f64,
    /// The time of it, s.
    pub at: f64,
    /// The largest term of the second order: where it is not small beside the first, the estimate is no estimate.
    pub second: f64,
    /// Of the law that carries the error.
    pub evaluations: u64,
    /// Times with the rows of the lower run there, the first order added: better by an order, and of unknown error.
    pub corrected: Vec<(f64, Vec<f64>)>,
    /// The largest value of the small parameter along the lower run, where it has one.
    pub small: Option<f64>,
    /// Whether it was not followed to the end, being beyond all that is allowed: then it is at least this.
    pub given_up: bool,
}

impl Estimate {
    /// Of a step that loses nothing.
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

    /// What is promised: both orders.
    pub fn promised(&self) -> f64 {
        self.first + self.second
    }
}

/// How (z, a, b) is read: the lower motion with the error that it makes.
pub(super) struct Carrying<'a> {
    pub watched: &'a Watched,
    /// Y(t, z)
    pub lift: &'a dyn Fn(f64, &[f64]) -> Vec<f64>,
    /// Of the richer law.
    pub row: &'a dyn Fn(f64, &[f64]) -> Vec<f64>,
    /// Of the lower motion.
    pub small: &'a dyn Fn(f64, &[f64]) -> Option<f64>,
    /// How many states are followed.
    pub kept: usize,
}

impl Carrying<'_> {
    /// Carries from a start, law after law, each to its time. It may err by so much of the sizes of z, and by a small part of
    /// this tolerance in the errors. Given up at the first step or instant at which more than `most` would be promised.
    ///
    /// # Errors
    /// Where a law does not reach its end.
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

    /// What is off at a time.
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
        // no number where one of them is none: of those the largest is not asked for
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
    /// The loss of a reduced model in the outputs; the tolerance says how well that need be known.
    ///
    /// # Errors
    /// Where the carried error does not reach the end: the lower motion leaves what the richer law allows.
    pub fn estimate(&self, rung: &ReducedModel, watched: &Watched, tolerance: f64) -> Result<Estimate, Failure> {
        self.estimate_within(rung, watched, tolerance, f64::INFINITY)
    }

    /// The same, given up at the first step or instant at which more than this would be promised.
    ///
    /// # Errors
    /// As [`Self::estimate`].
    pub fn estimate_within(
        &self,
        rung: &ReducedModel,
        watched: &Watched,
        tolerance: f64,
        most: f64,
    ) -> Result<Estimate, Failure> {
        if rung.is_exact() {
            return Ok(Estimate::nothing(watched.columns.len()));
        }
        let (n, span) = (self.start.len(), self.own.span);
        let law = carried(&self.written, &rung.lower).ok_or(Failure::Refused(Refusal::NoSeries))?;
        let y0 = rung.lifted(0.0, &rung.start, n);
        let first = self.start.iter().zip(&y0).map(|(y, lifted)| y - lifted);
        let start = rung.start.iter().copied().chain(first).chain(vec![0.0; n]).collect();
        let sizes: Vec<f64> = match &rung.lower.kept {
            Some(places) => places.iter().map(|&place| watched.states[place]).collect(),
            // how large states of its own become, its own run tells
            None => {
                let looks: Vec<f64> = looks(span).collect();
                let (coarse, _) = followed_at(&*rung.law, &Tolerance::both(COARSE), &looks, &rung.start)?;
                let states = || coarse.states.iter().chain([&rung.start]);
                (0..rung.start.len()).map(|i| largest(states().map(|state| state[i]))).collect()
            }
        };
        let carrying = Carrying {
            watched,
            lift: &|time, z| rung.lifted(time, z, n),
            row: &|time, y| self.row(time, y),
            small: &|time, z| {
                let small = rung.small.as_ref()?;
                let mut rates = vec![0.0; z.len()];
                rung.law.rates(time, z, &mut rates);
                small(z, &rates)
            },
            kept: rung.start.len(),
        };
        carrying.estimate(&[(span, law)], start, &sizes, tolerance, most)
    }

    /// The largest difference of two runs in the outputs, relative to the sizes: a reduced model's beside the law that it is derived
    /// from.
    pub fn difference(&self, rung: &ReducedModel, low: &Record<f64>, rich: &Record<f64>, watched: &Watched) -> f64 {
        let at = |((time, z), y): ((&f64, &Vec<f64>), &Vec<f64>)| {
            let low = self.row(*time, &rung.lifted(*time, z, self.start.len()));
            watched.off(&low, &self.row(*time, y))
        };
        low.times.iter().zip(&low.states).zip(&rich.states).map(at).fold(0.0, f64::max)
    }
}
