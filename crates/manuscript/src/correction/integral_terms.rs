//! Terms that a printed integral of motion lacks, compared with the integrals of the model.

use super::lost::{Sought, sought};
use crate::integrals::is_constant;
use crate::letters::Letters;
use latex::{Statement, Value, value};
use symbolic::{Hypotheses, Sym, normal};

/// The values of the letter of the unknown term for which an expression is a multiple of an integral of the model: of its energy, or of the momentum of a cyclic
/// coordinate.
pub(super) fn integral_terms(statement: &Statement, letters: &Letters<'_, '_>) -> Vec<Sym> {
    let trace = letters.trace;
    let meaning = Sought(letters);
    let sides = statement.chains.iter().flat_map(|chain| &chain.sides).filter(|side| !is_constant(side));
    let values: Option<Vec<Sym>> = sides
        .map(|side| match value(side, &meaning) {
            Ok(Value::Scalar(value)) => Some(value),
            _ => None,
        })
        .collect();
    let Some([is]) = values.as_deref() else { return Vec::new() };
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
