//! Pull-in: the least load with a stable slipping motion, and the bifurcation at which stable slipping motions begin.

use super::branches::{OutOfStep, Slipping};

/// The allowed rounding error of a Floquet multiplier at a fold, where the exact value is one.
const ROUNDING: f64 = 1e-6;

/// The least load with a stable slipping motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PullIn {
    /// The load, N m.
    pub load: f64,
    pub by: Onset,
}

/// The bifurcation at which stable slipping begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Onset {
    /// Homoclinic bifurcation: the period tends to infinity as the motion approaches an unstable equilibrium.
    Balance,
    /// A fold: a stable and an unstable slipping motion with this mean slip, rad/s, merge.
    Fold { slip: f64 },
    /// At the pull-out, where the synchronous equilibria end: the period tends to infinity, and there is no hysteresis.
    PullOut,
    /// At the end of the continuation, with this mean slip, rad/s: no bifurcation was found.
    End { slip: f64 },
}

impl OutOfStep {
    /// The pull-in, given the pull-out load, N m. `None` if no slipping motion is stable.
    pub fn pull_in(&self, pull_out: f64) -> Option<PullIn> {
        let at = |one: &Slipping| match one.fold {
            true => PullIn { load: one.load, by: Onset::Fold { slip: one.slip() } },
            false => PullIn { load: one.load, by: Onset::End { slip: one.slip() } },
        };
        let lasting = |one: &&Slipping| one.stable() || one.fold && one.multiplier < 1.0 + ROUNDING;
        let stable = self.motions.iter().filter(lasting).map(at);
        let last = self.motions.last().filter(|one| one.stable());
        let limit = self.limit.filter(|_| last.is_some()).map(|load| PullIn { load, by: Onset::Balance });
        let least = stable.chain(limit).min_by(|a, b| a.load.total_cmp(&b.load))?;
        // at the pull-out the period tends to infinity too, but slowly
        let towards = last.is_some_and(|last| last.load == least.load && least.load >= pull_out);
        Some(if towards { PullIn { load: pull_out, by: Onset::PullOut } } else { least })
    }
}
