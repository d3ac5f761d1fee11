//! The stability of a method for all modes of a motion, for every step size.

use super::{Fates, Mode, StabilityFunction, UndecidedFate};
use algebra::real::Enclosure;

/// The comparison of the method's stability with that of the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Judgement {
    /// Every mode decays, is constant or grows as in the motion.
    Correct,
    /// The motion is unstable, the method stable: spurious stability.
    Hides,
    /// The motion is stable, the method unstable: spurious instability.
    Invents,
    /// Both are stable, but the method damps a mode of constant amplitude.
    Damps,
    /// Both are unstable, but the method changes the growth of some mode.
    Confuses,
}

/// The result for the step sizes between two adjacent thresholds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepInterval {
    pub judgement: Judgement,
    /// The numbers of eigenvalues whose multipliers lie outside the unit circle (`growing`) and on it (`staying`).
    pub growing: usize,
    pub staying: usize,
}

/// The results for all step sizes from zero to infinity.
#[derive(Clone, Debug)]
pub struct Steps {
    /// The thresholds of the step size, s, in ascending order.
    pub cuts: Vec<Enclosure>,
    /// The results before, between and after the thresholds.
    pub stretches: Vec<StepInterval>,
}

impl Steps {
    /// The results of a method for the modes of a motion.
    ///
    /// # Errors
    /// [`UndecidedFate`] where thresholds of one mode cannot be separated.
    pub fn of(modes: &[Mode], function: &StabilityFunction) -> Result<Self, UndecidedFate> {
        let fates: Vec<Fates> = modes.iter().map(|mode| Fates::of(&mode.place, function)).collect::<Result<_, _>>()?;
        let mut cuts: Vec<Enclosure> = fates.iter().flat_map(|fates| fates.cuts.iter().cloned()).collect();
        cuts.sort_by(|a, b| a.to_f64().total_cmp(&b.to_f64()));
        // thresholds of two modes may coincide
        cuts.dedup_by(|next, last| {
            let one = !next.is_apart_from(last);
            if one {
                *last = last.hull(next);
            }
            one
        });
        let probes = probes(&cuts).ok_or(UndecidedFate)?;
        let judged = probes.iter().map(|step| {
            let signs: Option<Vec<i32>> = fates.iter().map(|fates| fates.at(step)).collect();
            signs.map(|signs| StepInterval::of(modes, &signs)).ok_or(UndecidedFate)
        });
        let mut stretches: Vec<StepInterval> = judged.collect::<Result<_, _>>()?;
        // a threshold with equal results on both sides is dropped
        let mut place = 0;
        while place < cuts.len() {
            if stretches[place] == stretches[place + 1] {
                cuts.remove(place);
                stretches.remove(place);
            } else {
                place += 1;
            }
        }
        Ok(Steps { cuts, stretches })
    }

    /// The threshold (s) below which all step sizes are correct; `Ok(None)` where every step size is.
    ///
    /// # Errors
    /// The judgement of the shortest steps, where these are not correct.
    pub fn correct(&self) -> Result<Option<&Enclosure>, Judgement> {
        match self.stretches.first() {
            Some(StepInterval { judgement: Judgement::Correct, .. }) => Ok(self.cuts.first()),
            Some(first) => Err(first.judgement),
            None => Ok(None),
        }
    }

    /// The intervals of step sizes with their ends: the first begins at zero, the last is unbounded.
    pub fn all(&self) -> impl Iterator<Item = (Option<&Enclosure>, Option<&Enclosure>, StepInterval)> {
        let ends = |place: usize| (place.checked_sub(1).and_then(|k| self.cuts.get(k)), self.cuts.get(place));
        self.stretches.iter().enumerate().map(move |(place, stretch)| {
            let (from, to) = ends(place);
            (from, to, *stretch)
        })
    }

    /// The result for a step size, s; `None` where it equals a threshold within rounding.
    pub fn at(&self, step: f64) -> Option<StepInterval> {
        let bits = self.cuts.first().map_or(64, Enclosure::bits);
        let step = Enclosure::float(step, bits)?;
        let mut passed = 0;
        for cut in &self.cuts {
            match (&step - cut).sign()? {
                1 => passed += 1,
                _ => break,
            }
        }
        self.stretches.get(passed).copied()
    }
}

impl StepInterval {
    fn of(modes: &[Mode], signs: &[i32]) -> Self {
        let count = |sign: i32| modes.iter().zip(signs).filter(|(_, s)| **s == sign).map(|(mode, _)| mode.count).sum();
        let (growing, staying) = (count(1), count(0));
        let right = modes.iter().zip(signs).all(|(mode, sign)| mode.place.sign() == *sign);
        let grows = modes.iter().any(|mode| mode.place.sign() > 0);
        let judgement = match (right, grows, growing > 0) {
            (true, ..) => Judgement::Correct,
            (false, true, false) => Judgement::Hides,
            (false, false, true) => Judgement::Invents,
            (false, false, false) => Judgement::Damps,
            (false, true, true) => Judgement::Confuses,
        };
        StepInterval { judgement, growing, staying }
    }
}

/// A step size within each interval.
fn probes(cuts: &[Enclosure]) -> Option<Vec<Enclosure>> {
    let bits = cuts.first().map_or(64, Enclosure::bits);
    let two = Enclosure::integer(2, bits);
    let mut before = Enclosure::integer(0, bits);
    let mut probes = Vec::new();
    for cut in cuts {
        probes.push((&before + cut).over(&two)?.middle());
        before = cut.clone();
    }
    probes.push((&before + &Enclosure::integer(1, bits)).middle());
    Some(probes)
}
