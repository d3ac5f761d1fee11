//! All coefficients of a solution's series, order by order.

use super::fused::{Fused, Task};
use super::layout::{CHAINS, Lanes, Layout, MOST, Rows, width};
use super::order::add;
use super::pick::{Columns, Pick};
use super::plan::Plan;
use super::small::{MOST_ORDER, SmallSeries};
use super::{Recurrence, Reduced};
use crate::tape::{Program, Tape};

/// A recurrence over a field, with room for the series of all its quantities: expanding allocates nothing.
///
/// `W` quantities are computed side by side: 8 fill the widest registers of today with `f64`; for a field that is wide
/// itself, 1. `N` is a power of two above the number of columns, so that no index needs a check. To lay one out takes as
/// long as a few steps, so an expansion is to be kept from run to run.
#[derive(Clone, Debug)]
pub struct Expansion<S: Fused, const W: usize, const N: usize = 256> {
    order: usize,
    states: usize,
    time: bool,
    way: Way<S, W, N>,
    /// The coefficients of all orders of what has a rate; so long is one order.
    series: Vec<S>,
    width: usize,
    /// 1/k
    reciprocals: Vec<S>,
    points: Program<'static, S>,
    coefficients: Program<'static, S>,
    /// Room for the values of the coefficients.
    values: Vec<S>,
}

/// How the orders are found.
#[derive(Clone, Debug)]
enum Way<S: Fused, const W: usize, const N: usize> {
    Stages(Stages<S, W, N>),
    Small(S::Small),
}

/// By stages of sums and products.
#[derive(Clone, Debug)]
struct Stages<S, const W: usize, const N: usize> {
    layout: Layout<S, W>,
    /// The coefficients of the order at hand of all quantities, by column.
    now: Box<Columns<S, N>>,
    /// Room for the next order: so the rates of this one need not wait for each other.
    then: Box<Columns<S, N>>,
}

impl Recurrence {
    /// Readies the recurrence for series to the given order at these parameters; `None` where it has more than `N`
    /// columns.
    pub fn expansion<S: Fused, const W: usize, const N: usize>(
        &self,
        parameters: &[S],
        order: usize,
    ) -> Option<Expansion<S, W, N>> {
        const { assert!(N.is_power_of_two() && N <= MOST) };
        if width(&self.plan, W) > N {
            return None;
        }
        let small = self.small.as_ref().filter(|_| W == GROUP && (2..=MOST_ORDER).contains(&order));
        let small = small.and_then(|small| Some((small, S::Small::new(&small.law)?)));
        let (way, moving, points, coefficients, count) = match small {
            Some((small, series)) => {
                let Reduced { law, coefficients, points } = small;
                (Way::Small(series), law.quantities(), points, coefficients, law.coefficients)
            }
            None => {
                let [now, then] = [(); 2].map(|()| Box::new(Columns([S::zero(); N])));
                let stages = Stages { layout: Layout::new(&self.plan, order), now, then };
                let Plan { moving, coefficients, .. } = self.plan;
                (Way::Stages(stages), moving, &self.points, &self.coefficients, coefficients)
            }
        };
        let width = moving.next_multiple_of(W);
        let mut expansion = Expansion {
            order,
            states: self.plan.states,
            time: self.plan.time,
            way,
            series: vec![S::zero(); width * (order + 1)],
            width,
            reciprocals: std::iter::once(S::zero()).chain((1..=order as i64 + 1).map(|k| S::ratio(1, k))).collect(),
            points: program(points),
            coefficients: program(coefficients),
            values: vec![S::zero(); count],
        };
        expansion.set_parameters(parameters);
        Some(expansion)
    }
}

fn program<S: Fused>(tape: &Tape) -> Program<'static, S> {
    if S::FINER { tape.over().kept() } else { tape.over_rounded().kept() }
}

impl<S: Fused, const W: usize, const N: usize> Expansion<S, W, N> {
    /// The order of the last coefficient.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Takes other values of the parameters.
    pub fn set_parameters(&mut self, parameters: &[S]) {
        // the points' program keeps them
        let moving = self.states + usize::from(self.time);
        let inputs: Vec<S> = std::iter::repeat_n(S::zero(), moving).chain(parameters.iter().copied()).collect();
        self.points.evaluate(&inputs, &mut []);
        self.coefficients.evaluate(parameters, &mut self.values);
        match &mut self.way {
            Way::Stages(stages) => stages.layout.set(&self.values),
            Way::Small(small) => small.set(&self.values),
        }
    }

    /// Expands the solution through `state` at `time`.
    pub fn expand(&mut self, state: &[S], time: S) {
        let n = self.states.min(state.len());
        copy::<S, W>(&state[..n], &mut self.series);
        let mut moving = self.states;
        if self.time {
            self.series[moving] = time;
            moving += 1;
        }
        let (known, points) = self.series.split_at_mut(moving);
        self.points.evaluate(known, points);
        let Expansion { order, series, width, reciprocals, .. } = self;
        match &mut self.way {
            Way::Stages(stages) => S::run(Expand { stages, order: *order, series, width: *width, reciprocals }, W),
            Way::Small(small) => small.expand(series),
        }
    }

    /// The coefficients a_k of the states.
    #[inline]
    pub fn coefficients(&self, k: usize) -> &[S] {
        &self.series[k * self.width..][..self.states]
    }

    /// The sum of the series at h, by Horner's scheme.
    #[inline]
    pub fn sum(&self, h: S, out: &mut [S]) {
        S::run(Sum { expansion: self, h, out }, W);
    }
}

/// A few numbers: to call what copies memory would take longer than this.
#[inline(always)]
fn copy<S: Copy, const W: usize>(from: &[S], to: &mut [S]) {
    for (to, from) in to.chunks_mut(W).zip(from.chunks(W)) {
        match (<&mut [S; W]>::try_from(&mut *to), <&[S; W]>::try_from(from)) {
            (Ok(to), Ok(from)) => *to = *from,
            _ => {
                let few = to.len().min(from.len());
                for lane in 0..W {
                    if lane < few {
                        to[lane] = from[lane];
                    }
                }
            }
        }
    }
}

/// So wide is a group in the small series.
const GROUP: usize = 8;

struct Expand<'a, S, const W: usize, const N: usize> {
    stages: &'a mut Stages<S, W, N>,
    order: usize,
    series: &'a mut [S],
    width: usize,
    reciprocals: &'a [S],
}

impl<S: Fused, const W: usize, const N: usize> Task<S> for Expand<'_, S, W, N> {
    #[inline(always)]
    fn run<P: Pick<S>>(self, pick: P) {
        let Expand { stages: Stages { layout, now, then }, order, series, width, reciprocals } = self;
        let (mut now, mut then) = (&mut **now, &mut **then);
        for group in layout.stages.iter_mut().flat_map(|stage| &mut stage.groups) {
            group.left[..CHAINS].fill(Lanes::zero());
        }
        for (now, first) in now.0.chunks_exact_mut(W).zip(series[..width].chunks_exact(W)) {
            now.copy_from_slice(first);
        }
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
            // x_(k+1) = (x')_k / (k + 1)
            let (next, reciprocal) = (&mut series[(k + 1) * width..][..width], reciprocals[k + 1]);
            let rows = then.0.chunks_exact_mut(W).zip(next.chunks_exact_mut(W));
            for (block, (then, next)) in layout.rates.blocks.iter().zip(rows) {
                let mut sum = block.sums::<P, N>(k, now);
                for rate in &mut sum {
                    *rate *= reciprocal;
                }
                then.copy_from_slice(&sum);
                next.copy_from_slice(&sum);
            }
            std::mem::swap(&mut now, &mut then);
        }
    }
}

struct Sum<'a, S: Fused, const W: usize, const N: usize> {
    expansion: &'a Expansion<S, W, N>,
    h: S,
    out: &'a mut [S],
}

/// Every so many terms are summed by themselves: Horner's scheme waits for each of its steps.
const APART: usize = 4;

impl<S: Fused, const W: usize, const N: usize> Task<S> for Sum<'_, S, W, N> {
    #[inline(always)]
    fn run<P: Pick<S>>(self, _: P) {
        let Expansion { series, width, states, .. } = self.expansion;
        let h = self.h;
        let square = h * h;
        let [h, square, fourth] = [h, square, square * square].map(|power| [power; W]);
        let (terms, over) = (self.expansion.order + 1, (self.expansion.order + 1) % APART);
        for (first, out) in (0..*states).step_by(W).zip(self.out.chunks_mut(W)) {
            let term = |k: usize| -> [S; W] {
                let mut term = [S::zero(); W];
                term.copy_from_slice(&series[k * width + first..][..W]);
                term
            };
            let mut sums = [[S::zero(); W]; APART];
            for (chain, sum) in sums.iter_mut().enumerate() {
                if chain < over {
                    *sum = term(terms - over + chain);
                }
            }
            for four in (0..terms / APART).rev() {
                for (chain, sum) in sums.iter_mut().enumerate() {
                    *sum = add::<P, S, W>(term(four * APART + chain), *sum, fourth);
                }
            }
            let [even, odd, more, most] = sums;
            let (low, high) = (add::<P, S, W>(even, odd, h), add::<P, S, W>(more, most, h));
            let sum = add::<P, S, W>(low, high, square);
            copy::<S, W>(&sum, out);
        }
    }
}
