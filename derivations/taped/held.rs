//! A law held to constraints, as the straight-line programs that it comes to.

use super::{Program, Running};
use field::DoubleDouble;
use integrators::{Directions, Held, HeldSystem};
use symbolic::Sym;

/// A law and its programs; where they cannot be recorded or are long, the law itself is run.
#[derive(Clone, Debug)]
pub struct TapedHeld<L> {
    law: L,
    programs: Option<Programs>,
}

#[derive(Clone, Debug)]
struct Programs {
    /// From y and z together.
    rates: Program,
    /// f, the columns of B, g.
    free: Program,
    columns: Program,
    constraints: Program,
}

/// So many components y and z have together at most.
const MOST: usize = 64;

impl<L: Held<Sym> + Sync> TapedHeld<L> {
    /// Records a law, which may depend on time.
    pub fn new(law: L) -> Self {
        let programs = Programs::of(&law);
        TapedHeld { law, programs }
    }
}

impl Programs {
    fn of(law: &(impl Held<Sym> + Sync)) -> Option<Self> {
        let (n, m) = law.sizes();
        let zeros = |count: usize| vec![Sym::ZERO; count];
        let parts = |t: Sym, y: &[Sym]| {
            let (mut free, mut columns) = (zeros(n), zeros(n * m));
            law.parts(t, y, &mut free, &mut columns);
            (free, columns)
        };
        let rates = |t: Sym, both: &[Sym]| {
            let mut rates = zeros(n);
            law.rates(t, &both[..n], &both[n..], &mut rates);
            rates
        };
        let constraints = |t: Sym, y: &[Sym]| {
            let mut constraints = zeros(m);
            law.constraints(t, y, &mut constraints);
            constraints
        };
        (n + m <= MOST).then_some(())?;
        Some(Programs {
            rates: Program::of(n + m, rates)?,
            free: Program::of(n, |t, y| parts(t, y).0)?,
            columns: Program::of(n, |t, y| parts(t, y).1)?,
            constraints: Program::of(n, constraints)?,
        })
    }

    fn rates<S: Running>(&self, t: S, y: &[S], z: &[S], dy: &mut [S]) -> Option<()> {
        let mut both = [S::zero(); MOST];
        both.get_mut(..y.len())?.copy_from_slice(y);
        both.get_mut(y.len()..y.len() + z.len())?.copy_from_slice(z);
        self.rates.run(t, &both[..y.len() + z.len()], dy)
    }
}

macro_rules! runs {
    ($($field:ty),*) => {$(
        impl<L: Held<$field>> Held<$field> for TapedHeld<L> {
            fn sizes(&self) -> (usize, usize) {
                self.law.sizes()
            }

            fn rates(&self, t: $field, y: &[$field], z: &[$field], dy: &mut [$field]) {
                let taped = self.programs.as_ref().and_then(|it| it.rates(t, y, z, dy));
                if taped.is_none() {
                    self.law.rates(t, y, z, dy);
                }
            }

            fn parts(&self, t: $field, y: &[$field], dy: &mut [$field], columns: &mut [$field]) {
                let taped = self.programs.as_ref().and_then(|it| {
                    it.free.run(t, y, dy)?;
                    it.columns.run(t, y, columns)
                });
                if taped.is_none() {
                    self.law.parts(t, y, dy, columns);
                }
            }

            fn constraints(&self, t: $field, y: &[$field], g: &mut [$field]) {
                let taped = self.programs.as_ref().and_then(|it| it.constraints.run(t, y, g));
                if taped.is_none() {
                    self.law.constraints(t, y, g);
                }
            }
        }
    )*};
}
runs!(f64, Directions, DoubleDouble);

impl<L: HeldSystem> HeldSystem for TapedHeld<L> {}
