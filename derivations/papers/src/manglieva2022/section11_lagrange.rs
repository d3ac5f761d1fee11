//! Section 1.1, last part: Lagrange's equations of the second kind for the rod, (1.30)-(1.42).

use super::alphabet::{exact, int, letter, letters, tidy};
use super::rod::{Released, RodLetters};
use claims::{Condition, Line, Page};
use field::{Analytic, Tangent};
use mechanics::constrained::motion::Motion;
use mechanics::constrained::second_kind;
use mechanics::constrained::{Constrained, Constraint, PointSystem, State, kinetic_energy};
use mechanics::differentiate::gradient;
use symbolic::{Hypotheses, Sym};

use Condition::{Equal, Positive, Zero};

pub fn claims(page: &mut Page, s: &RodLetters) {
    page.section("1.1. The rod, Lagrange's equations");
    energy(page, s);
    equations(page, s);
    released(page, s);
    pendulum(page, s);
    reactions(page, s);
}

fn energy(page: &mut Page, s: &RodLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let place = letters(["x", "y", "x1", "y1"]);
    let [x, y, x1, y1] = place;
    let at = State { time: Sym::ZERO, place, velocity: [Sym::ZERO; 4] };
    let [length, _] = s.rod.constraints(&at).map(|constraint| constraint.value());
    page.claim("eq1.30", "constraints", "With the guide $y=0$ put in, the rod keeps its length").defines([
        Line::equation((length + length).substitute(&[(y, Sym::ZERO)]), (x1 - x).powi(2) + y1.powi(2), s.l.powi(2)),
    ]);
    let chart = [s.x, Sym::ZERO, s.x + s.l * c, s.l * sin];
    let closed: [Constraint<Sym>; 2] = s.rod.constraints(&State { place: chart, ..at });
    page.claim("eq1.31", "chart", r"$x_1 = x+l\cos\theta$, $y_1 = l\sin\theta$ satisfy the constraints identically")
        .in_words()
        .follows(closed.map(|constraint| Zero(constraint.value())));

    let derived = kinetic_energy(s.rod.masses(), s.motion().state.velocity);
    let (half, t) = (Sym::constant(field::Rational::new(1, 2)), letter("T"));
    let (dx, turn) = (s.dx, s.dtheta);
    page.claim("eq1.32", "kinetic-energy", "The kinetic energy is (1.32), as a sum over the points and collected")
        .holds([
            Line::formula(
                derived,
                t,
                half * s.m * dx.powi(2)
                    + half * s.m1 * ((dx - s.l * sin * turn).powi(2) + s.l.powi(2) * c.powi(2) * turn.powi(2)),
            ),
            Line::formula(
                derived,
                t,
                half * (s.m1 + s.m) * dx.powi(2) + half * s.m1 * s.l.powi(2) * turn.powi(2)
                    - s.m1 * s.l * dx * turn * sin,
            ),
        ]);
    let [by_dx, by_turn] = gradient(|p| velocity_energy(s, [s.x, s.theta].map(Tangent::fixed), p), [dx, turn]);
    let [by_x, by_theta] = gradient(|q| velocity_energy(s, q, [dx, turn].map(Tangent::fixed)), [s.x, s.theta]);

    let work = |force: [Sym; 4]| s.motion().generalised(force);
    let [_, weight] = work(s.given_force());
    let [friction, turning] = work(s.friction());
    page.claim("eq1.33", "generalised-forces", "The generalised forces of the weights and of friction are (1.33)")
        .holds([
            Line::formula(weight, letter("Qθ"), s.m1 * s.g * s.l * c),
            Line::formula(friction, letter("Qτx"), s.mu * (s.m + s.m1 * c.powi(2))),
            Line::formula(turning, letter("Qτθ"), Sym::ZERO),
        ]);
    page.claim(
        "eq1.34",
        "momentum",
        r"The derivative $\partial T/\partial\dot x$ of the kinetic energy (1.32) is that of (1.34)",
    )
    .holds([Line::formula(by_dx, letter("∂T/∂ẋ"), (s.m + s.m1) * dx - s.m1 * s.l * turn * sin)]);
    page.claim("eq1.34", "cyclic", r"The kinetic energy (1.32) does not contain $x$: $\partial T/\partial x = 0$")
        .follows([Zero(by_x)]);
    page.claim("eq1.36", "momentum", r"The derivatives $\partial T/\partial\dot\theta$ and $\partial T/\partial\theta$ of the kinetic energy (1.32) are those of (1.36)").holds([
        Line::formula(by_turn, letter("∂T/∂θ̇"), s.m1 * s.l.powi(2) * turn - s.m1 * s.l * dx * sin),
        Line::formula(by_theta, letter("∂T/∂θ"), -(s.m1 * s.l * dx * turn * c)),
    ]);
}

/// The kinetic energy T along the chart over dual numbers.
fn velocity_energy(s: &RodLetters, q: [Tangent<Sym>; 2], p: [Tangent<Sym>; 2]) -> Tangent<Sym> {
    let velocity = mechanics::constrained::motion::velocity(&s.rod, Tangent::fixed(Sym::ZERO), q, p);
    kinetic_energy(s.rod.masses(), velocity)
}

fn equations(page: &mut Page, s: &RodLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let (weights, friction) = (s.given_force(), s.friction());
    let at = (Sym::ZERO, [s.x, s.theta], [s.dx, s.dtheta]);
    let force = std::array::from_fn(|i| weights[i] + friction[i]);
    let second_kind = second_kind::residual(&s.rod, at, force, [s.ddx, s.ddtheta]);
    // by d'Alembert's principle the constraint forces do no work along the chart
    let [along, turning] = s.motion().generalised(s.newton(s.acceleration(), friction));
    page.claim("eq1.34", "principle", r"Lagrange's equations hold with the generalised force of friction. They are the motion of the points with the forces of constraint eliminated ($x$, then $\theta$)")
        .follows([Equal(second_kind[0], along), Equal(second_kind[1], turning)]);
    let turn = s.dtheta.powi(2);
    page.claim("eq1.35", "sliding", "Lagrange's equation for $x$ is (1.35)").holds([Line::equation(
        along,
        (s.m + s.m1) * s.ddx - s.m1 * s.l * s.ddtheta * sin - s.m1 * s.l * turn * c,
        s.mu * (s.m + s.m1 * c.powi(2)),
    )]);
    let inertia = second_kind::residual(&s.rod, at, [Sym::ZERO; 4], [s.ddx, s.ddtheta])[1];
    let printed_left = s.m1 * s.l.powi(2) * s.ddtheta - s.m1 * s.l * s.ddx * sin;
    page.claim("eq1.36", "weight",r"The equation for $\theta$ is (1.36) as printed, with $mg\cos\theta\cdot l$ on the right and $\frac{d}{dt}\frac{\partial T}{\partial\dot\theta}-\frac{\partial T}{\partial\theta}$ on the left").why(r"The index of $m_1$ is missing: the weight of $M_1$ alone turns the rod.")
        .fails([Line::equation(turning, tidy(inertia), s.m * s.g * c * s.l)]);
    page.claim(
        "eq1.36",
        "weight-corrected",
        r"The equation for $\theta$ is (1.36) with $m_1g\cos\theta\cdot l$ on the right",
    )
    .holds([Line::equation(turning, printed_left, s.m1 * s.g * c * s.l)]);
    page.correct();
    page.claim("eq1.37", "turning", r"Lagrange's equation for $\theta$, divided by $m_1l$, is (1.37)")
        .holds([Line::equation(turning / (s.m1 * s.l), s.l * s.ddtheta - s.ddx * sin, s.g * c)]);
}

/// Claims on (1.38)-(1.39): the guide replaced by its reaction.
fn released(page: &mut Page, s: &RodLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let [y, dy, ddy] = letters(["y", "ẏ", "ÿ"]);
    let [rx, ry] = letters(["Rx", "Ry"]);
    let free = Released(s.rod.0);
    let motion = Motion::at(&free, Sym::ZERO, [s.x, y, s.theta], [s.dx, dy, s.dtheta]);
    let (half, turn) = (Sym::constant(field::Rational::new(1, 2)), s.dtheta);
    page.claim("eq1.38", "kinetic-energy", "The kinetic energy without the guide is that of (1.38)").holds([
        Line::formula(
            kinetic_energy(free.masses(), motion.state.velocity),
            letter("T"),
            half * (s.m + s.m1) * s.dx.powi(2)
                + half * (s.m + s.m1) * dy.powi(2)
                + half * s.m1 * s.l * turn * (s.l * turn + int(2) * dy * c - int(2) * s.dx * sin),
        ),
    ]);
    let weights = free.force(&motion.state);
    let [qx, qy, qtheta] = motion.generalised(weights);
    page.claim(
        "eq1.38",
        "generalised-forces",
        "The generalised forces of the weights without the guide are those of (1.38)",
    )
    .holds([
        Line::formula(qy, letter("Qy"), (s.m + s.m1) * s.g),
        Line::formula(qtheta, letter("Qθ"), s.m1 * s.g * s.l * c),
    ]);
    page.claim("eq1.38", "no-weight-along", r"The weights have no generalised force along $x$: $Q_x=0$")
        .follows([Zero(qx)]);
    let force = [weights[0] + rx, weights[1] + ry, weights[2], weights[3]];
    let at = (Sym::ZERO, [s.x, y, s.theta], [s.dx, dy, s.dtheta]);
    let derived = second_kind::residual(&free, at, force, [s.ddx, ddy, s.ddtheta]);
    let on_guide = derived.map(|residual| tidy(residual.substitute(&[(ddy, Sym::ZERO)])));
    let horizontal = (s.m + s.m1) * s.ddx - s.m1 * s.l * (s.ddtheta * sin + turn.powi(2) * c);
    let weight = (s.m + s.m1) * s.g + ry;
    let turning = s.m1 * s.l;
    for (equation, derived, lifted, tilted) in
        [("eq1.38", derived, (s.m + s.m1) * ddy, ddy * c), ("eq1.39", on_guide, Sym::ZERO, Sym::ZERO)]
    {
        let place = if equation == "eq1.38" { "without the guide is (1.38)" } else { "on the guide is (1.39)" };
        page.claim(equation, "horizontal", format!("The equation for $x$ {place}"))
            .holds([Line::equation(derived[0], horizontal, rx)]);
        let vertical = |centripetal: Sym| lifted + s.m1 * s.l * (s.ddtheta * c - centripetal);
        page.claim(equation, "vertical", format!("The equation for $y$ {place} as printed, with $l$ before the parentheses and inside them")).why(r"The factor $l$ stands twice in front of $\dot\theta^2$, so that the printed sum mixes $\ddot\theta$ with $l\dot\theta^2$.")
            .fails([Line::equation(derived[1], vertical(s.l * turn.powi(2) * sin), weight)]);
        let (slug, says) = (
            "vertical-corrected",
            format!(r"The equation for $y$ {place} with $\ddot\theta\cos\theta-\dot\theta^2\sin\theta$"),
        );
        page.claim(equation, slug, says).holds([Line::equation(derived[1], vertical(turn.powi(2) * sin), weight)]);
        page.correct();
        page.claim(equation, "turning", format!(r"The equation for $\theta$ {place}")).holds([Line::equation(
            derived[2] / turning,
            s.l * s.ddtheta + tilted - s.ddx * sin,
            s.g * c,
        )]);
    }
    page.claim("eq1.40", "sign",r"The law, printed $R_x = fR_y\operatorname{sign}\dot x$ with $\operatorname{sign}\dot x=-1$ for $\dot x>0$, brakes on a floor that pushes $M$ upwards").reading(r"The floor is judged. For a guide that holds $M$ down, $R_y>0$, the printed sign is right.").why(r"With $y$ downwards such a floor has $R_y<0$, so that the printed sign makes friction drive.")
        .given([Positive(s.f), Positive(s.dx), Positive(-ry), Equal(rx, -s.f * ry)])
        .refuted([Positive(-(rx * s.dx))], exact([("f", 1, 2), ("ẋ", 1, 1), ("Ry", -2, 1), ("Rx", 1, 1)]));
    let [normal, speed] = letters(["N", "v"]);
    page.claim("eq1.40", "sign-corrected",r"On a floor $R_x = fR_y$ for $\dot x=v>0$, and $-fR_y$ for $\dot x<0$. With $R_y=-N$ the power of friction is $-fNv$")
        .given([Positive(s.f), Positive(normal), Positive(speed)])
        .by_signs([Positive(-(s.f * -normal) * speed)]);
    page.correct();
}

/// Claims on (1.41): the angle from the vertical, theta = pi/2 - phi.
fn pendulum(page: &mut Page, s: &RodLetters) {
    let [phi, dphi, ddphi, sign] = letters(["φ", "φ̇", "φ̈", "ε"]);
    let unit = Hypotheses::none().rule(sign, 2, int(1));
    let point = phi.circle();
    let turned = [(s.point.cos, point.sin), (s.point.sin, point.cos), (s.dtheta, -dphi), (s.ddtheta, -ddphi)];
    let [_, turning] = s.motion().generalised(s.newton(s.acceleration(), [Sym::ZERO; 4]));
    let [rx, ry] = s.contact_by(s.acceleration());
    let derived = (rx + sign * s.f * ry).substitute(&turned);
    // the rate of the printed bracket along the motion
    let rate = |coupling: i64| {
        let [dx, spin] = [Tangent::moving(s.dx, s.ddx), Tangent::moving(dphi, ddphi)];
        let fixed = |value: Sym| Tangent::fixed(value);
        let cos = Tangent::moving(phi, dphi).circle().cos;
        (fixed(s.m + s.m1) * dx + fixed(int(coupling) * s.m1 * s.l) * spin * cos).slope
    };
    let load = |last: Sym| {
        sign * s.f * ((s.m + s.m1) * s.g + s.m1 * s.l * point.cos * dphi.powi(2) + s.m1 * s.l * point.sin * last)
    };
    page.claim("eq1.41", "sliding",r"The equation for $x$ with $\theta=\frac\pi2-\varphi$ is (1.41) as printed, with $-m_1l\dot\varphi\cos\varphi$ and $\sin\varphi\,\dot\varphi^2$, where $\varepsilon$ stands for $\operatorname{sign}\dot x$").why(r"There are two slips. $\dot\theta=-\dot\varphi$ reverses the sign of $m_1l\dot\varphi\cos\varphi$, and in $\sin\varphi\,\ddot\varphi$ a dot is missing.").note(r"The sign convention of (1.40) is right in (1.41), since the bracket is $-R_y$.")
        .under(&unit)
        .fails([Line::equation(derived, rate(-1), load(dphi.powi(2)))]);
    page.claim(
        "eq1.41",
        "sliding-corrected",r"The equation for $x$ is (1.41) with $\frac{d}{dt}[(m+m_1)\dot x+m_1l\dot\varphi\cos\varphi]$ and $\sin\varphi\,\ddot\varphi$",
    )
    .holds([Line::equation(derived, rate(1), load(ddphi))]);
    page.correct();
    page.claim("eq1.41", "turning", r"The equation for $\varphi$ is that of the elliptic pendulum").holds([
        Line::equation(
            -(turning.substitute(&turned) / (s.m1 * s.l)),
            s.l * ddphi + s.ddx * point.cos + s.g * point.sin,
            Sym::ZERO,
        ),
    ]);
}

fn reactions(page: &mut Page, s: &RodLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let [lambda1, lambda] = s.multipliers(s.friction());
    // x'' and theta'' of (1.35) and (1.37) in (1.39)
    let masses: [Sym; 4] = s.rod.masses();
    let (weights, friction) = (s.given_force(), s.friction());
    let normal = s.of_constraints(lambda1, lambda);
    let moved = std::array::from_fn(|i| (weights[i] + normal[i] + friction[i]) / masses[i]);
    let [rx, ry] = s.contact_by(moved).map(tidy);
    let along = [(s.lambda, lambda)];
    page.claim(
        "eq1.42",
        "by-multipliers",
        r"The reactions in (1.39), expressed by $\mu$ and $\lambda$ (here with its value (1.28)), are (1.42)",
    )
    .holds([
        Line::formula(rx, letter("Rx"), s.mu * (s.m + s.m1 * c.powi(2))),
        Line::formula(ry, letter("Ry"), (s.m1 * s.mu * sin * c + s.lambda).substitute(&along)),
    ]);
    let [name] = letters(["Ry"]);
    page.claim(
        "eq1.42",
        "one-sided","As printed, a one-sided guide holds while $R_y>0$. The condition is judged for a floor with the rod at rest, upright or hanging",
    ).reading(r#"The source says "one-sided" without the side. A floor is judged."#).why(r"The axis $y$ points downwards: $R_y>0$ is the condition for a guide above $M$, which pushes it down. A floor at rest has $R_y=-(m+m_1)g$.")
    .given([Positive(s.m), Positive(s.m1), Positive(s.g), Equal(name, -(s.m + s.m1) * s.g)])
    .refuted([Positive(name)], exact([("m", 1, 1), ("m1", 1, 1), ("g", 1, 1), ("Ry", -2, 1)]));
    let smooth = s.multipliers([Sym::ZERO; 4])[1];
    let at_rest = [(s.dtheta, Sym::ZERO), (c, Sym::ZERO)];
    page.claim(
        "eq1.42",
        "one-sided-corrected",
        "A floor holds while its upward push $-R_y$ is positive. For the rod at rest that push is $(m+m_1)g$",
    )
    .follows([Equal(-smooth.substitute(&at_rest), (s.m + s.m1) * s.g)]);
    page.correct();
}
