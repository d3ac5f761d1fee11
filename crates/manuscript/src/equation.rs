//! Decisions whether two sides are equal along motions: a proof, or an exact point at which they differ.

use crate::admissible::admissible;
use crate::exact_points::{Effort, completed, search};
use crate::half_turn::{is_number_of_half_turn, sign_of_number};
use crate::lost_divisors::Lost;
use crate::motion::Motion;
use crate::refutation::Refutation;
use crate::turned_points;
use claims::Condition;
use model::equations::constraints_of;
use symbolic::{Decision, HIGHEST_MULTIPLE, Identity, Node, Sym, Witness, decide, identified};

/// The decision on an expression that should vanish.
pub(crate) enum Outcome {
    /// The expression vanishes for all values for which these divisors do not.
    Zero(Vec<Sym>),
    /// The expression does not vanish at an exact point.
    NonZero(Refutation),
    /// This denominator vanishes identically.
    Undefined(Sym),
    /// The expression vanishes at random points of prime fields, and its normal form was not reached; the text states this.
    Identified(String),
    Undecided(String),
}

/// No normal form of longer expressions is computed: they are evaluated in prime fields and at exact points.
const MOST_EXPANDED: usize = 4_000;

/// The number of operations, common parts counted once, beyond which an exact point is looked for before the normal form is computed.
const MANY: usize = 1_000;

/// The largest number of points at which angles are fractions of pi.
const POINTS_OF_ANGLES: u32 = 200;

/// Whether an expression is zero along the motion where the conditions hold.
pub(crate) fn vanishes(motion: &Motion<'_, '_>, expression: Sym, conditions: &[Condition]) -> Outcome {
    vanishes_within(motion, expression, conditions, Effort::Whole)
}

/// The decision of [`vanishes`]; a counterexample with physically possible parameters is preferred.
pub(crate) fn vanishes_or_fails(motion: &Motion<'_, '_>, expression: Sym, conditions: &[Condition]) -> Outcome {
    let again = |within: &[Condition]| match vanishes_within(motion, expression, within, Effort::Part) {
        Outcome::NonZero(refutation) => Some(refutation),
        _ => None,
    };
    match vanishes(motion, expression, conditions) {
        Outcome::NonZero(refutation) => Outcome::NonZero(admissible(refutation, motion, conditions, again)),
        outcome => outcome,
    }
}

/// The decision of [`vanishes`] with the given effort in the search for points.
pub(crate) fn vanishes_within(
    motion: &Motion<'_, '_>,
    expression: Sym,
    conditions: &[Condition],
    effort: Effort,
) -> Outcome {
    match found(motion, expression, conditions, effort) {
        Outcome::Zero(mut divisors) => match motion.lost_divisors(expression) {
            Lost::Zero(why) => Outcome::Undecided(why),
            Lost::Divisors(lost) => {
                divisors.extend(lost);
                Outcome::Zero(divisors)
            }
        },
        Outcome::NonZero(refutation) if !refutation.is_confirmed(expression, motion) => {
            let why = "its normal form is not zero, but its value at the exact point that was found was not confirmed";
            Outcome::Undecided(why.to_owned())
        }
        outcome => outcome,
    }
}

fn found(motion: &Motion<'_, '_>, expression: Sym, conditions: &[Condition], effort: Effort) -> Outcome {
    let reduced = motion.reduced(expression);
    if Sym::operations_of(&[reduced]) > MOST_EXPANDED
        && let Some(found) = at_points(motion, reduced, conditions, effort)
    {
        return found;
    }
    // the normal form of an expression of a linkage outgrows every limit, so that an exact point is looked for first
    if Sym::operations_of(&[reduced]) > MANY
        && let Some(found) = refuted_at_a_point(motion, reduced, conditions, effort)
    {
        return found;
    }
    match decide(reduced, &motion.hypotheses) {
        Decision::Zero(proof) => Outcome::Zero(proof.requires),
        Decision::Undefined(denominator) => Outcome::Undefined(denominator),
        // a number such as sin(1) differs from zero by its enclosure; no exact point is necessary
        Decision::GaveUp(_) if sign_of_number(reduced).is_some_and(|sign| sign != 0) => {
            Outcome::NonZero(Refutation { point: Vec::new(), is_formal: false })
        }
        Decision::GaveUp(reason) => match identified(&[reduced]) {
            Identity::Identified { points, error, .. } => of_identity(points, error),
            Identity::Untested(why) => Outcome::Undecided(format!(
                "{reason}{}; random points of prime fields do not decide either: {why}",
                above_highest_multiple(reduced)
            )),
            Identity::NotZero => refuted_at_a_point(motion, reduced, conditions, effort)
                .unwrap_or_else(|| Outcome::Undecided(reason + &above_highest_multiple(reduced))),
        },
        Decision::NonZero(witness) => refuted(motion, reduced, (witness, effort), conditions),
    }
}

/// The refutation of an expression by an exact point, without its normal form; `None` if random points of prime fields do not differ, or no point is found.
fn refuted_at_a_point(
    motion: &Motion<'_, '_>,
    reduced: Sym,
    conditions: &[Condition],
    effort: Effort,
) -> Option<Outcome> {
    let is_determined = motion.undetermined(reduced).is_none() && motion.open.is_empty();
    if !is_determined || !matches!(identified(&[reduced]), Identity::NotZero) {
        return None;
    }
    match (search(&[reduced], conditions, motion, effort, |signs| signs[0] != 0), effort) {
        (Some(refutation), _) => Some(Outcome::NonZero(refutation)),
        (None, Effort::Part) => Some(Outcome::Undecided("no plainer point was found".to_owned())),
        (None, Effort::Whole) => None,
    }
}

/// A sentence about multiples of an angle that the normal form does not expand; empty if there are none.
fn above_highest_multiple(expression: Sym) -> String {
    let is_above = |leaf: Sym| match leaf.node() {
        Node::Cos(angle) | Node::Sin(angle) => {
            angle.linear_terms().iter().any(|(_, factor)| factor.to_f64().abs() > HIGHEST_MULTIPLE as f64)
        }
        _ => false,
    };
    match expression.leaves_of().into_iter().any(is_above) {
        true => format!("; sines and cosines of more than {HIGHEST_MULTIPLE} times an angle are not expanded"),
        false => String::new(),
    }
}

fn of_identity(points: usize, error: f64) -> Outcome {
    Outcome::Identified(format!(
        "equal at {points} random points of random prime fields; the probability of error is below 2^{:.0}",
        error.ceil()
    ))
}

/// The decision on a long expression by points, without its normal form; `None` if points do not decide.
fn at_points(motion: &Motion<'_, '_>, reduced: Sym, conditions: &[Condition], effort: Effort) -> Option<Outcome> {
    match identified(&[reduced]) {
        Identity::Identified { points, error, .. } => Some(of_identity(points, error)),
        Identity::NotZero => Some(match search(&[reduced], conditions, motion, effort, |signs| signs[0] != 0) {
            Some(refutation) => Outcome::NonZero(refutation),
            None => {
                let why = "the difference is not zero at a random point of a prime field, and no exact point was found that shows it";
                Outcome::Undecided(why.to_owned())
            }
        }),
        _ => None,
    }
}

/// The decision for an expression whose normal form is not zero: refuted if the witness, or another point, satisfies all conditions.
fn refuted(
    motion: &Motion<'_, '_>,
    reduced: Sym,
    (witness, effort): (Witness, Effort),
    conditions: &[Condition],
) -> Outcome {
    if let Some(letter) = motion.undetermined(reduced) {
        return Outcome::Undecided(format!(
            "the difference holds {}, which the equations of motion do not determine",
            named(letter, motion)
        ));
    }
    if let Some(open) = motion.open.first() {
        return Outcome::Undecided(format!(
            "the normal form of the difference is not zero, but its points may violate {open}"
        ));
    }
    let found = |witness: Witness| Refutation {
        is_formal: !witness.formal.is_empty(),
        point: witness.point.into_iter().filter(|(leaf, _)| !is_number_of_half_turn(*leaf)).collect(),
    };
    if let Some(refutation) = completed(found(witness), conditions) {
        return Outcome::NonZero(at_real_angles(&refutation, motion, reduced, conditions).unwrap_or(refutation));
    }
    // positive letters are replaced by squares, except within angles, where the square would have no exact sine
    let is_in_angle = |letter: Sym| {
        reduced.leaves_of().into_iter().any(|leaf| match leaf.node() {
            Node::Cos(angle) | Node::Sin(angle) => angle.symbols_of().contains(&letter),
            _ => false,
        })
    };
    let positive = conditions.iter().filter_map(|condition| match condition {
        Condition::Positive(e) if e.symbol_name().is_some() && !is_in_angle(*e) => {
            Some((*e, Sym::symbol(&format!("root of {e}"))))
        }
        _ => None,
    });
    let positive: Vec<(Sym, Sym)> = positive.collect();
    let squares: Vec<(Sym, Sym)> = positive.iter().map(|&(symbol, root)| (symbol, root * root)).collect();
    if let Decision::NonZero(mut witness) = decide(reduced.substitute(&squares), &motion.hypotheses) {
        for &(symbol, root) in &positive {
            if let Some((name, value)) = witness.point.iter_mut().find(|(known, _)| *known == root) {
                (*name, *value) = (symbol, value.powi(2));
            }
        }
        if let Some(refutation) = completed(found(witness), conditions) {
            return Outcome::NonZero(refutation);
        }
    }
    match search(&[reduced], conditions, motion, effort, |signs| signs[0] != 0) {
        Some(refutation) => Outcome::NonZero(refutation),
        None => {
            let why = "the difference is not zero, but no exact point was found that satisfies the hypotheses";
            Outcome::Undecided(why.to_owned())
        }
    }
}

/// A point at which angles are fractions of pi, in the place of one that takes sines and cosines as independent of their angles.
fn at_real_angles(
    formal: &Refutation,
    motion: &Motion<'_, '_>,
    reduced: Sym,
    conditions: &[Condition],
) -> Option<Refutation> {
    if !formal.is_formal || !motion.hypotheses.statements().is_empty() {
        return None;
    }
    let found = turned_points::find(&[reduced], conditions, POINTS_OF_ANGLES, |signs| signs[0] != 0)?;
    found.is_confirmed(reduced, motion).then_some(found)
}

/// The name of a symbol for readers; a multiplier is named as the reaction of its constraint.
fn named(symbol: Sym, motion: &Motion<'_, '_>) -> String {
    let constraints = constraints_of(motion.trace);
    let place = constraints.iter().position(|one| one.multiplier == symbol);
    place.map_or_else(|| symbol.to_string(), |place| format!("the reaction of {}", constraints[place].title(place)))
}
