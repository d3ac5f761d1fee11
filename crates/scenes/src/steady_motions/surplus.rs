//! Overdetermined equations: as many independent ones as unknowns are solved, and the others are tested at the solutions.

use super::search::independent;
use super::{Range, Unknown};
use symbolic::{Sym, Tape};

/// Points, as fractions of the ranges, at which independent equations are chosen; they avoid points of symmetry.
const ASIDE: [f64; 3] = [0.43, 0.71, 0.29];

/// The value of all reactions at these points.
const REACTION: f64 = 0.83;

/// A choice of equations to be solved; `surplus` are the others.
pub(super) struct Selection {
    pub solved: Vec<Sym>,
    pub surplus: Vec<Sym>,
}

impl Selection {
    /// Chooses as many equations as letters; `letters` are those of the unknowns, then of the reactions.
    pub fn of(equations: Vec<Sym>, letters: &[Sym], unknowns: &[Unknown]) -> Self {
        let wanted = letters.len();
        if equations.len() <= wanted {
            return Selection { solved: equations, surplus: Vec::new() };
        }
        let chosen = chosen(&equations, letters, unknowns).unwrap_or_else(|| (0..wanted).collect());
        let part = |is_chosen: bool| {
            let own = equations.iter().enumerate().filter(|(row, _)| chosen.contains(row) == is_chosen);
            own.map(|(_, row)| *row).collect()
        };
        Selection { solved: part(true), surplus: part(false) }
    }
}

/// The indices of equations that are independent at a point of the ranges.
fn chosen(equations: &[Sym], letters: &[Sym], unknowns: &[Unknown]) -> Option<Vec<usize>> {
    let slopes: Vec<Sym> = equations.iter().flat_map(|row| letters.iter().map(|&by| row.diff(by))).collect();
    let tape = Tape::record(letters, &slopes).ok()?;
    ASIDE.into_iter().find_map(|aside| {
        let place = |(k, Range { from, to }): (usize, Range)| from + (aside + 0.01 * k as f64) * (to - from);
        let mut at: Vec<f64> = unknowns.iter().map(|unknown| unknown.range).enumerate().map(place).collect();
        at.resize(letters.len(), REACTION);
        let mut values = vec![0.0; slopes.len()];
        tape.over::<f64>().evaluate(&at, &mut values);
        let is_finite = values.iter().all(|value| value.is_finite());
        is_finite.then(|| independent(equations.len(), letters.len(), |row, by| values[row * letters.len() + by]))?
    })
}
