//! Edits that remove a superfluous term.

use super::edit::Edit;
use super::exchanges::told;
use super::places::{Places, Summand};
use crate::change::EditKind;

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
