//! The first event of one signal within one step.

use super::again::Again;
use super::bounds::Bounds;
use super::{Event, Happening, Instant, Signal};

/// The largest number of halvings; the interval is then of the length of rounding.
const MOST_HALVINGS: u32 = 45;

/// The largest number of instants computed in one step: for a signal that is only noise no half is ever decided.
const MOST_KNOWN: usize = 256;

/// An instant just before a fall is searched at distances of 2^k units of rounding, k below this number.
const ROUNDINGS: i32 = 20;

/// An error bound below this fraction of the range of the cubic is negligible for its shape.
const SETTLED: f64 = 0.05;

/// The error bound of a step without further knowledge, as a fraction of the deviation of the cubic from its chord.
const OF_BOW: f64 = 0.25;

/// The fraction of a measured error that each half inherits; asymptotically it is 1/16 for short halves.
const OF_HALF: f64 = 0.25;

/// The smallest fraction of the error bound that each half inherits: a single value that lies on the cubic by chance
/// must not hide other zeros.
const LEAST_OF_HALF: f64 = 1.0 / 64.0;

/// A distance below this value counts as zero where the integration fails.
const NEAR: f64 = 1e-2;

/// A signal that has fallen to this fraction of its value before a gap counts as zero.
const CLOSE: f64 = 1e-6;

/// The largest number of halvings in the search for the last instant that can be integrated.
const MOST_NEARER: u32 = 12;

/// The search for events of one signal within one step.
pub(super) struct Search<'s, 'a> {
    pub again: &'s mut Again<'a>,
    /// The beginning of the step.
    pub step: &'s Instant,
    /// Instants within the step that have been integrated for any signal.
    pub known: &'s mut Vec<Instant>,
    pub signal: usize,
}

/// The result for a signal over an interval.
pub(super) enum Seen {
    /// No event; `armed`: whether the signal has been positive.
    Nothing {
        armed: bool,
    },
    Happened(Event, Vec<f64>),
    /// The zero lies after this instant, where the integration fails.
    Lost(Instant),
}

impl Search<'_, '_> {
    /// The error bound of the cubic over a step, from its own deviation and from the extrapolated cubic of the previous
    /// step. Each pair is a signal and its time: at the start of the previous step (`None` in the first step), and at the
    /// two ends of this step.
    pub fn doubt(before: Option<(Signal, f64)>, [(a, begin), (b, end)]: [(Signal, f64); 2]) -> f64 {
        let own = OF_BOW * Bounds::new(a, b, end - begin, 0.0).bow();
        let continued = before.map_or(0.0, |(signal, time)| {
            Bounds::error_of_continued(&Bounds::new(signal, a, begin - time, 0.0), b, end - begin)
        });
        own.max(continued)
    }

    fn of(&self, instant: &Instant) -> Signal {
        instant.signals[self.signal]
    }

    fn event(&self, what: Happening, instant: Instant) -> Seen {
        Seen::Happened(Event { signal: self.signal, what, time: instant.time }, instant.state)
    }

    /// Examines the interval from a to b, in halves while the bounds do not decide, at most `halvings` times. `armed`:
    /// whether the signal has been positive; `doubt`: the error bound of the cubic. `None` if an instant between them cannot
    /// be examined.
    pub fn look(&mut self, [a, b]: [&Instant; 2], armed: bool, doubt: f64, halvings: u32) -> Option<Seen> {
        let (left, right) = (self.of(a), self.of(b));
        let bounds = Bounds::new(left, right, b.time - a.time, doubt);
        let shortest = 16.0 * f64::EPSILON * a.time.abs().max(b.time.abs());
        let is_last = halvings == 0 || self.known.len() >= MOST_KNOWN || (b.time - a.time).abs() <= shortest;
        let seen = match armed {
            true => self.falls([a, b], &bounds, is_last),
            false => self.rises([a, b], &bounds, is_last),
        };
        match seen {
            Some(seen) => Some(seen),
            // a NaN decides nothing
            None if is_last => Some(Seen::Nothing { armed }),
            None => self.halves([a, b], &bounds, (armed, doubt), halvings),
        }
    }

    /// The result for a signal that has been positive; `None` while the bounds do not decide.
    fn falls(&mut self, [a, b]: [&Instant; 2], bounds: &Bounds, is_last: bool) -> Option<Seen> {
        let (left, right) = (self.of(a), self.of(b));
        let noise = left.noise.max(right.noise);
        let is_clear = is_last || bounds.doubt() <= noise.max(SETTLED * bounds.spread());
        // a minimum within the noise is a touch
        let is_above = if bounds.has_valley() { bounds.least() > noise } else { is_last || bounds.stays_up(0.0) };
        if right.value > 0.0 && is_above {
            return Some(Seen::Nothing { armed: true });
        }
        let ends_at_zero = right.value <= 0.0 && right.value >= -right.noise;
        if bounds.has_valley() && (ends_at_zero || right.value > 0.0 && is_clear) {
            return Some(self.valley([a, b]));
        }
        if right.value <= 0.0 {
            let once = bounds.changes_once() || right.value == 0.0 && bounds.is_monotone() || left.value <= 0.0;
            return (is_last || once).then(|| self.fall([a, b]));
        }
        (is_clear && bounds.is_monotone()).then_some(Seen::Nothing { armed: true })
    }

    /// The result for a signal that has not been positive yet; `None` while the bounds do not decide.
    fn rises(&mut self, [a, b]: [&Instant; 2], bounds: &Bounds, is_last: bool) -> Option<Seen> {
        let (left, right) = (self.of(a), self.of(b));
        let noise = left.noise.max(right.noise);
        // includes the rounding error of the time
        let slack = noise + 8.0 * f64::EPSILON * left.rate.abs() * a.time.abs().max((b.time - a.time).abs());
        let may_have_risen =
            left.value >= -slack && left.rate * bounds.length() > 0.0 && bounds.greatest() > 2.0 * noise;
        if right.value < -right.noise {
            let starts_below = || self.event(Happening::StartsBelow, self.step.clone());
            return (is_last || !may_have_risen).then(starts_below);
        }
        if right.value <= right.noise {
            return (is_last || !may_have_risen).then_some(Seen::Nothing { armed: false });
        }
        let clean = bounds.stays_up(slack) || left.value < 0.0 && bounds.changes_once();
        (is_last || clean).then_some(Seen::Nothing { armed: true })
    }

    /// Examines the first half, then the second.
    fn halves(
        &mut self,
        [a, b]: [&Instant; 2],
        bounds: &Bounds,
        (armed, doubt): (bool, f64),
        halvings: u32,
    ) -> Option<Seen> {
        let Some(middle) = self.between([a, b]) else { return self.last([a, b]) };
        let measured = bounds.error_at_middle(self.of(&middle));
        let left = (OF_HALF * measured).max(LEAST_OF_HALF * doubt);
        match self.look([a, &middle], armed, left, halvings - 1)? {
            Seen::Nothing { armed } => self.look([&middle, b], armed, left, halvings - 1),
            happened => Some(happened),
        }
    }

    /// The instant at the middle, integrated at most once.
    fn between(&mut self, [a, b]: [&Instant; 2]) -> Option<Instant> {
        let time = a.time + 0.5 * (b.time - a.time);
        if let Some(known) = self.known.iter().find(|known| known.time == time) {
            return Some(known.clone());
        }
        let found = self.again.at(self.step, a, time)?;
        self.known.push(found.clone());
        Some(found)
    }

    /// The zero of a distance at the last instant that can be integrated; `None` where the distance is not near zero
    /// there.
    fn last(&mut self, [a, b]: [&Instant; 2]) -> Option<Seen> {
        if self.of(a).pace.near == 0.0 {
            return None;
        }
        let (mut last, mut beyond) = (a.clone(), b.time);
        for _ in 0..MOST_NEARER {
            let time = last.time + 0.5 * (beyond - last.time);
            match self.again.at(self.step, &last, time) {
                Some(found) if self.of(&found).value <= 0.0 => return Some(self.fall([&last, &found])),
                Some(found) => last = found,
                None => beyond = time,
            }
        }
        self.is_near(&last).then(|| self.event(Happening::Falls, last))
    }

    fn is_near(&self, instant: &Instant) -> bool {
        let Signal { value, pace, .. } = self.of(instant);
        pace.near > 0.0 && value <= NEAR * NEAR
    }

    /// The event in an interval with a zero. Where the zero cannot be located, the end of the interval is taken.
    fn fall(&mut self, [a, b]: [&Instant; 2]) -> Seen {
        let signal = self.signal;
        let ends_above = self.again.switches.ends_above(signal);
        let found =
            self.again.root(self.step, [a, b], ends_above, |at| (at.signals[signal].value, at.signals[signal].rate));
        let [found, before] = match found {
            Some(found) => found,
            None if self.of(b).value.abs() > CLOSE * self.of(a).value.abs() && self.again.switches.is_timed(signal) => {
                return Seen::Lost(a.clone());
            }
            None => [b.clone(), a.clone()],
        };
        let found = match ends_above {
            true => self.above([a, &found]).unwrap_or(if self.of(&found).value > 0.0 { found } else { before }),
            false => found,
        };
        self.event(Happening::Falls, found)
    }

    /// The latest instant, at most a few units of rounding before a fall, with a positive signal.
    fn above(&mut self, [a, found]: [&Instant; 2]) -> Option<Instant> {
        let way = found.time - a.time;
        let rounding = f64::EPSILON * found.time.abs().max(way.abs()).copysign(way);
        let times = (0..ROUNDINGS).map(|k| found.time - rounding * f64::from(k).exp2());
        times.filter(|time| (time - a.time) * way > 0.0).find_map(|time| {
            let instant = self.again.at(self.step, a, time)?;
            (self.of(&instant).value > 0.0).then_some(instant)
        })
    }

    /// Examines the minimum of the signal in an interval: no event, a touch, or a fall before it.
    fn valley(&mut self, [a, b]: [&Instant; 2]) -> Seen {
        let (signal, direction) = (self.signal, (b.time - a.time).signum());
        let ends_above = self.again.switches.ends_above(signal);
        let rate = |at: &Instant| (-direction * at.signals[signal].rate, f64::NAN);
        let least = self.again.root(self.step, [a, b], ends_above, rate).map_or_else(|| b.clone(), |[least, _]| least);
        match self.of(&least) {
            Signal { value, noise, .. } if value > noise => match self.again.is_blocked && self.is_near(&least) {
                true => self.event(Happening::Falls, least),
                false => Seen::Nothing { armed: true },
            },
            Signal { value, noise, .. } if value >= -noise => self.event(Happening::Touches, least),
            _ => self.fall([a, &least]),
        }
    }
}

/// Examines one signal over an interval of a step. Where the integration fails, the values at the ends decide.
pub(super) fn look(search: &mut Search<'_, '_>, ends: [&Instant; 2], armed: bool, doubt: f64) -> Seen {
    if let Some(seen) = search.look(ends, armed, doubt, MOST_HALVINGS) {
        return seen;
    }
    match search.of(ends[1]) {
        Signal { value, .. } if armed && value <= 0.0 => search.fall(ends),
        Signal { value, noise, .. } if value < -noise => search.event(Happening::StartsBelow, search.step.clone()),
        Signal { value, noise, .. } => Seen::Nothing { armed: armed || value > noise },
    }
}
