//! A system with its Jacobian as sums of multiples of monomials, for the implicit methods.

use field::{DoubleDouble, Scalar};
use integrators::{Composed, Directions, Ode, Slopes, Splitting, System, TaylorSeries};
use std::sync::{Arc, OnceLock};
use symbolic::{Polynomials, Sym};

/// A system and the Jacobian of its right-hand side: the same laws, evaluated once over expressions and differentiated
/// exactly. The data of the system are in it as numbers.
#[derive(Clone, Debug)]
pub struct Differentiated<S, L> {
    system: S,
    law: Arc<L>,
    /// Made when it is first asked for; `None` where they cannot be recorded: then the law is run over dual numbers.
    entries: OnceLock<Option<Polynomials>>,
}

impl<S, L: Ode<Sym>> Differentiated<S, L> {
    /// An autonomous law, and the system that runs it.
    pub fn new(system: S, law: Arc<L>) -> Self {
        Differentiated { system, law, entries: OnceLock::new() }
    }

    /// df_i / dy_j, row after row.
    pub fn entries(&self) -> Option<&Polynomials> {
        let made = self.entries.get_or_init(|| {
            let state: Vec<Sym> = (0..self.law.dimension()).map(|i| Sym::symbol(&format!("y{i}"))).collect();
            let mut rates = vec![Sym::ZERO; state.len()];
            self.law.rates(Sym::ZERO, &state, &mut rates);
            let entries: Vec<Sym> = rates.iter().flat_map(|rate| state.iter().map(|&by| rate.diff(by))).collect();
            Polynomials::record(&state, &entries, state.len())
        });
        made.as_ref()
    }
}

impl<F: Scalar, S: Ode<F>, L> Ode<F> for Differentiated<S, L> {
    fn dimension(&self) -> usize {
        self.system.dimension()
    }

    fn rates(&self, t: F, y: &[F], dy: &mut [F]) {
        self.system.rates(t, y, dy);
    }
}

impl<S: System, L: Ode<Sym>> System for Differentiated<S, L>
where
    S: Ode<f64> + Ode<Directions> + Ode<DoubleDouble>,
{
    fn taylor(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        self.system.taylor()
    }

    fn taylor_exact(&self) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        self.system.taylor_exact()
    }

    fn taylor_directions(&self) -> Option<Box<dyn TaylorSeries<Directions> + '_>> {
        self.system.taylor_directions()
    }

    fn composed(&self, splitting: Splitting) -> Option<Box<dyn Composed<f64> + '_>> {
        self.system.composed(splitting)
    }

    fn composed_exact(&self, splitting: Splitting) -> Option<Box<dyn Composed<DoubleDouble> + '_>> {
        self.system.composed_exact(splitting)
    }

    fn slopes(&self) -> Option<Box<dyn Slopes + '_>> {
        Some(Box::new(Entries(self.entries()?)))
    }
}

struct Entries<'a>(&'a Polynomials);

impl Slopes for Entries<'_> {
    fn matrix(&mut self, y: &[f64], matrix: &mut [f64]) {
        self.0.evaluate(y, matrix);
    }
}
