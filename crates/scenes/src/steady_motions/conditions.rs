//! Laws that change at conditions: each condition holds, fails, or is zero, and then its part of the law lies anywhere between both, as dry
//! friction does that sticks.
//!
//! Where a condition is zero at every rest, as the sign of a speed is, it is zero. Else all three are tried; where the law is the same on
//! both sides of the condition's zero, as of `abs`, that zero belongs to the sides.

use super::rows::Rows;
use super::{NoSteadyMotions, Range};
use model::equations::vanishes;
use model::{Model, Trace};
use symbolic::{Sym, substitute_all};

/// The case of a condition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Case {
    Holds,
    Fails,
    /// Its value is zero, and its part of the law lies between both.
    Between,
}

/// More combinations of cases are not tried.
const MOST: usize = 243;

/// The part of a law at a condition's zero, between that where it fails and that where it holds.
pub(super) const BETWEEN: Range = Range { from: 0.0, to: 1.0 };

/// All combinations of cases that are tried.
pub(super) fn combinations(rows: &Rows, at_rest: &[(Sym, Sym)]) -> Result<Vec<Vec<Case>>, NoSteadyMotions> {
    let values = substitute_all(&rows.conditions, at_rest);
    let mut all: Vec<Vec<Case>> = vec![Vec::new()];
    for (value, letter) in values.iter().zip(&rows.condition_letters) {
        let cases: &[Case] = match value.as_constant() {
            _ if vanishes(*value) => &[Case::Between],
            Some(number) if number.to_f64() > 0.0 => &[Case::Holds],
            Some(_) => &[Case::Fails],
            None if is_continuous(rows, *letter, *value) => &[Case::Holds, Case::Fails],
            None => &[Case::Holds, Case::Fails, Case::Between],
        };
        all = all.iter().flat_map(|own| cases.iter().map(move |case| [&own[..], &[*case]].concat())).collect();
        if all.len() > MOST {
            return Err(NoSteadyMotions::ManyConditions { conditions: rows.conditions.len(), most: MOST });
        }
    }
    Ok(all)
}

/// The conditions of a law as texts.
pub fn conditions_of(model: &Model) -> Vec<String> {
    let own = |trace: Trace<'_>| model.switches.iter().map(|&own| trace.scalar(own).to_string()).collect();
    symbolic::apart(|| own(Trace::of(model)))
}

/// Whether the law does not jump where a condition is zero: shown for conditions that are linear in a letter.
fn is_continuous(rows: &Rows, letter: Sym, value: Sym) -> bool {
    let jumps: Vec<Sym> = rows.residuals.iter().map(|row| row.diff(letter)).filter(|jump| !vanishes(*jump)).collect();
    value.symbols_of().into_iter().any(|own| {
        let slope = value.diff(own);
        if slope.symbols_of().contains(&own) || vanishes(slope) {
            return false;
        }
        let there = own - value / slope;
        jumps.iter().all(|jump| vanishes(jump.substitute(&[(own, there)])))
    })
}
