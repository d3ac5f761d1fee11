//! The difference between two texts of a page, term by term: which term of which equation changed, and its physical
//! meaning.
//!
//! A page is exact text, so a difference of pages is a difference of statements. The equations of a claim are read back
//! ([`symbolic::parse`]), both are brought to one side and written out, and their monomials are compared: a term is gone,
//! new, of the other sign, or has another factor. The dimensions of its letters give the meaning of a term.

mod meaning;
mod page;
mod terms;

pub use meaning::meaning;
pub use terms::{Edit, Term, compare};

use page::{Told, claims};
use std::fmt;
use symbolic::Dimension;

/// A change of a claim between two texts.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// The claim was removed.
    Gone { id: String },
    /// The claim is new.
    New { id: String, verdict: String },
    /// Another verdict.
    Verdict { id: String, from: String, to: String },
    /// An equation of it, by its place, with the terms that differ.
    Terms { id: String, place: usize, terms: Vec<Term> },
    /// An equation is written otherwise and says the same.
    Rewritten { id: String, place: usize },
    /// An equation that cannot be read back: both as they stand.
    Text { id: String, place: usize, from: String, to: String },
    /// Equations came or went.
    Lines { id: String, from: usize, to: usize },
    /// Conditions that it needs now, or no longer.
    Requires { id: String, gained: Vec<String>, lost: Vec<String> },
    /// Another sentence.
    Sentence { id: String, from: String, to: String },
    /// The remarks: why the print fails, how it was read.
    Remarks { id: String, gained: Vec<String>, lost: Vec<String> },
    /// Another exact point, or another excess at it.
    Point { id: String },
}

/// All changes, in the order of the new page; removed claims come first.
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
