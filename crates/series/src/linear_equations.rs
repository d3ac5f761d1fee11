//! Taylor series of the unknowns of linear equations, order by order with one LU factorisation:
//!
//!   A_0 z_k = b_k - sum_(l = 1 ... k) A_l z_(k-l) .

use super::fused::{Fused, Task};
use super::pick::Pick;
use super::plan::{LinearEquations, Quantity};
use algebra::linear::{Factors, Magnitude, Pattern};
use field::{Batch, Scalar};

/// A matrix that is factorised once for all orders.
pub(super) trait Solver<S> {
    /// Factorises the matrix; if this fails, unknowns are NaN.
    fn factor(&mut self, entries: &[S]);

    /// Replaces the right-hand side by the unknowns.
    fn solve(&mut self, right: &mut [S]);
}

/// A factorisation, and whether it succeeded.
#[derive(Clone, Debug)]
pub(super) struct Checked<S> {
    factors: Factors<S>,
    are_there: bool,
}

impl<S: Magnitude> Checked<S> {
    pub fn new(pattern: &Pattern) -> Self {
        Checked { factors: Factors::new(pattern), are_there: false }
    }
}

impl<S: Magnitude> Solver<S> for Checked<S> {
    #[inline(always)]
    fn factor(&mut self, entries: &[S]) {
        self.are_there = self.factors.factor(entries).is_ok();
    }

    #[inline(always)]
    fn solve(&mut self, right: &mut [S]) {
        match self.are_there {
            true => self.factors.solve(right),
            false => right.fill(S::zero() / S::zero()),
        }
    }
}

/// A factorisation for each lane, with its own pivots: lanes are independent.
#[derive(Clone, Debug)]
pub(super) struct LaneEquations<const L: usize> {
    lanes: Vec<Checked<f64>>,
    /// Buffer for the numbers of one lane.
    entries: Vec<f64>,
    right: Vec<f64>,
}

impl<const L: usize> LaneEquations<L> {
    pub fn new(pattern: &Pattern) -> Self {
        let lanes = (0..L).map(|_| Checked::new(pattern)).collect();
        LaneEquations { lanes, entries: vec![0.0; pattern.places().len()], right: vec![0.0; pattern.size()] }
    }
}

impl<const L: usize> Solver<Batch<L>> for LaneEquations<L> {
    #[inline(always)]
    fn factor(&mut self, entries: &[Batch<L>]) {
        for (lane, checked) in self.lanes.iter_mut().enumerate() {
            self.entries.iter_mut().zip(entries).for_each(|(own, entry)| *own = entry.0[lane]);
            checked.factor(&self.entries);
        }
    }

    #[inline(always)]
    fn solve(&mut self, right: &mut [Batch<L>]) {
        for (lane, checked) in self.lanes.iter_mut().enumerate() {
            self.right.iter_mut().zip(&*right).for_each(|(own, number)| *own = number.0[lane]);
            checked.solve(&mut self.right);
            right.iter_mut().zip(&self.right).for_each(|(number, own)| number.0[lane] = *own);
        }
    }
}

/// The equations, with the series of their entries and unknowns.
#[derive(Clone, Debug)]
pub(super) struct LinearSeries<S, F> {
    entries: Vec<Source>,
    right: Vec<Source>,
    /// The values of constant entries and right-hand sides, by index.
    fixed: [Vec<S>; 2],
    /// The column of each unknown.
    unknowns: Vec<usize>,
    /// The columns of all variable quantities in the equations, and their numbers of the current order.
    columns: Vec<usize>,
    now: Vec<S>,
    /// The variable entries, column by column of the matrix.
    moving: Vec<usize>,
    runs: Vec<Run>,
    /// The coefficients of the variable entries, order by order.
    series: Vec<S>,
    /// The coefficients of the unknowns, order by order.
    found: Vec<S>,
    /// The entries of order zero.
    first: Vec<S>,
    solver: F,
}

/// The source of an entry.
#[derive(Clone, Copy, Debug)]
enum Source {
    /// The coefficient with this index.
    Fixed(u32),
    /// A variable quantity of the equations.
    Moving(usize),
}

/// Variable entries in consecutive rows of a column.
#[derive(Clone, Copy, Debug)]
struct Run {
    column: usize,
    row: usize,
    /// The range among the variable entries.
    from: usize,
    to: usize,
}

impl<S: Scalar, F: Solver<S>> LinearSeries<S, F> {
    /// Buffers for series of an order; `column` gives the column of a quantity.
    pub fn new(plan: &LinearEquations, order: usize, solver: F, column: impl Fn(u32) -> usize) -> Self {
        let mut columns = Vec::new();
        let mut source = |quantity: &Quantity| match *quantity {
            Quantity::Fixed(number) => Source::Fixed(number),
            Quantity::Moving(place) => {
                columns.push(column(place));
                Source::Moving(columns.len() - 1)
            }
        };
        let [entries, right] = [&plan.entries, &plan.right].map(|all| all.iter().map(&mut source).collect());
        let places = plan.pattern.places();
        let is_moving = |entry: &usize| matches!(plan.entries[*entry], Quantity::Moving(_));
        let mut moving: Vec<usize> = (0..places.len()).filter(is_moving).collect();
        moving.sort_by_key(|&entry| (places[entry].1, places[entry].0));
        let mut runs: Vec<Run> = Vec::new();
        for (number, &entry) in moving.iter().enumerate() {
            let (row, column) = places[entry];
            match runs.last_mut() {
                Some(run) if run.column == column && run.row + (run.to - run.from) == row => run.to += 1,
                _ => runs.push(Run { column, row, from: number, to: number + 1 }),
            }
        }
        let (count, size) = (moving.len(), plan.unknowns.len());
        LinearSeries {
            entries,
            right,
            fixed: [vec![S::zero(); places.len()], vec![S::zero(); size]],
            unknowns: plan.unknowns.iter().map(|&place| column(place)).collect(),
            now: vec![S::zero(); columns.len()],
            columns,
            moving,
            runs,
            series: vec![S::zero(); count * (order + 1)],
            found: vec![S::zero(); size * (order + 2)],
            first: vec![S::zero(); places.len()],
            solver,
        }
    }

    /// Sets the coefficients.
    pub fn set(&mut self, values: &[S]) {
        for (fixed, sources) in self.fixed.iter_mut().zip([&self.entries, &self.right]) {
            for (value, source) in fixed.iter_mut().zip(sources) {
                if let Source::Fixed(number) = source {
                    *value = values.get(*number as usize).copied().unwrap_or(S::zero());
                }
            }
        }
    }

    /// Reads the quantities of an order from their columns.
    #[inline(always)]
    pub fn read(&mut self, column: impl Fn(usize) -> S) {
        self.now.iter_mut().zip(&self.columns).for_each(|(now, &place)| *now = column(place));
    }

    /// Writes the unknowns of order k into their columns.
    #[inline(always)]
    pub fn write(&self, k: usize, mut column: impl FnMut(usize, S)) {
        let found = &self.found[k * self.unknowns.len()..];
        self.unknowns.iter().zip(found).for_each(|(&place, &unknown)| column(place, unknown));
    }

    /// Computes the unknowns of order k from the quantities that were read.
    #[inline(always)]
    fn next(&mut self, k: usize) {
        let size = self.unknowns.len();
        if k == 0 {
            for ((first, source), fixed) in self.first.iter_mut().zip(&self.entries).zip(&self.fixed[0]) {
                *first = match *source {
                    Source::Fixed(_) => *fixed,
                    Source::Moving(number) => self.now[number],
                };
            }
            self.solver.factor(&self.first);
        }
        let series = &mut self.series[..(k + 1) * self.moving.len()];
        for (value, &entry) in series[k * self.moving.len()..].iter_mut().zip(&self.moving) {
            if let Source::Moving(number) = self.entries[entry] {
                *value = self.now[number];
            }
        }
        let (found, rest) = self.found.split_at_mut(k * size);
        let rest = &mut rest[..size];
        for ((rest, source), fixed) in rest.iter_mut().zip(&self.right).zip(&self.fixed[1]) {
            *rest = match *source {
                Source::Fixed(_) if k == 0 => *fixed,
                Source::Fixed(_) => S::zero(),
                Source::Moving(number) => self.now[number],
            };
        }
        if !self.moving.is_empty() {
            let orders = series.chunks_exact(self.moving.len()).skip(1).zip(found.chunks_exact(size).rev());
            for (entries, unknowns) in orders {
                for &Run { column, row, from, to } in &self.runs {
                    let unknown = unknowns[column];
                    for (rest, &entry) in rest[row..].iter_mut().zip(&entries[from..to]) {
                        *rest = rest.less_product(entry, unknown);
                    }
                }
            }
        }
        self.solver.solve(rest);
    }
}

/// The computation of the unknowns of an order, compiled for each instruction set.
pub(super) struct Next<'a, S: Magnitude> {
    pub series: &'a mut LinearSeries<S, Checked<S>>,
    pub k: usize,
}

impl<S: Fused> Task<S> for Next<'_, S> {
    #[inline(always)]
    fn run<P: Pick<S> + Pick<f64>>(self, _pick: P) {
        self.series.next(self.k);
    }
}

impl<const L: usize> LinearSeries<Batch<L>, LaneEquations<L>> {
    /// Computes the unknowns of order k in every lane.
    #[inline(never)]
    pub fn next_of_lanes(&mut self, k: usize) {
        self.next(k);
    }
}

impl<F: Solver<f64>> LinearSeries<f64, F> {
    /// Copies the first orders from a finer type, rounded; the factorisation is that of the rounded entries.
    pub fn take<S: Scalar, G>(&mut self, finer: &LinearSeries<S, G>, orders: usize, round: impl Fn(S) -> f64) {
        let known = orders * self.moving.len();
        self.series[..known].iter_mut().zip(&finer.series).for_each(|(own, finer)| *own = round(*finer));
        let known = orders * self.unknowns.len();
        self.found[..known].iter_mut().zip(&finer.found).for_each(|(own, finer)| *own = round(*finer));
        self.first.iter_mut().zip(&finer.first).for_each(|(own, finer)| *own = round(*finer));
        self.solver.factor(&self.first);
    }
}
