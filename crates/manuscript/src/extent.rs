//! The set of points to which a claim applies. Its hypotheses and the domain of its formula may make the set empty.

use crate::cases::{Case, cases};
use crate::conditions::{Hypothesis, assume, conditions};
use crate::exact_points::completed;
use crate::motion::Motion;
use crate::natural_domain::natural_domain;
use crate::real_signs;
use crate::refutation::Refutation;
use crate::{condition_products, line_signs};
use claims::Condition;
use symbolic::Sym;

/// A condition under which a part of a formula has a value.
pub(crate) struct Demand {
    /// The condition in the paper's letters, as text and LaTeX.
    pub told: (String, String),
    /// The condition in the symbols of the model.
    pub condition: Condition,
    /// Whether the condition follows from hypotheses and constants.
    pub is_shown: bool,
}

/// A contradiction: the indices of the hypotheses and demands that contradict each other.
pub(crate) struct Contradiction {
    pub hypotheses: Vec<usize>,
    pub demands: Vec<usize>,
}

/// A minimal set of hypotheses and demands that no point of a motion satisfies together; `None` if none is found.
pub(crate) fn contradiction(
    base: &Motion<'_, '_>,
    assumed: &[Hypothesis],
    demands: &[Demand],
) -> Option<Contradiction> {
    let is_empty = |hypotheses: &[usize], demanded: &[usize]| {
        let kept: Vec<Hypothesis> = hypotheses.iter().map(|&place| assumed[place].clone()).collect();
        let is_excluded = |case: &Case<'_, '_>| {
            let demanded = demanded.iter().map(|&place| demands[place].condition);
            conditions_there(base, &case.assumed, demanded).is_some_and(|all| exclude_each_other(&all))
        };
        cases(base, &kept, &|own| own).is_ok_and(|cases| cases.iter().all(is_excluded))
    };
    let mut found = Contradiction { hypotheses: (0..assumed.len()).collect(), demands: (0..demands.len()).collect() };
    if !is_empty(&found.hypotheses, &found.demands) {
        return None;
    }
    for place in 0..demands.len() {
        let fewer: Vec<usize> = found.demands.iter().copied().filter(|one| *one != place).collect();
        if is_empty(&found.hypotheses, &fewer) {
            found.demands = fewer;
        }
    }
    for place in 0..assumed.len() {
        let fewer: Vec<usize> = found.hypotheses.iter().copied().filter(|one| *one != place).collect();
        if is_empty(&fewer, &found.demands) {
            found.hypotheses = fewer;
        }
    }
    Some(found)
}

/// The conditions with the equalities of hypotheses and the motion inserted; `None` if an equality cannot be solved.
fn conditions_there(
    base: &Motion<'_, '_>,
    assumed: &[Hypothesis],
    demanded: impl Iterator<Item = Condition>,
) -> Option<Vec<Condition>> {
    let mut motion = base.clone();
    assume(&mut motion, assumed).ok()?;
    let squares = motion.squares.iter().map(|&(_, zero)| Condition::Zero(zero));
    let demanded = demanded.chain(squares).map(|condition| condition.mapped(|e| motion.reduced(e)));
    let divisors = motion.divisors.iter().map(|&divisor| Condition::NonZero(motion.reduced(divisor)));
    Some(conditions(&motion, assumed).into_iter().chain(demanded).chain(divisors).collect())
}

/// Whether a proof is found that no point satisfies all conditions: in one unknown by real roots, otherwise by the sign of one condition that
/// follows from the others, or by products of conditions.
pub(crate) fn exclude_each_other(conditions: &[Condition]) -> bool {
    let expressions: Vec<Sym> = conditions.iter().map(|condition| condition.expression()).collect();
    let all = [conditions, &natural_domain(&expressions)].concat();
    let is_excluded = |place: usize| {
        let others = [&all[..place], &all[place + 1..]].concat();
        let opposite = Sym::ZERO - all[place].expression();
        match all[place] {
            Condition::Positive(_) => real_signs::shows(opposite, &others).is_some(),
            Condition::NotNegative(_) => real_signs::shows(opposite, &others).is_some_and(|shown| shown.is_strict),
            _ => false,
        }
    };
    line_signs::exclude_each_other(&all)
        || (0..all.len()).any(is_excluded)
        || condition_products::exclude_each_other(&all)
}

/// Whether an exact point is found that satisfies all conditions.
pub(crate) fn is_met(conditions: &[Condition]) -> bool {
    completed(Refutation { point: Vec::new(), is_formal: false }, conditions).is_some()
}

/// Whether an exact point is found that satisfies the hypotheses and lies inside the domain of the formula, not on its boundary.
pub(crate) fn has_inside(motion: &Motion<'_, '_>, there: &[Condition], demands: &[Demand]) -> bool {
    let inside = demands.iter().map(|demand| match demand.condition.mapped(|e| motion.reduced(e)) {
        Condition::NotNegative(e) if e.as_constant().is_none() => Condition::Positive(e),
        condition => condition,
    });
    let all: Vec<Condition> = there.iter().copied().chain(inside).collect();
    is_met(&all)
}
