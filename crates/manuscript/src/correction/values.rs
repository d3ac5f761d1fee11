//! Edits that replace a part of a formula by the value that it must have: a factor, a number, or one to three terms of a sum.

use super::comparison::letters;
use super::edit::Edit;
use super::ground::Ground;
use super::lost::{SOUGHT, signed};
use super::places::{Places, Summand};
use crate::change::EditKind;
use latex::read;
use std::ops::Range;
use symbolic::{Node, Sym};

/// The largest number of terms that are replaced together.
const MOST_TERMS: usize = 3;

/// The largest number of letters, numbers and signs in a value.
const MOST_WEIGHT: usize = 64;

/// The largest number of letters, numbers and signs in a value that replaces a printed zero; [`MOST_TERMS_FOR_ZERO`]: of its terms.
const MOST_WEIGHT_FOR_ZERO: usize = 120;
const MOST_TERMS_FOR_ZERO: usize = 8;

/// The largest number of terms in the value of a whole side.
const MOST_OF_SIDE: usize = 6;

/// A part of the printed formula that is replaced.
struct Part {
    /// The range that the value replaces.
    span: Range<usize>,
    /// The ranges of other terms of its sum, which are removed.
    away: Vec<Range<usize>>,
    /// The largest number of terms in its value.
    most: usize,
    /// Whether the part is a whole side.
    is_side: bool,
}

/// Edits that replace a part by its required value if this is short, the shortest first. `are_sides` selects whole sides, or else all other parts.
pub(super) fn values(ground: &impl Ground, places: &Places, are_sides: bool) -> Vec<Vec<Edit>> {
    let (text, mut known) = (ground.text(), ground.known());
    if known.iter().any(|name| name == SOUGHT) {
        return Vec::new();
    }
    known.push(SOUGHT.to_owned());
    let mut found: Vec<(usize, Vec<Edit>)> = Vec::new();
    let printed = places.atoms.len() + places.numbers.len();
    for part in parts(places, text) {
        let is_zero = &text[part.span.clone()] == "0" && part.away.is_empty();
        if are_sides != (part.is_side && !is_zero) {
            continue;
        }
        let most = if is_zero { (MOST_WEIGHT_FOR_ZERO, MOST_TERMS_FOR_ZERO) } else { (MOST_WEIGHT, part.most) };
        if !ground.goes_on() {
            break;
        }
        let gone = |span: &Range<usize>| {
            Edit::new(EditKind::Part, span.clone(), "", format!("no `{}`", text[span.clone()].trim()))
        };
        let edit = |after: String| {
            let words = format!("the value of `{}`", &text[part.span.clone()]);
            match below(&part, &after, places, text) {
                Some((term, fraction)) => Edit::new(EditKind::Part, term, fraction, words),
                None => Edit::new(EditKind::Part, part.span.clone(), after, words),
            }
        };
        let with = |after: String| {
            let mut edits: Vec<Edit> = part.away.iter().map(gone).collect();
            edits.push(edit(after));
            edits
        };
        let asked = super::search::edited(text, &with(SOUGHT.to_owned()));
        let Some(Ok(statement)) = asked.map(|(asked, _)| read(&asked, &known)) else { continue };
        for value in ground.sought(&statement) {
            let weight = weight(value);
            // a sum that replaces several terms and is much longer than the printed formula would be a new formula
            let is_new = !part.away.is_empty() && 2 * letters(value) > 3 * printed;
            if weight > most.0 || terms(value) > most.1 || is_new {
                continue;
            }
            let (sign, latex) = signed(value);
            let is_first = text[..part.span.start].trim_end().ends_with(['=', '{', '(']) || part.span.start == 0;
            let is_alone = is_first && is_whole_term(&part, places);
            let after = match (sign, without_brackets(&latex)) {
                ("-", _) if is_alone => format!("-{latex}"),
                ("-", _) => format!(r"\left(-{latex}\right)"),
                (_, Some(bare)) if is_alone && part.is_side => bare.to_owned(),
                _ => latex,
            };
            found.push((weight + 6 * part.away.len(), with(after)));
        }
    }
    found.sort_by_key(|(size, _)| *size);
    found.into_iter().map(|(_, edits)| edits).collect()
}

/// The content of brackets around a whole expression; `None` for other expressions, such as a product of two brackets.
fn without_brackets(latex: &str) -> Option<&str> {
    let held = latex.strip_prefix(r"\left(")?.strip_suffix(r"\right)")?;
    let mut depth = 0usize;
    for (at, _) in held.match_indices('\\') {
        match &held[at..] {
            rest if rest.starts_with(r"\left(") || rest.starts_with(r"\left[") => depth += 1,
            rest if rest.starts_with(r"\right)") || rest.starts_with(r"\right]") => depth = depth.checked_sub(1)?,
            _ => {}
        }
    }
    Some(held)
}

/// Whether a part is a term with all its factors.
fn is_whole_term(part: &Part, places: &Places) -> bool {
    places.summands.iter().any(|summand| summand.span == part.span)
}

/// For a factor whose value is 1/divisor: the range of its term, and the term as a fraction of its other factors; `None` if these contain a fraction.
fn below(part: &Part, value: &str, places: &Places, text: &str) -> Option<(Range<usize>, String)> {
    let divisor = value.strip_prefix(r"\frac{1}{")?.strip_suffix('}')?;
    let term =
        places.summands.iter().find(|summand| summand.factors.len() > 1 && summand.factors.contains(&part.span))?;
    let place = term.factors.iter().position(|factor| *factor == part.span)?;
    // the range includes the adjacent product sign
    let others = match place.checked_sub(1) {
        None => text.get(term.factors[1].start..term.span.end)?.to_owned(),
        Some(before) => {
            let end = term.factors[before].end;
            format!("{}{}", text.get(term.span.start..end)?, text.get(part.span.end..term.span.end)?)
        }
    };
    (!others.contains("frac") && !others.contains('/') && !divisor.contains(r"\frac"))
        .then(|| (term.span.clone(), format!(r"\frac{{{}}}{{{divisor}}}", others.trim())))
}

/// The number of letters, numbers and signs in an expression, without simplification.
pub(super) fn weight(expression: Sym) -> usize {
    1 + expression.node().children().map(weight).sum::<usize>()
}

/// The number of terms of a sum, or of the numerator of a quotient.
fn terms(expression: Sym) -> usize {
    match expression.node() {
        Node::Sum(a, b) | Node::Difference(a, b) => terms(a) + terms(b),
        Node::Quotient(a, _) | Node::Negation(a) => terms(a),
        _ => 1,
    }
}

/// The parts that may be replaced: factors, numbers, terms, and groups of terms.
fn parts(places: &Places, text: &str) -> Vec<Part> {
    let mut all: Vec<Part> = Vec::new();
    let mut add = |span: Range<usize>, away: Vec<Range<usize>>, terms: usize, is_side: bool| {
        let most = if is_side { MOST_OF_SIDE } else { terms + 1 };
        match all.iter_mut().find(|part| part.span == span && part.away == away) {
            Some(part) => {
                part.most = part.most.max(most);
                part.is_side |= is_side;
            }
            None => all.push(Part { span, away, most, is_side }),
        }
    };
    for (span, _) in &places.numbers {
        add(span.clone(), Vec::new(), 1, false);
    }
    for summand in &places.summands {
        for factor in &summand.factors {
            add(factor.clone(), Vec::new(), 1, false);
        }
        add(summand.span.clone(), Vec::new(), 1, summand.count == 1 && summand.side.is_some());
    }
    for count in 2..=MOST_TERMS {
        for sum in sums(places) {
            for chosen in subsets(sum.len(), count) {
                // the value follows the sign of the first of these terms
                let away = chosen[1..].iter().map(|&place| whole(sum[place])).collect();
                add(sum[chosen[0]].span.clone(), away, count, count == sum.len() && sum[0].side.is_some());
            }
        }
    }
    all.retain(|part| text.get(part.span.clone()).is_some());
    all
}

/// The range of a term that is not the first of its sum, including its sign.
fn whole(summand: &Summand) -> Range<usize> {
    summand.sign.map_or(summand.span.start, |(at, _)| at)..summand.span.end
}

/// The terms of each sum, in their order.
fn sums(places: &Places) -> Vec<Vec<&Summand>> {
    let of = |sum: usize| places.summands.iter().filter(|summand| summand.sum == sum).collect::<Vec<_>>();
    let all = (0..places.sums.len()).map(of);
    // sums that begin with a group are left out, since the group has its own signs
    all.filter(|sum| sum.iter().skip(1).all(|summand| summand.sign.is_some())).collect()
}

/// All choices of `count` among the numbers 0 to `of` - 1, each in ascending order.
fn subsets(of: usize, count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let with = |last: usize| {
        subsets(last, count - 1).into_iter().map(move |mut chosen| {
            chosen.push(last);
            chosen
        })
    };
    (count - 1..of).flat_map(with).collect()
}

#[cfg(test)]
mod tests {
    use super::without_brackets;

    #[test]
    fn brackets_about_a_whole_expression_are_left_out() {
        assert_eq!(without_brackets(r"\left(a + b\right)"), Some("a + b"));
        assert_eq!(without_brackets(r"\left(a + \left(b + c\right) d\right)"), Some(r"a + \left(b + c\right) d"));
        assert_eq!(without_brackets(r"\left(a + b\right)\left(c + d\right)"), None);
        assert_eq!(without_brackets("a + b"), None);
    }
}
