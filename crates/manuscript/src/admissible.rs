//! Counterexamples with parameters that bodies and circuits have: positive masses, moments of inertia, lengths, stiffnesses, resistances.

use crate::motion::Motion;
use crate::refutation::{Refutation, sign};
use claims::Condition;
use symbolic::{Dimension, Sym};

/// The parameters of a model that a counterexample should have positive.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Parameters {
    All,
    /// Those that are positive by what they are.
    Positive,
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

/// A counterexample with positive parameters where `again` finds one within more conditions, else the one that was found.
pub(crate) fn admissible(
    found: Refutation,
    motion: &Motion<'_, '_>,
    conditions: &[Condition],
    again: impl Fn(&[Condition]) -> Option<Refutation>,
) -> Refutation {
    for parameters in [Parameters::All, Parameters::Positive] {
        let valued = valued(&found, motion, parameters);
        if valued.iter().all(|(_, sign)| *sign > 0) {
            return found;
        }
        let positive = valued.into_iter().map(|(parameter, _)| Condition::Positive(motion.reduced(parameter)));
        let within: Vec<Condition> = conditions.iter().copied().chain(positive).collect();
        if let Some(better) = again(&within) {
            return better;
        }
    }
    found
}

/// The parameters that are positive by what they are, and are not at a counterexample.
pub(crate) fn unusual(found: &Refutation, motion: &Motion<'_, '_>) -> Vec<Sym> {
    let all = valued(found, motion, Parameters::Positive).into_iter();
    // a hypothesis may give a parameter its value
    let is_free = |parameter: &Sym| motion.reduced(*parameter).as_constant().is_none();
    all.filter(|(_, sign)| *sign <= 0).map(|(parameter, _)| parameter).filter(is_free).collect()
}

/// The parameters that have a value at a point, with its sign.
fn valued(found: &Refutation, motion: &Motion<'_, '_>, parameters: Parameters) -> Vec<(Sym, i32)> {
    let is_positive = |dimension: Dimension| POSITIVE.iter().any(|&[kg, m, s, a]| dimension == Dimension::of(kg, m, s, a));
    let chosen = motion.trace.model.parameters.iter().filter(|parameter| match parameters {
        Parameters::All => true,
        Parameters::Positive => is_positive(parameter.dimension),
    });
    let with_sign = |symbol: Sym| {
        let own = found.point.iter().find(|(known, _)| *known == symbol).map(|(_, value)| *value);
        let value = own.or_else(|| found.value(motion.reduced(symbol)))?;
        Some((symbol, sign(value)?))
    };
    chosen.filter_map(|parameter| with_sign(Sym::symbol(&parameter.name))).collect()
}
