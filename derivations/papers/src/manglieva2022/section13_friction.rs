//! Section 1.3, task 1: the steered rod's constraints and its law of friction, (1.66)-(1.82).

use super::alphabet::{exact, int, letter, letters, tidy};
use super::steered::SteeredLetters;
use claims::{Condition, Line, Page};
use field::{Scalar, Tangent};
use mechanics::constrained::{Constrained, State};
use symbolic::{Hypotheses, Sym};

use Condition::{Equal, NonZero, Positive};

pub fn claims(page: &mut Page, s: &SteeredLetters) {
    page.section("1.3. Task 1, the law of friction");
    constraints(page, s);
    combination(page, s);
    parts(page, s);
    law(page, s);
}

fn constraints(page: &mut Page, s: &SteeredLetters) {
    let place = letters(["x1", "y1", "x2", "y2"]);
    let velocity = letters(["ẋ1", "ẏ1", "ẋ2", "ẏ2"]);
    let ([x1, y1, x2, y2], [u1, v1, u2, v2]) = (place, velocity);
    let at = State { time: Sym::ZERO, place, velocity };
    let [length, _, _] = s.rod.constraints(&at).map(|constraint| constraint.value());
    page.claim("eq1.66", "constraints", "The rod with one end on the guide $y_1=0$ keeps its length").defines([
        Line::equation(length, (int(1) / int(2)) * ((y2 - y1).powi(2) + (x2 - x1).powi(2) - s.l.powi(2)), Sym::ZERO),
    ]);
    // twice the velocity of the middle, times the direction of the rod (cross product)
    let moving = |a: Sym, b: Sym, p: Sym, q: Sym| ((Tangent::moving(a, p) + Tangent::moving(b, q)).half()).slope;
    let (u, v) = (moving(x1, x2, u1, u2), moving(y1, y2, v1, v2));
    page.claim("eq1.67", "middle", "The velocity of the rod's middle has the direction of the rod").holds([
        Line::equation(
            int(2) * ((x2 - x1) * v - (y2 - y1) * u),
            (x2 - x1) * (v2 + v1) - (y2 - y1) * (u2 + u1),
            Sym::ZERO,
        ),
    ]);
}

/// Claims on (1.68)-(1.75).
fn combination(page: &mut Page, s: &SteeredLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let [rx, ry, y] = letters(["Rx", "Ry", "Y"]);
    let [rho, rho2, rho21, rho22] = letters(["ρ1", "ρ2", "ρ21", "ρ22"]);
    let of_friction = s.of_constraints([rho21, rho22, Sym::ZERO]);
    page.claim("eq1.68", "directions",r"(1.68) are the components of friction, with $\vec\rho_{21}$ along the rod and $\vec\rho_{22}$ across it, $(-\sin\theta,\cos\theta)$. On $M_2$ both enter with plus, on $M_1$ with minus and plus")
        .holds([
            Line::formula(of_friction[2], letter("ρ2x"), rho21 * c - rho22 * sin),
            Line::formula(of_friction[3], letter("ρ2y"), rho21 * sin + rho22 * c),
            Line::formula(of_friction[0], letter("ρ1x"), -rho21 * c - rho22 * sin),
            Line::formula(of_friction[1], letter("ρ1y"), -rho21 * sin + rho22 * c),
        ]);
    // friction at M1 and M2 by (1.68); the constraints on the friction divided by the masses
    let friction = [rx + of_friction[0], ry - y + of_friction[1], of_friction[2], of_friction[3]];
    let vertical = friction[1];
    page.claim(
        "eq1.69",
        "vertical",r"Friction at $M_1$ has no vertical component, printed with $+\rho_{22}\cos\theta$",
    ).why(r"By (1.68) friction at $M_1$ has $-\rho_{21}$ along the rod and $+\rho_{22}$ across it, so that the sign of $\rho_{22}\cos\theta$ is wrong.")
    .fails([Line::equation(vertical, ry - y, rho21 * sin + rho22 * c)]);
    page.claim(
        "eq1.69",
        "vertical-corrected",
        r"Friction at $M_1$ has no vertical component, with $-\rho_{22}\cos\theta$, which (1.73) and (1.74) use",
    )
    .holds([Line::equation(vertical, ry - y, rho21 * sin - rho22 * c)]);
    page.correct();

    let displaced = |direction: [Sym; 3], friction: [Sym; 4]| {
        let row = s.of_constraints(direction);
        let masses = [s.m1, s.m1, s.m2, s.m2];
        (0..4).fold(Sym::ZERO, |sum, i| sum + row[i] * friction[i] / masses[i])
    };
    let along = |friction| -displaced([int(1), Sym::ZERO, Sym::ZERO], friction);
    let across = |friction| -displaced([Sym::ZERO, int(1), Sym::ZERO], friction);
    page.claim("eq1.70", "along", "The displacements of both points have equal projections on the rod")
        .holds([Line::equation(along(friction), (rx * c + (ry - y) * sin - rho21) / s.m1, rho21 / s.m2)]);
    let whole = [rho, Sym::ZERO, of_friction[2], of_friction[3]];
    let given = [
        Equal(rho2.powi(2), tidy(of_friction[2].powi(2) + of_friction[3].powi(2))),
        Condition::Zero(tidy(along(whole))),
        Condition::Zero(tidy(across(whole))),
        Positive(s.m1),
        Positive(s.m2),
        Positive(rho2),
    ];
    page.claim("eq1.71", "by-sizes",r"$\frac1{m_1}\rho_1\cos\theta = \frac1{m_2}\rho_2$ holds as printed, with the size $\rho_2$ of friction at $M_2$").why(r"The projection on the rod is $\rho_{21}$; the size $\rho_2$ contains the component $\rho_{22}$ across the rod too.")
        .given(given)
        .refuted([Equal(rho * c / s.m1, rho2 / s.m2)], exact([
            ("m1", 1, 1), ("m2", 1, 1), ("ρ1", 1, 1), ("ρ2", 1, 1), ("ρ21", 3, 5), ("ρ22", 4, 5),
            ("cos θ", 3, 5), ("sin θ", 4, 5),
        ]));
    page.claim(
        "eq1.71",
        "by-sizes-corrected",
        r"$\frac1{m_1}\rho_1\cos\theta = \frac1{m_2}\rho_{21}$ holds with the component of friction along the rod",
    )
    .holds([Line::equation(along(whole), rho * c / s.m1, rho21 / s.m2)]);
    page.correct();
    page.claim("eq1.72", "across", "The projections across the rod cancel").holds([Line::equation(
        across(friction),
        (rx * sin - (ry - y) * c - rho22) / s.m1 - rho22 / s.m2,
        Sym::ZERO,
    )]);
    let guided = friction.map(|component| component.substitute(&[(ry, y + rho21 * sin - rho22 * c)]));
    let q = s.m1 / s.m2;
    page.claim("eq1.73", "along-collected", "(1.70) with (1.69) in its right form gives (1.73)")
        .holds([Line::equation(along(guided) * s.m1, rx * c, (q + c.powi(2)) * rho21 + rho22 * c * sin)]);
    page.claim("eq1.74", "across-collected", "(1.72) with (1.69) in its right form gives (1.74)")
        .holds([Line::equation(across(guided) * s.m1, rx * sin, (q + sin.powi(2)) * rho22 + rho21 * sin * c)]);
}

/// Claims on (1.75)-(1.80).
fn parts(page: &mut Page, s: &SteeredLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let [rx, ry, r21, r22] = letters(["Rx", "Ry", "R1", "R2"]);
    let parts = s.extended([rx, ry, r21, r22]);
    let [along, across, _] = parts.multipliers;
    let (rho21, rho22) = (tidy(r21 - along), tidy(r22 - across));
    page.claim("eq1.75", "ratio", r"(1.75) is $\rho_{22} = \operatorname{tg}\theta\,\rho_{21}$")
        .follows([Equal(rho22, sin / c * rho21)]);
    let share = |mass: Sym| mass * rx / (s.m1 + s.m2);
    page.claim("eq1.76", "along", "The friction along the rod is (1.76)")
        .reading(r"The source's $R_\tau$ is read as the component $R_x$ of the guide's reaction.")
        .holds([Line::formula(rho21, letter("ρ21"), share(s.m2) * c)]);
    page.claim("eq1.77", "across", "The friction across the rod is (1.77)")
        .reading(r"The source's $R_\tau$ is read as the component $R_x$ of the guide's reaction.")
        .holds([Line::formula(rho22, letter("ρ22"), share(s.m2) * sin)]);
    page.claim("eq1.78", "at-m1", "The friction at $M_1$ is (1.78)")
        .reading(r"The source's $R_\tau$ is read as the component $R_x$ of the guide's reaction.")
        .holds([Line::formula(parts.of_friction[0], letter("ρ1"), share(s.m1))]);
    let friction = s.friction();
    let combined = s.extended([(s.m1 + s.m2) * s.mu, Sym::ZERO, Sym::ZERO, Sym::ZERO]).of_friction;
    page.claim("eq1.79", "components-m1", r"With $\mu=R_x/(m_1+m_2)$ the friction at $M_1$ has the components (1.79)")
        .holds([
            Line::formula(combined[0], letter("ρ1x"), s.m1 * s.mu),
            Line::formula(combined[1], letter("ρ1y"), Sym::ZERO),
        ]);
    let double = s.point + s.point;
    page.claim("eq1.80", "components-m2", "The friction at $M_2$ has the components (1.80)").holds([
        Line::formula(friction[2], letter("ρ2x"), s.m2 * s.mu * double.cos),
        Line::formula(friction[3], letter("ρ2y"), s.m2 * s.mu * double.sin),
    ]);
    let normal = s.named_constraints();
    let (lambda, lambda1, lambda2) = (s.lambda, s.lambda1, s.lambda2);
    let names = letters(["R′1x", "R′1y", "R′2x", "R′2y"]);
    let lines = |right: [Sym; 4]| (0..4).map(move |i| Line::formula(normal[i], names[i], right[i]));
    page.claim("eq1.80", "forces-of-constraint",r"The forces of constraint at $M_1$ and $M_2$ are those printed, with $\lambda$ in the horizontal component").why(r"$\lambda$ pushes across the guide, so it belongs to the vertical component. In the last line sine and cosine are exchanged, and (1.83) has them right.")
        .fails(lines([
            lambda - lambda1 * c - lambda2 * sin,
            -lambda1 * sin - lambda2 * c,
            lambda1 * c - lambda2 * sin,
            lambda1 * c + lambda2 * sin,
        ]));
    page.claim(
        "eq1.80",
        "forces-of-constraint-corrected",
        "The forces of constraint at $M_1$ and $M_2$ are those that stand in (1.83)",
    )
    .holds(lines([
        -lambda1 * c - lambda2 * sin,
        -lambda1 * sin + lambda2 * c + lambda,
        lambda1 * c - lambda2 * sin,
        lambda1 * sin + lambda2 * c,
    ]));
    page.correct();
}

/// Claims on (1.81)-(1.82).
fn law(page: &mut Page, s: &SteeredLetters) {
    let [rx, ry, r21, r22, y] = letters(["Rx", "Ry", "R1", "R2", "Y"]);
    let [_, _, of_guide] = s.extended([rx, ry, r21, r22]).multipliers;
    page.claim("eq1.81", "vertical", r"The guide's normal reaction is its force of constraint: $R_y=Y=\lambda$, since by (1.75) the terms of (1.69) cancel")
        .holds([Line::formula(of_guide, y, ry)]);
    let sign = letter("ε");
    let mass = s.m1 + s.m2;
    let law = [Equal(mass * s.mu, sign * s.f * s.lambda), Positive(s.m1), Positive(s.m2), Positive(s.f)];
    page.claim(
        "eq1.81",
        "law",
        r"Coulomb's law $R_x=\varepsilon fR_y$, expressed by $\mu$ and $\lambda$, is (1.81) as printed, without $f$",
    )
    .why(r"The factor $f$ is missing. (1.82) and (1.97) have it.")
    .given(law)
    .refuted(
        [Equal(s.mu, sign * s.lambda / mass)],
        exact([("m1", 1, 1), ("m2", 1, 1), ("f", 1, 2), ("ε", 1, 1), ("λ", -4, 1), ("μ", -1, 1)]),
    );
    page.claim(
        "eq1.81",
        "law-corrected",
        r"Coulomb's law, expressed by $\mu$ and $\lambda$, is (1.81) with the factor $f$",
    )
    .given([Equal(mass * s.mu, sign * s.f * s.lambda), NonZero(mass)])
    .by_combination([(Equal(s.mu, sign * s.f * s.lambda / mass), vec![1], vec![(0, int(1))])]);
    page.correct();
    let way = sign;
    let unit = Hypotheses::none().rule(way, 2, int(1));
    page.claim("eq1.82", "direction",r"Friction, printed $\mu=-f\lambda/(m_1+m_2)$ for $\dot x_1>0$, is against the velocity on a floor that pushes $M_1$ upwards ($\lambda<0$)").reading(r"The source names no side of the guide; the floor is judged, as in (1.22).").why(r"The sign is that of a guide which holds $M_1$ down, $\lambda>0$; on a floor the printed friction drives.")
        .given([Positive(s.dx1), Positive(-s.lambda), Positive(s.f), Positive(s.m1), Positive(s.m2), Equal(s.mu, -(s.f * s.lambda / mass))])
        .refuted([Positive(-(s.mu * s.dx1))], exact([
            ("m1", 1, 1), ("m2", 1, 1), ("f", 1, 2), ("λ", -4, 1), ("μ", 1, 1), ("ẋ1", 1, 1),
        ]));
    let [push, speed] = letters(["N", "v"]);
    page.claim("eq1.82", "direction-corrected",r"$\mu=\varepsilon f\lambda/(m_1+m_2)$ with the sign $\varepsilon$ of $\dot x_1=\varepsilon v$. On a floor, $N=-\lambda>0$, the power of friction is $-fNv$")
        .under(&unit)
        .given([Positive(s.f), Positive(push), Positive(speed), Positive(s.m1), Positive(s.m2)])
        .by_signs([Positive(-(mass * (way * s.f * -push / mass) * (way * speed)))]);
    page.correct();
}
