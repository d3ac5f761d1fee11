//! Papers, each a page of claims in the paper's own order and letters.

pub mod konosevich2022;
pub mod manglieva2022;
pub mod mukharlyamov2007;

use claims::Page;

/// A paper of the ledger.
#[derive(Clone, Copy, Debug)]
pub struct Paper {
    /// What ids begin with.
    pub key: &'static str,
    /// Authors, year, subject: for headings.
    pub title: &'static str,
    /// Authors, title, journal.
    pub citation: &'static str,
    /// What the paper is about and what was found, in a paragraph; LaTeX between dollar signs.
    pub summary: &'static str,
    /// Everything it states: numbered equations, then statements. Each must have a claim.
    pub entries: &'static [&'static str],
    /// Its claims, made in the calling thread.
    pub page: fn() -> Page,
}

/// Every paper, and the workbench's own pages.
pub const ALL: &[Paper] = &[
    konosevich2022::PAPER,
    manglieva2022::PAPER,
    mukharlyamov2007::PAPER,
    crate::principles::PAPER,
    crate::regimes::PAPER,
    crate::stabilisation::PAPER,
    crate::stationary::PAPER,
    crate::phantom::PAPER,
    crate::synchronism::PAPER,
    crate::stationary::stability::PAPER,
];

/// Every paper's page, made in the calling thread.
pub fn pages() -> Vec<Page> {
    ALL.iter().map(|paper| (paper.page)()).collect()
}
