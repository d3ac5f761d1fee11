//! Pull-in: the least load under which a rotor can slip for ever, and how the slipping begins there.

use super::branches::{OutOfStep, Slipping};

/// Of a multiplier where two motions merge, which is one there.
const ROUNDING: f64 = 1e-6;

/// Where slipping begins: the least load under which a rotor can slip for ever.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PullIn {
    /// N m
    pub load: f64,
    pub by: Onset,
}

/// How the slipping begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Onset {
    /// With turns of any length, from a balance to the next.
    Balance,
    /// With a motion that splits in two, at this mean slip, rad/s: one of them is stable.
    Fold { slip: f64 },
    /// Where standing ends: with turns of any length as well, and without hysteresis.
    PullOut,
    /// At the end of what was followed, at this mean slip, rad/s.
    End { slip: f64 },
}

impl OutOfStep {
    /// The least load under which a rotor can slip for ever, turn after turn alike. `None` where no such motion is stable.
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
        // turns grow without bound towards the pull-out too, and slowly
        let towards = last.is_some_and(|last| last.load == least.load && least.load >= pull_out);
        Some(if towards { PullIn { load: pull_out, by: Onset::PullOut } } else { least })
    }
}
