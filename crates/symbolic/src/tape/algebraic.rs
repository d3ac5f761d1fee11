//! A tape of field operations alone, over every scalar, also over one without roots and angles.

use super::{Operation, Register, Tape};
use field::{Rational, Scalar};

/// One value as sums, products and quotients of its inputs. A constant is the quotient of two integers: every field
/// holds it as exactly as it can.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Algebraic {
    inputs: usize,
    constants: Vec<(i64, i64)>,
    operations: Vec<Operation>,
    output: Register,
    registers: usize,
}

impl Tape {
    /// The first output's program; `None` where the tape has roots, circle points or elementary functions, no output, or a constant whose
    /// numerator or denominator is beyond 64 bits.
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

/// Numerator and denominator, where both are within 64 bits.
fn integers(value: Rational) -> Option<(i64, i64)> {
    let big = value.to_big()?;
    Some((i64::try_from(big.numerator()).ok()?, i64::try_from(big.denominator()).ok()?))
}

impl Algebraic {
    /// The number of registers that an evaluation needs.
    pub fn registers(&self) -> usize {
        self.registers
    }

    /// The value at the inputs, with N registers on the stack; `None` where N are too few or inputs are missing.
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
