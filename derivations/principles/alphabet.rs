//! The letters of this page with their LaTeX and dimensions.

use crate::alphabet::{self, Letter};
use symbolic::{Dimension, Sym};

/// (name, LaTeX, exponents of kg, m, s). A `#` at the end of a name stands for a digit, two for a pair of them.
const LETTERS: &[Letter<3>] = &[
    ("t", "t", [0, 0, 1]),
    // data of the systems
    ("m", "m", [1, 0, 0]),
    ("m#", "m_#", [1, 0, 0]),
    ("J", "J", [1, 2, 0]),
    ("P", "P", [1, 2, 0]),
    ("I#", "I_#", [1, 2, 0]),
    ("M#", "M_#", [1, 2, -2]),
    ("l", "l", [0, 1, 0]),
    ("a", "a", [0, 1, 0]),
    ("d", "d", [0, 1, 0]),
    ("g", "g", [0, 1, -2]),
    ("u", "u", [0, 1, -1]),
    ("b", "b", [0, 1, -2]),
    ("X", "X", [1, 1, -2]),
    ("f", "f", [0, 0, 0]),
    // coordinates, velocities, accelerations
    ("x", "x", [0, 1, 0]),
    ("y", "y", [0, 1, 0]),
    ("r", "r", [0, 1, 0]),
    ("θ", r"\theta", [0, 0, 0]),
    ("α", r"\alpha", [0, 0, 0]),
    ("ψ", r"\psi", [0, 0, 0]),
    ("φ", r"\varphi", [0, 0, 0]),
    ("χ", r"\chi", [0, 0, 0]),
    ("ẋ", r"\dot x", [0, 1, -1]),
    ("ẏ", r"\dot y", [0, 1, -1]),
    ("ṙ", r"\dot r", [0, 1, -1]),
    ("v", "v", [0, 1, -1]),
    ("θ̇", r"\dot\theta", [0, 0, -1]),
    ("α̇", r"\dot\alpha", [0, 0, -1]),
    ("ψ̇", r"\dot\psi", [0, 0, -1]),
    ("φ̇", r"\dot\varphi", [0, 0, -1]),
    ("χ̇", r"\dot\chi", [0, 0, -1]),
    ("ẍ", r"\ddot x", [0, 1, -2]),
    ("r̈", r"\ddot r", [0, 1, -2]),
    ("v̇", r"\dot v", [0, 1, -2]),
    ("θ̈", r"\ddot\theta", [0, 0, -2]),
    ("ψ̈", r"\ddot\psi", [0, 0, -2]),
    ("φ̈", r"\ddot\varphi", [0, 0, -2]),
    // friction as the extended method writes it: multiples of m dx'/dp
    ("μx", r"\mu_x", [0, 1, -2]),
    ("μθ", r"\mu_\theta", [0, 0, -2]),
    ("μψ", r"\mu_\psi", [0, 0, -2]),
    ("μφ", r"\mu_\varphi", [0, 0, -2]),
    ("μχ", r"\mu_\chi", [0, 0, -1]),
    ("F", "F", [1, 1, -2]),
    // a system of any kind: rows of J without dimension, forces, accelerations
    ("J##", "J_{##}", [0, 0, 0]),
    ("R#", "R_#", [1, 1, -2]),
    ("lost#", r"\mathrm{lost}_#", [1, 1, -2]),
    ("slope", r"\partial Z/\partial\ddot\theta", [1, 2, -2]),
    ("slip", r"\mathrm{slip}", [0, 1, -1]),
    ("λ#", r"\lambda_#", [1, 1, -2]),
    ("X#", "X_#", [1, 1, -2]),
    ("w#", "w_#", [0, 1, -2]),
    ("δ#", r"\delta_#", [0, 1, -2]),
    ("β#", r"\beta_#", [0, 1, -2]),
    ("κ#", r"\kappa_#", [0, 0, -2]),
    // places off the constraints, laws of violations: Y1# of a length, Y2# of its square, Y0# of a number
    ("x#", "x_#", [0, 1, 0]),
    ("ẋ#", r"\dot x_#", [0, 1, -1]),
    ("ẍ#", r"\ddot x_#", [0, 1, -2]),
    ("c", "c", [0, 0, 0]),
    ("s", "s", [0, 0, 0]),
    ("ċ", r"\dot c", [0, 0, -1]),
    ("ṡ", r"\dot s", [0, 0, -1]),
    ("c̈", r"\ddot c", [0, 0, -2]),
    ("s̈", r"\ddot s", [0, 0, -2]),
    ("e#", "e_#", [0, 0, 0]),
    ("ė#", r"\dot e_#", [0, 0, -1]),
    ("ë#", r"\ddot e_#", [0, 0, -2]),
    ("n#", "n_#", [0, 0, 0]),
    ("ṅ#", r"\dot n_#", [0, 0, -1]),
    ("n̈#", r"\ddot n_#", [0, 0, -2]),
    ("Y0#", "Y_#", [0, 0, -2]),
    ("Y1#", "Y_#", [0, 1, -2]),
    ("Y2#", "Y_#", [0, 2, -2]),
    ("κ", r"\kappa", [0, 0, -1]),
    ("ω", r"\omega", [0, 0, -1]),
    ("a#", "a_#", [1, 0, 0]),
    ("γ#", r"\gamma_#", [1, 0, -1]),
    ("k#", "k_#", [1, 0, -2]),
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
