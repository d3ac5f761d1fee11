//! Taylor series of a batch, computed member by member: for laws with exponentials, whose arguments bound each step,
//! and for processors without SIMD registers.

use super::batch_series::{FEW, MANY};
use super::parametric_system::BATCH_SIZE;
use crate::{Expandable, Room};
use field::Batch;
use integrators::BatchSeries;
use series::Expansion;
use std::cell::Cell;

/// The number of quantities computed together in one system.
const WIDTH: usize = 8;

/// As [`batch_series`](super::batch_series()), member by member.
pub(super) fn one_by_one(law: &Expandable, order: usize) -> Option<Box<dyn BatchSeries<BATCH_SIZE> + '_>> {
    match law.recurrence.columns::<WIDTH>() {
        columns if columns <= FEW => Some(Box::new(OneByOne::<FEW>::new(law, order)?)),
        columns if columns <= MANY => Some(Box::new(OneByOne::<MANY>::new(law, order)?)),
        _ => None,
    }
}

struct OneByOne<'a, const N: usize> {
    law: &'a Expandable,
    lanes: Vec<Lane<N>>,
    /// The coefficients of the highest order, and of the one below.
    last: [Vec<Batch<BATCH_SIZE>>; 2],
    /// Buffer for the sum of one member.
    sums: Cell<Vec<f64>>,
}

/// The system of one lane.
struct Lane<const N: usize> {
    expansion: Expansion<f64, WIDTH, N>,
    parameters: Vec<f64>,
    /// The state, followed by buffers for the exponents.
    extended: Vec<f64>,
    exponents: Room,
}

impl<'a, const N: usize> OneByOne<'a, N> {
    fn new(law: &'a Expandable, order: usize) -> Option<Self> {
        let parameters = vec![0.0; law.parameters()];
        let lane = || {
            Some(Lane {
                expansion: law.recurrence.expansion(&parameters, order)?,
                parameters: parameters.clone(),
                extended: vec![0.0; law.recurrence.states()],
                exponents: Room::default(),
            })
        };
        let lanes = (0..BATCH_SIZE).map(|_| lane()).collect::<Option<Vec<_>>>()?;
        let last = [(); 2].map(|()| vec![Batch::all(0.0); law.states()]);
        Some(OneByOne { law, lanes, last, sums: Cell::default() })
    }
}

impl<const N: usize> BatchSeries<BATCH_SIZE> for OneByOne<'_, N> {
    fn set(&mut self, lane: usize, parameters: &[f64]) {
        let lane = &mut self.lanes[lane];
        lane.expansion.set_parameters(parameters);
        lane.parameters.copy_from_slice(parameters);
    }

    fn order(&self) -> usize {
        self.lanes[0].expansion.order()
    }

    fn expand(&mut self, times: Batch<BATCH_SIZE>, states: &[Batch<BATCH_SIZE>]) {
        let order = self.order();
        for (place, (lane, time)) in self.lanes.iter_mut().zip(times.0).enumerate() {
            lane.extended.iter_mut().zip(states).for_each(|(own, state)| *own = state.0[place]);
            if let Some(exponents) = &self.law.exponents {
                let state = states.iter().map(|state| state.0[place]);
                exponents.evaluate(&mut lane.exponents, state, time, &lane.parameters);
            }
            lane.expansion.expand(&lane.extended, time);
            for (k, last) in [order, order - 1].into_iter().zip(&mut self.last) {
                last.iter_mut().zip(lane.expansion.coefficients(k)).for_each(|(own, term)| own.0[place] = *term);
            }
        }
    }

    fn coefficients(&self, k: usize) -> &[Batch<BATCH_SIZE>] {
        &self.last[usize::from(k != self.order())]
    }

    fn sum(&self, h: Batch<BATCH_SIZE>, out: &mut [Batch<BATCH_SIZE>]) {
        let mut sums = self.sums.take();
        sums.resize(out.len(), 0.0);
        for (place, (lane, h)) in self.lanes.iter().zip(h.0).enumerate() {
            lane.expansion.sum(h, &mut sums);
            out.iter_mut().zip(&sums).for_each(|(out, sum)| out.0[place] = *sum);
        }
        self.sums.set(sums);
    }

    fn shown(&self) -> Batch<BATCH_SIZE> {
        let first = self.law.states();
        let longest = |lane: &Lane<N>| {
            let term = |place: usize, k: usize| lane.expansion.coefficients(k)[first + place];
            self.law.exponents.as_ref().map_or(f64::INFINITY, |exponents| {
                exponents.longest(&lane.exponents.values, lane.expansion.order(), false, term)
            })
        };
        let mut shown = Batch::all(f64::INFINITY);
        shown.0.iter_mut().zip(&self.lanes).for_each(|(shown, lane)| *shown = longest(lane));
        shown
    }
}
