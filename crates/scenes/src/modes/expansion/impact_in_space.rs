//! An impact with friction in space along a constant direction of sliding.
//!
//! The impulses N (normal) and T (tangential) change the sliding velocity v by N c + D T with a vector c and a matrix D. If c and D v are
//! parallel to v, as for a ball, T remains parallel to v during the whole impact, and the law is that of an impact in the plane of the
//! normal and v. Otherwise the direction of sliding changes during the impact (Routh 1860); such impacts are refused.

use super::impact_law::NotStruck;
use integrators::Real;

/// Components normal to the direction of sliding below this part of the others are rounding errors.
const ACROSS: f64 = 1e-12;

/// A contact that closes in space: the rate of its gap, its sliding velocity (m/s), and the changes of these by unit impulses (1/kg), one
/// column per impulse: N, then T along each tangent.
pub(super) struct Struck<S> {
    pub closing: S,
    pub sliding: [S; 2],
    pub responses: [[S; 3]; 3],
}

impl<S: Real> Struck<S> {
    /// The unit vector of the direction of sliding, which is constant during the impact.
    ///
    /// # Errors
    /// [`NotStruck::Turns`] if the direction would change.
    pub fn way(&self) -> Result<[S; 2], NotStruck> {
        let [[_, _, _], [by_normal, own, cross], [beside, _, other]] = self.responses;
        let size = |[a, b]: [S; 2]| (a * a + b * b).sqrt();
        let (speed, pull) = (size(self.sliding), size([by_normal, beside]));
        let is_small = |value: S, beside: S| value.approx().abs() <= ACROSS * beside.approx().abs();
        // a contact at rest begins to slide in the direction of the effect of N
        let way = match (speed.is_zero(), pull.is_zero()) {
            (false, _) => self.sliding.map(|part| part / speed),
            (true, false) => [by_normal / pull, beside / pull],
            (true, true) => [S::one(), S::zero()],
        };
        let across = |[first, second]: [S; 2]| way[0] * second - way[1] * first;
        let response = [own * way[0] + cross * way[1], cross * way[0] + other * way[1]];
        let keeps = (speed.is_zero() || is_small(across([by_normal, beside]), own + other))
            && is_small(across(response), own + other);
        if keeps { Ok(way) } else { Err(NotStruck::Turns) }
    }

    /// The impact in the plane of the normal and a direction: the rate of the gap, the sliding velocity along the direction, and their
    /// changes by unit impulses along the normal and this direction.
    pub fn along(&self, [first, second]: [S; 2]) -> (S, S, [[S; 2]; 2]) {
        let along = |[_, one, other]: [S; 3]| first * one + second * other;
        let [gap, one, other] = self.responses;
        let by_normal = along([S::zero(), one[0], other[0]]);
        let by_tangent = first * along(one) + second * along(other);
        let sliding = first * self.sliding[0] + second * self.sliding[1];
        (self.closing, sliding, [[gap[0], along(gap)], [by_normal, by_tangent]])
    }
}

#[cfg(test)]
mod tests {
    use super::{NotStruck, Struck};

    /// A ball: unit impulses change the velocity of its lowest point by 1/m along the normal, and by 7/(2 m) along the tangents.
    fn ball(sliding: [f64; 2]) -> Struck<f64> {
        Struck { closing: -1.0, sliding, responses: [[1.0, 0.0, 0.0], [0.0, 3.5, 0.0], [0.0, 0.0, 3.5]] }
    }

    #[test]
    fn a_ball_keeps_its_direction() {
        let way = ball([0.6, -0.8]).way().unwrap();
        assert!((way[0] - 0.6).abs() < 1e-15 && (way[1] + 0.8).abs() < 1e-15);
        let (_, sliding, responses) = ball([0.6, -0.8]).along(way);
        assert!((sliding - 1.0).abs() < 1e-15 && (responses[1][1] - 3.5).abs() < 1e-14);
    }

    #[test]
    fn a_body_whose_friction_turns_its_sliding_is_refused() {
        let mut body = ball([0.6, -0.8]);
        body.responses[2][2] = 1.0;
        assert_eq!(body.way(), Err(NotStruck::Turns));
        body.sliding = [1.0, 0.0];
        assert!(body.way().is_ok());
        body.responses[2][0] = 0.1;
        assert_eq!(body.way(), Err(NotStruck::Turns));
    }
}
