//! The premises of certificates: equations, and the steps from them to values of symbols.

use crate::conditions::Hypothesis;
use crate::motion::{Motion, equations_of_motion};
use claims::Condition;
use claims::certificate::{Relation, Relations, Step};
use symbolic::{Hypotheses, Sym};

/// The equations that hold on a motion, and the steps that determine the values of its symbols from them.
pub(crate) fn premises(
    motion: &Motion<'_, '_>,
    assumed: &[Hypothesis],
    relations: &mut Relations,
) -> (Vec<Relation>, Vec<Step>) {
    let mut equalities: Vec<Sym> = motion.held.clone();
    let mut given: Vec<Relation> = equalities.iter().map(|&zero| relations.of(Condition::Zero(zero))).collect();
    let mut steps = Vec::new();
    let mut known: Vec<Sym> = Vec::new();
    for round in &motion.rounds {
        let zeros = round.by.clone().unwrap_or_else(|| equations_of_motion(motion.trace));
        let mut place = |zero: Sym, relations: &mut Relations| match equalities.iter().position(|one| *one == zero) {
            Some(place) => place,
            None => {
                equalities.push(zero);
                given.push(relations.of(Condition::Zero(zero)));
                given.len() - 1
            }
        };
        let by = zeros.into_iter().map(|zero| place(zero, relations)).collect();
        // a symbol that an earlier round replaced no longer occurs
        let new: Vec<(Sym, Sym)> = round.values.iter().copied().filter(|(symbol, _)| !known.contains(symbol)).collect();
        known.extend(new.iter().map(|&(symbol, _)| symbol));
        if !new.is_empty() {
            let letters = new.iter().map(|&(symbol, _)| relations.recorder.place(symbol)).collect();
            let values = new.iter().map(|&(_, value)| relations.recorder.place(value)).collect();
            steps.push(Step::Solve { letters, values, by });
        }
    }
    for &(coordinate, zero) in &motion.squares {
        let by = given.len();
        given.push(relations.of(Condition::Zero(zero)));
        steps.push(Step::Rewrite { letter: relations.recorder.place(coordinate), power: 2, by });
    }
    relations.rules(&motion.with_free_frames(Hypotheses::none()), &mut given, &mut steps);
    let conditions: Vec<Condition> = assumed.iter().filter_map(|hypothesis| hypothesis.condition).collect();
    given.extend(relations.all(&conditions));
    (given, steps)
}
