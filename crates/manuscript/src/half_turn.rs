//! The number pi, a symbol that no point gives a value: pi is transcendental, so that an expression which is rational in it vanishes only where it
//! vanishes identically. Its sign follows from enclosures.

use crate::claim_text::ClaimText;
use crate::conditions::Hypothesis;
use crate::letters::Letters;
use claims::Condition;
use field::{Interval, Rational};
use latex::{Statement, value};
use std::f64::consts::PI;
use symbolic::Sym;

/// Whether a symbol is the number pi.
pub(crate) fn is_half_turn(symbol: Sym) -> bool {
    symbol.symbol_name().is_some_and(|name| name == "pi")
}

/// Whether the number pi stands in an expression.
pub(crate) fn holds_half_turn(expression: Sym) -> bool {
    expression.symbols_of().into_iter().any(is_half_turn)
}

/// The enclosure of an expression without letters other than pi.
pub(crate) fn enclosed(number: Sym) -> Option<Interval> {
    // the double-precision number lies below pi
    number.evaluate_analytic(&|name: &str| (name == "pi").then(|| Interval::new(PI, PI.next_up()))).ok()
}

/// Bounds of the number pi, 0 < 333/106 < pi < 355/113, as hypotheses of a claim in whose formula or hypotheses it stands.
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
    let pi = letters.trace.pi;
    let number = |above: i64, below: i64| Sym::constant(Rational::new(above, below));
    let bound = |greater: Sym, told: &str, latex: &str| Hypothesis {
        told: (told.to_owned(), latex.to_owned()),
        own: None,
        equality: None,
        scales: false,
        condition: Some(Condition::Positive(greater)),
        at: claim.formula.span.clone(),
    };
    vec![
        bound(pi, "pi > 0", r"\pi > 0"),
        bound(pi - number(333, 106), "pi > 333/106", r"\pi > \frac{333}{106}"),
        bound(number(355, 113) - pi, "pi < 355/113", r"\pi < \frac{355}{113}"),
    ]
}
