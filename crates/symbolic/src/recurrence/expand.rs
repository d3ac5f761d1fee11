//! All coefficients of a solution's series, order by order.

use super::Recurrence;
#[cfg(target_arch = "x86_64")]
use super::pick::Permuting;
use super::pick::{Columns, OneByOne, Pick};
use super::layout::{Block, CHAINS, Group, Implicit, Laid, Lanes, Layout, MOST, Rows, width};
use crate::tape::Program;
use field::{Analytic, DoubleDouble};

/// A field with a product added to a sum as fast as the processor can.
pub trait Fused: Analytic {
    /// self + a b, rounded once or twice.
    #[inline(always)]
    fn plus_product(self, a: Self, b: Self, _fused: bool) -> Self {
        self + a * b
    }

    /// Runs the orders from `first` to the last, with the widest instructions that there are.
    #[inline]
    fn run<const W: usize, const N: usize>(expansion: &mut Expansion<'_, Self, W, N>) {
        expansion.run(OneByOne::<false>);
    }
}

impl Fused for DoubleDouble {}

impl Fused for f64 {
    #[inline(always)]
    fn plus_product(self, a: Self, b: Self, fused: bool) -> Self {
        if fused { a.mul_add(b, self) } else { self + a * b }
    }

    #[inline]
    fn run<const W: usize, const N: usize>(expansion: &mut Expansion<'_, Self, W, N>) {
        #[cfg(target_arch = "x86_64")]
        if W == 8
            && N >= 8
            && let Some(widest) = pulp::x86::V4::try_new()
        {
            return pulp::Simd::vectorize(widest, Run(expansion, Permuting(widest)));
        }
        match pulp::Arch::new() {
            pulp::Arch::Scalar => expansion.run(OneByOne::<false>),
            wide => wide.dispatch(Run(expansion, OneByOne::<true>)),
        }
    }
}

/// Compiled once for each set of instructions.
struct Run<'a, 'b, P, const W: usize, const N: usize>(&'a mut Expansion<'b, f64, W, N>, P);

impl<P: Pick<f64>, const W: usize, const N: usize> pulp::WithSimd for Run<'_, '_, P, W, N> {
    type Output = ();

    #[inline(always)]
    fn with_simd<I: pulp::Simd>(self, _: I) {
        self.0.run(self.1);
    }
}

/// A recurrence over a field, with room for the series of all its quantities: expanding allocates nothing.
///
/// `W` quantities are computed side by side: 8 fill the widest registers of today with `f64`; for a field that is wide
/// itself, 1. `N` is a power of two above the number of columns, so that no index needs a check.
#[derive(Clone, Debug)]
pub struct Expansion<'a, S, const W: usize, const N: usize = 256> {
    order: usize,
    states: usize,
    time: bool,
    layout: Layout<S, W>,
    /// The coefficients of the order at hand of all quantities, by column.
    now: Box<Columns<S, N>>,
    /// The coefficients of all orders of what has a rate; so long is one order.
    series: Vec<S>,
    width: usize,
    /// 1/k
    reciprocals: Vec<S>,
    points: Program<'a, S>,
    inputs: Vec<S>,
    circle: Vec<S>,
    coefficients: Program<'a, S>,
}

impl Recurrence {
    /// Readies the recurrence for series to the given order at these parameters; `None` where it has more than `N`
    /// columns.
    pub fn expansion<S: Fused, const W: usize, const N: usize>(
        &self,
        parameters: &[S],
        order: usize,
    ) -> Option<Expansion<'_, S, W, N>> {
        const { assert!(N.is_power_of_two() && N <= MOST) };
        if width(&self.plan, W) > N {
            return None;
        }
        let layout = Layout::new(&self.plan, order);
        let inputs = self.plan.states + usize::from(self.plan.time);
        let width = self.plan.moving.next_multiple_of(W);
        let mut expansion = Expansion {
            order,
            states: self.plan.states,
            time: self.plan.time,
            layout,
            now: Box::new(Columns([S::zero(); N])),
            series: vec![S::zero(); width * (order + 1)],
            width,
            reciprocals: std::iter::once(S::zero()).chain((1..=order as i64 + 1).map(|k| S::ratio(1, k))).collect(),
            points: self.points.over(),
            inputs: vec![S::zero(); inputs + parameters.len()],
            circle: vec![S::zero(); self.plan.moving - inputs],
            coefficients: self.coefficients.over(),
        };
        expansion.set_parameters(parameters);
        Some(expansion)
    }
}

impl<S: Fused, const W: usize, const N: usize> Expansion<'_, S, W, N> {
    /// The order of the last coefficient.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Takes other values of the parameters.
    pub fn set_parameters(&mut self, parameters: &[S]) {
        let first = self.states + usize::from(self.time);
        for (input, value) in self.inputs[first..].iter_mut().zip(parameters) {
            *input = *value;
        }
        let mut values = vec![S::zero(); self.layout.coefficients];
        self.coefficients.evaluate(parameters, &mut values);
        self.layout.set(&values);
    }

    /// Expands the solution through `state` at `time`.
    pub fn expand(&mut self, state: &[S], time: S) {
        let n = self.states.min(state.len());
        self.inputs[..n].copy_from_slice(&state[..n]);
        let mut moving = self.states;
        if self.time {
            self.inputs[moving] = time;
            moving += 1;
        }
        self.series[..moving].copy_from_slice(&self.inputs[..moving]);
        if !self.circle.is_empty() {
            self.points.evaluate(&self.inputs, &mut self.circle);
            self.series[moving..moving + self.circle.len()].copy_from_slice(&self.circle);
        }
        S::run(self);
    }

    /// The coefficients a_k of the states.
    #[inline]
    pub fn coefficients(&self, k: usize) -> &[S] {
        &self.series[k * self.width..][..self.states]
    }

    #[inline(always)]
    fn run<P: Pick<S>>(&mut self, pick: P) {
        let Expansion { order, layout, now, series, width, reciprocals, .. } = self;
        let (order, now) = (*order, &mut **now);
        for group in layout.stages.iter_mut().flat_map(|stage| &mut stage.groups) {
            group.left[..CHAINS].fill(Lanes::zero());
        }
        now.0[..*width].copy_from_slice(&series[..*width]);
        for k in 0..order {
            for stage in &mut layout.stages {
                let Rows { first, blocks } = &stage.sums;
                for (place, block) in blocks.iter().enumerate() {
                    let sum = block.sums::<P, N>(k, now);
                    now.0[first + place * W..][..W].copy_from_slice(&sum);
                }
                for group in &mut stage.groups {
                    let products = group.products(pick, k, order, now);
                    now.0[group.first..][..W].copy_from_slice(&products);
                }
                if stage.has_implicit {
                    stage.implicit(k, &mut now.0);
                }
            }
            // x_(k+1) = (x')_k / (k + 1); all rates before the first of them is overwritten
            let next = &mut series[(k + 1) * *width..][..*width];
            for (block, next) in layout.rates.blocks.iter().zip(next.chunks_exact_mut(W)) {
                let mut sum = block.sums::<P, N>(k, now);
                for rate in &mut sum {
                    *rate *= reciprocals[k + 1];
                }
                next.copy_from_slice(&sum);
            }
            for (now, next) in now.0.chunks_exact_mut(W).zip(next.chunks_exact(W)) {
                now.copy_from_slice(next);
            }
        }
    }
}

#[inline(always)]
fn add<P: Pick<S>, S: Fused, const W: usize>(mut sum: [S; W], a: [S; W], b: [S; W]) -> [S; W] {
    for lane in 0..W {
        sum[lane] = sum[lane].plus_product(a[lane], b[lane], P::FUSED);
    }
    sum
}

#[inline(always)]
fn together<S: Fused, const W: usize>([mut a, b, mut c, d]: [[S; W]; CHAINS]) -> [S; W] {
    for lane in 0..W {
        a[lane] += b[lane];
        c[lane] += d[lane];
        a[lane] += c[lane];
    }
    a
}

impl<S: Fused, const W: usize> Block<S, W> {
    /// The sums in order k.
    #[inline(always)]
    fn sums<P: Pick<S>, const N: usize>(&self, k: usize, now: &Columns<S, N>) -> [S; W] {
        let mut sums = [[S::zero(); W]; CHAINS];
        if k == 0 {
            sums[0] = self.constants.0;
        }
        for (columns, factors) in self.columns.iter().zip(&self.factors) {
            for chain in 0..CHAINS {
                let x = now.0[columns[chain] as usize % N];
                sums[chain] = add::<P, S, W>(sums[chain], factors[chain].0, [x; W]);
            }
        }
        together(sums)
    }
}

impl<S: Fused, const W: usize> Group<S, W> {
    /// sum_j a_j b_(k-j) with a_k and b_k from the columns: what is older is summed without waiting for them.
    #[inline(always)]
    fn products<P: Pick<S>, const N: usize>(
        &mut self,
        pick: P,
        k: usize,
        order: usize,
        now: &Columns<S, N>,
    ) -> [S; W] {
        let [a, b] = &self.factors;
        let (newest_a, newest_b) = (pick.pick(now, a), pick.pick(now, b));
        let (left, right) = (&mut self.left[..], &mut self.right[order - k..]);
        // a is zero from k on, b behind its end: the last chains may go too far
        let middle = k.saturating_sub(1).next_multiple_of(CHAINS);
        let mut sums = [[S::zero(); W]; CHAINS];
        for (a, b) in left[1..=middle].chunks_exact(CHAINS).zip(right[1..=middle].chunks_exact(CHAINS)) {
            for chain in 0..CHAINS {
                sums[chain] = add::<P, S, W>(sums[chain], a[chain].0, b[chain].0);
            }
        }
        let mut sum = together(sums);
        left[k + CHAINS] = Lanes::zero();
        (left[k], right[0]) = (Lanes(newest_a), Lanes(newest_b));
        if k > 0 {
            sum = add::<P, S, W>(sum, left[0].0, newest_b);
        }
        add::<P, S, W>(sum, newest_a, right[k].0)
    }
}

impl<S: Analytic, const W: usize> Laid<S, W> {
    /// Rare, and kept out of the loop over the orders, which is short without it.
    #[inline(never)]
    fn implicit(&mut self, k: usize, now: &mut [S]) {
        self.reciprocals.iter_mut().for_each(|each| each.reciprocal(k, now));
        self.roots.iter_mut().for_each(|each| each.root(k, now));
    }
}

impl<S: Analytic> Implicit<S> {
    /// r_k from (r b)_k = 0, and r_0 = 1 / b_0.
    fn reciprocal(&mut self, k: usize, now: &mut [S]) {
        let newest = now[self.of];
        self.series[k][1] = newest;
        let result = if k == 0 {
            S::one() / newest
        } else {
            let pairs = self.series[..k].iter().zip(self.series[1..=k].iter().rev());
            -pairs.fold(S::zero(), |sum, (r, b)| sum + r[0] * b[1]) * self.series[0][0]
        };
        self.series[k][0] = result;
        now[self.column] = result;
    }

    /// r_k from (r r)_k = a_k, and r_0 the non-negative root of a_0.
    fn root(&mut self, k: usize, now: &mut [S]) {
        let newest = now[self.of];
        let result = if k == 0 {
            newest.sqrt()
        } else {
            let pairs = self.series[1..k].iter().zip(self.series[1..k].iter().rev());
            let known = pairs.fold(S::zero(), |sum, (p, q)| sum + p[0] * q[0]);
            (newest - known) / (self.series[0][0] + self.series[0][0])
        };
        self.series[k][0] = result;
        now[self.column] = result;
    }
}
