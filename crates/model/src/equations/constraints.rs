//! Constraints as equations between accelerations.

use crate::{Constraint, Trace};
use std::ops::Range;
use symbolic::{Hypotheses, Identity, Sym, decide, identified};

/// Whether a constraint speaks of positions or of speeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    Position,
    Speed,
}

/// A scalar constraint f = 0.
#[derive(Clone, Debug)]
pub struct Equation {
    /// As the model names it; empty where it does not.
    pub name: String,
    pub level: Level,
    /// f.
    pub zero: Sym,
    /// df/dt of a constraint of positions; f itself of one of speeds.
    pub rate: Sym,
    /// The row of J: the derivatives of that by the speeds.
    pub row: Vec<Sym>,
    /// c: what is left of the next rate where accelerations are zero.
    pub bias: Sym,
    /// Where the model has it.
    pub at: Range<usize>,
}

/// One for each scalar, and for each component of a vector that does not vanish identically.
pub fn equations(trace: &Trace<'_>) -> Vec<Equation> {
    let mut all = Vec::new();
    for constraint in &trace.model.constraints {
        match constraint {
            Constraint::Scalar { name, zero, at } => all.push(equation(trace, name, trace.scalar(*zero), at)),
            Constraint::Vector { name, zero, at } => {
                let components = trace.vector(*zero).components.into_iter();
                let held = components.filter(|component| !vanishes(*component));
                all.extend(held.map(|component| equation(trace, name, component, at)));
            }
        }
    }
    all
}

/// Whether a component is zero for all values: by random points of prime fields, or by its normal form where it has roots.
fn vanishes(component: Sym) -> bool {
    match identified(&[component]) {
        Identity::Identified { .. } => true,
        Identity::NotZero => false,
        Identity::Untested(_) => decide(component, &Hypotheses::none()).is_zero(),
    }
}

fn equation(trace: &Trace<'_>, name: &Option<String>, zero: Sym, at: &Range<usize>) -> Equation {
    let symbols = zero.symbols_of();
    let level = match trace.speeds.iter().any(|speed| symbols.contains(speed)) {
        true => Level::Speed,
        false => Level::Position,
    };
    let rate = if level == Level::Position { trace.rate_of(zero) } else { zero };
    let row: Vec<Sym> = (0..trace.speeds.len()).map(|i| trace.by_speed(rate, i)).collect();
    let at_rest: Vec<(Sym, Sym)> = trace.accelerations.iter().map(|&symbol| (symbol, Sym::ZERO)).collect();
    let bias = trace.rate_of(rate).substitute(&at_rest);
    Equation { name: name.clone().unwrap_or_default(), level, zero, rate, row, bias, at: at.clone() }
}
