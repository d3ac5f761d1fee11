//! Constants and registers for the interpretation of a tape over one scalar type.

use field::Analytic;
use std::sync::{Mutex, PoisonError};
use symbolic::Tape;

/// The constants of a tape, and reusable registers for concurrent evaluations.
#[derive(Debug)]
pub(super) struct Table<S> {
    pub constants: Vec<S>,
    registers: Mutex<Vec<Vec<S>>>,
}

impl<S: Analytic> Table<S> {
    pub fn of(tape: &Tape) -> Self {
        Table { constants: tape.constants(), registers: Mutex::default() }
    }

    /// The outputs of the tape of this table for the given inputs.
    pub fn evaluate(&self, tape: &Tape, inputs: impl Iterator<Item = S>, outputs: &mut [S]) {
        let spare = || self.registers.lock().unwrap_or_else(PoisonError::into_inner);
        let mut registers = spare().pop().unwrap_or_default();
        tape.evaluate_in(&mut registers, &self.constants, inputs, outputs);
        spare().push(registers);
    }
}

impl<S: Clone> Clone for Table<S> {
    fn clone(&self) -> Self {
        Table { constants: self.constants.clone(), registers: Mutex::default() }
    }
}
