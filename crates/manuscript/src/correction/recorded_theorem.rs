//! Corrections of a refuted theorem whose conclusion is an equation under hypotheses.

use super::recorded_equation::{LineCorrection, NotRead, conclusion_corrections};
use super::theorem_premises::Premises;
use crate::change::{Change, Correction, EditKind};
use claims::{Condition, Line, Page, Theorem, Verdict};
use symbolic::{Dimension, Hypotheses, Node, Sym, decide, normal};

/// The smallest edits with which the conclusion of a theorem, one equality, follows from the given equalities.
///
/// # Errors
/// The conclusion is not a single equality, or its LaTeX, parsed again, does not give the equality.
pub fn theorem_corrections(
    theorem: &Theorem,
    dimension: fn(&str) -> Option<Dimension>,
    goes_on: &dyn Fn() -> bool,
) -> Result<Vec<LineCorrection>, NotRead> {
    let [Condition::Equal(left, right)] = theorem.then[..] else {
        return Err(NotRead("the conclusion is not one equality".to_owned()));
    };
    let circles = letters_for_circles(left, right);
    let of = |side: Sym| side.substitute(&circles);
    let given: Vec<Condition> = theorem.given.iter().map(|one| one.mapped(of)).collect();
    let (left, right) = (of(left), of(right));
    let Premises { hypotheses, divisors } = Premises::of(&theorem.rules, &given, left);
    // without premises, a left side that is not a single name is derived, and is not printed
    let is_derived = |side: Sym| side.symbol_name().is_none() && theorem.given.is_empty();
    let line = match (is_derived(left), left.symbol_name()) {
        (true, _) => Line::formula(left, left, right),
        _ => Line::equation(Sym::ZERO, left, right),
    };
    if !divisors.is_empty() && decide(line.printed(), &hypotheses).is_zero() {
        return Ok(apart(&line, &hypotheses, &divisors, dimension).into_iter().collect());
    }
    let back: Vec<(Sym, Sym)> = circles.iter().map(|&(leaf, letter)| (letter, leaf)).collect();
    let mut found = conclusion_corrections(&back, &line, &hypotheses, dimension, goes_on)?;
    // the corrected equation must have no value where a divisor of the premises is zero
    found.retain(|found| divisors.iter().all(|&divisor| is_divided_by(&found.line, divisor)));
    for LineCorrection { line, .. } in &mut found {
        (line.left, line.right) = (line.left.substitute(&back), line.right.substitute(&back));
    }
    Ok(found)
}

/// Letters for cosines and sines in the conclusion if the unknown is one of them, since an equality can be solved only for a letter.
fn letters_for_circles(asked: Sym, right: Sym) -> Vec<(Sym, Sym)> {
    let is_circle = |leaf: &Sym| matches!(leaf.node(), Node::Cos(_) | Node::Sin(_));
    if !is_circle(&asked) {
        return Vec::new();
    }
    let leaves = [asked, right].into_iter().flat_map(Sym::leaves_of).filter(is_circle);
    leaves.map(|leaf| (leaf, Sym::symbol(&format!("letter for {leaf}")))).collect()
}

fn is_divided_by(line: &Line, divisor: Sym) -> bool {
    let form = |e: Sym| normal(e, &Hypotheses::none()).ok();
    let rest = form(line.printed()).and_then(|printed| form(printed.denominator() / divisor));
    rest.is_some_and(|rest| rest.denominator().as_constant().is_some())
}

/// The conclusion as printed, under the additional hypothesis that the divisors are not zero.
fn apart(
    line: &Line,
    hypotheses: &Hypotheses,
    divisors: &[Sym],
    dimension: fn(&str) -> Option<Dimension>,
) -> Option<LineCorrection> {
    let changes = divisors.iter().map(|divisor| {
        let after = format!(r"{} \neq 0", divisor.latex());
        Change { kind: EditKind::Hypothesis, words: format!("the hypothesis `{after}`"), before: String::new(), after }
    });
    let mut page = Page::of("print", dimension);
    let given = divisors.iter().map(|&divisor| Condition::NonZero(divisor));
    page.claim("print", "edited", "").under(hypotheses).given(given).follows([Condition::Equal(line.left, line.right)]);
    let judged = page.judge().into_iter().next().filter(|judged| judged.verdict == Verdict::Proved)?;
    let correction =
        Correction { changes: changes.collect(), formula: line.latex(), parts: Vec::new(), judged, certificate: None };
    Some(LineCorrection { correction, line: *line })
}
