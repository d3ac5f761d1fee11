//! Paper.

mod alphabet;
mod general;
mod ladder;
mod rod;
mod section11_extended;
mod section11_lagrange;
mod section11_law;
mod section11_painleve;
mod section12_lagrange;
mod section12_redundant;
mod section13_friction;
mod section13_ladder;
mod section13_lagrange;
mod section13_motion;
mod section13_quadrature;
mod steered;
mod work;

pub use alphabet::{dimension, letter};

use super::Paper;
use claims::Page;
use ladder::LadderLetters;
use rod::RodLetters;
use steered::SteeredLetters;

/// The paper.
pub const PAPER: Paper = Paper {
    key: "manglieva2022",
    title: "Manglieva & Beknazarov 2022: constraints with friction",
    citation: "",
    summary: "",
    entries: &[],
    page,
};

/// The page of the paper.
pub fn page() -> Page {
    let mut page = Page::of(PAPER.key, dimension);
    let rod = RodLetters::default();
    section11_painleve::claims(&mut page, &rod);
    section11_extended::claims(&mut page, &rod);
    section11_law::claims(&mut page, &rod);
    section11_lagrange::claims(&mut page, &rod);
    section12_lagrange::claims(&mut page);
    section12_redundant::claims(&mut page);
    let steered = SteeredLetters::default();
    section13_friction::claims(&mut page, &steered);
    section13_motion::claims(&mut page, &steered);
    section13_lagrange::claims(&mut page, &steered);
    let ladder = LadderLetters::default();
    section13_ladder::claims(&mut page, &ladder);
    section13_quadrature::claims(&mut page, &ladder);
    page
}
