//! All Taylor coefficients of a solution, order by order.

use super::fused::{Fused, Task};
use super::layout::{MOST, width};
use super::pick::{OneByOne, Pick};
use super::plan::Plan;
use super::small::{MOST_ORDER, SmallSeries};
use super::stages::{Expand, Stages};
use super::sum::{Sum, Terms, copy};
use super::{Recurrence, Reduced};
use symbolic::{Program, Tape};

/// A recurrence over a scalar type, with buffers for the series of all its quantities: an expansion allocates nothing.
///
/// `W` quantities are computed together: 8 `f64` fill the widest registers; a type that fills a register takes 1. `N`
/// is a power of two above the number of columns, so that indices need no check. The construction takes as long as a
/// few steps, so that an expansion should be reused between runs.
#[derive(Clone, Debug)]
pub struct Expansion<S: Fused, const W: usize, const N: usize = 256> {
    order: usize,
    states: usize,
    time: bool,
    way: Way<S, W, N>,
    /// The coefficients of all orders of the quantities with a rate; `width` is the length of one order.
    series: Vec<S>,
    /// Coefficients up to this order have the full precision of the type.
    fine: usize,
    width: usize,
    points: Program<'static, S>,
    coefficients: Program<'static, S>,
    /// Buffer for the coefficients of the sums.
    values: Vec<S>,
}

/// The implementation of the orders.
#[derive(Clone, Debug)]
enum Way<S: Fused, const W: usize, const N: usize> {
    Stages(Stages<S, W, N>),
    Small(S::Small),
}

impl Recurrence {
    /// Prepares the recurrence for series of the given order with these parameters; `None` where it has more than `N`
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
        let (way, moving, coefficients, count) = match small {
            Some((Reduced { law, coefficients }, series)) => {
                (Way::Small(series), law.quantities(), coefficients, law.coefficients)
            }
            None => {
                let stages = Stages::new(&self.plan, order);
                let Plan { moving, coefficients, .. } = self.plan;
                (Way::Stages(stages), moving, &self.coefficients, coefficients)
            }
        };
        let width = moving.next_multiple_of(W);
        let mut expansion = Expansion {
            order,
            states: self.plan.states,
            time: self.plan.time,
            way,
            series: vec![S::zero(); width * (order + 1)],
            fine: order,
            width,
            points: program(&self.points),
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
    /// The order of the series.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Sets the parameters.
    pub fn set_parameters(&mut self, parameters: &[S]) {
        // the program of the circle points reads them
        let moving = self.states + usize::from(self.time);
        let inputs: Vec<S> = std::iter::repeat_n(S::zero(), moving).chain(parameters.iter().copied()).collect();
        self.points.evaluate(&inputs, &mut []);
        self.coefficients.evaluate(parameters, &mut self.values);
        match &mut self.way {
            Way::Stages(stages) => stages.set(&self.values),
            Way::Small(small) => small.set(&self.values),
        }
    }

    /// Computes the Taylor coefficients of the solution through `state` at `time`.
    pub fn expand(&mut self, state: &[S], time: S) {
        self.expand_rounding(state, time, self.order);
    }

    /// As [`expand`](Self::expand), but coefficients above the order `fine` >= 1 need only the digits of `f64`. Returns
    /// the order up to which the coefficients have full precision.
    pub fn expand_rounding(&mut self, state: &[S], time: S, fine: usize) -> usize {
        let n = self.states.min(state.len());
        copy::<S, W>(&state[..n], &mut self.series);
        let mut moving = self.states;
        if self.time {
            self.series[moving] = time;
            moving += 1;
        }
        let (known, values) = self.series.split_at_mut(moving);
        let points = Points { program: &mut self.points, known, values };
        if S::FINER {
            S::run(points, W)
        } else {
            points.run(OneByOne::<false>)
        }
        let Expansion { order, series, width, .. } = self;
        let fine = if S::FINER { fine.clamp(1, *order) } else { *order };
        match &mut self.way {
            Way::Stages(stages) => S::run(Expand { stages, series, width: *width, fine }, W),
            Way::Small(small) => small.expand(series, fine),
        }
        self.fine = fine;
        fine
    }

    /// The Taylor coefficients a_k of the states.
    #[inline]
    pub fn coefficients(&self, k: usize) -> &[S] {
        &self.series[k * self.width..][..self.states]
    }

    /// Evaluates the series at h, by Horner's scheme.
    #[inline]
    pub fn sum(&self, h: S, out: &mut [S]) {
        let Expansion { series, width, states, order, fine, .. } = self;
        let terms = Terms { series, width: *width, states: *states, order: *order, fine: *fine };
        S::run(Sum::<S, W> { terms, h, out }, W);
    }
}

/// The circle points at the start. In double-double their products use fused multiply-add, where the processor has it.
struct Points<'a, S> {
    program: &'a mut Program<'static, S>,
    known: &'a [S],
    values: &'a mut [S],
}

impl<S: Fused> Task<S> for Points<'_, S> {
    #[inline(always)]
    fn run<P: Pick<S> + Pick<f64>>(self, _pick: P) {
        self.program.evaluate(self.known, self.values);
    }
}

/// The group size of the small series.
const GROUP: usize = 8;
