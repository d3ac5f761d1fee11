//! Running a tape.

use super::{Operation, Register, Tape};
use crate::evaluate::constant;
use field::{Analytic, Over};
use std::borrow::Cow;

/// A tape over a field, with its registers: evaluation allocates nothing.
#[derive(Clone, Debug)]
pub struct Program<'a, S> {
    tape: Cow<'a, Tape>,
    registers: Vec<S>,
}

impl Tape {
    /// The program over a field.
    pub fn over<S: Analytic>(&self) -> Program<'_, S> {
        let mut registers = vec![S::zero(); self.registers];
        for (register, value) in registers[self.inputs..].iter_mut().zip(&self.constants) {
            *register = constant(*value);
        }
        Program { tape: Cow::Borrowed(self), registers }
    }

    /// The constants over a field, for [`Tape::evaluate`].
    pub fn constants<S: Analytic>(&self) -> Vec<S> {
        self.constants.iter().map(|value| constant(*value)).collect()
    }

    /// The number of registers that an evaluation needs.
    pub fn registers(&self) -> usize {
        self.registers
    }

    /// The outputs at the inputs, with registers of its own on the stack: for a law that is shared between threads.
    /// `None` where there are not enough registers.
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

    /// The outputs with registers on the heap, for a tape of any length: each evaluation allocates and frees them.
    pub fn evaluate_long<S: Analytic>(&self, constants: &[S], inputs: impl Iterator<Item = S>, outputs: &mut [S]) {
        self.evaluate_in(&mut Vec::new(), constants, inputs, outputs);
    }

    /// The outputs with registers that are kept from evaluation to evaluation of this tape with these constants; the first one
    /// makes them.
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

    /// The outputs by registers that hold the inputs.
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

    /// The program over a field that is no finer than `f64`: its constants need not be computed again.
    pub fn over_rounded<S: Analytic + Over<f64>>(&self) -> Program<'_, S> {
        let mut registers = vec![S::zero(); self.registers];
        for (register, value) in registers[self.inputs..].iter_mut().zip(&self.rounded) {
            *register = S::lift(*value);
        }
        Program { tape: Cow::Borrowed(self), registers }
    }
}

impl<S> Program<'_, S> {
    /// The program with a tape of its own.
    pub fn kept(self) -> Program<'static, S> {
        Program { tape: Cow::Owned(self.tape.into_owned()), registers: self.registers }
    }
}

impl<S: Analytic> Program<'_, S> {
    /// The outputs at the inputs; numbers that are missing in `inputs` keep their values, superfluous ones are ignored,
    /// and as many outputs are written as there is room for.
    // always inlined: code compiled for wide registers then evaluates with them
    #[inline(always)]
    pub fn evaluate(&mut self, inputs: &[S], outputs: &mut [S]) {
        // as a whole: wide numbers taken one by one out of an iterator go through memory, and are waited for there
        let given = inputs.len().min(self.tape.inputs);
        self.registers[..given].copy_from_slice(&inputs[..given]);
        self.tape.follow(&mut self.registers, outputs);
    }
}
