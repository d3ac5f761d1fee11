//! Functions in expressions: of numbers, vectors and motions.

use super::elementary::OF_ONE;
use super::expressions::{Meaning, not_yet};
use super::operations::no_operation;
use super::orders::ACCELERATIONS;
use super::value::Value;
use super::{Elaborator, Sound, unknown};
use crate::arena::{Function, Scalar, Vector};
use crate::expression::{Argument, FUNCTIONS, Preposition, usage};
use crate::{Domain, DomainEnd, Fault, FrameId, Material, ScalarId, Text};
use field::Rational;
use std::ops::Range;
use symbolic::Dimension;

/// Planned functions that are not supported yet.
const LATER: [&str; 1] = ["angular_acceleration"];

/// An argument with its optional preposition `at` or `in`.
struct Found {
    meaning: Meaning,
    place: Option<(Preposition, String, Range<usize>)>,
}

impl Elaborator<'_> {
    pub(super) fn call(
        &mut self,
        text: &Text,
        span: &Range<usize>,
        function: &str,
        arguments: &[Argument],
        known: &[Meaning],
    ) -> Sound<Value> {
        let found: Vec<Found> = arguments
            .iter()
            .map(|argument| Found {
                meaning: known[argument.value],
                place: argument.place.clone().map(|(word, name, place)| (word, name, text.part(&place))),
            })
            .collect();
        let count = |needed: usize| match found.len() == needed {
            true => Ok(()),
            false => {
                let plural = if needed == 1 { "" } else { "s" };
                let title = format!("`{function}` has {needed} argument{plural}");
                Err(Box::new(Fault::at(span.clone(), title, format!("{} stand here", found.len()), usage(function))))
            }
        };
        let plain = |place: usize| match &found[place] {
            Found { meaning: Meaning::Value(value), place: None } => Ok(*value),
            _ => Err(Box::new(Fault::at(
                span.clone(),
                format!("`{function}` has no such argument"),
                "here",
                usage(function),
            ))),
        };
        if let Some(named) = Function::named(function) {
            count(1)?;
            return self.function(span, named, plain(0)?);
        }
        match function {
            "if" => {
                count(3)?;
                self.choice(span, found[0].meaning, plain(1)?, plain(2)?)
            }
            "abs" | "sign" => {
                count(1)?;
                self.sign(span, plain(0)?, function == "abs")
            }
            "min" | "max" => {
                count(2)?;
                self.extreme(span, plain(0)?, plain(1)?, function == "min")
            }
            "atan2" => {
                count(2)?;
                self.angle_of(span, plain(0)?, plain(1)?)
            }
            "table" => {
                let all: Vec<Value> = (0..found.len()).map(plain).collect::<Sound<_>>()?;
                self.table(span, all[0], &all[1..])
            }
            one if OF_ONE.contains(&one) => {
                count(1)?;
                self.elementary(span, one, plain(0)?)
            }
            "dot" | "cross" | "distance" => {
                count(2)?;
                let (a, b) = (plain(0)?, plain(1)?);
                match function {
                    "dot" => self.dot(span, a, b),
                    "cross" => self.cross(span, a, b),
                    _ => self.distance(span, a, b),
                }
            }
            "norm" | "unit" => {
                count(1)?;
                self.length(span, function == "unit", plain(0)?)
            }
            "velocity" | "acceleration" => {
                count(1)?;
                self.motion(span, function, &found[0])
            }
            "angular_velocity" => {
                count(1)?;
                let of = match found[0].meaning {
                    Meaning::Value(Value::Frame(frame)) => frame,
                    Meaning::Body(body) => self.turning(span, body)?,
                    Meaning::Value(other) => {
                        return Err(super::mismatch(span, "the argument", "a frame or a body", &other));
                    }
                    Meaning::Condition(_) => return Err(super::expressions::lone_condition(span.clone())),
                    Meaning::Literal { .. } => {
                        return Err(Box::new(Fault::at(
                            span.clone(),
                            "a frame or a body turns",
                            "here",
                            usage(function),
                        )));
                    }
                };
                let seen = self.seen(span, function, &found[0])?;
                let per_second = Dimension::none() / Dimension::time();
                Ok(Value::Vector(self.vector(Vector::AngularVelocity { of, seen }, Some(per_second))))
            }
            "rate" => {
                count(1)?;
                self.rate(span, &found[0])
            }
            "reaction" => {
                let arguments: Vec<Meaning> = found.iter().map(|found| found.meaning).collect();
                self.reaction(text, span, &arguments)
            }
            "friction" | "gap" | "sliding" => {
                self.must_be_output(span, function)?;
                let arguments: Vec<Meaning> = found.iter().map(|found| found.meaning).collect();
                self.of_contact(text, span, function, &arguments)
            }
            "joint_force" | "joint_torque" => {
                self.must_be_output(span, function)?;
                count(1)?;
                match &found[0] {
                    Found { meaning: Meaning::Body(body), place: None } => {
                        self.joint_load(span, function == "joint_force", *body)
                    }
                    _ => Err(Box::new(Fault::at(span.clone(), "a body has a joint", "here", usage(function)))),
                }
            }
            "momentum" => {
                self.must_be_output(span, function)?;
                count(1)?;
                match found[0] {
                    Found { meaning: Meaning::Body(body), place: None } => self.momentum_of_body(span, body),
                    _ => self.momentum(span, plain(0)?),
                }
            }
            "angular_momentum" => {
                self.must_be_output(span, function)?;
                let arguments: Vec<Meaning> = found.iter().map(|found| found.meaning).collect();
                self.angular_momentum(span, &arguments)
            }
            later if LATER.contains(&later) => Err(not_yet(
                span,
                &format!("the function `{later}`"),
                "rate(angular_velocity(B)) is the angular acceleration",
            )),
            other => Err(Box::new(unknown(
                &self.broken,
                span.clone(),
                other,
                "function",
                FUNCTIONS.iter().map(|function| function.name),
            ))),
        }
    }

    fn function(&mut self, span: &Range<usize>, function: Function, of: Value) -> Sound<Value> {
        let of = self.as_scalar(span, "the argument", of)?;
        let dimension = match function {
            Function::Sqrt => {
                self.must_not_be_negative(span, of);
                self.dimension_of(of.0).map(|dimension| dimension.power(Rational::new(1, 2)))
            }
            _ => {
                self.must_measure(span, of.0, "an angle", Some(Dimension::none()))?;
                Some(Dimension::none())
            }
        };
        Ok(Value::Scalar(self.scalar(Scalar::Function(function, of), dimension)))
    }

    /// Records an expression that must not be negative, since a function is defined only there.
    pub(super) fn must_not_be_negative(&mut self, span: &Range<usize>, margin: ScalarId) {
        self.note(Domain { margin, end: DomainEnd::Negative, at: span.clone() });
    }

    /// Records the exponent of an exponential function, which overflows if it is large.
    pub(super) fn must_not_be_large(&mut self, span: &Range<usize>, margin: ScalarId) {
        self.note(Domain { margin, end: DomainEnd::Large, at: span.clone() });
    }

    fn note(&mut self, domain: Domain) {
        if !self.model.domains.contains(&domain) {
            self.model.domains.push(domain);
        }
    }

    fn cross(&mut self, span: &Range<usize>, a: Value, b: Value) -> Sound<Value> {
        let (Value::Vector(a), Value::Vector(b)) = (a, b) else {
            return Err(no_operation(span, "multiplied as vectors", &[a, b]));
        };
        let dimension = self.dimension_of(a.0).zip(self.dimension_of(b.0)).map(|(a, b)| a * b);
        Ok(Value::Vector(self.vector(Vector::Cross(a, b), dimension)))
    }

    fn distance(&mut self, span: &Range<usize>, a: Value, b: Value) -> Sound<Value> {
        let (Value::Point { base: from, way: first }, Value::Point { base: to, way: second }) = (a, b) else {
            return Err(no_operation(span, "measured apart", &[a, b]));
        };
        let (from, to) = (self.point_of(from, first), self.point_of(to, second));
        let between = self.between(from, to);
        Ok(Value::Scalar(self.scalar(Scalar::Norm(between), Some(Dimension::length()))))
    }

    /// Returns the length of a vector, or with `along` the unit vector along it.
    pub(super) fn length(&mut self, span: &Range<usize>, along: bool, of: Value) -> Sound<Value> {
        let Value::Vector(of) = of else { return Err(no_operation(span, "measured", &[of])) };
        let dimension = self.dimension_of(of.0);
        let norm = self.scalar(Scalar::Norm(of), dimension);
        if !along {
            return Ok(Value::Scalar(norm));
        }
        let one = crate::arena::Number { value: 1.0, times: 1.0, per: 1.0 };
        let one = self.scalar(Scalar::Number(one), Some(Dimension::none()));
        let inverse = self.scalar(Scalar::Quotient(one, norm), dimension.map(|of| Dimension::none() / of));
        Ok(Value::Vector(self.vector(Vector::Scaled(inverse, of), dimension.map(|_| Dimension::none()))))
    }

    /// Reads `velocity(P)`, `velocity(disc)`, `velocity(disc at P)` or `velocity(P in B)`, and the same forms of `acceleration`.
    fn motion(&mut self, span: &Range<usize>, function: &str, found: &Found) -> Sound<Value> {
        let of = match (found.meaning, &found.place) {
            (Meaning::Body(body), Some((Preposition::At, point, place))) => {
                let point = self.point(&Text::at(point.as_str(), place.start))?;
                Material { body: Some(body), point }
            }
            (Meaning::Body(body), _) => Material { body: Some(body), point: self.centre(body, span)? },
            (Meaning::Value(Value::Point { base, way }), place) if !matches!(place, Some((Preposition::At, ..))) => {
                Material { body: None, point: self.point_of(base, way) }
            }
            _ => {
                return Err(Box::new(Fault::at(
                    span.clone(),
                    "a point or a body at a point moves",
                    "here",
                    usage(function),
                )));
            }
        };
        let seen = self.seen(span, function, found)?;
        let metre_per_second = Dimension::length() / Dimension::time();
        Ok(Value::Vector(match function {
            "velocity" => self.vector(Vector::Velocity { of, seen }, Some(metre_per_second)),
            _ => self.vector(Vector::Acceleration { of, seen }, Some(metre_per_second / Dimension::time())),
        }))
    }

    /// Returns the frame of reference named after `in`; by default the ground.
    fn seen(&mut self, span: &Range<usize>, function: &str, found: &Found) -> Sound<FrameId> {
        match &found.place {
            Some((Preposition::In, name, place)) => self.seen_from(name, place.clone()),
            Some((Preposition::At, ..))
                if !matches!(found.meaning, Meaning::Body(_)) || function == "angular_velocity" =>
            {
                Err(Box::new(Fault::at(span.clone(), "only a body has points", "`at` stands here", usage(function))))
            }
            _ => Ok(FrameId::GROUND),
        }
    }

    fn turning(&mut self, span: &Range<usize>, body: crate::BodyId) -> Sound<FrameId> {
        let name = self.model.bodies[body.0].name.clone();
        self.frame(&Text::at(name, span.start))
    }

    /// Returns a fault for the rate of an acceleration or reaction: it would contain third derivatives of coordinates, which the law does not give.
    fn must_have_rate(&self, span: &Range<usize>, part: usize) -> Sound<()> {
        if self.orders.of(part).is_none_or(|order| order < ACCELERATIONS) {
            return Ok(());
        }
        let title = "accelerations and reactions have no rate here";
        let accepted = "rates of coordinates and speeds, and of expressions of these; second rates at most";
        Err(Box::new(Fault::at(span.clone(), title, "this would hold a third rate of a coordinate", accepted)))
    }

    fn rate(&mut self, span: &Range<usize>, found: &Found) -> Sound<Value> {
        match (found.meaning, &found.place) {
            (Meaning::Value(Value::Scalar(of)), None) => {
                self.must_have_rate(span, of.0)?;
                let dimension = self.dimension_of(of.0).map(|of| of / Dimension::time());
                Ok(Value::Scalar(self.scalar(Scalar::RateOf(of), dimension)))
            }
            (Meaning::Value(Value::Vector(of)), place) if !matches!(place, Some((Preposition::At, ..))) => {
                self.must_have_rate(span, of.0)?;
                let seen = self.seen(span, "rate", found)?;
                let dimension = self.dimension_of(of.0).map(|of| of / Dimension::time());
                Ok(Value::Vector(self.vector(Vector::RateOf { of, seen }, dimension)))
            }
            _ => Err(Box::new(Fault::at(span.clone(), "a scalar or a vector has a rate", "here", usage("rate")))),
        }
    }
}
