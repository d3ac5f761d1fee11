//! The difference between two versions of a page, term by term: the changed terms of each equation, and their physical
//! meaning.
//!
//! A page contains exact text, so that a difference of texts is a difference of statements. The equations of a claim are parsed
//! ([`symbolic::parse`]), brought to one side and expanded, and their monomials are compared: a term may be removed,
//! added, changed in sign, or multiplied by a factor. The dimensions of the letters give the meaning of a term.

mod meaning;
mod page;
mod terms;

pub use meaning::meaning;
pub use terms::{Edit, Term, compare};

use page::{Told, claims};
use std::fmt;
use symbolic::Dimension;

/// A change of a claim between two versions of a page.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// The claim was removed.
    Gone { id: String },
    /// The claim is new.
    New { id: String, verdict: String },
    /// The verdict changed.
    Verdict { id: String, from: String, to: String },
    /// Terms of the equation with the index `place` changed.
    Terms { id: String, place: usize, terms: Vec<Term> },
    /// The equation with the index `place` is written differently and is equivalent.
    Rewritten { id: String, place: usize },
    /// The equation with the index `place` changed and cannot be parsed: both texts.
    Text { id: String, place: usize, from: String, to: String },
    /// The number of equations changed.
    Lines { id: String, from: usize, to: usize },
    /// Required conditions were added (`gained`) or removed (`lost`).
    Requires { id: String, gained: Vec<String>, lost: Vec<String> },
    /// The sentence changed.
    Sentence { id: String, from: String, to: String },
    /// Remarks were added or removed: the reason of a failure, the reading, notes.
    Remarks { id: String, gained: Vec<String>, lost: Vec<String> },
    /// The exact point changed, or the difference at it.
    Point { id: String },
}

/// All changes, first removed claims, then the others in the order of the new page.
pub fn review(old: &str, new: &str, dimension: &dyn Fn(&str) -> Option<Dimension>) -> Vec<Change> {
    let (before, now) = (claims(old), claims(new));
    let find = |all: &'_ [Told], id: &str| all.iter().position(|claim| claim.id == id);
    let gone = before.iter().filter(|claim| find(&now, &claim.id).is_none());
    let mut changes: Vec<Change> = gone.map(|claim| Change::Gone { id: claim.id.clone() }).collect();
    for claim in &now {
        match find(&before, &claim.id) {
            None => changes.push(Change::New { id: claim.id.clone(), verdict: claim.verdict.clone() }),
            Some(place) => changed(&before[place], claim, dimension, &mut changes),
        }
    }
    changes
}

fn changed(old: &Told, new: &Told, dimension: &dyn Fn(&str) -> Option<Dimension>, changes: &mut Vec<Change>) {
    let id = || new.id.clone();
    if old.verdict != new.verdict {
        changes.push(Change::Verdict { id: id(), from: old.verdict.clone(), to: new.verdict.clone() });
    }
    if old.sentence != new.sentence {
        changes.push(Change::Sentence { id: id(), from: old.sentence.clone(), to: new.sentence.clone() });
    }
    if old.equations.len() != new.equations.len() {
        changes.push(Change::Lines { id: id(), from: old.equations.len(), to: new.equations.len() });
    } else {
        let pairs = old.equations.iter().zip(&new.equations).enumerate();
        for (place, (from, to)) in pairs.filter(|(_, (from, to))| from != to) {
            changes.push(match terms::compare(from, to, dimension) {
                Some(terms) if terms.is_empty() => Change::Rewritten { id: id(), place },
                Some(terms) => Change::Terms { id: id(), place, terms },
                None => Change::Text { id: id(), place, from: from.clone(), to: to.clone() },
            });
        }
    }
    let without = |these: &[String], those: &[String]| -> Vec<String> {
        these.iter().filter(|each| !those.contains(each)).cloned().collect()
    };
    let (gained, lost) = (without(&new.requires, &old.requires), without(&old.requires, &new.requires));
    if !gained.is_empty() || !lost.is_empty() {
        changes.push(Change::Requires { id: id(), gained, lost });
    }
    let (gained, lost) = (without(&new.remarks, &old.remarks), without(&old.remarks, &new.remarks));
    if !gained.is_empty() || !lost.is_empty() {
        changes.push(Change::Remarks { id: id(), gained, lost });
    }
    if old.rest != new.rest {
        changes.push(Change::Point { id: id() });
    }
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Gone { id } => write!(f, "{id}: gone"),
            Self::New { id, verdict } => write!(f, "{id}: new, {verdict}"),
            Self::Verdict { id, from, to } => write!(f, "{id}: {from} before, {to} now"),
            Self::Terms { id, place, terms } => {
                write!(f, "{id}, line {}:", place + 1)?;
                terms.iter().try_for_each(|term| write!(f, "\n    {term}"))
            }
            Self::Rewritten { id, place } => {
                write!(f, "{id}, line {}: written otherwise, the same for all values", place + 1)
            }
            Self::Text { id, place, from, to } => {
                write!(f, "{id}, line {}: not comparable term by term\n    - {from}\n    + {to}", place + 1)
            }
            Self::Lines { id, from, to } => write!(f, "{id}: {from} lines before, {to} now"),
            Self::Requires { id, gained, lost } => {
                write!(f, "{id}:")?;
                gained.iter().try_for_each(|each| write!(f, "\n    needs now: {each}"))?;
                lost.iter().try_for_each(|each| write!(f, "\n    no longer needs: {each}"))
            }
            Self::Remarks { id, gained, lost } => {
                write!(f, "{id}: other remarks")?;
                lost.iter().try_for_each(|each| write!(f, "\n    - {each}"))?;
                gained.iter().try_for_each(|each| write!(f, "\n    + {each}"))
            }
            Self::Sentence { id, from, to } => write!(f, "{id}: another sentence\n    - {from}\n    + {to}"),
            Self::Point { id } => write!(f, "{id}: another exact point, or another value at it"),
        }
    }
}
