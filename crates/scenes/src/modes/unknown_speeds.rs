//! Symbolic solution of linear equations for algebraic speeds (speeds that no inertia governs), by Gaussian elimination.
//! An equation without unknowns is a hidden constraint; its time derivative takes its place.

use model::equations::vanishes;
use symbolic::{Derivation, Sym};

/// The linear equation `slopes` . unknowns = `right` after elimination by all earlier pivots.
struct Row {
    slopes: Vec<Sym>,
    right: Sym,
    /// Whether the equation is the time derivative of a hidden constraint.
    is_rate: bool,
}

/// State of the Gaussian elimination. Numbers are preferred as pivots, since other expressions may become zero.
pub(super) struct Elimination<'a> {
    unknowns: &'a [Sym],
    /// Row and column of each pivot, in the order of elimination.
    pivots: Vec<(usize, usize)>,
    rows: Vec<Row>,
}

impl<'a> Elimination<'a> {
    pub fn of(unknowns: &'a [Sym]) -> Self {
        Elimination { unknowns, pivots: Vec::new(), rows: Vec::new() }
    }

    /// Solves `zeros` = 0 for the unknowns; `rate` returns the time derivative of a hidden constraint. `None` where the equations do not
    /// determine all unknowns, or are not linear in them.
    pub fn solved(mut self, zeros: &[Sym], rate: impl Fn(Sym) -> Option<Sym>) -> Option<Vec<Sym>> {
        for zero in zeros {
            let row = self.row(*zero, false)?;
            self.rows.push(row);
        }
        while self.pivots.len() < self.unknowns.len() {
            if let Some((row, column)) = self.pivot() {
                self.pivots.push((row, column));
                for below in self.open() {
                    self.reduce(below, (row, column));
                }
                continue;
            }
            let hidden = self.open();
            if hidden.iter().any(|&row| self.rows[row].is_rate) {
                return None;
            }
            for place in hidden {
                self.rows[place] = self.row(rate(-self.rows[place].right)?, true)?;
                for pivot in self.pivots.clone() {
                    self.reduce(place, pivot);
                }
            }
        }
        let mut values = vec![Sym::ZERO; self.unknowns.len()];
        for &(row, column) in self.pivots.iter().rev() {
            let Row { slopes, right, .. } = &self.rows[row];
            let others = slopes.iter().zip(&values).enumerate().filter(|(place, _)| *place != column);
            let rest = others.fold(*right, |rest, (_, (slope, value))| rest - *slope * *value);
            values[column] = rest / slopes[column];
        }
        Some(values)
    }

    /// The equation `zero` = 0 as a row; `None` where it is not linear in the unknowns.
    fn row(&self, zero: Sym, is_rate: bool) -> Option<Row> {
        let slopes: Vec<Sym> =
            self.unknowns.iter().map(|&letter| Derivation::new([(letter, Sym::ONE)]).of(zero)).collect();
        let bends = |slope: &Sym| slope.symbols_of().iter().any(|letter| self.unknowns.contains(letter));
        if slopes.iter().any(bends) {
            return None;
        }
        let none: Vec<(Sym, Sym)> = self.unknowns.iter().map(|&letter| (letter, Sym::ZERO)).collect();
        Some(Row { slopes, right: -zero.substitute(&none), is_rate })
    }

    /// Indices of the rows without a pivot.
    fn open(&self) -> Vec<usize> {
        (0..self.rows.len()).filter(|row| self.pivots.iter().all(|(own, _)| own != row)).collect()
    }

    /// The next pivot (row, column): an entry of the row with fewest entries, a number if there is one.
    fn pivot(&self) -> Option<(usize, usize)> {
        let length = |row: usize| self.rows[row].slopes.iter().filter(|slope| **slope != Sym::ZERO).count();
        let mut open = self.open();
        open.sort_by_key(|&row| length(row));
        let is_free = |column: usize| self.pivots.iter().all(|(_, own)| *own != column);
        let entries: Vec<(usize, usize)> = open
            .into_iter()
            .flat_map(|row| (0..self.unknowns.len()).map(move |column| (row, column)))
            .filter(|&(row, column)| is_free(column) && self.rows[row].slopes[column] != Sym::ZERO)
            .collect();
        let slope = |(row, column): (usize, usize)| self.rows[row].slopes[column];
        let number = entries.iter().copied().find(|&entry| slope(entry).as_constant().is_some());
        number.or_else(|| entries.iter().copied().find(|&entry| !vanishes(slope(entry))))
    }

    /// Eliminates the unknown of a pivot's column from row `place`.
    fn reduce(&mut self, place: usize, (pivot, column): (usize, usize)) {
        let factor = self.rows[place].slopes[column] / self.rows[pivot].slopes[column];
        if factor == Sym::ZERO {
            return;
        }
        let slopes = self.rows[pivot].slopes.clone();
        let right = self.rows[pivot].right;
        let own = &mut self.rows[place];
        own.slopes.iter_mut().zip(slopes).for_each(|(entry, above)| *entry -= factor * above);
        own.slopes[column] = Sym::ZERO;
        own.right -= factor * right;
    }
}
