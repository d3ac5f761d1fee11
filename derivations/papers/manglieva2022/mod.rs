//! Paper.

mod alphabet;
mod rod;
mod section11_extended;
mod section11_lagrange;
mod section11_law;
mod section11_painleve;
mod section13_friction;
mod section13_lagrange;
mod section13_motion;
mod steered;

pub use alphabet::{dimension, letter};

use super::Paper;
use claims::Page;
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
    let steered = SteeredLetters::default();
    section13_friction::claims(&mut page, &steered);
    section13_motion::claims(&mut page, &steered);
    section13_lagrange::claims(&mut page, &steered);
    page
}
