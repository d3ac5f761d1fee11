//! Cross-examination: tests that every claim must pass, whatever its verdict.

use crate::{Line, Proof, Theorem};
use num_traits::One;
use symbolic::{Decision, Dimension, Hypotheses, Node, Sym, decide, dimension as dimension_of};

/// The largest number of mutated right sides per equation, enough to show that the prover can refute.
const MUTANTS: usize = 6;

/// Objections to equalities: mixed dimensions in the derived expression, two sides that are one expression, a mutated equation that is proved,
/// hypotheses that no point satisfies.
pub fn equations(lines: &[Line], hypotheses: &Hypotheses, dimension: fn(&str) -> Option<Dimension>) -> Vec<String> {
    let mut objections = Vec::new();
    for line in lines {
        if line.derived == line.printed() {
            objections
                .push(format!("both sides of {} = {} are one expression: nothing was compared", line.left, line.right));
        }
        objections.extend(mismatch(line.derived, dimension));
        // mutants of a false line are not tried, since a mutation may be the correction
        let holds = decide(line.derived - line.printed(), hypotheses).is_zero();
        for mutant in mutants(line.right).into_iter().take(MUTANTS).filter(|_| holds) {
            let mutated = Line { right: mutant, ..*line };
            if decide(mutated.derived - mutated.printed(), hypotheses).is_zero()
                && !decide(mutant - line.right, hypotheses).is_zero()
            {
                objections.push(format!("the mutant {} = {mutant} passes too", line.left));
            }
        }
    }
    if !matches!(decide(Sym::one(), hypotheses), Decision::NonZero(_)) {
        objections.push("no exact point satisfies the hypotheses".into());
    }
    objections
}

/// Messages about printed equalities that mix dimensions, within a side, between the sides, or with the derived expression.
pub fn mixed_lines(lines: &[Line], dimension: fn(&str) -> Option<Dimension>) -> Vec<String> {
    let sides = lines.iter().flat_map(|line| [line.left - line.right, line.derived - line.printed()]);
    sides.filter_map(|side| mismatch(side, dimension)).collect()
}

/// Messages about conclusions of a theorem that mix dimensions.
pub fn mixed_conclusions(theorem: &Theorem, dimension: fn(&str) -> Option<Dimension>) -> Vec<String> {
    theorem.then.iter().filter_map(|condition| mismatch(condition.expression(), dimension)).collect()
}

/// Objections to a theorem: premises with mixed dimensions, or a proof that also proves a mutated conclusion.
pub fn theorem(theorem: &Theorem, dimension: fn(&str) -> Option<Dimension>) -> Vec<String> {
    let mut objections = Vec::new();
    for condition in &theorem.given {
        objections.extend(mismatch(condition.expression(), dimension));
    }
    let mutable = !matches!(theorem.proof, Proof::Counterexample(_) | Proof::NoRoot { .. } | Proof::Example(_));
    if mutable && theorem.decide().verdict == crate::Verdict::Proved {
        let shifted = theorem.then.iter().map(|conclusion| conclusion.mutated()).collect();
        let mutant = Theorem { then: shifted, ..theorem.clone() };
        if mutant.decide().verdict == crate::Verdict::Proved {
            objections.push("the same proof shows a mutated conclusion".into());
        }
    }
    objections
}

fn mismatch(expression: Sym, dimension: fn(&str) -> Option<Dimension>) -> Option<String> {
    dimension_of(expression, &dimension).err().map(|mismatch| mismatch.to_string())
}

/// Mutants of an expression: with the sign of one term changed, for each term, and doubled.
pub fn mutants(expression: Sym) -> Vec<Sym> {
    let terms = summands(expression);
    let turned = (0..terms.len()).map(|k| {
        terms.iter().enumerate().fold(Sym::ZERO, |sum, (j, &term)| if j == k { sum - term } else { sum + term })
    });
    turned.chain([expression + expression]).collect()
}

/// The terms of a sum with their signs.
fn summands(expression: Sym) -> Vec<Sym> {
    match expression.node() {
        Node::Sum(a, b) => [summands(a), summands(b)].concat(),
        Node::Difference(a, b) => [summands(a), summands(b).into_iter().map(|term| -term).collect()].concat(),
        _ => vec![expression],
    }
}
