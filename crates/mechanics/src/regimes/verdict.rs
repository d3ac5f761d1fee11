//! The consistent regimes of a state, and the number of motions among them.

use super::dry::Pairs;
use super::mode::modes;
use super::reactions::{Reactions, reactions, sign_at};
use super::{Condition, Dry, Mode, Ordered, Touch, conditions};
use std::cmp::Ordering;

/// A consistent regime.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found<S, const K: usize> {
    pub regime: [Mode; K],
    /// The normal and tangential reaction of each contact, N.
    pub reactions: Pairs<S, K>,
    /// The normal and tangential acceleration of each contact, m/s^2; they identify the motion.
    pub motion: Pairs<S, K>,
    /// Whether the motion determines the reactions.
    pub determined: bool,
    /// Whether the regime admits exactly one motion.
    pub single: bool,
    /// The first condition that holds with equality (over rounded scalars: within rounding), with its contact.
    pub tie: Option<(usize, Condition)>,
}

/// The number of consistent motions, with examples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Consistency<S, const K: usize> {
    /// One motion.
    Unique(Found<S, K>),
    /// No consistent motion.
    None,
    /// At least two different motions.
    Several(Found<S, K>, Found<S, K>),
    /// A regime whose equations are singular admits infinitely many motions.
    Continuum(Found<S, K>),
    /// The state or the force is not finite.
    Undefined,
}

impl<S: Ordered, const K: usize> Dry<S, K> {
    fn defined(&self) -> bool {
        let rows = self.response.as_flattened().iter().chain([&self.free]);
        rows.flat_map(|row| row.as_flattened()).chain(&self.friction).all(|x| x.defined())
    }
}

/// Visits every consistent regime, in the order of the modes.
pub fn consistent<S: Ordered, const K: usize>(
    dry: &Dry<S, K>,
    touches: &[Touch; K],
    mut visit: impl FnMut(Found<S, K>),
) {
    let mut regime = [Mode::Apart; K];
    choose(dry, touches, 0, &mut regime, &mut visit);
}

/// Enumerates the modes of this contact and the following ones.
fn choose<S: Ordered, const K: usize>(
    dry: &Dry<S, K>,
    touches: &[Touch; K],
    contact: usize,
    regime: &mut [Mode; K],
    visit: &mut impl FnMut(Found<S, K>),
) {
    if contact == K {
        visit_if_consistent(dry, touches, regime, visit);
        return;
    }
    for mode in modes(touches[contact], dry.sides[contact], dry.friction[contact]) {
        regime[contact] = mode;
        choose(dry, touches, contact + 1, regime, visit);
    }
}

fn visit_if_consistent<S: Ordered, const K: usize>(
    dry: &Dry<S, K>,
    touches: &[Touch; K],
    regime: &[Mode; K],
    visit: &mut impl FnMut(Found<S, K>),
) {
    let (reactions, determined, single) = match reactions(dry, touches, regime) {
        Reactions::None => return,
        Reactions::One { reactions, determined } => (reactions, determined, true),
        Reactions::Continuum(reactions) => (reactions, false, false),
    };
    let conditions = conditions(dry, touches, regime);
    let of_contacts = (0..K).flat_map(|k| conditions[k].iter().flatten().map(move |(name, form)| (k, *name, form)));
    // if the motion does not determine the reactions, a tie of one solution is not a property of the motion
    let tie = of_contacts
        .filter(|(_, _, form)| determined && sign_at(form, &reactions) == Ordering::Equal)
        .map(|(k, name, _)| (k, name))
        .next();
    let motion = std::array::from_fn(|k| std::array::from_fn(|i| dry.acceleration(k, i).at(&reactions)));
    visit(Found { regime: *regime, reactions, motion, determined, single, tie });
}

/// Counts the consistent motions.
pub fn verdict<S: Ordered, const K: usize>(dry: &Dry<S, K>, touches: &[Touch; K]) -> Consistency<S, K> {
    if !dry.defined() {
        return Consistency::Undefined;
    }
    let mut verdict = Consistency::None;
    consistent(dry, touches, |found| {
        verdict = match verdict {
            _ if !found.single => Consistency::Continuum(found),
            Consistency::None => Consistency::Unique(found),
            Consistency::Unique(first) if differ(dry, &first, &found) => Consistency::Several(first, found),
            other => other,
        };
    });
    verdict
}

/// Whether two regimes have different motions.
pub fn differ<S: Ordered, const K: usize>(dry: &Dry<S, K>, a: &Found<S, K>, b: &Found<S, K>) -> bool {
    (0..K).any(|k| {
        (0..2).any(|i| {
            let form = dry.acceleration(k, i);
            let difference = std::array::from_fn(|k| std::array::from_fn(|i| a.reactions[k][i] - b.reactions[k][i]));
            let size = |pairs: &Pairs<S, K>| pairs.as_flattened().iter().fold(S::zero(), |sum, x| sum + x.size());
            let among = size(&form.row) * (size(&a.reactions) + size(&b.reactions));
            form.homogeneous().at(&difference).sign_among(among) != Ordering::Equal
        })
    })
}
