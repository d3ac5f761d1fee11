//! Evaluation of a tape.

use super::{Operation, Register, Tape};
use crate::evaluate::constant;
use field::{Analytic, Over};
use std::borrow::Cow;

/// A tape over a field, with its registers. An evaluation does not allocate memory.
#[derive(Clone, Debug)]
pub struct Program<'a, S> {
    tape: Cow<'a, Tape>,
    registers: Vec<S>,
}

impl Tape {
    /// Prepares the tape for evaluation over a field.
    pub fn over<S: Analytic>(&self) -> Program<'_, S> {
        let mut registers = vec![S::zero(); self.registers];
        for (register, value) in registers[self.inputs..].iter_mut().zip(&self.constants) {
            *register = constant(*value);
        }
        Program { tape: Cow::Borrowed(self), registers }
    }

    /// Returns the constants over a field, for [`Tape::evaluate`].
    pub fn constants<S: Analytic>(&self) -> Vec<S> {
        self.constants.iter().map(|value| constant(*value)).collect()
    }

    /// Returns the number of registers that an evaluation needs.
    pub fn registers(&self) -> usize {
        self.registers
    }

    /// Computes the outputs with N registers on the stack, so that several threads can share the tape. `constants` are those of [`Tape::constants`].
    /// Returns `None` if N is smaller than [`Tape::registers`].
    #[inline]
    pub fn evaluate<S: Analytic, const N: usize>(
        &self,
        constants: &[S],
        inputs: impl Iterator<Item = S>,
        outputs: &mut [S],
    ) -> Option<()> {
        let mut registers = [S::zero(); N];
        let registers = registers.get_mut(..self.registers)?;
        registers.get_mut(self.inputs..self.inputs + constants.len())?.copy_from_slice(constants);
        registers[..self.inputs].iter_mut().zip(inputs).for_each(|(register, input)| *register = input);
        self.follow(registers, outputs);
        Some(())
    }

    /// Computes the outputs with registers on the heap, for a tape of any length. Each evaluation allocates and frees them.
    pub fn evaluate_long<S: Analytic>(&self, constants: &[S], inputs: impl Iterator<Item = S>, outputs: &mut [S]) {
        self.evaluate_in(&mut Vec::new(), constants, inputs, outputs);
    }

    /// Computes the outputs with registers in a vector, which the first evaluation fills. Later evaluations of this tape with these constants
    /// reuse it.
    pub fn evaluate_in<S: Analytic>(
        &self,
        registers: &mut Vec<S>,
        constants: &[S],
        inputs: impl Iterator<Item = S>,
        outputs: &mut [S],
    ) {
        if registers.len() != self.registers {
            registers.clear();
            registers.reserve_exact(self.registers);
            registers.resize(self.inputs, S::zero());
            registers.extend_from_slice(constants);
            registers.resize(self.registers, S::zero());
        }
        registers[..self.inputs].iter_mut().zip(inputs).for_each(|(register, input)| *register = input);
        self.follow(registers, outputs);
    }

    /// Computes the outputs from registers that contain the inputs and constants.
    #[inline(always)]
    fn follow<S: Analytic>(&self, registers: &mut [S], outputs: &mut [S]) {
        let Tape { inputs, constants, operations, outputs: results, .. } = self;
        let mut next = inputs + constants.len();
        for &operation in operations {
            let value = |register: Register| registers[register as usize];
            let result = match operation {
                Operation::Root(a) => value(a).sqrt(),
                Operation::Elementary(function, a, b) => value(a).elementary(function, value(b)),
                Operation::Circle(a) => {
                    let point = if self.once { value(a).circle_once() } else { value(a).circle() };
                    registers[next + 1] = point.sin;
                    point.cos
                }
                rational => rational.of_field(value).unwrap_or(S::zero()),
            };
            registers[next] = result;
            next += operation.results();
        }
        for (output, &register) in outputs.iter_mut().zip(results) {
            *output = registers[register as usize];
        }
    }

    /// Prepares the tape for a field whose precision does not exceed `f64`, with the rounded constants of the tape.
    pub fn over_rounded<S: Analytic + Over<f64>>(&self) -> Program<'_, S> {
        let mut registers = vec![S::zero(); self.registers];
        for (register, value) in registers[self.inputs..].iter_mut().zip(&self.rounded) {
            *register = S::lift(*value);
        }
        Program { tape: Cow::Borrowed(self), registers }
    }
}

impl<S> Program<'_, S> {
    /// Returns the program with its own copy of the tape.
    pub fn kept(self) -> Program<'static, S> {
        Program { tape: Cow::Owned(self.tape.into_owned()), registers: self.registers }
    }
}

impl<S: Analytic> Program<'_, S> {
    /// Computes the outputs. Missing inputs keep the values of the previous evaluation, superfluous ones are ignored,
    /// and outputs are written as far as `outputs` has room.
    // always inlined, so that callers compiled for vector registers evaluate the tape with these
    #[inline(always)]
    pub fn evaluate(&mut self, inputs: &[S], outputs: &mut [S]) {
        // copied as a slice: an iterator over wide vectors would pass them through memory and wait for it
        let given = inputs.len().min(self.tape.inputs);
        self.registers[..given].copy_from_slice(&inputs[..given]);
        self.tape.follow(&mut self.registers, outputs);
    }
}
