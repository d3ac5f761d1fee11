//! A theorem about the principles: for any masses, inertias and forces they give the same equations.
//!
//! The theorem does not depend on a system. Letters stand for any vectors, with their rates and derivatives; each lemma is
//! decided by normal form, once in a process:
//!
//! | lemma | it says |
//! |---|---|
//! | [`functions`] | for a function c of positions and time, c' by a speed is c by its coordinate, and both derivatives commute |
//! | [`frames`] | d(dw/du)/dt - dw/dq = w x dw/du, from a frame to one that turns in it by an angle or freely |
//! | [`points`] | dr/dq = dv/du = da/du' and d(dv/du)/dt = dv/dq, from a point to one that is found from it |
//! | [`bodies`] | then d/dt dT/du - dT/dq = m a . dv/du + (I w)' . dw/du = dS/du' |
//! | [`energies`] | Hamilton's, Hamel's and Shulgin's equations are Lagrange's for any T; weights, potentials and dissipation as they stand in them |
//! | [`multipliers`] | they drop out along the directions that constraints leave |
//! | [`joints`] | the loads of joints do no work on motions that the joints leave |
//!
//! From the ground outwards the lemmas reach every frame and every point of a model, one step after the other. The conditions on a
//! model are read off its parts ([`hypotheses`]).

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

/// Two sides of an equation that a lemma states.
type Equations = Vec<(Sym, Sym)>;

/// Every lemma.
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

/// Whether the theorem says of a model that a principle gives Lagrange's equations.
pub(crate) fn holds(trace: &Trace<'_>, principle: Principle) -> bool {
    hypotheses::are_fulfilled(trace, principle) && all_are_proved()
}

/// Whether the theorem says of a model that Shulgin's equations are Lagrange's along the directions that constraints leave.
pub(crate) fn holds_on_constraints(trace: &Trace<'_>) -> bool {
    hypotheses::are_functions_of_places(trace) && all_are_proved()
}

/// Whether the theorem says that multipliers drop out along du/dw, for any rows of constraints.
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
