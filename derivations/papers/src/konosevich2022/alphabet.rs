//! The symbols of the paper with their LaTeX and dimensions.

use claims::alphabet::{self, Letter, read_by};
use field::{Rational, Scalar};
use nalgebra::{Matrix3, Vector3};
use num_traits::One;
use symbolic::{Dimension, Sym};

/// The symbols: name, LaTeX, exponents of kg, m, s, A. A `#` at the end of a name stands for the indices 1, 2, 3, two
/// for a pair of indices.
const LETTERS: &[Letter<4>] = &[
    ("ω#", r"\omega_#", [0, 0, -1, 0]),
    ("ω̇#", r"\dot\omega_#", [0, 0, -2, 0]),
    ("ν#", r"\nu_#", [0, 0, 0, 0]),
    ("ν̇#", r"\dot\nu_#", [0, 0, -1, 0]),
    ("l#", "l_#", [0, 0, 0, 0]),
    ("e#", "e_#", [0, 0, 0, 0]),
    ("h#", "h_#", [0, 1, 0, 0]),
    ("c⁰#", "c^0_#", [0, 1, 0, 0]),
    ("A#", "A_#", [1, 2, 0, 0]),
    ("A⋆#", "A^*_#", [1, 2, 0, 0]),
    ("x#", "x_#", [1, 2, -1, 0]),
    ("A⁰##", "A^0_{##}", [1, 2, 0, 0]),
    ("A⋆##", "A^*_{##}", [1, 2, 0, 0]),
    ("A##", "A_{##}", [1, 2, 0, 0]),
    ("m⁰", "m^0", [1, 0, 0, 0]),
    ("m′", "m'", [1, 0, 0, 0]),
    ("A′", "A'", [1, 2, 0, 0]),
    ("B′", "B'", [1, 2, 0, 0]),
    ("g", "g", [0, 1, -2, 0]),
    ("Γ", r"\Gamma", [1, 2, -2, 0]),
    ("φ̇′", r"\dot\varphi'", [0, 0, -1, 0]),
    ("φ̈′", r"\ddot\varphi'", [0, 0, -2, 0]),
    ("p′", "p'", [0, 0, -1, 0]),
    ("ṗ′", r"\dot p'", [0, 0, -2, 0]),
    ("M", "M", [1, 2, -2, 0]),
    ("M2", "M_2", [1, 2, -2, 0]),
    ("γ", r"\gamma", [0, 0, 0, 0]),
    ("γ̇", r"\dot\gamma", [0, 0, -1, 0]),
    ("γ̈", r"\ddot\gamma", [0, 0, -2, 0]),
    ("Ω", r"\Omega", [0, 0, -1, 0]),
    ("Ω′", r"\Omega'", [0, 0, -1, 0]),
    ("Ω⁰", r"\Omega^0", [0, 0, -1, 0]),
    ("ω⁰", r"\omega^0", [0, 0, -1, 0]),
    ("b0", "b_0", [1, 2, -2, 0]),
    ("c0", "c_0", [1, 2, -2, 0]),
    ("μ", r"\mu", [1, 2, -1, 0]),
    ("k", "k", [1, 2, -1, 0]),
    ("f", "f", [1, 2, -1, 0]),
    ("κ", r"\kappa", [1, 2, -1, 0]),
    ("Mk", "M_k", [1, 2, -2, 0]),
    ("sk", "s_k", [0, 0, 0, 0]),
    ("a1", "a_1", [1, 2, -2, -1]),
    ("a2", "a_2", [1, 2, -2, -1]),
    ("L1", "L_1", [1, 2, -2, -2]),
    ("L2", "L_2", [1, 2, -2, -2]),
    ("R1", "R_1", [1, 2, -3, -2]),
    ("R2", "R_2", [1, 2, -3, -2]),
    ("V", "V", [1, 2, -3, -1]),
    ("x", "x", [0, 0, 0, 1]),
    ("ẋ", r"\dot x", [0, 0, -1, 1]),
    ("D", "D", [0, 0, 0, 0]),
    ("det Ã", r"\det\tilde A", [3, 6, 0, 0]),
    ("V⋆", "V^*", [1, 2, 0, 0]),
    ("S⋆", "S^*", [1, 2, 0, 0]),
    ("Δ⋆", r"\Delta^*", [2, 4, 0, 0]),
    ("Π⋆", r"\Pi^*", [0, 0, 0, 0]),
    ("l⁰", "l^0", [0, 0, 0, 0]),
    // additional symbols: Euler angles, a quaternion, a direction, a scale, sines and cosines by name
    ("ψ", r"\psi", [0, 0, 0, 0]),
    ("θ", r"\theta", [0, 0, 0, 0]),
    ("φ", r"\varphi", [0, 0, 0, 0]),
    ("ψ̇", r"\dot\psi", [0, 0, -1, 0]),
    ("θ̇", r"\dot\theta", [0, 0, -1, 0]),
    ("φ̇", r"\dot\varphi", [0, 0, -1, 0]),
    ("φ′", r"\varphi'", [0, 0, 0, 0]),
    ("ψ̈", r"\ddot\psi", [0, 0, -2, 0]),
    ("θ̈", r"\ddot\theta", [0, 0, -2, 0]),
    ("φ̈", r"\ddot\varphi", [0, 0, -2, 0]),
    ("q0", "q_0", [0, 0, 0, 0]),
    ("q#", "q_#", [0, 0, 0, 0]),
    ("u#", "u_#", [0, 0, 0, 0]),
    ("t", "t", [0, 0, 0, 0]),
    ("r", "r", [0, 0, 0, 0]),
    ("C", "C", [0, 0, 0, 0]),
    ("c", "c", [0, 0, 0, 0]),
    ("s", "s", [0, 0, 0, 0]),
    ("ch", r"\cos h", [0, 0, 0, 0]),
    ("sh", r"\sin h", [0, 0, 0, 0]),
    ("cn", r"\cos 2nh", [0, 0, 0, 0]),
    ("sn", r"\sin 2nh", [0, 0, 0, 0]),
    ("ct", r"\cos t", [0, 0, 0, 0]),
    ("st", r"\sin t", [0, 0, 0, 0]),
    // additional symbols: a multiplier and its coefficients, moments of inertia
    ("λ", r"\lambda", [1, 2, -2, 0]),
    ("α#", r"\alpha_#", [1, 2, -2, 0]),
    ("δ#", r"\delta_#", [1, 2, -2, 0]),
    ("a", "a", [1, 2, 0, 0]),
    ("d#", "d_#", [1, 2, 0, 0]),
];

read_by!(letter, vector; [LETTERS]);

/// The dimension of a symbol of the paper; `None` for an unknown name.
pub fn dimension(name: &str) -> Option<Dimension> {
    let place = |[kg, m, s, a]: [i64; 4]| Dimension::of(kg, m, s, a);
    for (stem, exponents) in [("i̇", [0, 0, -1, 1]), ("i", [0, 0, 0, 1]), ("t", [0, 0, 0, 0])] {
        if name.strip_prefix(stem).is_some_and(|n| !n.is_empty() && n.chars().all(|c| c.is_ascii_digit())) {
            return Some(place(exponents));
        }
    }
    if name.starts_with("C") && name.len() == 3 {
        // the square root of a moment of inertia
        return dimension("A′").map(|inertia| inertia.power(Rational::new(1, 2)));
    }
    alphabet::dimension(LETTERS, name)
}

/// A symmetric tensor with components 11, 22, 33, 12, 23, 31.
pub fn tensor(stem: &str) -> Matrix3<Sym> {
    let [a11, a22, a33, a12, a23, a31] = ["11", "22", "33", "12", "23", "31"].map(|ij| letter(&format!("{stem}{ij}")));
    Matrix3::new(a11, a12, a31, a12, a22, a23, a31, a23, a33)
}

/// The current of a bar.
pub fn current(bar: u32) -> Sym {
    Sym::named(&format!("i{bar}"), &format!("i_{{{bar}}}"))
}

/// The vector whose components are a formula for (1 2 3) and its cyclic permutations.
pub fn cyclic(formula: impl Fn(usize, usize, usize) -> Sym) -> Vector3<Sym> {
    Vector3::new(formula(0, 1, 2), formula(1, 2, 0), formula(2, 0, 1))
}

/// A rational constant.
pub fn number(numerator: i64, denominator: i64) -> Sym {
    Sym::ratio(numerator, denominator)
}

/// One as a symbol's value.
pub fn one() -> Sym {
    Sym::one()
}
