//! Upper bounds of the step size where a law changes rapidly with time.
//!
//! The error estimate of a step depends on the law at its stages only. A force that acts for less time than the
//! distance of two stages is missed. Where functions of the time alone show such intervals, the step size is bounded
//! there.

use std::sync::Arc;

/// A time interval in which a law changes rapidly. Times in s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FastInterval {
    pub from: f64,
    pub to: f64,
    /// The largest step size within the interval, s.
    pub step: f64,
}

/// Disjoint time intervals in ascending order, with the largest step size in each; between them steps are not bounded.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StepBounds {
    /// The beginning of each interval, in s since the start of the run, and the largest step size from there on.
    stretches: Arc<[(f64, f64)]>,
}

impl StepBounds {
    /// The bounds for a run from `from` to `to`, in either direction. The given intervals may overlap.
    pub fn of(from: f64, to: f64, all: &[FastInterval]) -> Self {
        let since = |time: f64| (time - from) * (to - from).signum();
        let length = since(to);
        let mut ends: Vec<(f64, f64, f64)> = Vec::new();
        for haste in all {
            let [a, b] = [since(haste.from), since(haste.to)];
            let (begin, end) = (a.min(b).max(0.0), a.max(b).min(length));
            if begin < end {
                ends.push((begin, end, haste.step));
            }
        }
        ends.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut times: Vec<f64> = ends.iter().flat_map(|(begin, end, _)| [*begin, *end]).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        let (mut open, mut next): (Vec<(f64, f64)>, usize) = (Vec::new(), 0);
        let mut stretches: Vec<(f64, f64)> = Vec::new();
        for time in times {
            while let Some((_, end, step)) = ends.get(next).filter(|(begin, ..)| *begin <= time) {
                open.push((*end, *step));
                next += 1;
            }
            open.retain(|(end, _)| *end > time);
            let step = open.iter().fold(f64::INFINITY, |least, (_, step)| least.min(*step));
            if stretches.last().is_none_or(|(_, last)| *last != step) {
                stretches.push((time, step));
            }
        }
        StepBounds { stretches: stretches.into() }
    }

    /// The bounds for a run whose time is scaled by a factor.
    pub fn paced(&self, factor: f64) -> Self {
        StepBounds { stretches: self.stretches.iter().map(|(begin, step)| (begin * factor, step * factor)).collect() }
    }

    /// Whether there are no bounds.
    pub fn is_empty(&self) -> bool {
        self.stretches.is_empty()
    }

    /// The largest step size at a time since the start, at most `most`. The step ends where an interval begins, unless
    /// it is then shorter than the largest step of that interval: a series from outside does not represent the law
    /// within.
    pub fn longest(&self, tau: f64, most: f64) -> f64 {
        let behind = self.stretches.partition_point(|(begin, _)| *begin <= tau);
        let own = behind.checked_sub(1).map_or(f64::INFINITY, |place| self.stretches[place].1);
        let mut longest = most.min(own);
        for (begin, step) in &self.stretches[behind..] {
            if *begin >= tau + longest {
                break;
            }
            longest = longest.min((begin - tau).max(*step));
        }
        longest
    }
}

#[cfg(test)]
mod tests {
    use super::{FastInterval, StepBounds};

    #[test]
    fn a_step_ends_where_a_stretch_begins() {
        let all = [FastInterval { from: 4.0, to: 4.4, step: 0.1 }, FastInterval { from: 4.1, to: 4.2, step: 0.01 }];
        let bounds = StepBounds::of(0.0, 10.0, &all);
        let longest = |tau: f64, most: f64| bounds.longest(tau, most);
        assert_eq!([longest(0.0, 2.0), longest(0.0, 9.0), longest(5.0, 9.0)], [2.0, 4.0, 9.0]);
        assert!((longest(4.05, 9.0) - 0.05).abs() < 1e-12 && longest(4.15, 9.0) == 0.01);
        assert!((longest(4.3, 9.0) - 0.1).abs() < 1e-12);
    }

    #[test]
    fn a_run_that_goes_back_has_the_stretches_of_its_way() {
        let bounds = StepBounds::of(10.0, 2.0, &[FastInterval { from: 4.0, to: 5.0, step: 0.5 }]);
        let paced = bounds.paced(0.1);
        assert!((paced.longest(0.0, 0.9) - 0.5).abs() < 1e-12 && (paced.longest(0.52, 0.9) - 0.05).abs() < 1e-12);
        assert_eq!([bounds.longest(0.0, 9.0), bounds.longest(5.2, 9.0), bounds.longest(6.5, 9.0)], [5.0, 0.5, 9.0]);
        assert!(StepBounds::of(0.0, 1.0, &[FastInterval { from: 4.0, to: 5.0, step: 0.5 }]).is_empty());
    }
}
