//! Detection of runs that creep along the edge of the domain of their law.
//!
//! Where a motion comes to such an edge and rests there, such as the height of a tank that is empty, steps that end a little before it are
//! accepted, and longer ones have no rates: an endless alternation of steps and rejections.

/// The number of attempts in a window, and the number of those among them with rates that are not finite from which on a run
/// creeps.
const WINDOW: u32 = 600;
const SPOILT: u32 = 150;

/// Counts the attempts of a run.
#[derive(Default)]
pub(crate) struct Brink {
    attempts: u32,
    spoilt: u32,
}

impl Brink {
    /// Counts an attempt, and whether its rates were not finite; returns whether the run creeps.
    pub fn creeps(&mut self, is_spoilt: bool) -> bool {
        self.attempts += 1;
        self.spoilt += u32::from(is_spoilt);
        if self.attempts < WINDOW {
            return false;
        }
        let creeps = self.spoilt >= SPOILT;
        *self = Brink::default();
        creeps
    }
}

#[cfg(test)]
mod tests {
    use super::Brink;

    #[test]
    fn a_run_whose_attempts_are_spoilt_in_turn_creeps_and_one_that_passes_an_edge_does_not() {
        let mut brink = Brink::default();
        assert!((0..2_000).any(|attempt| brink.creeps(attempt % 3 == 0)));
        let mut brink = Brink::default();
        assert!(!(0..100_000).any(|attempt| brink.creeps(attempt % 700 < 50)));
    }
}
