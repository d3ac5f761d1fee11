//! A regime of contacts as linear equations and inequalities in the reactions.

use super::dry::Pairs;
use super::{Dry, Mode, Touch};
use field::Scalar;
use std::fmt;

/// An affine form in the reactions: constant + row . lambda.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Form<S, const K: usize> {
    pub constant: S,
    pub row: Pairs<S, K>,
}

/// An inequality that a regime requires of a contact besides its equations: the quantity is nonnegative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Condition {
    /// The acceleration gap'': an open contact does not close.
    Separates,
    /// The normal reaction, positive in the direction of its face.
    Presses,
    /// The margin f |N| - T: the tangential reaction stays within the friction cone in forward direction.
    HoldsForwards,
    /// The margin f |N| + T: the tangential reaction stays within the friction cone in backward direction.
    HoldsBackwards,
    /// The tangential acceleration, in the direction of incipient sliding.
    Departs,
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Separates => "separation gap''",
            Self::Presses => "normal reaction |N|",
            Self::HoldsForwards => "friction limit f|N| - T",
            Self::HoldsBackwards => "friction limit f|N| + T",
            Self::Departs => "acceleration of the slip",
        })
    }
}

impl<S: Scalar, const K: usize> Form<S, K> {
    /// The reaction of one contact, normal (0) or tangential (1), times a factor.
    fn reaction(contact: usize, component: usize, factor: S) -> Self {
        let mut row = [[S::zero(); 2]; K];
        row[contact][component] = factor;
        Form { constant: S::zero(), row }
    }

    fn plus(mut self, contact: usize, component: usize, factor: S) -> Self {
        self.row[contact][component] += factor;
        self
    }

    fn times(self, factor: S) -> Self {
        Form { constant: self.constant * factor, row: self.row.map(|pair| pair.map(|entry| entry * factor)) }
    }

    /// The value for given reactions.
    pub fn at(&self, reactions: &Pairs<S, K>) -> S {
        let terms = self.row.as_flattened().iter().zip(reactions.as_flattened());
        terms.fold(self.constant, |sum, (a, x)| sum + *a * *x)
    }

    /// The form without its constant.
    pub fn homogeneous(self) -> Self {
        Form { constant: S::zero(), ..self }
    }
}

impl<S: Scalar, const K: usize> Dry<S, K> {
    /// The acceleration of a contact as a form: of the gap (0) or along the curve (1).
    pub fn acceleration(&self, contact: usize, component: usize) -> Form<S, K> {
        Form { constant: self.free[contact][component], row: self.response[contact][component] }
    }
}

/// The equations of a regime, two for each contact.
pub fn equations<S: Scalar, const K: usize>(dry: &Dry<S, K>, regime: &[Mode; K]) -> [[Form<S, K>; 2]; K] {
    std::array::from_fn(|k| match regime[k] {
        Mode::Apart => [Form::reaction(k, 0, S::one()), Form::reaction(k, 1, S::one())],
        Mode::Stick(_) => [dry.acceleration(k, 0), dry.acceleration(k, 1)],
        // T = -(direction) f |N|
        Mode::Slip(direction, face) => {
            let limit = dry.friction[k] * face.sign() * direction.sign();
            [dry.acceleration(k, 0), Form::reaction(k, 1, S::one()).plus(k, 0, limit)]
        }
    })
}

/// The conditions of each contact, at most three, with their margins as forms.
pub type Conditions<S, const K: usize> = [[Option<(Condition, Form<S, K>)>; 3]; K];

/// The inequalities of a regime, by contact.
pub fn conditions<S: Scalar, const K: usize>(
    dry: &Dry<S, K>,
    touches: &[Touch; K],
    regime: &[Mode; K],
) -> Conditions<S, K> {
    std::array::from_fn(|k| match regime[k] {
        Mode::Apart if touches[k] == Touch::Open => [None; 3],
        Mode::Apart => [Some((Condition::Separates, dry.acceleration(k, 0))), None, None],
        Mode::Stick(face) => {
            let limit = Form::reaction(k, 0, dry.friction[k] * face.sign());
            [
                Some((Condition::Presses, Form::reaction(k, 0, face.sign()))),
                Some((Condition::HoldsForwards, limit.plus(k, 1, -S::one()))),
                Some((Condition::HoldsBackwards, limit.plus(k, 1, S::one()))),
            ]
        }
        Mode::Slip(direction, face) => {
            let begins = touches[k] == Touch::Rest && !dry.friction[k].is_zero();
            let departs = (Condition::Departs, dry.acceleration(k, 1).times(direction.sign()));
            [Some((Condition::Presses, Form::reaction(k, 0, face.sign()))), begins.then_some(departs), None]
        }
    })
}
