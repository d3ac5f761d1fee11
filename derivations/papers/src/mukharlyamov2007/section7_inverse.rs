//! Section 7: the perturbation equations, and the linear equations (18) for the control torques with right-hand sides
//! h.

use super::alphabet::{exact, int, letter, letters};
use super::top::{TopLetters, combination, half, vector};
use claims::{Condition, Line, Page};
use nalgebra::Vector3;
use symbolic::Sym;
use systems::variable_top::{Integrals, poisson, rates};

use Condition::{Equal, Zero};

pub fn claims(page: &mut Page, s: &TopLetters) {
    page.section("7. The inverse problem: linear equations for the moments");
    perturbations(page);
    system(page, s);
    right_sides(page, s);
}

/// Claims on the unnumbered equations before (18).
fn perturbations(page: &mut Page) {
    let [f1, k11, c1, df1] = letters(["f₁", "k₁₁", "C₁", "ḟ₁"]);
    page.claim(
        "section7-perturbations",
        "constants",
        r"Under $\dot f_1=k_{11}f_1+k_{12}f_2+k_{13}f_3$ the constant value $f_1=C_1$ of (17) is a solution, $\dot f_1=0$ (with $f_2=f_3=0$)",
    )
    .given([Equal(f1, c1), Equal(df1, k11 * f1)])
    .why(r"The perturbation of the integral is $f_1-C_1$ and not $f_1$.")
    .refuted([Zero(df1)], exact([("f₁", 1, 1), ("C₁", 1, 1), ("k₁₁", 1, 1), ("ḟ₁", 1, 1)]));
    page.claim("section7-perturbations", "constants-corrected", r"With the perturbation $f_1-C_1$ in the place of $f_1$, $\dot f_1=k_{11}(f_1-C_1)+k_{12}f_2+k_{13}f_3$, the constant value $f_1=C_1$ is a solution (with $f_2=f_3=0$)")
        .given([Equal(f1, c1), Equal(df1, k11 * (f1 - c1))])
        .by_combination([(Zero(df1), vec![], vec![(0, k11), (1, int(1))])]);
    page.correct();
}

/// The rates of f_1, f_2, f_3 under the torques X~, Y~, Z~, with arbitrary gamma'.
fn found(s: &TopLetters, moment: Vector3<Sym>, vertical_rate: Vector3<Sym>) -> Integrals<Sym> {
    rates(&s.top, &s.at, s.aim, moment, vertical_rate)
}

fn free() -> Vector3<Sym> {
    vector(["Γ1", "Γ2", "Γ3"])
}

/// Claims on the left-hand sides of (18).
fn system(page: &mut Page, s: &TopLetters) {
    let moment = vector(["X̃", "Ỹ", "Z̃"]);
    let (with, without) = (found(s, moment, free()), found(s, Vector3::zeros(), free()));
    let [h1, h2, h3] = letters(["h₁", "h₂", "h₃"]);
    let ([p, q, r], [g1, g2, g3]): ([Sym; 3], [Sym; 3]) = (s.at.spin.into(), s.at.vertical.into());
    let (energy, momentum) = (half(with.energy - without.energy), with.vertical_momentum - without.vertical_momentum);
    page.claim("eq18", "moments", r"By (18) the moments enter $\frac12\dot f_1$ and $\dot f_2$ as printed").holds([
        Line::equation(energy - h1, p * moment.x + q * moment.y + r * moment.z, h1),
        Line::equation(momentum - h2, g1 * moment.x + g2 * moment.y + g3 * moment.z, h2),
    ]);
    let [z, mz] = letters(["Z", "Mz"]);
    let axial = |moment: Sym| {
        let with = found(s, Vector3::new(Sym::ZERO, Sym::ZERO, moment), free()).axial_momentum;
        with - without.axial_momentum
    };
    page.claim("eq18", "axial", "By (18) as printed, $Z=h_3$")
        .why(r"The moment $M_z$ of the variable mass is missing: $\tilde Z=Z+M_z$.")
        .fails([Line::equation(axial(z + mz) - h3, z, h3)]);
    page.claim("eq18", "axial-corrected", r"(18) has $\tilde Z=h_3$, as (19) does").holds([Line::equation(
        axial(moment.z) - h3,
        moment.z,
        h3,
    )]);
    page.correct();
    let [k44, f4] = letters(["k₄₄", "f₄"]);
    let along = g1 * free().x + g2 * free().y + g3 * free().z;
    page.claim(
        "eq18",
        "length",
        r"By (18) as printed, $\gamma\cdot\Gamma=k_{44}f_4$ follows from $\dot f_4=k_{44}f_4$",
    )
    .why(r"$\dot f_4=2\gamma\cdot\Gamma$, for $f_4$ is a sum of squares: the half is missing.")
    .fails([Line::equation(half(without.length - k44 * f4), along, k44 * f4)]);
    page.claim("eq18", "length-corrected", r"$\gamma\cdot\Gamma=\frac12k_{44}f_4$ follows from $\dot f_4=k_{44}f_4$")
        .holds([Line::equation(half(without.length - k44 * f4), along, half(k44 * f4))]);
    page.correct();
}

fn right_sides(page: &mut Page, s: &TopLetters) {
    let wanted = [["k₁₁", "k₁₂", "k₁₃"], ["k₂₁", "k₂₂", "k₂₃"], ["k₃₁", "k₃₂", "k₃₃"]].map(combination);
    let [h1, h2, h3] = letters(["h₁", "h₂", "h₃"]);
    let missing = found(s, Vector3::zeros(), free());
    let [a, da, c, dc, m, dm, z, dz, g] = letters(["A", "Ȧ", "C", "Ċ", "M", "Ṁ", "zc", "żc", "g"]);
    let ([p, q, r], [g1, g2, g3]): ([Sym; 3], [Sym; 3]) = (s.at.spin.into(), s.at.vertical.into());
    let (rate, nu) = (free(), letter("ν"));
    let varying = -half(da * (p * p + q * q)) - half(dc * r * r) + half(s.tide * (da - dc) * g3 * g3);
    let tidal = s.tide * (a - c) * g3 * rate.z;
    let derived = half(wanted[0] - missing.energy);
    page.claim("section7-h1", "printed", "$h_1$ is the expression printed below (18)")
        .why(r"There are four slips. $\frac12\sum k_{1i}f_i$ is meant. $\Gamma_3$ and not $\Gamma_2$ belongs to $Mgz_c$. $\gamma_3$ and not $z_c$ belongs to $Mg\dot z_c$, as $\tilde h_1$ has it, and the printed product has another dimension than the other terms. $\dot M$ is missing.")
        .fails([Line::formula(derived, h1, wanted[0] - m * g * z * rate.y + tidal + varying - m * g * z * dz)]);
    page.claim("section7-h1", "corrected", r"$\dot f_1$ along (16) gives $h_1$").holds([Line::formula(
        derived,
        h1,
        half(wanted[0]) - m * g * z * rate.z + tidal + varying - g * g3 * (m * dz + dm * z),
    )]);
    page.correct();

    page.claim(
        "section7-h2-h3",
        "printed",
        r"$h_2=\sum k_{2i}f_i$, $h_3=\sum k_{3i}f_i$ hold as printed for a body of variable mass",
    )
    .why(r"The moments of inertia change in $f_2$ and $f_3$ too, and $\dot f_2$ contains $\Gamma$.")
    .fails([
        Line::formula(wanted[1] - missing.vertical_momentum, h2, wanted[1]),
        Line::formula(wanted[2] - missing.axial_momentum, h3, wanted[2]),
    ]);
    let turning = ((a - c) * r - nu) * (p * g2 - q * g1) - a * (p * rate.x + q * rate.y) - (c * r + nu) * rate.z;
    page.claim(
        "section7-h2-h3",
        "corrected",
        r"$\dot f_2$ and $\dot f_3$ along (16) give $h_2$ and $h_3$, for a body of variable mass and free $\Gamma$",
    )
    .holds([
        Line::formula(
            wanted[1] - missing.vertical_momentum,
            h2,
            wanted[1] - da * (p * g1 + q * g2) - dc * r * g3 + turning,
        ),
        Line::formula(wanted[2] - missing.axial_momentum, h3, wanted[2] - dc * (r - s.aim)),
    ]);
    page.correct();
    let moving = found(s, Vector3::zeros(), poisson(&s.at));
    page.claim("section7-h2-h3", "poisson", r"With $\Gamma=\gamma\times\omega$, $h_2$ is the printed sum and two terms with $\dot A$ and $\dot C$, so that the print is right for a body of constant mass")
        .holds([Line::formula(
            wanted[1] - moving.vertical_momentum,
            h2,
            wanted[1] - da * (p * g1 + q * g2) - dc * r * g3,
        )]);
}
