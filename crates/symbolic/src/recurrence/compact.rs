//! Series of right-hand sides of second degree, with an order's work in registers.
//!
//! For k > 0
//!
//!   f(y)_k = J y_k + r_k ,    r_k = sum_p w_p (a_1 b_(k-1) + .. + a_(k-1) b_1)_p ,
//!
//! with J the Jacobian of f at y_0. An order waits for y_k only by way of J; r_k is summed meanwhile, as soon as y_(k-1) is
//! known. Of what a processor does in one order of a small system most is waiting, and this halves it.

use super::degree::SecondDegree;
use super::fused::{Fused, Task};
use super::layout::Lanes;
use super::order::add;
use super::pick::{Pick, Shuffle};

type Wide = Lanes<f64, 8>;
const ZERO: Wide = Lanes([0.0; 8]);

/// Sums that run side by side: none waits for the addition before.
const CHAINS: usize = 2;

/// 1/k
const RECIPROCALS: [f64; MOST_ORDER + 1] = {
    let mut reciprocals = [0.0; MOST_ORDER + 1];
    let mut k = 1;
    while k <= MOST_ORDER {
        reciprocals[k] = 1.0 / k as f64;
        k += 1;
    }
    reciprocals
};

/// Room for the series to this order and for chains that go too far.
const ROOM: usize = MOST_ORDER + 2 * CHAINS;
/// Higher orders are for more digits than `f64` has.
pub(super) const MOST_ORDER: usize = 64;

/// The quantities in B groups of eight, the products in G.
#[derive(Clone, Debug)]
pub struct Kernel<const B: usize, const G: usize> {
    degree: SecondDegree,
    constants: [Wide; B],
    /// L, by columns.
    linear: [[[Wide; B]; 8]; B],
    /// w, by columns.
    weights: [[[Wide; B]; 8]; G],
    /// J at the point of the last expansion, by columns.
    jacobian: [[[Wide; B]; 8]; B],
    /// Which quantities the factors are.
    factors: [[Shuffle; 2]; G],
    /// a_j at j.
    left: [[Wide; G]; ROOM],
    /// b_j at MOST_ORDER - j.
    right: [[Wide; G]; ROOM],
}

/// A kernel of some size.
#[derive(Clone, Debug)]
pub enum Compact {
    OneOne(Box<Kernel<1, 1>>),
    OneTwo(Box<Kernel<1, 2>>),
    OneThree(Box<Kernel<1, 3>>),
    TwoOne(Box<Kernel<2, 1>>),
    TwoTwo(Box<Kernel<2, 2>>),
    TwoThree(Box<Kernel<2, 3>>),
}

/// The same for each size.
macro_rules! for_kernel {
    ($compact:expr, $kernel:ident => $what:expr) => {
        match $compact {
            Compact::OneOne($kernel) => $what,
            Compact::OneTwo($kernel) => $what,
            Compact::OneThree($kernel) => $what,
            Compact::TwoOne($kernel) => $what,
            Compact::TwoTwo($kernel) => $what,
            Compact::TwoThree($kernel) => $what,
        }
    };
}

/// A way of expanding small right-hand sides of second degree.
pub(super) trait SmallSeries<S>: Clone + std::fmt::Debug {
    /// Room for one, without its coefficients; `None` where there is no such way.
    fn new(degree: &SecondDegree) -> Option<Self>;

    /// Takes the values of the coefficients.
    fn set(&mut self, values: &[S]);

    /// Expands the solution whose first coefficients stand at the head of the series, which has a row of whole groups of
    /// eight for each order.
    fn expand(&mut self, series: &mut [S]);
}

impl SmallSeries<f64> for Compact {
    fn new(degree: &SecondDegree) -> Option<Self> {
        Some(match (degree.moving > 8, degree.products.len().div_ceil(8)) {
            (false, 0 | 1) => Compact::OneOne(Kernel::new(degree)),
            (false, 2) => Compact::OneTwo(Kernel::new(degree)),
            (false, _) => Compact::OneThree(Kernel::new(degree)),
            (true, 0 | 1) => Compact::TwoOne(Kernel::new(degree)),
            (true, 2) => Compact::TwoTwo(Kernel::new(degree)),
            (true, _) => Compact::TwoThree(Kernel::new(degree)),
        })
    }

    fn set(&mut self, values: &[f64]) {
        for_kernel!(self, kernel => kernel.set(values));
    }

    fn expand(&mut self, series: &mut [f64]) {
        for_kernel!(self, kernel => f64::run(Expand { kernel, series }, 8));
    }
}

/// Of fields that have no way of their own.
#[derive(Clone, Debug)]
pub enum Never {}

impl<S> SmallSeries<S> for Never {
    fn new(_: &SecondDegree) -> Option<Self> {
        None
    }

    fn set(&mut self, _: &[S]) {
        match *self {}
    }

    fn expand(&mut self, _: &mut [S]) {
        match *self {}
    }
}

impl<const B: usize, const G: usize> Kernel<B, G> {
    fn new(degree: &SecondDegree) -> Box<Self> {
        let shuffle = |group: usize, factor: usize| -> Shuffle {
            let quantity = |lane: usize| degree.products.get(8 * group + lane).map_or(0, |factors| factors[factor]);
            std::array::from_fn(|lane| quantity(lane) as u64)
        };
        Box::new(Kernel {
            degree: degree.clone(),
            constants: [ZERO; B],
            linear: [[[ZERO; B]; 8]; B],
            weights: [[[ZERO; B]; 8]; G],
            jacobian: [[[ZERO; B]; 8]; B],
            factors: std::array::from_fn(|group| [shuffle(group, 0), shuffle(group, 1)]),
            left: [[ZERO; G]; ROOM],
            right: [[ZERO; G]; ROOM],
        })
    }

    fn set(&mut self, values: &[f64]) {
        let value = |number: u32| values.get(number as usize).copied().unwrap_or(0.0);
        for &(row, number) in &self.degree.constants {
            self.constants[row / 8].0[row % 8] = value(number);
        }
        for &(row, column, number) in &self.degree.linear {
            self.linear[column / 8][column % 8][row / 8].0[row % 8] = value(number);
        }
        for &(row, product, number) in &self.degree.quadratic {
            self.weights[product / 8][product % 8][row / 8].0[row % 8] = value(number);
        }
    }

    /// J at a point: L, and each product's weight times the one factor in the column of the other.
    #[inline(always)]
    fn linearise<P: Pick<f64>>(&mut self, point: &[[f64; 8]; B]) {
        self.jacobian = self.linear;
        for (number, &[a, b]) in self.degree.products.iter().enumerate() {
            let weight = &self.weights[number / 8 % G][number % 8];
            for (of, partner) in [(a, b), (b, a)] {
                let partner = point[partner / 8 % B][partner % 8];
                for (sum, weight) in self.jacobian[of / 8 % B][of % 8].iter_mut().zip(weight) {
                    sum.0 = add::<P, f64, 8>(sum.0, weight.0, [partner; 8]);
                }
            }
        }
    }
}

impl<const B: usize, const G: usize> Kernel<B, G> {
    /// The factors on one side of all products.
    #[inline(always)]
    fn pick<P: Pick<f64>>(&self, pick: P, side: usize, from: &[[f64; 8]; B]) -> [Wide; G] {
        let mut picked = [ZERO; G];
        for (picked, factors) in picked.iter_mut().zip(&self.factors) {
            picked.0 = pick.shuffle([&from[0], &from[B - 1]], &factors[side]);
        }
        picked
    }

    /// Takes a_k and b_k, and sums a_1 b_k + .. + a_k b_1.
    #[inline(always)]
    fn middle<P: Pick<f64>>(&mut self, pick: P, k: usize, newest: &[[f64; 8]; B]) -> [[f64; 8]; G] {
        let (a, b) = (self.pick(pick, 0, newest), self.pick(pick, 1, newest));
        // a is zero from k on: the last chains may go too far
        let middle = k.saturating_sub(2).next_multiple_of(CHAINS);
        let (a_older, b_older) = (&self.left[2..][..middle], &self.right[MOST_ORDER - k + 1..][..middle]);
        let mut chains = [[[0.0; 8]; CHAINS]; G];
        for (a, b) in a_older.as_chunks::<CHAINS>().0.iter().zip(b_older.as_chunks::<CHAINS>().0) {
            for chain in 0..CHAINS {
                for group in 0..G {
                    let sum = &mut chains[group][chain];
                    *sum = add::<P, f64, 8>(*sum, a[chain][group].0, b[chain][group].0);
                }
            }
        }
        (self.left[k], self.left[k + CHAINS], self.right[MOST_ORDER - k]) = (a, [ZERO; G], b);
        let mut sums = [[0.0; 8]; G];
        for group in 0..G {
            let [first, second] = chains[group];
            let sum = add::<P, f64, 8>(plus(first, second), a[group].0, self.right[MOST_ORDER - 1][group].0);
            sums[group] = if k > 1 { add::<P, f64, 8>(sum, self.left[1][group].0, b[group].0) } else { sum };
        }
        sums
    }
}

/// sum_c matrix_c x_c
#[inline(always)]
fn times<P: Pick<f64>, const B: usize, const C: usize>(
    matrix: &[[[Wide; B]; 8]; C],
    x: &[[f64; 8]; C],
) -> [[f64; 8]; B] {
    let mut sums = [[[0.0; 8]; 4]; B];
    for (columns, eight) in matrix.iter().zip(x) {
        for column in 0..8 {
            for block in 0..B {
                let chain = &mut sums[block][column % 4];
                *chain = add::<P, f64, 8>(*chain, columns[column][block].0, [eight[column]; 8]);
            }
        }
    }
    let mut whole = [[0.0; 8]; B];
    for block in 0..B {
        let [a, b, c, d] = sums[block];
        whole[block] = plus(plus(a, b), plus(c, d));
    }
    whole
}

#[inline(always)]
fn plus(mut a: [f64; 8], b: [f64; 8]) -> [f64; 8] {
    for lane in 0..8 {
        a[lane] += b[lane];
    }
    a
}

#[inline(always)]
fn scaled(mut a: [f64; 8], by: f64) -> [f64; 8] {
    for lane in &mut a {
        *lane *= by;
    }
    a
}

struct Expand<'a, const B: usize, const G: usize> {
    kernel: &'a mut Kernel<B, G>,
    series: &'a mut [f64],
}

impl<const B: usize, const G: usize> Task<f64> for Expand<'_, B, G> {
    #[inline(always)]
    fn run<P: Pick<f64>>(self, pick: P) {
        let Expand { kernel, series } = self;
        let (rows, _) = series.as_chunks_mut::<8>();
        let order = (rows.len() / B).saturating_sub(1).min(MOST_ORDER);
        let mut newest = [[0.0; 8]; B];
        newest.copy_from_slice(&rows[..B]);
        kernel.linearise::<P>(&newest);
        let (a, b) = (kernel.pick(pick, 0, &newest), kernel.pick(pick, 1, &newest));
        kernel.left[..=CHAINS].fill([ZERO; G]);
        kernel.right[MOST_ORDER] = b;
        let mut products = [[0.0; 8]; G];
        for group in 0..G {
            products[group] = add::<P, f64, 8>([0.0; 8], a[group].0, b[group].0);
        }
        // f(y_0) itself, then what y_0 brings to the later orders stands in J
        let linear = times::<P, B, B>(&kernel.linear, &newest);
        let mut sums = times::<P, B, G>(&kernel.weights, &products);
        for block in 0..B {
            sums[block] = plus(plus(sums[block], kernel.constants[block].0), linear[block]);
        }
        let mut rest = [[0.0; 8]; B];
        for k in 0..order {
            if k > 0 {
                sums = times::<P, B, B>(&kernel.jacobian, &newest);
                for block in 0..B {
                    sums[block] = plus(sums[block], rest[block]);
                }
                let older = kernel.middle(pick, k, &newest);
                rest = times::<P, B, G>(&kernel.weights, &older);
            }
            for block in 0..B {
                newest[block] = scaled(sums[block], RECIPROCALS[k + 1]);
                rows[(k + 1) * B + block] = newest[block];
            }
        }
    }
}
