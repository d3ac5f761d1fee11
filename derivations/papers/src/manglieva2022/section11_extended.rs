//! Section 1.1, second part: the extended method on the rod, (1.6)-(1.19).

use super::alphabet::{int, letter, letters};
use super::rod::RodLetters;
use claims::{Condition, Line, Page};
use mechanics::constrained::{Constrained, State};
use symbolic::Sym;

use Condition::Equal;

pub fn claims(page: &mut Page, s: &RodLetters) {
    page.section("1.1. The rod, extended displacements");
    combination(page, s);
    components(page, s);
    motion(page, s);
}

/// Claims on (1.6)-(1.13): the friction parts of the reactions (R_x, R_y) of the guide and R_1 of the rod.
fn combination(page: &mut Page, s: &RodLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let [rx, ry, r1, y] = letters(["Rx", "Ry", "R1", "Y"]);
    let [rho, rho1] = letters(["ρ", "ρ1"]);
    let parts = s.extended([rx, ry, r1]);
    let [of_rod, of_guide] = parts.multipliers;
    let along = r1 - of_rod;
    let friction = parts.of_friction;

    page.claim("eq1.6", "along-the-guide", r"The friction at $M$ has the line of action $Ox$, since $\vec\rho\,\delta t/m$ is a virtual displacement")
        .note(r"In the lines before, $\vec\rho_1'$ in the force of friction at $M$ stands for $\vec R_1'$, as the repetition of the formula shows.")
        .holds([Line::formula(friction[1] / s.m, letter("ρy") / s.m, Sym::ZERO)]);
    page.claim("eq1.7", "vertical", r"$R_y - Y = \rho_1\sin\theta$, with the guide's normal force $Y$ and the rod's friction $\rho_1 = R_1-R'_1$ as they are combined")
        .follows([Equal(ry - of_guide, along * sin)]);

    // the length constraint: its row of the Jacobian times displacements
    let stretched = |[at_x, at_y, at_x1, at_y1]: [Sym; 4]| {
        let row = s.of_constraints(int(-1), Sym::ZERO);
        row[0] * at_x / s.m + row[1] * at_y / s.m + row[2] * at_x1 / s.m1 + row[3] * at_y1 / s.m1
    };
    page.claim(
        "eq1.8",
        "equal-projections",
        r"The displacements $\vec\rho\,\delta t/m$, $\vec\rho_1\delta t/m_1$ have equal projections on the rod",
    )
    .holds([Line::equation(stretched([rho, Sym::ZERO, rho1 * c, rho1 * sin]), rho / s.m * c, rho1 / s.m1)]);
    page.claim("eq1.8", "along-the-rod", r"Equal projections give $\rho_1 = \frac{m_1}{m}\rho\cos\theta$")
        .follows([Equal(along, s.m1 / s.m * friction[0] * c)]);
    let general = stretched([rx - rho1 * c, ry - y - rho1 * sin, rho1 * c, rho1 * sin]);
    page.claim(
        "eq1.9",
        "projections",
        "The equal projections of the displacements on the rod, expressed by the reactions, are (1.9)",
    )
    .holds([Line::equation(general, (rx * c + (ry - y) * sin - rho1) / s.m, rho1 / s.m1)]);
    let with_vertical = general.substitute(&[(ry, y + rho1 * sin)]) * s.m;
    page.claim("eq1.10", "with-vertical", "The equal projections with the vertical balance (1.7) put in give (1.10)")
        .holds([Line::equation(with_vertical, rx * c + rho1 * sin.powi(2), (s.m / s.m1 + int(1)) * rho1)]);
    page.claim("eq1.11", "solved", r"The relation (1.10) collected in $\rho_1$ is (1.11)").holds([Line::equation(
        with_vertical,
        rx * c,
        (s.m / s.m1 + c.powi(2)) * rho1,
    )]);
    page.claim("eq1.12", "friction-along-the-rod", r"The friction $\rho_1$ at $M_1$, along the rod, is (1.12)")
        .holds([Line::formula(along, rho1, s.m1 * c / (s.m + s.m1 * c.powi(2)) * rx)]);
    page.claim("eq1.13", "friction-at-the-guide", r"The friction $\rho$ at $M$, along the guide, is (1.13)")
        .holds([Line::formula(friction[0], rho, s.m * rx / (s.m + s.m1 * c.powi(2)))]);
}

/// Claims on (1.14)-(1.17), with mu = R_x / (m + m1 cos^2).
fn components(page: &mut Page, s: &RodLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let normal = s.of_constraints(s.lambda1, s.lambda);
    let friction = s.friction();
    page.claim(
        "eq1.14",
        "constraint-at-m",
        r"The force of constraint at $M$ is (1.14), with $Y=\lambda$, $R'_1=\lambda_1$",
    )
    .holds([
        Line::formula(normal[0], letter("R′x"), -s.lambda1 * c),
        Line::formula(normal[1], letter("R′y"), s.lambda - s.lambda1 * sin),
    ]);
    page.claim(
        "eq1.15",
        "friction-at-m",
        r"The friction at $M$ is (1.15) with $\mu = R_x/(m+m_1\cos^2\theta)$, an acceleration here and a force in (1.1)",
    )
    .holds([Line::formula(friction[0], letter("ρx"), s.m * s.mu), Line::formula(friction[1], letter("ρy"), Sym::ZERO)]);
    page.claim("eq1.16", "constraint-at-m1", "The force of constraint at $M_1$ is (1.16)").holds([
        Line::formula(normal[2], letter("R′1x"), s.lambda1 * c),
        Line::formula(normal[3], letter("R′1y"), s.lambda1 * sin),
    ]);
    page.claim("eq1.17", "friction-at-m1", "The friction at $M_1$ is (1.17)").holds([
        Line::formula(friction[2], letter("ρ1x"), s.m1 * s.mu * c.powi(2)),
        Line::formula(friction[3], letter("ρ1y"), s.m1 * s.mu * c * sin),
    ]);
}

fn motion(page: &mut Page, s: &RodLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let [ddx, ddy, ddx1, ddy1] = letters(["ẍ", "ÿ", "ẍ1", "ÿ1"]);
    let newton = s.newton([ddx, ddy, ddx1, ddy1], s.friction());
    page.claim("eq1.18", "motion", "The equations of motion of both points by the extended method are (1.18)").holds([
        Line::equation(newton[0], s.m * ddx, -s.lambda1 * c + s.m * s.mu),
        Line::equation(newton[1], s.m * ddy, s.lambda - s.lambda1 * sin + s.m * s.g),
        Line::equation(newton[2], s.m1 * ddx1, s.lambda1 * c + s.m1 * c.powi(2) * s.mu),
        Line::equation(newton[3], s.m1 * ddy1, s.lambda1 * sin + s.m1 * s.mu * c * sin + s.m1 * s.g),
    ]);
    let place = letters(["x", "y", "x1", "y1"]);
    let [x, y, x1, y1] = place;
    let at = State { time: Sym::ZERO, place, velocity: [Sym::ZERO; 4] };
    let [length, _] = s.rod.constraints(&at).map(|constraint| constraint.value());
    page.claim("eq1.19", "constraints", "The rod on the guide $y=0$ keeps its length").defines([Line::equation(
        length + length,
        (x1 - x).powi(2) + (y1 - y).powi(2) - s.l.powi(2),
        Sym::ZERO,
    )]);
}
