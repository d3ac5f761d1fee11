//! Expressions as straight-line programs.

mod algebraic;
mod arranged;
mod divisors;
mod factors;
mod fused;
mod propagation;
mod record;
mod run;
mod source;
mod time_parts;

pub use algebraic::Algebraic;
pub use propagation::Propagation;
pub use record::Untapeable;
pub use run::Program;
pub use source::{Language, Source, Statements};

use field::{Elementary, Rational, Scalar};

/// A straight-line program without branches that computes the values of expressions. Every common subexpression is computed once.
///
/// A tape does not refer to the expression graph, and can be sent to other threads. [`Tape::over`] prepares it for a
/// field.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tape {
    inputs: usize,
    constants: Vec<Rational>,
    /// The constants, rounded to `f64`.
    rounded: Vec<f64>,
    operations: Vec<Operation>,
    outputs: Vec<Register>,
    registers: usize,
    /// Whether fused operations round once, also inside sines and cosines: see [`Tape::fused`].
    once: bool,
}

/// The index of a number: inputs first, then constants, then results in the order of the operations.
pub type Register = u32;

/// An operation on registers with smaller indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    Sum(Register, Register),
    Difference(Register, Register),
    Product(Register, Register),
    /// A product whose first factor is a constant.
    Multiple(Register, Register),
    Quotient(Register, Register),
    /// A quotient whose divisor is a constant.
    Part(Register, Register),
    Negation(Register),
    Root(Register),
    /// Cosine and sine of an angle in radians, in two consecutive registers.
    Circle(Register),
    /// An elementary function. A function of one argument reads it twice.
    Elementary(Elementary, Register, Register),
    /// a b + c, rounded once if the field can: see [`Tape::fused`].
    ProductAnd([Register; 2], Register),
    /// a b - c.
    ProductLess([Register; 2], Register),
    /// c - a b.
    LessProduct([Register; 2], Register),
}

impl Operation {
    /// Returns the registers that the operation reads. If it reads fewer than three, the last one is repeated.
    #[inline(always)]
    pub fn operands(self) -> [Register; 3] {
        match self {
            Operation::Sum(a, b)
            | Operation::Difference(a, b)
            | Operation::Product(a, b)
            | Operation::Multiple(a, b)
            | Operation::Quotient(a, b)
            | Operation::Part(a, b)
            | Operation::Elementary(_, a, b) => [a, b, b],
            Operation::Negation(a) | Operation::Root(a) | Operation::Circle(a) => [a, a, a],
            Operation::ProductAnd([a, b], c)
            | Operation::ProductLess([a, b], c)
            | Operation::LessProduct([a, b], c) => [a, b, c],
        }
    }

    /// Returns the registers that the operation reads, each as often as it is read.
    fn reads(self) -> impl Iterator<Item = Register> {
        let count = match self {
            Operation::Negation(_) | Operation::Root(_) | Operation::Circle(_) => 1,
            Operation::ProductAnd(..) | Operation::ProductLess(..) | Operation::LessProduct(..) => 3,
            _ => 2,
        };
        self.operands().into_iter().take(count)
    }

    /// Returns the operation with its registers renumbered.
    fn through(self, other: impl Fn(Register) -> Register) -> Self {
        let [a, b, c] = self.operands().map(other);
        match self {
            Operation::Sum(..) => Operation::Sum(a, b),
            Operation::Difference(..) => Operation::Difference(a, b),
            Operation::Product(..) => Operation::Product(a, b),
            Operation::Multiple(..) => Operation::Multiple(a, b),
            Operation::Quotient(..) => Operation::Quotient(a, b),
            Operation::Part(..) => Operation::Part(a, b),
            Operation::Negation(_) => Operation::Negation(a),
            Operation::Root(_) => Operation::Root(a),
            Operation::Circle(_) => Operation::Circle(a),
            Operation::Elementary(function, ..) => Operation::Elementary(function, a, b),
            Operation::ProductAnd(..) => Operation::ProductAnd([a, b], c),
            Operation::ProductLess(..) => Operation::ProductLess([a, b], c),
            Operation::LessProduct(..) => Operation::LessProduct([a, b], c),
        }
    }

    /// Computes a field operation; `None` for roots, sines and cosines, and elementary functions.
    #[inline(always)]
    fn of_field<S: Scalar>(self, value: impl Fn(Register) -> S) -> Option<S> {
        // each branch reads only its operands, since numbers may be large
        match self {
            Operation::Sum(a, b) => Some(value(a) + value(b)),
            Operation::Difference(a, b) => Some(value(a) - value(b)),
            Operation::Product(a, b) | Operation::Multiple(a, b) => Some(value(a) * value(b)),
            Operation::Quotient(a, b) | Operation::Part(a, b) => Some(value(a) / value(b)),
            Operation::Negation(a) => Some(-value(a)),
            Operation::ProductAnd([a, b], c) => Some(value(a).times_and(value(b), value(c))),
            Operation::ProductLess([a, b], c) => Some(value(a).times_and(value(b), -value(c))),
            Operation::LessProduct([a, b], c) => Some((-value(a)).times_and(value(b), value(c))),
            Operation::Root(_) | Operation::Circle(_) | Operation::Elementary(..) => None,
        }
    }

    /// Returns the number of result registers: two for cosine and sine, otherwise one.
    #[inline(always)]
    pub fn results(self) -> usize {
        if matches!(self, Operation::Circle(_)) { 2 } else { 1 }
    }
}

impl Tape {
    /// Returns the number of inputs.
    pub fn inputs(&self) -> usize {
        self.inputs
    }

    /// Returns the number of outputs.
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// Returns the number of operations; cosine and sine of one angle count as one.
    pub fn operations(&self) -> usize {
        self.operations.len()
    }

    /// Returns the operations in order, for translation into another language.
    pub fn steps(&self) -> &[Operation] {
        &self.operations
    }

    /// Returns whether sines and cosines are computed by [`field::Analytic::circle_once`].
    pub fn rounds_once(&self) -> bool {
        self.once
    }

    /// Returns the first constant that `f64` cannot represent: it is too large, or so small that it is rounded to zero.
    pub fn beyond_range(&self) -> Option<Rational> {
        let lost =
            |(exact, rounded): &(&Rational, &f64)| !rounded.is_finite() || **rounded == 0.0 && exact.sign() != Some(0);
        self.constants.iter().zip(&self.rounded).find(lost).map(|(exact, _)| *exact)
    }

    /// Returns the constants, rounded to `f64`.
    pub fn rounded(&self) -> &[f64] {
        &self.rounded
    }

    /// Returns the registers of the outputs.
    pub fn results(&self) -> &[Register] {
        &self.outputs
    }
}
