//! Edits that remove a superfluous term.

use super::edit::Edit;
use super::exchanges::told;
use super::letter_rates::LetterRate;
use super::places::{Places, Summand};
use crate::change::EditKind;
use symbolic::Dimension;

/// Edits that remove one term; a term that is alone in its sum is not removed.
pub(super) fn superfluous(places: &Places, text: &str) -> Vec<Edit> {
    away(places, text, |_, _| true)
}

/// Edits that remove a term which occurs twice in its sum.
pub(super) fn repeated(places: &Places, text: &str) -> Vec<Edit> {
    away(places, text, |place, summand| {
        let before = places.summands[..place].iter().filter(|other| other.sum == summand.sum);
        before.into_iter().any(|other| text[other.span.clone()] == text[summand.span.clone()])
    })
}

/// Edits that remove one of the chosen terms; `chosen` receives the index of a term among all terms.
pub(super) fn away(places: &Places, text: &str, chosen: impl Fn(usize, &Summand) -> bool) -> Vec<Edit> {
    let mut all = Vec::new();
    for (place, summand) in places.summands.iter().enumerate() {
        if summand.count == 1 || !chosen(place, summand) {
            continue;
        }
        let start = summand.sign.map_or(summand.span.start, |(at, _)| at);
        let start = if summand.number > 1 { text[..start].trim_end().len() } else { start };
        let mut span = start..summand.span.end;
        // if the first term is removed, the plus sign after it is removed too
        let next =
            places.summands.iter().find(|next| next.number == 2 && next.sign.is_some_and(|(at, _)| at >= span.end));
        if let (1, Some((at, '+'))) = (summand.number, next.and_then(|next| next.sign)) {
            span.end = at + 1;
        }
        let words = format!("no `{}`, which is {}", &text[summand.span.clone()], told(summand, text));
        all.push(Edit::new(EditKind::ExtraTerm, span, "", words));
    }
    all
}

/// Adds an angle that is a coordinate to the argument of each sine and cosine that has another one, or subtracts it: `\cos(a + b)` for `\cos b`.
pub(super) fn angles_in_arguments(places: &Places, text: &str, rates: &[LetterRate]) -> Vec<Edit> {
    let is_angle = |rate: &&LetterRate| {
        rate.order == 0 && rate.is_symbol && !rate.is_parameter && !rate.is_input && rate.dimension == Dimension::none()
    };
    let angles: Vec<&LetterRate> = rates.iter().filter(is_angle).collect();
    let mut all = Vec::new();
    for call in &places.calls {
        let held = &text[call.argument.clone()];
        let inside =
            |atom: &&super::places::Atom| call.argument.start <= atom.span.start && atom.span.end <= call.argument.end;
        let own: Vec<&str> = places.atoms.iter().filter(inside).map(|atom| atom.name.as_str()).collect();
        let has_angle = angles.iter().any(|angle| own.contains(&angle.name.as_str()));
        for angle in angles.iter().filter(|angle| has_angle && !own.contains(&angle.name.as_str())) {
            let held = bare(held);
            for after in [
                format!("({held} + {})", angle.latex),
                format!("({held} - {})", angle.latex),
                format!("({} - {held})", angle.latex),
            ] {
                let words = format!("the angle `{}` in the argument `{held}`", angle.latex);
                all.push(Edit::new(EditKind::LostTerm, call.argument.clone(), after, words));
            }
        }
    }
    all
}

/// An argument without the brackets about it.
fn bare(argument: &str) -> &str {
    let pairs = [(r"\left(", r"\right)"), (r"\bigl(", r"\bigr)"), ("(", ")"), ("{", "}")];
    let inside = |(open, close): (&str, &str)| argument.strip_prefix(open)?.strip_suffix(close);
    pairs.into_iter().find_map(inside).map_or(argument, str::trim)
}
