//! Signs of expressions from their written form and from their normal form.

use crate::motion::Motion;
use claims::{Condition, Page, Verdict};
use field::Elementary;
use std::collections::HashMap;
use symbolic::{Node, Sym};

/// The proved sign of an expression, with the evidence.
pub(crate) struct Shown {
    /// Whether the expression is positive, not only nonnegative.
    pub is_strict: bool,
    /// Whether all terms of the normal form have this sign.
    pub is_of_normal_form: bool,
    pub evidence: String,
}

/// Whether an expression is proved positive or nonnegative where the conditions hold, by its normal form or by its written form; `None` without a proof.
pub(crate) fn shows(expression: Sym, motion: &Motion<'_, '_>, conditions: &[Condition]) -> Option<Shown> {
    let mut page = Page::of("paper", |_| None);
    let draft = page.claim("", "", "").given(conditions.iter().copied()).under(&motion.hypotheses);
    draft.by_signs([Condition::Positive(expression)]);
    if let Some(judged) = page.judge().into_iter().find(|judged| judged.verdict == Verdict::Proved) {
        return Some(Shown { is_strict: true, is_of_normal_form: true, evidence: judged.evidence });
    }
    // a normal form may mix signs that the written form separates
    let evidence =
        "every term as written has this sign: squares, exponentials, and letters that are positive".to_owned();
    let is_strict = is_written_as_positive(expression, conditions)?;
    Some(Shown { is_strict, is_of_normal_form: false, evidence })
}

/// Whether the written terms of an expression prove that it is nonnegative. `None` without a proof, otherwise whether it is positive.
pub(crate) fn is_written_as_positive(expression: Sym, conditions: &[Condition]) -> Option<bool> {
    let known = &mut HashMap::new();
    // from the leaves on, to avoid deep recursion in a long sum
    for part in Sym::ascending(&[expression]) {
        sign(part, conditions, known);
    }
    sign(expression, conditions, known).and_then(|sign| match sign {
        Sign::Positive => Some(true),
        Sign::NotNegative => Some(false),
        Sign::NotPositive | Sign::Negative => None,
    })
}

/// The known sign of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sign {
    Positive,
    NotNegative,
    NotPositive,
    Negative,
}

impl Sign {
    fn opposite(self) -> Self {
        match self {
            Sign::Positive => Sign::Negative,
            Sign::NotNegative => Sign::NotPositive,
            Sign::NotPositive => Sign::NotNegative,
            Sign::Negative => Sign::Positive,
        }
    }

    /// Whether the sign is nonnegative (otherwise nonpositive), and whether it excludes zero.
    fn parts(self) -> (bool, bool) {
        match self {
            Sign::Positive => (true, true),
            Sign::NotNegative => (true, false),
            Sign::NotPositive => (false, false),
            Sign::Negative => (false, true),
        }
    }

    fn of_parts((is_up, is_strict): (bool, bool)) -> Self {
        match (is_up, is_strict) {
            (true, true) => Sign::Positive,
            (true, false) => Sign::NotNegative,
            (false, false) => Sign::NotPositive,
            (false, true) => Sign::Negative,
        }
    }

    fn product(self, other: Self) -> Self {
        let ((up, strict), (other_up, other_strict)) = (self.parts(), other.parts());
        Sign::of_parts((up == other_up, strict && other_strict))
    }
}

/// The signs of parts that have been determined; shared parts are examined once.
type KnownSigns = HashMap<Sym, Option<Sign>>;

/// The sign of an expression in its written form, from conditions on its parts.
fn sign(expression: Sym, conditions: &[Condition], known: &mut KnownSigns) -> Option<Sign> {
    if let Some(found) = known.get(&expression) {
        return *found;
    }
    let found = sign_as_written(expression, conditions, known);
    known.insert(expression, found);
    found
}

fn sign_as_written(expression: Sym, conditions: &[Condition], known: &mut KnownSigns) -> Option<Sign> {
    let mut of = |part: Sym| sign(part, conditions, known);
    if conditions.contains(&Condition::Positive(expression)) {
        return Some(Sign::Positive);
    }
    if conditions.contains(&Condition::Positive(-expression))
        || conditions.contains(&Condition::Positive(Sym::ZERO - expression))
    {
        return Some(Sign::Negative);
    }
    if conditions.contains(&Condition::NotNegative(expression)) {
        return Some(Sign::NotNegative);
    }
    if conditions.contains(&Condition::NotNegative(-expression))
        || conditions.contains(&Condition::NotNegative(Sym::ZERO - expression))
    {
        return Some(Sign::NotPositive);
    }
    let is_stated = |part: Sym| {
        [part, -part, Sym::ZERO - part].into_iter().any(|part| conditions.contains(&Condition::NonZero(part)))
    };
    let square = |part: Sym, own: Option<Sign>| {
        let is_apart = is_stated(part) || own.is_some_and(|sign| sign.parts().1);
        Some(if is_apart { Sign::Positive } else { Sign::NotNegative })
    };
    let sum = |a: Sign, b: Sign| {
        let ((up, strict), (other_up, other_strict)) = (a.parts(), b.parts());
        (up == other_up).then(|| Sign::of_parts((up, strict || other_strict)))
    };
    match expression.node() {
        Node::Constant(_) => match expression.as_constant()?.sign()? {
            1 => Some(Sign::Positive),
            0 => Some(Sign::NotNegative),
            _ => Some(Sign::Negative),
        },
        Node::Sum(a, b) => sum(of(a)?, of(b)?),
        Node::Difference(a, b) if a == Sym::ZERO => of(b).map(Sign::opposite),
        Node::Difference(a, b) => sum(of(a)?, of(b)?.opposite()),
        Node::Negation(a) => of(a).map(Sign::opposite),
        Node::Product(a, b) if a == b => square(a, of(a)),
        Node::Product(a, b) => Some(of(a)?.product(of(b)?)),
        Node::Quotient(a, b) => {
            let below = of(b).filter(|sign| sign.parts().1)?;
            Some(of(a)?.product(below))
        }
        Node::Power(a, n) if n % 2 == 0 => square(a, of(a)),
        Node::Power(a, _) => of(a),
        Node::Elementary(Elementary::Exp, ..) => Some(Sign::Positive),
        Node::Root(a) => Some(if of(a) == Some(Sign::Positive) { Sign::Positive } else { Sign::NotNegative }),
        _ => None,
    }
}

/// A square root in an expression whose radicand is proved negative.
pub(crate) fn without_real_value(expression: Sym, motion: &Motion<'_, '_>, conditions: &[Condition]) -> Option<Sym> {
    // each shared part is visited once, since multiples of an angle have many parts in common
    Sym::ascending(&[expression]).into_iter().find(|part| {
        let Node::Root(below) = part.node() else { return false };
        let below = motion.reduced(below);
        below.as_constant().and_then(|value| value.sign()) == Some(-1)
            || shows(-below, motion, conditions).is_some_and(|shown| shown.is_strict)
    })
}
