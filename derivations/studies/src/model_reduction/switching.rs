//! Switching runs: a reduced model on those intervals of a run on which it changes the outputs little.
//!
//! Along a coarse run of the full law each interval is also run with the reduced model, from the projected state; at
//! the end the state is lifted, with consistent currents. The difference is weighted by transition matrices for every
//! output at the end of every interval. The reduced model is used where this loss is below a threshold, and left where
//! it is above a higher one (hysteresis). The threshold is the largest for which the sum of the losses stays within the
//! allowed error. The estimate is of first order.

use super::loss_weights::{Knot, propagator};
use super::outputs::Watched;
use super::run_rows::{Along, Run};
use super::{Hierarchy, ReducedModel};
use integrators::{Failure, Jacobian, Method, Record, Span, Tolerance, integrate};
use nalgebra::DMatrix;
use std::time::Instant;

/// The number of intervals of a run.
pub const INTERVALS: usize = 64;
/// The number of states along each interval from which its transition matrix is computed.
const KNOTS: usize = 4;
/// The number of Jacobians along the coarse run; each is more expensive than an evaluation.
pub const LOOKING: usize = 2 * INTERVALS * KNOTS;
/// The ratio of the threshold at which the reduced model is left to that at which it is used.
const HYSTERESIS: f64 = 4.0;
/// The tolerance of the coarse run.
const COARSE: f64 = 1e-8;

/// The intervals of a switching run.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    /// The end of each interval, s, and whether the reduced model runs on it.
    pub stretches: Vec<(f64, bool)>,
    /// The error estimate of the outputs.
    pub promised: f64,
}

/// The method and tolerance of the full and of the reduced model.
pub type Sides = [(Method, f64); 2];

impl Schedule {
    /// The intervals on which the reduced model runs, s.
    pub fn spans(&self) -> Vec<(f64, f64)> {
        let mut spans: Vec<(f64, f64)> = Vec::new();
        let mut begin = 0.0;
        for &(end, low) in &self.stretches {
            match spans.last_mut() {
                Some(last) if low && last.1 == begin => last.1 = end,
                _ if low => spans.push((begin, end)),
                _ => {}
            }
            begin = end;
        }
        spans
    }

    /// The fraction of the run on which the reduced model runs.
    pub fn share(&self) -> f64 {
        self.stretches.iter().filter(|(_, low)| *low).count() as f64 / self.stretches.len() as f64
    }
}

/// A coarse run of the full law, with the sensitivities of the outputs to the state after each interval.
pub struct CoarseRun {
    /// The ends of the intervals, s.
    times: Vec<f64>,
    /// The states at the beginnings of the intervals, and at the end.
    states: Vec<Vec<f64>>,
    /// For each interval: the weights of every output at its end and at the ends of all later ones.
    weights: Vec<Vec<Vec<f64>>>,
}

impl Hierarchy {
    /// The coarse run of the full law.
    ///
    /// # Errors
    /// [`Failure`] of the run, which may be the deadline.
    pub fn course(&self, watched: &Watched, deadline: Option<Instant>) -> Result<CoarseRun, Failure> {
        let (n, span) = (self.start.len(), self.own.span);
        let times: Vec<f64> = (1..=INTERVALS).map(|k| span * (k as f64 / INTERVALS as f64)).collect();
        let mut record = Record::new();
        let mut even = Span::new(0.0, span, &self.start).with_even_outputs(INTERVALS * KNOTS);
        if let Some(deadline) = deadline {
            even = even.with_deadline(deadline);
        }
        let run = integrate(&*self.law, Method::DormandPrince8, &Tolerance::both(COARSE), &even, &mut record);
        run.failure().map_or(Ok(()), Err)?;
        let knot = |(&time, state): (&f64, &Vec<f64>)| {
            let mut rates = vec![0.0; n];
            self.law.rates(time, state, &mut rates);
            (time, state.clone(), rates)
        };
        let along = record.times.iter().zip(&record.states);
        let knots: Vec<Knot> = std::iter::once((&0.0, &self.start)).chain(along).map(knot).collect();
        let mut jacobian = Jacobian::of(&*self.law);
        let short: Vec<DMatrix<f64>> =
            knots.windows(2).map(|ends| propagator(&mut jacobian, &ends[0], &ends[1])).collect();
        let whole = |parts: &[DMatrix<f64>]| parts.iter().fold(DMatrix::identity(n, n), |whole, part| part * whole);
        let matrices: Vec<DMatrix<f64>> = short.chunks(KNOTS).map(whole).collect();
        let states: Vec<Vec<f64>> = knots.into_iter().step_by(KNOTS).map(|(_, state, _)| state).collect();
        let mut weights = vec![Vec::new(); INTERVALS];
        for end in 1..=INTERVALS {
            for (&column, size) in watched.columns.iter().zip(&watched.sizes) {
                let mut weight = self.output(column, *size, times[end - 1], &states[end]);
                for k in (0..end).rev() {
                    let before = |j: usize| (0..n).map(|i| weight[i] * matrices[k][(i, j)]).sum();
                    let earlier = (0..n).map(before).collect();
                    weights[k].push(std::mem::replace(&mut weight, earlier));
                }
            }
        }
        Ok(CoarseRun { times, states, weights })
    }

    /// The schedule of a reduced model for an allowed error of the outputs; `None` where it suffices nowhere, or its
    /// states are not among those of the full law.
    pub fn schedule(&self, reduced: &ReducedModel, course: &CoarseRun, allowed: f64) -> Option<Schedule> {
        let kept = reduced.lower.kept.as_ref()?;
        let losses: Vec<f64> = (0..INTERVALS).map(|k| self.loss(reduced, kept, course, k)).collect();
        let taken = |threshold: f64| -> Vec<bool> {
            let mut low = false;
            let step = |loss: &f64| {
                low = *loss <= if low { HYSTERESIS * threshold } else { threshold };
                low
            };
            losses.iter().map(step).collect()
        };
        let lost =
            |taken: &[bool]| losses.iter().zip(taken).filter(|(_, low)| **low).map(|(loss, _)| loss).sum::<f64>();
        let mut thresholds = losses.clone();
        thresholds.sort_by(f64::total_cmp);
        let best = thresholds.into_iter().rev().map(taken).find(|taken| lost(taken) <= allowed)?;
        let promised = lost(&best);
        let stretches = course.times.iter().copied().zip(best).collect();
        Some(Schedule { stretches, promised }).filter(|schedule| schedule.share() > 0.0)
    }

    /// The largest change of an output by a reduced model on the interval k; infinite where its run does not reach the end.
    fn loss(&self, reduced: &ReducedModel, kept: &[usize], course: &CoarseRun, k: usize) -> f64 {
        let begin = k.checked_sub(1).map_or(0.0, |before| course.times[before]);
        let (y, end) = (&course.states[k], course.times[k]);
        let down: Vec<f64> = kept.iter().map(|&place| y[place]).collect();
        let span = Span::new(begin, end, &down);
        let ended = integrate(&*reduced.law, Method::DormandPrince8, &Tolerance::both(COARSE), &span, &mut ());
        if !ended.reached() {
            return f64::INFINITY;
        }
        let up = reduced.lifted(end, &ended.state, self.start.len());
        let off: Vec<f64> = up.iter().zip(&course.states[k + 1]).map(|(up, y)| up - y).collect();
        let lost = |weight: &Vec<f64>| weight.iter().zip(&off).map(|(w, d)| w * d).sum::<f64>().abs();
        course.weights[k].iter().map(lost).fold(0.0, f64::max)
    }

    /// The switching run of a schedule, with rows at its steps and at these times; `None` where it does not reach its end.
    pub fn run_switching(
        &self,
        reduced: &ReducedModel,
        schedule: &Schedule,
        sides: Sides,
        most: u64,
        times: &[f64],
    ) -> Option<Run> {
        let kept = reduced.lower.kept.as_ref()?;
        let (law, start) = (&self.law, &self.start);
        let n = self.start.len();
        let (mut at, mut y) = (0.0, start.clone());
        let mut run = Run { asked: Vec::new(), steps: Vec::new(), evaluations: 0 };
        for stretches in schedule.stretches.chunk_by(|a, b| a.1 == b.1) {
            let (end, low) = *stretches.last()?;
            let mut outputs: Vec<f64> = times.iter().copied().filter(|time| *time > at && *time <= end).collect();
            let seen = outputs.len();
            if outputs.last() != Some(&end) {
                outputs.push(end);
            }
            let state = if low { kept.iter().map(|&place| y[place]).collect() } else { y.clone() };
            let span = Span::new(at, end, &state).with_outputs(&outputs).with_evaluations(most);
            let (method, tolerance) = sides[usize::from(low)];
            let whole = |time: f64, state: &[f64]| if low { reduced.lifted(time, state, n) } else { state.to_vec() };
            let mut along = Along::of(|time: f64, state: &[f64]| self.row(time, &whole(time, state)));
            let system = if low { &reduced.law } else { law };
            let outcome = integrate(&**system, method, &Tolerance::both(tolerance), &span, &mut along);
            let evaluations = outcome.work.rates + outcome.work.jacobians * state.len() as u64;
            outcome.reached().then_some(())?;
            let part = along.run(run.evaluations + evaluations);
            run.asked.extend(part.asked.into_iter().take(seen));
            run.steps.extend(part.steps);
            run.evaluations = part.evaluations;
            y = whole(end, &outcome.state);
            at = end;
        }
        Some(run)
    }
}
