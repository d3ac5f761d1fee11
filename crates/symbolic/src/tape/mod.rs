//! Expressions as straight-line programs.

mod algebraic;
mod record;
mod run;
mod source;

pub use algebraic::Algebraic;
pub use record::Untapeable;
pub use run::Program;
pub use source::{Language, Source};

use field::{Rational, Scalar};

/// A straight-line program without branches: what the expressions compute, every common part once.
///
/// A tape knows nothing of the expression graph and may be sent to other threads. [`Tape::over`] readies it for a
/// field.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tape {
    inputs: usize,
    constants: Vec<Rational>,
    /// The same to the nearest `f64`.
    rounded: Vec<f64>,
    operations: Vec<Operation>,
    outputs: Vec<Register>,
    registers: usize,
}

/// A place for a number: inputs first, then constants, then results in the order of the operations.
pub type Register = u32;

/// What is computed from earlier registers.
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
    /// Cosine and sine of one angle, in two registers.
    Circle(Register),
}

impl Operation {
    #[inline(always)]
    /// What it reads; the only one twice.
    pub fn operands(self) -> [Register; 2] {
        match self {
            Operation::Sum(a, b)
            | Operation::Difference(a, b)
            | Operation::Product(a, b)
            | Operation::Multiple(a, b)
            | Operation::Quotient(a, b)
            | Operation::Part(a, b) => [a, b],
            Operation::Negation(a) | Operation::Root(a) | Operation::Circle(a) => [a, a],
        }
    }

    /// The result of a field operation; none of a root or a circle point.
    #[inline(always)]
    fn of_field<S: Scalar>(self, a: S, b: S) -> Option<S> {
        match self {
            Operation::Sum(..) => Some(a + b),
            Operation::Difference(..) => Some(a - b),
            Operation::Product(..) | Operation::Multiple(..) => Some(a * b),
            Operation::Quotient(..) | Operation::Part(..) => Some(a / b),
            Operation::Negation(_) => Some(-a),
            Operation::Root(_) | Operation::Circle(_) => None,
        }
    }

    #[inline(always)]
    fn results(self) -> usize {
        if matches!(self, Operation::Circle(_)) { 2 } else { 1 }
    }
}

impl Tape {
    /// How many numbers go in.
    pub fn inputs(&self) -> usize {
        self.inputs
    }

    /// How many numbers come out.
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// How many operations there are; a cosine with its sine is one.
    pub fn operations(&self) -> usize {
        self.operations.len()
    }

    /// The operations in their order: for whoever writes them in a language of its own.
    pub fn steps(&self) -> &[Operation] {
        &self.operations
    }

    /// The constants to the nearest `f64`.
    pub fn rounded(&self) -> &[f64] {
        &self.rounded
    }

    /// Where the outputs stand after the last operation.
    pub fn results(&self) -> &[Register] {
        &self.outputs
    }
}
