//! Counterexamples in which parameters have physically possible values: positive masses, moments of inertia, lengths, stiffnesses, resistances.

use crate::motion::Motion;
use crate::refutation::{Refutation, sign};
use claims::Condition;
use model::Trace;
use symbolic::{Dimension, Sym};

/// The parameters that a counterexample should make positive; all others should differ from zero.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Wanted {
    /// All parameters.
    AllPositive,
    /// The parameters whose dimension is in [`POSITIVE`].
    BodiesPositive,
}

/// The dimensions of masses, moments of inertia, lengths, stiffnesses, dampings, resistances, inductances and capacitances, as exponents of kg, m, s, A.
const POSITIVE: [[i64; 4]; 8] = [
    [1, 0, 0, 0],
    [1, 2, 0, 0],
    [0, 1, 0, 0],
    [1, 0, -2, 0],
    [1, 0, -1, 0],
    [1, 2, -3, -2],
    [1, 2, -2, -2],
    [-1, -2, 4, 2],
];

/// Conditions that the parameters with a dimension in [`POSITIVE`] are positive.
pub(crate) fn positive_parameters(trace: &Trace<'_>) -> impl Iterator<Item = Condition> {
    let of_body = trace.model.parameters.iter().filter(|parameter| is_of_body(parameter.dimension));
    of_body.map(|parameter| Condition::Positive(Sym::symbol(&parameter.name)))
}

fn is_of_body(dimension: Dimension) -> bool {
    POSITIVE.iter().any(|&[kg, m, s, a]| dimension == Dimension::of(kg, m, s, a))
}

/// Whether a symbol is a parameter with the dimension of a mass, a moment of inertia or a length.
pub(crate) fn is_of_every_body(symbol: Sym, motion: &Motion<'_, '_>) -> bool {
    let is_own =
        |dimension: Dimension| POSITIVE[..3].iter().any(|&[kg, m, s, a]| dimension == Dimension::of(kg, m, s, a));
    let mut parameters = motion.trace.model.parameters.iter();
    parameters.any(|parameter| Sym::symbol(&parameter.name) == symbol && is_own(parameter.dimension))
}

/// A counterexample with positive parameters if `again` finds one under further conditions, otherwise the given one.
pub(crate) fn admissible(
    found: Refutation,
    motion: &Motion<'_, '_>,
    conditions: &[Condition],
    again: impl Fn(&[Condition]) -> Option<Refutation>,
) -> Refutation {
    let mut best = found;
    for wanted in [Wanted::AllPositive, Wanted::BodiesPositive] {
        let asked = asked(&best, motion, wanted);
        if asked.iter().all(|(_, holds)| *holds) {
            return best;
        }
        let all: Vec<Condition> = conditions.iter().copied().chain(asked.into_iter().map(|(one, _)| one)).collect();
        if let Some(better) = again(&all) {
            return better;
        }
    }
    // as many of the conditions as possible
    let mut kept = conditions.to_vec();
    for (condition, holds) in asked(&best, motion, Wanted::BodiesPositive) {
        let with = [&kept[..], &[condition]].concat();
        if let Some(better) = (!holds).then(|| again(&with)).flatten() {
            (kept, best) = (with, better);
        } else if holds {
            kept = with;
        }
    }
    best
}

/// Whether all parameters that have a value at a counterexample are positive there.
pub(crate) fn has_positive_parameters(found: &Refutation, motion: &Motion<'_, '_>) -> bool {
    valued(found, motion).iter().all(|parameter| parameter.sign > 0)
}

/// The conditions that the parameters should satisfy at a counterexample, each with whether it holds there.
fn asked(found: &Refutation, motion: &Motion<'_, '_>, wanted: Wanted) -> Vec<(Condition, bool)> {
    let all = valued(found, motion).into_iter().map(|parameter| {
        let here = motion.reduced(parameter.symbol);
        match parameter.is_of_body || wanted == Wanted::AllPositive {
            true => (Condition::Positive(here), parameter.sign > 0),
            false => (Condition::NonZero(here), parameter.sign != 0),
        }
    });
    all.collect()
}

/// The parameters of a counterexample with physically unusual values.
#[derive(Default)]
pub(crate) struct Unusual {
    /// Masses, lengths and similar parameters that are not positive.
    pub not_positive: Vec<Sym>,
    /// Other parameters that are zero.
    pub zero: Vec<Sym>,
}

/// The parameters with physically unusual values at a counterexample.
pub(crate) fn unusual(found: &Refutation, motion: &Motion<'_, '_>) -> Unusual {
    let mut all = Unusual::default();
    // parameters whose value a hypothesis prescribes are left out
    let is_free = |parameter: &Valued| motion.reduced(parameter.symbol).as_constant().is_none();
    for parameter in valued(found, motion).into_iter().filter(is_free) {
        match parameter.sign {
            ..=0 if parameter.is_of_body => all.not_positive.push(parameter.symbol),
            0 => all.zero.push(parameter.symbol),
            _ => {}
        }
    }
    all
}

/// A parameter with its sign at a counterexample.
struct Valued {
    symbol: Sym,
    /// -1, 0 or 1.
    sign: i32,
    /// Whether its dimension is in [`POSITIVE`].
    is_of_body: bool,
}

/// The parameters that have a value at a counterexample.
fn valued(found: &Refutation, motion: &Motion<'_, '_>) -> Vec<Valued> {
    let all = motion.trace.model.parameters.iter().filter_map(|parameter| {
        let symbol = Sym::symbol(&parameter.name);
        let own = found.point.iter().find(|(known, _)| *known == symbol).map(|(_, value)| *value);
        let value = own.or_else(|| found.value(motion.reduced(symbol)))?;
        Some(Valued { symbol, sign: sign(value)?, is_of_body: is_of_body(parameter.dimension) })
    });
    all.collect()
}
