//! One evaluation, in registers of eight.

use super::{Lanes, Polynomials, WIDTH};
use crate::recurrence::{Columns, Fused, Pick, Task};

/// Numbers of an evaluation: inputs, parts, products. What is cleared and not needed costs.
const FEW: usize = 64;
const SOME: usize = 128;
const MORE: usize = 256;
const MANY: usize = 1024;
pub(super) const MOST: usize = 4096;

impl Polynomials {
    /// The outputs at the inputs, row after row; inputs that are missing are zero, and of the outputs as many are written as
    /// there is room for. Allocates nothing.
    #[inline]
    pub fn evaluate(&self, inputs: &[f64], outputs: &mut [f64]) {
        match &self.narrow {
            Some(narrow) => narrow.evaluate(&self.parts, inputs, outputs),
            None => self.wide(inputs, outputs),
        }
    }

    /// The products, each after its factors.
    #[inline(always)]
    fn multiply<P: Pick<f64>, const N: usize>(&self, pick: P, values: &mut Columns<f64, N>) {
        for (group, [lower, variable]) in self.products.iter().enumerate() {
            let (a, b) = (pick.load(&pick.pick(values, lower)), pick.load(&pick.pick(values, variable)));
            let place = (self.first + group * WIDTH) % N;
            values.0[place..place + WIDTH].copy_from_slice(&pick.store(pick.product(a, b)));
        }
    }

    #[inline]
    fn wide(&self, inputs: &[f64], outputs: &mut [f64]) {
        match self.numbers() {
            few if few <= FEW => f64::run(Evaluation::<FEW> { of: self, inputs, outputs }, WIDTH),
            some if some <= SOME => f64::run(Evaluation::<SOME> { of: self, inputs, outputs }, WIDTH),
            more if more <= MORE => f64::run(Evaluation::<MORE> { of: self, inputs, outputs }, WIDTH),
            many if many <= MANY => f64::run(Evaluation::<MANY> { of: self, inputs, outputs }, WIDTH),
            _ => f64::run(Evaluation::<MOST> { of: self, inputs, outputs }, WIDTH),
        }
    }

    /// How many numbers there are, in whole groups.
    fn numbers(&self) -> usize {
        self.first + WIDTH * self.products.len()
    }
}

struct Evaluation<'a, const N: usize> {
    of: &'a Polynomials,
    inputs: &'a [f64],
    outputs: &'a mut [f64],
}

impl<const N: usize> Task<f64> for Evaluation<'_, N> {
    #[inline(always)]
    fn run<P: Pick<f64>>(self, pick: P) {
        let Evaluation { of, inputs, outputs } = self;
        let mut values = Columns([0.0; N]);
        of.parts.fill(pick, inputs, &mut values.0);
        of.multiply(pick, &mut values);
        let blocks = &of.blocks;
        for (output, constant) in outputs.iter_mut().zip(&blocks.constants) {
            *output = *constant;
        }
        let mut begin = 0;
        for block in &blocks.all {
            let (terms, rest) = blocks.places[begin..block.end].as_chunks::<4>();
            let (factors, factors_left) = blocks.factors[begin..block.end].as_chunks::<4>();
            // four sums: none waits for the addition before
            let zero = pick.load(&[0.0; WIDTH]);
            let (mut a, mut b, mut c, mut d) = (pick.load(&block.constants.0), zero, zero, zero);
            for (terms, factors) in terms.iter().zip(factors) {
                a = multiple(pick, a, terms[0], &factors[0], &values);
                b = multiple(pick, b, terms[1], &factors[1], &values);
                c = multiple(pick, c, terms[2], &factors[2], &values);
                d = multiple(pick, d, terms[3], &factors[3], &values);
            }
            for (term, factor) in rest.iter().zip(factors_left) {
                a = multiple(pick, a, *term, factor, &values);
            }
            begin = block.end;
            let sums = pick.store(pick.plus(pick.plus(a, b), pick.plus(c, d)));
            if !blocks.are_neighbours() {
                for (to, sum) in block.to.into_iter().zip(sums) {
                    if let Some(output) = outputs.get_mut(to as usize) {
                        *output = sum;
                    }
                }
                continue;
            }
            let Some(room) = outputs.get_mut(block.to[0] as usize..) else { return };
            match room.first_chunk_mut() {
                Some(whole) => *whole = sums,
                None => room.iter_mut().zip(sums).for_each(|(output, sum)| *output = sum),
            }
        }
    }
}

/// sum + factor times the value at a place. A function and no closure, which would be compiled for narrow registers.
#[inline(always)]
fn multiple<P: Pick<f64>, const N: usize>(
    pick: P,
    sum: P::Eight,
    place: u32,
    factor: &Lanes,
    values: &Columns<f64, N>,
) -> P::Eight {
    let value = pick.load(&[values.0[place as usize % N]; WIDTH]);
    // rounded twice everywhere: a sum is the same on every processor
    pick.plus(sum, pick.product(pick.load(&factor.0), value))
}
