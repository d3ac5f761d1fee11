//! The symbols of the page with their LaTeX and dimensions.

use claims::alphabet::{Letter, read_by};

/// Each entry is (name, LaTeX, exponents of kg, m, s).
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

read_by!(dimension, letter, letters; [LETTERS]);
