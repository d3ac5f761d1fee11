//! Statements about the motion of a model, each with its verdict: its energy, its momenta, its constraints, and the terms that mistaken
//! derivations lose.

mod constraint_rates;
mod lost_terms;
mod momenta;
mod power_balance;

pub use lost_terms::{Mistake, Mistaken, mistaken};

use crate::Trace;
use crate::agreement::Agreement;
use crate::principles::Principle;
use symbolic::Sym;

/// A statement and the degree to which it is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// The quantity that it is about: energy, momentum of x, constraint 1.
    pub subject: String,
    /// The statement in words.
    pub says: String,
    pub agreement: Agreement,
}

/// All statements that a model makes by itself.
pub fn statements(trace: &Trace<'_>) -> Vec<Statement> {
    let mut all = Vec::new();
    // what leaves with a varying mass takes energy and momentum along
    if !trace.varies() {
        all.push(power_balance::statement(trace));
        all.extend(momenta::statements(trace));
    }
    all.extend(constraint_rates::statements(trace));
    all
}

/// Inertia less forces, by bodies where they are known, so that energies are compared with equations that do not know them.
fn residual(trace: &Trace<'_>) -> Vec<Sym> {
    let by_bodies = Principle::VirtualPower.residual(trace);
    by_bodies.or_else(|_| Principle::Lagrange.residual(trace)).unwrap_or_default()
}
