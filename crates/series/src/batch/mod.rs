//! Taylor series of a batch: many systems of one kind at once, with different data.
//!
//! All numbers are vectors over the lanes, and quantities are computed one after another. Most of the time is spent on
//! loading and addressing. Products are therefore computed for four orders at a time, in pairs where they have a common
//! factor, and likewise sums of common quantities.

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

/// Taylor series of L systems, which differ in their parameters, states and times, one in each lane. Allocates nothing;
/// lanes are independent. `N` is a power of two above the number of quantities, so that indices need no check.
#[derive(Clone, Debug)]
pub struct BatchExpansion<'a, const L: usize, const N: usize = 256> {
    order: usize,
    states: usize,
    time: bool,
    stages: Vec<Side<L>>,
    rates: Rows<L>,
    quantities: Box<[Quantity<L>; N]>,
    /// The coefficients of the states of the highest order, and of the one below.
    last: [Vec<Batch<L>>; 2],
    factors: Vec<Factor>,
    histories: Histories<L>,
    points: Program<'a, Batch<L>>,
    inputs: Vec<Batch<L>>,
    circle: Vec<Batch<L>>,
    /// Computes the coefficients of the sums from the parameters.
    coefficients: Program<'a, Batch<L>>,
    values: Vec<Batch<L>>,
    /// Whether parameters have changed since the coefficients were computed.
    changed: bool,
}

impl Recurrence {
    /// Prepares the recurrence for L systems. `None` where it has more than `N` quantities, or the processor has no
    /// SIMD registers with fused multiply-add. Until a lane is [set], all its coefficients are zero.
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
    /// The order of the series.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Sets the parameters of the system in a lane.
    pub fn set(&mut self, lane: usize, parameters: &[f64]) {
        let inputs = &mut self.inputs[self.states + usize::from(self.time)..];
        inputs.iter_mut().zip(parameters).for_each(|(input, value)| input.0[lane] = *value);
        self.changed = true;
    }

    /// Computes the Taylor coefficients of the solutions through these states, each at its time.
    pub fn expand(&mut self, states: &[Batch<L>], time: Batch<L>) {
        in_wide(Expand { batch_expansion: self, states, time });
    }

    /// The Taylor coefficients a_k of the states, where k is the highest order or the one below; empty for other k.
    #[inline]
    pub fn coefficients(&self, k: usize) -> &[Batch<L>] {
        self.order.checked_sub(k).and_then(|before| self.last.get(before)).map_or(&[], |last| last)
    }

    /// Evaluates the series, each lane at its h, by Horner's scheme.
    pub fn sum(&self, h: Batch<L>, out: &mut [Batch<L>]) {
        let (histories, order) = (&self.histories, self.order);
        let states = self.states.min(out.len());
        let out = &mut out[..states];
        in_wide(Sum { histories, order, h, out });
    }
}
