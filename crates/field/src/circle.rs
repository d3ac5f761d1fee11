//! Angles as points of the unit circle.

use crate::{Analytic, Scalar, Tangent};
use std::ops::{Add, Neg, Sub};

/// The point (cos a, sin a): an angle without its number of turns. Sums are the addition theorems, so that every law
/// in it is algebraic and an equality between laws can be decided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle<S> {
    pub cos: S,
    pub sin: S,
}

impl<S: Scalar> Circle<S> {
    /// The angle 0.
    pub fn zero() -> Self {
        Circle { cos: S::one(), sin: S::zero() }
    }

    /// Every rational point but (-1, 0), from t = tan(a/2): ((1 - t^2), 2t) / (1 + t^2).
    pub fn from_half_tangent(t: S) -> Self {
        let norm = S::one() + t * t;
        Circle { cos: (S::one() - t * t) / norm, sin: (t + t) / norm }
    }

    /// cos^2 + sin^2 - 1: zero on the circle.
    pub fn defect(self) -> S {
        self.cos * self.cos + self.sin * self.sin - S::one()
    }

    /// The same angle moving at the rate `speed`: its derivative is (-sin, cos) * speed.
    #[inline]
    pub fn moving(self, speed: S) -> Circle<Tangent<S>> {
        Circle {
            cos: Tangent { value: self.cos, slope: -self.sin * speed },
            sin: Tangent { value: self.sin, slope: self.cos * speed },
        }
    }

    /// The same point with its coordinates seen in another field.
    #[inline]
    pub fn map<T>(self, f: impl Fn(S) -> T) -> Circle<T> {
        Circle { cos: f(self.cos), sin: f(self.sin) }
    }
}

impl<S: Analytic> Circle<S> {
    /// One eighth of a turn, pi/4: both coordinates are the root of 1/2.
    pub fn eighth_turn() -> Self {
        let root = S::ratio(1, 2).sqrt();
        Circle { cos: root, sin: root }
    }
}

impl Circle<f64> {
    /// The fraction `part / whole` of a full turn.
    pub fn turn(part: u32, whole: u32) -> Self {
        (std::f64::consts::TAU * f64::from(part) / f64::from(whole)).circle()
    }
}

impl<S: Scalar> Add for Circle<S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Circle { cos: self.cos * other.cos - self.sin * other.sin, sin: self.sin * other.cos + self.cos * other.sin }
    }
}

impl<S: Scalar> Neg for Circle<S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Circle { cos: self.cos, sin: -self.sin }
    }
}

impl<S: Scalar> Sub for Circle<S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
