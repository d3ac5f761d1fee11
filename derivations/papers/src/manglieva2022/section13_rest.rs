//! Section 1.3, task 1: equilibrium with friction, (1.100).

use super::alphabet::{exact, int, letter, letters, tidy};
use super::steered::SteeredLetters;
use claims::{Condition, Line, Page};
use symbolic::{Hypotheses, Sym};

use Condition::{Equal, Positive};

/// Claims on (1.100): the reactions of the guide in equilibrium.
pub fn claims(page: &mut Page, s: &SteeredLetters) {
    page.section("1.3. Task 1, rest");
    let (c, sin, double) = (s.point.cos, s.point.sin, s.point + s.point);
    let (m1, m2, g, drive) = (s.m1, s.m2, s.g, s.drive);
    let still = [(s.dx1, Sym::ZERO), (s.dtheta, Sym::ZERO)];
    let derived = s.multipliers(s.friction()).map(|multiplier| tidy(multiplier.substitute(&still)));
    let two = int(2);
    let factor = m2 / (m1 * (m1 + m2));
    let across = m1 * drive * sin - m1 * g * c * (m1 + m2 * c.powi(2)) + m1 * m2 * g * sin.powi(2) * c;
    page.claim("section1.3-static", "lambda-2", r"$\lambda_2$ at rest has the printed value").holds([Line::formula(
        derived[1],
        s.lambda2,
        factor * across,
    )]);
    let along = |way: i64| {
        let way = int(way);
        m1 * drive * c + way * (m1 * m2 * g * c.powi(2) * sin - m1 * (m1 + m2 * sin.powi(2)) * g * sin)
    };
    page.claim(
        "section1.3-static",
        "lambda-1",
        r"$\lambda_1$ at rest has the printed value, with the signs of the terms in $g$ reversed",
    )
    .why(r"The terms with $g$ have the opposite signs of (1.87), from which they come.")
    .fails([Line::formula(derived[0], s.lambda1, factor * along(-1))]);
    page.claim("section1.3-static", "lambda-1-corrected", r"$\lambda_1$ at rest has the signs of (1.87)")
        .holds([Line::formula(derived[0], s.lambda1, factor * along(1))]);
    page.correct();
    let weight = -(m1 + m2) * g + two * m2 * g * c.powi(2);
    page.claim("section1.3-static", "lambda", r"$\lambda$ at rest has the printed value")
        .holds([Line::formula(derived[2], s.lambda, weight)]);
    let pull = derived[0] * c + derived[1] * sin;
    page.claim("section1.3-static", "pull", r"$\lambda_1\cos\theta+\lambda_2\sin\theta$ at rest has the printed value")
        .follows([Equal(pull, m2 / (m1 + m2) * (drive - m1 * g * double.sin))]);

    // the friction that keeps M1 at rest, from the equation of motion without acceleration
    let [missing] = s.motion().generalised(s.newton([Sym::ZERO; 4], s.friction()));
    let mu = tidy(-(missing.substitute(&[(s.mu, Sym::ZERO)]) / tidy(missing.diff(s.mu))));
    page.claim(
        "section1.3-static",
        "friction",
        "The friction at $M_1$ that keeps the rod at rest has the printed value",
    )
    .holds([Line::formula(m1 * mu, m1 * s.mu, -(m1 / (m1 + m2) * (drive + m2 * g * double.sin)))]);
    page.claim(
        "section1.3-static",
        "by-multipliers",
        r"The friction that keeps the rod at rest is $\lambda_1\cos\theta+\lambda_2\sin\theta-X$",
    )
    .in_words()
    .follows([Equal(m1 * mu, pull - drive)]);
    let held = drive + m2 * g * double.sin;
    page.claim(
        "eq1.100",
        "inequality",
        r"The rod rests while $|R_x|\le f|\lambda|$. The data give both sides, which are squared here",
    )
    .follows([
        Equal(((m1 + m2) * mu).powi(2), held.powi(2)),
        Equal(derived[2].powi(2), ((m1 + m2) * g - two * m2 * g * c.powi(2)).powi(2)),
    ]);

    let sign = letter("ε");
    let [needed] = letters(["N"]);
    let name = s.lambda;
    let unit = Hypotheses::none().rule(sign, 2, int(1));
    page.claim("section1.3-static", "start",r"As printed, beyond (1.100) the friction $R_x=\varepsilon f\lambda$ has the direction of the force $N$ that rest would need. The sign $\varepsilon$ is opposite to $N$").why(r"That holds where the floor pushes, $\lambda<0$; at $\theta=0$ with $m_2>m_1$ the guide pulls, $\lambda>0$.")
        .given([
            Positive(s.f), Positive(m1), Positive(m2), Positive(g), Equal(name, weight), Equal(needed, -held),
            Positive(held.powi(2) - (s.f * name).powi(2)), Equal(sign.powi(2), int(1)), Positive(-(sign * needed)),
        ])
        .refuted([Positive(sign * s.f * name * needed)], exact([
            ("m1", 1, 1), ("m2", 2, 1), ("g", 1, 1), ("X", -1, 1), ("cos θ", 1, 1), ("sin θ", 0, 1),
            ("f", 1, 2), ("λ", 1, 1), ("ε", -1, 1), ("N", 1, 1),
        ]));
    let push = letter("Y");
    page.claim("section1.3-static", "start-corrected",r"Where the floor pushes, $\lambda=-Y<0$, and $N=-\varepsilon X$, $X>0$, friction $\varepsilon f\lambda$ has the direction of $N$").note(r"Where the guide pulls, the direction needs $\varepsilon$ to be the sign of $N$.")
        .under(&unit)
        .given([Positive(s.f), Positive(push), Positive(drive)])
        .by_signs([Positive((sign * s.f * -push) * -(sign * drive))]);
    page.correct();
}
