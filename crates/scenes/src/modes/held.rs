//! Symbolic motion in a mode with conditions held at zero: each switch has the value between its two cases for which the condition
//! remains at zero (Filippov 1988).
//!
//! The law is linear in the switch s, and along the motion g' = a + b s; hence s = -a/b. Dry friction is an example: during sticking, s
//! follows the required force.

use super::algebraic::{Parted, Settled};
use super::contacts::{Closed, PARTS, closed, letters as reactions_of};
use super::mode::{Case, Mode};
use super::motion::ModeMotion;
use super::multiples::{Mirrored, letters as letters_of, mirrored as mirrored_in};
use crate::compiled_system::NotCompiled;
use model::Trace;
use symbolic::{Derivation, Sym, substitute_all};

/// The motion in a mode, with all switches and reactions replaced by expressions.
///
/// # Errors
/// A held condition or a contact has no pivot, or the law is not linear in a held switch.
pub(crate) fn held(trace: &Trace<'_>, mode: &Mode, parted: Parted) -> Result<ModeMotion, NotCompiled> {
    let Settled { values: settled, implicit, switches: found_switches } = parted.settled(trace, mode)?;
    let Parted { accelerations, multipliers, mut is_direct, letters, .. } = parted;
    found_switches.into_iter().for_each(|switch| is_direct.conditions[switch] = true);
    let [accelerations, multipliers] = [accelerations, multipliers].map(|all| substitute_all(&all, &settled));
    let speeds = accelerations.len();
    let (Closed { found: of_contacts, determinant }, mut accelerations) = match mode.phases.is_empty() {
        true => (Closed { found: Vec::new(), determinant: Sym::ONE }, [accelerations, multipliers].concat()),
        false => closed(trace, mode, (&settled, &is_direct.contacts), &accelerations, &multipliers)?,
    };
    let multipliers = accelerations.split_off(speeds);
    let of_contacts =
        |all: &[Sym]| of_contacts.iter().fold(substitute_all(all, &settled), |all, found| substitute_all(&all, found));
    let reactions = of_contacts(&reactions_of(trace));
    let settled = settled_with(&settled, of_contacts);
    let mode = &mode.cases;
    let mirrored = mirrored_in(trace);
    let others = letters_of(trace, &mirrored);
    let own = || (0..mode.len()).filter(|&switch| mirrored[switch].is_none() && !is_direct.conditions[switch]);
    let of = |wanted: fn(Case) -> bool| -> Vec<usize> { own().filter(|&switch| wanted(mode[switch])).collect() };
    let letter = |switch: &usize| trace.switches[*switch];
    let fixed = |switch: usize| mode[switch].fixed().map(|on| if on { Sym::ONE } else { Sym::ZERO });
    let known: Vec<(Sym, Sym)> =
        own().filter(|&switch| !mode[switch].rests()).filter_map(|k| Some((letter(&k), fixed(k)?))).collect();
    let in_mode = |all: &[Sym]| substitute_all(&substitute_all(&substitute_all(all, &others), &settled), &known);
    let [accelerations, multipliers] = [accelerations, multipliers].map(|all| in_mode(&all));
    let motion: Vec<(Sym, Sym)> = trace.accelerations.iter().copied().zip(accelerations.iter().copied()).collect();
    let resting = of(Case::rests);
    let held = of(|case| case == Case::Held);
    let shared = of(|case| case == Case::Shared);
    let free = of(|case| case.fixed().is_none());
    let symbols: Vec<Sym> = resting.iter().map(letter).collect();
    let condition = |switch: &usize| in_mode(&[trace.scalar(trace.model.switches[*switch])])[0];
    let rates: Vec<Sym> = held.iter().map(|k| trace.rate_of(condition(k)).substitute(&motion)).collect();
    let rates = substitute_all(&rates, &settled);
    // |g| in the law of g causes powers of the switch, which vanish at g = 0
    let at_zero = match is_linear(&rates, &symbols) {
        true => Vec::new(),
        false => zeros(trace, &resting.iter().map(condition).collect::<Vec<Sym>>()),
    };
    let [accelerations, multipliers] = [accelerations, multipliers].map(|all| substitute_all(&all, &at_zero));
    let rates = substitute_all(&rates, &at_zero);
    if !is_linear(&rates, &symbols) {
        return Err(NotCompiled::NotHeld { switch: held[0] });
    }
    let slopes = |row: usize, of: &[usize]| of.iter().map(|k| by(rates[row], letter(k))).collect::<Vec<Sym>>();
    // matrix b and right side -a, with 1/2 for each shared switch
    let (mut rows, mut right): (Vec<Vec<Sym>>, Vec<Sym>) = (Vec::new(), Vec::new());
    let half = Sym::ONE / (Sym::ONE + Sym::ONE);
    let bounds = own().filter_map(|switch| Some((letter(&switch), fixed(switch)?)));
    let given: Vec<(Sym, Sym)> = bounds.chain(shared.iter().map(|k| (letter(k), half))).collect();
    let none: Vec<(Sym, Sym)> = held.iter().map(|k| (letter(k), Sym::ZERO)).collect();
    for (row, &switch) in held.iter().enumerate() {
        let slopes = slopes(row, &held);
        if slopes.iter().all(|slope| *slope == Sym::ZERO) {
            return Err(NotCompiled::NotHeld { switch });
        }
        right.push(-rates[row].substitute(&given).substitute(&none));
        rows.push(slopes);
    }
    let values = solved(rows, right).map_err(|row| NotCompiled::NotHeld { switch: held[row] })?;
    let found: Vec<(Sym, Sym)> = held.iter().map(letter).zip(values.iter().copied()).chain(given).collect();
    let in_found = |all: &[Sym]| substitute_all(all, &found);
    let mut parts: Vec<Sym> = in_found(&trace.switches);
    if free.len() < resting.len() || !shared.is_empty() {
        // s = 1/2 + B^T l: of all solutions the nearest to 1/2
        let columns: Vec<Vec<Sym>> = (0..held.len()).map(|row| slopes(row, &free)).collect();
        let product = |a: &[Sym], b: &[Sym]| a.iter().zip(b).fold(Sym::ZERO, |sum, (a, b)| sum + *a * *b);
        let gram = columns.iter().map(|a| columns.iter().map(|b| product(a, b)).collect()).collect();
        let away: Vec<Sym> = free.iter().map(|&k| parts[k] - half).collect();
        let needed = columns.iter().map(|row| product(row, &away)).collect();
        let factors = solved(gram, needed).map_err(|row| NotCompiled::NotHeld { switch: held[row] })?;
        for &switch in &resting {
            let column: Vec<Sym> = (0..held.len()).map(|row| by(rates[row], letter(&switch))).collect();
            parts[switch] = half + product(&column, &factors);
        }
    }
    let mut switches: Vec<Sym> = (0..mode.len()).map(|k| fixed(k).unwrap_or(parts[k])).collect();
    let of_own: Vec<(Sym, Sym)> = own().map(|switch| (letter(&switch), switches[switch])).collect();
    for switch in (0..mode.len()).filter(|&switch| mirrored[switch].is_none() && is_direct.conditions[switch]) {
        let value = letter(&switch).substitute(&settled).substitute(&of_own);
        (switches[switch], parts[switch]) = (value, value);
    }
    for (own, mirrored) in mirrored.iter().enumerate() {
        if let Some(Mirrored { of, same_side }) = *mirrored {
            let own_of = |all: &[Sym]| if same_side { all[of] } else { Sym::ONE - all[of] };
            (switches[own], parts[own]) = (own_of(&switches), own_of(&parts));
        }
    }
    let (mut accelerations, multipliers) = (in_found(&accelerations), substitute_all(&multipliers, &of_own));
    let reactions = substitute_all(&reactions, &of_own).as_chunks::<PARTS>().0.to_vec();
    let own_speeds = letters.into_iter().filter(|letter| trace.speeds.contains(letter));
    let speeds: Vec<(Sym, Sym)> =
        own_speeds.map(|letter| (letter, letter.substitute(&settled).substitute(&of_own))).collect();
    let motion: Vec<(Sym, Sym)> = trace.accelerations.iter().copied().zip(accelerations.iter().copied()).collect();
    let implicit_speeds: Vec<Sym> = implicit.iter().map(|(letter, _)| *letter).collect();
    let speeds: Vec<(Sym, Sym)> = speeds.into_iter().filter(|(letter, _)| !implicit_speeds.contains(letter)).collect();
    let mut rates: Vec<(Sym, Sym)> = speeds
        .iter()
        .map(|&(letter, is)| (letter, trace.rate_of(is).substitute(&motion).substitute(&speeds)))
        .collect();
    let zeros: Vec<Sym> = implicit.iter().map(|(_, zero)| zero.substitute(&of_own)).collect();
    rates.extend(implicit_speeds.iter().copied().zip(implicit_rates(trace, &implicit_speeds, &zeros, &motion)?));
    for (letter, rate) in rates {
        let place = trace.speeds.iter().position(|speed| *speed == letter);
        place.into_iter().for_each(|place| accelerations[place] = rate);
    }
    let implicit = implicit_speeds.into_iter().zip(zeros).collect();
    Ok(ModeMotion { switches, parts, accelerations, multipliers, reactions, determinant, speeds, implicit })
}

/// The rates of implicit speeds, from the time derivatives of their equations `zeros`, which are expressions equal to zero.
fn implicit_rates(
    trace: &Trace<'_>,
    speeds: &[Sym],
    zeros: &[Sym],
    motion: &[(Sym, Sym)],
) -> Result<Vec<Sym>, NotCompiled> {
    let own: Vec<Sym> = speeds
        .iter()
        .filter_map(|speed| trace.speeds.iter().position(|known| known == speed))
        .map(|place| trace.accelerations[place])
        .collect();
    let rests: Vec<(Sym, Sym)> = own.iter().map(|&letter| (letter, Sym::ZERO)).collect();
    let others: Vec<(Sym, Sym)> = motion.iter().copied().filter(|(letter, _)| !own.contains(letter)).collect();
    let rows = zeros.iter().map(|&zero| speeds.iter().map(|&speed| by(zero, speed)).collect()).collect();
    let right = zeros.iter().map(|&zero| -trace.rate_of(zero).substitute(&rests).substitute(&others)).collect();
    let first = || trace.speeds.iter().position(|known| speeds.first() == Some(known)).unwrap_or_default();
    solved(rows, right)
        .map_err(|_| NotCompiled::Massless { coordinate: crate::compiled_system::speed_name(trace.model, first()) })
}

/// Symbols with their values, with the reactions of contacts inserted.
fn settled_with(settled: &[(Sym, Sym)], reactions: impl Fn(&[Sym]) -> Vec<Sym>) -> Vec<(Sym, Sym)> {
    let (letters, values): (Vec<Sym>, Vec<Sym>) = settled.iter().copied().unzip();
    letters.into_iter().zip(reactions(&values)).collect()
}

/// The partial derivative of an expression by a symbol.
fn by(expression: Sym, letter: Sym) -> Sym {
    Derivation::new([(letter, Sym::ONE)]).of(expression)
}

/// True if expressions are jointly linear in symbols.
pub(super) fn is_linear(expressions: &[Sym], letters: &[Sym]) -> bool {
    let mut slopes =
        expressions.iter().flat_map(|&expression| letters.iter().map(move |&letter| by(expression, letter)));
    slopes.all(|slope| letters.iter().all(|letter| !slope.symbols_of().contains(letter)))
}

/// For each condition g = c u + d with a speed u and a constant c: the substitution u = -d/c, which holds at g = 0.
fn zeros(trace: &Trace<'_>, conditions: &[Sym]) -> Vec<(Sym, Sym)> {
    let mut known: Vec<(Sym, Sym)> = Vec::new();
    for condition in conditions {
        let condition = condition.substitute(&known);
        let solved = trace.speeds.iter().find_map(|&speed| {
            let slope = by(condition, speed);
            let data = |name: &str| trace.model.parameters.iter().find(|one| one.name == name)?.value;
            let is_number = slope.evaluate_analytic(&data).is_ok_and(|value: f64| value.is_finite() && value != 0.0);
            is_number.then(|| (speed, -condition.substitute(&[(speed, Sym::ZERO)]) / slope))
        });
        if let Some((speed, value)) = solved {
            known.iter_mut().for_each(|(_, earlier)| *earlier = earlier.substitute(&[(speed, value)]));
            known.push((speed, value));
        }
    }
    known
}

/// The solution of linear equations, or the index of the first column without a pivot.
fn solved(rows: Vec<Vec<Sym>>, right: Vec<Sym>) -> Result<Vec<Sym>, usize> {
    eliminated(rows, right).map(|(values, _)| values)
}

/// The solution of linear equations by Gaussian elimination with the first nonzero pivot of each column, and the determinant; or the
/// index of the first column without a pivot.
pub(crate) fn eliminated(mut rows: Vec<Vec<Sym>>, mut right: Vec<Sym>) -> Result<(Vec<Sym>, Sym), usize> {
    let (n, mut determinant) = (right.len(), Sym::ONE);
    for pivot in 0..n {
        let Some(row) = (pivot..n).find(|&row| rows[row][pivot] != Sym::ZERO) else { return Err(pivot) };
        rows.swap(pivot, row);
        right.swap(pivot, row);
        determinant *= if row == pivot { rows[pivot][pivot] } else { -rows[pivot][pivot] };
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
    Ok((right, determinant))
}
