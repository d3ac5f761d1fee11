//! A paper as an entry of the ledger.

use crate::Page;

/// A paper of the ledger.
#[derive(Clone, Copy, Debug)]
pub struct Paper {
    /// The key of the paper, with which the ids of its claims begin.
    pub key: &'static str,
    /// Authors, year, subject, as shown in headings.
    pub title: &'static str,
    /// Authors, title, journal.
    pub citation: &'static str,
    /// The subject and the findings in a paragraph, with LaTeX between dollar signs.
    pub summary: &'static str,
    /// All numbered equations of the paper, then its statements. Each must have a claim.
    pub entries: &'static [&'static str],
    /// Builds the claims of the paper in the calling thread.
    pub page: fn() -> Page,
}
