//! The first event of one signal within one step.

use super::again::Again;
use super::bounds::Bounds;
use super::{Event, Happening, Instant, Signal};

/// Halvings of a step, after which the rest is within rounding.
const MOST_HALVINGS: u32 = 45;

/// The largest number of instants computed in one step: a signal that is noise leaves every half open.
const MOST_KNOWN: usize = 256;

/// Doublings of a rounding of the time, by which an instant before a fall is sought.
const ROUNDINGS: i32 = 20;

/// A doubt below this part of the change of the cubic leaves no doubt of its shape.
const SETTLED: f64 = 0.05;

/// The doubt that a step leaves by itself, as a part of the bow of the cubic.
const OF_BOW: f64 = 0.25;

/// The part of a doubt measured at the middle that each half keeps: a sixteenth of it would be right for short halves.
const OF_HALF: f64 = 0.25;

/// The least part that a halving keeps of a doubt: one value that happens to lie on the cubic must not hide others.
const LEAST_OF_HALF: f64 = 1.0 / 64.0;

/// A distance below this counts as zero where the motion cannot be computed again.
const NEAR: f64 = 1e-2;

/// A signal that has fallen to this part of its value before a gap of the law counts as zero.
const CLOSE: f64 = 1e-6;

/// Halvings of an interval, by which its last instant that can be computed again is found.
const MOST_NEARER: u32 = 12;

/// The data of a step.
pub(super) struct Search<'s, 'a> {
    pub again: &'s mut Again<'a>,
    /// The beginning of the step.
    pub step: &'s Instant,
    /// The instants computed again within it so far, for any signal.
    pub known: &'s mut Vec<Instant>,
    pub signal: usize,
}

/// The behaviour of a signal over an interval.
pub(super) enum Seen {
    /// No event; whether the signal has been positive.
    Nothing {
        armed: bool,
    },
    Happened(Event, Vec<f64>),
    /// The signal passes zero behind an instant, where the motion cannot be computed.
    Lost(Instant),
}

impl Search<'_, '_> {
    /// The doubt in a step, by the step before if that is known.
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

    /// Examines the interval from a to b, in halves while the doubt leaves it open.
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
            // a signal that is NaN decides nothing
            None if is_last => Some(Seen::Nothing { armed }),
            None => self.halves([a, b], &bounds, (armed, doubt), halvings),
        }
    }

    /// The behaviour of a signal that was positive; `None` where that is open.
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

    /// The behaviour of a signal that was not positive yet; `None` where that is open.
    fn rises(&mut self, [a, b]: [&Instant; 2], bounds: &Bounds, is_last: bool) -> Option<Seen> {
        let (left, right) = (self.of(a), self.of(b));
        let noise = left.noise.max(right.noise);
        // by the rounding of a time
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

    /// The search in both halves, one after the other.
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

    /// The instant in the middle.
    fn between(&mut self, [a, b]: [&Instant; 2]) -> Option<Instant> {
        let time = a.time + 0.5 * (b.time - a.time);
        if let Some(known) = self.known.iter().find(|known| known.time == time) {
            return Some(known.clone());
        }
        let found = self.again.at(self.step, a, time)?;
        self.known.push(found.clone());
        Some(found)
    }

    /// The fall of a distance to zero at the last instant of an interval that can be computed again; `None` where the motion does not
    /// end there.
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

    /// The fall through zero in an interval that has one. Where it cannot be computed again, the end, which counts as zero, is taken.
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

    /// The last instant, found a few roundings before a fall, at which the signal is positive.
    fn above(&mut self, [a, found]: [&Instant; 2]) -> Option<Instant> {
        let way = found.time - a.time;
        let rounding = f64::EPSILON * found.time.abs().max(way.abs()).copysign(way);
        let times = (0..ROUNDINGS).map(|k| found.time - rounding * f64::from(k).exp2());
        times.filter(|time| (time - a.time) * way > 0.0).find_map(|time| {
            let instant = self.again.at(self.step, a, time)?;
            (self.of(&instant).value > 0.0).then_some(instant)
        })
    }

    /// The least value in an interval, where the rate changes its sign: nothing, a touch, or a fall before it.
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

/// Examines one signal over an interval of a step. Where the motion cannot be computed again, the ends decide.
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
