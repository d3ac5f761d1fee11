//! Section 3.1: the linearised elastic governor and its characteristic equation.

use super::alphabet::{int, letter, letters, tidy};
use super::elastic::{AS_PRINTED, AS_STIFFNESS, ElasticLetters};
use super::section31_hurwitz::{self, Quintic, by_powers};
use claims::{Condition, Line, Page};
use symbolic::Sym;

pub fn claims(page: &mut Page, s: &ElasticLetters) {
    page.section("3.1. Stability of the elastic governor");
    linearised(page, s);
    matrix(page, s);
    let quintic = Quintic::new(s);
    page.section("3.1. The characteristic polynomial of the elastic governor");
    polynomial(page, s, &quintic);
    section31_hurwitz::claims(page, &quintic);
}

/// Claims on (3.20), (3.21) by differentiation; deviations are marked with a prime.
fn linearised(page: &mut Page, s: &ElasticLetters) {
    let [dw, ddx, dx, x, w, w0] = letters(["ω̇′", "ẍ′", "ẋ′", "x′", "ω′", "ω₀"]);
    let [lambda, psi, dlambda, dpsi] = letters(["λᵉ", "ψ", "λ̇ᵉ", "ψ̇"]);
    let ([of_w, of_x, of_dx, of_lambda, of_psi], [of_dw, of_ddx]) = (s.state, s.rates);
    let deviations =
        [(of_w, w), (of_x, x), (of_dx, dx), (of_lambda, lambda), (of_psi, psi), (of_dw, dw), (of_ddx, ddx)];
    let linear =
        |equation: Sym| deviations.iter().fold(Sym::ZERO, |sum, (of, by)| sum + s.stationary(equation.diff(*of)) * *by);
    let [turning, sliding] = s.balance.map(linear);
    let [rho, f, theta, m0] = letters(["ϱ₀", "Fˣ", "θ₀", "m₀"]);
    let names = s.names(&["θ₀", "ϱ₀", "Fˣ"]);
    let fall = s.drum / rho.powi(2) * s.moments[1];
    page.claim("eq3.20", "rotation", r"The linear equation of $\omega_1$ has the printed terms $\dot x'$ with $M_2$ and $-b\psi$, with the right $F(x_0)$")
        .under(&names)
        .why(r"The moment $M_2R/(x-c)$ varies with $x$, not with $\dot x$; $-b\psi\frac R{x-c}$ on the right of (3.17) comes to the left with a plus.")
        .reading(format!("{AS_PRINTED} For a rim that resists, the sign $-b$ is right and the factor $R/\\rho_0$ alone is missing."))
        .fails([Line::equation(turning, theta * dw + f * dx * w0 + fall * dx - s.b * psi, Sym::ZERO)]);
    page.claim(
        "eq3.20",
        "rotation-corrected",
        r"The linear equation of $\omega_1$ has $x'$ with $M_2$ and $+b\frac R{\rho_0}\psi$, which the moment $-b\psi$ on the disc gives",
    )
    .under(&names)
    .reading(AS_PRINTED)
    .holds([Line::equation(turning, theta * dw + f * dx * w0 + fall * x + s.b * s.drum / rho * psi, Sym::ZERO)]);
    page.correct();
    let [c1, c2] = s.springs;
    let half = s.ball / int(2);
    page.claim("eq3.21", "sleeve", r"As printed, the linear equation of $x$ has dots over $x'$ and $\omega_1'$ and no $m_{sp}$")
        .under(&s.names(&["m₀"]))
        .why(r"The centrifugal force and the springs vary with $x$ and $\omega_1$, not with their rates; $m_{sp}$ is missing in front of $2x_0\omega_1^0\omega_1'$.")
        .reading(AS_PRINTED)
        .fails([Line::equation(
            sliding,
            m0 * ddx + half * dx * w0.powi(2) + int(2) * s.rest * w0 * dw + (c1 + c2) * dx - s.a * lambda,
            Sym::ZERO,
        )]);
    page.claim(
        "eq3.21",
        "sleeve-corrected",
        r"The linear equation of $x$ is $m_0\ddot x'+\frac12m_{sp}(x'(\omega_1^0)^2+2x_0\omega_1^0\omega_1')+(c_1+c_2)x'-a\lambda=0$",
    )
    .reading(AS_PRINTED)
    .under(&s.names(&["m₀"]))
    .holds([Line::equation(
        sliding,
        m0 * ddx + half * (x * w0.powi(2) + int(2) * s.rest * w0 * w) + (c1 + c2) * x - s.a * lambda,
        Sym::ZERO,
    )]);
    page.correct();
    let [_, across, turn] = s.rolling().map(linear);
    let rolled = s.drum * w0;
    page.claim(
        "eq3.21",
        "slip",
        r"The linear constraint of no slipping across is $\dot x'-\dot\lambda-r_1\omega_1^0\psi=0$",
    )
    .holds([Line::equation(across - dlambda, dx - dlambda - rolled * psi, Sym::ZERO)]);
    let line = |a: Sym| Line::equation(dpsi - turn, dpsi - rolled * s.alpha * a + rolled * s.beta * psi, Sym::ZERO);
    page.claim("eq3.21", "line", r"As printed, the linear equation of the line of rolling has $\dot\lambda$")
        .why(r"The dot over $\lambda$ is a slip: (3.17) and (3.22) have $\lambda$.")
        .fails([line(dlambda)]);
    page.claim("eq3.21", "line-corrected", r"The linear equation of the line of rolling has $\lambda$")
        .holds([line(lambda)]);
    page.correct();
}

fn matrix(page: &mut Page, s: &ElasticLetters) {
    let derived = s.characteristic_matrix();
    let [theta, m0, v, rho, mu, f, w0] = letters(["θ₀", "m₀", "V", "ϱ₀", "μᵉ", "Fˣ", "ω₀"]);
    let names = s.names(&["θ₀", "m₀", "V", "ϱ₀", "Fˣ"]);
    let zero = Sym::ZERO;
    let stiffness = s.ball / int(2) * w0.powi(2) + s.springs[0] + s.springs[1];
    let printed = [
        [theta * mu, f * mu * w0 + s.drum / rho.powi(2) * s.moments[1], zero, -s.b],
        [s.ball * s.rest * w0, m0 * mu.powi(2) + stiffness, -s.a, zero],
        [zero, mu, -mu, -v],
        [zero, zero, -(v * s.alpha), mu + v * s.beta],
    ];
    let nonzero = (0..4).flat_map(|i| (0..4).map(move |j| (i, j))).filter(|&(i, j)| printed[i][j] != zero);
    let name = letter("D₁₄");
    let lines: Vec<Line> = nonzero
        .filter(|&place| place != (0, 3))
        .map(|(i, j)| Line::formula(derived[i][j], name, printed[i][j]))
        .collect();
    page.claim("eq3.22", "entries", r"Every entry of the matrix but that of $\psi$ in the first row follows from (3.17), with the right $F(x_0)$ and with $-a$ as the factor of $\lambda$")
        .in_words()
        .reading(AS_PRINTED)
        .under(&names)
        .follows(lines.iter().map(|line| Condition::Equal(line.derived, line.right)));
    page.claim("eq3.22", "twist", r"As printed, the entry of $\psi$ in the first row is $-b$")
        .under(&s.names(&["ϱ₀"]))
        .why(r"Sign and factor are those of (3.20): $-b\psi\frac R{\rho_0}$ on the right side comes to the left with a plus.")
        .reading(format!("{AS_PRINTED} For a rim that resists, the sign $-b$ is right and the factor $R/\\rho_0$ alone is missing."))
        .fails([Line::formula(derived[0][3], name, printed[0][3])]);
    page.claim("eq3.22", "twist-corrected", r"The entry of $\psi$ in the first row is $+b\frac R{\rho_0}$")
        .under(&s.names(&["ϱ₀"]))
        .holds([Line::formula(derived[0][3], name, s.b * s.drum / rho)]);
    page.correct();
}

fn polynomial(page: &mut Page, s: &ElasticLetters, q: &Quintic) {
    let entry = "section3.1-quintic";
    let by_data: [Sym; 6] = by_powers(&s.characteristic_matrix()).map(|coefficient| s.resisting(coefficient));
    page.claim(
        entry,
        "names",
        r"The coefficients of the characteristic polynomial of the elastic governor by $\theta$, $m_0$, $\Phi_k$, $\alpha_1$, $\beta_1$, $V_0$ are those by the data, for a rim that resists",
    )
    .in_words()
    .reading(AS_STIFFNESS)
    .under(&s.names_of_stiffness(&["θ₀", "m₀", "V", "α₁", "β₁", "Φ₁", "Φ₂", "Φ₃", "Φ₄", "ϱ₀"]))
    .follows((0..6).map(|k| Condition::Equal(by_data[k], q.derived[k])));
    let [theta, m0, v, alpha, beta] = letters(["θ₀", "m₀", "V", "α₁", "β₁"]);
    let [phi1, phi2, phi3, phi4] = letters(["Φ₁", "Φ₂", "Φ₃", "Φ₄"]);
    let names = letters(["a₀", "a₁", "a₂", "a₃", "a₄", "a₅"]);
    let (right, core) = (q.right(), phi3 * phi1 - phi4 * theta - q.a * theta);
    sign_of_rim(page, q);
    page.claim(entry, "mu5-and-1", r"The coefficients of $\mu^5$ and of 1 are right as printed").holds([
        Line::formula(q.derived[0], names[0], theta * m0),
        Line::formula(q.derived[5], names[5], -(alpha * v * phi3 * phi2)),
    ]);
    let wrong = [
        ("mu4", "mu4-corrected", r"of $\mu^4$", 1, -(theta * m0 * beta), "The sign of the whole coefficient is wrong."),
        (
            "mu3",
            "mu3-corrected",
            r"of $\mu^3$",
            2,
            theta * m0 * alpha * v + core,
            "$-Z$ stands next to $\\theta m_0\\alpha_1V_0$, where $Z$ should stand.",
        ),
        (
            "mu2",
            "mu2-corrected",
            r"of $\mu^2$",
            3,
            beta * core + phi3 * phi2,
            "The sign of the whole coefficient is wrong: $-(\\beta_1Z-\\Phi_3\\Phi_2)$ is printed.",
        ),
        (
            "mu1",
            "mu1-corrected",
            r"of $\mu$",
            4,
            beta * phi3 * phi2 - alpha * (v * (phi3 * phi1 - phi4 * theta) - q.b * phi3),
            "The sign of $\\beta_1\\Phi_3\\Phi_2$ is wrong and the factor $R/\\rho_0$ of $b$ is missing.",
        ),
    ];
    for (slug, corrected, of, k, printed, why) in wrong {
        page.claim(entry, slug, format!("The paper prints the coefficient {of} of the characteristic polynomial of the elastic governor as below"))
            .why(why)
            .reading(AS_STIFFNESS)
            .fails([Line::formula(q.derived[k], names[k], printed)]);
        page.claim(
            entry,
            corrected,
            format!("For a rim that resists, the coefficient {of} of the determinant is as follows"),
        )
        .holds([Line::formula(q.derived[k], names[k], right[k])]);
        page.correct();
    }
}

/// Claims on the contradiction of (3.17) and Z, and on the sign with which the motion can be stable.
fn sign_of_rim(page: &mut Page, q: &Quintic) {
    let entry = "section3.1-quintic";
    let [theta, m0, v, alpha, beta] = letters(["θ₀", "m₀", "V", "α₁", "β₁"]);
    let [phi2, phi3, phi4, z] = letters(["Φ₂", "Φ₃", "Φ₄", "Zᶠ"]);
    // a3 = beta Z - Phi3 Phi2 defines Z; with the force + a lambda, a has the opposite sign
    let of_resisting = (q.derived[3] + phi3 * phi2) / beta;
    let of_pushing = tidy(of_resisting.substitute(&[(q.a, -q.a), (q.b, -q.b)]));
    page.claim(
        entry,
        "z",r"The printed $Z=-\Phi_3\Phi_1+\Phi_4\theta+a\theta$ follows from (3.17) and (3.22), where the rim's force is $+a\lambda$",
    )
    .why(r"The force $+a\lambda$ gives $-a\theta$: (3.17) and $Z$ contradict each other in the sign of $a$.")
    .reading(AS_PRINTED)
    .fails([Line::formula(of_pushing, z, q.z())]);
    page.claim(
        entry,
        "z-corrected",
        r"$Z$ as printed is that of the force $-a\lambda$. With $+a\lambda$ it has $-a\theta$",
    )
    .reading(AS_STIFFNESS)
    .holds([Line::formula(of_resisting, z, q.z()), Line::formula(of_pushing, z, q.z() - theta * q.a - theta * q.a)]);
    page.correct();
    // the sleeve and the rim at a constant speed: rows 2 to 4 of the matrix
    let third = |force: Sym| {
        let (mu, zero) = (letter("μᵉ"), Sym::ZERO);
        let matrix = [[m0 * mu.powi(2) + phi4, force, zero], [mu, -mu, -v], [zero, -alpha, mu + beta]];
        let [a0, a1, a2, a3, a4]: [Sym; 5] = by_powers(&matrix);
        tidy(a1 * a2 * a3 - a0 * a3.powi(2) - a1.powi(2) * a4)
    };
    let data = || [m0, v, alpha, beta, phi4, q.a].map(Condition::Positive);
    page.claim(entry, "kept-speed-resists", r"At a kept speed $\omega_1$ a rim of the force $-a\lambda$, $a>0$, has a positive third minor of Hurwitz, $\Delta_3>0$")
        .reading(AS_STIFFNESS)
        .given(data())
        .by_signs([Condition::Positive(third(q.a))]);
    page.claim(entry, "kept-speed-pushes", r"At a kept speed $\omega_1$ a rim of the force $+a\lambda$, $a>0$, has a negative third minor of Hurwitz, $-\Delta_3>0$, for any other positive data, so that Hurwitz' condition fails")
        .reading(AS_PRINTED)
        .given(data())
        .by_signs([Condition::Positive(-third(-q.a))]);
}
