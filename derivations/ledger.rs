//! The ledger: every page of claims, the papers' and the workbench's own.

use claims::{Page, Paper};

/// Every paper, and the workbench's own pages.
pub const PAGES: &[Paper] = &[
    crate::papers::konosevich2022::PAPER,
    crate::papers::manglieva2022::PAPER,
    crate::papers::mukharlyamov2007::PAPER,
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
    PAGES.iter().map(|paper| (paper.page)()).collect()
}
