//! The symbols of the page with their LaTeX and dimensions.

use claims::alphabet::{Letter, read_by};
use field::Circle;
use symbolic::{Hypotheses, Sym};

/// Each entry is (name, LaTeX, exponents of kg, m, s).
const LETTERS: &[Letter<3>] = &[
    ("bn", "b_n", [0, 1, -2]),
    ("bt", "b_t", [0, 1, -2]),
    ("Wnn", "W_{nn}", [-1, 0, 0]),
    ("Wnt", "W_{nt}", [-1, 0, 0]),
    ("Wtt", "W_{tt}", [-1, 0, 0]),
    ("det W", r"\det W", [-2, 0, 0]),
    ("D+", "D_+", [-1, 0, 0]),
    ("D-", "D_-", [-1, 0, 0]),
    ("N", "N", [1, 1, -2]),
    ("f", "f", [0, 0, 0]),
    ("f*", "f_*", [0, 0, 0]),
    ("fA", "f_A", [0, 0, 0]),
    ("fB", "f_B", [0, 0, 0]),
    ("c", r"\cos\theta", [0, 0, 0]),
    ("s", r"\sin\theta", [0, 0, 0]),
    ("ca", r"\cos\alpha", [0, 0, 0]),
    ("sa", r"\sin\alpha", [0, 0, 0]),
    ("m", "m", [1, 0, 0]),
    ("m1", "m_1", [1, 0, 0]),
    ("m2", "m_2", [1, 0, 0]),
    ("l", "l", [0, 1, 0]),
    ("g", "g", [0, 1, -2]),
    ("x", "x", [0, 1, 0]),
    ("k", "k", [0, 0, 0]),
    ("kappa", r"\kappa", [0, 0, 0]),
    ("u", "u", [0, 0, 0]),
    ("v", "v", [0, 0, 0]),
    ("P1", "P_1", [1, 1, -2]),
    ("P2", "P_2", [1, 1, -2]),
    ("P", "P", [1, 1, -2]),
    ("fA NA + TA", "f_AN_A + T_A", [1, 1, -2]),
    ("fB NB - TB", "f_BN_B - T_B", [1, 1, -2]),
    ("fB NB + TB", "f_BN_B + T_B", [1, 1, -2]),
    ("fA NA - TA", "f_AN_A - T_A", [1, 1, -2]),
    ("anA", r"\Delta a_{An}", [0, 1, -2]),
    ("atA", r"\Delta a_{At}", [0, 1, -2]),
    ("anB", r"\Delta a_{Bn}", [0, 1, -2]),
    ("atB", r"\Delta a_{Bt}", [0, 1, -2]),
    ("nA", "n_A", [1, 1, -2]),
    ("nB", "n_B", [1, 1, -2]),
    ("eps", r"\varepsilon", [0, 0, -2]),
    ("M11", "M_{11}", [-1, 0, 0]),
    ("M22", "M_{22}", [-1, 0, 0]),
    ("det M", r"\det M", [-2, 0, 0]),
    ("N det M", r"N\det M", [-1, 1, -2]),
];

read_by!(dimension, letter; [LETTERS]);

/// An angle, given by its cosine and sine, with the relation between them.
pub fn angle(cos: &str, sin: &str) -> (Circle<Sym>, Hypotheses) {
    let point = Circle { cos: letter(cos), sin: letter(sin) };
    (point, Hypotheses::none().on_circle(point))
}
