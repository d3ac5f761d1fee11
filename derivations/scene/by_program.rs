//! A system whose law is text, run by one program of the whole law.
//!
//! The laws of a written motor are programs of their own, which any field evaluates one by one; put together in a right-hand
//! side they share nothing. Recorded once as a whole, with the gyrostat around the motor, they do, and the data are constants.

use super::problem::Law;
use crate::taped::Program;
use field::DoubleDouble;
use integrators::{Composed, Directions, Ode, Slopes, Splitting, System, TaylorSeries};
use std::sync::Arc;
use symbolic::Sym;

/// A system, and the program that stands for its right-hand side.
struct ByProgram {
    system: Arc<dyn Law>,
    program: Program,
}

/// The system as it was where its law cannot be recorded.
pub fn by_program(system: Arc<dyn Law>, law: &impl Ode<Sym>) -> Arc<dyn Law> {
    match Program::of_law(law) {
        Some(program) => Arc::new(ByProgram { system, program }),
        None => system,
    }
}

macro_rules! runs {
    ($($field:ty),*) => {$(
        impl Ode<$field> for ByProgram {
            fn dimension(&self) -> usize {
                Ode::<$field>::dimension(&*self.system)
            }

            fn rates(&self, t: $field, y: &[$field], dy: &mut [$field]) {
                // a program that was recorded has registers enough
                self.program.run(t, y, dy).unwrap_or(());
            }
        }
    )*};
}
runs!(f64, Directions, DoubleDouble);

impl System for ByProgram {
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
