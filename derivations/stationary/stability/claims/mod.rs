//! The page of claims.

mod alphabet;
mod closed;
mod families;
mod foundations;
mod letters;
mod motors;

use super::PAPER;
use crate::papers::konosevich2022::Letters;
use claims::Page;

/// The claims, made in the calling thread.
pub fn page() -> Page {
    let letters = Letters::default();
    let mut page = Page::of(PAPER.key, alphabet::dimension);
    foundations::claims(&mut page, &letters);
    motors::claims(&mut page, &letters);
    closed::claims(&mut page, &letters);
    families::claims(&mut page, &letters);
    page
}
