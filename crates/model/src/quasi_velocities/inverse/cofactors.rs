//! The adjugate and the determinant of a block without division, by Laplace expansion with each minor computed once.

use super::Reading;
use rustc_hash::FxHashMap;
use symbolic::Sym;

/// Returns the adjugate by rows, and the determinant.
pub(super) fn of(block: &[Vec<Sym>], reading: &mut impl Reading) -> (Vec<Vec<Sym>>, Sym) {
    let k = block.len();
    let all: u64 = (1 << k) - 1;
    let mut minors = Minors { block, known: FxHashMap::default() };
    let adjugate: Vec<Vec<Sym>> = (0..k)
        .map(|column| {
            let cofactor = |row: usize| {
                let minor = minors.of(all & !(1 << row), all & !(1 << column), reading);
                if (row + column).is_multiple_of(2) { minor } else { -minor }
            };
            (0..k).map(cofactor).collect()
        })
        .collect();
    let determinant = minors.of(all, all, reading);
    (adjugate, determinant)
}

/// Minors of a block, by bit masks of their rows and columns.
struct Minors<'a> {
    block: &'a [Vec<Sym>],
    known: FxHashMap<(u64, u64), Sym>,
}

impl Minors<'_> {
    /// Returns a minor, expanded along its first row.
    fn of(&mut self, rows: u64, columns: u64, reading: &mut impl Reading) -> Sym {
        if rows == 0 {
            return Sym::ONE;
        }
        if let Some(&known) = self.known.get(&(rows, columns)) {
            return known;
        }
        let row = rows.trailing_zeros() as usize;
        let (mut sum, mut is_added) = (Sym::ZERO, true);
        for column in (0..self.block.len()).filter(|column| columns >> column & 1 == 1) {
            let entry = self.block[row][column];
            if entry != Sym::ZERO {
                let term = entry * self.of(rows & !(1 << row), columns & !(1 << column), reading);
                sum = if is_added { sum + term } else { sum - term };
            }
            is_added = !is_added;
        }
        let minor = reading.read(sum);
        self.known.insert((rows, columns), minor);
        minor
    }
}
