//! A motion that jumps between two values with alike motions: two folds lie between them, and between the folds there are more motions.
//!
//! A motion moves in proportion to the parameter. One that moves much further between two values than beside them may jump; halving the
//! interval finds the values with more motions, if there are some, and else a motion that moves fast.

use super::change::distance;
use super::tracks::tracks;
use super::{NoSteadyMotions, Sample, kinds};

/// A motion may jump if it moves further than this multiple of its way beside the interval.
const FURTHER: f64 = 3.0;

/// A way below this part of the ranges is no jump.
const LEAST: f64 = 1e-3;

/// The number of times that an interval is halved.
const HALVED: usize = 16;

/// Samples before, between and after two folds.
pub(super) fn hysteresis(
    samples: &[&Sample],
    at: &impl Fn(f64) -> Result<Sample, NoSteadyMotions>,
) -> Vec<[Sample; 3]> {
    let stretches = samples.chunk_by(|a, b| kinds(&a.found) == kinds(&b.found));
    let intervals = stretches.flat_map(|stretch| jumps(stretch).into_iter().map(|k| [stretch[k - 1], stretch[k]]));
    intervals.filter_map(|[before, after]| between(before.clone(), after.clone(), at)).collect()
}

/// The places of samples before which a motion jumps.
fn jumps(stretch: &[&Sample]) -> Vec<usize> {
    let tracks = tracks(stretch);
    let way = |track: &[usize], k: usize| {
        let [from, to] = [k - 1, k].map(|k| &stretch[k].found.motions[track[k]].enclosure);
        distance(&stretch[k].found.unknowns, from, to)
    };
    let jumps = |track: &Vec<usize>, k: usize| {
        let beside = [k - 1, k + 1].into_iter().filter(|k| (1..stretch.len()).contains(k));
        let usual = beside.map(|k| way(track, k)).reduce(f64::max);
        usual.is_some_and(|usual| way(track, k) > LEAST.max(FURTHER * usual))
    };
    (1..stretch.len()).filter(|&k| tracks.iter().any(|track| jumps(track, k))).collect()
}

/// Samples before, between and after two folds between samples with alike motions.
fn between(
    mut before: Sample,
    mut after: Sample,
    at: &impl Fn(f64) -> Result<Sample, NoSteadyMotions>,
) -> Option<[Sample; 3]> {
    for _ in 0..HALVED {
        let middle = at(0.5 * (before.value + after.value)).ok()?;
        if !middle.found.is_complete() {
            return None;
        }
        if kinds(&middle.found) != kinds(&before.found) {
            return Some([before, middle, after]);
        }
        let [left, right] = [[&before, &middle], [&middle, &after]].map(|pair| longest(&pair));
        if left.max(right) <= LEAST {
            return None;
        }
        if left > right { after = middle } else { before = middle }
    }
    None
}

/// The longest way of a motion between two samples.
fn longest(pair: &[&Sample; 2]) -> f64 {
    let ways = tracks(pair).into_iter().map(|track| {
        let [from, to] = [0, 1].map(|k| &pair[k].found.motions[track[k]].enclosure);
        distance(&pair[0].found.unknowns, from, to)
    });
    ways.fold(0.0, f64::max)
}
