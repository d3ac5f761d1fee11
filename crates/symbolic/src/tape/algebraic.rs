//! Tapes with field operations only, for scalars without roots and angles.

use super::{Operation, Register, Tape};
use field::{Rational, Scalar};

/// A program for one value that consists of sums, products and quotients of its inputs. Constants are stored as quotients of two integers, which every field
/// represents as exactly as it can.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Algebraic {
    inputs: usize,
    constants: Vec<(i64, i64)>,
    operations: Vec<Operation>,
    output: Register,
    registers: usize,
}

impl Tape {
    /// Returns the program of the first output. Returns `None` if the tape contains roots, sines, cosines or elementary functions, has no output, or contains a constant
    /// whose numerator or denominator exceeds 64 bits.
    pub fn algebraic(&self) -> Option<Algebraic> {
        let beyond = |operation: &Operation| {
            matches!(operation, Operation::Root(_) | Operation::Circle(_) | Operation::Elementary(..))
        };
        if self.operations.iter().any(beyond) {
            return None;
        }
        Some(Algebraic {
            inputs: self.inputs,
            constants: self.constants.iter().map(|&value| integers(value)).collect::<Option<_>>()?,
            operations: self.operations.clone(),
            output: *self.outputs.first()?,
            registers: self.registers,
        })
    }
}

/// Returns numerator and denominator, if both fit into 64 bits.
fn integers(value: Rational) -> Option<(i64, i64)> {
    let big = value.to_big()?;
    Some((i64::try_from(big.numerator()).ok()?, i64::try_from(big.denominator()).ok()?))
}

impl Algebraic {
    /// Returns the number of registers that an evaluation needs.
    pub fn registers(&self) -> usize {
        self.registers
    }

    /// Evaluates the program with N registers on the stack. Returns `None` if N is too small or inputs are missing.
    pub fn evaluate<S: Scalar, const N: usize>(&self, inputs: impl Iterator<Item = S>) -> Option<S> {
        let mut registers = [S::zero(); N];
        let mut next = 0;
        for input in inputs.take(self.inputs) {
            *registers.get_mut(next)? = input;
            next += 1;
        }
        if next < self.inputs {
            return None;
        }
        for &(above, below) in &self.constants {
            *registers.get_mut(next)? = S::ratio(above, below);
            next += 1;
        }
        for &operation in &self.operations {
            let value = |register: Register| registers.get(register as usize).copied().unwrap_or(S::zero());
            let value = operation.of_field(value)?;
            *registers.get_mut(next)? = value;
            next += 1;
        }
        registers.get(self.output as usize).copied()
    }
}
