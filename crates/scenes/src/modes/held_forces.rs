//! Sticking friction with a bound that depends on an unknown, such as a reaction.
//!
//! The equations for the unknowns u depend on a switch s by
//!
//!   E_i(u, s) = E_i(u, 1/2) + d_i (s - 1/2) W(u)
//!
//! with one friction bound W and constant factors d. The force F = (s - 1/2) W replaces s as an unknown: the equations and the rate of
//! the held condition are linear in u and F, and s follows from F.

use super::unknown_speeds::Elimination;
use field::Scalar as _;
use model::equations::vanishes;
use symbolic::{Derivation, Sym, substitute_all};

/// True if a switch multiplies unknowns in some equation.
pub(super) fn multiplies(switch: Sym, zeros: &[Sym], unknowns: &[Sym]) -> bool {
    zeros.iter().any(|zero| by(*zero, switch).symbols_of().iter().any(|letter| unknowns.contains(letter)))
}

/// Expressions of the unknowns and switches, from the equations `zeros` and the rates of the conditions in `held` (pairs of switch and
/// rate). `None` if these are not linear in the unknowns and forces.
pub(super) fn held_forces(unknowns: &[Sym], held: &[(Sym, Sym)], zeros: &[Sym]) -> Option<Vec<(Sym, Sym)>> {
    let switches: Vec<Sym> = held.iter().map(|(switch, _)| *switch).collect();
    let half = Sym::ONE / Sym::int(2);
    let middle: Vec<(Sym, Sym)> = switches.iter().map(|&switch| (switch, half)).collect();
    // any values serve, since a constant quotient does not depend on the unknowns
    let some = unknowns.iter().zip(2_i64..).map(|(&letter, number)| (letter, Sym::ratio(2 * number + 1, number)));
    let some: Vec<(Sym, Sym)> = some.chain(middle.iter().copied()).collect();
    let forces: Vec<Sym> = (0..held.len()).map(|number| Sym::symbol(&format!("held force {number}"))).collect();
    let mut equations: Vec<Sym> = zeros.iter().copied().chain(held.iter().map(|(_, rate)| *rate)).collect();
    let slopes: Vec<Vec<Sym>> = switches.iter().map(|&s| equations.iter().map(|&zero| by(zero, s)).collect()).collect();
    let mut bounds = Vec::new();
    equations = substitute_all(&equations, &middle);
    for (number, (slopes, &force)) in slopes.iter().zip(&forces).enumerate() {
        // derivative of the rate of the condition by its own switch
        let bound = slopes[zeros.len() + number];
        if vanishes(bound) {
            return None;
        }
        let at_some = bound.substitute(&some);
        for (equation, &slope) in equations.iter_mut().zip(slopes) {
            if slope == Sym::ZERO {
                continue;
            }
            let own = slope.substitute(&some);
            if !vanishes(slope * at_some - own * bound) {
                return None;
            }
            *equation += own / at_some * force;
        }
        bounds.push(bound);
    }
    let all: Vec<Sym> = unknowns.iter().chain(&forces).copied().collect();
    let found = Elimination::of(&all).solved(&equations, |_| None)?;
    let (values, found_forces) = found.split_at(unknowns.len());
    let known: Vec<(Sym, Sym)> = unknowns.iter().copied().zip(values.iter().copied()).collect();
    let bounds = substitute_all(&bounds, &known);
    let switch = |((&switch, &force), bound): ((&Sym, &Sym), Sym)| (switch, half + force / bound);
    let switches = switches.iter().zip(found_forces).zip(bounds).map(switch).collect::<Vec<_>>();
    Some(known.into_iter().chain(switches).collect())
}

/// The partial derivative of an expression by a symbol.
fn by(expression: Sym, letter: Sym) -> Sym {
    Derivation::new([(letter, Sym::ONE)]).of(expression)
}
