//! The compiled functions of a search, of its unknowns and then of reactions.

use super::angle_sums::AngleSums;
use super::{NoSteadyMotions, Unknown};
use symbolic::{Sym, Tape, substitute_in_angles, with_sums_of_angles};

/// The largest order of a derivative.
const MOST_ORDER: usize = 8;

/// Longer expressions have no derivatives of such orders.
const MOST_OPERATIONS: usize = 2_000;

/// Equations as expressions.
#[derive(Clone)]
pub(super) struct Expressions {
    /// As many as are solved.
    pub values: Vec<Sym>,
    /// J^T, row after row, then -h.
    pub loads: Vec<Sym>,
    pub surplus: Vec<Sym>,
    pub implied: Vec<Sym>,
    pub sides: Vec<Sym>,
}

/// The equations as compiled functions.
#[derive(Debug)]
pub(super) struct Tapes {
    /// Residuals by unknowns, then multipliers.
    pub values: Tape,
    /// Derivatives of the side conditions by the unknowns, row after row.
    pub slopes: Tape,
    /// J^T, row after row, then -h, by unknowns alone.
    pub loads: Tape,
    /// Equations beyond the number of unknowns.
    pub surplus: Tape,
    /// Constraints that were left out, since they follow from others near the start: elsewhere they may not.
    pub implied: Tape,
    /// Conditions.
    pub sides: Tape,
    /// Derivatives of the side conditions by the unknowns, row after row.
    pub side_slopes: Tape,
    /// Conditions less their margins, which are further inputs.
    pub margins: Tape,
}

impl Expressions {
    /// The same by sums of angles, where these occur more simply.
    ///
    /// # Errors
    /// An expression without values.
    pub fn by_sums(
        &self,
        (letters, multipliers): (&[Sym], &[Sym]),
        unknowns: &[Unknown],
    ) -> Result<Option<(AngleSums, Tapes)>, NoSteadyMotions> {
        // one angle has no sums
        if unknowns.iter().filter(|unknown| unknown.is_circle).count() < 2 {
            return Ok(None);
        }
        let in_sums = self.rewritten(with_sums_of_angles);
        let sums = AngleSums::of(&in_sums.values, letters, unknowns);
        // written out, equations may be shorter without any sum
        let is_shorter = || Sym::operations_of(&in_sums.values) < Sym::operations_of(&self.values);
        let Some(sums) = sums.or_else(|| is_shorter().then(|| AngleSums::none(letters.len()))) else { return Ok(None) };
        let replacements = sums.replacements(letters);
        let own = in_sums.rewritten(|rows| substitute_in_angles(rows, &replacements));
        Ok(Some((sums, own.recorded(letters, multipliers)?)))
    }

    /// Each list rewritten.
    fn rewritten(&self, put: impl Fn(&[Sym]) -> Vec<Sym>) -> Self {
        Expressions {
            values: put(&self.values),
            loads: put(&self.loads),
            surplus: put(&self.surplus),
            implied: put(&self.implied),
            sides: put(&self.sides),
        }
    }

    /// By letters of unknowns, and of reactions.
    ///
    /// # Errors
    /// An expression without values.
    pub fn recorded(&self, letters: &[Sym], multipliers: &[Sym]) -> Result<Tapes, NoSteadyMotions> {
        let inputs = [letters, multipliers].concat();
        let slopes_of =
            |rows: &[Sym]| -> Vec<Sym> { rows.iter().flat_map(|row| inputs.iter().map(|&by| row.diff(by))).collect() };
        let margins: Vec<Sym> = (0..self.sides.len()).map(|k| Sym::symbol(&format!("margin of side {k}"))).collect();
        let beyond: Vec<Sym> = self.sides.iter().zip(&margins).map(|(side, margin)| *side - *margin).collect();
        Ok(Tapes {
            margins: recorded(&[&inputs[..], &margins].concat(), &beyond)?,
            values: recorded(&inputs, &self.values)?,
            slopes: recorded(&inputs, &slopes_of(&self.values))?,
            loads: recorded(letters, &self.loads)?,
            surplus: recorded(&inputs, &self.surplus)?,
            implied: recorded(&inputs, &self.implied)?,
            sides: recorded(&inputs, &self.sides)?,
            side_slopes: recorded(&inputs, &slopes_of(&self.sides))?,
        })
    }
}

/// A program of expressions.
///
/// # Errors
/// An expression without values.
pub(super) fn recorded(inputs: &[Sym], outputs: &[Sym]) -> Result<Tape, NoSteadyMotions> {
    Tape::record(inputs, outputs).map_err(|why| NoSteadyMotions::Undefined { why: why.to_string() })
}

/// The one equation of one unknown with its derivatives, up to the largest order of zeros that is tried.
pub(super) fn derivatives(letters: &[Sym], values: &[Sym]) -> Option<Tape> {
    let ([letter], [value]) = (letters, values) else { return None };
    let mut all = vec![*value];
    for _ in 0..MOST_ORDER {
        let next = all[all.len() - 1].diff(*letter);
        all.push(next);
        if Sym::operations_of(&all) > MOST_OPERATIONS {
            return None;
        }
    }
    Tape::record(letters, &all).ok()
}
