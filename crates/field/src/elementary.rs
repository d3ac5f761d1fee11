//! Elementary functions other than square roots and circle points: names, values and derivatives.

use crate::Scalar;

/// A function of one argument a, or of two, a and b.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Elementary {
    /// The exponential e^a.
    Exp,
    /// The natural logarithm of a positive number.
    Ln,
    /// The hyperbolic tangent.
    Tanh,
    /// The angle of the point (b, a), from -pi to pi rad.
    Atan2,
}

impl Elementary {
    pub const ALL: [Elementary; 4] = [Elementary::Exp, Elementary::Ln, Elementary::Tanh, Elementary::Atan2];

    /// The name in expressions.
    pub fn name(self) -> &'static str {
        match self {
            Elementary::Exp => "exp",
            Elementary::Ln => "ln",
            Elementary::Tanh => "tanh",
            Elementary::Atan2 => "atan2",
        }
    }

    /// The number of arguments.
    pub fn arguments(self) -> usize {
        if self == Elementary::Atan2 { 2 } else { 1 }
    }

    /// The partial derivatives with respect to a and b, from the arguments and the value.
    pub fn slopes<S: Scalar>(self, a: S, b: S, value: S) -> [S; 2] {
        match self {
            Elementary::Exp => [value, S::zero()],
            Elementary::Ln => [S::one() / a, S::zero()],
            Elementary::Tanh => [S::one() - value * value, S::zero()],
            Elementary::Atan2 => {
                let square = a * a + b * b;
                [b / square, -a / square]
            }
        }
    }

    /// The value in `f64`, bitwise equal on all platforms.
    pub fn of(self, a: f64, b: f64) -> f64 {
        match self {
            Elementary::Exp => libm::exp(a),
            Elementary::Ln => libm::log(a),
            Elementary::Tanh => libm::tanh(a),
            Elementary::Atan2 => libm::atan2(a, b),
        }
    }
}
