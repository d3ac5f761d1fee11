//! The letters of the page with their LaTeX and dimensions.

use crate::alphabet::{self, Letter};
use symbolic::{Dimension, Sym};

/// (name, LaTeX, exponents of kg, m, s, A)
const LETTERS: &[Letter<4>] = &[
    // gains in steps
    ("β", r"\beta", [0, 0, 0, 0]),
    ("κ", r"\kappa", [0, 0, 0, 0]),
    ("T", "T", [0, 0, 0, 0]),
    ("D", "D", [0, 0, 0, 0]),
    ("w", "w", [0, 0, 0, 0]),
    ("s1", "1-D", [0, 0, 0, 0]),
    ("s2", "1-T+D", [0, 0, 0, 0]),
    ("s3", "1+T+D", [0, 0, 0, 0]),
    ("ρ", r"\rho", [0, 0, 0, 0]),
    // a pendulum
    ("h", "h", [0, 0, 1, 0]),
    ("b", "b", [0, 0, -1, 0]),
    ("k", "k", [0, 0, -2, 0]),
    ("m", "m", [1, 0, 0, 0]),
    ("x", "x", [0, 1, 0, 0]),
    ("y", "y", [0, 1, 0, 0]),
    ("u", "u", [0, 1, -1, 0]),
    ("v", "v", [0, 1, -1, 0]),
    ("g", "g", [0, 1, -2, 0]),
    ("l", "l", [0, 1, 0, 0]),
    // the drive
    ("t", "t", [0, 0, 1, 0]),
    ("E0", "E_0", [1, 2, -3, -1]),
    ("Ω", r"\Omega", [0, 0, -1, 0]),
    ("L1", "L_1", [1, 2, -2, -2]),
    ("L2", "L_2", [1, 2, -2, -2]),
    ("M", "M", [1, 2, -2, -2]),
    ("L4", "L_4", [1, 2, -2, -2]),
    ("L5", "L_5", [1, 2, -2, -2]),
    ("R1", "R_1", [1, 2, -3, -2]),
    ("R2", "R_2", [1, 2, -3, -2]),
    ("R4", "R_4", [1, 2, -3, -2]),
    ("R5", "R_5", [1, 2, -3, -2]),
    ("Rf", r"R_{\mathrm f}", [1, 2, -3, -2]),
    ("Rr", r"R_{\mathrm r}", [1, 2, -3, -2]),
    ("i0", "i_0", [0, 0, 0, 1]),
    ("i", "i", [0, 0, 0, 1]),
    ("C", "C", [-1, -2, 4, 2]),
    ("K", "K", [1, 2, -2, -1]),
    ("b6", "b_6", [1, 2, -1, 0]),
    ("b7", "b_7", [1, 0, -1, 0]),
    ("J", "J", [1, 2, 0, 0]),
    ("r", "r", [0, 1, 0, 0]),
    ("G", "G", [1, 2, -2, 0]),
    ("q1", "q^1", [0, 0, 1, 1]),
    ("q2", "q^2", [0, 0, 1, 1]),
    ("q3", "q^3", [0, 0, 1, 1]),
    ("q4", "q^4", [0, 0, 1, 1]),
    ("q5", "q^5", [0, 0, 1, 1]),
    ("q6", "q^6", [0, 0, 0, 0]),
    ("q7", "q^7", [0, 1, 0, 0]),
    ("f1", "f^1", [0, 0, 0, 1]),
    ("f2", "f^2", [0, 0, 0, 1]),
    ("f4", "f^4", [0, 0, 0, 1]),
    ("f5", "f^5", [0, 0, 0, 1]),
    ("f6", "f^6", [0, 0, -1, 0]),
    ("f7", "f^7", [0, 1, -1, 0]),
    ("a1", r"\dot f^1", [0, 0, -1, 1]),
    ("a2", r"\dot f^2", [0, 0, -1, 1]),
    ("a4", r"\dot f^4", [0, 0, -1, 1]),
    ("a5", r"\dot f^5", [0, 0, -1, 1]),
    ("a6", r"\dot f^6", [0, 0, -2, 0]),
    ("a7", r"\dot f^7", [0, 1, -2, 0]),
    ("λ", r"\lambda", [1, 0, -2, 0]),
    ("ui", "u(i)", [1, 2, -3, -1]),
    ("Y", "Y", [0, 2, -2, 0]),
    ("p", r"v\cdot\dot v", [0, 2, -3, 0]),
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
