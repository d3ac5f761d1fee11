//! The series of many systems of one kind at once, each with data of its own.
//!
//! All numbers are lanes, and every quantity is computed by itself. Loading and addressing the numbers is most of the cost:
//! products are therefore formed for four orders at a time, two of them together where they share a factor, and likewise
//! sums of the same quantities.

mod parts;
mod products;
mod sums;
mod work;

use super::Recurrence;
use super::fused::{in_wide, is_wide};
use super::plan::{Slot, Stage};
use field::Batch;
use parts::{Side, Slots};
use products::{Factor, Histories, Quantity};
use sums::Rows;
use symbolic::Program;
use work::{Expand, Sum};

/// L systems that differ in their parameters, states and times, one in each lane. Nothing is allocated, and no lane
/// depends on another. `N` is a power of two above the number of quantities: no index needs a check.
#[derive(Clone, Debug)]
pub struct BatchExpansion<'a, const L: usize, const N: usize = 256> {
    order: usize,
    states: usize,
    time: bool,
    stages: Vec<Side<L>>,
    rates: Rows<L>,
    quantities: Box<[Quantity<L>; N]>,
    /// The states' coefficients of the last order, and of the one before.
    last: [Vec<Batch<L>>; 2],
    factors: Vec<Factor>,
    histories: Histories<L>,
    points: Program<'a, Batch<L>>,
    inputs: Vec<Batch<L>>,
    circle: Vec<Batch<L>>,
    /// From the parameters to the coefficients.
    coefficients: Program<'a, Batch<L>>,
    values: Vec<Batch<L>>,
    /// Whether a lane has parameters that the coefficients do not contain yet.
    changed: bool,
}

impl Recurrence {
    /// Prepares the recurrence for L systems; `None` where it has more than `N` quantities, or where the processor has no
    /// registers for several numbers with a sum and product in one instruction. Until a lane is [set], all its coefficients
    /// are zero.
    ///
    /// [set]: BatchExpansion::set
    pub fn batch_expansion<const L: usize, const N: usize>(&self, order: usize) -> Option<BatchExpansion<'_, L, N>> {
        const { assert!(N.is_power_of_two() && N <= 1 << 16) };
        let plan = &self.plan;
        let last = plan.stages.iter().flat_map(Stage::places).max().unwrap_or(0);
        if plan.moving.max(last as usize + 1) > N || !is_wide() {
            return None;
        }
        let zero = Batch::all(0.0);
        let inputs = plan.states + usize::from(plan.time);
        let mut slots = Slots { of: vec![None; N], factors: Vec::new() };
        // quantities with a rate need their series in any case
        for place in 0..plan.moving as Slot {
            slots.factor(place);
        }
        let stages: Vec<Side<L>> = plan.stages.iter().map(|stage| Side::new(stage, order, &mut slots)).collect();
        let each = order / 4 + 1;
        let quantities = vec![Quantity::ZERO; N].into_boxed_slice();
        Some(BatchExpansion {
            order,
            states: plan.states,
            time: plan.time,
            stages,
            rates: Rows::new(&plan.rates, &(0..plan.moving as Slot).collect::<Vec<_>>()),
            quantities: quantities.try_into().ok()?,
            last: [(); 2].map(|()| vec![zero; plan.states]),
            histories: Histories { fours: vec![[zero; 4]; slots.factors.len() * each], each },
            factors: slots.factors,
            points: self.points.over(),
            inputs: vec![zero; self.points.inputs()],
            circle: vec![zero; plan.moving - inputs],
            coefficients: self.coefficients.over(),
            values: vec![zero; self.coefficients.outputs()],
            changed: false,
        })
    }

    /// The number of parameters of a system.
    pub fn parameters(&self) -> usize {
        self.coefficients.inputs()
    }
}

impl<const L: usize, const N: usize> BatchExpansion<'_, L, N> {
    /// The order of the last coefficients.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Gives the system in a lane its parameters.
    pub fn set(&mut self, lane: usize, parameters: &[f64]) {
        let inputs = &mut self.inputs[self.states + usize::from(self.time)..];
        inputs.iter_mut().zip(parameters).for_each(|(input, value)| input.0[lane] = *value);
        self.changed = true;
    }

    /// Expands the solutions through these states, each at its time.
    pub fn expand(&mut self, states: &[Batch<L>], time: Batch<L>) {
        in_wide(Expand { batch_expansion: self, states, time });
    }

    /// The coefficients a_k of the states, for k the order or one less; others are not kept in one piece.
    #[inline]
    pub fn coefficients(&self, k: usize) -> &[Batch<L>] {
        self.order.checked_sub(k).and_then(|before| self.last.get(before)).map_or(&[], |last| last)
    }

    /// The sums of the series, each at its h, by Horner's scheme.
    pub fn sum(&self, h: Batch<L>, out: &mut [Batch<L>]) {
        let (histories, order) = (&self.histories, self.order);
        let states = self.states.min(out.len());
        let out = &mut out[..states];
        in_wide(Sum { histories, order, h, out });
    }
}
