//! A law as the straight-line program that it comes to: what every field but that of expressions evaluates.

use field::{Analytic, DoubleDouble};
use integrators::{Directions, Ode};
use std::sync::Arc;
use symbolic::{Polynomials, Sym, Tape};

/// A law and its program. Laws made of masses and a chart build matrices and solve them at each evaluation; their program
/// has each common part once and the data folded into constants.
#[derive(Clone, Debug)]
pub struct Taped<L> {
    law: Arc<L>,
    /// `None` where the law cannot be recorded or its program is long: then the law itself is run.
    program: Option<Program>,
}

/// A function of a state and the time as straight-line code over every field that runs.
#[derive(Clone, Debug)]
pub struct Program {
    tape: Tape,
    /// In `f64`, where that is shorter than the tape.
    monomials: Option<Polynomials>,
    plain: Vec<f64>,
    slopes: Vec<Directions>,
    exact: Vec<DoubleDouble>,
}

/// Registers: of small laws, of usual ones and of the largest. Clearing them costs, most of all over numbers with slopes, so that
/// a program has hardly more than it needs.
const FEW: usize = 64;
const SOME: usize = 128;
const MORE: usize = 256;
const MANY: usize = 1024;
/// States and the time.
const INPUTS: usize = 64;

impl<L: Ode<Sym>> Taped<L> {
    /// Records a law, which may depend on time.
    pub fn new(law: Arc<L>) -> Self {
        let n = law.dimension();
        let program = Program::of(n, |time, state| {
            let mut rates = vec![Sym::ZERO; n];
            law.rates(time, state, &mut rates);
            rates
        });
        Taped { law, program }
    }
}

impl Program {
    /// Of a state of `n` components; `None` where it cannot be recorded or is long.
    pub fn of(n: usize, function: impl FnOnce(Sym, &[Sym]) -> Vec<Sym>) -> Option<Self> {
        let inputs: Vec<Sym> = (0..=n).map(|i| Sym::symbol(&format!("y{i}"))).collect();
        let outputs = function(inputs[n], &inputs[..n]);
        let tape = Tape::record(&inputs, &outputs).ok().filter(|tape| tape.registers() <= MANY && n < INPUTS)?;
        let (plain, slopes, exact) = (tape.constants(), tape.constants(), tape.constants());
        Some(Program { plain, slopes, exact, tape, monomials: None })
    }

    /// The right-hand side of a law, which in `f64` runs as sums of multiples of monomials where these are fewer than the steps of
    /// the tape: eight at a time, that is nearly as fast as compiled code.
    pub fn of_law(law: &impl Ode<Sym>) -> Option<Self> {
        let n = law.dimension();
        let mut written = None;
        let mut program = Program::of(n, |time, state| {
            let mut rates = vec![Sym::ZERO; n];
            law.rates(time, state, &mut rates);
            written = Some((state.to_vec(), rates.clone()));
            rates
        })?;
        // a law of time is none of the states alone, and is not recorded
        let monomials = written.and_then(|(state, rates)| Polynomials::record(&state, &rates, n));
        program.monomials = monomials.filter(|all| all.instructions() < program.tape.operations());
        Some(program)
    }

    /// The values at a time and a state; none where the state is longer than what was recorded.
    #[inline]
    pub fn run<S: Running>(&self, t: S, y: &[S], values: &mut [S]) -> Option<()> {
        S::run(self, t, y, values)
    }

    #[inline]
    fn rates<S: Analytic>(&self, constants: &[S], t: S, y: &[S], dy: &mut [S]) -> Option<()> {
        let mut inputs = [S::zero(); INPUTS];
        inputs.get_mut(..y.len())?.copy_from_slice(y);
        *inputs.get_mut(y.len())? = t;
        let inputs = &inputs[..=y.len()];
        match self.tape.registers() {
            few if few <= FEW => self.tape.evaluate::<S, FEW>(constants, inputs, dy),
            some if some <= SOME => self.tape.evaluate::<S, SOME>(constants, inputs, dy),
            more if more <= MORE => self.tape.evaluate::<S, MORE>(constants, inputs, dy),
            _ => self.tape.evaluate::<S, MANY>(constants, inputs, dy),
        }
    }
}

/// A field in which programs run.
pub trait Running: Analytic {
    /// The values of a program.
    fn run(program: &Program, t: Self, y: &[Self], values: &mut [Self]) -> Option<()>;
}

impl Running for f64 {
    #[inline]
    fn run(program: &Program, t: f64, y: &[f64], values: &mut [f64]) -> Option<()> {
        match &program.monomials {
            Some(monomials) => monomials.evaluate(y, values),
            None => program.rates(&program.plain, t, y, values)?,
        }
        Some(())
    }
}

impl Running for Directions {
    fn run(program: &Program, t: Self, y: &[Self], values: &mut [Self]) -> Option<()> {
        program.rates(&program.slopes, t, y, values)
    }
}

impl Running for DoubleDouble {
    fn run(program: &Program, t: Self, y: &[Self], values: &mut [Self]) -> Option<()> {
        program.rates(&program.exact, t, y, values)
    }
}

macro_rules! runs {
    ($($field:ty),*) => {$(
        impl<L: Ode<$field>> Ode<$field> for Taped<L> {
            fn dimension(&self) -> usize {
                self.law.dimension()
            }

            fn rates(&self, t: $field, y: &[$field], dy: &mut [$field]) {
                let taped = self.program.as_ref().and_then(|it| it.run(t, y, dy));
                if taped.is_none() {
                    self.law.rates(t, y, dy);
                }
            }
        }
    )*};
}
runs!(f64, Directions, DoubleDouble);

impl<L: Ode<Sym>> Ode<Sym> for Taped<L> {
    fn dimension(&self) -> usize {
        self.law.dimension()
    }

    fn rates(&self, t: Sym, y: &[Sym], dy: &mut [Sym]) {
        self.law.rates(t, y, dy);
    }
}
