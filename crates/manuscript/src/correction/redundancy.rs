//! Parts of a formula that say nothing: terms that cancel or vanish, factors that cancel, quotients of equals or by one.

use latex::{Form, Statement, Term};
use symbolic::{Hypotheses, Sym, decide};

/// The number of such parts, by the values of terms in the letters of the print.
pub(super) fn redundancies(statement: &Statement, own: &dyn Fn(&Term) -> Option<Sym>) -> usize {
    statement.chains.iter().flat_map(|chain| &chain.sides).map(|side| within(side, own)).sum()
}

fn within(term: &Term, own: &dyn Fn(&Term) -> Option<Sym>) -> usize {
    let inner = |parts: &[&Term]| parts.iter().map(|part| within(part, own)).sum::<usize>();
    match &term.form {
        Form::Number(_) | Form::Letter(_) => 0,
        Form::Sum(..) | Form::Difference(..) | Form::Negation(_) => {
            let parts = summands(term);
            let values: Vec<Sym> = parts
                .iter()
                .filter_map(|(is_negative, part)| own(part).map(|value| if *is_negative { -value } else { value }))
                .collect();
            let vanishing = values.iter().filter(|value| parts.len() > 1 && is_zero(**value)).count();
            let parts: Vec<&Term> = parts.into_iter().map(|(_, part)| part).collect();
            vanishing + pairs(&values, |a, b| !is_zero(a) && is_zero(a + b)) + inner(&parts)
        }
        Form::Product(..) | Form::Dot(..) => {
            let factors = factors(term);
            let values: Vec<Sym> = factors.iter().filter_map(|factor| own(factor)).filter(is_open).collect();
            pairs(&values, |a, b| is_zero(a * b - Sym::ONE)) + inner(&factors)
        }
        Form::Quotient(above, below) => {
            let values = |term: &Term| factors(term).into_iter().filter_map(own).collect::<Vec<Sym>>();
            let (over, under) = (values(above), values(below));
            let both = over.iter().filter(|a| is_open(a) && under.iter().any(|b| is_zero(**a - *b))).count();
            both + usize::from(is_reducible(above, below)) + inner(&[above, below])
        }
        Form::Rate(of, _) | Form::Power(of, _) | Form::Root(of) | Form::Function(_, of) | Form::Transposed(of) => {
            within(of, own)
        }
        Form::Partial(a, b) | Form::Cross(a, b) => inner(&[a, b]),
        Form::Matrix(rows) => rows.iter().flatten().map(|entry| within(entry, own)).sum(),
    }
}

fn pairs(values: &[Sym], is_one: impl Fn(Sym, Sym) -> bool) -> usize {
    let behind = |place: usize| values[place + 1..].iter().filter(|other| is_one(values[place], **other)).count();
    (0..values.len()).map(behind).sum()
}

fn is_zero(value: Sym) -> bool {
    decide(value, &Hypotheses::none()).is_zero()
}

/// Whether a value is no number.
fn is_open(value: &Sym) -> bool {
    value.as_constant().is_none()
}

/// Whether a quotient is by one, or one of numbers that is not in lowest terms.
fn is_reducible(above: &Term, below: &Term) -> bool {
    let (Form::Number(above), Form::Number(below)) = (&above.form, &below.form) else {
        return matches!(&below.form, Form::Number(value) if *value == field::Rational::new(1, 1));
    };
    // a quotient in lowest terms is written with its own numbers
    (*above / *below).to_string() != format!("{above}/{below}")
}

/// The terms of a sum with their signs: whether each is subtracted.
pub(super) fn summands(sum: &Term) -> Vec<(bool, &Term)> {
    match &sum.form {
        Form::Sum(a, b) => [summands(a), summands(b)].concat(),
        Form::Difference(a, b) => [summands(a), turned(b)].concat(),
        Form::Negation(of) => turned(of),
        _ => vec![(false, sum)],
    }
}

/// The terms of a sum that is subtracted.
fn turned(sum: &Term) -> Vec<(bool, &Term)> {
    summands(sum).into_iter().map(|(is_negative, part)| (!is_negative, part)).collect()
}

/// The factors of a product.
fn factors(product: &Term) -> Vec<&Term> {
    match &product.form {
        Form::Product(a, b) | Form::Dot(a, b) => [factors(a), factors(b)].concat(),
        _ => vec![product],
    }
}
