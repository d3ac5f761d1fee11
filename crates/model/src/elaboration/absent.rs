//! Simplification of a model whose parameters are partly zero: removes the terms and conditions that vanish with them.

use crate::arena::{Number, Part, Scalar, Vector};
use crate::{Contact, Function, Model, ScalarId};
use std::sync::Arc;

impl Model {
    /// Sets the named parameters to zero permanently. Terms that vanish are removed from the law, and conditions that no longer change it are not
    /// monitored.
    pub(super) fn leave_out<N: AsRef<str>>(&mut self, names: &[N]) {
        for (place, parameter) in self.parameters.iter_mut().enumerate() {
            if names.iter().any(|name| name.as_ref() == parameter.name) {
                parameter.value = Some(0.0);
                parameter.written = if parameter.unit == "1" { "0".into() } else { format!("0 {}", parameter.unit) };
                self.absent.push(place);
            }
        }
        if !self.absent.is_empty() {
            self.drop_what_vanishes();
        }
    }

    /// Returns the model with frictionless contacts where the current parameter values make the coefficient of friction zero.
    pub fn with_smooth_contacts(self: &Arc<Self>) -> Arc<Self> {
        let rough = |contact: &Contact| contact.friction.is_some();
        if !self.contacts.iter().any(rough) {
            return Arc::clone(self);
        }
        let zeros = self.parameters.iter().enumerate().filter(|(_, parameter)| parameter.value == Some(0.0));
        let vanishes = self.vanishing(&zeros.map(|(place, _)| place).collect::<Vec<_>>());
        let mut smooth = Arc::clone(self);
        if self.contacts.iter().filter_map(|contact| contact.friction).any(|friction| vanishes[friction.0]) {
            Arc::make_mut(&mut smooth).smooth_contacts(&vanishes);
        }
        smooth
    }

    fn smooth_contacts(&mut self, vanishes: &[bool]) {
        for contact in &mut self.contacts {
            contact.friction = contact.friction.filter(|friction| !vanishes[friction.0]);
        }
    }

    /// Returns for each node whether it is zero in every motion if the given parameters are zero.
    fn vanishing(&self, zeros: &[usize]) -> Vec<bool> {
        let mut vanishes: Vec<bool> = Vec::with_capacity(self.arena.parts.len());
        // operands precede the operations on them
        for part in &self.arena.parts {
            vanishes.push(match part {
                Part::Scalar(scalar) => is_zero_scalar(*scalar, &vanishes, zeros),
                Part::Vector(vector) => is_zero_vector(*vector, &vanishes),
            });
        }
        vanishes
    }

    fn drop_what_vanishes(&mut self) {
        let vanishes = self.vanishing(&self.absent);
        let parts = &mut self.arena.parts;
        for place in 0..parts.len() {
            parts[place] = match parts[place] {
                Part::Scalar(_) if vanishes[place] => Part::Scalar(ZERO),
                Part::Vector(_) if vanishes[place] => Part::Vector(Vector::Zero),
                // only the other term of the sum remains
                Part::Scalar(Scalar::Sum(a, b)) if vanishes[a.0] => parts[b.0],
                Part::Scalar(Scalar::Sum(a, b) | Scalar::Difference(a, b)) if vanishes[b.0] => parts[a.0],
                Part::Scalar(Scalar::Difference(a, b)) if vanishes[a.0] => Part::Scalar(Scalar::Negation(b)),
                Part::Vector(Vector::Sum(a, b)) if vanishes[a.0] => parts[b.0],
                Part::Vector(Vector::Sum(a, b) | Vector::Difference(a, b)) if vanishes[b.0] => parts[a.0],
                Part::Vector(Vector::Difference(a, b)) if vanishes[a.0] => Part::Vector(Vector::Negation(b)),
                part => part,
            };
        }
        self.smooth_contacts(&vanishes);
    }
}

const ZERO: Scalar = Scalar::Number(Number { value: 0.0, times: 1.0, per: 1.0 });

/// Returns whether a scalar is zero in every motion, if the given parameters are zero; `vanishes` contains the results for its operands.
fn is_zero_scalar(scalar: Scalar, vanishes: &[bool], absent: &[usize]) -> bool {
    let is_zero = |id: ScalarId| vanishes[id.0];
    match scalar {
        Scalar::Number(number) => number.value == 0.0,
        Scalar::Parameter(place) => absent.contains(&place),
        Scalar::Negation(a) | Scalar::RateOf(a) => is_zero(a),
        Scalar::Function(Function::Sin | Function::Tan | Function::Sqrt, a) => is_zero(a),
        Scalar::Sum(a, b) | Scalar::Difference(a, b) => is_zero(a) && is_zero(b),
        Scalar::Product(a, b) => is_zero(a) || is_zero(b),
        Scalar::Quotient(a, b) => is_zero(a) && !is_zero(b),
        Scalar::Power(a, exponent) => is_zero(a) && exponent.numerator > 0,
        Scalar::Dot(a, b) => vanishes[a.0] || vanishes[b.0],
        Scalar::Norm(a) => vanishes[a.0],
        _ => false,
    }
}

fn is_zero_vector(vector: Vector, vanishes: &[bool]) -> bool {
    match vector {
        Vector::Zero => true,
        Vector::Negation(a) | Vector::RateOf { of: a, .. } => vanishes[a.0],
        Vector::Sum(a, b) | Vector::Difference(a, b) => vanishes[a.0] && vanishes[b.0],
        Vector::Scaled(a, b) => vanishes[a.0] || vanishes[b.0],
        Vector::Cross(a, b) => vanishes[a.0] || vanishes[b.0],
        _ => false,
    }
}
