//! The search for the smallest edits of a formula with which it is proved, for claims of any kind.

use super::combinations::{self, Effect, apart, is_small, size};
use super::edit::{Edit, is_whole};
use super::ground::{Ground, Look, Proof};
use super::letter_rates::LetterRate;
use super::lost::lost_beside;
use super::places::Places;
use super::values::values;
use super::{comparison, exchanges, factors, renamings, terms};
use crate::change::{Change, Correction, EditKind};
use latex::{Statement, read};
use std::cell::OnceCell;
use std::cmp::Reverse;
use std::collections::HashSet;
use std::ops::Range;
use symbolic::{Hypotheses, Node, Sym, decide, normal};

/// The largest number of reported corrections of one size.
pub(super) const MOST_TOLD: usize = 3;

/// The largest number of edits of one size that are decided exactly after they have passed the test points.
const MOST_DECIDED: usize = 24;

/// The largest number of edits that are decided exactly, for formulas without test points.
const MOST_UNTESTED: usize = 160;

/// The largest number of pairs of edits that are tried.
const MOST_PAIRS: usize = 20_000;

/// The least number of letters, numbers and functions of a formula for which two edits of any kind are tried; [`LEAST_FOR_THREE`]: three edits.
const LEAST_FOR_TWO: usize = 5;
const LEAST_FOR_THREE: usize = 9;

/// The largest number of edits whose effect on the residual is computed.
const MOST_MEASURED: usize = 6_000;

/// The largest number of effects, including those of pairs of edits of one term.
const MOST_EFFECTS: usize = 300_000;

/// The largest number of lost terms that are added together.
const MOST_LOST: usize = 6;

/// The largest number of edits that are combined with one lost term.
const MOST_BESIDE: usize = 120;

/// The search for edits of one formula.
pub(super) struct Search<'a, G> {
    pub ground: &'a G,
    pub places: Places,
    exchanges: Vec<Edit>,
    /// The residual of the printed formula at the test points; `None` if it cannot be evaluated.
    residual: Option<Vec<f64>>,
    known: Vec<String>,
    /// Whether the difference of the sides of the printed formula is a number.
    is_number: bool,
    /// The number of parts of the printed formula that state nothing.
    redundancies: usize,
}

impl<'a, G: Ground> Search<'a, G> {
    pub fn of(ground: &'a G, statement: &Statement) -> Self {
        let (text, places) = (ground.text(), Places::of(statement, ground.text()));
        let exchanges = [terms::repeated(&places, text), exchanges::exchanges(&places, text, ground.rates())].concat();
        let residual = ground.residual(statement);
        let is_number = ground.own_difference(statement).is_some_and(is_number);
        let redundancies = ground.redundancies(statement);
        Search { ground, places, exchanges, residual, known: ground.known(), is_number, redundancies }
    }

    /// Corrections by one edit, of a relation, a symbol, a factor or a term, in this order, and by two signs. The first size with a proved edit ends the
    /// search.
    pub fn small(&self) -> Vec<Correction> {
        let (text, places) = (self.ground.text(), &self.places);
        let sizes: [&dyn Fn() -> Vec<Edit>; 4] = [
            &|| exchanges::relations(text),
            &|| self.exchanges.clone(),
            &|| factors::factors(places, text, self.ground.rates()),
            &|| {
                let angles = terms::angles_in_arguments(places, text, self.ground.rates());
                [terms::superfluous(places, text), self.ground.lost(places, 1), angles].concat()
            },
        ];
        for edits in sizes {
            let found = self.proved(edits().into_iter().map(|edit| vec![edit]));
            if !found.is_empty() {
                return found;
            }
        }
        if !self.ground.has_points() {
            return Vec::new();
        }
        let signs: Vec<&Edit> = self.exchanges.iter().filter(|edit| edit.kind == EditKind::Sign).collect();
        self.proved(pairs(&signs))
    }

    /// Corrections by two edits, several lost terms, another value of a part, or three edits. The first size with a proved edit ends the search.
    pub fn large(&self) -> Vec<Correction> {
        if !self.ground.has_points() {
            return Vec::new();
        }
        let is_short = |edit: &&Edit| !matches!(edit.kind, EditKind::Number | EditKind::Letter);
        let short: Vec<&Edit> = self.exchanges.iter().filter(is_short).collect();
        let (text, places) = (self.ground.text(), &self.places);
        // with as many edits as it has letters, a short formula could be turned into any true one
        let size = places.atoms.len() + places.numbers.len() + places.calls.len();
        let found = if size < LEAST_FOR_TWO { Vec::new() } else { self.proved(pairs(&short)) };
        if !found.is_empty() {
            return found;
        }
        let factors = factors::factors(places, text, self.ground.rates());
        // rates and composed quantities that the printed formula does not contain are not added together with other edits
        let is_printed = |rate: &LetterRate| places.atoms.iter().any(|atom| atom.name == rate.name);
        let is_quantity = |rate: &&LetterRate| (rate.order > 0 || !rate.is_symbol) && !is_printed(rate);
        let foreign = self.ground.rates().iter().filter(is_quantity);
        let foreign: Vec<&str> = foreign.map(|rate| rate.latex.as_str()).collect();
        let adds_rate = |edit: &Edit| {
            let added = [Some(edit.after.as_str()), edit.closing.as_ref().map(|(_, text)| text.as_str())];
            added.into_iter().flatten().any(|added| foreign.iter().any(|rate| added.contains(rate)))
        };
        let factors = factors.into_iter().filter(|edit| !adds_rate(edit)).collect();
        let edits = [self.exchanges.clone(), factors, terms::superfluous(places, text)].concat();
        let edits = if size < LEAST_FOR_TWO { Vec::new() } else { edits };
        let effects = self.residual.as_ref().map_or_else(Vec::new, |residual| self.effects(&edits, residual));
        let residual = self.residual.clone().unwrap_or_default();
        let most = (places.summands.len() + 1).min(MOST_LOST);
        let kept = OnceCell::new();
        let compared = || kept.get_or_init(|| comparison::compared(self.ground, places));
        // several added terms are rejected if fewer edits of printed terms suffice
        let adds = |edit: &Edit| edit.kind == EditKind::LostTerm;
        let changes_some = |edits: &&Vec<Edit>| !edits.iter().all(adds);
        let fewest = || {
            let changing = compared().iter().filter(changes_some).map(Vec::len).min();
            changing.map_or(most, |edits| edits.saturating_sub(1))
        };
        let adds_nothing = |edits: &[Edit]| !edits.iter().any(adds);
        let one = |edits: Vec<Edit>| edits.into_iter().map(|edit| vec![edit]).collect::<Vec<_>>();
        let sizes: [&dyn Fn() -> Vec<Vec<Edit>>; 10] = [
            &|| combinations::alone(&effects, &residual),
            &|| combinations::pairs(&effects, &residual),
            &|| renamings::renamings(places, text, self.ground.rates()),
            &|| one(self.ground.lost(places, most.min(fewest()))),
            &|| compared().iter().filter(|edits| adds_nothing(edits)).cloned().collect(),
            &|| values(self.ground, places, false),
            &|| self.beside_lost(&effects),
            &|| if size < LEAST_FOR_THREE { Vec::new() } else { combinations::triples(&effects, &residual) },
            &|| values(self.ground, places, true),
            &|| compared().clone(),
        ];
        sizes
            .into_iter()
            .map(|edits| self.proved(edits().into_iter()))
            .find(|found| !found.is_empty())
            .unwrap_or_default()
    }

    /// Pairs of an edit and one lost term at the end of the last side.
    fn beside_lost(&self, effects: &[Effect]) -> Vec<Vec<Edit>> {
        let end = self.ground.text().trim_end().len();
        let single = effects.iter().filter(|effect| effect.edits.len() == 1).take(MOST_BESIDE);
        let going = single.take_while(|_| self.ground.goes_on());
        let with = |effect: &Effect| {
            let first = effect.edits[0].clone();
            let terms = lost_beside(self.ground, &first, end);
            terms.into_iter().map(move |term| vec![first.clone(), term]).collect::<Vec<_>>()
        };
        going.flat_map(with).collect()
    }

    /// Edits with their change of the residual, the smallest edits first, then pairs of edits of one term.
    fn effects(&self, edits: &[Edit], residual: &[f64]) -> Vec<Effect> {
        let mut tried = HashSet::new();
        let mut ordered: Vec<&Edit> = edits.iter().collect();
        ordered.sort_by_key(|edit| size(edit));
        let going = ordered.into_iter().take_while(|_| self.ground.goes_on());
        let all = going.filter_map(|edit| {
            let change = self.change(edit, residual, &mut tried)?;
            (!is_small(&change, residual)).then(|| Effect { edits: vec![edit.clone()], change })
        });
        let mut all: Vec<Effect> = all.take(MOST_MEASURED).collect();
        let single = all.len();
        for term in &self.places.summands {
            let none = Edit::new(EditKind::ExtraTerm, term.span.clone(), "0", String::new());
            let Some(change) = self.change(&none, residual, &mut HashSet::new()) else { continue };
            let pairs = combinations::in_one_product(&all[..single], &term.span, &change);
            all.extend(pairs);
            if all.len() > MOST_EFFECTS {
                break;
            }
        }
        all
    }

    /// The change of the residual by one edit; `None` if the edit was tried before or gives no valid formula.
    fn change(&self, edit: &Edit, residual: &[f64], tried: &mut HashSet<String>) -> Option<Vec<f64>> {
        let (text, _) = edited(self.ground.text(), std::slice::from_ref(edit))?;
        if !is_whole(&text) || !tried.insert(text.clone()) {
            return None;
        }
        let statement = read(&text, &self.known).ok()?;
        let after = self.ground.residual(&statement).filter(|after| after.len() == residual.len())?;
        Some(after.iter().zip(residual).map(|(after, before)| after - before).collect())
    }

    /// The first corrections that are proved, with different formulas. Candidates that hold at the test points are decided before others.
    pub fn proved(&self, candidates: impl Iterator<Item = Vec<Edit>>) -> Vec<Correction> {
        let (mut found, mut open): (Vec<(Correction, Option<Sym>)>, Vec<Candidate>) = (Vec::new(), Vec::new());
        let mut tried = HashSet::<String>::new();
        let most = if self.ground.has_points() { MOST_DECIDED } else { MOST_UNTESTED };
        let mut decided = 0;
        for edits in candidates {
            if found.len() >= MOST_TOLD || decided >= most || !self.ground.goes_on() {
                break;
            }
            let Some((text, parts)) = edited(self.ground.text(), &edits) else { continue };
            if !is_whole(&text) || !tried.insert(text.clone()) {
                continue;
            }
            let Ok(statement) = read(&text, &self.known) else { continue };
            if self.is_apart(&statement) {
                continue;
            }
            let candidate = Candidate { own: self.ground.own_difference(&statement), text, edits, parts };
            let is_empty = || candidate.own.is_some_and(|own| is_number(own) && !self.is_number);
            let says_less = || self.ground.redundancies(&statement) > self.redundancies;
            match self.ground.has_points().then(|| self.ground.look(&candidate.text, &statement)) {
                Some(Look::Fails) => {}
                _ if says_less() => {}
                Some(Look::Open) => open.push(candidate),
                // identities in the letters and inequalities between numbers state nothing
                None if is_empty() => {}
                None | Some(Look::Holds) => {
                    decided += 1;
                    self.decide(candidate, &mut found);
                }
            }
        }
        if found.is_empty() {
            for candidate in open.into_iter().take(MOST_DECIDED) {
                if found.len() < MOST_TOLD && self.ground.goes_on() {
                    self.decide(candidate, &mut found);
                }
            }
        }
        found.into_iter().map(|(correction, _)| correction).collect()
    }

    /// Whether the residual shows that an edited formula is false.
    fn is_apart(&self, statement: &Statement) -> bool {
        let Some(before) = &self.residual else { return false };
        let after = self.ground.residual(statement);
        after.is_some_and(|after| after.len() == before.len() && !is_small(&after, before))
    }

    /// Adds a candidate to the corrections if it is proved and is not equivalent to one of them.
    fn decide(&self, candidate: Candidate, found: &mut Vec<(Correction, Option<Sym>)>) {
        let Candidate { text, edits, parts, own } = candidate;
        let is_known = |known: &Option<Sym>| known.zip(own).is_some_and(|(known, own)| is_one_equality(known, own));
        if found.iter().any(|(_, known)| is_known(known)) {
            return;
        }
        if let Some(proof) = self.ground.proved(&text) {
            found.push((self.correction(&edits, text, parts, proof), own));
        }
    }

    fn correction(&self, edits: &[Edit], formula: String, parts: Vec<Range<usize>>, proof: Proof) -> Correction {
        let change = |edit: &Edit| {
            let [before, after] = edit.shown(self.ground.text());
            Change { kind: edit.kind, words: edit.words.clone(), before, after }
        };
        let Proof { judged, certificate } = proof;
        let mut changes: Vec<Change> = Vec::new();
        for change in edits.iter().map(change) {
            // an edit of all occurrences of a letter is reported once
            if !changes.contains(&change) {
                changes.push(change);
            }
        }
        Correction { changes, formula, parts, judged, certificate }
    }
}

/// Whether two equations are equivalent because one is the other multiplied or divided by letters and numbers: `H/u = w` and `H = u w`.
fn is_one_equality(one: Sym, other: Sym) -> bool {
    if [one - other, one + other].into_iter().any(|zero| decide(zero, &Hypotheses::none()).is_zero()) {
        return true;
    }
    let is_product = |ratio: Sym| {
        Sym::ascending(&[ratio]).into_iter().all(|part| !matches!(part.node(), Node::Sum(..) | Node::Difference(..)))
    };
    let is_zero = |of: Sym| decide(of, &Hypotheses::none()).is_zero();
    !is_zero(other) && normal(one / other, &Hypotheses::none()).is_ok_and(|ratio| is_product(ratio.to_sym()))
}

/// Whether an expression is a number, independent of its letters.
fn is_number(expression: Sym) -> bool {
    normal(expression, &Hypotheses::none()).is_ok_and(|form| form.to_sym().as_constant().is_some())
}

/// An edited formula.
struct Candidate {
    text: String,
    edits: Vec<Edit>,
    /// The ranges of the edits in the text, in bytes.
    parts: Vec<Range<usize>>,
    /// The difference of its sides in the printed letters.
    own: Option<Sym>,
}

/// Pairs of edits in separate ranges.
fn pairs<'a>(edits: &'a [&Edit]) -> impl Iterator<Item = Vec<Edit>> + 'a {
    let each = edits.iter().enumerate().flat_map(|(place, first)| {
        edits[place + 1..]
            .iter()
            .filter(|second| apart(first, second))
            .map(|second| vec![(*first).clone(), (*second).clone()])
    });
    each.take(MOST_PAIRS)
}

/// The text of the formula after all edits, and for each part of an edit its range of bytes in the new text; `None` if two edits overlap.
pub(super) fn edited(formula: &str, edits: &[Edit]) -> Option<(String, Vec<Range<usize>>)> {
    let behind = |place: usize| &edits[place + 1..];
    if edits.iter().enumerate().any(|(place, one)| behind(place).iter().any(|other| !apart(one, other))) {
        return None;
    }
    let edits: Vec<Edit> = edits.iter().flat_map(Edit::parts).collect();
    let mut ordered: Vec<&Edit> = edits.iter().collect();
    // at one position, the sign before a part is inserted after the part itself is edited, and a lost term before a fraction is closed
    let rank = |edit: &Edit| match edit.kind {
        EditKind::LostTerm => 0,
        _ if edit.after.starts_with('}') => 1,
        EditKind::Sign => 3,
        _ => 2,
    };
    ordered.sort_by_key(|edit| (Reverse((edit.span.start, edit.span.end)), rank(edit)));
    let (mut text, mut parts) = (formula.to_owned(), Vec::<Range<usize>>::new());
    for edit in ordered {
        let (next, mut part) = edit.applied(&text);
        // the context of an edit is marked too, unless it overlaps another edit
        let around = &edit.around;
        let stands_there =
            |other: &&Edit| *other != edit && around.start <= other.span.end && other.span.start <= around.end;
        if !edits.iter().any(|other| stands_there(&other)) {
            part = part.start - (edit.span.start - around.start)..part.end + (around.end - edit.span.end);
        }
        // later ranges are shifted by the change of length
        for behind in &mut parts {
            *behind = behind.start + next.len() - text.len()..behind.end + next.len() - text.len();
        }
        parts.push(part);
        text = next;
    }
    parts.reverse();
    Some((text, parts))
}
