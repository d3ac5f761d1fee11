//! Two motions that pass through each other between two values and exchange their stability there: a transcritical bifurcation.
//!
//! On both sides motions are equally many, with as many unstable directions. Their difference D is a smooth function of the parameter p, with
//!
//!   |D(p)| = |c| |p - p0| + O((p - p0)^2) .
//!
//! Where the distances at neighbouring values may be such an absolute value, the secant method finds p0.

use super::change::{distance, unstable};
use super::tracks::tracks;
use super::{NoSteadyMotions, Sample, kinds};
use std::collections::BTreeSet;

/// The sum of the distances at both ends of an interval is at most this multiple of their change over an interval of the same width
/// beside it: one for an absolute value.
const BENT: f64 = 1.5;

/// Rounds of values that are tried until two motions meet.
const TRIED: usize = 12;

/// The least distance becomes smaller by this factor, at least, from round to round.
const SHRINKS: f64 = 0.5;

/// A distance below this part of the ranges counts as a meeting.
const MET: f64 = 1e-6;

/// The parts of the range of the parameter, on both sides of a meeting, at which motions are told apart.
const BESIDE: [f64; 7] = [1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3];

/// The ratio of neighbouring parts of the range.
const WIDER: f64 = 10.0;

/// Distances beside a meeting are those of an absolute value up to this factor.
const STRAIGHT: f64 = 2.0;

/// An event between two values with alike motions.
pub(super) enum Meeting {
    /// Two motions pass through each other between the samples.
    Transcritical(Box<[Sample; 2]>),
    /// The motions in the middle are others than those at both ends.
    Hidden(Box<[Sample; 3]>),
}

/// Meetings between neighbouring complete samples with alike motions, along a parameter whose range has a size.
pub(super) fn meetings(
    samples: &[&Sample],
    size: f64,
    at: &impl Fn(f64) -> Result<Sample, NoSteadyMotions>,
) -> Vec<Meeting> {
    let stretches = samples.chunk_by(|a, b| kinds(&a.found) == kinds(&b.found));
    stretches.flat_map(|stretch| candidates(stretch).into_iter().filter_map(|one| one.meeting(size, at))).collect()
}

/// An interval in which two motions may meet, with the distances of the two at its ends.
struct Candidate {
    ends: [Sample; 2],
    gaps: [f64; 2],
    /// The numbers of unstable directions of the two.
    unstable: [usize; 2],
}

/// The intervals of a stretch of alike samples in which two motions of different stability may meet.
fn candidates(stretch: &[&Sample]) -> Vec<Candidate> {
    let tracks = tracks(stretch);
    let value = |k: usize| stretch[k].value;
    let mut known = BTreeSet::new();
    let mut all = Vec::new();
    for (i, one) in tracks.iter().enumerate() {
        for other in &tracks[..i] {
            let unstable = [one, other].map(|track| unstable(&stretch[0].found.motions[track[0]]));
            if unstable[0] == unstable[1] {
                continue;
            }
            let gaps: Vec<f64> = (0..stretch.len()).map(|k| gap(stretch[k], one[k], other[k])).collect();
            let slope = |from: usize, to: usize| (gaps[to] - gaps[from]) / (value(to) - value(from)).abs();
            for k in 1..stretch.len() {
                let beside = [
                    k.checked_sub(2).map_or(0.0, |before| slope(k - 1, before)),
                    if k + 1 < stretch.len() { slope(k, k + 1) } else { 0.0 },
                ];
                let way = (value(k) - value(k - 1)).abs();
                let is_bent = gaps[k - 1] + gaps[k] <= BENT * way * beside[0].max(beside[1]);
                if is_bent && known.insert((k, unstable)) {
                    let ends = [stretch[k - 1].clone(), stretch[k].clone()];
                    all.push(Candidate { ends, gaps: [gaps[k - 1], gaps[k]], unstable });
                }
            }
        }
    }
    all
}

/// The distance of two motions of a sample.
fn gap(sample: &Sample, one: usize, other: usize) -> f64 {
    let motions = &sample.found.motions;
    distance(&sample.found.unknowns, &motions[one].enclosure, &motions[other].enclosure)
}

impl Candidate {
    /// The meeting in the interval; none where the two motions turn back before they meet.
    fn meeting(self, size: f64, at: &impl Fn(f64) -> Result<Sample, NoSteadyMotions>) -> Option<Meeting> {
        let alike = kinds(&self.ends[0].found);
        let [from, to] = [self.ends[0].value, self.ends[1].value];
        let slope = (self.gaps[0] + self.gaps[1]) / (to - from).abs();
        let mut open = vec![from + (to - from) * self.gaps[0] / (self.gaps[0] + self.gaps[1])];
        let mut least = self.gaps[0].max(self.gaps[1]);
        for _ in 0..TRIED {
            let mut nearest: Option<(f64, f64)> = None;
            for value in open {
                let sample = at(value).ok()?;
                let has_met = sample.found.motions.len() + 1 == self.ends[0].found.motions.len();
                if !sample.found.is_complete() || has_met {
                    return self.beside(value, size, at);
                }
                if kinds(&sample.found) != alike {
                    let [before, after] = self.ends;
                    return Some(Meeting::Hidden(Box::new([before, sample, after])));
                }
                let gap = self.closest(&sample)?;
                nearest = nearest.filter(|(known, _)| *known <= gap).or(Some((gap, value)));
            }
            let (gap, value) = nearest?;
            if gap <= MET {
                return self.beside(value, size, at);
            }
            if gap > SHRINKS * least {
                return None;
            }
            least = gap;
            // the sign of the distance is not known
            let sides = [value - gap / slope, value + gap / slope];
            open = sides.into_iter().filter(|side| from.min(to) < *side && *side < from.max(to)).collect();
        }
        None
    }

    /// The least distance of two motions with these numbers of unstable directions.
    fn closest(&self, sample: &Sample) -> Option<f64> {
        let of = |count: usize| {
            let motions = sample.found.motions.iter().enumerate();
            motions.filter(move |(_, motion)| unstable(motion) == count).map(|(place, _)| place)
        };
        let pairs = of(self.unstable[0]).flat_map(|one| of(self.unstable[1]).map(move |other| (one, other)));
        pairs.map(|(one, other)| gap(sample, one, other)).min_by(f64::total_cmp)
    }

    /// The meeting between two values beside a value, as close to it as motions are told apart: there the distance grows in proportion to
    /// that of the values.
    fn beside(&self, value: f64, size: f64, at: &impl Fn(f64) -> Result<Sample, NoSteadyMotions>) -> Option<Meeting> {
        let alike = kinds(&self.ends[0].found);
        let is_alike = |sample: &Sample| sample.found.is_complete() && kinds(&sample.found) == alike;
        let mut last: Option<([Sample; 2], f64)> = None;
        for part in BESIDE {
            let both = [at(value - part * size).ok()?, at(value + part * size).ok()?];
            let gaps = self.closest(&both[0]).zip(self.closest(&both[1])).map(|(one, other)| one + other);
            let next = gaps.filter(|_| both.iter().all(is_alike)).map(|gaps| (both, gaps));
            match (last.take(), &next) {
                (Some((both, known)), Some((_, gaps))) if (gaps / known / WIDER).ln().abs() <= STRAIGHT.ln() => {
                    return Some(Meeting::Transcritical(Box::new(both)));
                }
                _ => last = next,
            }
        }
        None
    }
}
