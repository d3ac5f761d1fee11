//! Section 1.1, first part: Painleve's rod with his choice of virtual displacements, (1.1)-(1.5).

use super::alphabet::{exact, int, letter, letters};
use super::rod::RodLetters;
use claims::{Condition, Line, Page};
use symbolic::Sym;

use Condition::{Equal, NonZero, Positive, Zero};

pub fn claims(page: &mut Page, s: &RodLetters) {
    page.section("1.1. The rod, first choice of displacements");
    components(page, s);
    multipliers(page, s);
}

/// Painleve's friction force, with the symbol mu as its horizontal component at M.
fn friction(s: &RodLetters) -> [Sym; 4] {
    let mu = letter("μᴾ");
    let one = int(1);
    s.painleve([mu * (one + s.point.cos.powi(2)), Sym::ZERO, Sym::ZERO]).of_friction
}

fn components(page: &mut Page, s: &RodLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let mu = letter("μᴾ");
    let normal = s.of_constraints(s.lambda1, s.lambda);
    let friction = friction(s);
    page.claim("eq1.1", "components", r"The forces of constraint and of friction at $M$ are (1.1), where $\mu$ is the horizontal force of friction there and $R_x = \mu(1+\cos^2\theta)$")
        .holds([
            Line::formula(normal[1], letter("R′y"), -s.lambda1 * sin + s.lambda),
            Line::formula(normal[0], letter("R′x"), -s.lambda1 * c),
            Line::formula(friction[1], letter("ρy"), Sym::ZERO),
            Line::formula(friction[0], letter("ρx"), mu),
        ]);
    page.claim("eq1.2", "components", "The forces of constraint and of friction at $M_1$ are (1.2)").holds([
        Line::formula(normal[3], letter("R′1y"), s.lambda1 * sin),
        Line::formula(normal[2], letter("R′1x"), s.lambda1 * c),
        Line::formula(friction[3], letter("ρ1y"), mu * sin * c),
        Line::formula(friction[2], letter("ρ1x"), mu * c.powi(2)),
    ]);
    let [ddx, ddx1] = letters(["ẍ", "ẍ1"]);
    let ddy1 = letter("ÿ1");
    let newton = s.newton([ddx, Sym::ZERO, ddx1, ddy1], friction);
    page.claim("eq1.3", "motion", "The equations of motion of both points by Painlevé's displacements are (1.3)")
        .holds([
            Line::equation(newton[0], s.m * ddx, mu - s.lambda1 * c),
            Line::equation(-newton[1], s.m * s.g + s.lambda - s.lambda1 * sin, Sym::ZERO),
            Line::equation(newton[3], s.m1 * ddy1, s.m1 * s.g + s.lambda1 * sin + mu * sin * c),
            Line::equation(newton[2], s.m1 * ddx1, s.lambda1 * c + mu * c.powi(2)),
        ]);
}

fn multipliers(page: &mut Page, s: &RodLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let mu = letter("μᴾ");
    let one = int(1);
    let friction = friction(s);
    let (masses, weights) = ([s.m, s.m, s.m1, s.m1], s.given_force());
    let normal = s.of_constraints(s.lambda1, s.lambda1 * sin - s.m * s.g);
    let accelerations = std::array::from_fn(|i| (weights[i] + normal[i] + friction[i]) / masses[i]);
    // the second derivative of the length, for the accelerations of (1.3)
    let derived = s.stretch(accelerations) * s.m1 / s.l;
    let left = |inertia: Sym| s.lambda1 * (one + s.m1 / s.m * c.powi(2)) + s.m1 * (s.g * sin + inertia);
    let right = mu * (s.m1 / s.m - one) * c;
    page.claim("eq1.4", "multiplier",r"(1.4), the relation for $\lambda_1$, holds as printed, with $\dot\theta^2$").reading(r"The source prints $m_2/m$ in front of $\cos^2\theta$. This problem has no $m_2$, so $m_1$ is read.").why(r"The factor $l$ is missing in front of $\dot\theta^2$. The printed sum adds an acceleration and the square of an angular velocity.")
        .fails([Line::equation(derived, left(s.dtheta.powi(2)), right)]);
    page.claim(
        "eq1.4",
        "multiplier-corrected",
        r"(1.4), the relation for $\lambda_1$, holds with $l\dot\theta^2$ and $m_1$ throughout",
    )
    .holds([Line::equation(derived, left(s.l * s.dtheta.powi(2)), right)]);
    page.correct();

    let equal = [(s.m1, s.m)];
    let derived = s.multipliers(friction)[0].substitute(&equal);
    page.claim(
        "eq1.5",
        "equal-masses",
        r"(1.5), the multiplier $\lambda_1$ for $m=m_1$, holds as printed, without $m$ and $l$",
    )
    .why(r"The factors $m$ and $l$ are missing, so that the printed right side is no force.")
    .fails([Line::formula(derived, s.lambda1, -((s.dtheta.powi(2) + s.g * sin) / (one + c.powi(2))))]);
    page.claim(
        "eq1.5",
        "equal-masses-corrected",
        r"(1.5), the multiplier $\lambda_1$ for $m=m_1$, holds with the factors $m$ and $l$",
    )
    .holds([Line::formula(derived, s.lambda1, -(s.m * (s.l * s.dtheta.powi(2) + s.g * sin) / (one + c.powi(2))))]);
    page.correct();

    let [lambda1, lambda] = s.multipliers(friction);
    page.claim(
        "section1.1-painleve",
        "dependence",
        r"Painlevé's displacements give $\partial\lambda_1/\partial\mu$ and $\partial\lambda/\partial\mu$ as follows",
    )
    .follows([
        Equal(lambda1.diff(mu), (s.m1 - s.m) * c / s.mobile()),
        Equal(lambda.diff(mu), (s.m1 - s.m) * c * sin / s.mobile()),
    ]);
    page.claim(
        "section1.1-painleve",
        "equal-masses",
        "With $m=m_1$ the multipliers do not depend on friction, and equal those without friction",
    )
    .in_words()
    .follows([lambda1, lambda].map(|multiplier| {
        let smooth = multiplier.substitute(&[(mu, Sym::ZERO)]);
        Equal(multiplier.substitute(&equal), smooth.substitute(&equal))
    }));
    let upright = exact([("m", 1, 1), ("m1", 2, 1), ("cos θ", 0, 1), ("sin θ", 1, 1)]);
    let premises = [Positive(s.m), Positive(s.m1), Zero((s.m1 - s.m) * c / s.mobile())];
    page.claim(
        "section1.1-painleve",
        "only-equal-masses",r"As printed, $\lambda_1$ is free of friction with equal masses only, so that $\partial\lambda_1/\partial\mu=0$ at one position gives $m=m_1$",
    ).why(r"At the upright rod, $\cos\theta=0$, the derivative vanishes for any masses. As a statement about all positions the sentence is right.")
    .given(premises)
    .refuted([Equal(s.m1, s.m)], upright);
    page.claim(
        "section1.1-painleve",
        "only-equal-masses-corrected",
        r"$\partial\lambda_1/\partial\mu=0$ at one position, where $\cos\theta\ne0$, gives $m=m_1$",
    )
    .given(premises)
    .given([NonZero(c)])
    .by_combination([(Equal(s.m1, s.m), vec![3], vec![(2, s.mobile())])]);
    page.correct();
}
