//! Detection of runs that stagnate at the edge of the domain of their law.
//!
//! A motion may end at such an edge, for example at the height zero of an emptying tank. Steps that end just before the
//! edge are accepted, longer ones have undefined rates: acceptances and rejections alternate without end.

/// The number of attempts in a window, and the number of attempts with undefined rates among them from which the run
/// counts as stagnating.
const WINDOW: u32 = 600;
const SPOILT: u32 = 150;

/// Counts attempted steps.
#[derive(Default)]
pub(crate) struct Brink {
    attempts: u32,
    spoilt: u32,
}

impl Brink {
    /// Counts an attempt; `is_spoilt`: its rates were not finite. Returns whether the run stagnates.
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
