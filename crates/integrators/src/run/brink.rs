//! Runs that creep along the edge of what their law is defined on.
//!
//! Where a motion comes to such an edge and rests there, such as the height of a tank that is empty, steps that end a little before it are
//! accepted, and longer ones have no rates, or rates with which Newton's iteration does not converge: without end, a step and a rejection in
//! turn.

/// Attempts that are looked at together.
const WINDOW: u32 = 600;

/// The part of them that rates without numbers have spoilt, from which on a run creeps.
const SPOILT: f64 = 0.25;

/// The part of them that was rejected for any reason, and the steps that are left, from which on it does too.
const REJECTED: f64 = 0.4;
const ENDLESS: f64 = 1e7;

/// Counts the attempts of a run.
#[derive(Default)]
pub(crate) struct Brink {
    attempts: u32,
    spoilt: u32,
    rejected: u32,
}

impl Brink {
    /// Counts an attempt, accepted where `rejected` is none, else whether rates without numbers have spoilt it; `left` steps as long as this
    /// one lead to the end. Whether the run creeps.
    pub fn creeps(&mut self, rejected: Option<bool>, left: f64) -> bool {
        self.attempts += 1;
        self.rejected += u32::from(rejected.is_some());
        self.spoilt += u32::from(rejected == Some(true));
        if self.attempts < WINDOW {
            return false;
        }
        let part = |count: u32| f64::from(count) / f64::from(WINDOW);
        let creeps = part(self.spoilt) >= SPOILT || part(self.rejected) >= REJECTED && left > ENDLESS;
        *self = Brink::default();
        creeps
    }
}

#[cfg(test)]
mod tests {
    use super::Brink;

    #[test]
    fn a_run_whose_attempts_are_spoilt_in_turn_creeps_and_one_that_passes_an_edge_does_not() {
        let any = |count: usize, left: f64, rejected: fn(usize) -> Option<bool>| {
            let mut brink = Brink::default();
            (0..count).any(|attempt| brink.creeps(rejected(attempt), left))
        };
        assert!(any(2_000, 1.0, |attempt| (attempt % 3 == 0).then_some(true)));
        assert!(!any(100_000, 1.0, |attempt| (attempt % 700 < 50).then_some(true)));
        assert!(any(2_000, 1e9, |attempt| (attempt % 2 == 0).then_some(false)));
        // hard, and with an end
        assert!(!any(100_000, 1e5, |attempt| (attempt % 2 == 0).then_some(false)));
    }
}
