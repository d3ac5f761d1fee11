//! A law as a straight-line program, which can be evaluated over every numeric scalar type.

mod table;

use crate::law::trace::{TracedOde, symbols, traced};
use field::{Analytic, DoubleDouble};
use integrators::{Dual8, Ode};
use native::Code;
use std::sync::Arc;
use symbolic::{Sym, Tape, apart};
use table::Table;

/// A function of a state and the time as straight-line code.
#[derive(Clone, Debug)]
pub struct Program {
    tape: Tape,
    /// Machine code in `f64`, where there is a code generator for this machine.
    code: Option<Arc<Code>>,
    plain: Table<f64>,
    slopes: Table<Dual8>,
    exact: Table<DoubleDouble>,
}

/// Numbers of registers for small, usual and the largest laws. Clearing registers is costly, especially over dual
/// numbers: a program gets hardly more than it needs.
const LEAST: usize = 16;
const LESS: usize = 32;
const FEW: usize = 64;
const SOME: usize = 128;
const MORE: usize = 256;
const MANY: usize = 1024;

impl Program {
    /// The program of a function of a state of `n` components and the time; `None` where an expression is undefined.
    pub fn of(n: usize, function: impl FnOnce(Sym, &[Sym]) -> Vec<Sym> + Send) -> Option<Self> {
        Program::recorded(tape(n, function)?)
    }

    /// As [`Program::of`] without machine code, for a few evaluations only. `None` if an expression is undefined.
    pub fn for_few(n: usize, function: impl FnOnce(Sym, &[Sym]) -> Vec<Sym> + Send) -> Option<Self> {
        Some(Program::without_code(tape(n, function)?))
    }

    /// The program of a tape whose last input is the time.
    pub fn of_tape(tape: Tape) -> Option<Self> {
        Program::recorded(tape)
    }

    /// The program of the rates of a law; `None` if a rate is undefined.
    pub fn of_law(law: &(impl Ode<Sym> + Sync + ?Sized)) -> Option<Self> {
        traced(law, |TracedOde { state, time, rates }| {
            Program::recorded(Tape::record(&[&state[..], &[*time]].concat(), rates).ok()?.arranged())
        })
    }

    fn recorded(tape: Tape) -> Option<Self> {
        let code = Code::of(&tape).map(Arc::new);
        Some(Program { code, ..Program::without_code(tape) })
    }

    /// The operations over any other scalar type; the inputs are the state, then the time.
    pub fn over<S: Analytic>(&self) -> symbolic::Program<'_, S> {
        self.tape.over()
    }

    /// The divisors, radicands and angles, as [`Tape::singular_places`].
    pub(super) fn singular_places(&self) -> Option<(Tape, [usize; 3])> {
        self.tape.singular_places()
    }

    /// The functions of the time alone, as [`Tape::parts_of_last_input`].
    pub(super) fn parts_of_time(&self) -> Vec<Tape> {
        self.tape.parts_of_last_input()
    }

    /// The program of a tape, interpreted.
    pub(super) fn without_code(tape: Tape) -> Self {
        let (plain, slopes, exact) = (Table::of(&tape), Table::of(&tape), Table::of(&tape));
        Program { code: None, plain, slopes, exact, tape }
    }

    /// Whether the program is compiled to machine code; otherwise its operations are interpreted, which takes about
    /// five times as long.
    pub fn is_code(&self) -> bool {
        self.code.is_some()
    }

    /// The size of the machine code in bytes, including constants; `None` if the program is interpreted.
    pub fn code_size(&self) -> Option<usize> {
        self.code.as_ref().map(|code| code.size())
    }

    /// Evaluates the program at a time and a state. `None` where the length of the state differs from the recorded one,
    /// or `values` is too short.
    #[inline]
    pub fn run<S: Running>(&self, t: S, y: &[S], values: &mut [S]) -> Option<()> {
        S::run(self, t, y, values)
    }

    /// Interprets the operations. A separate function, since its length would slow down the call of machine code.
    #[cold]
    fn follow_table(&self, t: f64, y: &[f64], values: &mut [f64]) -> Option<()> {
        self.follow(&self.plain, t, y, values)
    }

    #[inline]
    fn follow<S: Analytic>(&self, table: &Table<S>, t: S, y: &[S], values: &mut [S]) -> Option<()> {
        if y.len() + 1 != self.tape.inputs() {
            return None;
        }
        let inputs = y.iter().copied().chain([t]);
        let constants = &table.constants;
        match self.tape.registers() {
            least if least <= LEAST => self.tape.evaluate::<S, LEAST>(constants, inputs, values),
            less if less <= LESS => self.tape.evaluate::<S, LESS>(constants, inputs, values),
            few if few <= FEW => self.tape.evaluate::<S, FEW>(constants, inputs, values),
            some if some <= SOME => self.tape.evaluate::<S, SOME>(constants, inputs, values),
            more if more <= MORE => self.tape.evaluate::<S, MORE>(constants, inputs, values),
            many if many <= MANY => self.tape.evaluate::<S, MANY>(constants, inputs, values),
            _ => {
                table.evaluate(&self.tape, inputs, values);
                Some(())
            }
        }
    }
}

/// The tape of a function of a state of `n` components and the time.
fn tape(n: usize, function: impl FnOnce(Sym, &[Sym]) -> Vec<Sym> + Send) -> Option<Tape> {
    apart(|| {
        let (state, time) = symbols(n);
        let values = function(time, &state);
        Some(Tape::record(&[&state[..], &[time]].concat(), &values).ok()?.arranged())
    })
}

/// A scalar type over which programs are evaluated.
pub trait Running: Analytic {
    /// Evaluates a program.
    fn run(program: &Program, t: Self, y: &[Self], values: &mut [Self]) -> Option<()>;
}

impl Running for f64 {
    #[inline]
    fn run(program: &Program, t: f64, y: &[f64], values: &mut [f64]) -> Option<()> {
        match &program.code {
            Some(code) => code.run(y, t, values),
            None => program.follow_table(t, y, values),
        }
    }
}

impl Running for Dual8 {
    fn run(program: &Program, t: Self, y: &[Self], values: &mut [Self]) -> Option<()> {
        program.follow(&program.slopes, t, y, values)
    }
}

impl Running for DoubleDouble {
    fn run(program: &Program, t: Self, y: &[Self], values: &mut [Self]) -> Option<()> {
        program.follow(&program.exact, t, y, values)
    }
}

#[cfg(test)]
mod tests {
    use super::Program;
    use field::{Analytic, Scalar};

    #[test]
    fn without_machine_code_a_program_has_the_same_bits() {
        let made = Program::of(2, |t, y| vec![y[0] * y[1] - t, (y[0] + t).circle().sin / y[1], y[1].sqrt().half()]);
        let written = made.expect("it has values");
        let followed = Program::without_code(written.tape.clone());
        let ([mut own, mut table], y) = ([[0.0_f64; 3]; 2], [0.7, 1.9]);
        assert_eq!(written.run(0.3, &y, &mut own), Some(()));
        assert_eq!(followed.run(0.3, &y, &mut table), Some(()));
        assert_eq!(own.map(f64::to_bits), table.map(f64::to_bits));
    }
}
