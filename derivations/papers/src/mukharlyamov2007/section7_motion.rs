//! Section 7: the equations (21), the permanent rotation (22), and the perturbation equations missing in the text.

use super::alphabet::{exact, int, letter, letters};
use super::top::{TopLetters, field, perturbations, perturbed, unperturbed, vector};
use claims::{Condition, Line, Page};
use symbolic::Sym;
use systems::variable_top::{poisson, rates};

use Condition::Zero;

pub fn claims(page: &mut Page, s: &TopLetters) {
    page.section("7. The motion in the Newtonian field");
    equations(page, s);
    permanent(page, s);
    perturbed_motion(page, s);
}

/// Claims on (21).
fn equations(page: &mut Page, s: &TopLetters) {
    let now = s.now();
    let ([p, q, r], [g1, g2, g3]): ([Sym; 3], [Sym; 3]) = (s.at.spin.into(), s.at.vertical.into());
    let [a, c, m, z, nu, g] = letters(["A", "C", "M", "zc", "ν", "g"]);
    let acceleration = vector(["ṗ", "q̇", "ṙ"]);
    let derived = now.residual(s.at.spin, acceleration, now.moment_of_field(s.at.vertical));
    let weight = m * g * z;
    let first = (a - c) * q * r - nu * q + weight * g2 + s.tide * (c - a) * g2 * g3;
    page.claim("eq21", "first", "The first and the third equation of (21) are right as printed").holds([
        Line::equation(derived.x, a * acceleration.x, first),
        Line::equation(derived.z, c * acceleration.z, Sym::ZERO),
    ]);
    let rest = nu * p - weight * g1 + s.tide * (a - c) * g3 * g1;
    page.claim("eq21", "second", "As printed, the second equation of (21) has $(A-C)rp$")
        .why("The sign is wrong: (16) has $(C-A)rp$.")
        .fails([Line::equation(derived.y, a * acceleration.y, (a - c) * r * p + rest)]);
    page.claim("eq21", "second-corrected", "The second equation of (21) has $(C-A)rp$, as in (16)")
        .holds([Line::equation(derived.y, a * acceleration.y, (c - a) * r * p + rest)]);
    page.correct();
    let moving = poisson(&s.at);
    let names = letters(["γ̇1", "γ̇2", "γ̇3"]);
    let printed = [r * g2 - q * g3, p * g3 - r * g1, q * g1 - p * g2];
    page.claim(
        "eq21",
        "vertical",
        r"$\dot\gamma_1=r\gamma_2-q\gamma_3$ and its permutations hold because the vertical is at rest in space",
    )
    .holds((0..3).map(|i| Line::formula(moving[i], names[i], printed[i])));
    let moment = now.moment_of_field(s.at.vertical);
    let kept = rates(&s.constant(), &s.at, s.aim, moment, moving);
    page.claim(
        "eq21",
        "integrals",
        "(21) with the corrected second equation has the integrals (17) for constant $A$, $C$, $Mz_c$",
    )
    .in_words()
    .follows([kept.energy, kept.vertical_momentum, kept.axial_momentum, kept.length].map(Zero));
    varying(page, s);
    let wrong = int(2) * q * int(2) * (a - c) * r * p;
    page.claim("eq21", "energy", r"(21) with the printed sign does not keep $f_1$, for constant $A$, $C$, $Mz_c$")
        .holds([Line::formula(kept.energy + wrong, letter("ḟ₁"), int(4) * (a - c) * p * q * r)]);
}

/// Claims on (21) with A(t), C(t), M(t), z_c(t), as used for V.
fn varying(page: &mut Page, s: &TopLetters) {
    let ([p, q, r], [g1, g2, g3]): ([Sym; 3], [Sym; 3]) = (s.at.spin.into(), s.at.vertical.into());
    let [da, dc, g] = letters(["Ȧ", "Ċ", "g"]);
    let found = rates(&s.top, &s.at, s.aim, s.now().moment_of_field(s.at.vertical), poisson(&s.at));
    let names = letters(["ḟ₁", "ḟ₂", "ḟ₃"]);
    let line = |derived: [Sym; 3], right: [Sym; 3]| (0..3).map(move |i| Line::formula(derived[i], names[i], right[i]));
    let derived = [found.energy, found.vertical_momentum, found.axial_momentum];
    page.claim(
        "eq21",
        "varying",
        r"(17) are integrals of (21) with varying $A$, $C$, $Mz_c$ too, so that $V$ is a bundle of integrals there",
    )
    .why("(21) leaves out the moments of the variable mass that keep these integrals by section 7.")
    .fails(line(derived, [Sym::ZERO; 3]));
    let [_, change] = s.static_moment();
    let energy = da * (p * p + q * q) + dc * r * r + int(2) * g * g3 * change - s.tide * (da - dc) * g3 * g3;
    page.claim(
        "eq21",
        "varying-corrected",
        r"(21) with varying $A$, $C$, $Mz_c$ and without the moments of the variable mass has these rates of (17)",
    )
    .holds(line(derived, [energy, da * (p * g1 + q * g2) + dc * r * g3, dc * (r - s.aim)]));
    page.correct();
}

/// Claims on (22).
fn permanent(page: &mut Page, s: &TopLetters) {
    page.claim("eq22", "rotation", r"$p=q=0$, $r=r_0$, $\gamma=(0,0,1)$ is a motion of (21), since every right side vanishes there, for any $A$, $C$, $Mz_c$ at the instant")
        .in_words()
        .follows(field(s).map(|rate| Zero(unperturbed(perturbed(rate)))));
}

/// Claims on the perturbation equations, which are missing in the text.
fn perturbed_motion(page: &mut Page, s: &TopLetters) {
    let [x1, x2, x3, x4, x5, x6] = perturbations();
    page.claim(
        "section7-perturbations",
        "lost",
        r"The equations of perturbed motion are $x_1=0,\dots,x_6=0$, (22) once more, so that every perturbation is zero",
    )
    .why("The text prints (22) twice, in the place of the equations of perturbed motion too.")
    .refuted([Zero(x1)], exact([("ω1", 1, 1)]));
    let [a, c, m, z, nu, g, r0] = letters(["A", "C", "M", "zc", "ν", "g", "r₀"]);
    let names = letters(["ω̇1", "ω̇2", "ω̇3", "η̇4", "η̇5", "η̇6"]);
    let found = field(s).map(perturbed);
    let (up, spin) = (int(1) + x6, r0 + x3);
    let pull = m * g * z - s.tide * (a - c) * up;
    let printed = [
        (((a - c) * spin - nu) * x2 + pull * x5) / a,
        (-((a - c) * spin - nu) * x1 - pull * x4) / a,
        Sym::ZERO,
        spin * x5 - x2 * up,
        x1 * up - spin * x4,
        x2 * x4 - x1 * x5,
    ];
    page.claim(
        "section7-perturbations",
        "lost-corrected",
        r"The equations of perturbed motion are (21) corrected with $x=(p,q,r-r_0,\gamma_1,\gamma_2,\gamma_3-1)$",
    )
    .holds((0..6).map(|i| Line::formula(found[i], names[i], printed[i])));
    page.correct();
}
