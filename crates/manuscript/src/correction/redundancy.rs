//! Parts of a formula that state nothing: terms that vanish, cancel or are alike, factors that cancel, divisors equal to one.

use super::exchanges::gcd;
use latex::{Chain, Form, Statement, Term};
use symbolic::{Hypotheses, Sym, decide, normal};

/// The number of such parts in all sides; `meaning` returns the value of a term.
pub(super) fn redundancies(statement: &Statement, meaning: &dyn Fn(&Term) -> Option<Sym>) -> usize {
    statement.chains.iter().flat_map(|chain| &chain.sides).map(|side| within(side, meaning)).sum()
}

/// The number of terms on one side of an equality that are numerical multiples of a term on its other side; `own` returns a term in printed letters.
pub(super) fn on_both_sides(statement: &Statement, own: &dyn Fn(&Term) -> Option<Sym>) -> usize {
    let [Chain { sides, .. }] = &statement.chains[..] else { return 0 };
    let [left, right] = &sides[..] else { return 0 };
    let values = |side: &Term| summands(side).into_iter().filter_map(|(_, term)| own(term)).collect::<Vec<Sym>>();
    let (left, right) = (values(left), values(right));
    // an equality of two single terms has no redundant part
    if left.len() == 1 && right.len() == 1 {
        return 0;
    }
    left.iter().map(|one| right.iter().filter(|other| are_alike(*one, **other)).count()).sum()
}

/// The number of variable letters that are a factor of both sides of an equality; where such a letter is zero, the equality states nothing.
pub(super) fn common_factors(
    statement: &Statement,
    own: &dyn Fn(&Term) -> Option<Sym>,
    moves: &dyn Fn(Sym) -> bool,
) -> usize {
    let [Chain { sides, .. }] = &statement.chains[..] else { return 0 };
    let values: Option<Vec<Sym>> = sides.iter().map(own).collect();
    let values: Vec<Sym> = values.unwrap_or_default().into_iter().filter(|value| !is_zero(*value)).collect();
    let [first, others @ ..] = &values[..] else { return 0 };
    let divides = |leaf: Sym, side: Sym| {
        let rest = normal(side / leaf, &Hypotheses::none());
        rest.is_ok_and(|rest| !rest.denominator().leaves_of().contains(&leaf))
    };
    let is_common = |leaf: &Sym| divides(*leaf, *first) && others.iter().all(|side| divides(*leaf, *side));
    let leaves = first.leaves_of().into_iter().filter(|leaf| leaf.as_constant().is_none() && moves(*leaf));
    if others.is_empty() { 0 } else { leaves.filter(is_common).count() }
}

/// The number of factors of products that vanish on the motion or are equal to one.
pub(super) fn vanishing_factors(statement: &Statement, vanishes: &dyn Fn(&Term) -> bool) -> usize {
    statement.chains.iter().flat_map(|chain| &chain.sides).map(|side| vanishing_in(side, vanishes)).sum()
}

fn vanishing_in(term: &Term, vanishes: &dyn Fn(&Term) -> bool) -> usize {
    let inner = |parts: &[&Term]| parts.iter().map(|part| vanishing_in(part, vanishes)).sum::<usize>();
    let of_product = |parts: &[&Term]| {
        let is_product = |part: &&&Term| matches!(part.form, Form::Product(..) | Form::Dot(..) | Form::Quotient(..));
        parts.iter().filter(|part| !is_product(part) && (is_one(part) || vanishes(part))).count() + inner(parts)
    };
    match &term.form {
        Form::Number(_) | Form::Letter(_) | Form::Rate(..) | Form::Matrix(_) => 0,
        Form::Sum(a, b) | Form::Difference(a, b) | Form::Cross(a, b) | Form::Partial(a, b) => inner(&[a, b]),
        Form::Product(a, b) | Form::Dot(a, b) => of_product(&[a, b]),
        // the numerator 1 is necessary
        Form::Quotient(above, below) if is_one(above) => inner(&[below]),
        Form::Quotient(above, below) => of_product(&[above]) + inner(&[below]),
        Form::Negation(of) | Form::Power(of, _) | Form::Root(of) | Form::Function(_, of) | Form::Transposed(of) => {
            inner(&[of])
        }
    }
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
            vanishing + pairs(&values, are_alike) + inner(&parts)
        }
        Form::Product(..) | Form::Dot(..) => cancelling(term, own) + inner(&factors(term)),
        Form::Quotient(above, below) => {
            let products = [above, below].map(|side| factors(side));
            // both products are compared with each other here, and must not be compared again below
            cancelling(term, own) + usize::from(is_one(below)) + inner(&products.concat())
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

/// Whether two terms are nonzero numerical multiples of each other.
pub(super) fn are_alike(one: Sym, other: Sym) -> bool {
    let is_number =
        |value: Sym| normal(value, &Hypotheses::none()).is_ok_and(|form| form.to_sym().as_constant().is_some());
    !is_zero(one) && !is_zero(other) && is_number(one / other)
}

fn is_zero(value: Sym) -> bool {
    decide(value, &Hypotheses::none()).is_zero()
}

/// The number of factors that a product has in its numerator and in its denominator.
fn cancelling(product: &Term, own: &dyn Fn(&Term) -> Option<Sym>) -> usize {
    let (mut above, mut below) = (Vec::new(), Vec::new());
    collect(product, [&mut above, &mut below], own);
    let (numbers, above): (Vec<Sym>, Vec<Sym>) = above.into_iter().partition(|value| value.as_constant().is_some());
    let (divisors, below): (Vec<Sym>, Vec<Sym>) = below.into_iter().partition(|value| value.as_constant().is_some());
    let both = above.iter().filter(|value| below.iter().any(|other| is_zero(**value - *other))).count();
    both + usize::from(is_cancelled(&numbers, &divisors))
}

/// Whether integers in the numerator and the denominator have a common divisor.
fn is_cancelled(above: &[Sym], below: &[Sym]) -> bool {
    let whole = |value: &Sym| value.to_string().parse::<i64>().ok();
    let product = |all: &[Sym]| all.iter().try_fold(1_i64, |product, value| product.checked_mul(whole(value)?));
    match (product(above), product(below)) {
        (Some(above), Some(below)) => gcd(above.abs(), below.abs()) > 1,
        _ => false,
    }
}

/// The bases of the factors in the numerators and denominators of a product, including numbers.
fn collect(product: &Term, [above, below]: [&mut Vec<Sym>; 2], own: &dyn Fn(&Term) -> Option<Sym>) {
    match &product.form {
        Form::Product(a, b) | Form::Dot(a, b) => {
            collect(a, [above, below], own);
            collect(b, [above, below], own);
        }
        Form::Quotient(a, b) => {
            collect(a, [above, below], own);
            collect(b, [below, above], own);
        }
        Form::Negation(of) => collect(of, [above, below], own),
        Form::Power(of, exponent) if *exponent < 0 => collect(of, [below, above], own),
        Form::Power(of, _) => collect(of, [above, below], own),
        _ => above.extend(own(product)),
    }
}

/// Whether a term is the number one.
fn is_one(term: &Term) -> bool {
    matches!(&term.form, Form::Number(value) if *value == field::Rational::new(1, 1))
}

/// The terms of a sum, each with whether it is subtracted.
pub(super) fn summands(sum: &Term) -> Vec<(bool, &Term)> {
    match &sum.form {
        Form::Sum(a, b) => [summands(a), summands(b)].concat(),
        Form::Difference(a, b) => [summands(a), turned(b)].concat(),
        Form::Negation(of) => turned(of),
        _ => vec![(false, sum)],
    }
}

/// The terms of a subtracted sum.
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
