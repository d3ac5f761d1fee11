//! Solutions with w = 0: p = h.v with v parallel or antiparallel to the weight, or any v if there is no weight.

use super::{Case, Momentum, RotationPlace, Selected, Turning};
use crate::steady_rotations::spectrum::Vector;
use crate::steady_rotations::{Kind, Shape};
use algebra::real::Number;
use std::sync::Arc;

impl Selected {
    pub(super) fn rests(&mut self, case: &Arc<Case>, momentum: &Momentum) {
        let body = &case.body;
        let Momentum { numerator: p, denominator: d } = momentum;
        let (squared, shared) = (inner(&body.weight, &body.weight), &inner(&body.spin, &body.weight) * d);
        let rest =
            |shape: Shape, kind: Kind, place: RotationPlace| Turning { shape, kind, place, case: Arc::clone(case) };
        if squared.is_zero() {
            self.motions
                .extend(weightless(case, momentum).into_iter().map(|(s, place)| rest(s, Kind::Degenerate, place)));
        } else if (&(&(p * p) * &squared) - &(&shared * &shared)).is_zero() {
            // p G^2 = h.G |G| or its negative
            let same = p.sign() * shared.sign() >= 0;
            let sides = if p.is_zero() { vec![true, false] } else { vec![same] };
            let of_side = |along: bool| {
                let place = RotationPlace::Rest { along, vector: body.weight.clone() };
                rest(Shape::Point, if along { Kind::Maximum } else { Kind::Minimum }, place)
            };
            self.motions.extend(sides.into_iter().map(of_side));
        }
    }
}

/// All v with h.v = p: a circle about h if |p| < |h|, a point if both are equal.
fn weightless(case: &Arc<Case>, Momentum { numerator: p, denominator: d }: &Momentum) -> Vec<(Shape, RotationPlace)> {
    let axis = case.body.spin.clone();
    let most = inner(&axis, &axis);
    match (&(p * p) - &(&(&most * d) * d)).sign() {
        0 if most.is_zero() => vec![(Shape::Sphere, RotationPlace::Everywhere)],
        0 => vec![(Shape::Point, RotationPlace::Rest { along: p.sign() * d.sign() > 0, vector: axis })],
        -1 => {
            let place = RotationPlace::Circle { axis, momentum: p.clone(), denominator: &most * d };
            vec![(Shape::Circle { place: 0 }, place)]
        }
        _ => Vec::new(),
    }
}

fn inner(a: &Vector<Number>, b: &Vector<Number>) -> Number {
    (0..3).fold(Number::zero(), |sum, i| &sum + &(&a[i] * &b[i]))
}
