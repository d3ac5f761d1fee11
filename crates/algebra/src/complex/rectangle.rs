//! Rectangular enclosures of complex numbers.

use crate::real::Enclosure;
use std::ops::{Add, Mul, Sub};

/// An enclosure of a complex number. Operations round outwards: the result contains all values for all operands.
#[derive(Clone, Debug, PartialEq)]
pub struct Rectangle {
    pub re: Enclosure,
    pub im: Enclosure,
}

impl Rectangle {
    /// The enclosure of a real number.
    pub fn real(re: Enclosure, bits: usize) -> Self {
        Rectangle { re, im: Enclosure::integer(0, bits) }
    }

    /// |z|^2.
    pub fn square(&self) -> Enclosure {
        &(&self.re * &self.re) + &(&self.im * &self.im)
    }

    /// The quotient; `None` where the divisor may be zero.
    pub fn over(&self, divisor: &Self) -> Option<Self> {
        let size = divisor.square();
        let product = self * &Rectangle { re: divisor.re.clone(), im: -&divisor.im };
        Some(Rectangle { re: product.re.over(&size)?, im: product.im.over(&size)? })
    }

    /// The midpoint of the rectangle.
    pub fn middle(&self) -> Self {
        Rectangle { re: self.re.middle(), im: self.im.middle() }
    }
}

impl Add for &Rectangle {
    type Output = Rectangle;
    fn add(self, b: &Rectangle) -> Rectangle {
        Rectangle { re: &self.re + &b.re, im: &self.im + &b.im }
    }
}

impl Sub for &Rectangle {
    type Output = Rectangle;
    fn sub(self, b: &Rectangle) -> Rectangle {
        Rectangle { re: &self.re - &b.re, im: &self.im - &b.im }
    }
}

impl Mul for &Rectangle {
    type Output = Rectangle;
    fn mul(self, b: &Rectangle) -> Rectangle {
        Rectangle { re: &(&self.re * &b.re) - &(&self.im * &b.im), im: &(&self.re * &b.im) + &(&self.im * &b.re) }
    }
}
