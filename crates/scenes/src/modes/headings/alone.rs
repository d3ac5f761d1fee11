//! All directions in which one contact may begin to slide: zeros, on the whole circle, of the component of its acceleration normal to the
//! direction.

use super::super::mode::Heading;
use super::{Slip, exact};
use std::f64::consts::TAU;

/// The number of trial directions, and the largest number of steps to a zero between two of them.
const TRIED: usize = 64;
const STEPS: usize = 80;

impl Slip<'_> {
    /// All directions in which the acceleration of the slip is parallel to the direction.
    pub(super) fn of_one(&self) -> Vec<Vec<Heading>> {
        let at = |angle: f64| Some(self.accelerations(&[exact(angle)])?[0]);
        let step = TAU / TRIED as f64;
        // avoids multiples of a right angle, which are often exact directions of slip
        let tried: Vec<(f64, Option<[f64; 2]>)> =
            (0..=TRIED).map(|place| (place as f64 - 0.382) * step).map(|angle| (angle, at(angle))).collect();
        let between = |pair: &[(f64, Option<[f64; 2]>)]| {
            let [(low, at_low), (high, at_high)] = [pair[0], pair[1]];
            let [at_low, at_high] = [at_low?[0], at_high?[0]];
            if at_low == 0.0 || (at_low > 0.0) == (at_high > 0.0) {
                return (at_low == 0.0).then_some(low);
            }
            Some(zero(|angle| at(angle).map_or(f64::NAN, |parts| parts[0]), [low, high], [at_low, at_high]))
        };
        let own = tried.windows(2).filter_map(between);
        own.filter(|&angle| at(angle).is_some_and(|[_, along]| along > 0.0)).map(|angle| vec![exact(angle)]).collect()
    }
}

/// The zero of a function between two points with values of different signs, by the Illinois variant of the secant method (Dowell and
/// Jarratt 1971).
fn zero(of: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2], [mut at_low, mut at_high]: [f64; 2]) -> f64 {
    let mut side = 0;
    for _ in 0..STEPS {
        let place = (low * at_high - high * at_low) / (at_high - at_low);
        let value = of(place);
        if value == 0.0 || place == low || place == high || !value.is_finite() {
            return place;
        }
        if (value > 0.0) == (at_high > 0.0) {
            (high, at_high) = (place, value);
            if side == 1 {
                at_low /= 2.0;
            }
            side = 1;
        } else {
            (low, at_low) = (place, value);
            if side == -1 {
                at_high /= 2.0;
            }
            side = -1;
        }
        if (high - low).abs() <= 2.0 * f64::EPSILON * low.abs().max(high.abs()) {
            return place;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::zero;

    #[test]
    fn a_zero_is_found_to_rounding() {
        let found = zero(|x| x.cos() - x, [0.0, 1.5], [1.0, 1.5_f64.cos() - 1.5]);
        assert!((found - 0.739_085_133_215_160_6).abs() < 1e-15);
    }
}
