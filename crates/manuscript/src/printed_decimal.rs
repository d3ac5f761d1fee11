//! A printed decimal number, such as `-12.98` or `3.0\cdot 10^{-3}`, and the unit of its last digit.

use field::{Rational, Scalar};
use latex::{Form, Term};
use std::ops::Range;

/// The digits of a number, and its power of ten.
#[derive(Clone)]
pub(crate) struct PrintedDecimal {
    /// The range of the digits in the formula, including a sign before them.
    pub span: Range<usize>,
    /// The number of digits after the decimal point.
    pub decimals: usize,
    /// The exponent of the power of ten; zero if none is printed.
    pub exponent: i32,
    /// The range of the printed exponent in the formula, including its `^`; `None` without a power of ten.
    script: Option<Range<usize>>,
}

impl PrintedDecimal {
    /// The printed number; `None` if the term is another expression.
    pub fn of(term: &Term, formula: &str) -> Option<Self> {
        match &term.form {
            Form::Number(_) => {
                let digits = formula.get(term.span.clone())?.trim();
                let decimals = digits.split_once('.').map_or(0, |(_, part)| part.len());
                Some(PrintedDecimal { span: term.span.clone(), decimals, exponent: 0, script: None })
            }
            Form::Negation(of) => {
                let found = Self::of(of, formula)?;
                Some(PrintedDecimal { span: term.span.start..found.span.end, ..found })
            }
            Form::Product(of, power) | Form::Dot(of, power) | Form::Cross(of, power) => {
                let exponent = power_of_ten(power)?;
                let sign = formula.get(power.span.clone())?.find('^').unwrap_or(power.span.len());
                let script = Some(power.span.start + sign..power.span.end);
                let found = Self::of(of, formula).filter(|found| found.script.is_none())?;
                Some(PrintedDecimal { exponent, script, ..found })
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

    /// The range of the exponent, and the exponent with which the printed digits are those of a value up to the sign. `None`
    /// without a power of ten, or if the digits differ.
    pub fn power_for(&self, value: f64, formula: &str) -> Option<(Range<usize>, String)> {
        let script = self.script.clone()?;
        let printed: f64 = formula.get(self.span.clone())?.replace(char::is_whitespace, "").parse().ok()?;
        let apart = (value / printed).abs().log10() - f64::from(self.exponent);
        let exponent = apart.is_finite().then(|| self.exponent + apart.round() as i32)?;
        let right = PrintedDecimal { exponent, ..self.clone() };
        let is_right = right.digits(value.abs()) == self.with_decimals(printed.abs());
        let power = if exponent == 1 { String::new() } else { format!("^{{{exponent}}}") };
        (is_right && exponent != self.exponent).then_some((script, power))
    }

    /// A value with as many digits as are printed, without the power of ten.
    pub fn digits(&self, value: f64) -> String {
        self.with_decimals(value / 10f64.powi(self.exponent))
    }

    fn with_decimals(&self, value: f64) -> String {
        format!("{value:.*}", self.decimals)
    }
}

/// The exponent if a term is a power of ten.
fn power_of_ten(term: &Term) -> Option<i32> {
    let is_ten = |term: &Term| matches!(&term.form, Form::Number(base) if *base == Rational::int(10));
    match &term.form {
        Form::Power(base, exponent) if is_ten(base) => Some(*exponent),
        Form::Number(_) if is_ten(term) => Some(1),
        _ => None,
    }
}
