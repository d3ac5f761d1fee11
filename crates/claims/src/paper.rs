//! A paper as an entry of the ledger.

use crate::Page;

/// A paper of the ledger.
#[derive(Clone, Copy, Debug)]
pub struct Paper {
    /// The beginning of the ids of its claims.
    pub key: &'static str,
    /// Authors, year, subject: for headings.
    pub title: &'static str,
    /// Authors, title, journal.
    pub citation: &'static str,
    /// Subject and findings in a paragraph; LaTeX between dollar signs.
    pub summary: &'static str,
    /// Everything that it states: numbered equations, then statements. Each must have a claim.
    pub entries: &'static [&'static str],
    /// The claims of the paper, made in the calling thread.
    pub page: fn() -> Page,
}
