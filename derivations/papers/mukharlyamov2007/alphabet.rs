//! The paper's letters with their LaTeX and dimensions, and how symbols are made of them.

use crate::alphabet::{self, Letter};
use symbolic::{Dimension, Sym};

/// (name, LaTeX, exponents of kg, m, s). A `#` stands for a digit, two for a pair of them. Letters that the paper uses twice
/// have a name of their own for each meaning.
const LETTERS: &[Letter<3>] = &[
    ("t", "t", [0, 0, 1]),
    // 1: output Y in m, funds in kg
    ("Y", "Y", [0, 1, 0]),
    ("Ẏ", r"\dot Y", [0, 1, -1]),
    ("Ÿ", r"\ddot Y", [0, 1, -2]),
    ("mᶠ", "m", [1, -1, 1]),
    ("ṁᶠ", r"\dot m", [1, -1, 0]),
    ("δ", r"\delta", [0, 0, -1]),
    ("uᶠ", "u", [1, 0, -1]),
    // 2: information in m
    ("I", "I", [0, 1, 0]),
    ("İ", r"\dot I", [0, 1, -1]),
    ("Ï", r"\ddot I", [0, 1, -2]),
    ("L", "L", [0, 1, 0]),
    ("τ", r"\tau", [0, 1, -1]),
    ("G", "G", [0, -1, 2]),
    ("Mᴵ", "M", [0, 2, -2]),
    ("c", "c", [0, 0, 0]),
    ("E", "E", [0, 0, 0]),
    ("v0", "v_0", [0, 1, -1]),
    // 3 and 4: joint, point of variable mass
    ("φ", r"\varphi", [0, 0, 0]),
    ("φ̇", r"\dot\varphi", [0, 0, -1]),
    ("φ̈", r"\ddot\varphi", [0, 0, -2]),
    ("J₀", "J_0", [1, 2, 0]),
    ("ρ", r"\rho", [0, 1, 0]),
    ("ρ̇", r"\dot\rho", [0, 1, -1]),
    ("Mᴶ", "M", [1, 2, -2]),
    ("m", "m", [1, 0, 0]),
    ("ṁ", r"\dot m", [1, 0, -1]),
    ("x", "x", [0, 1, 0]),
    ("ẋ", r"\dot x", [0, 1, -1]),
    ("ẍ", r"\ddot x", [0, 1, -2]),
    ("β", r"\beta", [1, 0, -1]),
    ("k", "k", [1, 0, -2]),
    ("Rᶠ", "R", [1, 1, -2]),
    ("u", "u", [0, 1, -1]),
    ("x₀", "x_0", [0, 1, 0]),
    ("x₁", "x_1", [0, 1, 0]),
    ("x₂", "x_2", [0, 1, 0]),
    ("ω", r"\omega", [0, 0, -1]),
    ("cs", r"\cos\omega t", [0, 0, 0]),
    ("sn", r"\sin\omega t", [0, 0, 0]),
    ("P₀", "p_0", [1, 1, -1]),
    // 4: constraints arbitrary to the second order
    ("m#", "m_#", [1, 0, 0]),
    ("X#", "X_#", [1, 1, -2]),
    ("q̇#", r"\dot q_#", [0, 1, -1]),
    ("q̈#", r"\ddot q_#", [0, 1, -2]),
    ("δq#", r"\delta q_#", [0, 1, 0]),
    ("f", "f", [0, 1, 0]),
    ("ḟ", r"\dot f", [0, 1, -1]),
    ("f#", "f_{,#}", [0, 0, 0]),
    ("f##", "f_{,##}", [0, -1, 0]),
    ("f#t", "f_{,#t}", [0, 0, -1]),
    ("ft", "f_{,t}", [0, 1, -1]),
    ("ftt", "f_{,tt}", [0, 1, -2]),
    ("ϕ", r"\varphi", [0, 1, -1]),
    ("ϕ#", r"\varphi_{,\dot#}", [0, 0, 0]),
    ("ϕ##", r"\varphi_{,\dot#\dot#}", [0, -1, 1]),
    ("ϕx#", r"\varphi_{,#}", [0, 0, -1]),
    ("ϕt", r"\varphi_{,t}", [0, 1, -2]),
    ("λ", r"\lambda", [1, 1, -2]),
    ("R#", "R_#", [1, 1, -2]),
    ("E#", "E_#", [1, 1, -2]),
    ("Ey", "E_y", [1, 1, -2]),
    ("Y#", "Y_#", [0, 1, -2]),
    ("y₀", "y_0", [0, 1, 0]),
    ("ẏ₀", r"\dot y_0", [0, 1, -1]),
    ("b", "b", [0, 1, 0]),
    ("h", "h", [0, 0, 1]),
    // 5: redundant variables with energies
    ("q#", "q_#", [0, 1, 0]),
    ("m##", "m_{##}", [1, -1, 0]),
    ("y", "y", [0, 1, 0]),
    ("ẏ", r"\dot y", [0, 1, -1]),
    ("ÿ", r"\ddot y", [0, 1, -2]),
    ("a", "a", [1, 0, 0]),
    ("a#", "a_{,#}", [1, -1, 0]),
    ("k#", "k_{,#}", [1, -1, -2]),
    ("d", "d", [1, 0, -1]),
    ("c₀", "c", [1, 0, -1]),
    ("c#", r"c_{,\dot#}", [1, -1, 0]),
    ("P#", "P_{,#}", [1, 1, -2]),
    ("Q#", "Q_#", [1, 1, -2]),
    ("Dy", r"D_{,y}", [1, 1, -3]),
    ("Dyy", r"D_{,yy}", [1, 0, -3]),
    ("Dyẏ", r"D_{,y\dot y}", [1, 0, -2]),
    ("Fy", r"F_y", [1, 1, -2]),
    ("W", "W", [0, 2, -2]),
    ("s", "s", [1, 0, -1]),
    // several violations: symmetric matrices, and the triangles and diagonals of which they are made
    ("y#", "y_#", [0, 1, 0]),
    ("ẏ#", r"\dot y_#", [0, 1, -1]),
    ("ÿ#", r"\ddot y_#", [0, 1, -2]),
    ("aʸ##", "a_{##}", [1, 0, 0]),
    ("cʸ##", "c_{##}", [1, 0, -1]),
    ("kʸ##", "k_{##}", [1, 0, -2]),
    ("ε", r"\varepsilon", [0, 0, -1]),
    ("g##", "g_{##}", [0, 0, 0]),
    ("n##", "m_{##}", [0, 0, 0]),
    ("d#", "d_#", [1, 0, -1]),
    ("α#", r"\alpha_#", [1, 0, 0]),
    // 6
    ("q⁶", "q^6", [0, 0, 0]),
    ("q⁷", "q^7", [0, 1, 0]),
    ("rᶜ", "r", [0, 1, 0]),
    ("l", "l", [0, 1, 0]),
    // 7
    ("A", "A", [1, 2, 0]),
    ("C", "C", [1, 2, 0]),
    ("Ȧ", r"\dot A", [1, 2, -1]),
    ("Ċ", r"\dot C", [1, 2, -1]),
    ("M", "M", [1, 0, 0]),
    ("Ṁ", r"\dot M", [1, 0, -1]),
    ("zc", "z_c", [0, 1, 0]),
    ("żc", r"\dot z_c", [0, 1, -1]),
    ("ν", r"\nu", [1, 2, -1]),
    ("g", "g", [0, 1, -2]),
    ("R", "R", [0, 1, 0]),
    ("μ", r"\mu_1", [0, 3, -2]),
    ("p", "p", [0, 0, -1]),
    ("q", "q", [0, 0, -1]),
    ("r", "r", [0, 0, -1]),
    ("r₀", "r_0", [0, 0, -1]),
    ("ṗ", r"\dot p", [0, 0, -2]),
    ("q̇", r"\dot q", [0, 0, -2]),
    ("ṙ", r"\dot r", [0, 0, -2]),
    ("γ#", r"\gamma_#", [0, 0, 0]),
    ("γ̇#", r"\dot\gamma_#", [0, 0, -1]),
    ("Γ#", r"\Gamma_#", [0, 0, -1]),
    ("cᵞ#", "c_#", [0, 0, -1]),
    ("X", "X", [1, 2, -2]),
    ("Yᴹ", "Y", [1, 2, -2]),
    ("Z", "Z", [1, 2, -2]),
    ("Mx", "M_x", [1, 2, -2]),
    ("My", "M_y", [1, 2, -2]),
    ("Mz", "M_z", [1, 2, -2]),
    ("X̃", r"\tilde X", [1, 2, -2]),
    ("Ỹ", r"\tilde Y", [1, 2, -2]),
    ("Z̃", r"\tilde Z", [1, 2, -2]),
    // the particle that moves inside the body: place, velocity, acceleration, velocity of leaving
    ("ξ#", r"\xi_#", [0, 1, 0]),
    ("ξ̇#", r"\dot\xi_#", [0, 1, -1]),
    ("ξ̈#", r"\ddot\xi_#", [0, 1, -2]),
    ("w#", "w_#", [0, 1, -1]),
    ("f₁", "f_1", [1, 2, -2]),
    ("f₂", "f_2", [1, 2, -1]),
    ("f₃", "f_3", [1, 2, -1]),
    ("f₄", "f_4", [0, 0, 0]),
    ("ḟ₁", r"\dot f_1", [1, 2, -3]),
    ("ḟ₂", r"\dot f_2", [1, 2, -2]),
    ("ḟ₃", r"\dot f_3", [1, 2, -2]),
    ("C₁", "C_1", [1, 2, -2]),
    ("k₁₁", "k_{11}", [0, 0, -1]),
    ("k₁₂", "k_{12}", [0, 0, -2]),
    ("k₁₃", "k_{13}", [0, 0, -2]),
    ("k₂₁", "k_{21}", [0, 0, 0]),
    ("k₂₂", "k_{22}", [0, 0, -1]),
    ("k₂₃", "k_{23}", [0, 0, -1]),
    ("k₃₁", "k_{31}", [0, 0, 0]),
    ("k₃₂", "k_{32}", [0, 0, -1]),
    ("k₃₃", "k_{33}", [0, 0, -1]),
    ("κ₂₁", "k_{21}", [0, 0, -2]),
    ("κ₂₂", "k_{22}", [0, 0, -2]),
    ("k₄₄", "k_{44}", [0, 0, -1]),
    ("h₁", "h_1", [1, 2, -3]),
    ("h₂", "h_2", [1, 2, -2]),
    ("h₃", "h_3", [1, 2, -2]),
    ("2h̃₁", r"2\tilde h_1", [1, 2, -3]),
    ("U", "U", [1, 2, -2]),
    // perturbations of the permanent rotation: angular velocities, directions
    ("ω#", "x_#", [0, 0, -1]),
    ("ω̇#", r"\dot x_#", [0, 0, -2]),
    ("η4", "x_4", [0, 0, 0]),
    ("η5", "x_5", [0, 0, 0]),
    ("η6", "x_6", [0, 0, 0]),
    ("η̇4", r"\dot x_4", [0, 0, -1]),
    ("η̇5", r"\dot x_5", [0, 0, -1]),
    ("η̇6", r"\dot x_6", [0, 0, -1]),
    ("σ", r"\sigma", [0, 0, -1]),
    ("Δ", r"\Delta", [1, 2, -1]),
];

/// Of the drive of section 6, as it is completed here; kg, m, s, A.
const DRIVE: &[Letter<4>] = &[
    ("E₀", "E_0", [1, 2, -3, -1]),
    ("Ωᵈ", r"\Omega", [0, 0, -1, 0]),
    ("Lᵈ#", "L_#", [1, 2, -2, -2]),
    ("Mᵈ", "M", [1, 2, -2, -2]),
    ("Rᵈ#", "R_#", [1, 2, -3, -2]),
    ("Rᵈᶠ", r"R_{\mathrm f}", [1, 2, -3, -2]),
    ("Rᵈʳ", r"R_{\mathrm r}", [1, 2, -3, -2]),
    ("i₀", "i_0", [0, 0, 0, 1]),
    ("Cᵈ", "C", [-1, -2, 4, 2]),
    ("Kᵈ", "K", [1, 2, -2, -1]),
    ("b₆", "b_6", [1, 2, -1, 0]),
    ("b₇", "b_7", [1, 0, -1, 0]),
    ("Jᵈ", "J", [1, 2, 0, 0]),
    ("mᵈ", "m", [1, 0, 0, 0]),
    ("Gᵈ", "G", [1, 2, -2, 0]),
    ("qᵈ#", "q^#", [0, 0, 1, 1]),
    ("fᵈ#", "f^#", [0, 0, 0, 1]),
    ("f⁶", "f^6", [0, 0, -1, 0]),
    ("f⁷", "f^7", [0, 1, -1, 0]),
    ("ḟᵈ#", r"\dot f^#", [0, 0, -1, 1]),
    ("ḟ⁶", r"\dot f^6", [0, 0, -2, 0]),
    ("ḟ⁷", r"\dot f^7", [0, 1, -2, 0]),
    ("λᵈ", r"\lambda", [1, 0, -2, 0]),
];

pub use crate::alphabet::exact;

/// The dimension of a symbol of the paper; `None` for a name that the paper does not have.
pub fn dimension(name: &str) -> Option<Dimension> {
    alphabet::dimension(LETTERS, name).or_else(|| alphabet::dimension(DRIVE, name))
}

/// The symbol of a letter; the LaTeX comes from its table.
pub fn letter(name: &str) -> Sym {
    match alphabet::dimension(DRIVE, name) {
        Some(_) => alphabet::letter(DRIVE, name),
        None => alphabet::letter(LETTERS, name),
    }
}

/// Several letters at once.
pub fn letters<const N: usize>(names: [&str; N]) -> [Sym; N] {
    names.map(letter)
}

/// A letter with the indices 1 to N in place of its `#`.
pub fn indexed<const N: usize>(pattern: &str) -> [Sym; N] {
    std::array::from_fn(|i| letter(&pattern.replacen('#', &(i + 1).to_string(), 1)))
}

/// An integer.
pub fn int(n: i64) -> Sym {
    use field::Scalar;
    Sym::int(n)
}

/// sum of a_i b_i
pub fn dot<const N: usize>(a: [Sym; N], b: [Sym; N]) -> Sym {
    (0..N).fold(Sym::ZERO, |sum, i| sum + a[i] * b[i])
}
