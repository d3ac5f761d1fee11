//! A system whose right-hand side is run by one program of the whole law.
//!
//! Recorded once as a whole, a law has each common part once, its data are constants, and over `f64` it is machine code; over dual and
//! double-double numbers the program is followed operation by operation.

use super::problem::Law;
use crate::taped::Program;
use field::DoubleDouble;
use integrators::{Composed, Directions, Ode, Slopes, Splitting, System, TaylorSeries};
use std::sync::{Arc, OnceLock};
use symbolic::Sym;

/// A system, and the program that stands for its right-hand side.
struct ByProgram<L> {
    system: Arc<dyn Law>,
    law: Arc<L>,
    /// Made when the law is first run; `None` where it cannot be recorded or is long: then the system's own rates are run.
    program: OnceLock<Option<Program>>,
}

/// A system that runs a law, by the law's program.
pub fn by_program<L>(system: Arc<dyn Law>, law: Arc<L>) -> Arc<dyn Law>
where
    L: Ode<Sym> + Send + Sync + 'static,
{
    Arc::new(ByProgram { system, law, program: OnceLock::new() })
}

impl<L: Ode<Sym> + Sync> ByProgram<L> {
    #[inline]
    fn program(&self) -> Option<&Program> {
        self.program.get_or_init(|| Program::of_law(&*self.law)).as_ref()
    }
}

macro_rules! runs {
    ($($field:ty),*) => {$(
        impl<L: Ode<Sym> + Sync> Ode<$field> for ByProgram<L> {
            fn dimension(&self) -> usize {
                self.law.dimension()
            }

            fn rates(&self, t: $field, y: &[$field], dy: &mut [$field]) {
                match self.program() {
                    // made for a state of this length
                    Some(program) => program.run(t, y, dy).unwrap_or(()),
                    None => self.system.rates(t, y, dy),
                }
            }
        }
    )*};
}
runs!(f64, Directions, DoubleDouble);

impl<L: Ode<Sym> + Sync> System for ByProgram<L> {
    fn taylor(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        self.system.taylor()
    }

    fn taylor_directions(&self) -> Option<Box<dyn TaylorSeries<Directions> + '_>> {
        self.system.taylor_directions()
    }

    fn taylor_exact(&self) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        self.system.taylor_exact()
    }

    fn slopes(&self) -> Option<Box<dyn Slopes + '_>> {
        self.system.slopes()
    }

    fn composed(&self, splitting: Splitting) -> Option<Box<dyn Composed<f64> + '_>> {
        self.system.composed(splitting)
    }

    fn composed_exact(&self, splitting: Splitting) -> Option<Box<dyn Composed<DoubleDouble> + '_>> {
        self.system.composed_exact(splitting)
    }
}
