//! Whether two sides are equal where a motion is: exactly, or an exact point at which they are not.

use crate::motion::Motion;
use claims::{Condition, Point};
use symbolic::{Decision, Hypotheses, Identity, Sym, Witness, decide, identified, normal};

/// What is found of an expression that should vanish.
pub(crate) enum Outcome {
    /// For all values; these divisors must not vanish.
    Zero(Vec<Sym>),
    /// At an exact point the expression has another value.
    NonZero(Refutation),
    /// This denominator vanishes everywhere.
    Undefined(Sym),
    /// It vanishes at random points of prime fields, and no normal form was reached.
    Identified(String),
    Undecided(String),
}

/// An exact point at which an expression does not vanish.
pub(crate) struct Refutation {
    /// Symbols of the model, cosines and sines of its angles, with their values.
    pub point: Vec<(Sym, Sym)>,
    /// Whether sines and cosines are taken as independent of their angles.
    pub is_formal: bool,
}

impl Refutation {
    /// The value of an expression there, where the point gives it one.
    pub fn value(&self, expression: Sym) -> Option<Sym> {
        let found = expression.substitute(&self.point);
        let form = normal(found, &Hypotheses::none()).ok()?.to_sym();
        form.symbols_of().is_empty().then_some(form)
    }
}

/// Whether an expression vanishes where the motion is and the conditions hold.
pub(crate) fn vanishes(motion: &Motion<'_, '_>, expression: Sym, conditions: &[Condition]) -> Outcome {
    let reduced = motion.reduced(expression);
    match decide(reduced, &motion.hypotheses) {
        Decision::Zero(proof) => Outcome::Zero(proof.requires),
        Decision::Undefined(denominator) => Outcome::Undefined(denominator),
        Decision::GaveUp(reason) => match identified(&[reduced]) {
            Identity::Identified { points, error, .. } => Outcome::Identified(format!(
                "equal at {points} random points of random prime fields; the probability of error is below 2^{:.0}",
                error.ceil()
            )),
            _ => Outcome::Undecided(reason),
        },
        Decision::NonZero(witness) => refuted(motion, reduced, witness, conditions),
    }
}

/// A witness counts where it satisfies everything.
fn refuted(motion: &Motion<'_, '_>, reduced: Sym, witness: Witness, conditions: &[Condition]) -> Outcome {
    if let Some(letter) = motion.undetermined(reduced) {
        return Outcome::Undecided(format!(
            "the difference holds {letter}, which the equations of motion do not determine"
        ));
    }
    if let Some(open) = motion.open.first() {
        return Outcome::Undecided(format!(
            "the normal form of the difference is not zero, but its points may violate {open}"
        ));
    }
    if admits(&witness, conditions) {
        return Outcome::NonZero(Refutation { is_formal: !witness.formal.is_empty(), point: witness.point });
    }
    // letters that are positive are squares
    let positive: Vec<(Sym, Sym, Sym)> = conditions
        .iter()
        .filter_map(|condition| match condition {
            Condition::Positive(e) if e.symbol_name().is_some() => {
                let root = Sym::symbol(&format!("root of {e}"));
                Some((*e, root, root * root))
            }
            _ => None,
        })
        .collect();
    let squares: Vec<(Sym, Sym)> = positive.iter().map(|&(symbol, _, square)| (symbol, square)).collect();
    if let Decision::NonZero(mut witness) = decide(reduced.substitute(&squares), &motion.hypotheses) {
        for &(symbol, root, _) in &positive {
            if let Some(place) = witness.point.iter().position(|(known, _)| *known == root) {
                let value = witness.point[place].1;
                witness.point[place] = (symbol, value * value);
            }
        }
        if admits(&witness, conditions) {
            return Outcome::NonZero(Refutation { is_formal: !witness.formal.is_empty(), point: witness.point });
        }
    }
    Outcome::Undecided(
        "the difference is not zero, but no exact point was found that satisfies the hypotheses".to_owned(),
    )
}

fn admits(witness: &Witness, conditions: &[Condition]) -> bool {
    let values = witness.point.iter().filter_map(|(symbol, value)| Some((*symbol, value.as_constant()?)));
    let point = Point::of(values);
    conditions.iter().all(|condition| {
        // letters that the point leaves open may have any value
        condition.holds_at(&point) != Some(false)
    })
}
