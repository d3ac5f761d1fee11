//! A compiled law of motion: all evaluations that a method needs, from one symbolic law.

use crate::law::divisors::DivisorProgram;
use crate::law::jacobian::JacobianProgram;
use crate::law::program::Program;
use crate::law::series::LawSeries;
use crate::law::time_scales::TimeScales;
use field::DoubleDouble;
use integrators::{
    Composed, Divisors, Dual8, JacobianFn, Ode, Splitting, StepBounds, System, TaylorSeries, Variations,
};
use std::sync::{Arc, OnceLock};
use symbolic::Sym;

/// A system that can be shared between threads.
pub trait Law: System + Send + Sync {}
impl<L: System + Send + Sync> Law for L {}

/// A law over symbolic expressions that can be shared between threads.
pub trait SymbolicLaw: Ode<Sym> + Send + Sync {}
impl<L: Ode<Sym> + Send + Sync> SymbolicLaw for L {}

/// A source of the Jacobian of a law.
pub trait Differentiable: Send + Sync {
    /// The Jacobian with buffers for one run; `None` where unavailable: the law is then evaluated over dual numbers.
    fn jacobian_fn(&self) -> Option<Box<dyn JacobianFn + '_>>;
}

/// A law that is a sum of fields with known flows, for splitting methods.
pub trait Splittable: Send + Sync {
    /// The composed flows in `f64`; `None` where the law is no such sum.
    fn composed(&self, splitting: Splitting) -> Option<Box<dyn Composed<f64> + '_>>;

    /// The composed flows in double-double.
    fn composed_exact(&self, splitting: Splitting) -> Option<Box<dyn Composed<DoubleDouble> + '_>>;
}

/// A law as programs. Each is compiled when first needed; the data of the law are constants in it.
pub struct CompiledLaw {
    law: Arc<dyn SymbolicLaw>,
    /// `None` where an expression is undefined.
    rates: OnceLock<Option<Program>>,
    /// `None` where the rates divide by constants only.
    divisors: OnceLock<Option<DivisorProgram>>,
    /// `None` where the rates depend on the time at most linearly.
    time_scales: OnceLock<Option<TimeScales>>,
    series: LawSeries,
    jacobian: Arc<dyn Differentiable>,
    pieces: Option<Arc<dyn Splittable>>,
}

impl CompiledLaw {
    /// Compiles a law, which may depend on time.
    pub fn new(law: impl SymbolicLaw + 'static) -> Self {
        CompiledLaw::of(Arc::new(law))
    }

    /// Compiles a shared law.
    pub fn of(law: Arc<dyn SymbolicLaw>) -> Self {
        CompiledLaw {
            rates: OnceLock::new(),
            divisors: OnceLock::new(),
            time_scales: OnceLock::new(),
            series: LawSeries::of(Arc::clone(&law)),
            jacobian: Arc::new(JacobianProgram::of(Arc::clone(&law))),
            pieces: None,
            law,
        }
    }

    /// The law with rates that are already compiled.
    pub fn with_rates(self, rates: Program) -> Self {
        CompiledLaw { rates: OnceLock::from(Some(rates)), ..self }
    }

    /// The law with other Taylor series.
    pub fn with_series(self, series: LawSeries) -> Self {
        CompiledLaw { series, ..self }
    }

    /// The law with another source of the Jacobian.
    pub fn with_jacobian(self, jacobian: Arc<dyn Differentiable>) -> Self {
        CompiledLaw { jacobian, ..self }
    }

    /// The law with flows for splitting methods.
    pub fn with_pieces(self, pieces: Arc<dyn Splittable>) -> Self {
        CompiledLaw { pieces: Some(pieces), ..self }
    }

    /// The program of the rates; `None` where an expression is undefined, such as a division by zero: then every rate
    /// is NaN.
    #[inline]
    pub fn program(&self) -> Option<&Program> {
        self.rates.get_or_init(|| Program::of_law(&*self.law)).as_ref()
    }
}

macro_rules! runs {
    ($($field:ty),*) => {$(
        impl Ode<$field> for CompiledLaw {
            fn dimension(&self) -> usize {
                self.law.dimension()
            }

            #[inline]
            fn rates(&self, t: $field, y: &[$field], dy: &mut [$field]) {
                match self.program() {
                    // the length of the state is correct by construction
                    Some(program) => program.run(t, y, dy).unwrap_or(()),
                    None => dy.fill(<$field>::from(f64::NAN)),
                }
            }
        }
    )*};
}
runs!(f64, Dual8, DoubleDouble);

impl Ode<Sym> for CompiledLaw {
    fn dimension(&self) -> usize {
        self.law.dimension()
    }

    fn rates(&self, t: Sym, y: &[Sym], dy: &mut [Sym]) {
        self.law.rates(t, y, dy);
    }
}

impl System for CompiledLaw {
    fn code_size(&self) -> Option<usize> {
        self.program()?.code_size()
    }

    fn divisors(&self) -> Option<&dyn Divisors> {
        let made = self.divisors.get_or_init(|| self.program().and_then(DivisorProgram::of));
        made.as_ref().map(|program| program as &dyn Divisors)
    }

    fn step_bounds(&self, from: f64, to: f64) -> StepBounds {
        let made = self.time_scales.get_or_init(|| self.program().and_then(TimeScales::of));
        made.as_ref().map_or_else(StepBounds::default, |scales| scales.bounds(from, to))
    }

    fn taylor(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        self.series.plain()
    }

    fn taylor_variations(&self) -> Option<Box<dyn TaylorSeries<Variations> + '_>> {
        self.series.directed()
    }

    fn taylor_exact(&self) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        self.series.exact()
    }

    fn jacobian_fn(&self) -> Option<Box<dyn JacobianFn + '_>> {
        self.jacobian.jacobian_fn()
    }

    fn composed(&self, splitting: Splitting) -> Option<Box<dyn Composed<f64> + '_>> {
        self.pieces.as_ref()?.composed(splitting)
    }

    fn composed_exact(&self, splitting: Splitting) -> Option<Box<dyn Composed<DoubleDouble> + '_>> {
        self.pieces.as_ref()?.composed_exact(splitting)
    }
}
