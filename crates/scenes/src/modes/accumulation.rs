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
    /// The contacts that an impact closes because the flights that follow are negligible: those that bounce, and those between which a body rocks.
    /// The velocities along their normals become zero, and of a body that rocks without sliding the sliding velocities too.
    pub(super) fn accumulated(
        &self,
        mode: &Mode,
        impact: Impact<'_>,
        (time, state): (f64, &mut [f64]),
    ) -> Result<Vec<usize>, &'static str> {
        let expansions = self.laws.expansions().map_err(refused)?;
        let closed = |stick: &[usize], slide: &[usize]| {
            let mut closed = mode.clone();
            stick.iter().for_each(|contact| closed.phases[*contact] = Phase::Sticks(Face::Front));
            slide.iter().for_each(|contact| {
                closed.phases[*contact] = Phase::Slips { forwards: true, face: Face::Front };
            });
            closed
        };
        if let Some(next) = self.rocking_ends(mode, impact, (time, state))? {
            let all = [impact.struck, impact.opened].concat();
            let (stick, slide): (Vec<usize>, Vec<usize>) =
                impact.struck.iter().partition(|contact| next.phases[**contact].sticking().is_some());
            // the friction of several contacts on one body is not determined: that of those that were struck suffices
            if !expansions.return_to_zero(time, state, &closed(&stick, &[&slide, impact.opened].concat()), 0.0) {
                expansions.return_to_zero(time, state, &closed(&[], &all), 0.0);
            }
            return Ok(all);
        }
        let mut ended = Vec::new();
        for &contact in impact.struck {
            if self.bounces_end(mode, contact, (time, state))? {
                ended.push(contact);
            }
        }
        if !ended.is_empty() {
            expansions.return_to_zero(time, state, &closed(&[], &ended), 0.0);
        }
        Ok(ended)
    }

    /// Whether the remaining bounces of a contact are short compared with the time of the run, or no higher than the rounding of its gap.
    fn bounces_end(&self, mode: &Mode, contact: usize, (time, state): (f64, &[f64])) -> Result<bool, &'static str> {
        let expansions = self.laws.expansions().map_err(refused)?;
        let [_, restitution] = expansions.coefficients(time, state, (contact, &mode.cases));
        let found = expansions.at::<2>(&Instant::at(time, state), mode);
        let Some(found) = found else { return Ok(false) };
        let flight = Flight::of(&found.contacts[contact]);
        let part = if expansions.shares_impacts(contact) { SHARED_BOUNCES } else { BOUNCES };
        let rest = flight.duration / (1.0 - restitution);
        let is_over = (0.0..part * time).contains(&rest) || flight.height < flight.lowest(restitution);
        Ok(flight.duration > 0.0 && flight.duration.is_finite() && restitution < 1.0 && is_over)
    }

    /// The mode of the next flight if the flights of contacts that an impact has opened are short relative to the time of the run, as those of a block that
    /// rocks from edge to edge. The ratio of successive flights follows from the time since the last impact.
    fn rocking_ends(
        &self,
        mode: &Mode,
        impact: Impact<'_>,
        (time, state): (f64, &[f64]),
    ) -> Result<Option<Mode>, &'static str> {
        let Impact { struck, opened, stay, stick } = impact;
        let Some(last) = self.last_impact().filter(|_| !opened.is_empty()) else { return Ok(None) };
        let expansions = self.laws.expansions().map_err(refused)?;
        // the direction of a slide in space is not known before its mode is decided
        let is_rough_in_space = |contact: &usize| {
            let kind = expansions.kinds[*contact];
            kind.is_in_space && kind.is_rough
        };
        if struck.iter().chain(opened).any(is_rough_in_space) {
            return Ok(None);
        }
        let mut next = mode.clone();
        for &contact in opened {
            next.phases[contact] = Phase::Apart;
        }
        let velocities = expansions.contacts(&Instant::at(time, state), &mode.cases);
        for &contact in struck {
            let Touching { gap_rate, slide, .. } = velocities[contact];
            let [leaves, forwards] = [gap_rate, slide].map(|velocity| velocity.sign_of(0, SLACK));
            next.phases[contact] = if leaves > 0.0 && !stay.contains(&contact) {
                Phase::Apart
            } else if forwards == 0.0 || stick.contains(&contact) {
                Phase::Sticks(Face::Front)
            } else {
                Phase::Slips { forwards: forwards > 0.0, face: Face::Front }
            };
        }
        let Some(found) = expansions.at::<2>(&Instant::at(time, state), &next) else { return Ok(None) };
        let flies = |contact: &&usize| next.phases[**contact] == Phase::Apart;
        let flights: Vec<Flight> =
            struck.iter().chain(opened).filter(flies).map(|contact| Flight::of(&found.contacts[*contact])).collect();
        let longest = flights.iter().map(|flight| flight.duration).fold(0.0, f64::max);
        let ratio = longest / (time - last);
        let is_low = flights.iter().all(|flight| flight.height < flight.lowest(ratio));
        let ends = ratio < SHRINKS && (longest / (1.0 - ratio) < SHARED_BOUNCES * time || is_low);
        Ok(ends.then_some(next))
    }

    /// The time of the last impact of the run.
    fn last_impact(&self) -> Option<f64> {
        let course = self.course.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let is_impact = |sets: Sets| matches!(sets, Sets::Impact(_) | Sets::LastBounce);
        course.iter().rev().filter_map(|leg| leg.cause).find(|cause| is_impact(cause.sets)).map(|cause| cause.time)
    }
}

/// The free motion of a gap after an impact.
struct Flight {
    /// The time until the gap is zero again, s: 2 v/a. It is infinite where nothing pulls the bodies together.
    duration: f64,
    /// The largest gap: v^2/(2 a).
    height: f64,
    /// The rounding error of the gap.
    rounding: f64,
}

impl Flight {
    fn of(Touching { gap, gap_rate, .. }: &Touching<2>) -> Self {
        let [rate, acceleration] = gap_rate.terms;
        let rounding = SLACK * gap.doubts[0];
        if acceleration >= 0.0 {
            return Flight { duration: f64::INFINITY, height: f64::INFINITY, rounding };
        }
        Flight { duration: 2.0 * rate / -acceleration, height: rate * rate / (-2.0 * acceleration), rounding }
    }

    /// The height below which flights do not become shorter, although an impact reduces velocities to a fraction e. A gap is zero up to its rounding
    /// error d, which lengthens each fall: the next height e^2 (h + d) is not below h for h = d e^2/(1 - e^2).
    fn lowest(&self, fraction: f64) -> f64 {
        let square = fraction * fraction;
        self.rounding * (1.0 + DEEPER * square / (1.0 - square))
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
