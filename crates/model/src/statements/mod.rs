//! Statements about the motion of a model, each with its verdict: on its energy, its momenta, its constraints, and on the terms that
//! mistaken derivations lose.

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

/// A statement, and the degree of certainty of its agreement with the equations.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// The subject: "energy", "momentum of x", "constraint 1".
    pub subject: String,
    /// The statement in words.
    pub says: String,
    pub agreement: Agreement,
}

/// Returns all statements that follow from a model itself.
pub fn statements(trace: &Trace<'_>) -> Vec<Statement> {
    let mut all = vec![power_balance::statement(trace)];
    all.extend(momenta::statements(trace));
    all.extend(constraint_rates::statements(trace));
    all
}

/// Restricts a sentence to the time between events, if the law changes at events or conditions.
fn piecewise(trace: &Trace<'_>, says: &str) -> String {
    let changes = !(trace.model.events.is_empty() && trace.model.switches.is_empty());
    if changes { format!("between events {says}") } else { says.to_owned() }
}

/// Restricts a sentence to constant inputs, if the expressions contain inputs without a value: time derivatives treat these as constant.
fn while_inputs_rest(trace: &Trace<'_>, of: &[Sym], says: String) -> String {
    let known: Vec<Sym> = of.iter().flat_map(|expression| expression.symbols_of()).collect();
    let open = trace.model.inputs.iter().filter(|input| input.value.is_none());
    let open: Vec<&str> =
        open.map(|input| input.name.as_str()).filter(|name| known.contains(&Sym::symbol(name))).collect();
    if open.is_empty() { says } else { format!("at constant {}: {says}", open.join(", ")) }
}

/// Returns inertia minus forces, by bodies if possible, so that statements on energies are compared with equations that were derived without energies.
fn residual(trace: &Trace<'_>) -> Vec<Sym> {
    let by_bodies = Principle::VirtualPower.residual(trace);
    by_bodies.or_else(|_| Principle::Lagrange.residual(trace)).unwrap_or_default()
}
