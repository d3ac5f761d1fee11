//! Piecewise functions: `if`, `abs`, `sign`, `min`, `max`, `table`. A condition becomes a switch with the value 1 or 0, and each
//! function a polynomial in switches. Between two events the law is smooth.

use super::expressions::Meaning;
use super::operations::no_operation;
use super::value::Value;
use super::{Elaborator, Sound};
use crate::arena::{AtZero, Number, Scalar};
use crate::expression::Relation;
use crate::{Fault, ScalarId};
use std::ops::Range;
use symbolic::Dimension;

impl Elaborator<'_> {
    /// Returns the switch of a comparison: 1 if `b - a` is positive, for `a <= b` also if it is zero.
    pub(super) fn comparison(
        &mut self,
        span: &Range<usize>,
        relation: Relation,
        a: Value,
        b: Value,
    ) -> Sound<ScalarId> {
        let (Value::Scalar(a), Value::Scalar(b)) = (a, b) else { return Err(no_operation(span, "compared", &[a, b])) };
        let dimension = self.common(span, a.0, b.0)?;
        // equality decides only the value in outputs; in a law it holds at isolated instants
        let (less, more) = match relation {
            Relation::Less | Relation::LessOrEqual => (a, b),
            Relation::Greater | Relation::GreaterOrEqual => (b, a),
        };
        let difference = self.scalar(Scalar::Difference(more, less), dimension);
        let at_zero = match relation {
            Relation::Less | Relation::Greater => AtZero::Off,
            Relation::LessOrEqual | Relation::GreaterOrEqual => AtZero::On,
        };
        Ok(self.switch(difference, at_zero, span))
    }

    /// Returns the switch that is 1 where an expression is positive and 0 where it is negative.
    fn switch(&mut self, positive: ScalarId, at_zero: AtZero, span: &Range<usize>) -> ScalarId {
        let known = self.model.switches.iter().position(|known| *known == positive);
        let switch = known.unwrap_or_else(|| {
            let unit = self.dimension_of(positive.0).unwrap_or_else(Dimension::none).to_string();
            let unit = units::Dimension::of(&unit).coherent();
            self.model.switches.push(positive);
            self.model.switch_units.push(unit);
            self.model.switch_places.push(span.clone());
            self.model.switches.len() - 1
        });
        self.scalar(Scalar::Switch(switch, at_zero), Some(Dimension::none()))
    }

    fn whole(&mut self, value: f64) -> ScalarId {
        self.scalar(Scalar::Number(Number { value, times: 1.0, per: 1.0 }), Some(Dimension::none()))
    }

    /// Returns s a + (1 - s) b for the switch s.
    fn chosen(&mut self, switch: ScalarId, a: ScalarId, b: ScalarId, dimension: Option<Dimension>) -> ScalarId {
        let one = self.whole(1.0);
        let off = self.scalar(Scalar::Difference(one, switch), Some(Dimension::none()));
        let [a, b] = [(switch, a), (off, b)].map(|(switch, of)| self.scalar(Scalar::Product(switch, of), dimension));
        self.scalar(Scalar::Sum(a, b), dimension)
    }

    /// Reads `if(condition, a, b)`.
    pub(super) fn choice(&mut self, span: &Range<usize>, condition: Meaning, a: Value, b: Value) -> Sound<Value> {
        let Meaning::Condition(switch) = condition else {
            let accepted = "if(t < (2 s), a, b)";
            return Err(Box::new(Fault::at(span.clone(), "`if` begins with a condition", "no condition", accepted)));
        };
        let (a, b) = (self.as_scalar(span, "the first case", a)?, self.as_scalar(span, "the second case", b)?);
        let dimension = self.common(span, a.0, b.0)?;
        Ok(Value::Scalar(self.chosen(switch, a, b, dimension)))
    }

    /// Returns `sign(a)` = 2 s - 1 or `abs(a)` = (2 s - 1) a.
    pub(super) fn sign(&mut self, span: &Range<usize>, of: Value, absolute: bool) -> Sound<Value> {
        let of = self.as_scalar(span, "the argument", of)?;
        let switch = self.switch(of, AtZero::Half, span);
        let (one, two) = (self.whole(1.0), self.whole(2.0));
        let none = Some(Dimension::none());
        let double = self.scalar(Scalar::Product(two, switch), none);
        let sign = self.scalar(Scalar::Difference(double, one), none);
        if !absolute {
            return Ok(Value::Scalar(sign));
        }
        let dimension = self.dimension_of(of.0);
        Ok(Value::Scalar(self.scalar(Scalar::Product(sign, of), dimension)))
    }

    /// Reads `min(a, b)` or `max(a, b)`.
    pub(super) fn extreme(&mut self, span: &Range<usize>, a: Value, b: Value, least: bool) -> Sound<Value> {
        let (a, b) = (self.as_scalar(span, "an argument", a)?, self.as_scalar(span, "an argument", b)?);
        let dimension = self.common(span, a.0, b.0)?;
        let (small, large) = if least { (a, b) } else { (b, a) };
        let difference = self.scalar(Scalar::Difference(large, small), dimension);
        let switch = self.switch(difference, AtZero::Half, span);
        Ok(Value::Scalar(self.chosen(switch, a, b, dimension)))
    }

    /// Reads `table(x, x1, y1, x2, y2, ...)`: linear interpolation between points with ascending x, constant outside.
    pub(super) fn table(&mut self, span: &Range<usize>, at: Value, points: &[Value]) -> Sound<Value> {
        let at = self.as_scalar(span, "the first argument", at)?;
        let wrong = |title: &str| {
            let accepted = "table(x, x1, y1, x2, y2, ...): at least two points, x1 < x2 < ...";
            Err(Box::new(Fault::at(span.clone(), title, "in this table", accepted)))
        };
        let (pairs, rest) = points.as_chunks::<2>();
        if pairs.len() < 2 || !rest.is_empty() {
            return wrong("a table must have at least two pairs of numbers");
        }
        let mut knots: Vec<[ScalarId; 2]> = Vec::new();
        for [x, y] in pairs {
            let [x, y] = [self.as_scalar(span, "a place", *x)?, self.as_scalar(span, "a value", *y)?];
            self.common(span, at.0, x.0)?;
            if let Some([_, first]) = knots.first() {
                self.common(span, first.0, y.0)?;
            }
            knots.push([x, y]);
        }
        let numbers = knots.iter().filter_map(|[x, _]| self.number_of(*x)).collect::<Vec<f64>>();
        if numbers.windows(2).any(|pair| pair[0] >= pair[1]) {
            return wrong("the places x1, x2, ... of a table must increase");
        }
        let along = self.dimension_of(at.0);
        // max(x - x_k, 0) for each knot x_k
        let beyond: Vec<ScalarId> = knots
            .iter()
            .map(|[x, _]| {
                let past = self.scalar(Scalar::Difference(at, *x), along);
                let switch = self.switch(past, AtZero::Half, span);
                self.scalar(Scalar::Product(switch, past), along)
            })
            .collect();
        let up = knots.iter().find_map(|[_, y]| self.dimension_of(y.0));
        let mut sum = knots[0][1];
        for (k, pair) in knots.windows(2).enumerate() {
            let ([x, y], [next_x, next_y]) = (pair[0], pair[1]);
            let run = self.scalar(Scalar::Difference(next_x, x), along);
            let rise = self.scalar(Scalar::Difference(next_y, y), up);
            let slope = up.zip(along).map(|(up, along)| up / along);
            let slope = self.scalar(Scalar::Quotient(rise, run), slope);
            let within = self.scalar(Scalar::Difference(beyond[k], beyond[k + 1]), along);
            let part = self.scalar(Scalar::Product(slope, within), up);
            sum = self.scalar(Scalar::Sum(sum, part), up);
        }
        Ok(Value::Scalar(sum))
    }

    /// Returns the value of a number, its negative, or a parameter.
    fn number_of(&self, id: ScalarId) -> Option<f64> {
        match self.model.arena.scalar_at(id)? {
            Scalar::Number(Number { value, times, per }) => Some(value * times / per),
            Scalar::Negation(of) => self.number_of(*of).map(|value| -value),
            Scalar::Parameter(at) => self.model.parameters[*at].value,
            _ => None,
        }
    }
}
