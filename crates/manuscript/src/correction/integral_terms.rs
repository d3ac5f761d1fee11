//! Terms that a printed integral of motion lacks, compared with the integrals of the model.

use super::lost::{SOUGHT, Sought, sought};
use crate::integrals::is_constant;
use crate::letters::Letters;
use latex::{Form, Statement, Term, Value, value};
use symbolic::{Hypotheses, Sym, normal};

/// The values of the letter of the unknown term for which an expression is a multiple of an integral of the model: of its energy, or of the momentum of a cyclic
/// coordinate.
pub(super) fn integral_terms(statement: &Statement, letters: &Letters<'_, '_>) -> Vec<Sym> {
    let meaning = Sought(letters);
    let sides = statement.chains.iter().flat_map(|chain| &chain.sides).filter(|side| !is_constant(side));
    let values: Option<Vec<Sym>> = sides
        .map(|side| match value(side, &meaning) {
            Ok(Value::Scalar(value)) => Some(value),
            _ => None,
        })
        .collect();
    let Some([is]) = values.as_deref() else { return Vec::new() };
    terms_beside(*is, letters)
}

/// The values of the sought letter in an expression whose rate is printed, with which it is a multiple of the energy or of a momentum.
pub(super) fn terms_below_rates(statement: &Statement, letters: &Letters<'_, '_>) -> Vec<Sym> {
    let mut sides = statement.chains.iter().flat_map(|chain| &chain.sides);
    let Some(below) = sides.find_map(rated) else { return Vec::new() };
    match value(below, &Sought(letters)) {
        Ok(Value::Scalar(is)) => terms_beside(is, letters),
        _ => Vec::new(),
    }
}

/// The expression whose rate is printed and in which the sought letter stands.
fn rated(term: &Term) -> Option<&Term> {
    match &term.form {
        Form::Rate(of, 1) => holds_sought(of).then_some(of),
        Form::Sum(a, b) | Form::Difference(a, b) | Form::Product(a, b) | Form::Dot(a, b) | Form::Quotient(a, b) => {
            rated(a).or_else(|| rated(b))
        }
        Form::Negation(of) => rated(of),
        _ => None,
    }
}

fn holds_sought(term: &Term) -> bool {
    match &term.form {
        Form::Number(_) | Form::Matrix(_) => false,
        Form::Letter(name) => name == SOUGHT,
        Form::Sum(a, b)
        | Form::Difference(a, b)
        | Form::Product(a, b)
        | Form::Dot(a, b)
        | Form::Cross(a, b)
        | Form::Quotient(a, b)
        | Form::Partial(a, b) => holds_sought(a) || holds_sought(b),
        Form::Rate(of, _) | Form::Power(of, _) | Form::Function(_, of) => holds_sought(of),
        Form::Negation(of) | Form::Root(of) | Form::Transposed(of) => holds_sought(of),
    }
}

/// The values of the sought letter with which an expression is a multiple of the energy or of a momentum.
fn terms_beside(is: Sym, letters: &Letters<'_, '_>) -> Vec<Sym> {
    let trace = letters.trace;
    let plain = is.substitute(&[(sought(), Sym::ZERO)]);
    let slope = is.diff(sought());
    if slope == Sym::ZERO || slope.symbols_of().contains(&sought()) {
        return Vec::new();
    }
    let kinetic = trace.kinetic_and_coenergy();
    let momentum = |place: usize| trace.by_speed(kinetic, place);
    let moving = (0..trace.speeds.len()).fold(Sym::ZERO, |sum, place| sum + momentum(place) * trace.speeds[place]);
    let integrals =
        [moving - kinetic + trace.potential_energy()].into_iter().chain((0..trace.speeds.len()).map(momentum));
    let factor = |integral: Sym| {
        let by_speeds = trace.speeds.iter().map(|&speed| (plain.diff(speed), integral.diff(speed)));
        let both = by_speeds.filter(|(own, other)| *own != Sym::ZERO && *other != Sym::ZERO);
        let ratios =
            both.filter_map(|(own, other)| normal(own / other, &Hypotheses::none()).ok().map(|form| form.to_sym()));
        let is_plain = |ratio: &Sym| ratio.symbols_of().iter().all(|symbol| trace.parameters.contains(symbol));
        [Sym::ONE].into_iter().chain(ratios.filter(is_plain)).collect::<Vec<_>>()
    };
    let lacking = integrals.flat_map(|integral| factor(integral).into_iter().map(move |factor| factor * integral));
    let told = lacking.filter_map(|whole| {
        let form = normal((whole - plain) / slope, &Hypotheses::none()).ok()?;
        normal(letters.told(form.to_sym()), &Hypotheses::none()).ok().map(|form| form.to_sym())
    });
    told.collect()
}
