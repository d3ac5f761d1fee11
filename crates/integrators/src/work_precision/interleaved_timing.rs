//! Interleaved timing: the runs are measured in turns, so that slow phases of the machine affect all of them.

use std::time::{Duration, Instant};

/// The shortest time of a measurement: a faster run is repeated within one measurement.
const SHORTEST: Duration = Duration::from_micros(200);
/// The number of measurements of a median.
const ENOUGH: usize = 9;
/// The smallest number of measurements of a median, and the total time after which they suffice for a long run.
const FEWEST: usize = 3;
const LONG: Duration = Duration::from_millis(12);

/// The median time of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Median {
    pub seconds: f64,
    /// The number of measurements.
    pub measurements: usize,
}

/// The median times of `count` runs, measured in turns until each median is settled or the time `allowed` is over. A
/// run that returns false, or was never called, has no median.
pub fn interleaved(count: usize, allowed: Duration, run: impl FnMut(usize) -> bool) -> Vec<Option<Median>> {
    at_most(ENOUGH, count, allowed, run)
}

/// As [`interleaved`], with at most `enough` turns.
pub(crate) fn at_most(
    enough: usize,
    count: usize,
    allowed: Duration,
    mut run: impl FnMut(usize) -> bool,
) -> Vec<Option<Median>> {
    let end = Instant::now() + allowed;
    let mut turns = vec![Turns::default(); count];
    for _ in 0..enough {
        for (index, turn) in turns.iter_mut().enumerate() {
            if !turn.failed && !turn.settled() && Instant::now() + turn.longest() <= end {
                turn.measure(|| run(index));
            }
        }
    }
    turns.into_iter().map(Turns::median).collect()
}

#[derive(Clone, Default)]
struct Turns {
    seconds: Vec<f64>,
    failed: bool,
}

impl Turns {
    fn settled(&self) -> bool {
        self.seconds.len() >= FEWEST && self.seconds.iter().sum::<f64>() >= LONG.as_secs_f64()
    }

    fn longest(&self) -> Duration {
        Duration::from_secs_f64(self.seconds.iter().copied().fold(0.0, f64::max))
    }

    fn measure(&mut self, mut run: impl FnMut() -> bool) {
        let (begin, mut runs) = (Instant::now(), 0);
        while runs == 0 || begin.elapsed() < SHORTEST {
            if !run() {
                self.failed = true;
                return;
            }
            runs += 1;
        }
        self.seconds.push(begin.elapsed().as_secs_f64() / f64::from(runs));
    }

    fn median(mut self) -> Option<Median> {
        self.seconds.sort_by(f64::total_cmp);
        let measurements = self.seconds.len();
        let seconds = *self.seconds.get(measurements / 2)?;
        (!self.failed).then_some(Median { seconds, measurements })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_take_turns_and_one_that_fails_has_no_median() {
        let mut order = Vec::new();
        let wait = |index: usize| std::thread::sleep(Duration::from_millis(index as u64));
        let found = interleaved(3, Duration::from_secs(10), |index| {
            order.push(index);
            wait(index);
            index != 0
        });
        assert_eq!(&order[..3], [0, 1, 2].as_slice());
        assert!(found[0].is_none() && order.iter().filter(|index| **index == 0).count() == 1);
        let [one, two] = [found[1], found[2]].map(|median| median.map_or(0, |median| median.measurements));
        assert!((FEWEST..=ENOUGH).contains(&one) && (FEWEST..=ENOUGH).contains(&two));
    }

    #[test]
    fn without_time_there_is_no_median() {
        assert_eq!(interleaved(2, Duration::ZERO, |_| true), [None, None]);
    }
}
