//! The letters of the page with their LaTeX and dimensions.

use crate::alphabet::{self, Letter};
use symbolic::{Dimension, Sym};

/// (name, LaTeX, exponents of kg, m, s)
const LETTERS: &[Letter<3>] = &[
    ("z", "z", [0, 0, 0]),
    ("y", "y", [0, 0, 0]),
    ("a", "a", [0, 0, 0]),
    ("b", "b", [0, 0, 0]),
    ("c", "c", [0, 0, 0]),
    ("R", "R", [0, 0, 0]),
    ("m", "|R|^2", [0, 0, 0]),
    ("κ", r"\kappa", [0, 0, 0]),
    ("T", "T", [0, 0, 0]),
];

/// The dimension of a letter; `None` for a name that the page does not have.
pub fn dimension(name: &str) -> Option<Dimension> {
    alphabet::dimension(LETTERS, name)
}

/// The symbol of a letter; the LaTeX comes from the table.
pub fn letter(name: &str) -> Sym {
    alphabet::letter(LETTERS, name)
}

/// Several at once.
pub fn letters<const N: usize>(names: [&str; N]) -> [Sym; N] {
    names.map(letter)
}
