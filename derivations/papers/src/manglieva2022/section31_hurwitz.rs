//! Section 3.1: Hurwitz' conditions of the elastic governor.

use super::alphabet::{exact, int, letter, letters, tidy};
use super::elastic::{AS_STIFFNESS, ElasticLetters};
use algebra::linear::determinant;
use claims::{Condition, Line, Page};
use symbolic::{Sym, coefficients};

pub fn claims(page: &mut Page, quintic: &Quintic) {
    page.section("3.1. Hurwitz' conditions of the elastic governor");
    coefficients_of_hurwitz(page, quintic);
    determinants(page, quintic);
}

/// The characteristic polynomial a0 mu^5 + ... + a5 of a resisting rim: of the matrix (3.22) with corrected entries,
/// where a and b have the signs of Z.
pub(super) struct Quintic {
    pub derived: [Sym; 6],
    pub ball: Sym,
    pub a: Sym,
    pub b: Sym,
    /// The coefficient b R/rho_0.
    pub twist: Sym,
}

impl Quintic {
    pub fn new(s: &ElasticLetters) -> Self {
        let [theta, m0, v, alpha, beta, mu] = letters(["θ₀", "m₀", "V", "α₁", "β₁", "μᵉ"]);
        let [phi1, phi2, phi3, phi4] = letters(["Φ₁", "Φ₂", "Φ₃", "Φ₄"]);
        let (twist, zero) = (s.b * s.drum / letter("ϱ₀"), Sym::ZERO);
        let matrix = [
            [theta * mu, phi1 * mu + phi2, zero, -twist],
            [phi3, m0 * mu.powi(2) + phi4, s.a, zero],
            [zero, mu, -mu, -v],
            [zero, zero, -alpha, mu + beta],
        ];
        Quintic { derived: by_powers(&matrix), ball: s.ball, a: s.a, b: s.b, twist }
    }

    /// The correct coefficients, in the paper's symbols.
    pub fn right(&self) -> [Sym; 6] {
        let [theta, m0, v, alpha, beta] = letters(["θ₀", "m₀", "V", "α₁", "β₁"]);
        let [phi1, phi2, phi3, phi4] = letters(["Φ₁", "Φ₂", "Φ₃", "Φ₄"]);
        let z = self.z();
        [
            theta * m0,
            theta * m0 * beta,
            z + theta * m0 * alpha * v,
            beta * z - phi3 * phi2,
            phi3 * (self.twist * alpha - beta * phi2) + alpha * v * (phi4 * theta - phi3 * phi1),
            -(alpha * v * phi3 * phi2),
        ]
    }

    /// Z as printed.
    pub fn z(&self) -> Sym {
        let [theta, phi1, phi3, phi4] = letters(["θ₀", "Φ₁", "Φ₃", "Φ₄"]);
        -(phi3 * phi1) + phi4 * theta + self.a * theta
    }
}

/// The coefficients of minus the determinant, the highest power of mu first.
pub(super) fn by_powers<const N: usize, const POWERS: usize>(matrix: &[[Sym; N]; N]) -> [Sym; POWERS] {
    let mut powers = [Sym::ZERO; POWERS];
    let polynomial = -determinant(matrix).unwrap_or(Sym::ZERO);
    for (exponents, coefficient) in coefficients(polynomial, &[letter("μᵉ")]).unwrap_or_default() {
        let place = (POWERS - 1).checked_sub(exponents[0] as usize);
        if let Some(place) = place.and_then(|place| powers.get_mut(place)) {
            *place = tidy(coefficient);
        }
    }
    powers
}

fn coefficients_of_hurwitz(page: &mut Page, q: &Quintic) {
    let entry = "section3.1-hurwitz";
    let [theta, v, alpha, beta] = letters(["θ₀", "V", "α₁", "β₁"]);
    let [phi2, phi3] = letters(["Φ₂", "Φ₃"]);
    let names = letters(["a₀", "a₁", "a₂", "a₃", "a₄", "a₅"]);
    let right = q.right();
    let z = q.z();
    let loose = theta * q.ball;
    let printed = [
        ("a0", "a0-corrected", 0, loose, r"$m_{sp}$ stands where $m(x_0)$ should stand."),
        ("a1", "a1-corrected", 1, loose * beta, r"$m_{sp}$ stands where $m(x_0)$ should stand."),
        (
            "a2",
            "a2-corrected",
            2,
            z - loose * alpha * v,
            r"The sign of $\alpha_1V_0$ is wrong, and $m_{sp}$ stands where $m(x_0)$ should stand.",
        ),
        (
            "a4",
            "a4-corrected",
            4,
            phi3 * (q.b * alpha - beta * phi2) + alpha * v * (q.a * theta - z),
            r"The sign of the last bracket is wrong, and the factor $R/\rho_0$ of $b$ is missing.",
        ),
        (
            "a5",
            "a5-corrected",
            5,
            alpha * v * phi3 * phi2,
            "The sign is wrong. The polynomial before has the right one.",
        ),
    ];
    for (slug, corrected, k, value, why) in printed {
        page.claim(
            entry,
            slug,
            format!("The paper prints the coefficient $a_{k}$ of Hurwitz' matrix of the elastic governor as below"),
        )
        .why(why)
        .reading(AS_STIFFNESS)
        .fails([Line::formula(q.derived[k], names[k], value)]);
        page.claim(
            entry,
            corrected,
            format!("For a rim that resists, the coefficient $a_{k}$ of the determinant is as follows"),
        )
        .holds([Line::formula(q.derived[k], names[k], right[k])]);
        page.correct();
    }
    page.claim(entry, "a3", r"The coefficient $a_3=\beta_1Z-\Phi_3\Phi_2$ of Hurwitz' matrix is right as printed")
        .reading(AS_STIFFNESS)
        .holds([Line::formula(q.derived[3], names[3], beta * z - phi3 * phi2)]);
}

/// The leading minors of Hurwitz' matrix: row i, column j has a_(2j - i), counted from 1.
fn minor(a: &[Sym; 6], size: usize) -> Sym {
    let entry = |i: usize, j: usize| (2 * j + 1).checked_sub(i).and_then(|k| a.get(k)).copied().unwrap_or(Sym::ZERO);
    let rows: Vec<Vec<Sym>> = (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect();
    determinant(&rows).unwrap_or(Sym::ZERO)
}

/// Claims on the minors, with the coefficients of the polynomial in terms of independent symbols.
fn determinants(page: &mut Page, q: &Quintic) {
    let entry = "section3.1-hurwitz";
    let [theta, m0, v, alpha, beta] = letters(["θ₀", "m₀", "V", "α₁", "β₁"]);
    let [phi2, phi3, phi4] = letters(["Φ₂", "Φ₃", "Φ₄"]);
    let [first, second, third, fourth, fifth] = letters(["Δ₁", "Δ₂", "Δ₃", "Δ₄", "Δ₅"]);
    let a = q.right();
    let derived = |size: usize| tidy(minor(&a, size));
    let inertia = theta * m0;
    page.claim(entry, "delta1", r"As printed, the first minor is $\Delta_1=a_1=\theta m_0$")
        .why(r"The factor $\beta_1$ of $a_1$ is missing.")
        .fails([Line::formula(derived(1), first, inertia)]);
    page.claim(entry, "delta1-corrected", r"The first minor is $\Delta_1=\theta m_0\beta_1$").holds([Line::formula(
        derived(1),
        first,
        inertia * beta,
    )]);
    page.correct();
    page.claim(
        entry,
        "delta2",
        r"As printed, the second minor is $\Delta_2=\theta m_0(\Phi_3\Phi_2-\theta m_0\alpha_1V_0\beta_1V_0)$",
    )
    .why(r"The sign is that of the printed $a_2$, and $V_0$ stands twice.")
    .fails([Line::formula(derived(2), second, inertia * (phi3 * phi2 - inertia * alpha * v * beta * v))]);
    page.claim(
        entry,
        "delta2-corrected",
        r"The second minor is $\Delta_2=\theta m_0(\Phi_3\Phi_2+\theta m_0\alpha_1\beta_1V_0)$",
    )
    .holds([Line::formula(derived(2), second, inertia * (phi3 * phi2 + inertia * alpha * beta * v))]);
    page.correct();
    let z = q.z();
    let coupling = phi2 * phi3;
    let third_of_paper = coupling
        * (int(2) * m0.powi(2) * beta * alpha * theta.powi(2) * v + inertia * beta * z - inertia * coupling
            + beta.powi(3) * inertia.powi(2))
        - alpha * beta.powi(2) * inertia.powi(2) * (q.b * phi3 + v * q.a * theta);
    page.claim(entry, "delta3", r"As printed, the third minor is the bracket that $a_4$ multiplies in $\Delta_4$")
        .why(r"The signs of $2m_0^2\theta^2\alpha_1\beta_1V_0$ and of $V_0a\theta$ are wrong, and the factor $R/\rho_0$ of $b$ is missing.")
        .reading(AS_STIFFNESS)
        .fails([Line::formula(derived(3), third, third_of_paper)]);
    page.claim(
        entry,
        "delta3-corrected",
        r"The third minor is $\Delta_3=\theta m_0\left(\Phi_2\Phi_3\left(\beta_1Z-\Phi_2\Phi_3+\theta m_0\beta_1(\beta_1^2-2\alpha_1V_0)\right)-\theta m_0\alpha_1\beta_1^2\left(b\frac R{\rho_0}\Phi_3-aV_0\theta\right)\right)$",
    )
    .note(r"In addition to $a_0,\dots,a_5>0$ the third minor is not needed, by Liénard and Chipart: $\Delta_2$ and $\Delta_4$ suffice.")
    .holds([Line::formula(
        derived(3),
        third,
        inertia
            * (coupling * (beta * z - coupling + inertia * beta * (beta.powi(2) - int(2) * alpha * v))
                - inertia * alpha * beta.powi(2) * (q.twist * phi3 - q.a * v * theta)),
    )]);
    page.correct();
    let fourth_of_paper = (phi3 * (q.b * alpha - beta * phi2) + alpha * v * (q.a * theta - z)) * third_of_paper
        - alpha
            * v
            * coupling
            * (inertia * coupling * (z + inertia)
                + inertia.powi(2) * beta * alpha * (-(phi3 * q.b) - v * (q.a * theta)));
    let data = [theta, m0, v, alpha, beta, phi3, phi4, q.ball, q.a, q.b];
    let positive = data.map(Condition::Positive);
    let one = |name: &'static str, value: i64| (name, value, 1);
    let point = exact([
        one("θ₀", 1),
        one("m₀", 1),
        one("V", 1),
        one("α₁", 1),
        one("β₁", 1),
        one("Φ₁", -1),
        one("Φ₂", -1),
        one("Φ₃", 1),
        one("Φ₄", 2),
        one("mₛ", 1),
        one("aᵉ", 1),
        one("bᵉ", 1),
        one("R", 1),
        one("ϱ₀", 1),
    ]);
    page.claim(entry, "delta4", "The fourth minor is the printed one, whose first term is $a_4$ times the bracket")
        .why(r"It is put together from the printed $a_2$, $a_4$, $a_5$ and $\Delta_3$, whose signs are wrong.")
        .reading(AS_STIFFNESS)
        .given(positive)
        .refuted([Condition::Equal(derived(4), fourth_of_paper)], point);
    let by_pairs = (a[1] * a[2] - a[0] * a[3]) * (a[3] * a[4] - a[2] * a[5]) - (a[1] * a[4] - a[0] * a[5]).powi(2);
    page.claim(
        entry,
        "delta4-corrected",
        r"The fourth minor is $\Delta_4=(a_1a_2-a_0a_3)(a_3a_4-a_2a_5)-(a_1a_4-a_0a_5)^2$ with the right $a_k$",
    )
    .holds([Line::formula(derived(4), fourth, by_pairs)]);
    page.correct();
    page.claim(entry, "delta5", r"As printed, the fifth minor is $\Delta_5=a_5=\alpha_1V_0\Phi_3\Phi_2$")
        .why(r"The factor $\Delta_4$ is missing, and the sign of $a_5$ is wrong.")
        .reading(AS_STIFFNESS)
        .fails([Line::formula(derived(5), fifth, alpha * v * phi3 * phi2)]);
    page.claim(
        entry,
        "delta5-corrected",
        r"The fifth minor is $\Delta_5=a_5\Delta_4$ with $a_5=-\alpha_1V_0\Phi_3\Phi_2$",
    )
    .holds([Line::formula(derived(5), fifth, by_pairs * a[5])]);
    page.correct();
}
