//! Taylor series of the solutions of y' = f(y, ...), coefficient by coefficient through the operations of the tape.
//!
//! With x(t) = sum x_k t^k, (a b)_k = sum a_j b_(k-j); a quotient q = a/b solves (q b)_k = a_k for q_k, a root r solves
//! (r r)_k = a_k, and cosine and sine follow from c' = -a' s, s' = a' c. All coefficients to order N cost O(N^2) per
//! operation.

use super::{Operation, Tape};
use crate::evaluate::constant;
use field::{Analytic, Tangent};
use std::fmt;

/// A tape that is not the right side of a differential equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IllPosed {
    pub inputs: usize,
    pub outputs: usize,
}

impl fmt::Display for IllPosed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let IllPosed { inputs, outputs } = self;
        write!(f, "{outputs} rates for {inputs} inputs: the state must come first among the inputs, one rate to each")
    }
}

impl std::error::Error for IllPosed {}

/// A tape with room for the series of all its registers.
#[derive(Clone, Debug)]
pub struct Series<'a, S> {
    tape: &'a Tape,
    order: usize,
    /// The coefficients of one register after those of another.
    coefficients: Vec<S>,
    /// 0, 1, 2, ... as far as needed.
    numbers: Vec<S>,
}

impl Tape {
    /// Readies the tape for series to the given order. Its first inputs are the state, in the order of the outputs,
    /// which are the state's rates; further inputs are time and parameters.
    ///
    /// # Errors
    /// [`IllPosed`] where there are more outputs than inputs.
    pub fn series<S: Analytic>(&self, order: usize) -> Result<Series<'_, S>, IllPosed> {
        if self.outputs.len() > self.inputs {
            return Err(IllPosed { inputs: self.inputs, outputs: self.outputs.len() });
        }
        let stride = order + 1;
        let mut coefficients = vec![S::zero(); self.registers * stride];
        for (number, value) in self.constants.iter().enumerate() {
            coefficients[(self.inputs + number) * stride] = constant(*value);
        }
        let numbers = (0..=stride as i64).map(S::int).collect();
        Ok(Series { tape: self, order, coefficients, numbers })
    }
}

impl<S: Analytic> Series<'_, S> {
    /// The order of the last coefficient.
    pub fn order(&self) -> usize {
        self.order
    }

    /// The Taylor coefficients of the solution through `state`, those of order k at `out[k * n .. (k + 1) * n]`. The
    /// `others` are the inputs after the state: time as `Tangent::variable(t)`, a parameter as `Tangent::fixed(p)`.
    /// Numbers that are missing are taken as zero, and as many coefficients are written as there is room for.
    pub fn expand(&mut self, state: &[S], others: &[Tangent<S>], out: &mut [S]) {
        let (size, stride) = (self.tape.outputs.len(), self.order + 1);
        for input in 0..self.tape.inputs {
            let other = input.checked_sub(size).and_then(|place| others.get(place)).copied();
            let start = match other {
                _ if input < size => Tangent::fixed(state.get(input).copied().unwrap_or(S::zero())),
                Some(moving) => moving,
                None => Tangent::fixed(S::zero()),
            };
            let series = &mut self.coefficients[input * stride..(input + 1) * stride];
            series.fill(S::zero());
            series[0] = start.value;
            if let Some(slope) = series.get_mut(1) {
                *slope = start.slope;
            }
        }
        for k in 0..self.order {
            self.advance(k);
            for (input, &rate) in self.tape.outputs.iter().enumerate() {
                self.coefficients[input * stride + k + 1] =
                    self.coefficients[rate as usize * stride + k] / self.numbers[k + 1];
            }
        }
        for (place, coefficient) in out.iter_mut().enumerate().take(size * stride) {
            *coefficient = self.coefficients[(place % size) * stride + place / size];
        }
    }

    /// The coefficients of order k of all results.
    fn advance(&mut self, k: usize) {
        let stride = self.order + 1;
        let mut next = self.tape.inputs + self.tape.constants.len();
        for &operation in &self.tape.operations {
            // Results come after their operands.
            let (before, after) = self.coefficients.split_at_mut(next * stride);
            let [a, b] = operation.operands().map(|operand| &before[operand as usize * stride..][..stride]);
            let (result, second) = after.split_at_mut(stride);
            match operation {
                Operation::Sum(..) => result[k] = a[k] + b[k],
                Operation::Difference(..) => result[k] = a[k] - b[k],
                Operation::Product(p, q) if p == q => result[k] = square(a, k),
                Operation::Product(..) => result[k] = convolution(&a[..=k], &b[..=k]),
                Operation::Multiple(..) => result[k] = a[0] * b[k],
                Operation::Quotient(..) => {
                    let known = if k == 0 { S::zero() } else { convolution(&result[..k], &b[1..=k]) };
                    result[k] = (a[k] - known) / b[0];
                }
                Operation::Part(..) => result[k] = a[k] / b[0],
                Operation::Negation(_) => result[k] = -a[k],
                Operation::Root(_) if k == 0 => result[0] = a[0].sqrt(),
                Operation::Root(_) => {
                    let known = if k == 1 { S::zero() } else { convolution(&result[1..k], &result[1..k]) };
                    result[k] = (a[k] - known) / (result[0] + result[0]);
                }
                Operation::Circle(_) if k == 0 => {
                    let point = a[0].circle();
                    (result[0], second[0]) = (point.cos, point.sin);
                }
                Operation::Circle(_) => {
                    let (mut cos, mut sin) = (S::zero(), S::zero());
                    for j in 1..=k {
                        let rate = self.numbers[j] * a[j];
                        cos -= rate * second[k - j];
                        sin += rate * result[k - j];
                    }
                    (result[k], second[k]) = (cos / self.numbers[k], sin / self.numbers[k]);
                }
            }
            next += operation.results();
        }
    }
}

/// sum a_j b_(n-j) over two series of equal length.
#[inline]
fn convolution<S: Analytic>(a: &[S], b: &[S]) -> S {
    a.iter().zip(b.iter().rev()).fold(S::zero(), |sum, (&p, &q)| sum + p * q)
}

/// The coefficient of order k of a square: every mixed product occurs twice.
#[inline]
fn square<S: Analytic>(a: &[S], k: usize) -> S {
    let half = k.div_ceil(2);
    let mixed = a[..half].iter().zip(a[..=k].iter().rev()).fold(S::zero(), |sum, (&p, &q)| sum + p * q);
    let double = mixed + mixed;
    if k.is_multiple_of(2) { double + a[k / 2] * a[k / 2] } else { double }
}
