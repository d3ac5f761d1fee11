//! Edits that add a missing factor or remove a superfluous one.

use super::edit::Edit;
use super::exchanges::told;
use super::letter_rates::LetterRate;
use super::places::{Places, Summand};
use crate::change::EditKind;
use std::ops::Range;
use symbolic::{Dimension, Hypotheses, normal};

/// Numerical factors that formulas often lack or have in excess.
const NUMBERS: [&str; 10] = [
    "2",
    r"\frac{1}{2}",
    "3",
    r"\frac{1}{3}",
    "4",
    r"\frac{1}{4}",
    r"\frac{3}{2}",
    r"\frac{2}{3}",
    r"\frac{4}{3}",
    r"\frac{3}{4}",
];

/// Edits that add a factor to a term, or remove a factor from it.
pub(super) fn factors(places: &Places, text: &str, rates: &[LetterRate]) -> Vec<Edit> {
    let mut candidates: Vec<String> = NUMBERS.map(str::to_owned).to_vec();
    for call in &places.calls {
        let name = &text[call.command.clone()];
        for function in [name, r"\cos", r"\sin"] {
            let argument = &text[call.argument.clone()];
            let space = if argument.starts_with(|letter: char| letter.is_ascii_alphabetic()) { " " } else { "" };
            let factor = format!("{function}{space}{argument}");
            if !candidates.contains(&factor) {
                candidates.push(factor);
            }
        }
    }
    // cosines and sines of angles that are coordinates are tried even if the printed formula does not contain them
    let is_angle = |rate: &&LetterRate| {
        rate.order == 0 && rate.is_symbol && !rate.is_parameter && rate.dimension == Dimension::none()
    };
    for angle in rates.iter().filter(is_angle) {
        let circles = [r"\cos", r"\sin"].map(|function| format!("{function}{{{}}}", angle.latex));
        let is_new = |factor: &String| !candidates.contains(&factor.replace(['{', '}'], ""));
        let new: Vec<String> = circles.into_iter().filter(is_new).collect();
        candidates.extend(new);
    }
    let inverse: Vec<String> =
        candidates[NUMBERS.len()..].iter().map(|call| format!(r"\frac{{1}}{{{call}}}")).collect();
    candidates.extend(inverse);
    let plain: Vec<&str> = rates.iter().filter(|rate| !rate.vanishes).map(|rate| rate.latex.as_str()).collect();
    candidates.extend(plain.iter().map(|&latex| latex.to_owned()));
    candidates.extend(plain.iter().map(|latex| format!(r"\frac{{1}}{{{latex}}}")));
    candidates.extend(plain.iter().map(|latex| format!("{latex}^2")));
    candidates.extend(plain.iter().map(|latex| format!(r"\frac{{1}}{{{latex}^2}}")));
    // quotients of letters of the same dimension
    let measured = || rates.iter().filter(|rate| rate.order == 0 && rate.dimension != Dimension::none());
    for above in measured() {
        // except those that are numbers
        let is_number = |below: &LetterRate| {
            normal(above.value / below.value, &Hypotheses::none())
                .is_ok_and(|form| form.to_sym().as_constant().is_some())
        };
        let others = measured().filter(|below| below.dimension == above.dimension && !is_number(below));
        candidates.extend(others.map(|below| format!(r"\frac{{{}}}{{{}}}", above.latex, below.latex)));
    }
    // terms are preferred to a letter that the formula defines, and missing factors to superfluous ones
    let mut all = Vec::new();
    for summand in places.summands.iter().filter(|summand| &text[summand.span.clone()] != "0") {
        for (place, factor) in summand.factors.iter().enumerate() {
            // the range includes the adjacent product sign
            let (span, after) = match (place, summand.factors.get(place + 1)) {
                // a term that consists of this factor alone is removed by another kind of edit
                (0, None) if summand.count > 1 || summand.side.is_some() => continue,
                (0, None) => (factor.clone(), "1".to_owned()),
                (0, Some(next)) => (factor.start..next.start, String::new()),
                (place, _) => (summand.factors[place - 1].end..factor.end, String::new()),
            };
            let words = format!("no factor `{}` in {}", &text[factor.clone()], told(summand, text));
            if text.get(span.clone()).is_some() && &text[factor.clone()] != "1" {
                all.push(((places.is_told(summand), false), Edit::new(EditKind::ExtraFactor, span, after, words)));
            }
        }
        for factor in &candidates {
            let below = factor.strip_prefix(r"\frac{1}{").and_then(|rest| rest.strip_suffix('}'));
            // a factor that would cancel a printed one is left out, since removing that one is an edit too
            if summand.factors.iter().any(|own| Some(&text[own.clone()]) == below) {
                continue;
            }
            let edit = match below {
                Some(_) if is_fraction_by_one_term(summand, places, text) => continue,
                Some(below) => over(summand, below, text),
                None => before(summand, factor, text),
            };
            all.push(((places.is_told(summand), factor.starts_with(r"\frac")), edit));
        }
    }
    all.sort_by_key(|(rank, _)| *rank);
    all.into_iter().map(|(_, edit)| edit).collect()
}

/// Whether a term is one fraction with a single term as denominator. A further divisor is then added as a factor of the denominator.
fn is_fraction_by_one_term(summand: &Summand, places: &Places, text: &str) -> bool {
    let [factor] = &summand.factors[..] else { return false };
    let behind = |below: &Summand| text[below.span.end..factor.end.max(below.span.end)].trim();
    let is_below = |below: &&Summand| {
        let inside = factor.start < below.span.start && below.span.end <= factor.end;
        inside && below.count == 1 && matches!(behind(below), "" | "}")
    };
    is_fraction(factor, text) && places.summands.iter().any(|below| is_below(&below))
}

fn is_fraction(factor: &Range<usize>, text: &str) -> bool {
    [r"\frac", r"\dfrac", r"\tfrac"].iter().any(|command| text[factor.clone()].starts_with(command))
}

/// The edit that divides a term, or the part of it after its fractions, by a divisor.
fn over(summand: &Summand, below: &str, text: &str) -> Edit {
    let inverse = format!(r"\frac{{1}}{{{below}}}");
    let first = summand.factors.iter().position(|factor| !is_fraction(factor, text));
    let Some((first, behind)) = first.map(|place| (&summand.factors[place], &summand.factors[place..])) else {
        return before(summand, &inverse, text);
    };
    let end = behind.last().map_or(first.end, |last| last.end);
    let is_plain = text.get(first.start..end).is_some_and(|held| !held.contains(r"frac") && !held.contains('/'));
    if !is_plain || end != summand.span.end {
        return before(summand, &inverse, text);
    }
    let words = format!("the factor `{inverse}` in {}", told(summand, text));
    Edit::new(EditKind::MissingFactor, first.start..first.start, r"\frac{", words).closed(end, format!("}}{{{below}}}"))
}

/// The edit that puts a factor before a term.
pub(super) fn before(summand: &Summand, factor: &str, text: &str) -> Edit {
    let at = summand.span.start;
    // a product sign is necessary after a function, and between two numbers
    let needs_sign = factor.starts_with(r"\cos")
        || factor.starts_with(r"\sin")
        || text[at..].starts_with(|letter: char| letter.is_ascii_digit())
        || text[at..].starts_with(['(', '['])
        || text[at..].starts_with(r"\left");
    let after = if needs_sign { format!(r"{factor} \cdot ") } else { format!("{factor} ") };
    let words = format!("the factor `{factor}` in {}", told(summand, text));
    Edit::new(EditKind::MissingFactor, at..at, after, words)
}
