//! Accelerations of contacts along their tangents, at one state in many modes.
//!
//! Where rows are linear in switches and reactions, their values and slopes are evaluated once, and a mode costs one elimination.

use super::super::contacts::PARTS;
use super::super::jet::Jet;
use super::super::mode::Mode;
use super::{Expansions, Instant, solved};
use num_traits::Zero;

/// Rows and their slopes, at a state and in the cases of conditions.
pub(in super::super) struct Accelerations<'a> {
    expansions: &'a Expansions,
    values: Vec<Jet<1>>,
}

impl<'a> Accelerations<'a> {
    /// None where rows are not linear, or speeds are algebraic.
    pub fn of(expansions: &'a Expansions, Instant { time, state, .. }: &Instant<'_>, mode: &Mode) -> Option<Self> {
        if expansions.has_algebraic() || expansions.slopes.iter().any(|slope| !slope.changed_by.is_empty()) {
            return None;
        }
        let exact = |value: f64| Jet::constant(value, 0.0);
        let parts: Vec<Jet<1>> = state.iter().map(|&part| exact(part)).collect();
        let letters = expansions.letters_in(&mode.cases);
        Some(Accelerations { expansions, values: expansions.values(exact(*time), &parts, &letters, &[]) })
    }

    /// Those along both tangents of each contact, in a mode with these cases; none where its reactions are not determined.
    pub fn along_tangents(&self, mode: &Mode) -> Option<Vec<[f64; 2]>> {
        let Accelerations { expansions, values } = self;
        let (tied, mut unknown) = (expansions.tied(mode, values), expansions.held(mode));
        unknown.extend(expansions.unknown_reactions(mode));
        let row = |letter: usize| values[expansions.states + mode.cases.len() + letter];
        let slopes = expansions.slopes_by(values, &tied, &unknown, &unknown);
        let found = solved(slopes, unknown.iter().map(|&letter| -row(letter)).collect())?;
        let tangents: Vec<usize> =
            (0..tied.len()).flat_map(|contact| [1, 2].map(|part| expansions.reaction([contact, part]))).collect();
        let moved = expansions.slopes_by(values, &tied, &tangents, &unknown);
        let rate = |(&tangent, slopes): (&usize, &Vec<Jet<1>>)| {
            let through = slopes.iter().zip(&found).fold(Jet::zero(), |sum: Jet<1>, (slope, one)| sum + *slope * *one);
            (row(tangent) + through).terms[0]
        };
        let rates: Vec<f64> = tangents.iter().zip(&moved).map(rate).collect();
        Some(rates.as_chunks::<{ PARTS - 1 }>().0.to_vec())
    }
}
