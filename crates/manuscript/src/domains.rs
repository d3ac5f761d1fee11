//! The domain of a printed formula: nonnegative radicands, positive arguments of logarithms, nonzero divisors.

use crate::conditions::Hypothesis;
use crate::display::{Told, divisors};
use crate::extent::Demand;
use crate::letters::Letters;
use crate::motion::Motion;
use crate::real_signs;
use crate::signs::{Shown, shows};
use claims::Condition;
use latex::{Form, Function, Meaning, Statement, Term, Value, value};
use symbolic::{Hypotheses, Sym, decide, normal};

/// A part of a formula with the condition that it must satisfy.
struct Asked<'a> {
    part: &'a Term,
    sign: Sign,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Sign {
    NotZero,
    NotNegative,
    Positive,
    /// The cosine of the part must not vanish; [`Sign::Sine`]: its sine.
    Cosine,
    Sine,
}

/// The reason for which a part of a formula has no value along any motion: this divisor or argument vanishes.
pub(crate) enum NoValue {
    Divisor(Sym),
    Logarithm(Sym),
}

/// The conditions under which all parts of a formula have values.
///
/// # Errors
/// A divisor, or an argument of a logarithm, that vanishes along every motion.
pub(crate) fn domains(
    statement: &Statement,
    letters: &Letters<'_, '_>,
    motion: &Motion<'_, '_>,
    assumed: &[Hypothesis],
    conditions: &[Condition],
) -> Result<Vec<Demand>, NoValue> {
    let mut asked = Vec::new();
    for side in statement.chains.iter().flat_map(|chain| &chain.sides) {
        collect(side, &mut asked);
    }
    let mut all: Vec<Demand> = Vec::new();
    for Asked { part, sign } in asked {
        let (Ok(Value::Scalar(model)), Ok(Value::Scalar(own))) =
            (value(part, &letters.in_model()), value(part, &letters.in_paper()))
        else {
            continue;
        };
        let of = |angle: Sym| (letters.in_model().circle(angle), angle.circle_as_written());
        let (model, own) = match sign {
            Sign::Cosine => (of(model).0.0, of(own).1.cos),
            Sign::Sine => (of(model).0.1, of(own).1.sin),
            _ => (model, own),
        };
        let here = normal(motion.reduced(model), &Hypotheses::none()).map_or(model, |form| form.to_sym());
        if sign != Sign::NotNegative && decide(here, &motion.hypotheses).is_zero() {
            return Err(if sign == Sign::Positive { NoValue::Logarithm(model) } else { NoValue::Divisor(model) });
        }
        let told = |relation: &str, latex: &str| (format!("{own} {relation} 0"), format!("{} {latex} 0", own.latex()));
        let (is_shown, lines) = match sign {
            Sign::NotNegative => (is_positive(here, motion, conditions, false), vec![told(">=", r"\geq")]),
            Sign::Positive => (is_positive(here, motion, conditions, true), vec![told(">", ">")]),
            Sign::NotZero | Sign::Cosine | Sign::Sine => {
                let is_stated = conditions.contains(&Condition::NonZero(here));
                let apart = |e: Sym| is_positive(e, motion, conditions, true);
                // each factor of a product is a separate requirement
                (is_stated || apart(here) || apart(-here), divisors(&[model], Told(letters)))
            }
        };
        let condition = match sign {
            Sign::NotNegative => Condition::NotNegative(model),
            Sign::Positive => Condition::Positive(model),
            Sign::NotZero | Sign::Cosine | Sign::Sine => Condition::NonZero(model),
        };
        for line in lines {
            let is_stated = assumed.iter().any(|hypothesis| hypothesis.told == line);
            if all.iter().all(|known| known.told != line) {
                all.push(Demand { told: line, condition, is_shown: is_shown || is_stated });
            }
        }
    }
    Ok(all)
}

fn is_positive(expression: Sym, motion: &Motion<'_, '_>, conditions: &[Condition], is_strict: bool) -> bool {
    if let Some(sign) = expression.as_constant().and_then(|value| value.sign()) {
        return sign > 0 || sign == 0 && !is_strict;
    }
    let is_enough = |shown: Shown| shown.is_strict || !is_strict;
    shows(expression, motion, conditions).is_some_and(is_enough)
        || real_signs::shows(expression, conditions).is_some_and(is_enough)
}

/// Collects the parts of a formula on whose values the existence of its value depends.
fn collect<'a>(term: &'a Term, all: &mut Vec<Asked<'a>>) {
    let mut add = |part: &'a Term, sign: Sign| all.push(Asked { part, sign });
    match &term.form {
        Form::Quotient(_, below) => factors(below).into_iter().for_each(|factor| add(factor, Sign::NotZero)),
        Form::Power(base, exponent) if *exponent < 0 => add(base, Sign::NotZero),
        Form::Root(of) => add(of, Sign::NotNegative),
        Form::Function(Function::Ln, of) => add(of, Sign::Positive),
        Form::Function(Function::Tan | Function::Sec, of) => add(of, Sign::Cosine),
        Form::Function(Function::Cot | Function::Csc, of) => add(of, Sign::Sine),
        _ => {}
    }
    match &term.form {
        Form::Number(_) | Form::Letter(_) => {}
        Form::Rate(of, _)
        | Form::Negation(of)
        | Form::Power(of, _)
        | Form::Root(of)
        | Form::Function(_, of)
        | Form::Transposed(of) => collect(of, all),
        Form::Partial(a, b)
        | Form::Sum(a, b)
        | Form::Difference(a, b)
        | Form::Product(a, b)
        | Form::Dot(a, b)
        | Form::Cross(a, b)
        | Form::Quotient(a, b) => {
            collect(a, all);
            collect(b, all);
        }
        Form::Matrix(rows) => rows.iter().flatten().for_each(|entry| collect(entry, all)),
    }
}

/// The printed factors of a product.
fn factors(term: &Term) -> Vec<&Term> {
    match &term.form {
        Form::Product(a, b) | Form::Dot(a, b) => [factors(a), factors(b)].concat(),
        _ => vec![term],
    }
}
