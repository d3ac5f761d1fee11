//! The cone of all axes of steady rotation, branch by branch over the angular velocity, in double precision for
//! figures.
//!
//! In the principal axes of M, with k_i = w^2 m_i and b = w h + G, the multipliers are the roots of sum b_i^2 / (k_i -
//! x)^2 = 1: one beyond either end of the poles, and none or two between adjacent poles, where the sum is convex, so
//! that no branch is missed. Between two cuts (folds, zero, and angular velocities where some b_i vanishes) their
//! number is constant.

use mechanics::steady_rotations::Kind;
use nalgebra::Vector3;
use std::f64::consts::PI;

/// M, h and G in the principal axes of M.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Form {
    pub moments: Vector3<f64>,
    /// The vector h, N m s.
    pub spin: Vector3<f64>,
    /// The vector G, N m.
    pub weight: Vector3<f64>,
}

/// A connected curve of steady directions of one kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// The kind; `None` where w^2 would be negative.
    pub kind: Option<Kind>,
    /// The points (v, w) in the order of w.
    pub points: Vec<(Vector3<f64>, f64)>,
}

/// The number of points of a branch between two cuts.
const POINTS: usize = 60;
/// Components of b below this fraction are rounding.
const ROUNDING: f64 = 1e-13;
/// The number of binary digits of the distance to the next cut that an angular velocity keeps.
const BITS: i32 = 6;
/// The distance to a cut up to which a branch is computed, as a fraction of the interval.
const NEAR: f64 = 1e-9;

/// A steady direction at one angular velocity; `place` locates its multiplier among the poles, to join adjacent points.
struct Here {
    place: (usize, bool, bool),
    kind: Kind,
    direction: Vector3<f64>,
}

impl Form {
    /// All branches; `folds` are the angular velocities at which two branches merge.
    pub fn branches(&self, folds: &[f64]) -> Vec<Branch> {
        let mut cuts: Vec<f64> = folds.to_vec();
        cuts.push(0.0);
        cuts.extend((0..3).map(|i| -self.weight[i] / self.spin[i]).filter(|w| w.is_finite()));
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        let ends = [&[f64::NEG_INFINITY], &cuts[..], &[f64::INFINITY]].concat();
        let mut branches: Vec<Branch> = ends.windows(2).flat_map(|pair| self.stretch(pair[0], pair[1])).collect();
        if self.spin.norm() == 0.0 {
            branches.extend(self.without_rotation());
        }
        branches
    }

    /// The branches between two adjacent cuts.
    fn stretch(&self, from: f64, to: f64) -> Vec<Branch> {
        let usual = self.usual_speed();
        let at = |k: usize| {
            let share = (0.5 - 0.5 * (PI * k as f64 / (POINTS - 1) as f64).cos()).clamp(NEAR, 1.0 - NEAR);
            let w = match (from.is_finite(), to.is_finite()) {
                (true, true) => from + (to - from) * share,
                (true, false) => from + usual * share / (1.004 - share),
                (false, _) => to - usual * (1.0 - share) / (share + 0.004),
            };
            short(w, (w - from).min(to - w))
        };
        let instants = (0..POINTS).map(at).map(|w| (w, self.here(self.moments * (w * w), self.spin * w + self.weight)));
        joined(instants, true)
    }

    /// The branches of directions at which only a negative w^2 would balance the weight.
    fn without_rotation(&self) -> Vec<Branch> {
        let usual = self.usual_speed();
        let at = |k: usize| {
            let share = (k as f64 + 0.5) / POINTS as f64;
            usual * share / (1.004 - share)
        };
        joined((0..POINTS).map(at).map(|w| (f64::NAN, self.here(-self.moments * (w * w), self.weight))), false)
    }

    /// The magnitude of angular velocities (rad/s) at which rotation and weight, or rotation and rotor, are comparable.
    fn usual_speed(&self) -> f64 {
        let size = self.moments.max();
        (self.weight.norm() / size).sqrt() + self.spin.norm() / size
    }

    /// All v with (k - x) v + b = 0, |v| = 1 for some x.
    fn here(&self, k: Vector3<f64>, b: Vector3<f64>) -> Vec<Here> {
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| k[i].total_cmp(&k[j]));
        let size = b.norm();
        let (poles, free): (Vec<usize>, Vec<usize>) = order.iter().partition(|&&i| b[i].abs() > ROUNDING * size);
        let below = |x: f64| k.iter().filter(|k| **k < x).count();
        let direction = |origin: usize, t: f64| {
            Vector3::from_fn(|i, _| if b[i].abs() > ROUNDING * size { b[i] / ((k[origin] - k[i]) + t) } else { 0.0 })
        };
        let length = |origin: usize, t: f64| direction(origin, t).norm_squared() - 1.0;
        let mut found = Vec::new();
        if let (Some(&first), Some(&last)) = (poles.first(), poles.last()) {
            let t = -bisect(|t| length(first, -t), size);
            found.push(Here { place: (0, false, false), kind: Kind::Minimum, direction: direction(first, t) });
            let t = bisect(|t| length(last, t), size);
            found.push(Here { place: (3, true, false), kind: Kind::Maximum, direction: direction(last, t) });
        }
        for pair in poles.windows(2) {
            let [left, right] = [pair[0], pair[1]];
            let gap = k[right] - k[left];
            // the sum is convex: its minimum is where the derivative changes its sign
            let slope = |t: f64| {
                (0..3)
                    .filter(|&i| b[i].abs() > ROUNDING * size)
                    .map(|i| -b[i] * b[i] / ((k[left] - k[i]) + t).powi(3))
                    .sum::<f64>()
            };
            let (mut low, mut high) = (0.0, gap);
            for _ in 0..200 {
                let middle = 0.5 * (low + high);
                if slope(middle) < 0.0 { low = middle } else { high = middle }
            }
            let least = 0.5 * (low + high);
            if length(left, least) >= 0.0 {
                continue;
            }
            let at_left = bisect(|t| length(left, t), least);
            let at_right = -bisect(|t| length(right, -t), gap - least);
            let of = |falling: usize| [Kind::Minimum, Kind::Saddle, Kind::Maximum][falling.min(2)];
            let place = poles.iter().position(|&i| i == left).unwrap_or(0);
            let v = direction(left, at_left);
            found.push(Here {
                place: (place, true, false),
                kind: of(below(k[left] + at_left).saturating_sub(1)),
                direction: v,
            });
            let v = direction(right, at_right);
            found.push(Here { place: (place + 1, false, false), kind: of(below(k[right] + at_right)), direction: v });
        }
        for i in free {
            let centre = direction(i, 0.0);
            let room = 1.0 - centre.norm_squared();
            if room > 0.0 && poles.iter().all(|&j| k[j] != k[i]) {
                let kind = [Kind::Minimum, Kind::Saddle, Kind::Maximum][below(k[i]).min(2)];
                found.extend([1.0, -1.0].map(|side| Here {
                    place: (i, side > 0.0, true),
                    kind,
                    direction: centre + Vector3::ith(i, side * room.sqrt()),
                }));
            }
        }
        found
    }
}

/// A number with fewer digits, within 2^-BITS of a distance: exact arithmetic is then faster.
fn short(value: f64, distance: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    let unit = f64::from_bits(distance.to_bits() & EXPONENT) * 0.5f64.powi(BITS);
    (value / unit).round() * unit
}

/// Joins directions whose multipliers have equal positions.
fn joined(instants: impl Iterator<Item = (f64, Vec<Here>)>, real: bool) -> Vec<Branch> {
    let mut branches: Vec<((usize, bool, bool), Branch)> = Vec::new();
    for (w, all) in instants {
        for Here { place, kind, direction } in all {
            let kind = real.then_some(kind);
            match branches.iter_mut().find(|(known, branch)| *known == place && branch.kind == kind) {
                Some((_, branch)) => branch.points.push((direction, w)),
                None => branches.push((place, Branch { kind, points: vec![(direction, w)] })),
            }
        }
    }
    branches.into_iter().map(|(_, branch)| branch).collect()
}

/// The zero of a function that decreases from plus infinity at 0, to relative precision.
fn bisect(f: impl Fn(f64) -> f64, start: f64) -> f64 {
    let mut high = start;
    while f(high) > 0.0 {
        high *= 2.0;
    }
    let mut low = 0.5 * high;
    while f(low) < 0.0 && low > f64::MIN_POSITIVE {
        (low, high) = (0.5 * low, low);
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if f(middle) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}
