//! Conditions that stay at zero: the value between the two cases of each that keeps it there (Filippov 1988).
//!
//! Along the motion g' = a + b s with the switch s, which the law holds linearly: s = -a/b. Dry friction is such a law: while it
//! sticks, s takes the value of the force that is needed.

use super::Case;
use super::multiples::{Mirrored, letters as letters_of, mirrored as mirrored_in};
use crate::compiled_system::{Motion, NotCompiled};
use model::Trace;
use symbolic::{Derivation, Sym, substitute_all};

/// The accelerations with every switch replaced, and the values of the switches.
pub(crate) fn held(
    trace: &Trace<'_>,
    mode: &[Case],
    accelerations: Vec<Sym>,
    multipliers: Vec<Sym>,
) -> Result<Motion, NotCompiled> {
    let fixed = |case: &Case| match case {
        Case::On => Some(Sym::ONE),
        Case::Off => Some(Sym::ZERO),
        Case::Held => None,
    };
    let mirrored = mirrored_in(trace);
    let others = letters_of(trace, &mirrored);
    let is_own = |switch: &usize| mirrored[*switch].is_none();
    let own = || (0..mode.len()).filter(is_own);
    let known: Vec<(Sym, Sym)> =
        own().filter_map(|switch| Some((trace.switches[switch], fixed(&mode[switch])?))).collect();
    let in_mode = |all: &[Sym]| substitute_all(&substitute_all(all, &others), &known);
    let [accelerations, multipliers] = [accelerations, multipliers].map(|all| in_mode(&all));
    let motion: Vec<(Sym, Sym)> = trace.accelerations.iter().copied().zip(accelerations.iter().copied()).collect();
    let unknown: Vec<usize> = own().filter(|&switch| mode[switch] == Case::Held).collect();
    let symbols: Vec<Sym> = unknown.iter().map(|&k| trace.switches[k]).collect();
    let conditions: Vec<Sym> =
        unknown.iter().map(|&switch| in_mode(&[trace.scalar(trace.model.switches[switch])])[0]).collect();
    let rates: Vec<Sym> = conditions.iter().map(|&condition| trace.rate_of(condition).substitute(&motion)).collect();
    // an |g| in the law of g brings powers of the switch, which go where g is zero
    let at_zero = match is_linear(&rates, &symbols) {
        true => Vec::new(),
        false => zeros(trace, &conditions),
    };
    let [accelerations, multipliers] = [accelerations, multipliers].map(|all| substitute_all(&all, &at_zero));
    let rates = substitute_all(&rates, &at_zero);
    if !is_linear(&rates, &symbols) {
        return Err(NotCompiled::NotHeld { switch: unknown[0] });
    }
    // rows of b, and -a
    let (mut rows, mut right): (Vec<Vec<Sym>>, Vec<Sym>) = (Vec::new(), Vec::new());
    let none: Vec<(Sym, Sym)> = symbols.iter().map(|&letter| (letter, Sym::ZERO)).collect();
    for (rate, &switch) in rates.iter().zip(&unknown) {
        let slopes: Vec<Sym> = symbols.iter().map(|&letter| by(*rate, letter)).collect();
        if slopes.iter().all(|slope| *slope == Sym::ZERO) {
            return Err(NotCompiled::NotHeld { switch });
        }
        right.push(-rate.substitute(&none));
        rows.push(slopes);
    }
    let values = solved(rows, right).map_err(|row| NotCompiled::NotHeld { switch: unknown[row] })?;
    let found: Vec<(Sym, Sym)> = symbols.iter().copied().zip(values).collect();
    let value = |switch: usize| {
        let letter = trace.switches[switch];
        let solved = found.iter().find(|(symbol, _)| *symbol == letter).map_or(Sym::UNDEFINED, |(_, value)| *value);
        fixed(&mode[switch]).unwrap_or(solved)
    };
    let switches = mirrored.iter().enumerate().map(|(switch, mirrored)| match *mirrored {
        None => value(switch),
        Some(Mirrored { of, same_side: true }) => value(of),
        Some(Mirrored { of, same_side: false }) => Sym::ONE - value(of),
    });
    let [accelerations, multipliers] = [accelerations, multipliers].map(|all| substitute_all(&all, &found));
    Ok(Motion { switches: switches.collect(), accelerations, multipliers })
}

/// A partial derivative.
fn by(expression: Sym, letter: Sym) -> Sym {
    Derivation::new([(letter, Sym::ONE)]).of(expression)
}

/// Whether expressions are linear in letters together.
fn is_linear(expressions: &[Sym], letters: &[Sym]) -> bool {
    let mut slopes =
        expressions.iter().flat_map(|&expression| letters.iter().map(move |&letter| by(expression, letter)));
    slopes.all(|slope| letters.iter().all(|letter| !slope.symbols_of().contains(letter)))
}

/// For each condition g, where it has the form c u + d of a speed u with a number c, that u is -d/c where g is zero.
fn zeros(trace: &Trace<'_>, conditions: &[Sym]) -> Vec<(Sym, Sym)> {
    let mut known: Vec<(Sym, Sym)> = Vec::new();
    for condition in conditions {
        let condition = condition.substitute(&known);
        let solved = trace.speeds.iter().find_map(|&speed| {
            let slope = by(condition, speed);
            let is_number = slope != Sym::ZERO && slope.symbols_of().is_empty();
            is_number.then(|| (speed, -condition.substitute(&[(speed, Sym::ZERO)]) / slope))
        });
        if let Some((speed, value)) = solved {
            known.iter_mut().for_each(|(_, earlier)| *earlier = earlier.substitute(&[(speed, value)]));
            known.push((speed, value));
        }
    }
    known
}

/// Gauss's elimination in order; the first row without a pivot where there is one.
fn solved(mut rows: Vec<Vec<Sym>>, mut right: Vec<Sym>) -> Result<Vec<Sym>, usize> {
    let n = right.len();
    for pivot in 0..n {
        let Some(row) = (pivot..n).find(|&row| rows[row][pivot] != Sym::ZERO) else { return Err(pivot) };
        rows.swap(pivot, row);
        right.swap(pivot, row);
        for below in pivot + 1..n {
            let factor = rows[below][pivot] / rows[pivot][pivot];
            let (upper, lower) = rows.split_at_mut(below);
            for (entry, &above) in lower[0].iter_mut().zip(&upper[pivot]) {
                *entry -= factor * above;
            }
            let part = factor * right[pivot];
            right[below] -= part;
        }
    }
    for row in (0..n).rev() {
        let known = (row + 1..n).fold(right[row], |rest, column| rest - rows[row][column] * right[column]);
        right[row] = known / rows[row][row];
    }
    Ok(right)
}
