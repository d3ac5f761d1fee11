//! Impacts that accumulate: infinitely many bounces, or rocks from one contact to another, in a finite time.

use super::Modes;
use super::course::Sets;
use super::expansion::{Expansions, Instant, Touching};
use super::mode::{Face, Mode, Phase};
use super::passage::SLACK;
use super::reasons::refused;

/// Bouncing ends when all further bounces together take less than this fraction of the time of the run.
const BOUNCES: f64 = 1e-9;

/// The same for contacts that share impacts: rounding of their gaps keeps bounces of several in turn from becoming shorter.
const SHARED_BOUNCES: f64 = 1e-6;

/// A fall exceeds the previous one by at most this many roundings of the gap.
const DEEPER: f64 = 8.0;

/// The largest ratio of the durations of successive flights that is taken for a geometric sequence.
const SHRINKS: f64 = 0.999;

/// The contacts of an impact.
#[derive(Clone, Copy)]
pub(super) struct Impact<'a> {
    /// Contacts that have closed.
    pub struck: &'a [usize],
    /// Contacts in touch that the impact opens.
    pub opened: &'a [usize],
    /// Contacts that stay in touch, and contacts that do not slide.
    pub stay: &'a [usize],
    pub stick: &'a [usize],
}

impl Modes {
    /// The contacts that are closed by an impact because the flights that follow are negligible: those that bounce, and those between which a
    /// body rocks.
    pub(super) fn accumulated(
        &self,
        mode: &Mode,
        impact: Impact<'_>,
        (time, state): (f64, &[f64]),
    ) -> Result<Vec<usize>, &'static str> {
        if self.rocking_ends(mode, impact, (time, state))? {
            return Ok([impact.struck, impact.opened].concat());
        }
        let mut ended = Vec::new();
        for &contact in impact.struck {
            if self.bounces_end(mode, contact, (time, state))? {
                ended.push(contact);
            }
        }
        Ok(ended)
    }

    /// Whether the remaining bounces of a contact are short compared with the time of the run, or no higher than the rounding of its gap.
    fn bounces_end(&self, mode: &Mode, contact: usize, (time, state): (f64, &[f64])) -> Result<bool, &'static str> {
        let expansions = self.laws.expansions().map_err(refused)?;
        let [_, restitution] = expansions.coefficients(time, state, (contact, &mode.cases));
        let found = expansions.at::<2>(&Instant::at(time, state), mode);
        let Some(Touching { gap, gap_rate, .. }) = found.map(|found| found.contacts[contact]) else { return Ok(false) };
        let [rate, acceleration] = gap_rate.terms;
        // the flights last 2 v/a, then e times that, and so on; the first one is v^2/(2 a) high
        let rest = 2.0 * rate / -acceleration / (1.0 - restitution);
        let height = rate * rate / (-2.0 * acceleration);
        // a gap is zero up to its rounding d, which lengthens each fall: the next height e^2 (h + d) is not below h for h = d e^2/(1 - e^2)
        let square = restitution * restitution;
        let lowest = SLACK * gap.doubts[0] * (1.0 + DEEPER * square / (1.0 - square));
        let part = if expansions.shares_impacts(contact) { SHARED_BOUNCES } else { BOUNCES };
        let is_over = (0.0..part * time).contains(&rest) || (0.0..lowest).contains(&height);
        Ok(rate > 0.0 && acceleration < 0.0 && restitution < 1.0 && is_over)
    }

    /// Whether the flights of contacts that an impact has opened are short compared with the time of the run, as those of a block that rocks from
    /// edge to edge. The ratio of successive flights follows from the time since the last impact.
    fn rocking_ends(
        &self,
        mode: &Mode,
        impact: Impact<'_>,
        (time, state): (f64, &[f64]),
    ) -> Result<bool, &'static str> {
        let Impact { struck, opened, stay, stick } = impact;
        let Some(last) = self.last_impact().filter(|_| !opened.is_empty()) else { return Ok(false) };
        let expansions = self.laws.expansions().map_err(refused)?;
        let mut next = mode.clone();
        for &contact in opened {
            next.phases[contact] = Phase::Apart;
        }
        let velocities = expansions.contacts(&Instant::at(time, state), &mode.cases);
        for &contact in struck {
            let forwards = velocities[contact].slide.terms[0] > 0.0;
            next.phases[contact] = match (stay.contains(&contact), stick.contains(&contact)) {
                (false, _) => Phase::Apart,
                (true, true) => Phase::Sticks(Face::Front),
                (true, false) => Phase::Slips { forwards, face: Face::Front },
            };
        }
        let Some(found) = expansions.at::<2>(&Instant::at(time, state), &next) else { return Ok(false) };
        let flight = |contact: &usize| {
            let [rate, acceleration] = found.contacts[*contact].gap_rate.terms;
            if acceleration < 0.0 { 2.0 * rate / -acceleration } else { f64::INFINITY }
        };
        let flies = |contact: &&usize| next.phases[**contact] == Phase::Apart;
        let longest = struck.iter().chain(opened).filter(flies).map(flight).fold(0.0, f64::max);
        let ratio = longest / (time - last);
        Ok(ratio < SHRINKS && longest / (1.0 - ratio) < SHARED_BOUNCES * time)
    }

    /// The time of the last impact of the run.
    fn last_impact(&self) -> Option<f64> {
        let course = self.course.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let is_impact = |sets: Sets| matches!(sets, Sets::Impact(_) | Sets::LastBounce);
        course.iter().rev().filter_map(|leg| leg.cause).find(|cause| is_impact(cause.sets)).map(|cause| cause.time)
    }
}

impl Expansions {
    /// The contacts in touch whose gaps an impact may displace; a guide has none.
    pub(super) fn in_touch(&self, mode: &Mode) -> Vec<usize> {
        let has_gap = |contact: &usize| {
            let kind = self.kinds[*contact];
            !kind.is_guide && !kind.is_one_way && !kind.is_direct
        };
        (0..mode.phases.len()).filter(|contact| mode.phases[*contact] != Phase::Apart).filter(has_gap).collect()
    }
}
