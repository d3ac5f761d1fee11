//! An elimination order for a sparse matrix with small fill-in (Markowitz 1957).
//!
//! Pivots on the diagonal come first: in equations of motion these are masses. A diagonal pivot created by fill-in is
//! accepted only when all original entries of its row are eliminated: for a multiplier it is then -J M^-1 J^T, which is
//! nonzero for independent constraints. If no diagonal pivot is left, any entry may be a pivot: a coordinate without
//! inertia is determined by the constraint that contains it.

/// The pivots in order, and the entries eliminated by each.
#[derive(Clone, Debug, PartialEq, Default)]
pub(super) struct Order {
    /// The row and the column at each position of the order.
    pub rows: Vec<usize>,
    pub columns: Vec<usize>,
    /// The position of each row and each column in the order.
    pub row_places: Vec<usize>,
    pub column_places: Vec<usize>,
    pub steps: Vec<Step>,
}

/// The rows and columns, by position, that change in the elimination with a pivot.
#[derive(Clone, Debug, PartialEq, Default)]
pub(super) struct Step {
    /// The rows with an entry below the pivot.
    pub below: Vec<usize>,
    /// The columns with an entry to the right of the pivot, as ranges.
    pub across: Vec<(usize, usize)>,
}

/// A matrix of bits.
struct Bits {
    words: usize,
    bits: Vec<u64>,
}

impl Bits {
    fn new(size: usize) -> Self {
        let words = size.div_ceil(64);
        Bits { words, bits: vec![0; words * size] }
    }

    fn set(&mut self, row: usize, column: usize) {
        self.bits[row * self.words + column / 64] |= 1 << (column % 64);
    }

    fn clear(&mut self, row: usize, column: usize) {
        self.bits[row * self.words + column / 64] &= !(1 << (column % 64));
    }

    fn has(&self, row: usize, column: usize) -> bool {
        self.bits[row * self.words + column / 64] >> (column % 64) & 1 == 1
    }

    fn row(&self, row: usize) -> &[u64] {
        &self.bits[row * self.words..][..self.words]
    }

    fn count(&self, row: usize) -> usize {
        self.row(row).iter().map(|word| word.count_ones() as usize).sum()
    }

    fn empty(&mut self, row: usize) {
        self.bits[row * self.words..][..self.words].fill(0);
    }

    /// Adds the bits of one row to another.
    fn join(&mut self, into: usize, from: usize) {
        for word in 0..self.words {
            self.bits[into * self.words + word] |= self.bits[from * self.words + word];
        }
    }

    fn columns(&self, row: usize) -> impl Iterator<Item = usize> + '_ {
        self.row(row).iter().enumerate().flat_map(|(place, &word)| {
            let mut rest = word;
            std::iter::from_fn(move || {
                let bit = (rest != 0).then(|| rest.trailing_zeros() as usize)?;
                rest &= rest - 1;
                Some(place * 64 + bit)
            })
        })
    }
}

impl Order {
    pub fn of(size: usize, places: &[(usize, usize)]) -> Self {
        // the entries, by rows and by columns
        let (mut across, mut down) = (Bits::new(size), Bits::new(size));
        for &(row, column) in places {
            across.set(row, column);
            down.set(column, row);
        }
        // the numbers of original entries not eliminated yet
        let mut own: Vec<usize> = (0..size).map(|row| across.count(row)).collect();
        let given: Vec<bool> = (0..size).map(|place| across.has(place, place)).collect();
        let neighbours: Vec<Vec<usize>> = (0..size).map(|column| down.columns(column).collect()).collect();
        let mut order = Order::default();
        let mut pairs: Vec<(Vec<usize>, Vec<usize>)> = Vec::new();
        let (mut rows_left, mut columns_left) = (vec![true; size], vec![true; size]);
        for _ in 0..size {
            let cost = |row: usize, column: usize| (across.count(row) - 1) * (down.count(column) - 1);
            let on_diagonal = (0..size).filter(|&k| {
                let trusted = given[k] || own[k] == 0;
                rows_left[k] && columns_left[k] && across.has(k, k) && trusted
            });
            let (row, column) = on_diagonal.map(|k| (k, k)).min_by_key(|&(k, _)| cost(k, k)).unwrap_or_else(|| {
                let left = (0..size).filter(|&row| rows_left[row]);
                let any = left.flat_map(|row| across.columns(row).map(move |column| (row, column)));
                let first = |left: &[bool]| left.iter().position(|left| *left).unwrap_or(0);
                // a position without an entry is no pivot
                any.min_by_key(|&(row, column)| cost(row, column))
                    .unwrap_or_else(|| (first(&rows_left), first(&columns_left)))
            });
            (rows_left[row], columns_left[column]) = (false, false);
            for &row in &neighbours[column] {
                own[row] -= 1;
            }
            let below: Vec<usize> = down.columns(column).filter(|&other| other != row).collect();
            let beside: Vec<usize> = across.columns(row).filter(|&other| other != column).collect();
            across.clear(row, column);
            for &other in &below {
                across.clear(other, column);
                across.join(other, row);
            }
            down.clear(column, row);
            for &other in &beside {
                down.clear(other, row);
                down.join(other, column);
            }
            across.empty(row);
            down.empty(column);
            order.rows.push(row);
            order.columns.push(column);
            pairs.push((below, beside));
        }
        order.finish(pairs)
    }

    fn finish(mut self, pairs: Vec<(Vec<usize>, Vec<usize>)>) -> Self {
        let places = |order: &[usize]| {
            let mut places = vec![0; order.len()];
            order.iter().enumerate().for_each(|(place, &each)| places[each] = place);
            places
        };
        (self.row_places, self.column_places) = (places(&self.rows), places(&self.columns));
        let step = |(below, beside): (Vec<usize>, Vec<usize>)| {
            let mut below: Vec<usize> = below.into_iter().map(|row| self.row_places[row]).collect();
            let mut beside: Vec<usize> = beside.into_iter().map(|column| self.column_places[column]).collect();
            below.sort_unstable();
            beside.sort_unstable();
            let mut across: Vec<(usize, usize)> = Vec::new();
            for column in beside {
                match across.last_mut() {
                    Some((_, end)) if *end == column => *end += 1,
                    _ => across.push((column, column + 1)),
                }
            }
            Step { below, across }
        };
        self.steps = pairs.into_iter().map(step).collect();
        self
    }

    pub fn work(&self) -> usize {
        let across = |step: &Step| step.across.iter().map(|(from, to)| to - from).sum::<usize>();
        self.steps.iter().map(|step| step.below.len() * (1 + across(step))).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::Order;

    #[test]
    fn an_arrow_is_eliminated_from_its_tips() {
        // the first unknown occurs in every equation
        let places: Vec<(usize, usize)> = (0..6).flat_map(|k| [(k, k), (0, k), (k, 0)]).collect();
        let order = Order::of(6, &places);
        assert!(!order.rows[..4].contains(&0), "{:?}", order.rows);
        assert_eq!(order.work(), 5 * 2);
    }

    #[test]
    fn a_multiplier_waits_for_all_that_it_holds() {
        // two masses with one common constraint
        let order = Order::of(3, &[(0, 0), (1, 1), (0, 2), (2, 0), (1, 2), (2, 1)]);
        assert_eq!(order.rows, [0, 1, 2]);
    }

    #[test]
    fn a_coordinate_without_inertia_takes_the_equation_that_moves_it() {
        // the first unknown has no mass
        let order = Order::of(3, &[(1, 1), (0, 2), (2, 0), (1, 2), (2, 1)]);
        assert_eq!((order.rows, order.columns), (vec![1, 0, 2], vec![1, 2, 0]));
    }
}
