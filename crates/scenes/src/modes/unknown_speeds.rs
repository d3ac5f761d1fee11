//! Linear equations over expressions for algebraic speeds, with hidden constraints.

use model::equations::vanishes;
use symbolic::{Derivation, Sym};

/// An equation, slopes times unknowns = right, after those before it have been taken from it.
struct Row {
    slopes: Vec<Sym>,
    right: Sym,
    /// Whether it is the rate of a hidden constraint.
    is_rate: bool,
}

/// Gauss's elimination over expressions: entries that are numbers are pivots first, since other entries may vanish.
pub(super) struct Elimination<'a> {
    unknowns: &'a [Sym],
    /// Row and column of each pivot, in their order.
    pivots: Vec<(usize, usize)>,
    rows: Vec<Row>,
}

impl<'a> Elimination<'a> {
    pub fn of(unknowns: &'a [Sym]) -> Self {
        Elimination { unknowns, pivots: Vec::new(), rows: Vec::new() }
    }

    /// The unknowns that take sums to zero; `rate` gives the rate of a hidden constraint. None where they are not determined, or the sums
    /// are not linear in them.
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

    /// A sum as an equation; none where it is not linear.
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

    /// Rows without a pivot.
    fn open(&self) -> Vec<usize> {
        (0..self.rows.len()).filter(|row| self.pivots.iter().all(|(own, _)| own != row)).collect()
    }

    /// The entry that becomes the next pivot: in the shortest row that has one.
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

    /// Takes a pivot's row from another one.
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
