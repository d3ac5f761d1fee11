//! The symbols of the page: those of the paper, the deviations, the unknown of the polynomials, and their coefficients.

use claims::alphabet::{self, Letter, read_by};
use papers::konosevich2022;
use symbolic::Dimension;

/// Each entry is (name, LaTeX, exponents of kg, m, s, A).
const LETTERS: &[Letter<4>] = &[
    ("z", "z", [0, 0, -1, 0]),
    ("δν#", r"\delta\nu_#", [0, 0, 0, 0]),
    ("η#", r"\eta_#", [0, 0, -1, 0]),
    ("δγ", r"\delta\gamma", [0, 0, 0, 0]),
    ("δγ̇", r"\delta\dot\gamma", [0, 0, -1, 0]),
    ("δν̇#", r"\delta\dot\nu_#", [0, 0, -1, 0]),
    ("η̇#", r"\dot\eta_#", [0, 0, -2, 0]),
    ("δγ̈", r"\delta\ddot\gamma", [0, 0, -2, 0]),
    ("ac", "a_c", [0, 0, -2, 0]),
    ("bc", "b_c", [0, 0, -4, 0]),
    ("af", "a_f", [0, 0, -2, 0]),
    ("bf", "b_f", [0, 0, -4, 0]),
    ("pc", "p_c", [0, 0, -4, 0]),
    ("pf", "p_f", [0, 0, -4, 0]),
    ("σ", "s", [0, 0, -2, 0]),
    ("X", r"\operatorname{Re}Z", [1, 2, -2, 0]),
    ("Y", r"\operatorname{Im}Z", [1, 2, -2, 0]),
    ("y", "y", [0, 0, -1, 0]),
    ("ψ", r"\psi_1'", [1, 2, -2, -1]),
    ("J", "A'D", [1, 2, 0, 0]),
    ("K", "K", [1, 2, -2, 0]),
    ("d", "d", [1, 2, -1, 0]),
    ("Z", "Z", [1, 2, -2, 0]),
    ("k##", "K_{##}", [1, 2, -2, 0]),
    ("v#", "v_#", [0, 0, -1, 0]),
    ("w#", "w_#", [0, 0, -1, 0]),
    ("H", "h", [1, 2, -1, 0]),
    ("λ", r"\lambda", [1, 2, -2, 0]),
];

read_by!(letter, vector; [LETTERS]);

/// The dimension of a symbol; `None` if the page has no symbol of this name.
pub fn dimension(name: &str) -> Option<Dimension> {
    if let Some(root) = name.strip_prefix('√') {
        return konosevich2022::dimension(root).map(|square| square.power(field::Rational::new(1, 2)));
    }
    alphabet::dimension(LETTERS, name).or_else(|| konosevich2022::dimension(name))
}
