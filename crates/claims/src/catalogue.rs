//! The catalogue of papers, from every crate that is linked.

use crate::{Page, Paper};

/// The papers that a crate brings, in the order of the ledger; catalogues are ordered by name.
#[derive(Clone, Copy, Debug)]
pub struct Catalogue {
    pub name: &'static str,
    pub papers: &'static [&'static Paper],
}

inventory::collect!(Catalogue);

/// Every paper, and the workbench's own pages.
pub fn papers() -> Vec<&'static Paper> {
    let mut catalogues: Vec<&Catalogue> = inventory::iter::<Catalogue>().collect();
    catalogues.sort_by_key(|catalogue| catalogue.name);
    catalogues.iter().flat_map(|catalogue| catalogue.papers).copied().collect()
}

/// Every paper's page, made in the calling thread.
pub fn pages() -> Vec<Page> {
    papers().into_iter().map(|paper| (paper.page)()).collect()
}
