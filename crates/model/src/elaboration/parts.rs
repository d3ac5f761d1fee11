//! Traversal of the expressions of a model.

use crate::arena::{Part, Scalar, Vector};
use crate::{Model, VectorId};

/// Returns for each node whether it is among the given nodes or occurs in one of them.
pub(super) fn reached(model: &Model, mut open: Vec<usize>) -> Vec<bool> {
    let mut reached = vec![false; model.arena.parts.len()];
    while let Some(part) = open.pop() {
        if !std::mem::replace(&mut reached[part], true) {
            match &model.arena.parts[part] {
                Part::Scalar(scalar) => of_scalar(model, scalar, &mut open),
                Part::Vector(vector) => of_vector(vector, &mut open),
            }
        }
    }
    reached
}

/// Appends the operands of a scalar node.
fn of_scalar(model: &Model, scalar: &Scalar, open: &mut Vec<usize>) {
    match scalar {
        Scalar::Switch(switch, _) => open.push(model.switches[*switch].0),
        Scalar::Input(input) => open.extend(model.inputs[*input].value.map(|value| value.0)),
        Scalar::Negation(a) | Scalar::Power(a, _) | Scalar::Function(_, a) | Scalar::RateOf(a) | Scalar::Step(a, _) => {
            open.push(a.0);
        }
        Scalar::Sum(a, b)
        | Scalar::Difference(a, b)
        | Scalar::Product(a, b)
        | Scalar::Quotient(a, b)
        | Scalar::Elementary(_, a, b) => open.extend([a.0, b.0]),
        Scalar::Dot(a, b) => open.extend([a.0, b.0]),
        Scalar::Norm(a) => open.push(a.0),
        _ => {}
    }
}

/// Appends the operands of a vector node. Its points and frames are not followed, since the given nodes include their expressions.
fn of_vector(vector: &Vector, open: &mut Vec<usize>) {
    let of = |id: &VectorId| id.0;
    match vector {
        Vector::Negation(a) | Vector::RateOf { of: a, .. } => open.push(of(a)),
        Vector::Sum(a, b) | Vector::Difference(a, b) | Vector::Cross(a, b) => open.extend([of(a), of(b)]),
        Vector::Scaled(a, b) => open.extend([a.0, of(b)]),
        _ => {}
    }
}
