//! Section 1.1, third part: Coulomb's law and the multipliers of the rod, (1.20)-(1.29).

use super::alphabet::{exact, int, letter, letters};
use super::rod::RodLetters;
use claims::{Condition, Line, Page};
use mechanics::constrained::rates::rates;
use mechanics::constrained::{Constrained, Constraint, PointSystem, State};
use symbolic::{Hypotheses, Sym};

use Condition::{Equal, NonZero, Positive, Zero};

pub fn claims(page: &mut Page, s: &RodLetters) {
    page.section("1.1. The rod, Coulomb's law");
    law(page, s);
    multipliers(page, s);
    eliminated(page, s);
}

/// Claims on (1.20)-(1.23). y points downwards: a supporting floor makes R_y negative.
fn law(page: &mut Page, s: &RodLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let [name_x, name_y] = letters(["Rx", "Ry"]);
    let [rx, ry] = s.contact();
    page.claim(
        "eq1.20",
        "coulomb",
        r"Coulomb's law for the contact of $M$ with its guide is $|R_x| = f|R_y|$, here squared, where $\mu$ is directed against $\dot x$",
    )
    .defines([Line::equation(Sym::ZERO, name_x.powi(2), s.f.powi(2) * name_y.powi(2))]);
    page.claim(
        "eq1.21",
        "by-multipliers",
        r"The components $R_x$ and $R_y$ of the law, expressed by $\lambda$ and $\mu$, are (1.21)",
    )
    .holds([
        Line::formula(rx, name_x, s.mu * (s.m + s.m1 * c.powi(2))),
        Line::formula(ry, name_y, s.lambda + s.m1 * sin * c * s.mu),
    ]);

    let lambda = s.multipliers(s.friction())[1];
    let coupling = s.m1 * sin * c * s.f;
    let denominator = |sign: i64| s.m1 * c.powi(2) + int(sign) * coupling + s.m;
    let ways = [
        ("eq1.22", 1, "sliding-forward", "sliding-forward-corrected", r"$\dot x>0$"),
        ("eq1.23", -1, "sliding-back", "sliding-back-corrected", r"$\dot x<0$"),
    ];
    for (equation, way, slug, corrected, when) in ways {
        let way_of = int(way);
        // the mirror image for backward sliding: M1 is on the other side, and both examples are equivalent
        let at = exact([
            ("m", 1, 1),
            ("m1", 1, 1),
            ("l", 1, 1),
            ("g", 1, 1),
            ("f", 1, 2),
            ("θ̇", 0, 1),
            ("ẋ", way, 1),
            ("cos θ", 3 * way, 5),
            ("sin θ", 4, 5),
            ("λ", -25, 17),
            ("μ", -625 * way, 952),
        ]);
        page.claim(equation, slug, format!(r"For {when} on a floor that pushes $M$ upwards, the friction $\mu$ is ({}) as printed, with the sign of a guide above", equation.trim_start_matches("eq")))
            .why("On a floor the printed sign makes friction push along the velocity.")
            .reading("The source does not say from which side the guide holds $M$. A floor is judged, $R_y<0$ with $y$ downwards. For a guide that holds $M$ down the printed formula is right.")
            .given([
                Positive(s.f), Positive(way_of * s.dx), Positive(-(rx * way_of)), Positive(-ry),
                Equal(rx.powi(2), s.f.powi(2) * ry.powi(2)), Equal(s.lambda, lambda),
            ])
            .refuted([Equal(s.mu, -way_of * s.f * s.lambda / denominator(way))], at);
        page.claim(
            equation,
            corrected,
            format!(
                r"For {when} on a floor that pushes, $R_y<0$, the reactions $R_x$ and $R_y$ have {} sign",
                if way > 0 { "one" } else { "opposite" }
            ),
        )
        .given([
            Equal(rx.powi(2), s.f.powi(2) * ry.powi(2)),
            Positive(-way_of * (rx + way_of * s.f * ry)),
            NonZero(denominator(-way)),
        ])
        .by_combination([(
            Equal(s.mu, way_of * s.f * s.lambda / denominator(-way)),
            vec![1, 2],
            vec![(0, -way_of)],
        )]);
        page.correct();
    }
    let reaction = |way: i64| ry.substitute(&[(s.mu, int(way) * s.f * s.lambda / denominator(-way))]);
    page.claim("eq1.23", "pushing", r"With the corrected $\mu$ the floor pushes, $R_y<0$, where $\lambda$ and the denominator have different signs. The values of $R_y$ are those for $\dot x>0$ and $\dot x<0$")
        .follows([1, -1].map(|way| Equal(reaction(way), s.lambda * s.mobile() / denominator(-way))));
    page.claim("eq1.23", "paradox",r"For a rod of positive masses $m+m_1\cos^2\theta < f m_1\sin\theta\cos\theta$ is possible. In an example where $M$ slides forward the law $R_x=fR_y$ needs a floor that pulls, and $R_x=-fR_y$ a guide above that pulls").note(r"This is Painlevé's paradox.")
        .given([Positive(s.m), Positive(s.m1), Positive(s.f), Positive(s.g), Equal(s.lambda, lambda)])
        .exists(
            [Positive(-denominator(-1)), Positive(reaction(1)), Positive(-reaction(-1))],
            exact([
                ("m", 1, 1), ("m1", 100, 1), ("l", 1, 1), ("g", 1, 1), ("f", 1, 1), ("θ̇", 0, 1),
                ("cos θ", 3, 5), ("sin θ", 4, 5), ("λ", -101, 37),
            ]),
        );
}

/// Claims on (1.24)-(1.28) and the statements on them.
fn multipliers(page: &mut Page, s: &RodLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let place = [s.x, Sym::ZERO, s.x + s.l * c, s.l * sin];
    let at = State { time: Sym::ZERO, place, velocity: [Sym::ZERO; 4] };
    let closed: [Constraint<Sym>; 2] = s.rod.constraints(&at);
    page.claim(
        "eq1.24",
        "chart",
        r"$x_1 = x+l\cos\theta$, $y_1 = l\sin\theta$, $y=0$ satisfy the constraints (1.19) identically",
    )
    .reading(r"The source prints $y=l\sin\theta$ next to $y=0$. The index is missing, and $y_1=l\sin\theta$ is read.")
    .in_words()
    .follows(closed.map(|constraint| Zero(constraint.value())));
    let friction = s.friction();
    let balance = s.newton(s.acceleration(), friction)[1];
    page.claim("eq1.25", "guide", "The second equation (1.18) on the guide is (1.25)").holds([Line::equation(
        -balance,
        s.lambda - s.lambda1 * sin + s.m * s.g,
        Sym::ZERO,
    )]);
    differentiated(page, s);

    let [lambda1, lambda] = s.multipliers(friction);
    let tension = (s.l * s.dtheta.powi(2) + s.g * sin) * s.m * s.m1 / (s.m + s.m1 * c.powi(2));
    page.claim(
        "eq1.27",
        "along-the-rod",
        r"$\lambda_1$ is (1.27) by Lagrange's equations of the first kind, under friction of any size $\mu$",
    )
    .holds([Line::formula(lambda1, s.lambda1, -tension)]);
    page.claim(
        "eq1.28",
        "at-the-guide",
        r"$\lambda$ is (1.28) by Lagrange's equations of the first kind, under friction of any size $\mu$",
    )
    .holds([Line::formula(lambda, s.lambda, -s.m * s.g - tension * sin)]);

    let [p, q] = letters(["μ1", "μ2"]);
    let motion = s.motion();
    let masses: [Sym; 4] = s.rod.masses();
    let any = std::array::from_fn(|i| masses[i] * (p * motion.fields[0][i] + q / s.l * motion.fields[1][i]));
    page.claim("section1.1-extended", "multipliers", r"With the extended method $\lambda$ and $\lambda_1$ never depend on friction. The friction here is $m_k\delta\vec r_k$ along any virtual displacement (two magnitudes), and the masses are arbitrary")
        .follows(s.multipliers(any).into_iter().flat_map(|multiplier| [Zero(multiplier.diff(p)), Zero(multiplier.diff(q))]));
    let [_, ry] = s.contact();
    page.claim("section1.1-extended", "normal-reaction",r"The guide's own normal reaction $R_y = \lambda + m_1\mu\sin\theta\cos\theta$ depends on friction. It equals $\lambda$ only without friction, or with the rod along or across the guide")
        .follows([Equal(ry - s.lambda, s.m1 * s.mu * sin * c)]);
}

/// Claims on (1.26) and the preceding lines.
fn differentiated(page: &mut Page, s: &RodLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let place = letters(["x", "y", "x1", "y1"]);
    let velocity = letters(["ẋ", "ẏ", "ẋ1", "ẏ1"]);
    let acceleration = letters(["ẍ", "ÿ", "ẍ1", "ÿ1"]);
    let [derived, _] = rates(&s.rod, &State { time: Sym::ZERO, place, velocity }, acceleration);
    let from = |of: [Sym; 4]| [of[2] - of[0], of[3] - of[1]];
    let ([x, y], [dx, dy], [ddx, ddy]) = (from(place), from(velocity), from(acceleration));
    page.claim("eq1.26", "differentiated", "The constraint of the length, differentiated twice, gives (1.26)")
        .holds([Line::equation(derived, x * ddx + y * ddy + dx.powi(2) + dy.powi(2), Sym::ZERO)]);

    let (masses, weights, friction): ([Sym; 4], _, _) = (s.rod.masses(), s.given_force(), s.friction());
    let normal = s.of_constraints(s.lambda1, s.lambda1 * sin - s.m * s.g);
    let derived = s.stretch(std::array::from_fn(|i| (weights[i] + normal[i] + friction[i]) / masses[i]));
    let (l, lambda1, mu, turn) = (s.l, s.lambda1, s.mu, s.dtheta.powi(2));
    page.claim(
        "eq1.26",
        "substituted",
        "The length differentiated twice takes this form with the accelerations of (1.18)",
    )
    .holds([Line::equation(
        derived,
        l * c * (lambda1 / s.m1 * c + mu * c.powi(2) + lambda1 / s.m * c - mu)
            + l * sin * (lambda1 / s.m1 * sin + mu * sin * c + s.g)
            + l.powi(2) * c.powi(2) * turn
            + l.powi(2) * sin.powi(2) * turn,
        Sym::ZERO,
    )]);
    page.claim("eq1.26", "expanded", r"In the differentiated length, multiplied out, the terms in $\mu$ cancel").holds(
        [Line::equation(
            derived,
            l / s.m1 * lambda1 + l * c.powi(2) / s.m * lambda1 - l * mu * c * sin.powi(2)
                + l * sin.powi(2) * c * mu
                + l * sin * s.g
                + l.powi(2) * turn,
            Sym::ZERO,
        )],
    );
    page.claim(
        "eq1.26",
        "reduced",
        r"The differentiated length determines $\lambda_1$ once the terms in $\mu$ have cancelled",
    )
    .holds([Line::equation(
        derived,
        l * lambda1 * (int(1) / s.m1 + c.powi(2) / s.m) + l * sin * s.g + l.powi(2) * turn,
        Sym::ZERO,
    )]);
}

/// Claims on (1.29): the law in the equations of motion, with a sign epsilon.
fn eliminated(page: &mut Page, s: &RodLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let sign = letter("ε");
    let unit = Hypotheses::none().rule(sign, 2, int(1));
    let [lambda1, lambda] = s.multipliers(s.friction());
    let mu = s.mu_by_law(sign, lambda);
    let at_m = (s.of_constraints(lambda1, lambda)[0] + s.friction()[0].substitute(&[(s.mu, mu)])) / s.m;
    let factor = s.m1 * c.powi(2) - sign * s.f * s.m1 * sin * c + s.m;
    let pull = s.m1 * (s.l * s.dtheta.powi(2) + s.g * sin) / (s.m + s.m1 * c.powi(2));
    let right = |term: Sym| pull * (factor * c + term) - s.m * sign * s.f * s.g;
    let derived = factor * (s.ddx - at_m);
    page.claim(
        "eq1.29",
        "sliding",r"The equation for $x$ by the law $R_x = \varepsilon fR_y$ of (1.22)-(1.23) is (1.29) as printed, with $+m_1\varepsilon f\sin\theta$",
    ).why(r"The term $\varepsilon f\lambda$ brings $-m\varepsilon f\sin\theta$ into the bracket. The mass and the sign are wrong in the print.")
    .under(&unit)
    .fails([Line::equation(derived, factor * s.ddx, right(s.m1 * sign * s.f * sin))]);
    page.claim(
        "eq1.29",
        "sliding-corrected",
        r"The equation for $x$ by the law $R_x = \varepsilon fR_y$ is (1.29) with $-m\varepsilon f\sin\theta$",
    )
    .holds([Line::equation(derived, factor * s.ddx, right(-s.m * sign * s.f * sin))]);
    page.correct();

    let missing = s.newton(s.acceleration(), s.friction());
    let turning = s.motion().generalised(missing)[1] / (s.m1 * s.l);
    let left = s.l * s.ddtheta - s.ddx * sin;
    page.claim("eq1.29", "turning", r"The equation for $\theta$ is (1.29) as printed, with $-g\cos\theta$")
        .why(r"The sign of the weight is wrong: (1.37), which is right, has $+g\cos\theta$ with $y$ downwards.")
        .fails([Line::equation(turning, left, -s.g * c)]);
    page.claim("eq1.29", "turning-corrected", r"The equation for $\theta$ is (1.29) with $+g\cos\theta$, as in (1.37)")
        .holds([Line::equation(turning, left, s.g * c)]);
    page.correct();

    let [rx, ry] = letters(["Rx", "Ry"]);
    page.claim("eq1.29", "direction",r"Friction, printed $R_x=\varepsilon fR_y$ with $\varepsilon=-1$ for $\dot x>0$, brakes on a floor that pushes $M$ upwards").why(r"On a floor $R_y<0$, so that $\varepsilon=-1$ makes $R_x$ positive for $\dot x>0$: friction drives.")
        .given([Positive(s.f), Positive(s.dx), Positive(-ry), Equal(rx, -s.f * ry)])
        .refuted([Positive(-(rx * s.dx))], exact([("f", 1, 2), ("ẋ", 1, 1), ("Ry", -2, 1), ("Rx", 1, 1)]));
    let [normal, speed] = letters(["N", "v"]);
    page.claim(
        "eq1.29",
        "direction-corrected",r"$\varepsilon$ is the sign of the velocity, $\dot x=\varepsilon v$. With $R_y=-N$ the power of friction is $-fNv$",
    )
    .under(&unit)
    .given([Positive(s.f), Positive(normal), Positive(speed)])
    .by_signs([Positive(-(sign * s.f * -normal) * (sign * speed))]);
    page.correct();
}
