//! Combinations of edits of different terms. Since their changes of the residual add up, suitable combinations are found without trying all of them.

use super::edit::Edit;
use crate::change::EditKind;
use std::ops::Range;

/// Edits with the change of the residual that they cause at the test points.
pub(super) struct Effect {
    pub edits: Vec<Edit>,
    /// The change of the residual, one entry for each equality and each test point.
    pub change: Vec<f64>,
}

/// The largest number of edits that are combined in threes.
const MOST_IN_THREES: usize = 1_200;

/// The largest number of returned combinations.
const MOST: usize = 400;

/// The relative difference below which two residuals, or a residual and zero, agree.
pub(super) const ROUNDING: f64 = 1e-8;

/// Whether all entries of a residual are zero relative to the sizes of their summands.
pub(super) fn is_small(residual: &[f64], sizes: &[f64]) -> bool {
    residual.iter().zip(sizes).all(|(value, size)| value.abs() <= ROUNDING * (1.0 + size.abs()))
}

/// The largest number of edits of one term that are combined in pairs.
const MOST_OF_TERM: usize = 240;

/// Pairs of edits of two factors of one term. Each edit multiplies the term by a number, so that both together multiply it by the product; `gone` is the
/// change of the residual when the term is removed.
pub(super) fn in_one_product(effects: &[Effect], term: &Range<usize>, gone: &[f64]) -> Vec<Effect> {
    let holds = |edit: &Edit| term.start <= edit.span.start && edit.span.end <= term.end;
    let own: Vec<&Effect> = effects.iter().filter(|effect| effect.edits.iter().all(holds)).take(MOST_OF_TERM).collect();
    let mut all = Vec::new();
    for (place, first) in own.iter().enumerate() {
        for second in own[place + 1..].iter().filter(|second| are_apart(first, second)) {
            let both = first.change.iter().zip(&second.change).zip(gone);
            let change: Vec<f64> = both.map(|((a, b), gone)| a + b - a * b / gone).collect();
            if change.iter().all(|change| change.is_finite()) {
                all.push(Effect { edits: [&first.edits[..], &second.edits].concat(), change });
            }
        }
    }
    all
}

/// Pairs of edits of one term that make the residual vanish, the smallest edits first.
pub(super) fn alone(effects: &[Effect], residual: &[f64]) -> Vec<Vec<Edit>> {
    let is_it = |effect: &&Effect| {
        let rest: Vec<f64> = effect.change.iter().zip(residual).map(|(change, rest)| change + rest).collect();
        effect.edits.len() > 1 && is_small(&rest, residual)
    };
    by_size(effects.iter().filter(is_it).map(|effect| vec![effect]).collect())
}

/// Pairs of edits in separate places whose changes add up to minus the residual, the smallest edits first.
pub(super) fn pairs(effects: &[Effect], residual: &[f64]) -> Vec<Vec<Edit>> {
    let sorted = Sorted::of(effects);
    let mut found = Vec::new();
    for (place, first) in effects.iter().enumerate() {
        let sought: Vec<f64> = residual.iter().zip(&first.change).map(|(rest, change)| -rest - change).collect();
        for other in sorted.near(&sought, residual) {
            if other > place && are_apart(first, &effects[other]) {
                found.push(vec![first, &effects[other]]);
            }
        }
    }
    by_size(found)
}

/// Triples of edits in separate places whose changes add up to minus the residual, the smallest edits first.
pub(super) fn triples(effects: &[Effect], residual: &[f64]) -> Vec<Vec<Edit>> {
    let effects = &effects[..effects.len().min(MOST_IN_THREES)];
    let sorted = Sorted::of(effects);
    let mut found = Vec::new();
    for (place, first) in effects.iter().enumerate() {
        for (next, second) in effects.iter().enumerate().skip(place + 1) {
            if found.len() >= 10 * MOST || !are_apart(first, second) {
                continue;
            }
            let changes = first.change.iter().zip(&second.change);
            let sought: Vec<f64> = residual.iter().zip(changes).map(|(rest, (a, b))| -rest - a - b).collect();
            for other in sorted.near(&sought, residual) {
                let third = &effects[other];
                if other > next && are_apart(first, third) && are_apart(second, third) {
                    found.push(vec![first, second, third]);
                }
            }
        }
    }
    by_size(found)
}

fn by_size(mut found: Vec<Vec<&Effect>>) -> Vec<Vec<Edit>> {
    let edits = |effects: &[&Effect]| effects.iter().flat_map(|effect| effect.edits.clone()).collect::<Vec<_>>();
    found.sort_by_key(|effects| edits(effects).iter().map(size).sum::<u32>());
    found.truncate(MOST);
    found.iter().map(|effects| edits(effects)).collect()
}

fn are_apart(first: &Effect, second: &Effect) -> bool {
    first.edits.iter().all(|one| second.edits.iter().all(|other| apart(one, other)))
}

/// The size of an edit, by which edits are ordered: edits of one symbol before others, plain factors before powers and quotients.
pub(super) fn size(edit: &Edit) -> u32 {
    let is_composed = edit.after.contains("^2")
        || edit.after.starts_with(r"\frac{") && edit.closing.is_none() && !edit.after.starts_with(r"\frac{1}");
    match edit.kind {
        EditKind::Sign | EditKind::Dot | EditKind::Function | EditKind::Exponent | EditKind::Direction => 2,
        EditKind::MissingFactor if is_composed => 4,
        EditKind::Letter | EditKind::Number | EditKind::MissingFactor | EditKind::ExtraFactor => 3,
        _ => 4,
    }
}

/// Whether two edits can be applied together.
pub(super) fn apart(first: &Edit, second: &Edit) -> bool {
    match (&first.closing, &second.closing) {
        (None, None) => first.span.end <= second.span.start || second.span.end <= first.span.start,
        _ => first.is_apart(second),
    }
}

/// Effects sorted by the first entry of their change.
struct Sorted<'a> {
    effects: &'a [Effect],
    /// The indices of the effects in ascending order of this entry.
    order: Vec<usize>,
}

impl<'a> Sorted<'a> {
    fn of(effects: &'a [Effect]) -> Self {
        let mut order: Vec<usize> = (0..effects.len()).collect();
        order.sort_by(|&a, &b| effects[a].change[0].total_cmp(&effects[b].change[0]));
        Sorted { effects, order }
    }

    /// The indices of effects whose change agrees with `sought` up to rounding.
    fn near<'c>(&'c self, sought: &'c [f64], sizes: &'c [f64]) -> impl Iterator<Item = usize> + 'c {
        let width = ROUNDING * (1.0 + sizes[0].abs() + sought[0].abs());
        let change = |place: usize| &self.effects[place].change;
        let from = self.order.partition_point(|&place| change(place)[0] < sought[0] - width);
        let near = self.order[from..].iter().copied().take_while(move |&place| change(place)[0] <= sought[0] + width);
        near.filter(move |&place| {
            let rest: Vec<f64> = change(place).iter().zip(sought).map(|(change, sought)| change - sought).collect();
            let size: Vec<f64> = sizes.iter().zip(sought).map(|(size, sought)| size.abs() + sought.abs()).collect();
            is_small(&rest, &size)
        })
    }
}
