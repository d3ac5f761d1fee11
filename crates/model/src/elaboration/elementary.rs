//! Elementary functions: exponentials, logarithms, hyperbolic and inverse trigonometric functions, expressed by exp, ln, tanh and atan2.

use super::value::Value;
use super::{Elaborator, Sound};
use crate::ScalarId;
use crate::arena::{Function, Number, Scalar};
use crate::expression::Exponent;
use field::Elementary;
use std::ops::Range;
use symbolic::Dimension;

/// Functions of one argument.
pub(super) const OF_ONE: [&str; 9] = ["exp", "ln", "tanh", "sinh", "cosh", "asin", "acos", "atan", "log"];

impl Elaborator<'_> {
    /// Reads one of the functions [`OF_ONE`].
    pub(super) fn elementary(&mut self, span: &Range<usize>, name: &str, of: Value) -> Sound<Value> {
        let of = self.as_scalar(span, "the argument", of)?;
        self.must_measure(span, of.0, &format!("the argument of `{name}`"), Some(Dimension::none()))?;
        Ok(Value::Scalar(match name {
            "exp" => {
                self.must_not_be_large(span, of);
                self.called(Elementary::Exp, of, of)
            }
            "ln" | "log" => {
                self.must_not_be_negative(span, of);
                self.called(Elementary::Ln, of, of)
            }
            "tanh" => self.called(Elementary::Tanh, of, of),
            "sinh" | "cosh" => self.hyperbolic(span, of, name == "cosh"),
            "atan" => {
                let one = self.pure(1.0);
                self.called(Elementary::Atan2, of, one)
            }
            // asin and acos by atan2, with the other leg of a right triangle with hypotenuse one
            _ => {
                let (one, half) = (self.pure(1.0), Exponent { numerator: 2, denominator: 1 });
                let square = self.unmeasured(Scalar::Power(of, half));
                let rest = self.unmeasured(Scalar::Difference(one, square));
                self.must_not_be_negative(span, rest);
                let leg = self.unmeasured(Scalar::Function(Function::Sqrt, rest));
                let (opposite, adjacent) = if name == "asin" { (of, leg) } else { (leg, of) };
                self.called(Elementary::Atan2, opposite, adjacent)
            }
        }))
    }

    /// Reads `atan2(y, x)` for two numbers of equal dimension.
    pub(super) fn angle_of(&mut self, span: &Range<usize>, y: Value, x: Value) -> Sound<Value> {
        let (y, x) = (self.as_scalar(span, "an argument", y)?, self.as_scalar(span, "an argument", x)?);
        self.common(span, y.0, x.0)?;
        Ok(Value::Scalar(self.called(Elementary::Atan2, y, x)))
    }

    /// Returns (e^a - e^-a)/2, or with `even` (e^a + e^-a)/2.
    fn hyperbolic(&mut self, span: &Range<usize>, of: ScalarId, even: bool) -> ScalarId {
        let back = self.unmeasured(Scalar::Negation(of));
        [of, back].into_iter().for_each(|exponent| self.must_not_be_large(span, exponent));
        let (grows, falls) = (self.called(Elementary::Exp, of, of), self.called(Elementary::Exp, back, back));
        let both = self.unmeasured(if even { Scalar::Sum(grows, falls) } else { Scalar::Difference(grows, falls) });
        let two = self.pure(2.0);
        self.unmeasured(Scalar::Quotient(both, two))
    }

    fn called(&mut self, function: Elementary, a: ScalarId, b: ScalarId) -> ScalarId {
        self.unmeasured(Scalar::Elementary(function, a, b))
    }

    fn pure(&mut self, value: f64) -> ScalarId {
        self.unmeasured(Scalar::Number(Number { value, times: 1.0, per: 1.0 }))
    }

    fn unmeasured(&mut self, scalar: Scalar) -> ScalarId {
        self.scalar(scalar, Some(Dimension::none()))
    }
}
