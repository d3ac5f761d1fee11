//! Gaps: time intervals within a step where the integration fails, as at a coordinate singularity.

/// The search ends after this many failed instants.
const MOST: usize = 24;

/// A gap within the bracket of a zero, narrowed from both sides. `found` counts the failed instants.
pub(super) struct Gap {
    ends: [f64; 2],
    found: usize,
}

impl Gap {
    /// The gap `known` extended by the failed instant `time`; `None` stands for no gap so far.
    pub fn with(known: Option<Gap>, time: f64) -> Self {
        let Some(Gap { ends: [first, last], found }) = known else { return Gap { ends: [time; 2], found: 1 } };
        Gap { ends: [first.min(time), last.max(time)], found: found + 1 }
    }

    /// Whether the gap lies inside the bracket.
    pub fn is_between(&self, low: f64, high: f64) -> bool {
        self.ends.iter().all(|time| (time - low) * (time - high) < 0.0)
    }

    /// The middle of the longer part of the bracket outside the gap.
    pub fn beside(&self, low: f64, high: f64) -> f64 {
        let [a, b] = self.longer(low, high);
        a + 0.5 * (b - a)
    }

    /// Whether the gap is narrowed as far as possible.
    pub fn is_settled(&self, low: f64, high: f64, closest: f64) -> bool {
        let [a, b] = self.longer(low, high);
        self.found >= MOST || (b - a).abs() <= closest
    }

    fn longer(&self, low: f64, high: f64) -> [f64; 2] {
        let [first, last] = if low <= high { self.ends } else { [self.ends[1], self.ends[0]] };
        if (first - low).abs() >= (high - last).abs() { [low, first] } else { [last, high] }
    }
}

#[cfg(test)]
mod tests {
    use super::Gap;

    #[test]
    fn a_gap_is_narrowed_from_its_longer_side_forwards_and_backwards() {
        let gap = Gap::with(Some(Gap::with(None, 0.6)), 0.5);
        assert_eq!([gap.beside(0.0, 1.0), gap.beside(1.0, 0.0)], [0.25, 0.25]);
        assert!(gap.is_between(0.0, 1.0) && !gap.is_between(0.55, 1.0));
        assert!(!gap.is_settled(0.0, 1.0, 1e-3) && gap.is_settled(0.4999, 0.6001, 1e-3));
    }
}
