//! The principles of mechanics, equal on every system; where one is valid under a condition only, the condition.

pub mod alphabet;
mod any;
mod combining;
pub mod equal;
mod friction;
mod lost;
mod museum;
pub mod systems;

pub use alphabet::{dimension, letter};

use super::papers::Paper;
use claims::Page;

/// The page of the workbench's own.
pub const PAPER: Paper = Paper {
    key: "principles",
    title: "The principles of mechanics, equal on every system",
    citation: "The workbench's own page",
    summary: "x",
    entries: &["rod", "steered-rod", "ladder", "disc", "knife-edge", "swing", "kept-speed"],
    page,
};

/// The page.
pub fn page() -> Page {
    let mut page = Page::of(PAPER.key, dimension);
    combining::claims(&mut page);
    friction::claims(&mut page);
    lost::claims(&mut page);
    museum::claims(&mut page);
    page
}
