//! Nodes of expressions, each built from its operands.

use super::operations::no_operation;
use super::value::Value;
use super::{Elaborator, Named, Sound, unknown};
use crate::arena::{Number, Scalar, Vector};
use crate::expression::{Expression, Form};
use crate::parts::TURNING;
use crate::{Fault, FrameId, ScalarId, Text};
use field::Rational;
use std::ops::Range;
use symbolic::Dimension;

/// The meaning of a subexpression: a value, or a body, which has no value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Meaning {
    Value(Value),
    Body(crate::BodyId),
    /// A comparison, represented by its switch.
    Condition(crate::ScalarId),
    /// The name or number of a constraint, as a range of bytes. It is looked up among the constraints only.
    Literal {
        start: usize,
        end: usize,
    },
}

impl Elaborator<'_> {
    /// Returns the value of an expression that occurs in a text.
    pub(super) fn value_of(&mut self, text: &Text, expression: &Expression) -> Sound<Value> {
        let mut meanings: Vec<Meaning> = Vec::with_capacity(expression.parts.len());
        let of_constraints = constraint_names(expression);
        for (place, (form, span)) in expression.parts.iter().zip(&expression.spans).enumerate() {
            if of_constraints.contains(&place) {
                meanings.push(Meaning::Literal { start: span.start, end: span.end });
                continue;
            }
            match self.meaning(text, form, &text.part(span), &meanings, &expression.spans) {
                Ok(meaning) => meanings.push(meaning),
                Err(fault) => {
                    self.later_names(text, expression, place + 1, &of_constraints);
                    return Err(fault);
                }
            }
        }
        self.judge_angles(text, expression);
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

    pub(super) fn named(&mut self, span: &Range<usize>, name: &str) -> Sound<Meaning> {
        if self.broken.contains(name) {
            return Err(Box::new(Fault::consequence(span.clone())));
        }
        match self.names.get(name) {
            Some(Named::Value(value)) => return Ok(Meaning::Value(*value)),
            Some(Named::Body(body)) => return Ok(Meaning::Body(*body)),
            Some(Named::Drive(drive)) => return Err(self.bare_drive(span, *drive)),
            None => {}
        }
        if let Some(energy) = self.energy_shown(span, name)? {
            return Ok(Meaning::Value(Value::Scalar(energy)));
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
            (None, 1) if self.quasi_velocity_of(base).is_some() => {
                let Some(Named::Value(Value::Scalar(is))) = self.names.get(base).cloned() else {
                    return Err(Box::new(Fault::consequence(span.clone())));
                };
                let dimension = self.dimension_of(is.0).map(|dimension| dimension / Dimension::time());
                Ok(Meaning::Value(Value::Scalar(self.scalar(Scalar::RateOf(is), dimension))))
            }
            (None, _) if order > 1 && self.quasi_velocity_of(base).is_some() => Err(Box::new(Fault::at(
                span.clone(),
                format!("`{name}` is a rate of order {order} of a quasi-velocity"),
                "too high",
                format!("`{base}'`"),
            ))),
            (None, _) if order > 0 && self.names.contains_key(base) => Err(Box::new(Fault::at(
                span.clone(),
                format!("`{base}` is no coordinate, so `{name}` is not known"),
                "no coordinate",
                format!("rate({base}) is the rate of any scalar"),
            ))),
            (None, _) if matches!(name, "pi" | "PI" | "Pi" | "π") => {
                let title = format!("no parameter or coordinate is called `{name}`");
                Err(Box::new(Fault::at(span.clone(), title, "not known", "half a turn is (180 deg)")))
            }
            (None, _) if self.source.outputs.iter().any(|output| output.name.text == name) => {
                let title = format!("`{name}` is an output, not a parameter or coordinate");
                let accepted = format!("{name} under [definitions]: then expressions and outputs have it");
                Err(Box::new(Fault::at(span.clone(), title, "not known here", accepted)))
            }
            (None, _) => {
                let rates = self.model.coordinates.iter().map(|coordinate| coordinate.name.as_str());
                let known: Vec<&str> = self.names.keys().map(String::as_str).chain(rates).collect();
                Err(Box::new(unknown(
                    &self.broken,
                    span.clone(),
                    name,
                    "parameter, coordinate, point, frame or definition",
                    known.into_iter(),
                )))
            }
        }
    }

    pub(super) fn member(&mut self, span: &Range<usize>, of: &str, name: &str) -> Sound<Value> {
        if let Some(super::Named::Drive(drive)) = self.names.get(of) {
            return self.of_drive(span, *drive, name);
        }
        if let Some(fault) = self.component_of_no_frame(span, of, name) {
            return Err(Box::new(fault));
        }
        if name == "i" && !self.names.contains_key(of) && !self.broken.contains(of) {
            let title = format!("no drive is called `{of}`");
            return Err(Box::new(Fault::at(span.clone(), title, "not known", "[[drive]] with a name and windings")));
        }
        let frame = self.frame(&Text::at(of, span.start))?;
        let per_second = Some(Dimension::none() / Dimension::time());
        if name == "w" {
            let seen = match self.by_angles.contains(&frame) {
                true => self.parent_before_angles(frame),
                false => self.model.frames[frame.0].parent.map_or(FrameId::GROUND, |(parent, _)| parent),
            };
            return Ok(Value::Vector(self.vector(Vector::AngularVelocity { of: frame, seen }, per_second)));
        }
        if let (Some(part), Some(number)) = (TURNING.iter().position(|part| *part == name), self.number_of_free(frame))
        {
            let coordinate = self.model.free_speed(number) + part;
            return Ok(Value::Scalar(self.scalar(Scalar::Rate { coordinate, order: 1 }, per_second)));
        }
        if let Some(part) = TURNING.iter().position(|part| *part == name)
            && self.by_angles.contains(&frame)
        {
            return Ok(self.turning_by_angles(frame, part));
        }
        let Some(axis) = ["x", "y", "z"].iter().position(|axis| *axis == name) else {
            let title = format!("a frame has no part `{name}`");
            let accepted = format!("{of}.x, {of}.y, {of}.z, its axes; {of}.w, its angular velocity in its parent");
            return Err(Box::new(Fault::at(span.clone(), title, "not known", accepted)));
        };
        Ok(Value::Vector(self.vector(Vector::Axis { frame, axis }, Some(Dimension::none()))))
    }

    /// Returns the fault of `P.z` where P is not a frame, with a proposed expression.
    fn component_of_no_frame(&self, span: &Range<usize>, of: &str, name: &str) -> Option<Fault> {
        let axis = if matches!(name, "x" | "y" | "z") { name } else { "x" };
        let (kind, accepted) = match self.names.get(of)? {
            Named::Value(Value::Point { .. }) => {
                ("a point", format!("({of} - O) . N.{axis} is its coordinate along an axis"))
            }
            Named::Value(Value::Vector(_)) => ("a vector", format!("{of} . N.{axis} is its component along an axis")),
            Named::Value(Value::Scalar(_)) => ("a scalar", format!("`{of}` alone")),
            // a body stands for the frame in which it is fixed
            Named::Value(Value::Frame(_)) | Named::Body(_) | Named::Drive(_) => return None,
        };
        Some(Fault::at(span.clone(), format!("`{of}` is {kind}, and only frames have axes"), "no axis", accepted))
    }

    pub(super) fn number_of_free(&self, frame: FrameId) -> Option<usize> {
        self.model.free.iter().position(|free| *free == frame)
    }

    /// Returns the index of a scalar value; other values are a fault.
    pub(super) fn as_scalar(&self, span: &Range<usize>, what: &str, value: Value) -> Sound<ScalarId> {
        match value {
            Value::Scalar(id) => Ok(id),
            other => Err(super::mismatch(span, what, "a scalar", &other)),
        }
    }

    /// Returns the frame with this name.
    pub(super) fn seen_from(&self, name: &str, span: Range<usize>) -> Sound<FrameId> {
        self.frame(&Text::at(name, span.start))
    }
}

pub(super) fn lone_condition(span: Range<usize>) -> Box<Fault> {
    let accepted = "if(t < (2 s), a, b)";
    Box::new(Fault::at(span, "a condition stands in `if` alone", "a condition", accepted))
}

/// Functions whose arguments are names of constraints and contacts.
const OF_NAMES: [&str; 4] = ["reaction", "friction", "gap", "sliding"];

/// Returns the arguments of these functions that are names or numbers.
fn constraint_names(expression: &Expression) -> Vec<usize> {
    let calls = expression.parts.iter().filter_map(|form| match form {
        Form::Call { function, arguments } if OF_NAMES.contains(&function.as_str()) => Some(arguments),
        _ => None,
    });
    let literal = |part: &usize| matches!(expression.parts[*part], Form::Name(_) | Form::Number(_));
    calls.flatten().map(|argument| argument.value).filter(literal).collect()
}

pub(super) fn not_yet(span: &Range<usize>, what: &str, accepted: &str) -> Box<Fault> {
    Box::new(Fault::at(span.clone(), format!("{what} is not supported yet"), "not supported yet", accepted))
}
