//! Parts of an expression, each from those that it is made of.

use super::value::Value;
use super::{Elaborator, Named, Sound, unknown};
use crate::arena::{Number, Scalar, Vector};
use crate::expression::{Exponent, Expression, Form};
use crate::parts::TURNING;
use crate::{Fault, FrameId, PointId, ScalarId, Text, VectorId};
use field::Rational;
use std::ops::Range;
use symbolic::Dimension;

/// The longest number that is made of numbers.
const MOST_BITS: u64 = 1 << 20;

/// The meaning of a part: a value, or a body, which is no value of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Meaning {
    Value(Value),
    Body(crate::BodyId),
    /// A comparison, as its switch.
    Condition(crate::ScalarId),
    /// A name or a number of a constraint, by its bytes: it is looked up among constraints alone.
    Literal {
        start: usize,
        end: usize,
    },
}

impl Elaborator<'_> {
    /// The value of an expression that stands in a text.
    pub(super) fn value_of(&mut self, text: &Text, expression: &Expression) -> Sound<Value> {
        let mut meanings: Vec<Meaning> = Vec::with_capacity(expression.parts.len());
        let of_constraints = constraint_names(expression);
        for (place, (form, span)) in expression.parts.iter().zip(&expression.spans).enumerate() {
            if of_constraints.contains(&place) {
                meanings.push(Meaning::Literal { start: span.start, end: span.end });
                continue;
            }
            let meaning = self.meaning(text, form, &text.part(span), &meanings, &expression.spans)?;
            meanings.push(meaning);
        }
        match meanings.last() {
            Some(Meaning::Value(value)) => Ok(*value),
            Some(Meaning::Body(body)) => {
                let name = &self.model.bodies[body.0].name;
                let title = format!("the body `{name}` is no expression");
                Err(Box::new(Fault::at(text.span(), title, "a body", format!("its motion: velocity({name} at P)"))))
            }
            Some(Meaning::Condition(_)) => Err(lone_condition(text.span())),
            Some(Meaning::Literal { .. }) | None => {
                Err(Box::new(Fault::at(text.span(), "nothing stands here", "empty", super::EXAMPLES)))
            }
        }
    }

    fn meaning(
        &mut self,
        text: &Text,
        form: &Form,
        span: &Range<usize>,
        known: &[Meaning],
        spans: &[Range<usize>],
    ) -> Sound<Meaning> {
        let operand = |part: &usize| match known[*part] {
            Meaning::Value(value) => Ok(value),
            Meaning::Body(_) | Meaning::Literal { .. } => Err(Box::new(Fault::at(
                text.part(&spans[*part]),
                "a body is no operand",
                "a body",
                "its points and motion are: velocity(disc at P)",
            ))),
            Meaning::Condition(_) => Err(lone_condition(text.part(&spans[*part]))),
        };
        let value = match form {
            Form::Number(digits) => self.number(span, digits, "")?,
            Form::Quantity { number, unit } => self.number(span, number, unit)?,
            Form::Name(name) => return self.named(span, name),
            Form::Member { of, name } => self.member(span, of, name)?,
            Form::Negation(a) => match operand(a)? {
                Value::Scalar(a) => {
                    let dimension = self.dimension_of(a.0);
                    Value::Scalar(self.scalar(Scalar::Negation(a), dimension))
                }
                Value::Vector(a) => {
                    let dimension = self.dimension_of(a.0);
                    Value::Vector(self.vector(Vector::Negation(a), dimension))
                }
                other => return Err(no_operation(span, "negated", &[other])),
            },
            Form::Sum(a, b) => self.sum(span, operand(a)?, operand(b)?)?,
            Form::Difference(a, b) => self.difference(span, operand(a)?, operand(b)?)?,
            Form::Product(a, b) => self.product(span, operand(a)?, operand(b)?)?,
            Form::Quotient(a, b) => self.quotient(span, operand(a)?, operand(b)?)?,
            Form::Dot(a, b) => {
                let both = [(a, operand(a)?), (b, operand(b)?)];
                if both.iter().any(|(_, value)| matches!(value, Value::Point { .. })) {
                    let [left, right] = both.map(|(part, value)| match value {
                        Value::Point { .. } => format!("({} - O)", &text.text[spans[*part].clone()]),
                        _ => text.text[spans[*part].clone()].to_owned(),
                    });
                    let accepted = format!("point minus point is a vector: `{left} . {right}`");
                    return Err(Box::new(Fault::at(span.clone(), "a point is no vector", "a point", accepted)));
                }
                self.dot(span, both[0].1, both[1].1)?
            }
            Form::Power(a, exponent) => self.power(span, operand(a)?, *exponent)?,
            Form::Call { function, arguments } => self.call(text, span, function, arguments, known)?,
            Form::Comparison(relation, a, b) => {
                let switch = self.comparison(span, *relation, operand(a)?, operand(b)?)?;
                return Ok(Meaning::Condition(switch));
            }
        };
        Ok(Meaning::Value(value))
    }

    fn number(&mut self, span: &Range<usize>, digits: &str, unit: &str) -> Sound<Value> {
        let value = units::quantity::finite(digits).map_err(|wrong| {
            Box::new(Fault::at(span.clone(), wrong.to_string(), "no number", "a decimal number such as 0.25 or 1e-4"))
        })?;
        let read = units::Unit::parse(unit).map_err(|wrong| {
            Box::new(Fault::at(span.clone(), wrong.to_string(), "no unit", "a number with its unit, such as (20 mm)"))
        })?;
        let dimension = (value != 0.0).then(|| read.dimension().of_expressions());
        let [times, per] = read.factors();
        Ok(Value::Scalar(self.scalar(Scalar::Number(Number { value, times, per }), dimension)))
    }

    fn named(&mut self, span: &Range<usize>, name: &str) -> Sound<Meaning> {
        match self.names.get(name) {
            Some(Named::Value(value)) => return Ok(Meaning::Value(*value)),
            Some(Named::Body(body)) => return Ok(Meaning::Body(*body)),
            None => {}
        }
        let plain = name.replace('′', "'").replace('″', "''");
        let base = plain.trim_end_matches('\'');
        let order = plain.len() - base.len();
        let coordinate = self.model.coordinates.iter().position(|coordinate| coordinate.name == base);
        match (coordinate, order) {
            (Some(coordinate), 1 | 2) => {
                let per = Dimension::time().power(Rational::new(order as i64, 1));
                let dimension = self.model.coordinates[coordinate].dimension / per;
                let rate = self.scalar(Scalar::Rate { coordinate, order }, Some(dimension));
                Ok(Meaning::Value(Value::Scalar(rate)))
            }
            (Some(_), _) => Err(Box::new(Fault::at(
                span.clone(),
                format!("`{name}` is a rate of order {order}"),
                "too high",
                format!("`{base}'` and `{base}''`"),
            ))),
            (None, _) if order > 0 && self.names.contains_key(base) => Err(Box::new(Fault::at(
                span.clone(),
                format!("`{base}` is no coordinate, so `{name}` is not known"),
                "no coordinate",
                format!("rate({base}) is the rate of any scalar"),
            ))),
            (None, _) if matches!(name, "pi" | "PI" | "Pi" | "π") => {
                let title = format!("no letter is called `{name}`");
                Err(Box::new(Fault::at(span.clone(), title, "not known", "half a turn is (180 deg)")))
            }
            (None, _) => {
                let rates = self.model.coordinates.iter().map(|coordinate| coordinate.name.as_str());
                let known: Vec<&str> = self.names.keys().map(String::as_str).chain(rates).collect();
                Err(Box::new(unknown(
                    &self.broken,
                    span.clone(),
                    name,
                    "letter, point, frame or definition",
                    known.into_iter(),
                )))
            }
        }
    }

    fn member(&mut self, span: &Range<usize>, of: &str, name: &str) -> Sound<Value> {
        let frame = self.frame(&Text::at(of, span.start))?;
        let per_second = Some(Dimension::none() / Dimension::time());
        if name == "w" {
            let seen = self.model.frames[frame.0].parent.map_or(FrameId::GROUND, |(parent, _)| parent);
            return Ok(Value::Vector(self.vector(Vector::AngularVelocity { of: frame, seen }, per_second)));
        }
        if let (Some(part), Some(number)) = (TURNING.iter().position(|part| *part == name), self.number_of_free(frame))
        {
            let coordinate = self.model.free_speed(number) + part;
            return Ok(Value::Scalar(self.scalar(Scalar::Rate { coordinate, order: 1 }, per_second)));
        }
        let Some(axis) = ["x", "y", "z"].iter().position(|axis| *axis == name) else {
            let title = format!("a frame has no part `{name}`");
            let accepted = format!("{of}.x, {of}.y, {of}.z, its axes; {of}.w, its angular velocity in its parent");
            return Err(Box::new(Fault::at(span.clone(), title, "not known", accepted)));
        };
        Ok(Value::Vector(self.vector(Vector::Axis { frame, axis }, Some(Dimension::none()))))
    }

    pub(super) fn number_of_free(&self, frame: FrameId) -> Option<usize> {
        self.model.free.iter().position(|free| *free == frame)
    }

    /// The dimension of two parts that are added; zero fits to everything.
    pub(super) fn common(&self, span: &Range<usize>, a: usize, b: usize) -> Sound<Option<Dimension>> {
        match (self.dimension_of(a), self.dimension_of(b)) {
            (Some(left), Some(right)) if left != right => Err(Box::new(Fault::at(
                span.clone(),
                "the two sides have different dimensions",
                format!("{left} and {right}"),
                "terms of one dimension are added; a number with a unit stands in parentheses: (20 mm)",
            ))),
            (left, right) => Ok(left.or(right)),
        }
    }

    fn sum(&mut self, span: &Range<usize>, a: Value, b: Value) -> Sound<Value> {
        Ok(match (a, b) {
            (Value::Scalar(a), Value::Scalar(b)) => {
                let dimension = self.common(span, a.0, b.0)?;
                Value::Scalar(self.scalar(Scalar::Sum(a, b), dimension))
            }
            (Value::Vector(a), Value::Vector(b)) => Value::Vector(self.vector_sum(span, a, b)?),
            (Value::Point { base, way }, Value::Vector(b)) | (Value::Vector(b), Value::Point { base, way }) => {
                self.must_measure(span, b.0, "a way between points", Some(Dimension::length()))?;
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

    fn difference(&mut self, span: &Range<usize>, a: Value, b: Value) -> Sound<Value> {
        Ok(match (a, b) {
            (Value::Scalar(a), Value::Scalar(b)) => {
                let dimension = self.common(span, a.0, b.0)?;
                Value::Scalar(self.scalar(Scalar::Difference(a, b), dimension))
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

    fn product(&mut self, span: &Range<usize>, a: Value, b: Value) -> Sound<Value> {
        Ok(match (a, b) {
            (Value::Scalar(a), Value::Scalar(b)) => {
                let dimension = self.multiplied(a.0, b.0);
                Value::Scalar(self.scalar(Scalar::Product(a, b), dimension))
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

    fn quotient(&mut self, span: &Range<usize>, a: Value, b: Value) -> Sound<Value> {
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
                Value::Scalar(self.scalar(Scalar::Quotient(a, below), dimension))
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

    fn power(&mut self, span: &Range<usize>, a: Value, exponent: Exponent) -> Sound<Value> {
        let Value::Scalar(a) = a else {
            return Err(no_operation(span, "raised to a power", &[a]));
        };
        if !matches!(exponent.denominator, 1 | 2) {
            let accepted = "whole exponents and halves, x^(3/2); of a positive number x also exp(ln(x)/3)";
            return Err(not_yet(span, "an exponent that is no multiple of 1/2", accepted));
        }
        if self.bits[a.0].is_some_and(|bits| bits.saturating_mul(exponent.numerator.unsigned_abs().into()) > MOST_BITS)
        {
            let title = "this number has more digits than anything needs";
            return Err(Box::new(Fault::at(span.clone(), title, "too long", "a decimal number such as 1.5e-3")));
        }
        let share = Rational::new(exponent.numerator.into(), exponent.denominator.into());
        let dimension = self.dimension_of(a.0).map(|dimension| dimension.power(share));
        Ok(Value::Scalar(self.scalar(Scalar::Power(a, exponent), dimension)))
    }

    /// A scalar part by its id.
    pub(super) fn as_scalar(&self, span: &Range<usize>, what: &str, value: Value) -> Sound<ScalarId> {
        match value {
            Value::Scalar(id) => Ok(id),
            other => Err(super::mismatch(span, what, "a scalar", &other)),
        }
    }

    /// The frame of a name in an expression.
    pub(super) fn seen_from(&self, name: &str, span: Range<usize>) -> Sound<FrameId> {
        self.frame(&Text::at(name, span.start))
    }
}

pub(super) fn lone_condition(span: Range<usize>) -> Box<Fault> {
    let accepted = "if(t < (2 s), a, b)";
    Box::new(Fault::at(span, "a condition stands in `if` alone", "a condition", accepted))
}

/// The arguments of `reaction`: names and numbers as they stand.
fn constraint_names(expression: &Expression) -> Vec<usize> {
    let calls = expression.parts.iter().filter_map(|form| match form {
        Form::Call { function, arguments } if function == "reaction" => Some(arguments),
        _ => None,
    });
    let literal = |part: &usize| matches!(expression.parts[*part], Form::Name(_) | Form::Number(_));
    calls.flatten().map(|argument| argument.value).filter(literal).collect()
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

/// The operands that an operation has.
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

pub(super) fn not_yet(span: &Range<usize>, what: &str, accepted: &str) -> Box<Fault> {
    Box::new(Fault::at(span.clone(), format!("{what} is not there yet"), "not there yet", accepted))
}
