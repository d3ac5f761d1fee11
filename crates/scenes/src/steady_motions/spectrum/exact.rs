//! Routh's criterion in exact arithmetic, at a motion whose values are decimals and at which all derivatives are rational.

use super::reduction::{Layout, Pivot, Reduced, solved, whole};
use crate::linearisation::{AllSlopes, VariedEquations};
use field::{Rational, Scalar};
use mechanics::linear_stability::{HalfPlanes, characteristic};
use model::Model;
use symbolic::Sym;

/// Largest number of speeds; fractions of larger systems have too many digits.
pub(super) const MOST_SPEEDS: usize = 8;

/// Exact numbers of eigenvalues left of, on and right of the imaginary axis, without zeros; and of zeros.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Routh {
    /// The number of eigenvalues with negative real parts.
    pub left: usize,
    /// The number of imaginary eigenvalues other than zero.
    pub axis: usize,
    /// The number of eigenvalues with positive real parts.
    pub right: usize,
    /// The number of zero eigenvalues without a known reason.
    pub unexplained: usize,
}

/// The exact counts at a state, with the cases of conditions, if `reasons` zero eigenvalues of the reduced equations have known reasons. `None` if a
/// number is irrational, or the state is not exactly a steady motion.
pub(super) fn routh(
    model: &Model,
    with_numbers: &VariedEquations,
    layout: &Layout,
    (state, switches): (&[f64], &[f64]),
    reasons: usize,
) -> Option<Routh> {
    if model.speeds() > MOST_SPEEDS || !are_fractions(with_numbers, (state, switches)) {
        return None;
    }
    let all: Vec<usize> = (0..model.parameters.len()).collect();
    let varied = VariedEquations::with_inputs(model, &all, &[]).ok()?;
    let data = model.parameters.iter().map(|parameter| Some(Rational::decimal(parameter.value?)));
    let data: Vec<Rational> = data.collect::<Option<_>>()?;
    let one = Rational::int(1);
    let exactly = |point: &[Rational]| {
        symbolic::apart(|| {
            let cases = switches.iter().map(|value| Rational::exactly(*value));
            let numbers: Vec<Sym> = point.iter().chain(&data).copied().chain(cases).map(Sym::constant).collect();
            varied
                .over(&numbers, Sym::ZERO)
                .through(|value: Sym| value.as_constant().filter(|value| value.is_defined()))
        })
    };
    let at = at_motion(&varied, layout, state, &one, exactly)?;
    let reduced = Reduced::of(&at, layout, &one)?;
    let mut coefficients = characteristic(&reduced.matrix, &one);
    let size = coefficients.len();
    while coefficients.last().is_some_and(|last| last.sign() == Some(0)) {
        coefficients.pop();
    }
    let unexplained = (size - coefficients.len()).checked_sub(reasons)?;
    counted(coefficients, unexplained)
}

/// Whether all derivatives at zero accelerations are rational; a sine of a number is not.
fn are_fractions(varied: &VariedEquations, (state, switches): (&[f64], &[f64])) -> bool {
    let [n, m, ..] = varied.counts();
    symbolic::apart(|| {
        let numbers = state.iter().map(|value| Sym::constant(Rational::exactly(*value)));
        let cases = switches.iter().map(|value| Sym::constant(Rational::exactly(*value)));
        let numbers: Vec<Sym> = numbers.chain(std::iter::repeat_n(Sym::ZERO, n + m)).chain(cases).collect();
        varied.over(&numbers, Sym::ZERO).through(|value: Sym| value.as_constant()).is_some()
    })
}

/// The counts by Routh's criterion for a polynomial without zero roots.
pub(super) fn counted(coefficients: Vec<Rational>, unexplained: usize) -> Option<Routh> {
    let HalfPlanes { left, axis, right, .. } = HalfPlanes::of(&coefficients)?;
    Some(Routh { left, axis, right, unexplained })
}

/// The derivatives of the equations at the motion, with exact speeds, accelerations and multipliers. `None` if the state is not a steady motion.
pub(super) fn at_motion<R: Pivot>(
    varied: &VariedEquations,
    layout: &Layout,
    state: &[f64],
    one: &R,
    exactly: impl Fn(&[R]) -> Option<AllSlopes<R>>,
) -> Option<AllSlopes<R>> {
    let [n, m, ..] = varied.counts();
    let zero = one.integer(0);
    let number = |value: &f64| one.fraction(Rational::decimal(*value));
    let mut point: Vec<R> = state.iter().map(number).collect::<Option<_>>()?;
    layout.cyclic.iter().for_each(|&k| point[k] = zero.clone());
    point.resize(2 * n + n + m, zero.clone());
    let negative = |value: &R| vec![zero.minus(value)];
    // corrects the dependent speeds so that constraints of speeds hold exactly
    let at = exactly(&point)?;
    let rows = &at.acceleration.by_accelerations[layout.positions..];
    let own = rows.iter().map(|row| layout.determined.iter().map(|&k| row[k].clone()).collect()).collect();
    let steps = solved(own, at.rate.values[layout.positions..].iter().map(negative).collect())?;
    layout.determined.iter().zip(steps).for_each(|(&k, step)| point[n + k] = point[n + k].plus(&step[0]));
    let at = exactly(&point)?;
    let right = at.motion.values.iter().chain(&at.acceleration.values).map(negative).collect();
    let found = solved(whole(&at, &zero), right)?;
    point[2 * n..].iter_mut().zip(found).for_each(|(own, found)| *own = found[0].clone());
    let is_zero = |value: &R| value.sign() == Some(0);
    let is_held = at.zero.values[..layout.positions].iter().chain(&at.rate.values).all(is_zero);
    let is_steady = (0..n).all(|k| {
        (layout.cyclic.contains(&k) || is_zero(&point[n + k]))
            && (layout.determined.contains(&k) || is_zero(&point[2 * n + k]))
    });
    if is_held && is_steady { exactly(&point) } else { None }
}
