//! The smallest edit of a printed formula that makes a refuted claim true.
//!
//! # Overview
//! * [`places`]: terms, factors, letters, numbers and powers with their places in the print;
//! * [`exchanges`], [`factors`], [`terms`]: the edits, by their size;
//! * [`probe`]: an edited claim is looked at in exact points before it is decided;
//! * [`corrections`]: the edits of the first size at which one is proved, by the judge of the claim itself.

mod edit;
mod exchanges;
mod factors;
mod hypotheses;
mod letter_rates;
mod lost;
mod places;
mod probe;
mod terms;

use crate::change::{Change, Correction, EditKind};
use crate::claim_text::{ClaimText, Kind};
use crate::conditions::Hypothesis;
use crate::finding::Finding;
use crate::integrals::known;
use crate::letters::Letters;
use crate::numbers::{Right, right};
use claims::Verdict;
use edit::{Edit, is_whole};
use latex::{Statement, read};
use lost::lost;
use places::Places;
use probe::{Look, Probe, own_difference};
use std::collections::HashSet;
use std::ops::Range;
use symbolic::{Hypotheses, Sym, decide};

/// Corrections of one size that are told.
const MOST_TOLD: usize = 3;

/// Edits that pass the points and are decided exactly, for each size.
const MOST_DECIDED: usize = 24;

/// Edits of claims that no point can test, which are all decided exactly.
const MOST_UNTESTED: usize = 160;

/// Pairs of edits that are looked at.
const MOST_PAIRS: usize = 4_000;

/// Terms that a print may have lost together.
const MOST_LOST: usize = 3;

/// Everything that a claim is judged with.
pub(crate) struct Judge<'a> {
    /// Reads and decides an edited claim; none where it cannot be read.
    pub decide: &'a dyn Fn(&ClaimText) -> Option<Finding>,
    /// Whether there is time left.
    pub goes_on: &'a dyn Fn() -> bool,
}

/// Corrections of a refuted claim, all of one size; none where no edit is proved.
pub(crate) fn corrections(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    judge: &Judge<'_>,
) -> Vec<Correction> {
    let text = claim.formula.text.as_str();
    let places = Places::of(statement, text);
    if claim.kind == Kind::Number {
        let search = Search { claim, letters, probe: None, judge };
        let digits = digits(claim, statement, letters, assumed);
        let edits = exchanges::signs(&places, text).into_iter().chain(digits);
        return search.proved(edits.map(|edit| vec![edit])).into_iter().take(1).collect();
    }
    let probe = Probe::of(claim, statement, letters, assumed);
    let search = Search { claim, letters, probe: probe.as_ref(), judge };
    let exchanges =
        [exchanges::directions(text), terms::repeated(&places, text), exchanges::exchanges(&places, text, letters)]
            .concat();
    let sizes: [&dyn Fn() -> Vec<Edit>; 3] =
        [&|| exchanges.clone(), &|| factors::factors(&places, text, letters), &|| {
            let lost = probe.as_ref().map(|probe| lost(claim.kind, &places, text, letters, probe, 1));
            [terms::superfluous(&places, text), lost.unwrap_or_default()].concat()
        }];
    for edits in sizes {
        let edits: Vec<Vec<Edit>> = edits().into_iter().map(|edit| vec![edit]).collect();
        let found = search.proved(edits.into_iter());
        if !found.is_empty() {
            return found;
        }
    }
    let signs: Vec<&Edit> = exchanges.iter().filter(|edit| edit.kind == EditKind::Sign).collect();
    if probe.is_some() {
        let found = search.proved(pairs(&signs));
        if !found.is_empty() {
            return found;
        }
    }
    let found = search.under(hypotheses::candidates(&places, letters));
    let Some(probe) = probe.as_ref().filter(|_| found.is_empty()) else { return found };
    let short: Vec<&Edit> =
        exchanges.iter().filter(|edit| !matches!(edit.kind, EditKind::Number | EditKind::Letter)).collect();
    let found = search.proved(pairs(&short));
    if !found.is_empty() {
        return found;
    }
    let several = lost(claim.kind, &places, text, letters, probe, places.summands.len().min(MOST_LOST));
    search.proved(several.into_iter().map(|edit| vec![edit]))
}

/// Two edits together that stand apart.
fn pairs<'a>(edits: &'a [&Edit]) -> impl Iterator<Item = Vec<Edit>> + 'a {
    let each = edits.iter().enumerate().flat_map(|(place, first)| {
        let apart = |second: &&&Edit| first.span.end <= second.span.start || second.span.end <= first.span.start;
        edits[place + 1..].iter().filter(apart).map(|second| vec![(*first).clone(), (*second).clone()])
    });
    each.take(MOST_PAIRS)
}

/// An edited claim.
struct Candidate {
    claim: ClaimText,
    edits: Vec<Edit>,
    parts: Vec<Range<usize>>,
    /// The difference of its sides in the paper's letters.
    own: Option<Sym>,
}

struct Search<'a, 't, 'm> {
    claim: &'a ClaimText,
    letters: &'a Letters<'t, 'm>,
    probe: Option<&'a Probe<'t, 'm>>,
    judge: &'a Judge<'a>,
}

impl Search<'_, '_, '_> {
    /// The first corrections that are proved, no two of which are one formula. Those that hold at points are decided first.
    fn proved(&self, candidates: impl Iterator<Item = Vec<Edit>>) -> Vec<Correction> {
        let (mut found, mut open): (Vec<(Correction, Option<Sym>)>, Vec<Candidate>) = (Vec::new(), Vec::new());
        let mut tried: HashSet<String> = HashSet::new();
        let most = if self.probe.is_some() { MOST_DECIDED } else { MOST_UNTESTED };
        let mut decided = 0;
        for edits in candidates {
            if found.len() >= MOST_TOLD || decided >= most || !(self.judge.goes_on)() {
                break;
            }
            let (text, parts) = edited(&self.claim.formula.text, &edits);
            if !is_whole(&text) || !tried.insert(text.clone()) {
                continue;
            }
            let mut claim = self.claim.clone();
            claim.formula = claim.formula.with_text(text);
            claim.expected = None;
            let Ok(statement) = read(&claim.formula.text, &known(claim.kind, self.letters)) else { continue };
            let candidate = Candidate { own: own_difference(&statement, self.letters), claim, edits, parts };
            match self.probe.map(|probe| probe.look(&candidate.claim, &statement, self.letters)) {
                Some(Look::Fails) => {}
                Some(Look::Open) => open.push(candidate),
                // an identity of the letters says nothing
                None if candidate.own.is_some_and(|own| decide(own, &Hypotheses::none()).is_zero()) => {}
                None | Some(Look::Holds) => {
                    decided += 1;
                    self.decide(candidate, &mut found);
                }
            }
        }
        if found.is_empty() {
            for candidate in open.into_iter().take(MOST_DECIDED) {
                if found.len() < MOST_TOLD && (self.judge.goes_on)() {
                    self.decide(candidate, &mut found);
                }
            }
        }
        found.into_iter().map(|(correction, _)| correction).collect()
    }

    /// Keeps a candidate that is proved and differs from those before it by more than its sign.
    fn decide(&self, candidate: Candidate, found: &mut Vec<(Correction, Option<Sym>)>) {
        let Candidate { claim, edits, parts, own } = candidate;
        let is_one =
            |a: Sym, b: Sym| [a - b, a + b].into_iter().any(|zero| decide(zero, &Hypotheses::none()).is_zero());
        let is_known = |known: &Option<Sym>| known.zip(own).is_some_and(|(known, own)| is_one(known, own));
        if found.iter().any(|(_, known)| is_known(known)) {
            return;
        }
        if let Some(finding) = (self.judge.decide)(&claim).filter(|finding| is_sound(finding, &claim)) {
            found.push((self.correction(&edits, claim.formula.text, parts, finding), own));
        }
    }

    /// Hypotheses under which the claim as printed is proved.
    fn under(&self, candidates: Vec<String>) -> Vec<Correction> {
        let mut found = Vec::new();
        for hypothesis in candidates {
            if found.len() >= MOST_TOLD || !(self.judge.goes_on)() {
                break;
            }
            let mut claim = self.claim.clone();
            claim.given.push(claim.formula.with_text(hypothesis.clone()));
            claim.expected = None;
            if !hypotheses::leaves_something(&claim, &hypothesis, self.letters) {
                continue;
            }
            if let Some(finding) = (self.judge.decide)(&claim).filter(|finding| is_sound(finding, &claim)) {
                let change = Change {
                    kind: EditKind::Hypothesis,
                    words: format!("the hypothesis `{hypothesis}`"),
                    before: String::new(),
                    after: hypothesis,
                };
                found.push(Correction {
                    changes: vec![change],
                    formula: self.claim.formula.text.clone(),
                    parts: Vec::new(),
                    judged: finding.judged,
                    certificate: finding.certificate,
                });
            }
        }
        found
    }

    fn correction(&self, edits: &[Edit], formula: String, parts: Vec<Range<usize>>, finding: Finding) -> Correction {
        let change = |edit: &Edit| Change {
            kind: edit.kind,
            words: edit.words.clone(),
            before: self.claim.formula.text[edit.span.clone()].trim().to_owned(),
            after: edit.after.trim().to_owned(),
        };
        let Finding { judged, certificate, .. } = finding;
        Correction { changes: edits.iter().map(change).collect(), formula, parts, judged, certificate }
    }
}

/// The right digits of a printed number, as many as are printed.
fn digits(claim: &ClaimText, statement: &Statement, letters: &Letters<'_, '_>, assumed: &[Hypothesis]) -> Option<Edit> {
    let Right { span, digits } = right(claim, statement, letters, assumed)?;
    let words = format!("the number `{digits}` for `{}`", &claim.formula.text[span.clone()]);
    Some(Edit { kind: EditKind::Digits, span, after: digits, words })
}

/// Proved without an objection; of printed numbers by enclosures.
fn is_sound(finding: &Finding, claim: &ClaimText) -> bool {
    let verdict = finding.judged.verdict;
    let is_shown = verdict == Verdict::Proved || verdict == Verdict::Enclosed && claim.kind == Kind::Number;
    is_shown && finding.judged.objections.is_empty()
}

/// The formula after its edits, and where they stand in it.
fn edited(formula: &str, edits: &[Edit]) -> (String, Vec<Range<usize>>) {
    let mut ordered: Vec<&Edit> = edits.iter().collect();
    ordered.sort_by_key(|edit| std::cmp::Reverse(edit.span.start));
    let (mut text, mut parts) = (formula.to_owned(), Vec::<Range<usize>>::new());
    for edit in ordered {
        let (next, part) = edit.applied(&text);
        // what stands behind moves along
        for behind in &mut parts {
            *behind = behind.start + next.len() - text.len()..behind.end + next.len() - text.len();
        }
        parts.push(part);
        text = next;
    }
    parts.reverse();
    (text, parts)
}
