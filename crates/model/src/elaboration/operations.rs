//! Operations on scalars, vectors and points: sums, products and powers, with the dimensions of their results.

use super::value::Value;
use super::{Elaborator, Sound};
use crate::arena::{Number, Scalar, Vector};
use crate::expression::Exponent;
use crate::{Fault, PointId, VectorId};
use field::{Elementary, Rational};
use std::ops::Range;
use symbolic::Dimension;

impl Elaborator<'_> {
    /// Returns the common dimension of two terms. Zero has every dimension.
    pub(super) fn common(&self, span: &Range<usize>, a: usize, b: usize) -> Sound<Option<Dimension>> {
        match (self.dimension_of(a), self.dimension_of(b)) {
            (Some(left), Some(right)) if left != right => Err(Box::new(Fault::at(
                span.clone(),
                "terms of different dimensions cannot be added or compared",
                format!("{left} on the left, {right} on the right"),
                "two terms of the same dimension; a number with a unit stands in parentheses: (20 mm)",
            ))),
            (left, right) => Ok(left.or(right)),
        }
    }

    pub(super) fn sum(&mut self, span: &Range<usize>, a: Value, b: Value) -> Sound<Value> {
        Ok(match (a, b) {
            (Value::Scalar(a), Value::Scalar(b)) => {
                let dimension = self.common(span, a.0, b.0)?;
                Value::Scalar(self.bounded(span, Scalar::Sum(a, b), dimension)?)
            }
            (Value::Vector(a), Value::Vector(b)) => Value::Vector(self.vector_sum(span, a, b)?),
            (Value::Point { base, way }, Value::Vector(b)) | (Value::Vector(b), Value::Point { base, way }) => {
                self.must_measure(span, b.0, "a vector between points", Some(Dimension::length()))?;
                let way = match way {
                    Some(way) => self.vector_sum(span, way, b)?,
                    None => b,
                };
                Value::Point { base, way: Some(way) }
            }
            _ => return Err(no_operation(span, "added", &[a, b])),
        })
    }

    fn vector_sum(&mut self, span: &Range<usize>, a: VectorId, b: VectorId) -> Sound<VectorId> {
        let dimension = self.common(span, a.0, b.0)?;
        Ok(self.vector(Vector::Sum(a, b), dimension))
    }

    pub(super) fn difference(&mut self, span: &Range<usize>, a: Value, b: Value) -> Sound<Value> {
        Ok(match (a, b) {
            (Value::Scalar(a), Value::Scalar(b)) => {
                let dimension = self.common(span, a.0, b.0)?;
                Value::Scalar(self.bounded(span, Scalar::Difference(a, b), dimension)?)
            }
            (Value::Vector(a), Value::Vector(b)) => {
                let dimension = self.common(span, a.0, b.0)?;
                Value::Vector(self.vector(Vector::Difference(a, b), dimension))
            }
            (Value::Point { .. }, Value::Vector(b)) => {
                let dimension = self.dimension_of(b.0);
                let back = self.vector(Vector::Negation(b), dimension);
                self.sum(span, a, Value::Vector(back))?
            }
            (Value::Point { base: to, way: to_way }, Value::Point { base: from, way: from_way }) => {
                let (from, to) = (self.point_of(from, from_way), self.point_of(to, to_way));
                Value::Vector(self.between(from, to))
            }
            _ => return Err(no_operation(span, "subtracted", &[a, b])),
        })
    }

    pub(super) fn between(&mut self, from: PointId, to: PointId) -> VectorId {
        self.vector(Vector::Between { from, to }, Some(Dimension::length()))
    }

    pub(super) fn product(&mut self, span: &Range<usize>, a: Value, b: Value) -> Sound<Value> {
        Ok(match (a, b) {
            (Value::Scalar(a), Value::Scalar(b)) => {
                let dimension = self.multiplied(a.0, b.0);
                Value::Scalar(self.bounded(span, Scalar::Product(a, b), dimension)?)
            }
            (Value::Scalar(a), Value::Vector(b)) | (Value::Vector(b), Value::Scalar(a)) => {
                let dimension = self.multiplied(a.0, b.0);
                Value::Vector(self.vector(Vector::Scaled(a, b), dimension))
            }
            (Value::Vector(_), Value::Vector(_)) => {
                return Err(Box::new(Fault::at(
                    span.clone(),
                    "two vectors are multiplied by *",
                    "which product is meant?",
                    "a . b (with spaces) or dot(a, b); cross(a, b)",
                )));
            }
            _ => return Err(no_operation(span, "multiplied", &[a, b])),
        })
    }

    fn multiplied(&self, a: usize, b: usize) -> Option<Dimension> {
        Some(self.dimension_of(a)? * self.dimension_of(b)?)
    }

    fn divided(&self, a: usize, b: usize) -> Option<Dimension> {
        Some(self.dimension_of(a)? / self.dimension_of(b)?)
    }

    pub(super) fn quotient(&mut self, span: &Range<usize>, a: Value, b: Value) -> Sound<Value> {
        let Value::Scalar(below) = b else { return Err(no_operation(span, "divided", &[a, b])) };
        if self.dimension_of(below.0).is_none() {
            return Err(Box::new(Fault::at(
                span.clone(),
                "a division by zero",
                "zero below",
                "a divisor other than zero",
            )));
        }
        Ok(match a {
            Value::Scalar(a) => {
                let dimension = self.divided(a.0, below.0);
                Value::Scalar(self.bounded(span, Scalar::Quotient(a, below), dimension)?)
            }
            Value::Vector(a) => {
                let one =
                    self.scalar(Scalar::Number(Number { value: 1.0, times: 1.0, per: 1.0 }), Some(Dimension::none()));
                let inverse = self.divided(one.0, below.0);
                let inverse = self.scalar(Scalar::Quotient(one, below), inverse);
                let dimension = self.divided(a.0, below.0);
                Value::Vector(self.vector(Vector::Scaled(inverse, a), dimension))
            }
            _ => return Err(no_operation(span, "divided", &[a, b])),
        })
    }

    pub(super) fn dot(&mut self, span: &Range<usize>, a: Value, b: Value) -> Sound<Value> {
        let (Value::Vector(a), Value::Vector(b)) = (a, b) else {
            return Err(no_operation(span, "multiplied as vectors", &[a, b]));
        };
        let dimension = self.multiplied(a.0, b.0);
        Ok(Value::Scalar(self.scalar(Scalar::Dot(a, b), dimension)))
    }

    pub(super) fn power(&mut self, span: &Range<usize>, a: Value, exponent: Exponent) -> Sound<Value> {
        let Value::Scalar(a) = a else {
            return Err(no_operation(span, "raised to a power", &[a]));
        };
        let share = Rational::new(exponent.numerator.into(), exponent.denominator.into());
        let dimension = self.dimension_of(a.0).map(|dimension| dimension.power(share));
        if exponent.denominator != 1 {
            self.must_not_be_negative(span, a);
        }
        if matches!(exponent.denominator, 1 | 2) {
            return Ok(Value::Scalar(self.bounded(span, Scalar::Power(a, exponent), dimension)?));
        }
        // other rational powers of a positive number, in SI units: exp(ln(a) n/d)
        let number = |value: i32| Scalar::Number(Number { value: f64::from(value), times: 1.0, per: 1.0 });
        let none = Some(Dimension::none());
        let logarithm = self.bounded(span, Scalar::Elementary(Elementary::Ln, a, a), none)?;
        let [above, below] = [exponent.numerator, exponent.denominator].map(|value| self.scalar(number(value), none));
        let share = self.scalar(Scalar::Quotient(above, below), none);
        let times = self.bounded(span, Scalar::Product(share, logarithm), none)?;
        Ok(Value::Scalar(self.bounded(span, Scalar::Elementary(Elementary::Exp, times, times), dimension)?))
    }
}

pub(super) fn no_operation(span: &Range<usize>, done: &str, values: &[Value]) -> Box<Fault> {
    let found = values.iter().map(Value::describe).collect::<Vec<_>>().join(" and ");
    let accepted = if values.iter().any(|value| matches!(value, Value::Frame(_))) {
        "a frame is no operand; its axes are vectors: A.x, A.y, A.z"
    } else {
        operands(done)
    };
    Box::new(Fault::at(span.clone(), format!("{found} cannot be {done}"), found, accepted))
}

/// Returns a description of the operands that an operation accepts.
fn operands(done: &str) -> &'static str {
    match done {
        "added" => "scalar + scalar, vector + vector, point + vector",
        "subtracted" => "scalar - scalar, vector - vector, point - vector; point - point is a vector",
        "negated" => "-scalar, -vector",
        "multiplied" => {
            "scalar*scalar, scalar*vector; of two vectors a . b or cross(a, b); (P - O) is the vector of a point P"
        }
        "divided" => "scalar/scalar, vector/scalar",
        "multiplied as vectors" => "two vectors: a . b, dot(a, b), cross(a, b)",
        "raised to a power" => "a scalar; of a vector v . v is the square",
        "measured apart" => "distance(P, Q) of two points",
        "measured" => "norm(v) and unit(v) of a vector, distance(P, Q) of two points, abs(x) of a scalar",
        _ => "two scalars",
    }
}
