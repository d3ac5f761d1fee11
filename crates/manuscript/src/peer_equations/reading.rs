//! Parser for texts of another program's equations, in the symbols of a model.
//!
//! The language is that of models without units, which the other program does not have.

use crate::letters::circle;
use field::{Analytic, Elementary, Rational, Scalar as _};
use model::expression::{Exponent, Form, Part, read};
use std::collections::HashMap;
use symbolic::{Sym, parse};

/// Names with the expressions that they denote.
#[derive(Clone)]
pub(super) struct Vocabulary {
    known: HashMap<String, Sym>,
    pi: Sym,
}

impl Vocabulary {
    pub fn new(time: Sym, pi: Sym) -> Self {
        Vocabulary { known: HashMap::from([("t".to_owned(), time), ("pi".to_owned(), pi)]), pi }
    }

    pub fn add(&mut self, name: &str, value: Sym) {
        self.known.insert(name.to_owned(), value);
    }

    pub fn get(&self, name: &str) -> Option<Sym> {
        self.known.get(name).copied()
    }

    /// Parses an expression.
    ///
    /// # Errors
    /// The text is not an expression, or contains unknown names.
    pub fn read(&self, text: &str) -> Result<Sym, String> {
        let expression = read(text).map_err(|fault| format!("`{}`: {}", shortened(text), fault.reason))?;
        let mut values: Vec<Sym> = Vec::with_capacity(expression.parts.len());
        for part in &expression.parts {
            let value = self.value(part, &values)?;
            values.push(value);
        }
        Ok(values[expression.whole()])
    }

    fn value(&self, form: &Form, values: &[Sym]) -> Result<Sym, String> {
        let of = |part: &Part| values[*part];
        Ok(match form {
            Form::Number(text) => parse(text, &|_| None).map_err(|fault| format!("`{text}`: {fault}"))?,
            Form::Name(name) => self.get(name).ok_or_else(|| format!("`{name}` is not known"))?,
            Form::Negation(a) => -of(a),
            Form::Sum(a, b) => of(a) + of(b),
            Form::Difference(a, b) => of(a) - of(b),
            Form::Product(a, b) => of(a) * of(b),
            Form::Quotient(a, b) => of(a) / of(b),
            Form::Power(a, exponent) => power(of(a), *exponent)?,
            Form::Call { function, arguments } => {
                let arguments: Vec<Sym> = arguments.iter().map(|argument| of(&argument.value)).collect();
                self.called(function, &arguments)?
            }
            Form::Quantity { .. } | Form::Member { .. } | Form::Dot(..) | Form::Comparison(..) => {
                return Err("units, vectors and comparisons are not compared".to_owned());
            }
        })
    }

    fn called(&self, function: &str, arguments: &[Sym]) -> Result<Sym, String> {
        let leg = |a: Sym| (Sym::ONE - a * a).sqrt();
        let exp = |a: Sym| a.elementary(Elementary::Exp, a);
        let angle = |y: Sym, x: Sym| y.elementary(Elementary::Atan2, x);
        Ok(match (function, arguments) {
            ("cos", &[a]) => circle(a, self.pi).0,
            ("sin", &[a]) => circle(a, self.pi).1,
            ("tan", &[a]) => circle(a, self.pi).1 / circle(a, self.pi).0,
            ("sqrt", &[a]) => a.sqrt(),
            ("exp", &[a]) => exp(a),
            ("ln" | "log", &[a]) => a.elementary(Elementary::Ln, a),
            ("tanh", &[a]) => a.elementary(Elementary::Tanh, a),
            ("sinh", &[a]) => (exp(a) - exp(-a)) / Sym::int(2),
            ("cosh", &[a]) => (exp(a) + exp(-a)) / Sym::int(2),
            ("atan", &[a]) => angle(a, Sym::ONE),
            ("asin", &[a]) => angle(a, leg(a)),
            ("acos", &[a]) => angle(leg(a), a),
            ("atan2", &[y, x]) => angle(y, x),
            _ => {
                return Err(format!(
                    "`{function}` is not compared; accepted are sqrt, cos, sin, tan, exp, ln, sinh, cosh, tanh, asin, acos, atan and atan2"
                ));
            }
        })
    }
}

/// A power with a rational exponent; a denominator that is a power of two gives nested square roots.
fn power(base: Sym, Exponent { numerator, denominator }: Exponent) -> Result<Sym, String> {
    let (mut root, mut left) = (base, denominator);
    while left > 1 && left % 2 == 0 {
        (root, left) = (root.sqrt(), left / 2);
    }
    match left {
        1 => Ok(root.powi(numerator)),
        _ => Err(format!(
            "the exponent {} is not compared; whole numbers and halves are",
            Rational::new(numerator.into(), denominator.into())
        )),
    }
}

fn shortened(text: &str) -> String {
    let beginning: String = text.chars().take(60).collect();
    if beginning.len() < text.len() { format!("{beginning} ...") } else { beginning }
}
