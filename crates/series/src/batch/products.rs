//! Cauchy products, four orders at a time.
//!
//! When K = 4 q orders are known, their contributions to the orders K .. K+3 of a product are summed together: each
//! number loaded is used four times, and eight times where two products have a common factor. The contributions of the
//! four current orders are then added order by order:
//!
//!   (a b)_(K+i) = sum over 0 < j < K  +  sum_(s <= i) (a_s b_(K+i-s) + a_(K+i-s) b_s) .

use crate::plan::Product;
use field::Batch;

/// Four consecutive orders.
pub(super) type Four<const L: usize> = [Batch<L>; 4];

/// The coefficients of a quantity needed in every order: its first four, and the current four.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quantity<const L: usize> {
    pub oldest: Four<L>,
    pub newest: Four<L>,
    /// Padding: quantities at distances of powers of two would cause false address conflicts in the processor.
    _apart: Batch<L>,
}

impl<const L: usize> Quantity<L> {
    pub const ZERO: Self = {
        let zero = Batch([0.0; L]);
        Quantity { oldest: [zero; 4], newest: [zero; 4], _apart: zero }
    };
}

/// The series of all factors, one after another.
#[derive(Clone, Debug)]
pub(super) struct Histories<const L: usize> {
    pub fours: Vec<Four<L>>,
    /// The number of groups of four orders of each factor.
    pub each: usize,
}

impl<const L: usize> Histories<L> {
    /// The first groups of four orders of a factor.
    #[inline(always)]
    pub fn of(&self, slot: u16, fours: usize) -> &[Four<L>] {
        &self.fours[usize::from(slot) * self.each..][..fours]
    }
}

/// A factor: the place of the quantity, and the number of its series.
#[derive(Clone, Copy, Debug)]
pub(super) struct Factor {
    pub place: u16,
    pub slot: u16,
}

/// The products of one factor with M others, one or two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fan<const L: usize, const M: usize> {
    pub places: [u16; M],
    pub one: Factor,
    pub others: [Factor; M],
    /// The contributions of the earlier orders to the current ones.
    pub known: [Four<L>; M],
}

impl<const L: usize, const M: usize> Fan<L, M> {
    /// Sums the contributions of the first `fours` groups of orders to the next group.
    #[inline(always)]
    pub fn begin(&mut self, histories: &Histories<L>, fours: usize) {
        let one = histories.of(self.one.slot, fours);
        let [first, last] = [self.others[0], self.others[M - 1]].map(|other| histories.of(other.slot, fours));
        let mut sums = [[Batch::all(0.0); 4]; M];
        ends(&mut sums[0], one[fours - 1], first[0]);
        if M == 2 {
            ends(&mut sums[M - 1], one[fours - 1], last[0]);
        }
        for ((pair, first), last) in one.windows(2).rev().zip(&first[1..]).zip(&last[1..]) {
            middle(&mut sums[0], pair, first);
            if M == 2 {
                middle(&mut sums[M - 1], pair, last);
            }
        }
        self.known = sums;
    }

    /// The products of order I of the current group; `FIRST` for the first group.
    #[inline(always)]
    pub fn finish<const FIRST: bool, const I: usize, const N: usize>(&self, quantities: &mut [Quantity<L>; N]) {
        // all are computed before any is written, so that the common factor is loaded once
        let one = &quantities[usize::from(self.one.place) % N];
        let mut values = [Batch::all(0.0); M];
        for number in 0..M {
            let other = &quantities[usize::from(self.others[number].place) % N];
            values[number] =
                if FIRST { among::<L, I>(one, other) } else { newest::<L, I>(self.known[number][I], one, other) };
        }
        for (place, value) in self.places.iter().zip(values) {
            quantities[usize::from(*place) % N].newest[I] = value;
        }
    }
}

/// The products of the last coefficients of a with the first ones of b.
#[inline(always)]
fn ends<const L: usize>(sums: &mut Four<L>, [_, x, y, z]: Four<L>, [_, b, c, d]: Four<L>) {
    sums[0] = sums[0].plus_product(z, b, true).plus_product(y, c, true).plus_product(x, d, true);
    sums[1] = sums[1].plus_product(z, c, true).plus_product(y, d, true);
    sums[2] = sums[2].plus_product(z, d, true);
}

/// Adds a number times four numbers. This function and those below are unrolled by hand: the compiler would not unroll
/// loops, and would keep the sums in memory.
#[inline(always)]
fn add<const L: usize>(sums: &mut Four<L>, [a, b, c, d]: Four<L>, x: Batch<L>) {
    sums[0] = sums[0].plus_product(a, x, true);
    sums[1] = sums[1].plus_product(b, x, true);
    sums[2] = sums[2].plus_product(c, x, true);
    sums[3] = sums[3].plus_product(d, x, true);
}

/// The products of four numbers of b with the seven of a.
#[inline(always)]
fn middle<const L: usize>(sums: &mut Four<L>, pair: &[Four<L>], &[a, b, c, d]: &Four<L>) {
    let ([_, t, u, v], [w, x, y, z]) = (pair[0], pair[1]);
    add(sums, [w, x, y, z], a);
    add(sums, [v, w, x, y], b);
    add(sums, [u, v, w, x], c);
    add(sums, [t, u, v, w], d);
}

/// Adds the contributions of the current group to its order I, the newest last.
#[inline(always)]
fn newest<const L: usize, const I: usize>(mut sum: Batch<L>, a: &Quantity<L>, b: &Quantity<L>) -> Batch<L> {
    if I == 3 {
        sum = both(sum, a, b, 3, 0);
    }
    if I >= 2 {
        sum = both(sum, a, b, 2, I - 2);
    }
    if I >= 1 {
        sum = both(sum, a, b, 1, I - 1);
    }
    both(sum, a, b, 0, I)
}

#[inline(always)]
fn both<const L: usize>(sum: Batch<L>, a: &Quantity<L>, b: &Quantity<L>, old: usize, new: usize) -> Batch<L> {
    sum.plus_product(a.oldest[old], b.newest[new], true).plus_product(a.newest[new], b.oldest[old], true)
}

/// The sum of a_j b_(I-j) within the first group, the newest last.
#[inline(always)]
fn among<const L: usize, const I: usize>(a: &Quantity<L>, b: &Quantity<L>) -> Batch<L> {
    let (a, b) = (&a.newest, &b.newest);
    let mut sum = Batch::all(0.0);
    if I >= 2 {
        sum = sum.plus_product(a[1], b[I - 1], true);
    }
    if I == 3 {
        sum = sum.plus_product(a[2], b[1], true);
    }
    sum = sum.plus_product(a[0], b[I], true);
    if I >= 1 { sum.plus_product(a[I], b[0], true) } else { sum }
}

/// Pairs products with a common factor, as many as possible, and returns the rest. The product with the fewest partners
/// chooses first.
pub(super) fn paired(products: &[Product]) -> (Vec<[Product; 2]>, Vec<Product>) {
    let shares = |p: &Product, q: &Product| p.a == q.a || p.a == q.b || p.b == q.a || p.b == q.b;
    let (mut left, mut pairs, mut alone) = (products.to_vec(), Vec::new(), Vec::new());
    while !left.is_empty() {
        let partners = |p: &Product| left.iter().filter(|q| q.place != p.place && shares(p, q)).count();
        let fewest = |among: &mut dyn Iterator<Item = usize>| among.min_by_key(|&number| partners(&left[number]));
        let Some(first) = fewest(&mut (0..left.len())) else { break };
        let second = fewest(&mut (0..left.len()).filter(|&each| each != first && shares(&left[first], &left[each])));
        match second {
            Some(second) => {
                pairs.push([left[first], left[second]]);
                left.remove(first.max(second));
                left.remove(first.min(second));
            }
            None => alone.push(left.remove(first)),
        }
    }
    (pairs, alone)
}
