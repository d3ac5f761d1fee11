//! Section 3.1: the governor with a movable wheel, its equations, (3.1)-(3.6).

use super::alphabet::{exact, int, letters, tidy};
use super::governor::GovernorLetters;
use claims::{Condition, Line, Page};
use field::Scalar;
use mechanics::constrained::{Constrained, PointSystem};
use symbolic::Sym;

use Condition::{Equal, Positive, Zero};

pub fn claims(page: &mut Page, s: &GovernorLetters) {
    page.section("3.1. The governor with a movable wheel");
    constraints(page, s);
    energy(page, s);
    appell(page, s);
    reduced(page, s);
}

fn constraints(page: &mut Page, s: &GovernorLetters) {
    let [kept] = letters(["ω₀"]);
    page.claim(
        "eq3.1",
        "speed",
        r"(3.1) is the condition $\omega_2=\omega_2^0$ that the push on the wheel has to keep",
    )
    .defines([Line::equation(Sym::ZERO, s.speed, kept)]);
    let [w1, w2, w] = letters(["ω1", "ω2", "ω"]);
    let rolling = s.governor.constraints(&s.turning([w1, w2, w])).map(|constraint| constraint.value());
    page.claim("eq3.2", "rolling", r"The wheel does not slip at either contact").defines([
        Line::equation(rolling[4] - rolling[3], s.drum * w1, s.rho * w2),
        Line::equation(rolling[4], s.radius * w, s.rho * w2),
    ]);
}

fn energy(page: &mut Page, s: &GovernorLetters) {
    let [name] = letters(["S"]);
    let [[w1, dw1], [w2, dw2], [w, dw]] = s.spins();
    let discs = |wheel: Sym| {
        (s.first * (dw1.powi(2) + w1.powi(4))
            + s.second * (dw2.powi(2) + w2.powi(4))
            + s.wheel * (dw.powi(2) + w.powi(4))
            + s.mass * wheel.powi(2))
        .half()
    };
    page.claim(
        "eq3.3",
        "energy",
        r"The energy of accelerations is $S=\frac12\sum J(\dot\omega^2+\omega^4)+\frac12m\dot\rho^2$ as printed, with the speed of the wheel",
    )
    .reading(
        r"The source shows $\dot\rho$. As everywhere, a lost dot is judged as printed and restored in the correction.",
    )
    .why(r"A dot is missing: the energy of accelerations has $\frac12m\ddot\rho^2$.")
    .fails([Line::formula(s.acceleration_energy(), name, discs(s.drho))]);
    page.claim(
        "eq3.3",
        "energy-corrected",
        r"The energy of accelerations of the discs' mass points is $S=\frac12\sum J(\dot\omega^2+\omega^4)+\frac12m\ddot\rho^2$",
    )
    .holds([Line::formula(s.acceleration_energy(), name, discs(s.ddrho))]);
    page.correct();
    // Appell's equations contain only the derivatives of S with respect to the accelerations
    let seen = |energy: Sym| [tidy(energy.diff(s.dspeed)), energy.diff(s.ddrho)];
    let rim = s.drho * s.speed + s.rho * s.dspeed;
    let reduced =
        |wheel: Sym| (s.reduced() * rim.powi(2) + s.second * s.dspeed.powi(2) + s.mass * wheel.powi(2)).half();
    let derived = seen(s.acceleration_energy());
    let names = letters(["∂S/∂ω̇2", "∂S/∂ϱ̈"]);
    let lines = |wheel: Sym| {
        let printed = [reduced(wheel).diff(s.dspeed), tidy(reduced(wheel).diff(s.ddrho))];
        [0, 1].map(|i| Line::formula(derived[i], names[i], printed[i]))
    };
    page.claim("eq3.3", "reduced-energy",r"The derivatives by $\dot\omega_2$ and $\ddot\rho$ of $S$ with the constraints put in are those of the print, with $\frac12m\dot\rho^2$").why(r"A dot is missing, so that $\partial S/\partial\ddot\rho=0$: the inertia term $m\ddot\rho$ is missing.")
        .fails(lines(s.drho));
    page.claim(
        "eq3.3",
        "reduced-energy-corrected",
        r"The derivatives by $\dot\omega_2$ and $\ddot\rho$ of $S$ are those with $\frac12m\ddot\rho^2$",
    )
    .holds(lines(s.ddrho));
    page.correct();
}

fn appell(page: &mut Page, s: &GovernorLetters) {
    let motion = s.motion();
    let force: [Sym; 7] = s.governor.force(&motion.state);
    let work = motion.generalised(force);
    let [turn, push] = letters(["Qφ2", "Qρ"]);
    page.claim("eq3.3", "work", r"The elementary work of both shafts gives the generalised force of $\varphi_2$")
        .holds([Line::formula(work[0], turn, s.m2 + s.rho / s.drum * s.m1)]);
    page.claim("eq3.3", "work-on-wheel", r"The generalised force of $\rho$ is the push less the friction across")
        .defines([Line::formula(work[1], push, s.push - s.friction)]);
    let [condition, wheel] = s.kept();
    let right = s.m2 + s.rho / s.drum * s.m1;
    page.claim(
        "eq3.3",
        "equations",
        "Appell's equations with the speed kept are the condition, in two forms, and the equation of motion of the wheel",
    )
    .holds([
        Line::equation(
            condition,
            s.first / s.drum.powi(2) * (s.drho * s.speed * s.rho)
                + s.wheel / s.radius.powi(2) * (s.drho * s.speed * s.rho),
            right,
        ),
        Line::equation(condition, s.speed * s.rho * s.reduced() * s.drho, right),
        Line::equation(wheel, s.mass * s.ddrho, -s.friction + s.push),
    ]);
    // power: the rate of the bodies' kinetic energy along the equations
    let energy: Sym = mechanics::constrained::kinetic_energy(s.governor.masses(), motion.state.velocity);
    let rate = energy.diff(s.rho) * s.drho + energy.diff(s.speed) * s.dspeed + energy.diff(s.drho) * s.ddrho;
    let [turning, sliding] = s.balance();
    let power = (s.m2 + s.m1 * s.rho / s.drum) * s.speed + (s.push - s.friction) * s.drho;
    page.claim(
        "eq3.3",
        "power",
        "Kinetic energy changes at a rate equal to the power of torques, push and friction; with Appell's equations this is an identity",
    )
    .in_words()
    .follows([Equal(rate - power, turning * s.speed + sliding * s.drho)]);
}

fn reduced(page: &mut Page, s: &GovernorLetters) {
    let [k, k1, k2] = letters(["k", "k₁", "k₂"]);
    let square = s.radius.powi(2);
    page.claim("eq3.4", "names", "(3.4) defines the names $k$, $k_1(t)$, $k_2(t)$").defines([
        Line::equation(Sym::ZERO, k, s.speed * (s.wheel + s.first * square / s.drum.powi(2))),
        Line::equation(Sym::ZERO, k1, square * s.m2),
        Line::equation(Sym::ZERO, k2, square * s.m1 / s.drum),
    ]);
    let [condition, _] = s.kept();
    page.claim("eq3.5", "law", "The condition of the kept speed, expressed by $k$, $k_1$, $k_2$, is (3.5)")
        .under(&s.names())
        .holds([Line::equation(square * condition / s.rho, k * s.drho, k1 / s.rho + k2)]);
    let law = |rho: Sym| k1 / rho + k2;
    let third = law(s.rho).diff(s.rho).diff(s.rho).diff(s.rho);
    page.claim(
        "eq3.5",
        "riccati",r"As printed, (3.5) is Riccati's equation, whose right side is of the second degree in $\rho$ and has no third derivative",
    )
    .why(r"The right side is $k_1/\rho+k_2$, no polynomial in $\rho$.")
    .given([Positive(k1), Positive(s.rho)])
    .refuted([Zero(third)], exact([("k₁", 1, 1), ("ϱ", 1, 1)]));
    // with y = 1/rho: y' = -rho'/rho^2
    let y = int(1) / s.rho;
    page.claim(
        "eq3.5",
        "riccati-corrected",
        r"With $y=1/\rho$ (3.5) is Abel's equation of the first kind, $k\dot y=-k_1y^3-k_2y^2$",
    )
    .follows([Equal(-law(s.rho) / s.rho.powi(2), -k1 * y.powi(3) - k2 * y.powi(2))]);
    page.correct();
    let [epsilon] = letters(["εᵏ"]);
    let names = s.names();
    let drift: Sym = tidy(s.governor.programme(Sym::ZERO, s.rho, s.speed));
    let small = names.given(epsilon, int(1) / (s.speed * (s.wheel + s.first * square / s.drum.powi(2))));
    page.claim("eq3.6", "small-parameter", r"$\dot\rho$, expressed by $\varepsilon=1/k$, is (3.6)")
        .under(&small)
        .holds([Line::formula(drift, s.drho, epsilon * (k1 / s.rho + k2))]);
}
