//! All orders of a series, and its evaluation, compiled for each instruction set.

use super::BatchExpansion;
use super::products::{Fan, Histories, Quantity};
use field::Batch;
use pulp::{Simd, WithSimd};

/// All orders of a series.
pub(super) struct Expand<'a, 'b, 'c, const L: usize, const N: usize> {
    pub batch_expansion: &'a mut BatchExpansion<'b, L, N>,
    pub states: &'c [Batch<L>],
    pub time: Batch<L>,
}

impl<const L: usize, const N: usize> Expand<'_, '_, '_, L, N> {
    #[inline(always)]
    pub fn run(self) {
        let order = self.batch_expansion.order;
        if self.batch_expansion.changed {
            self.batch_expansion.learn();
        }
        self.batch_expansion.start(self.states, self.time);
        for k in (0..order).step_by(4) {
            if k == 0 {
                self.batch_expansion.four::<true>(k, order);
            } else {
                self.batch_expansion.begin(k / 4);
                self.batch_expansion.four::<false>(k, order);
            }
        }
        self.batch_expansion.end();
    }
}

impl<const L: usize, const N: usize> BatchExpansion<'_, L, N> {
    /// Recomputes the coefficients of all systems, which costs no more than those of one.
    #[inline(always)]
    fn learn(&mut self) {
        let parameters = &self.inputs[self.states + usize::from(self.time)..];
        self.coefficients.evaluate(parameters, &mut self.values);
        for stage in &mut self.stages {
            stage.sums.take(&self.values);
            stage.linear.iter_mut().for_each(|linear| linear.set(&self.values));
        }
        self.rates.take(&self.values);
        self.changed = false;
    }

    /// Order zero of all quantities with a rate.
    #[inline(always)]
    fn start(&mut self, states: &[Batch<L>], time: Batch<L>) {
        let n = self.states.min(states.len());
        self.inputs[..n].copy_from_slice(&states[..n]);
        let mut moving = self.states;
        if self.time {
            self.inputs[moving] = time;
            moving += 1;
        }
        if !self.circle.is_empty() {
            self.points.evaluate(&self.inputs, &mut self.circle);
        }
        let starts = self.inputs[..moving].iter().chain(&self.circle);
        for (quantity, start) in self.quantities.iter_mut().zip(starts) {
            quantity.newest[0] = *start;
        }
    }

    /// Copies the highest two orders of the states.
    #[inline(always)]
    fn end(&mut self) {
        let [last, before] = &mut self.last;
        for (number, (last, before)) in last.iter_mut().zip(before).enumerate() {
            // by element: a copy of the whole would go through memory
            let newest = &self.quantities[number % N].newest;
            (*last, *before) = (newest[self.order % 4], newest[(self.order + 3) % 4]);
            self.histories.fours[number * self.histories.each + self.order / 4] = *newest;
        }
    }

    /// Sums the contributions of the first `fours` groups of orders to the next group.
    #[inline(always)]
    fn begin(&mut self, fours: usize) {
        for stage in &mut self.stages {
            for fan in &mut stage.pairs {
                fan.begin(&self.histories, fours);
            }
            for fan in &mut stage.alone {
                fan.begin(&self.histories, fours);
            }
        }
    }

    /// Computes up to four orders from k on.
    #[inline(always)]
    fn four<const FIRST: bool>(&mut self, k: usize, order: usize) {
        self.next::<FIRST, 0>(k);
        if k + 1 < order {
            self.next::<FIRST, 1>(k + 1);
        }
        if k + 2 < order {
            self.next::<FIRST, 2>(k + 2);
        }
        if k + 3 < order {
            self.next::<FIRST, 3>(k + 3);
        }
    }

    /// Computes order k + 1 of all quantities with a rate from order k.
    #[inline(always)]
    fn next<const FIRST: bool, const I: usize>(&mut self, k: usize) {
        let quantities = &mut *self.quantities;
        for stage in &mut self.stages {
            if FIRST && I == 0 {
                stage.sums.sums::<true, I, N>(quantities, |to, place, sum| to[place].newest[I] = sum);
            } else {
                stage.sums.sums::<false, I, N>(quantities, |to, place, sum| to[place].newest[I] = sum);
            }
            finish::<L, 2, N, FIRST, I>(&stage.pairs, quantities);
            finish::<L, 1, N, FIRST, I>(&stage.alone, quantities);
            for each in &mut stage.quotients {
                let above = each.above.map(|above| quantities[above % N].newest[I]);
                quantities[each.column % N].newest[I] = each.quotient(k, above, quantities[each.of % N].newest[I]);
            }
            for each in &mut stage.roots {
                quantities[each.column % N].newest[I] = each.root(k, quantities[each.of % N].newest[I]);
            }
            if let Some(series) = &mut stage.linear {
                series.read(|column| quantities[column % N].newest[I]);
                series.next_of_lanes(k);
                series.write(k, |column, unknown| quantities[column % N].newest[I] = unknown);
            }
        }
        if I == 3 {
            let histories = self.histories.fours.chunks_exact_mut(self.histories.each);
            for (factor, history) in self.factors.iter().zip(histories) {
                let quantity = &mut quantities[usize::from(factor.place) % N];
                history[k / 4] = quantity.newest;
                if FIRST {
                    quantity.oldest = quantity.newest;
                }
            }
        }
        // x_(k+1) = (x')_k / (k + 1)
        let reciprocal = Batch::all(1.0 / (k + 1) as f64);
        let put =
            |to: &mut [Quantity<L>; N], place: usize, sum: Batch<L>| to[place].newest[(I + 1) % 4] = sum * reciprocal;
        if FIRST && I == 0 {
            self.rates.sums::<true, I, N>(quantities, put);
        } else {
            self.rates.sums::<false, I, N>(quantities, put);
        }
    }
}

#[inline(always)]
fn finish<const L: usize, const M: usize, const N: usize, const FIRST: bool, const I: usize>(
    fans: &[Fan<L, M>],
    quantities: &mut [Quantity<L>; N],
) {
    for fan in fans {
        fan.finish::<FIRST, I, N>(quantities);
    }
}

impl<const L: usize, const N: usize> WithSimd for Expand<'_, '_, '_, L, N> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.run();
    }
}

pub(super) struct Sum<'a, const L: usize> {
    pub histories: &'a Histories<L>,
    pub order: usize,
    pub h: Batch<L>,
    pub out: &'a mut [Batch<L>],
}

impl<const L: usize> Sum<'_, L> {
    #[inline(always)]
    pub fn run(self) {
        for (slot, out) in (0..).zip(self.out) {
            let fours = self.histories.of(slot, self.order / 4 + 1);
            let Some((last, before)) = fours.split_last() else { continue };
            let mut sum = Batch::all(0.0);
            for term in last[..=self.order % 4].iter().rev() {
                sum = term.plus_product(sum, self.h, true);
            }
            for [a, b, c, d] in before.iter().rev() {
                sum = c.plus_product(d.plus_product(sum, self.h, true), self.h, true);
                sum = a.plus_product(b.plus_product(sum, self.h, true), self.h, true);
            }
            *out = sum;
        }
    }
}

impl<const L: usize> WithSimd for Sum<'_, L> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.run();
    }
}
