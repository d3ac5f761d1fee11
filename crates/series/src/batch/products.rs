//! Products, four orders at a time.
//!
//! When K orders are known, K = 4 q, their contributions to the orders K .. K+3 of a product are summed in one go: each
//! number loaded is used four times, and eight times where two products have a factor in common. Contributions of the orders
//! at hand are added order by order, from numbers that lie beside each other:
//!
//!   (a b)_(K+i) = sum over 0 < j < K  +  sum_(s <= i) (a_s b_(K+i-s) + a_(K+i-s) b_s) .

use crate::plan::Product;
use field::Batch;

/// Four orders in a row.
pub(super) type Four<const L: usize> = [Batch<L>; 4];

/// The coefficients of a quantity that every order needs: its first four, and the four at hand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quantity<const L: usize> {
    pub oldest: Four<L>,
    pub newest: Four<L>,
    /// Padding, for quantities must not lie powers of two apart: a processor takes addresses with equal last digits for
    /// equal, and waits.
    _apart: Batch<L>,
}

impl<const L: usize> Quantity<L> {
    pub const ZERO: Self = {
        let zero = Batch([0.0; L]);
        Quantity { oldest: [zero; 4], newest: [zero; 4], _apart: zero }
    };
}

/// The series of all factors, one after the other.
#[derive(Clone, Debug)]
pub(super) struct Histories<const L: usize> {
    pub fours: Vec<Four<L>>,
    /// The number of fours of each factor.
    pub each: usize,
}

impl<const L: usize> Histories<L> {
    /// The first fours of a factor.
    #[inline(always)]
    pub fn of(&self, slot: u16, fours: usize) -> &[Four<L>] {
        &self.fours[usize::from(slot) * self.each..][..fours]
    }
}

/// A factor: the quantity, and the place of its series.
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
    /// The contributions of the earlier orders to those at hand.
    pub known: [Four<L>; M],
}

impl<const L: usize, const M: usize> Fan<L, M> {
    /// Sums the contributions of the first orders, so many fours of them, to the next four.
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

    /// The products of an order, the I-th of those at hand; `FIRST` where these are the first four.
    #[inline(always)]
    pub fn finish<const FIRST: bool, const I: usize, const N: usize>(&self, quantities: &mut [Quantity<L>; N]) {
        // all are computed before one is written: the common factor is loaded once
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

/// One number with four. Written out, as are the functions below: as loops these would not be unrolled, and the sums not
/// kept in registers.
#[inline(always)]
fn add<const L: usize>(sums: &mut Four<L>, [a, b, c, d]: Four<L>, x: Batch<L>) {
    sums[0] = sums[0].plus_product(a, x, true);
    sums[1] = sums[1].plus_product(b, x, true);
    sums[2] = sums[2].plus_product(c, x, true);
    sums[3] = sums[3].plus_product(d, x, true);
}

/// Four numbers of b with the seven of a that they meet.
#[inline(always)]
fn middle<const L: usize>(sums: &mut Four<L>, pair: &[Four<L>], &[a, b, c, d]: &Four<L>) {
    let ([_, t, u, v], [w, x, y, z]) = (pair[0], pair[1]);
    add(sums, [w, x, y, z], a);
    add(sums, [v, w, x, y], b);
    add(sums, [u, v, w, x], c);
    add(sums, [t, u, v, w], d);
}

/// Adds the contributions of the orders at hand to the I-th of them, the newest last.
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

/// sum_j a_j b_(I-j), the newest last.
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

/// Two products that have a factor in common, as many as there are, and those that are left. The product that has the fewest
/// partners chooses first.
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
