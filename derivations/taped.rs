//! A law as the straight-line program that it comes to: what every field but that of expressions evaluates.

use field::{Analytic, DoubleDouble};
use integrators::{Directions, Ode};
use std::sync::Arc;
use symbolic::{Sym, Tape};

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
    plain: Vec<f64>,
    slopes: Vec<Directions>,
    exact: Vec<DoubleDouble>,
}

/// Registers: of small laws, of usual ones and of the largest. Clearing them costs, so that a program has hardly more than it
/// needs.
const FEW: usize = 64;
const SOME: usize = 256;
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
        Some(Program { plain: tape.constants(), slopes: tape.constants(), exact: tape.constants(), tape })
    }

    /// The values at a time and a state; none where the state is longer than what was recorded.
    #[inline]
    pub fn run<S: Running>(&self, t: S, y: &[S], values: &mut [S]) -> Option<()> {
        self.rates(S::constants(self), t, y, values)
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
            _ => self.tape.evaluate::<S, MANY>(constants, inputs, dy),
        }
    }
}

/// A field in which programs run.
pub trait Running: Analytic {
    /// The constants of a program in this field.
    fn constants(program: &Program) -> &[Self];
}

macro_rules! runs {
    ($field:ty, $constants:ident) => {
        impl Running for $field {
            fn constants(program: &Program) -> &[$field] {
                &program.$constants
            }
        }

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
    };
}

runs!(f64, plain);
runs!(Directions, slopes);
runs!(DoubleDouble, exact);

impl<L: Ode<Sym>> Ode<Sym> for Taped<L> {
    fn dimension(&self) -> usize {
        self.law.dimension()
    }

    fn rates(&self, t: Sym, y: &[Sym], dy: &mut [Sym]) {
        self.law.rates(t, y, dy);
    }
}
