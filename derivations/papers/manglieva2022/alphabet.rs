//! The paper's letters with their LaTeX and dimensions, and how symbols are made of them.

use super::alphabet3;
use crate::alphabet::{self, Letter};
use field::Scalar;
use symbolic::{Dimension, Hypotheses, Sym, normal};

/// (name, LaTeX, exponents of kg, m, s). A `#` stands for an index 1 to 4, two for a pair of them.
const LETTERS: &[Letter<3>] = &[
    // points, places, speeds
    ("m", "m", [1, 0, 0]),
    ("m#", "m_#", [1, 0, 0]),
    ("l", "l", [0, 1, 0]),
    ("g", "g", [0, 1, -2]),
    ("f", "f", [0, 0, 0]),
    ("x", "x", [0, 1, 0]),
    ("x#", "x_#", [0, 1, 0]),
    ("y", "y", [0, 1, 0]),
    ("y#", "y_#", [0, 1, 0]),
    ("ẋ", r"\dot x", [0, 1, -1]),
    ("ẋ#", r"\dot x_#", [0, 1, -1]),
    ("ẏ", r"\dot y", [0, 1, -1]),
    ("ẏ#", r"\dot y_#", [0, 1, -1]),
    ("ẍ", r"\ddot x", [0, 1, -2]),
    ("ẍ#", r"\ddot x_#", [0, 1, -2]),
    ("ÿ", r"\ddot y", [0, 1, -2]),
    ("ÿ#", r"\ddot y_#", [0, 1, -2]),
    ("θ", r"\theta", [0, 0, 0]),
    ("θ̇", r"\dot\theta", [0, 0, -1]),
    ("θ̈", r"\ddot\theta", [0, 0, -2]),
    ("φ", r"\varphi", [0, 0, 0]),
    ("φ̇", r"\dot\varphi", [0, 0, -1]),
    ("φ̈", r"\ddot\varphi", [0, 0, -2]),
    ("T", "T", [1, 2, -2]),
    ("t", "t", [0, 0, 1]),
    // reactions of the rod
    ("λ", r"\lambda", [1, 1, -2]),
    ("λ#", r"\lambda_#", [1, 1, -2]),
    ("μ", r"\mu", [0, 1, -2]),
    ("μᴾ", r"\mu", [1, 1, -2]),
    ("Y", "Y", [1, 1, -2]),
    ("X", "X", [1, 1, -2]),
    ("Rx", "R_x", [1, 1, -2]),
    ("Ry", "R_y", [1, 1, -2]),
    ("R#", "R_#", [1, 1, -2]),
    ("R′x", "R'_x", [1, 1, -2]),
    ("R′y", "R'_y", [1, 1, -2]),
    ("R′#x", "R'_{#x}", [1, 1, -2]),
    ("R′#y", "R'_{#y}", [1, 1, -2]),
    ("ρ", r"\rho", [1, 1, -2]),
    ("ρ#", r"\rho_#", [1, 1, -2]),
    ("ρ##", r"\rho_{##}", [1, 1, -2]),
    ("ρx", r"\rho_x", [1, 1, -2]),
    ("ρy", r"\rho_y", [1, 1, -2]),
    ("ρ#x", r"\rho_{#x}", [1, 1, -2]),
    ("ρ#y", r"\rho_{#y}", [1, 1, -2]),
    ("ε", r"\varepsilon", [0, 0, 0]),
    ("N", "N", [1, 1, -2]),
    ("v", "v", [0, 1, -1]),
    ("q", "q", [0, 0, 0]),
    // work and generalised forces
    ("δx", r"\delta x", [0, 1, 0]),
    ("δx#", r"\delta x_#", [0, 1, 0]),
    ("δy#", r"\delta y_#", [0, 1, 0]),
    ("δy", r"\delta y", [0, 1, 0]),
    ("δθ", r"\delta\theta", [0, 0, 0]),
    ("δα", r"\delta\alpha", [0, 0, 0]),
    ("δA", r"\delta A", [1, 2, -2]),
    ("δAτ", r"\delta A^\tau", [1, 2, -2]),
    ("Qx", "Q_x", [1, 1, -2]),
    ("Qy", "Q_y", [1, 1, -2]),
    ("Qθ", r"Q_\theta", [1, 2, -2]),
    ("Qτx", r"Q^\tau_x", [1, 1, -2]),
    ("Qτθ", r"Q^\tau_\theta", [1, 2, -2]),
    ("Qτ", r"Q^\tau", [1, 2, -2]),
    ("Q", "Q", [1, 2, -2]),
    ("∂T/∂ẋ", r"\frac{\partial T}{\partial\dot x}", [1, 1, -1]),
    ("∂T/∂x", r"\frac{\partial T}{\partial x}", [1, 1, -2]),
    ("∂T/∂θ̇", r"\frac{\partial T}{\partial\dot\theta}", [1, 2, -1]),
    ("∂T/∂θ", r"\frac{\partial T}{\partial\theta}", [1, 2, -2]),
    ("d(tg θ/2)/dt", r"\frac{d}{dt}\operatorname{tg}\frac\theta2", [0, 0, -1]),
    // the ladder
    ("J", "J", [1, 2, 0]),
    ("α", r"\alpha", [0, 0, 0]),
    ("cos", r"\cos\alpha", [0, 0, 0]),
    ("sin", r"\sin\alpha", [0, 0, 0]),
    ("α₀", r"\alpha_0", [0, 0, 0]),
    ("α̇", r"\dot\alpha", [0, 0, -1]),
    ("α̇₀", r"\dot\alpha_0", [0, 0, -1]),
    ("α̈", r"\ddot\alpha", [0, 0, -2]),
    ("fA", "f_A", [0, 0, 0]),
    ("fB", "f_B", [0, 0, 0]),
    ("RAn", "R_A^n", [1, 1, -2]),
    ("RBn", "R_B^n", [1, 1, -2]),
    ("RAτ", r"R_A^\tau", [1, 1, -2]),
    ("RBτ", r"R_B^\tau", [1, 1, -2]),
    ("a", "a", [0, 0, 0]),
    ("b", "b", [0, 0, 0]),
    ("G", "G", [0, 0, 0]),
    ("E", r"e^{b\alpha}", [0, 0, 0]),
    ("E₀", r"e^{b\alpha_0}", [0, 0, 0]),
    ("C̃", r"\tilde C", [0, 0, -2]),
    ("C₁", "C_1", [0, 0, -1]),
    ("C₁′", "C_1'", [0, 0, -1]),
    ("dα̇/dα", r"\frac{d\dot\alpha}{d\alpha}", [0, 0, -1]),
    ("d(α̇²)/dα", r"\frac{d\dot\alpha^2}{d\alpha}", [0, 0, -2]),
    ("xG", "x_G", [0, 1, 0]),
    ("yG", "y_G", [0, 1, 0]),
    ("ẍG", r"\ddot x_G", [0, 1, -2]),
    ("ÿG", r"\ddot y_G", [0, 1, -2]),
    // the general theory: coordinates of the points by number, constraints by their derivatives at the place considered
    ("X#", "X_#", [1, 1, -2]),
    ("μ#", r"\mu_#", [0, 1, -2]),
    ("u", "u", [1, 1, -2]),
    ("f#", "f_{,#}", [0, 0, 0]),
    ("f##", "f_{,##}", [0, -1, 0]),
    ("f#t", "f_{,#t}", [0, 0, -1]),
    ("ft", "f_{,t}", [0, 1, -1]),
    ("ftt", "f_{,tt}", [0, 1, -2]),
    ("F#", "F_{,#}", [0, 0, 0]),
    ("F##", "F_{,##}", [0, -1, 0]),
    ("F#t", "F_{,#t}", [0, 0, -1]),
    ("Ft", "F_{,t}", [0, 1, -1]),
    ("Ftt", "F_{,tt}", [0, 1, -2]),
    ("φ#", r"\varphi_{,\dot#}", [0, 0, 0]),
    ("φx#", r"\varphi_{,#}", [0, 0, -1]),
    ("Φ", r"\Phi", [0, 1, -1]),
    ("Φ#", r"\Phi_{,\dot#}", [0, 0, 0]),
    ("Φ##", r"\Phi_{,\dot#\dot#}", [0, -1, 1]),
    ("Φx#", r"\Phi_{,#}", [0, 0, -1]),
    ("Φt", r"\Phi_{,t}", [0, 1, -2]),
    ("Δμ#", r"\Delta\mu_#", [0, 1, -2]),
    (
        "Σ ∂φ/∂x μ ∂ẋ/∂p",
        r"\sum\frac{\partial\varphi}{\partial x_\gamma}\mu_j\frac{\partial\dot x_\gamma}{\partial p_j}",
        [0, 1, -3],
    ),
    ("δq#", r"\delta q_#", [0, 1, 0]),
    ("Q#", "Q_#", [1, 1, -2]),
    ("p#", "p_#", [0, 1, -1]),
    ("ṗ#", r"\dot p_#", [0, 1, -2]),
    ("q̈#", r"\ddot q_#", [0, 1, -2]),
    ("Af", "A", [0, 1, -2]),
    ("Bφ", "B", [0, 1, -2]),
    ("ẍ′#", r"\ddot x'_#", [0, 1, -2]),
    ("δẍ#", r"\delta\ddot x_#", [0, 1, -2]),
    ("a#", "a_#", [0, 1, -2]),
    ("AdD", "A_{dD}", [1, 2, -4]),
    ("AμD", r"A_{\mu D}", [1, 2, -4]),
    ("Adμ", r"A_{d\mu}", [1, 2, -4]),
];

pub use crate::alphabet::exact;

/// Every letter, those of chapter 3 last.
fn all() -> impl Iterator<Item = &'static Letter<3>> {
    LETTERS.iter().chain(alphabet3::LETTERS)
}

/// The dimension of a symbol of the paper; `None` for a name that the paper does not have.
pub fn dimension(name: &str) -> Option<Dimension> {
    alphabet::dimension(all(), name)
}

/// The symbol of a letter; the LaTeX comes from the table.
pub fn letter(name: &str) -> Sym {
    alphabet::letter(all(), name)
}

/// Several letters at once.
pub fn letters<const N: usize>(names: [&str; N]) -> [Sym; N] {
    names.map(letter)
}

/// A letter with the indices 1 to N in place of its `#`.
pub fn indexed<const N: usize>(pattern: &str) -> [Sym; N] {
    std::array::from_fn(|i| letter(&pattern.replacen('#', &(i + 1).to_string(), 1)))
}

/// The expression in its normal form, for reading and for exact values; itself where that is too large.
pub fn tidy(expression: Sym) -> Sym {
    normal(expression, &Hypotheses::none()).map_or(expression, |form| form.to_sym())
}

/// An integer.
pub fn int(n: i64) -> Sym {
    Sym::int(n)
}
