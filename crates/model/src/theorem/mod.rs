//! A theorem on the principles: for any masses, inertias and forces they give equal equations.
//!
//! The theorem does not depend on a system. Symbols represent arbitrary vectors with their rates and derivatives. Each lemma is
//! decided by normal form, once per process:
//!
//! | lemma | statement |
//! |---|---|
//! | [`functions`] | dc'/du = dc/dq for a function c of positions and time, and both derivatives commute |
//! | [`frames`] | d(dw/du)/dt - dw/dq = w x dw/du; from a frame to its children, which rotate by an angle or freely |
//! | [`points`] | dr/dq = dv/du = da/du' and d(dv/du)/dt = dv/dq; from a point to points defined from it |
//! | [`bodies`] | d/dt dT/du - dT/dq = m a . dv/du + (I w)' . dw/du = dS/du', given the properties above |
//! | [`energies`] | Hamilton's, Hamel's and Shulgin's equations are Lagrange's for any T; the terms of weights, potentials and dissipation agree |
//! | [`multipliers`] | multipliers cancel along the admissible directions of constraints |
//! | [`joints`] | joint loads have no power on motions that the joints admit |
//!
//! By induction from the ground outwards, the lemmas cover every frame and every point of a model. The hypotheses are
//! checked on the parts of a model ([`hypotheses`]).

mod bodies;
mod directions;
mod energies;
mod frames;
mod functions;
mod hypotheses;
mod joints;
mod multipliers;
mod points;

use crate::Trace;
use crate::principles::Principle;
use std::sync::OnceLock;
use symbolic::{Hypotheses, Sym, apart, decide};

/// Pairs of sides (left, right) that a lemma states to be equal.
type Equations = Vec<(Sym, Sym)>;

/// All lemmas.
const LEMMAS: [fn() -> Equations; 17] = [
    functions::of_places,
    frames::turned_by_an_angle,
    frames::turned_freely,
    frames::turned_in_one_that_turns_freely,
    points::found_by_a_way,
    points::carried_by_a_body,
    bodies::masses,
    bodies::inertias,
    bodies::inertias_beside_a_spin,
    energies::weights,
    energies::potentials,
    energies::dissipation,
    energies::canonical,
    energies::quasi_velocities,
    energies::constrained,
    joints::carried,
    multipliers::eliminated,
];

/// Returns whether the theorem states that a principle gives Lagrange's equations for a model.
pub(crate) fn holds(trace: &Trace<'_>, principle: Principle) -> bool {
    hypotheses::are_fulfilled(trace, principle) && all_are_proved()
}

/// Returns whether the theorem states that Shulgin's equations are Lagrange's along the admissible directions, for a model.
pub(crate) fn holds_on_constraints(trace: &Trace<'_>) -> bool {
    hypotheses::are_functions_of_places(trace) && all_are_proved()
}

/// Returns whether the theorem states that multipliers cancel along du/dw, for any rows of constraints.
pub(crate) fn holds_for_any_rows() -> bool {
    all_are_proved()
}

fn all_are_proved() -> bool {
    static ALL: OnceLock<bool> = OnceLock::new();
    *ALL.get_or_init(|| LEMMAS.into_iter().all(is_proved))
}

fn is_proved(lemma: fn() -> Equations) -> bool {
    apart(|| lemma().into_iter().all(|(one, other)| decide(one - other, &Hypotheses::none()).is_zero()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_lemma_is_proved() {
        for (place, lemma) in LEMMAS.into_iter().enumerate() {
            assert!(is_proved(lemma), "lemma {}", place + 1);
        }
    }
}
