//! Angles as points of the unit circle.

use crate::{Analytic, Scalar, Tangent};
use std::ops::{Add, Neg, Sub};

/// The point (cos a, sin a), which represents an angle without its number of turns. Sums follow the addition theorems.
/// Laws in it are algebraic, so that equality of laws can be decided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle<S> {
    pub cos: S,
    pub sin: S,
}

impl<S: Scalar> Circle<S> {
    /// The angle 0.
    #[inline(always)]
    pub fn zero() -> Self {
        Circle { cos: S::one(), sin: S::zero() }
    }

    /// The rational point with t = tan(a/2): ((1 - t^2), 2t) / (1 + t^2), which gives all of them but (-1, 0).
    pub fn from_half_tangent(t: S) -> Self {
        let norm = S::one() + t * t;
        Circle { cos: (S::one() - t * t) / norm, sin: (t + t) / norm }
    }

    /// The residual cos^2 + sin^2 - 1: zero on the circle.
    pub fn defect(self) -> S {
        self.cos * self.cos + self.sin * self.sin - S::one()
    }

    /// The angle as dual numbers with the rate `speed`: the derivative is (-sin, cos) * speed.
    #[inline(always)]
    pub fn moving(self, speed: S) -> Circle<Tangent<S>> {
        Circle { cos: Tangent::moving(self.cos, -self.sin * speed), sin: Tangent::moving(self.sin, self.cos * speed) }
    }

    /// The angle as the variable of a short law: dual numbers that mark constants, see
    /// [`DerivativeKnowledge`](crate::DerivativeKnowledge).
    #[inline(always)]
    pub fn varied(self) -> Circle<Tangent<S, bool>> {
        Circle { cos: Tangent::at_rate(self.cos, -self.sin), sin: Tangent::at_rate(self.sin, self.cos) }
    }

    /// The point with a function applied to both coordinates.
    #[inline(always)]
    pub fn map<T>(self, f: impl Fn(S) -> T) -> Circle<T> {
        Circle { cos: f(self.cos), sin: f(self.sin) }
    }
}

impl<S: Analytic> Circle<S> {
    /// The fraction `part / whole` of a full turn, exactly by square roots of 2 and 3; `None` unless `whole` divides
    /// 24.
    pub fn exact_turn(part: u32, whole: u32) -> Option<Self> {
        if whole == 0 || 24 % whole != 0 {
            return None;
        }
        let (two, three) = (S::int(2).sqrt(), S::int(3).sqrt());
        let quarter = two * S::ratio(1, 4);
        // cosines of 0, 15, ..., 90 degrees
        let cosines = [
            S::one(),
            quarter * (three + S::one()),
            three.half(),
            two.half(),
            S::ratio(1, 2),
            quarter * (three - S::one()),
            S::zero(),
        ];
        let steps = (part % whole * (24 / whole)) as usize;
        let (quadrant, step) = (steps / 6, steps % 6);
        let (cos, sin) = (cosines[step], cosines[6 - step]);
        Some(match quadrant {
            0 => Circle { cos, sin },
            1 => Circle { cos: -sin, sin: cos },
            2 => Circle { cos: -cos, sin: -sin },
            _ => Circle { cos: sin, sin: -cos },
        })
    }
}

impl Circle<f64> {
    /// The fraction `part / whole` of a full turn, rounded to `f64`.
    pub fn turn(part: u32, whole: u32) -> Self {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(part) / f64::from(whole)).sin_cos();
        Circle { cos, sin }
    }
}

impl<S: Scalar> Add for Circle<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Circle {
            cos: (self.cos * other.cos).less_product(self.sin, other.sin),
            sin: (self.sin * other.cos).and_product(self.cos, other.sin),
        }
    }
}

impl<S: Scalar> Neg for Circle<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Circle { cos: self.cos, sin: -self.sin }
    }
}

impl<S: Scalar> Sub for Circle<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
