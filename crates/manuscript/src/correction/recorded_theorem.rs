//! The conclusion of a theorem that is refuted as an equation under what is given.

use super::recorded_equation::{LineCorrection, NotRead, line_corrections};
use claims::{Condition, Line, Page, Theorem, Verdict};
use symbolic::{Dimension, Hypotheses, Node, Sym, coefficients, normal};

/// The smallest edits by which the conclusion of a theorem, one equality, follows from the equalities that are given.
///
/// # Errors
/// The conclusion is no equality, or its LaTeX is not read back.
pub fn theorem_corrections(
    theorem: &Theorem,
    dimension: fn(&str) -> Option<Dimension>,
    goes_on: &dyn Fn() -> bool,
) -> Result<Vec<LineCorrection>, NotRead> {
    let [Condition::Equal(left, right)] = theorem.then[..] else {
        return Err(NotRead("the conclusion is not one equality".to_owned()));
    };
    let hypotheses = solved(theorem, left);
    // a side that was derived is no print
    let is_derived = |side: Sym| side.symbol_name().is_none() && theorem.given.is_empty();
    let line = match (is_derived(left), left.symbol_name()) {
        (true, _) => Line::formula(left, left, right),
        _ => Line::equation(Sym::ZERO, left, right),
    };
    line_corrections(&line, &hypotheses, dimension, goes_on)
}

/// The rules of a theorem with its equalities, each solved for a symbol in which it is linear: for the one that is asked for where it can be.
fn solved(theorem: &Theorem, asked: Sym) -> Hypotheses {
    let mut hypotheses = theorem.rules.clone();
    for condition in &theorem.given {
        let (Condition::Zero(_) | Condition::Equal(..)) = condition else { continue };
        // a square that is given
        if let Condition::Equal(square, value) = condition
            && let Node::Power(lead, power) = square.node()
            && lead.symbol_name().is_some()
        {
            let with = hypotheses.clone().rule(lead, power, *value);
            if with.check().is_ok() {
                hypotheses = with;
                continue;
            }
        }
        let Ok(zero) = normal(condition.expression(), &hypotheses).map(|form| form.numerator()) else { continue };
        let mut symbols = zero.symbols_of();
        symbols.sort_by_key(|symbol| *symbol != asked);
        let linear = symbols.into_iter().find_map(|symbol| Some((symbol, solution(zero, symbol, &theorem.given)?)));
        if let Some((symbol, value)) = linear {
            let with = hypotheses.clone().given(symbol, value);
            if with.check().is_ok() {
                hypotheses = with;
            }
        }
    }
    hypotheses
}

/// A symbol by the others, where an expression that is linear in it vanishes, and its factor does not by what is given.
fn solution(zero: Sym, symbol: Sym, given: &[Condition]) -> Option<Sym> {
    let terms = coefficients(zero, &[symbol]).ok()?;
    let of = |power: u32| terms.iter().find(|(exponents, _)| exponents[0] == power).map(|(_, value)| *value);
    let factor = of(1).filter(|_| terms.iter().all(|(exponents, _)| exponents[0] <= 1))?;
    let is_apart = factor.as_constant().is_some() || {
        let mut page = Page::of("print", |_| None);
        let premises = given.iter().copied().filter(|one| !matches!(one, Condition::Zero(_) | Condition::Equal(..)));
        page.claim("print", "divisor", "").given(premises).by_signs([Condition::NonZero(factor)]);
        page.judge().iter().all(|judged| judged.verdict == Verdict::Proved)
    };
    is_apart.then(|| -of(0).unwrap_or(Sym::ZERO) / factor)
}
