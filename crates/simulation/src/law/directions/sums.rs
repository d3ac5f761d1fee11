//! The weighted sums of a directional derivative, for several directions at once.

use super::block::{Block, LANES};
use pulp::{Simd, WithSimd};
use symbolic::Differential;

/// The structure of the sums, without their weights.
#[derive(Debug)]
pub(super) struct Sums {
    /// The number of inputs, which come first.
    pub inputs: usize,
    pub outputs: usize,
    /// The index of the first term of each sum, and the end of the last.
    begins: Vec<u32>,
    /// The index of the source of each term.
    sources: Vec<u32>,
}

impl Sums {
    pub fn of(differential: &Differential) -> Self {
        let mut begins = vec![0];
        let mut sources = Vec::new();
        for sum in &differential.sums {
            sources.extend(sum.iter().map(|term| term.source as u32));
            begins.push(sources.len() as u32);
        }
        Sums { inputs: differential.inputs, outputs: differential.outputs, begins, sources }
    }

    pub fn terms(&self) -> usize {
        self.sources.len()
    }

    pub fn count(&self) -> usize {
        self.begins.len() - 1
    }

    pub fn places(&self) -> usize {
        self.inputs + self.count()
    }

    /// The sources of a sum.
    pub fn sources(&self, sum: usize) -> &[u32] {
        &self.sources[self.begins[sum] as usize..self.begins[sum + 1] as usize]
    }
}

/// One evaluation over blocks, compiled for each instruction set.
pub(super) struct Run<'a> {
    pub sums: &'a Sums,
    pub blocks: &'a [Block],
    pub weights: &'a [f64],
    /// The intermediate results of the last evaluation of these blocks, or zeros.
    pub places: &'a mut [[f64; LANES]],
    /// The length of a row, and the rows, initially zero.
    pub width: usize,
    pub rows: &'a mut [f64],
}

impl WithSimd for Run<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Run { sums, blocks, weights, places, width, rows } = self;
        let first_output = sums.count() - sums.outputs;
        for (place, block) in blocks.iter().enumerate() {
            for stale in &block.stale {
                places[stale.start as usize..stale.end as usize].fill([0.0; LANES]);
            }
            for (lane, input) in block.inputs.clone().enumerate() {
                places[input][lane] = 1.0;
            }
            for range in &block.moved {
                for sum in range.start as usize..range.end as usize {
                    let terms = sums.begins[sum] as usize..sums.begins[sum + 1] as usize;
                    places[sums.inputs + sum] = total(&sums.sources[terms.clone()], &weights[terms], places);
                }
            }
            let column = place * LANES;
            let lanes = block.inputs.len();
            for range in &block.outputs {
                for sum in range.start as usize..range.end as usize {
                    let terms = sums.begins[sum] as usize..sums.begins[sum + 1] as usize;
                    let total = total(&sums.sources[terms.clone()], &weights[terms], places);
                    let row = &mut rows[(sum - first_output) * width + column..];
                    if lanes == LANES {
                        row[..LANES].copy_from_slice(&total)
                    } else {
                        row[..lanes].copy_from_slice(&total[..lanes])
                    }
                }
            }
            for input in block.inputs.clone() {
                places[input] = [0.0; LANES];
            }
        }
    }
}

#[inline(always)]
fn total(sources: &[u32], weights: &[f64], places: &[[f64; LANES]]) -> [f64; LANES] {
    match *sources {
        [] => [0.0; LANES],
        [a] => several([a], weights, places),
        [a, b] => several([a, b], weights, places),
        [a, b, c] => several([a, b, c], weights, places),
        [a, b, c, d] => several([a, b, c, d], weights, places),
        _ => {
            let mut sum = [0.0; LANES];
            for (&source, &weight) in sources.iter().zip(weights) {
                sum = add(sum, weight, &places[source as usize]);
            }
            sum
        }
    }
}

#[inline(always)]
fn several<const N: usize>(sources: [u32; N], weights: &[f64], places: &[[f64; LANES]]) -> [f64; LANES] {
    let mut sum = [0.0; LANES];
    for k in 0..N {
        sum = add(sum, weights[k], &places[sources[k] as usize]);
    }
    sum
}

#[inline(always)]
fn add(mut sum: [f64; LANES], weight: f64, source: &[f64; LANES]) -> [f64; LANES] {
    for lane in 0..LANES {
        sum[lane] += weight * source[lane];
    }
    sum
}
