//! Section 1.3, task 1: equations of motion and multipliers of the steered rod, (1.83)-(1.91).

use super::alphabet::{exact, int, letters, tidy};
use super::steered::SteeredLetters;
use claims::{Condition, Line, Page};
use mechanics::constrained::rates::rates;
use mechanics::constrained::{Constrained, State};
use symbolic::Sym;

use Condition::{Equal, NonZero, Positive, Zero};

pub fn claims(page: &mut Page, s: &SteeredLetters) {
    page.section("1.3. Task 1, the multipliers");
    motion(page, s);
    differentiated(page, s);
    multipliers(page, s);
    painleve(page, s);
}

fn motion(page: &mut Page, s: &SteeredLetters) {
    let (c, sin, double) = (s.point.cos, s.point.sin, s.point + s.point);
    let (lambda, lambda1, lambda2, mu) = (s.lambda, s.lambda1, s.lambda2, s.mu);
    let second = letters(["ẍ1", "ÿ1", "ẍ2", "ÿ2"]);
    let newton = s.newton(second, s.friction());
    let masses = [s.m1, s.m1, s.m2, s.m2];
    let right = [
        -lambda1 * c - lambda2 * sin + s.m1 * mu + s.drive,
        s.m1 * s.g - lambda1 * sin + lambda2 * c + lambda,
        lambda1 * c - lambda2 * sin + s.m2 * mu * double.cos,
        s.m2 * s.g + lambda1 * sin + lambda2 * c + s.m2 * mu * double.sin,
    ];
    page.claim("eq1.83", "motion", "The equations of motion of both points of the steered rod are (1.83)")
        .holds((0..4).map(|i| Line::equation(newton[i], masses[i] * second[i], right[i])));
}

fn differentiated(page: &mut Page, s: &SteeredLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let place = letters(["x1", "y1", "x2", "y2"]);
    let velocity = letters(["ẋ1", "ẏ1", "ẋ2", "ẏ2"]);
    let second = letters(["ẍ1", "ÿ1", "ẍ2", "ÿ2"]);
    let at = State { time: Sym::ZERO, place, velocity };
    let ([x1, y1, x2, y2], [u1, v1, u2, v2], [a1, b1, a2, b2]) = (place, velocity, second);
    let [length, _, _] = s.rod.constraints(&at).map(|constraint| constraint.value());
    page.claim(
        "eq1.84",
        "constraints",
        "The rod keeps its length. The guide and the middle are those of (1.66) and (1.67)",
    )
    .defines([Line::equation(length + length, (x2 - x1).powi(2) + (y2 - y1).powi(2), s.l.powi(2))]);
    let [length, middle, _] = rates(&s.rod, &at, second);
    page.claim("eq1.85", "differentiated", r"(1.85) are the constraint of the length differentiated twice and that of the middle differentiated once, with $\ddot y_1=0$").holds([
        Line::equation(
            length,
            (x2 - x1) * (a2 - a1) + (b2 - b1) * (y2 - y1) + (u2 - u1).powi(2) + (v2 - v1).powi(2),
            Sym::ZERO,
        ),
        Line::equation(
            middle,
            (x2 - x1) * (b2 + b1) - (y2 - y1) * (a2 + a1) - int(2) * u1 * v2 + int(2) * u2 * v1,
            Sym::ZERO,
        ),
    ]);

    let (lambda, lambda1, lambda2) = (s.lambda, s.lambda1, s.lambda2);
    let guide = -s.newton([Sym::ZERO; 4], s.friction())[1];
    // on the guide lambda is such that y1'' = 0
    let kept = [(lambda, -s.m1 * s.g + lambda1 * sin - lambda2 * c)];
    let [length, middle, _] = s.differentiated(s.friction()).map(|rate| tidy(rate.substitute(&kept) / s.l));
    let inverse = |mass: Sym| int(1) / mass;
    page.claim(
        "eq1.86",
        "substituted",
        r"The differentiated constraints with the accelerations of (1.83) are (1.86), where $\mu$ drops out",
    )
    .holds([
        Line::equation(guide, s.m1 * s.g - lambda1 * sin + lambda2 * c + lambda, Sym::ZERO),
        Line::equation(
            length,
            (inverse(s.m2) + inverse(s.m1) * c.powi(2)) * lambda1 + inverse(s.m1) * lambda2 * sin * c,
            inverse(s.m1) * s.drive * c - (s.l * s.dtheta.powi(2) + s.g * sin),
        ),
        Line::equation(
            middle,
            inverse(s.m1) * c * sin * lambda1 + (inverse(s.m2) + inverse(s.m1) * sin.powi(2)) * lambda2,
            inverse(s.m1) * s.drive * sin + (int(2) * s.dx1 * s.dtheta - s.g) * c,
        ),
    ]);
    let right = inverse(s.m1) * s.drive * sin + (int(2) * s.dx1 * s.dtheta - s.g) * c;
    let [across, along] = [s.multipliers(s.friction())[1], s.multipliers(s.friction())[0]];
    let premises = [Equal(lambda1, along), Equal(lambda2, across), Positive(s.m1), Positive(s.m2), Positive(s.l)];
    page.claim("eq1.86", "third-zero",r#"The third line of (1.86) is printed with "= 0" after its right side"#).why(r#"The right side equals the left side $(\frac1{m_2}+\frac1{m_1}\sin^2\theta)\lambda_2+\dots$, which does not vanish; the "= 0" is a slip."#)
        .given(premises)
        .refuted(
            [Zero(right)],
            exact([
                ("m1", 1, 1),
                ("m2", 1, 1),
                ("l", 1, 1),
                ("g", 1, 1),
                ("X", 0, 1),
                ("ẋ1", 0, 1),
                ("θ̇", 0, 1),
                ("cos θ", 1, 1),
                ("sin θ", 0, 1),
                ("λ1", 0, 1),
                ("λ2", -1, 1),
            ]),
        );
    page.claim("eq1.86", "third-zero-corrected", "The right side of (1.86), third line, equals its left side")
        .in_words()
        .follows([Equal(
            inverse(s.m1) * c * sin * along + (inverse(s.m2) + inverse(s.m1) * sin.powi(2)) * across,
            right,
        )]);
    page.correct();
}

fn multipliers(page: &mut Page, s: &SteeredLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let (m1, m2, drive) = (s.m1, s.m2, s.drive);
    let derived = s.multipliers(s.friction());
    let turn = int(2) * s.dx1 * s.dtheta - s.g;
    let pull = s.l * s.dtheta.powi(2) + s.g * sin;
    let factor = m2 / (m1 * (m1 + m2));
    page.claim(
        "eq1.87",
        "solved",
        r"$\lambda_1$ and $\lambda_2$ are (1.87) by Lagrange's equations of the first kind, under friction of any size $\mu$",
    )
    .holds([
        Line::formula(
            derived[0],
            s.lambda1,
            factor * (m1 * drive * c - m1 * m2 * turn * c.powi(2) * sin - m1 * (m1 + m2 * sin.powi(2)) * pull),
        ),
        Line::formula(
            derived[1],
            s.lambda2,
            factor * (m1 * drive * sin + m1 * turn * c * (m1 + m2 * c.powi(2)) + m1 * m2 * pull * sin * c),
        ),
    ]);
    let weight = -(m1 + m2) * s.g;
    page.claim("eq1.88", "guide", r"$\lambda$, expressed by $\dot x_1$ and $\dot\theta$, is (1.88)").holds([
        Line::formula(
            derived[2],
            s.lambda,
            weight
                - m2 * (s.l * s.dtheta.powi(2) * sin + int(2) * s.dx1 * s.dtheta * c.powi(2)
                    - int(2) * s.g * c.powi(2)),
        ),
    ]);
    page.claim("eq1.88", "speed", r"The constraint of the middle expresses $\dot x_1$ by $\dot\theta$")
        .holds([Line::formula(s.speed(), s.dx1, s.l * s.dtheta / (int(2) * sin))]);
    let on_constraint = derived[2].substitute(&[(s.dx1, s.speed())]);
    let turn = s.l * s.dtheta.powi(2);
    page.claim("eq1.89", "guide", r"$\lambda$, expressed by $\dot\theta$ alone, is (1.89), in two steps").holds([
        Line::formula(
            on_constraint,
            s.lambda,
            weight - m2 * (turn * sin + turn / sin * c.powi(2) - int(2) * s.g * c.powi(2)),
        ),
        Line::formula(on_constraint, s.lambda, weight - m2 * (turn / sin - int(2) * s.g * c.powi(2))),
    ]);
    let [p] = letters(["μ1"]);
    let masses = [m1, m1, m2, m2];
    let field = s.motion().fields[0];
    let any = std::array::from_fn(|i| masses[i] * p * field[i]);
    page.claim(
        "eq1.89",
        "independent",
        r"The multipliers of the steered rod do not depend on friction $m_k\delta\vec r_k$, for any masses",
    )
    .follows(s.multipliers(any).map(|multiplier| Zero(multiplier.diff(p))));
}

/// Claims on (1.90)-(1.91): equations of motion and multipliers by Painleve's displacements, where mu is the friction
/// force at M1.
fn painleve(page: &mut Page, s: &SteeredLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let [mu, q] = letters(["μᴾ", "q"]);
    let friction = s.painleve([int(2) * mu, Sym::ZERO, Sym::ZERO, Sym::ZERO]).of_friction;
    let ratio = [(s.m2, s.m1 / q)];
    let derived = s.multipliers(friction.map(tidy)).map(|multiplier| tidy(multiplier.substitute(&ratio)));
    let turn = int(2) * s.dx1 * s.dtheta - s.g;
    let pull = s.l * s.dtheta.powi(2) + s.g * sin;
    let one = int(1);
    let across = (s.drive * q * sin + s.m1 * (pull * sin * c + turn * (q + c.powi(2)) * c)) / (q * (q + one));
    let along = (s.drive * q * c - s.m1 * (pull * (q + sin.powi(2)) + turn * c.powi(2) * sin)) / (q * (q + one));
    let share = (q - one) / (q + one) * mu;
    page.claim("eq1.90", "across",r"$\lambda_2$ by Painlevé's displacements, $q=m_1/m_2$, is (1.90) as printed, with $+(q-1)\mu$").reading(r"$\mu$ is read as the horizontal force of friction at $M_1$, as in (1.1). No other scale of $\mu$ makes both printed terms right, since those of $\lambda_1$ and $\lambda_2$ are as cosine to sine.").why(r"The derived term is $-\frac{q-1}{q+1}\mu\sin\theta$: sign, divisor and sine differ in the print.")
        .fails([Line::formula(derived[1], s.lambda2, across + (q - one) * mu)]);
    page.claim(
        "eq1.90",
        "across-corrected",
        r"$\lambda_2$ by Painlevé's displacements is (1.90) with $-\frac{q-1}{q+1}\mu\sin\theta$",
    )
    .holds([Line::formula(derived[1], s.lambda2, across - share * sin)]);
    page.correct();
    page.claim("eq1.91", "along",r"$\lambda_1$ by Painlevé's displacements is (1.91) as printed, with $-(q-1)\mu\sin\theta$").why(r"The derived term is $-\frac{q-1}{q+1}\mu\cos\theta$: the divisor is missing, and sine stands where cosine should stand.")
        .fails([Line::formula(derived[0], s.lambda1, along - (q - one) * sin * mu)]);
    page.claim(
        "eq1.91",
        "along-corrected",
        r"$\lambda_1$ by Painlevé's displacements is (1.91) with $-\frac{q-1}{q+1}\mu\cos\theta$",
    )
    .holds([Line::formula(derived[0], s.lambda1, along - share * c)]);
    page.correct();
    let at_guide = derived[2].diff(mu);
    page.claim(
        "eq1.91",
        "at-the-guide",r"As printed, $\lambda$ depends on $\mu$ by Painlevé's displacements: $\partial\lambda/\partial\mu\ne0$ for unequal masses",
    )
    .why(r"The two terms in $\mu$ cancel in $\lambda = -m_1g+\lambda_1\sin\theta-\lambda_2\cos\theta$.")
    .given([Positive(s.m1), Positive(q), NonZero(q - one)])
    .refuted([NonZero(tidy(at_guide))], exact([("m1", 1, 1), ("q", 2, 1), ("cos θ", 3, 5), ("sin θ", 4, 5)]));
    page.claim("eq1.91", "at-the-guide-corrected",r"$\partial\lambda/\partial\mu=0$ for all masses. $\lambda_1$ and $\lambda_2$ depend on $\mu$, but $\lambda = -m_1g+\lambda_1\sin\theta-\lambda_2\cos\theta$ does not")
        .follows([Zero(at_guide)]);
    page.correct();
    let size = derived[0].diff(mu).powi(2) + derived[1].diff(mu).powi(2);
    page.claim("eq1.91", "equal-masses",r"The squares of $\partial\lambda_1/\partial\mu$ and $\partial\lambda_2/\partial\mu$ add up to $\left(\frac{q-1}{q+1}\right)^2$, so that both vanish for $q=1$ alone")
        .follows([Equal(size, ((q - one) / (q + one)).powi(2))]);
}
