//! Compiled functions for a search, of the unknowns and then the reactions.

use super::angle_sums::AngleSums;
use super::{NoSteadyMotions, Unknown};
use symbolic::{Sym, Tape, substitute_in_angles, with_sums_of_angles};

/// Largest order of a derivative of the single equation.
const MOST_ORDER: usize = 8;

/// Largest number of operations for such derivatives; longer expressions have none.
const MOST_OPERATIONS: usize = 2_000;

/// The equations of a search as expressions.
#[derive(Clone)]
pub(super) struct Expressions {
    /// The equations that are solved, as many as unknowns and reactions.
    pub values: Vec<Sym>,
    /// J^T, row by row, then -h.
    pub loads: Vec<Sym>,
    pub surplus: Vec<Sym>,
    pub implied: Vec<Sym>,
    pub sides: Vec<Sym>,
}

/// The equations of a search as compiled functions.
#[derive(Debug)]
pub(super) struct Tapes {
    /// Residuals of the solved equations.
    pub values: Tape,
    /// Their derivatives by unknowns and reactions, row by row.
    pub slopes: Tape,
    /// J^T, row by row, then -h, as functions of the unknowns alone.
    pub loads: Tape,
    /// Residuals of surplus equations.
    pub surplus: Tape,
    /// Residuals of redundant constraints that were removed; away from the start they may not follow from the others.
    pub implied: Tape,
    /// Expressions with required signs.
    pub sides: Tape,
    /// Their derivatives by unknowns and reactions, row by row.
    pub side_slopes: Tape,
    /// The expressions with required signs minus margins; the margins are further inputs.
    pub margins: Tape,
}

impl Expressions {
    /// The equations in terms of sums of angles; `None` if they do not become simpler.
    ///
    /// # Errors
    /// An expression that cannot be evaluated.
    pub fn by_sums(
        &self,
        (letters, multipliers): (&[Sym], &[Sym]),
        unknowns: &[Unknown],
    ) -> Result<Option<(AngleSums, Tapes)>, NoSteadyMotions> {
        // a single angle has no sums
        if unknowns.iter().filter(|unknown| unknown.is_circle).count() < 2 {
            return Ok(None);
        }
        let in_sums = self.rewritten(with_sums_of_angles);
        let sums = AngleSums::of(&in_sums.values, letters, unknowns);
        // the expansion of sums of angles alone may shorten the equations
        let is_shorter = || Sym::operations_of(&in_sums.values) < Sym::operations_of(&self.values);
        let Some(sums) = sums.or_else(|| is_shorter().then(|| AngleSums::none(letters.len()))) else { return Ok(None) };
        let replacements = sums.replacements(letters);
        let own = in_sums.rewritten(|rows| substitute_in_angles(rows, &replacements));
        Ok(Some((sums, own.recorded(letters, multipliers)?)))
    }

    /// Applies `put` to each list of expressions.
    fn rewritten(&self, put: impl Fn(&[Sym]) -> Vec<Sym>) -> Self {
        Expressions {
            values: put(&self.values),
            loads: put(&self.loads),
            surplus: put(&self.surplus),
            implied: put(&self.implied),
            sides: put(&self.sides),
        }
    }

    /// Compiles the equations with the letters of unknowns, then of reactions.
    ///
    /// # Errors
    /// An expression that cannot be evaluated.
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

/// Compiles expressions.
///
/// # Errors
/// An expression that cannot be evaluated.
pub(super) fn recorded(inputs: &[Sym], outputs: &[Sym]) -> Result<Tape, NoSteadyMotions> {
    Tape::record(inputs, outputs).map_err(|why| NoSteadyMotions::Undefined { why: why.to_string() })
}

/// The single equation of a single unknown with its derivatives up to order `MOST_ORDER`; `None` for other systems and long expressions.
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
