//! A run with rows of outputs at requested times, and at the method's steps.
//!
//! Two runs are compared at the steps of the coarser one; the finer run provides rows at these times. Hence nothing is
//! interpolated, and transients that the coarser run resolves are compared too.

use super::outputs::Watched;
use super::sampled_run::instants;
use integrators::Observer;
use std::cell::Cell;

/// A time with the outputs there.
pub type Row = (f64, Vec<f64>);

/// Whether a run is still acceptable with this row at a requested time; otherwise it is stopped there.
pub type Serves<'a> = dyn Fn(f64, &[f64]) -> bool + 'a;

/// The largest number of steps with rows: of longer runs every second step is kept, every fourth, ...
const KEPT: usize = 256;

/// A run of a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// The rows at the requested times.
    pub asked: Vec<Row>,
    /// The rows at the method's steps.
    pub steps: Vec<Row>,
    pub evaluations: u64,
}

impl Run {
    /// The rows at the output times of references.
    pub fn at_instants(&self, span: f64) -> Vec<Row> {
        let known = |(time, _): &&Row| instants(span).any(|instant| instant == *time);
        self.asked.iter().filter(known).cloned().collect()
    }

    /// All times with rows, ascending.
    pub fn times(&self) -> Vec<f64> {
        self.rows().into_iter().map(|(time, _)| *time).collect()
    }

    /// The largest difference from a finer run, relative to the sizes; `None` where the finer run lacks a row at a time
    /// of this run.
    pub fn apart(&self, finer: &Run, watched: &Watched) -> Option<f64> {
        let mut rest = finer.asked.iter();
        let off = |(time, row): &Row| {
            let (_, finer) = rest.find(|(at, _)| at == time)?;
            Some(watched.off(row, finer))
        };
        self.rows().into_iter().map(off).try_fold(0.0, |largest, off| Some(f64::max(largest, off?)))
    }

    /// A test whether rows of another run, in the order of their times, differ from this one by at most `most`.
    pub fn near(&self, watched: &Watched, most: f64) -> impl Fn(f64, &[f64]) -> bool {
        let (rows, next) = (self.rows(), Cell::new(0));
        move |time, row| {
            while rows.get(next.get()).is_some_and(|(at, _)| *at < time) {
                next.set(next.get() + 1);
            }
            rows.get(next.get()).is_none_or(|(at, own)| *at > time || watched.off(own, row) <= most)
        }
    }

    fn rows(&self) -> Vec<&Row> {
        let mut all: Vec<&Row> = self.asked.iter().chain(&self.steps).collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all.dedup_by(|a, b| a.0 == b.0);
        all
    }
}

/// An observer that stores the rows of a run, and stops it where it leaves its law or is not acceptable.
pub struct Along<'a, F> {
    row: F,
    outside: &'a dyn Fn(f64, &[f64]) -> bool,
    serves: &'a Serves<'a>,
    left: bool,
    asked: Vec<Row>,
    steps: Vec<Row>,
    stride: usize,
    seen: usize,
}

impl<'a, F: Fn(f64, &[f64]) -> Vec<f64>> Along<'a, F> {
    /// An observer with a map from states to rows.
    pub fn of(row: F) -> Self {
        Self::within(row, &|_, _| false, &|_, _| true)
    }

    /// An observer that also stops the run where `outside` is true or a requested row is not accepted by `serves`.
    pub fn within(row: F, outside: &'a dyn Fn(f64, &[f64]) -> bool, serves: &'a Serves<'a>) -> Self {
        Along { row, outside, serves, left: false, asked: Vec::new(), steps: Vec::new(), stride: 1, seen: 0 }
    }

    /// Whether the run has left its law, or is not acceptable.
    pub fn left(&self) -> bool {
        self.left
    }

    /// The run with its rows.
    pub fn run(self, evaluations: u64) -> Run {
        Run { asked: self.asked, steps: self.steps, evaluations }
    }
}

impl<F: Fn(f64, &[f64]) -> Vec<f64>> Observer<f64> for Along<'_, F> {
    fn sample(&mut self, time: f64, state: &[f64]) {
        let row = (self.row)(time, state);
        self.left |= !(self.serves)(time, &row);
        self.asked.push((time, row));
    }

    fn enough(&self) -> bool {
        self.left
    }

    fn step(&mut self, time: f64, state: &[f64]) {
        self.left |= (self.outside)(time, state);
        self.seen += 1;
        if !self.seen.is_multiple_of(self.stride) {
            return;
        }
        if self.steps.len() == KEPT {
            let mut place = 0;
            self.steps.retain(|_| {
                place += 1;
                place % 2 == 0
            });
            self.stride *= 2;
            if !self.seen.is_multiple_of(self.stride) {
                return;
            }
        }
        self.steps.push((time, (self.row)(time, state)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_many_steps_so_many_are_kept_evenly() {
        let mut along = Along::of(|time, _: &[f64]| vec![time]);
        (1..=10_000).for_each(|k| along.step(f64::from(k), &[]));
        let times: Vec<f64> = along.steps.iter().map(|(time, _)| *time).collect();
        assert!((KEPT / 2..=KEPT).contains(&times.len()), "{}", times.len());
        assert!(times.windows(2).all(|pair| pair[1] - pair[0] == times[0]), "{times:?}");
    }

    #[test]
    fn a_difference_between_two_instants_is_seen_where_there_are_steps() {
        let watched = Watched {
            names: vec!["x".into()],
            columns: vec![0],
            sizes: vec![2.0],
            states: Vec::new(),
            stiff: false,
            left: None,
            without_value: None,
        };
        let row = |time, value| (time, vec![value]);
        let coarse = Run { asked: vec![row(1.0, 0.0)], steps: vec![row(0.1, 3.0), row(1.0, 0.0)], evaluations: 0 };
        assert_eq!(coarse.times(), [0.1, 1.0]);
        let finer = Run { asked: vec![row(0.1, 1.0), row(1.0, 0.0)], steps: Vec::new(), evaluations: 0 };
        assert_eq!(coarse.apart(&finer, &watched), Some(1.0));
        assert_eq!(finer.apart(&Run { asked: vec![row(1.0, 0.0)], ..coarse }, &watched), None);
    }
}
