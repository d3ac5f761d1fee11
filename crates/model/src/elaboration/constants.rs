//! Constants: their exact values, and a bound of their length.
//!
//! Constants are computed exactly in decimal notation: 0.1 + 0.2 is 0.3. Products and powers become long: a decimal of 17 digits to the
//! power 40 has 700 digits. A constant longer than [`MOST_BITS`] is replaced by the nearest number in double precision. Parameters
//! remain symbols here and get values when a system is run; a constant formed from parameters that is too long for a run is an error.

use super::{Elaborator, Sound};
use crate::arena::{Number, Scalar};
use crate::expression::Exponent;
use crate::{Fault, ScalarId};
use dashu_int::ops::BitTest;
use dashu_ratio::RBig;
use field::Rational;
use std::f64::consts::{PI, TAU};
use std::ops::Range;
use symbolic::Dimension;

/// The largest number of bits of numerator and denominator of a constant formed from decimals; this is 38 digits.
const MOST_BITS: usize = 128;

/// The limit for a constant that contains parameters or pi, which stays exact.
const MOST_BITS_OF_DATA: usize = 10_000;

/// Pi to 48 digits, as the sum of three numbers in double precision.
pub const HALF_TURN: [f64; 3] = [PI, 1.224_646_799_147_353_2e-16, -2.994_769_809_718_339_7e-33];

/// An exact constant.
#[derive(Clone, Debug)]
pub(super) struct Constant {
    value: RBig,
    of: Data,
}

/// The ingredients of a constant; a later variant includes the earlier ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Data {
    Decimals,
    Pi,
    Parameters,
}

impl Constant {
    fn is_short(&self) -> bool {
        let most = if self.of == Data::Decimals { MOST_BITS } else { MOST_BITS_OF_DATA };
        self.value.numerator().bit_len().max(self.value.denominator().bit_len()) <= most
    }

    fn combined(&self, other: &Constant, value: RBig) -> Self {
        Constant { value, of: self.of.max(other.of) }
    }

    /// Returns the exact value of a decimal number with its unit.
    fn of_number(&Number { value, times, per }: &Number) -> Option<Self> {
        let factor = |value: f64| match value {
            PI => Some((half_turn()?, Data::Pi)),
            TAU => Some((half_turn()? * RBig::from(2), Data::Pi)),
            other => Some((RBig::try_from(other).ok()?, Data::Decimals)),
        };
        let ((times, above), (per, below)) = (factor(times)?, factor(per)?);
        Some(Constant { value: Rational::decimal(value).to_big()? * times / per, of: above.max(below) })
    }
}

fn half_turn() -> Option<RBig> {
    HALF_TURN.into_iter().try_fold(RBig::ZERO, |sum, part| Some(sum + RBig::try_from(part).ok()?))
}

impl Elaborator<'_> {
    /// Returns the exact value of a node formed from constants; `None` for other nodes, and for undefined values.
    pub(super) fn constant_of(&self, scalar: &Scalar) -> Option<Constant> {
        let of = |id: &ScalarId| self.constants[id.0].as_ref();
        let both = |a: &ScalarId, b: &ScalarId| of(a).zip(of(b));
        match scalar {
            Scalar::Number(number) => Constant::of_number(number),
            Scalar::Pi => Some(Constant { value: half_turn()?, of: Data::Pi }),
            Scalar::Parameter(place) => {
                let value = RBig::try_from(self.model.parameters[*place].value?).ok()?;
                Some(Constant { value, of: Data::Parameters })
            }
            Scalar::Negation(a) => of(a).map(|a| Constant { value: -a.value.clone(), of: a.of }),
            Scalar::Sum(a, b) => both(a, b).map(|(a, b)| a.combined(b, &a.value + &b.value)),
            Scalar::Difference(a, b) => both(a, b).map(|(a, b)| a.combined(b, &a.value - &b.value)),
            Scalar::Product(a, b) => both(a, b).map(|(a, b)| a.combined(b, &a.value * &b.value)),
            Scalar::Quotient(a, b) => {
                let (a, b) = both(a, b).filter(|(_, b)| !b.value.is_zero())?;
                Some(a.combined(b, &a.value / &b.value))
            }
            Scalar::Power(a, Exponent { numerator, denominator: 1 }) => {
                let base = of(a).filter(|a| *numerator >= 0 || !a.value.is_zero())?;
                Some(Constant { value: base.value.pow(*numerator as isize), of: base.of })
            }
            _ => None,
        }
    }

    /// Adds a node. If the node is a constant longer than the limit, it is replaced by the nearest number in double precision.
    pub(super) fn bounded(
        &mut self,
        span: &Range<usize>,
        scalar: Scalar,
        dimension: Option<Dimension>,
    ) -> Sound<ScalarId> {
        let long = match scalar {
            // the square root of an integer power
            Scalar::Power(a, Exponent { numerator, denominator: 2 }) => {
                let square = Scalar::Power(a, Exponent { numerator, denominator: 1 });
                self.constant_of(&square).filter(|square| square.value >= RBig::ZERO && !square.is_short())
            }
            _ => self.constant_of(&scalar).filter(|constant| !constant.is_short()),
        };
        let Some(Constant { value, of }) = long else { return Ok(self.scalar(scalar, dimension)) };
        let is_root = matches!(scalar, Scalar::Power(_, Exponent { denominator: 2, .. }));
        if of == Data::Parameters {
            let accepted = "a parameter of its own for its value, or parameters with fewer digits";
            let title = "this constant of parameters has more digits than a run can hold";
            return Err(Box::new(Fault::at(span.clone(), title, "more than 3,000 digits", accepted)));
        }
        let nearest = value.to_f64().value();
        let nearest = if is_root { nearest.sqrt() } else { nearest };
        if !nearest.is_normal() {
            let title = if nearest == 0.0 || nearest.is_subnormal() { "too small" } else { "too large" };
            let label = format!("{title} for double precision");
            let accepted = "numbers between 1e-307 and 1e308, in SI units";
            return Err(Box::new(Fault::at(span.clone(), format!("this number is {title}"), label, accepted)));
        }
        Ok(self.scalar(Scalar::Number(Number { value: nearest, times: 1.0, per: 1.0 }), dimension))
    }
}
