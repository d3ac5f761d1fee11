//! The data of a body with spinning wheels, as integers with a common denominator.

use super::spectrum::{Matrix, Vector};
use algebra::real::{Field, Number, Root};
use field::Rational;
use nalgebra::{Matrix3, Vector3};

/// The tensor M, the wheels' angular momentum h and the weight vector G, multiplied by a common positive number.
#[derive(Clone, Debug)]
pub struct Body {
    pub(super) tensor: Matrix<Number>,
    pub(super) spin: Vector<Number>,
    pub(super) weight: Vector<Number>,
    pub(super) scale: Number,
}

impl Body {
    /// A body from its symmetric tensor M (kg m^2), the wheels' angular momentum per unit speed (kg m^2), their speed
    /// (rad/s), and the weight vector G (N m). `None` where a number is undefined.
    pub fn new(
        tensor: &Matrix3<Rational>,
        momentum: &Vector3<Rational>,
        speed: &Root,
        weight: &Vector3<Rational>,
    ) -> Option<Self> {
        let all: Vec<Rational> = tensor.iter().chain(weight.iter()).chain(momentum.iter()).copied().collect();
        let (whole, scale) = Number::over_common(&all)?;
        let (speed, denominator) = match speed.as_rational() {
            Some(speed) => {
                let (mut numerator, denominator) = Number::over_common(&[speed])?;
                (numerator.pop()?, denominator)
            }
            None => Field::of(speed)?,
        };
        let denominator_positive = denominator.sign() > 0;
        let positive = |n: Number| if denominator_positive { n } else { -&n };
        let (speed, denominator) = (positive(speed), positive(denominator));
        let times = |n: &Number| n * &denominator;
        Some(Body {
            // the tensor is symmetric: columns are rows
            tensor: std::array::from_fn(|i| std::array::from_fn(|j| times(&whole[3 * i + j]))),
            weight: std::array::from_fn(|i| times(&whole[9 + i])),
            spin: std::array::from_fn(|i| &whole[12 + i] * &speed),
            scale: times(&scale),
        })
    }
}
