//! An index-2 DAE compiled to straight-line programs.

use crate::law::program::{Program, Running};
use field::DoubleDouble;
use integrators::{Dual8, Index2Dae, Index2DaeSystem};
use std::sync::Arc;
use symbolic::Sym;

/// An index-2 DAE over symbolic expressions that can be shared between threads.
pub trait SymbolicDae: Index2Dae<Sym> + Send + Sync {}
impl<L: Index2Dae<Sym> + Send + Sync> SymbolicDae for L {}

/// An index-2 DAE as programs.
pub struct CompiledDae {
    law: Arc<dyn SymbolicDae>,
    /// `None` where an expression is undefined: then every result is NaN.
    programs: Option<Programs>,
}

struct Programs {
    /// The rates as functions of y and z.
    rates: Program,
    /// f, the columns of B, and g.
    free: Program,
    columns: Program,
    constraints: Program,
}

/// The largest number of components of y and z that are gathered without allocation.
const FEW: usize = 64;

impl CompiledDae {
    /// Compiles a DAE, which may depend on time.
    pub fn new(law: impl SymbolicDae + 'static) -> Self {
        CompiledDae { programs: Programs::of(&law), law: Arc::new(law) }
    }
}

impl Programs {
    fn of(law: &impl SymbolicDae) -> Option<Self> {
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
        Some(Programs {
            rates: Program::of(n + m, rates)?,
            free: Program::of(n, |t, y| parts(t, y).0)?,
            columns: Program::of(n, |t, y| parts(t, y).1)?,
            constraints: Program::of(n, constraints)?,
        })
    }

    fn rates<S: Running>(&self, t: S, y: &[S], z: &[S], dy: &mut [S]) -> Option<()> {
        let (mut few, mut many) = ([S::zero(); FEW], Vec::new());
        let both = match few.get_mut(..y.len() + z.len()) {
            Some(few) => few,
            None => {
                many.resize(y.len() + z.len(), S::zero());
                &mut many[..]
            }
        };
        let (first, second) = both.split_at_mut(y.len());
        first.copy_from_slice(y);
        second.copy_from_slice(z);
        self.rates.run(t, both, dy)
    }
}

macro_rules! runs {
    ($($field:ty),*) => {$(
        impl Index2Dae<$field> for CompiledDae {
            fn sizes(&self) -> (usize, usize) {
                self.law.sizes()
            }

            fn rates(&self, t: $field, y: &[$field], z: &[$field], dy: &mut [$field]) {
                let run = self.programs.as_ref().and_then(|it| it.rates(t, y, z, dy));
                run.unwrap_or_else(|| dy.fill(<$field>::from(f64::NAN)));
            }

            fn parts(&self, t: $field, y: &[$field], dy: &mut [$field], columns: &mut [$field]) {
                let run = self.programs.as_ref().and_then(|it| {
                    it.free.run(t, y, dy)?;
                    it.columns.run(t, y, columns)
                });
                run.unwrap_or_else(|| dy.fill(<$field>::from(f64::NAN)));
            }

            fn constraints(&self, t: $field, y: &[$field], g: &mut [$field]) {
                let run = self.programs.as_ref().and_then(|it| it.constraints.run(t, y, g));
                run.unwrap_or_else(|| g.fill(<$field>::from(f64::NAN)));
            }
        }
    )*};
}
runs!(f64, Dual8, DoubleDouble);

impl Index2DaeSystem for CompiledDae {}
