//! Edits that change the number of dots of a letter at all its occurrences in one side.

use super::edit::Edit;
use super::letter_rates::LetterRate;
use super::places::{Atom, Places};
use crate::change::EditKind;

/// The largest number of combinations.
const MOST: usize = 400;

/// All combinations of other numbers of dots for the letters of a side, those with few changed letters first.
pub(super) fn renamings(places: &Places, text: &str, rates: &[LetterRate]) -> Vec<Vec<Edit>> {
    let sides = places.summands.iter().filter(|summand| summand.number == 1 && summand.side.is_some());
    let mut all: Vec<(usize, Vec<Edit>)> = Vec::new();
    for (side, first) in ["left", "right"].into_iter().zip(sides) {
        let bounds = &places.sums[first.sum];
        let inside = |atom: &&Atom| bounds.start <= atom.span.start && atom.span.end <= bounds.end;
        let mut choices: Vec<(usize, Vec<Edit>)> = vec![(0, Vec::new())];
        for (letter, atoms) in letters(places.atoms.iter().filter(inside)) {
            let others: Vec<&LetterRate> =
                rates.iter().filter(|rate| rate.name == letter.name && rate.order != letter.order).collect();
            if choices.len() * (others.len() + 1) > MOST {
                break;
            }
            let with = |(count, edits): &(usize, Vec<Edit>), other: &LetterRate| {
                let words = format!(
                    "`{}` for `{}` wherever it stands on the {side} side",
                    other.latex,
                    &text[letter.span.clone()]
                );
                let edit =
                    |atom: &&Atom| Edit::new(EditKind::Dot, atom.span.clone(), other.latex.as_str(), words.clone());
                (count + 1, [&edits[..], &atoms.iter().map(edit).collect::<Vec<_>>()].concat())
            };
            let more = choices.iter().flat_map(|choice| others.iter().map(move |other| with(choice, other)));
            let more: Vec<(usize, Vec<Edit>)> = more.collect();
            choices.extend(more);
        }
        all.extend(choices);
    }
    all.sort_by_key(|(count, _)| *count);
    all.into_iter().map(|(_, edits)| edits).filter(|edits| edits.len() > 1).collect()
}

/// The different letters, each with its occurrences.
fn letters<'a>(atoms: impl Iterator<Item = &'a Atom>) -> Vec<(&'a Atom, Vec<&'a Atom>)> {
    let mut all: Vec<(&Atom, Vec<&Atom>)> = Vec::new();
    for atom in atoms {
        match all.iter_mut().find(|(first, _)| first.name == atom.name && first.order == atom.order) {
            Some((_, places)) => places.push(atom),
            None => all.push((atom, vec![atom])),
        }
    }
    all
}
