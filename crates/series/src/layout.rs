//! The memory layout of the quantities of a plan, such that `W` of them are computed together.

use super::fused::Fused;
use super::linear_equations::{Checked, LinearSeries};
use super::pick::Selection;
use super::plan::{Plan, Product, Quotient, Slot, Sums};
use algebra::linear::Magnitude;
use field::Scalar;

/// W adjacent numbers; a group of eight `f64` is one cache line.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Packed<S, const W: usize>(pub [S; W]);

impl<S: Scalar, const W: usize> Packed<S, W> {
    pub fn zero() -> Self {
        Packed([S::zero(); W])
    }
}

/// The number of sums computed concurrently, to hide latency. Terms are padded to a multiple of it.
pub(super) const CHAINS: usize = 4;

/// The largest number of columns.
pub(super) const MOST: usize = 1 << 16;

/// The columns of the quantities, and the sums and products over them.
#[derive(Clone, Debug)]
pub(super) struct Layout<S, const W: usize> {
    pub stages: Vec<Laid<S, W>>,
    pub rates: Rows<S, W>,
}

/// A stage of the plan.
#[derive(Clone, Debug)]
pub(super) struct Laid<S, const W: usize> {
    pub sums: Rows<S, W>,
    pub groups: Vec<Group<S, W>>,
    pub quotients: Vec<Implicit<S>>,
    pub roots: Vec<Implicit<S>>,
    /// Whether the stage has quotients, roots or linear equations.
    pub has_implicit: bool,
    pub linear: Option<Box<LinearSeries<S, Checked<S>>>>,
}

/// W products of two series each.
#[derive(Clone, Debug)]
pub(super) struct Group<S, const W: usize> {
    /// The columns of the factors.
    pub factors: [Selection<W>; 2],
    /// The column of the first product.
    pub first: usize,
    /// The series of the left factors: a_i at index i.
    pub left: Vec<Packed<S, W>>,
    /// The series of the right factors: b_i at index order - i.
    pub right: Vec<Packed<S, W>>,
}

/// A quotient or a square root.
#[derive(Clone, Debug)]
pub(super) struct Implicit<S> {
    pub column: usize,
    /// The column of the radicand, or of the divisor.
    pub of: usize,
    /// The column of the numerator; `None` for a reciprocal.
    pub above: Option<usize>,
    /// The series of the quotient or root, and of the divisor.
    pub series: Vec<[S; 2]>,
    /// The reciprocal of the first coefficient of the divisor.
    pub inverse: S,
}

impl<S: Scalar> Implicit<S> {
    pub fn new(column: usize, of: usize, above: Option<usize>, order: usize) -> Self {
        Implicit { column, of, above, series: vec![[S::zero(); 2]; order + 1], inverse: S::zero() }
    }
}

/// W sums at a time, by columns, each with one coefficient for every sum.
#[derive(Clone, Debug)]
pub(super) struct Rows<S, const W: usize> {
    /// The column of the first sum.
    pub first: usize,
    pub blocks: Vec<Block<S, W>>,
}

/// W sums: their constants, and for each column its coefficient in each sum.
#[derive(Clone, Debug)]
pub(super) struct Block<S, const W: usize> {
    pub constants: Packed<S, W>,
    pub columns: Vec<[u16; CHAINS]>,
    pub factors: Vec<[Packed<S, W>; CHAINS]>,
    /// The indices of the coefficients by place.
    constant_of: [u32; W],
    factor_of: Vec<[[u32; W]; CHAINS]>,
}

const NONE: u32 = u32::MAX;

impl<S: Scalar + Magnitude, const W: usize> Layout<S, W> {
    /// The layout for series of the given order, without coefficients.
    pub fn new(plan: &Plan, order: usize) -> Self {
        let mut columns = Places { of: (0..plan.moving as u16).collect(), next: plan.moving.next_multiple_of(W) };
        let mut stages = Vec::new();
        for stage in &plan.stages {
            let first_sum = columns.take::<W>(stage.sum_places.iter().copied());
            let sums = Rows::new(&stage.sums, first_sum, &columns);
            let first = columns.take::<W>(stage.products.iter().map(|product| product.place));
            let group = |(number, products): (usize, &[Product])| {
                let column = |factor: fn(&Product) -> Slot, lane: usize| -> u16 {
                    products.get(lane).map_or(0, |product| columns.of(factor(product)))
                };
                let factors: [fn(&Product) -> Slot; 2] = [|product| product.a, |product| product.b];
                let factors = factors.map(|factor| Selection::new(std::array::from_fn(|lane| column(factor, lane))));
                let room = vec![Packed::zero(); order + 1 + 2 * CHAINS];
                Group { factors, first: first + number * W, left: room.clone(), right: room }
            };
            let groups = stage.products.chunks(W).enumerate().map(group).collect();
            let mut implicit = |place: Slot, of: Slot, above: Option<Slot>| {
                let column = columns.take::<1>([place]);
                let [of, above] = [Some(of), above].map(|slot| slot.map(|slot| columns.of(slot).into()));
                Implicit::new(column, of.unwrap_or(column), above, order)
            };
            let quotient = |&Quotient { place, above, below }: &Quotient| implicit(place, below, above);
            let quotients: Vec<_> = stage.quotients.iter().map(quotient).collect();
            let roots: Vec<_> = stage.roots.iter().map(|&(place, of)| implicit(place, of, None)).collect();
            let has_implicit = !(quotients.is_empty() && roots.is_empty());
            columns.next = columns.next.next_multiple_of(W);
            let linear = stage.linear.as_ref().map(|linear| {
                columns.take::<W>(linear.unknowns.iter().copied());
                let factors = Checked::new(&linear.pattern);
                Box::new(LinearSeries::new(linear, order, factors, |place| columns.of(place).into()))
            });
            stages.push(Laid { sums, groups, quotients, roots, has_implicit, linear });
        }
        Layout { stages, rates: Rows::new(&plan.rates, 0, &columns) }
    }

    /// Sets the coefficients.
    pub fn set(&mut self, values: &[S]) {
        for stage in &mut self.stages {
            stage.sums.set(values);
            stage.linear.iter_mut().for_each(|linear| linear.set(values));
        }
        self.rates.set(values);
    }
}

impl<const W: usize> Layout<f64, W> {
    /// Copies the series of all factors up to (without) the order `up_to` from a finer type, rounded; `order` is the
    /// highest order.
    pub fn take<S: Fused>(&mut self, finer: &Layout<S, W>, up_to: usize, order: usize) {
        let round = |own: &mut [Packed<f64, W>], finer: &[Packed<S, W>]| {
            own.iter_mut().zip(finer).for_each(|(own, finer)| own.0 = finer.0.map(S::rounded));
        };
        for (own, finer) in self.stages.iter_mut().zip(&finer.stages) {
            for (own, finer) in own.groups.iter_mut().zip(&finer.groups) {
                round(&mut own.left[..up_to + CHAINS], &finer.left[..up_to + CHAINS]);
                let known = order + 1 - up_to..order + 1;
                round(&mut own.right[known.clone()], &finer.right[known]);
            }
            if let (Some(own), Some(finer)) = (&mut own.linear, &finer.linear) {
                own.take(finer, up_to, S::rounded);
            }
            let implicit = own.quotients.iter_mut().chain(&mut own.roots);
            for (own, finer) in implicit.zip(finer.quotients.iter().chain(&finer.roots)) {
                own.inverse = finer.inverse.rounded();
                let known = own.series[..up_to].iter_mut().zip(&finer.series);
                known.for_each(|(own, finer)| *own = finer.map(S::rounded));
            }
        }
    }
}

/// The number of columns of a plan with groups of `lanes`.
pub(super) fn width(plan: &Plan, lanes: usize) -> usize {
    let stage = |stage: &super::plan::Stage| {
        let single = (stage.quotients.len() + stage.roots.len()).next_multiple_of(lanes);
        let unknowns = stage.linear.as_ref().map_or(0, |linear| linear.unknowns.len()).next_multiple_of(lanes);
        let groups = stage.sum_places.len().next_multiple_of(lanes) + stage.products.len().next_multiple_of(lanes);
        groups + single + unknowns
    };
    plan.moving.next_multiple_of(lanes) + plan.stages.iter().map(stage).sum::<usize>()
}

impl<S: Scalar, const W: usize> Rows<S, W> {
    fn new(sums: &Sums, first: usize, columns: &Places) -> Self {
        let block = |number: usize| {
            let mut constant_of = [NONE; W];
            let inside = |row: u32| row as usize / W == number;
            for &(row, coefficient) in sums.constants.iter().filter(|(row, _)| inside(*row)) {
                constant_of[row as usize % W] = coefficient;
            }
            // terms are sorted by the time at which their columns become known
            let mut own: Vec<_> = sums.terms.iter().filter(|(row, ..)| inside(*row)).collect();
            own.sort_by_key(|(_, place, _)| columns.of(*place));
            let mut terms: Vec<(u16, [u32; W])> = Vec::new();
            for &&(row, place, coefficient) in &own {
                let column = columns.of(place);
                if terms.last().is_none_or(|(last, _)| *last != column) {
                    terms.push((column, [NONE; W]));
                }
                if let Some((_, coefficients)) = terms.last_mut() {
                    coefficients[row as usize % W] = coefficient;
                }
            }
            terms.resize(terms.len().next_multiple_of(CHAINS), (0, [NONE; W]));
            let four = terms.chunks_exact(CHAINS);
            let columns = four.clone().map(|four| std::array::from_fn(|chain| four[chain].0)).collect();
            let factor_of: Vec<_> = four.map(|four| std::array::from_fn(|chain| four[chain].1)).collect();
            let factors = vec![[Packed::zero(); CHAINS]; factor_of.len()];
            Block { constants: Packed::zero(), columns, factors, constant_of, factor_of }
        };
        Rows { first, blocks: (0..sums.rows.div_ceil(W)).map(block).collect() }
    }

    fn set(&mut self, values: &[S]) {
        let value = |number: u32| values.get(number as usize).copied().unwrap_or(S::zero());
        for block in &mut self.blocks {
            block.constants.0 = block.constant_of.map(value);
            for (factors, numbers) in block.factors.iter_mut().zip(&block.factor_of) {
                *factors = numbers.map(|numbers| Packed(numbers.map(value)));
            }
        }
    }
}

/// The column of each place.
struct Places {
    of: Vec<u16>,
    next: usize,
}

impl Places {
    fn of(&self, place: Slot) -> u16 {
        self.of.get(place as usize).copied().unwrap_or(0)
    }

    /// Assigns columns to these places, padded to a multiple of W.
    fn take<const W: usize>(&mut self, places: impl IntoIterator<Item = Slot>) -> usize {
        let first = self.next;
        for (number, place) in places.into_iter().enumerate() {
            if self.of.len() <= place as usize {
                self.of.resize(place as usize + 1, 0);
            }
            self.of[place as usize] = (first + number) as u16;
            self.next = first + (number + 1).next_multiple_of(W);
        }
        first
    }
}
