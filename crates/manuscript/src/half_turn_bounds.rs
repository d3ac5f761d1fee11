//! Bounds of π as hypotheses of claims that contain π.

use crate::claim_text::ClaimText;
use crate::conditions::Hypothesis;
use crate::half_turn::{self, holds_half_turn};
use crate::letters::Letters;
use claims::Condition;
use latex::{Statement, value};

/// The hypotheses 333/106 < π < 355/113, if the formula or the hypotheses of a claim contain π; otherwise none.
pub(crate) fn bounds(
    claim: &ClaimText,
    statement: &Statement,
    assumed: &[Hypothesis],
    letters: &Letters<'_, '_>,
) -> Vec<Hypothesis> {
    let sides = statement.chains.iter().flat_map(|chain| &chain.sides);
    let printed = sides.filter_map(|side| value(side, &letters.in_model()).ok()).flat_map(|side| side.entries());
    let given = assumed.iter().filter_map(|one| {
        let condition = one.condition.map(|condition| condition.expression());
        condition.or(one.equality.map(|(zero, _)| zero))
    });
    if !printed.chain(given).any(holds_half_turn) {
        return Vec::new();
    }
    let told = [
        ("pi > 0", r"\pi > 0"),
        ("pi > 333/106", r"\pi > \frac{333}{106}"),
        ("pi < 355/113", r"\pi < \frac{355}{113}"),
    ];
    let bound = |(condition, (told, latex)): (Condition, (&str, &str))| Hypothesis {
        told: (told.to_owned(), latex.to_owned()),
        own: None,
        equality: None,
        scales: false,
        condition: Some(condition),
        at: claim.formula.span.clone(),
    };
    half_turn::bounds().into_iter().zip(told).map(bound).collect()
}
