//! Laws that are sums of fields with known flows, for splitting methods.

use super::Programs;
use field::DoubleDouble;
use integrators::{Composed, Pieces, Real, Splitting, compose};
use simulation::{CompiledLaw, Running, Splittable, SymbolicLaw};
use std::sync::{Arc, OnceLock};

/// A law that is a sum of fields with known flows.
pub trait Separable {
    /// The programs with which the flows are computed.
    fn programs(&self) -> Programs;

    /// The pieces over a scalar type, by these programs or by separate laws; `None` where the law is no such sum.
    fn pieces_by<'a, S: Real + Running>(&'a self, programs: Option<&'a Programs>) -> Option<impl Pieces<S> + 'a>;

    /// The pieces, by separate laws.
    fn pieces<S: Real + Running>(&self) -> Option<impl Pieces<S>> {
        self.pieces_by(None)
    }
}

/// The pieces of a law, by its programs.
struct PiecesByProgram<L> {
    law: Arc<L>,
    /// Recorded when first needed.
    programs: OnceLock<Programs>,
}

/// A law compiled for runs, with its pieces.
pub fn compiled<L: Separable + SymbolicLaw + 'static>(law: &Arc<L>) -> CompiledLaw {
    let pieces = PiecesByProgram { law: Arc::clone(law), programs: OnceLock::new() };
    CompiledLaw::of(Arc::clone(law) as Arc<dyn SymbolicLaw>).with_pieces(Arc::new(pieces))
}

impl<L: Separable> PiecesByProgram<L> {
    fn in_field<S: Real + Running>(&self, splitting: Splitting) -> Option<Box<dyn Composed<S> + '_>> {
        let programs = self.programs.get_or_init(|| self.law.programs());
        Some(compose(self.law.pieces_by(Some(programs))?, splitting))
    }
}

impl<L: Separable + Send + Sync> Splittable for PiecesByProgram<L> {
    fn composed(&self, splitting: Splitting) -> Option<Box<dyn Composed<f64> + '_>> {
        self.in_field(splitting)
    }

    fn composed_exact(&self, splitting: Splitting) -> Option<Box<dyn Composed<DoubleDouble> + '_>> {
        self.in_field(splitting)
    }
}
