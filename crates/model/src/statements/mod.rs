//! Statements about the motion of a model, each with its verdict: its energy, its momenta, its constraints, and the terms lost by
//! mistaken derivations.

mod constraint_rates;
mod lost_terms;
mod momenta;
mod power_balance;
mod reaction_power;

pub use lost_terms::{Mistake, Mistaken, mistaken};
pub use momenta::kept_momenta;
pub use power_balance::PowerBalance;

use crate::Trace;
use crate::agreement::Agreement;
use crate::principles::Principle;
use symbolic::Sym;

/// A statement and the degree to which it is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// The quantity of the statement: energy, momentum of x, constraint 1.
    pub subject: String,
    /// The statement in words.
    pub says: String,
    pub agreement: Agreement,
}

/// All statements that a model makes by itself.
pub fn statements(trace: &Trace<'_>) -> Vec<Statement> {
    let mut all = vec![power_balance::statement(trace)];
    all.extend(momenta::statements(trace));
    all.extend(constraint_rates::statements(trace));
    all
}

/// A sentence about a motion whose law may change at events and conditions, and which may jump there.
fn piecewise(trace: &Trace<'_>, says: &str) -> String {
    let changes = !(trace.model.events.is_empty() && trace.model.switches.is_empty());
    if changes { format!("between events {says}") } else { says.to_owned() }
}

/// A sentence about expressions that inputs without a value stand in: rates take such an input as a constant.
fn while_inputs_rest(trace: &Trace<'_>, of: &[Sym], says: String) -> String {
    let known: Vec<Sym> = of.iter().flat_map(|expression| expression.symbols_of()).collect();
    let open = trace.model.inputs.iter().filter(|input| input.value.is_none());
    let open: Vec<&str> =
        open.map(|input| input.name.as_str()).filter(|name| known.contains(&Sym::symbol(name))).collect();
    if open.is_empty() { says } else { format!("at constant {}: {says}", open.join(", ")) }
}

/// Inertia less forces, by bodies where they are known, so that energies are compared with equations derived without them.
fn residual(trace: &Trace<'_>) -> Vec<Sym> {
    let by_bodies = Principle::VirtualPower.residual(trace);
    by_bodies.or_else(|_| Principle::Lagrange.residual(trace)).unwrap_or_default()
}
