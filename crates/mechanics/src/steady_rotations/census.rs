//! The number of uniform rotations as a function of the angular velocity.

use super::{Body, Undecided};
use field::Rational;

/// The axis of angular velocities, divided where the number of rotations may change.
pub struct Census {
    /// The intervals in ascending order; the first begins at minus infinity, the last ends at plus infinity.
    pub stretches: Vec<SpeedInterval>,
}

/// An open interval of angular velocities (rad/s) in which the number of rotations is constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedInterval {
    pub from: f64,
    pub to: f64,
    /// The numbers of isolated directions and of families.
    pub isolated: usize,
    pub families: usize,
}

/// The number of bits to which the ends of intervals are computed.
const BITS: usize = 96;

impl Body {
    /// The number of rotations between any two adjacent folds and zero, each counted exactly at one angular velocity:
    /// it cannot change within.
    ///
    /// # Errors
    /// [`Undecided`] with the reason why folds may be missing.
    pub fn census(&self) -> Result<Census, Undecided> {
        let folds = self.folds();
        if let Some(reason) = folds.undecided {
            return Err(reason);
        }
        let mut cuts = vec![0.0];
        for fold in &folds.motions {
            let (_, w) = fold.direction_and_speed(BITS).ok_or(Undecided::TooFine)?;
            cuts.push(w.to_f64());
        }
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        let ends = [&[f64::NEG_INFINITY], &cuts[..], &[f64::INFINITY]].concat();
        let mut stretches: Vec<SpeedInterval> = Vec::new();
        for pair in ends.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            let at = match (from.is_finite(), to.is_finite()) {
                (true, true) => 0.5 * (from + to),
                (true, false) => 2.0 * from.abs() + from + 1.0,
                (false, true) => to - 2.0 * to.abs() - 1.0,
                (false, false) => 0.0,
            };
            let found = self.rotations(Rational::exactly(at)).ok_or(Undecided::TooFine)?;
            let isolated = found.isolated();
            stretches.push(SpeedInterval { from, to, isolated, families: found.motions.len() - isolated });
        }
        Ok(Census { stretches })
    }
}
