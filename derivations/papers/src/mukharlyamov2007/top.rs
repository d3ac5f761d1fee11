//! The body of section 7 in the paper's symbols.

use super::alphabet::{dot, indexed, int, letter, letters};
use field::{Scalar, Tangent};
use nalgebra::Vector3;
use symbolic::{Hypotheses, Sym};
use systems::variable_top::{Attitude, Top};

/// The body with the rates of its parameters, at a general attitude.
#[derive(Clone, Debug)]
pub struct TopLetters {
    pub top: Top<Tangent<Sym>>,
    pub at: Attitude<Sym>,
    /// The axial angular velocity r_0.
    pub aim: Sym,
    /// The coefficient 3 g/R of the Newtonian field.
    pub tide: Sym,
    /// The hypothesis that gamma is a unit vector.
    pub unit: Hypotheses,
}

impl Default for TopLetters {
    fn default() -> Self {
        let [a, da, c, dc, m, dm, z, dz, nu, g, radius] =
            letters(["A", "Ȧ", "C", "Ċ", "M", "Ṁ", "zc", "żc", "ν", "g", "R"]);
        let tide = int(3) * g / radius;
        let top = Top {
            equatorial: Tangent::moving(a, da),
            axial: Tangent::moving(c, dc),
            static_moment: Tangent::moving(m, dm) * Tangent::moving(z, dz),
            gyroscope: Tangent::fixed(nu),
            gravity: Tangent::fixed(g),
            tide: Tangent::fixed(tide),
        };
        let gamma = indexed("γ#");
        let at = Attitude { spin: letters(["p", "q", "r"]).into(), vertical: gamma.into() };
        TopLetters { top, at, aim: letter("r₀"), tide, unit: Hypotheses::none().unit_vector(gamma) }
    }
}

impl TopLetters {
    /// The body at the instant, without rates of its parameters.
    pub fn now(&self) -> Top<Sym> {
        self.top.map(|x| x.value)
    }

    /// The body with constant parameters.
    pub fn constant(&self) -> Top<Tangent<Sym>> {
        self.top.map(|x| Tangent::fixed(x.value))
    }

    /// The expression p gamma_2 - q gamma_1.
    pub fn delta(&self) -> Sym {
        self.at.spin.x * self.at.vertical.y - self.at.spin.y * self.at.vertical.x
    }

    /// The static moment and its rate.
    pub fn static_moment(&self) -> [Sym; 2] {
        [self.top.static_moment.value, self.top.static_moment.slope]
    }

    /// f_1, f_2, f_3 as printed, as functions of the state.
    pub fn printed_integrals(&self) -> [Sym; 3] {
        let [a, c, m, z, nu, g] = letters(["A", "C", "M", "zc", "ν", "g"]);
        let ([p, q, r], [g1, g2, g3]): ([Sym; 3], [Sym; 3]) = (self.at.spin.into(), self.at.vertical.into());
        [
            a * (p * p + q * q) + c * r * r + int(2) * m * g * z * g3 - self.tide * (a - c) * g3 * g3,
            a * (p * g1 + q * g2) + c * r * g3 + nu * g3,
            c * (r - self.aim),
        ]
    }
}

/// The combination sum of k_ij f_j with the symbols k_ij of row i.
pub fn combination(row: [&str; 3]) -> Sym {
    dot(letters(row), letters(["f₁", "f₂", "f₃"]))
}

/// Three symbols as a vector.
pub fn vector(names: [&str; 3]) -> Vector3<Sym> {
    letters(names).into()
}

/// The right-hand sides of (21), with the sign of (16) in the second one, in the paper's symbols with constant
/// parameters.
pub fn field(s: &TopLetters) -> [Sym; 6] {
    let (now, at) = (s.now(), &s.at);
    let spin = now.acceleration(at.spin, now.moment_of_field(at.vertical));
    let vertical = systems::variable_top::poisson(at);
    [spin.x, spin.y, spin.z, vertical.x, vertical.y, vertical.z]
}

/// x / 2.
pub fn half(x: Sym) -> Sym {
    x.half()
}

/// An expression at the perturbed permanent rotation: p = x1, q = x2, r = r0 + x3, gamma = (x4, x5, 1 + x6).
pub fn perturbed(e: Sym) -> Sym {
    let [p, q, r, r0, g1, g2, g3] = letters(["p", "q", "r", "r₀", "γ1", "γ2", "γ3"]);
    let [x1, x2, x3, x4, x5, x6] = perturbations();
    e.substitute(&[(p, x1), (q, x2), (r, r0 + x3), (g1, x4), (g2, x5), (g3, int(1) + x6)])
}

/// The perturbations x1 to x6.
pub fn perturbations() -> [Sym; 6] {
    letters(["ω1", "ω2", "ω3", "η4", "η5", "η6"])
}

/// An expression at x = 0.
pub fn unperturbed(e: Sym) -> Sym {
    e.substitute(&perturbations().map(|x| (x, Sym::ZERO)))
}

/// The rate of a function of A, C, M, z_c.
pub fn varying(e: Sym) -> Sym {
    [("A", "Ȧ"), ("C", "Ċ"), ("M", "Ṁ"), ("zc", "żc")]
        .into_iter()
        .fold(Sym::ZERO, |sum, (value, rate)| sum + e.diff(letter(value)) * letter(rate))
}
