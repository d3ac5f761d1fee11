//! Hypotheses under which the model has no inertia, so that its equations determine no accelerations.

use crate::conditions::{assume, hypotheses};
use crate::inertia::inertia_determinant;
use crate::letters::Letters;
use crate::motion::Motion;
use crate::passage::Passage;
use symbolic::{Identity, Sym, decide, identified};

/// Whether the mass matrix is singular under the hypotheses, and is not without the last of them.
pub(super) fn takes_inertia(given: &[Passage], letters: &Letters<'_, '_>) -> bool {
    let (Some((_, before)), Some(determinant)) = (given.split_last(), inertia_determinant(letters.trace)) else {
        return false;
    };
    let is_singular = |given: &[Passage]| {
        let mut motion = Motion::by_constraints(letters.trace);
        let is_assumed = hypotheses(given, letters).is_ok_and(|assumed| assume(&mut motion, &assumed).is_ok());
        is_assumed && vanishes(determinant, &motion)
    };
    is_singular(given) && !is_singular(before)
}

fn vanishes(expression: Sym, motion: &Motion<'_, '_>) -> bool {
    let reduced = motion.reduced(expression);
    match identified(&[reduced]) {
        Identity::Identified { .. } => true,
        Identity::NotZero if motion.hypotheses.statements().is_empty() => false,
        _ => decide(reduced, &motion.hypotheses).is_zero(),
    }
}
