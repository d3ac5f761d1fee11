//! The catalogue of papers from all linked crates.

use crate::{Page, Paper};

/// The papers of one crate, in the order of the ledger; the ledger orders catalogues by name.
#[derive(Clone, Copy, Debug)]
pub struct Catalogue {
    pub name: &'static str,
    pub papers: &'static [&'static Paper],
}

inventory::collect!(Catalogue);

/// All papers of all linked crates, including the workbench's own pages.
pub fn papers() -> Vec<&'static Paper> {
    let mut catalogues: Vec<&Catalogue> = inventory::iter::<Catalogue>().collect();
    catalogues.sort_by_key(|catalogue| catalogue.name);
    catalogues.iter().flat_map(|catalogue| catalogue.papers).copied().collect()
}

/// The pages of all papers, built in the calling thread.
pub fn pages() -> Vec<Page> {
    papers().into_iter().map(|paper| (paper.page)()).collect()
}
