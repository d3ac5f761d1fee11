//! A printed decimal number, such as `-12.98` or `3.0\cdot 10^{-3}`, with the unit of its last digit.

use field::{Rational, Scalar};
use latex::{Form, Term};
use std::ops::Range;

/// The digits of a number, and the power of ten beside them.
pub(crate) struct PrintedDecimal {
    /// The digits in the formula, with a sign before them.
    pub span: Range<usize>,
    /// The number of digits after the point.
    pub decimals: usize,
    /// The exponent of the power of ten; zero without one.
    pub exponent: i32,
}

impl PrintedDecimal {
    /// None if the term is another expression.
    pub fn of(term: &Term, formula: &str) -> Option<Self> {
        match &term.form {
            Form::Number(_) => {
                let digits = formula.get(term.span.clone())?.trim();
                let decimals = digits.split_once('.').map_or(0, |(_, part)| part.len());
                Some(PrintedDecimal { span: term.span.clone(), decimals, exponent: 0 })
            }
            Form::Negation(of) => {
                let found = Self::of(of, formula)?;
                Some(PrintedDecimal { span: term.span.start..found.span.end, ..found })
            }
            Form::Product(of, power) | Form::Dot(of, power) | Form::Cross(of, power) => {
                let exponent = power_of_ten(power)?;
                Self::of(of, formula)
                    .filter(|found| found.exponent == 0)
                    .map(|found| PrintedDecimal { exponent, ..found })
            }
            _ => None,
        }
    }

    /// Half a unit of the last digit.
    pub fn half_unit(&self) -> Rational {
        let places = i64::from(self.exponent) - self.decimals as i64;
        let (half, ten) = (Rational::new(1, 2), Rational::int(10));
        (0..places.unsigned_abs()).fold(half, |unit, _| if places < 0 { unit / ten } else { unit * ten })
    }

    /// A value with as many digits as are printed, without the power of ten.
    pub fn digits(&self, value: f64) -> String {
        format!("{:.*}", self.decimals, value / 10f64.powi(self.exponent))
    }
}

/// The exponent of a power of ten.
fn power_of_ten(term: &Term) -> Option<i32> {
    let is_ten = |term: &Term| matches!(&term.form, Form::Number(base) if *base == Rational::int(10));
    match &term.form {
        Form::Power(base, exponent) if is_ten(base) => Some(*exponent),
        Form::Number(_) if is_ten(term) => Some(1),
        _ => None,
    }
}
