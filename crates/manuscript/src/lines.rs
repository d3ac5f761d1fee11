//! The equalities of a formula, by components.

use crate::claim_text::ClaimText;
use crate::conditions::side;
use crate::letters::Letters;
use latex::{Chain, Relation, Statement};
use reader::Issue;
use symbolic::Sym;

/// An equality between two adjacent sides: in the symbols of the model, and in the paper's letters.
pub(crate) struct Line {
    pub model: [Sym; 2],
    pub own: [Sym; 2],
}

/// The equalities of a formula, one for each component and each pair of adjacent sides.
pub(crate) fn lines(claim: &ClaimText, statement: &Statement, letters: &Letters<'_, '_>) -> Result<Vec<Line>, Issue> {
    let accepted = "two sides or more with `=` between them";
    let refused = |title: &str| Issue::at(claim.formula.span.clone(), title.to_owned(), "here").accepted(accepted);
    let [Chain { sides, relations }] = &statement.chains[..] else {
        return Err(refused("an equivalence is a claim of the kind `equivalence`"));
    };
    if relations.is_empty() {
        return Err(refused("this formula has one side, and states nothing"));
    }
    if relations.iter().any(|relation| *relation != Relation::Equal) {
        return Err(refused("this formula is no equality; an inequality is a claim of the kind `inequality`"));
    }
    let sides: Vec<_> = sides.iter().map(|term| side(&claim.formula, term, letters)).collect::<Result<_, _>>()?;
    let mut lines = Vec::new();
    for pair in sides.windows(2) {
        let (left, right) = (pair[0].model.entries(), pair[1].model.entries());
        // the number zero also denotes the zero vector
        let all_zero = |side: &[Sym]| side.len() == 1 && side[0] == Sym::ZERO;
        let count = left.len().max(right.len());
        if left.len() != right.len() && !all_zero(&left) && !all_zero(&right) {
            return Err(refused(&format!("one side has {} components and the other {}", left.len(), right.len())));
        }
        let padded = |side: Vec<Sym>| if side.len() == count { side } else { vec![Sym::ZERO; count] };
        let own = [padded(pair[0].own.entries()), padded(pair[1].own.entries())];
        for (place, (left, right)) in padded(left).into_iter().zip(padded(right)).enumerate() {
            lines.push(Line { model: [left, right], own: [own[0][place], own[1][place]] });
        }
    }
    Ok(lines)
}
