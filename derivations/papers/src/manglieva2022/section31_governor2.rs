//! Section 3.1: the second governor, whose wheel changes its distance from both axes.

use super::alphabet::{int, letters, tidy};
use super::governor::GovernorLetters;
use claims::{Condition, Line, Page};
use mechanics::constrained::newton::Reactions;
use mechanics::constrained::{Constrained, PointSystem};
use symbolic::Sym;
use systems::governor::between::{Between, Quadrature};

const ENTRY: &str = "section3.1-governor2";

pub fn claims(page: &mut Page, s: &GovernorLetters) {
    page.section("3.1. The governor between two discs");
    kinematics(page, s);
    contacts(page, s);
    motion(page, s);
    quadrature(page, s);
}

fn kinematics(page: &mut Page, s: &GovernorLetters) {
    let [w1, w2, w, dw1, dw] = letters(["ω1", "ω2", "ω", "ω̇1", "ω̇"]);
    let [.., first, second] = s.governor.constraints(&s.turning([w1, w2, w])).map(|constraint| constraint.value());
    let far = s.distance - s.rho;
    page.claim(ENTRY, "rolling", r"The wheel does not slip at either disc").defines([
        Line::equation(first, s.radius * w, s.rho * w1),
        Line::equation(second - first, s.rho * w1, far * w2),
    ]);
    let [[of_first, first], _, [of_wheel, wheel]] = s.spins();
    let kept = |rate: Sym| tidy(rate.substitute(&[(s.dspeed, Sym::ZERO)]));
    page.claim(
        ENTRY,
        "speeds",
        r"With $\omega_2$ kept, $\omega$, $\dot\omega$, $\omega_1$ and $\dot\omega_1$ (in both steps) have these values",
    )
    .holds([
        Line::formula(of_wheel, w, far / s.radius * s.speed),
        Line::formula(kept(wheel), dw, -s.speed / s.radius * s.drho),
        Line::formula(of_first, w1, s.speed * far / s.rho),
        Line::formula(kept(first), dw1, s.speed * (-s.drho * s.rho - far * s.drho) / s.rho.powi(2)),
        Line::formula(kept(first), dw1, -s.speed * s.distance * s.drho / s.rho.powi(2)),
    ]);
}

/// The residuals m x'' - X along the tangents of first disc, second disc and wheel, at the prescribed speed.
fn missing(s: &GovernorLetters) -> [Sym; 3] {
    let (masses, force): ([Sym; 7], [Sym; 7]) = (s.governor.masses(), s.governor.force(&s.motion().state));
    let acceleration = s.acceleration();
    [1, 3, 5].map(|i| tidy((masses[i] * acceleration[i] - force[i]).substitute(&[(s.dspeed, Sym::ZERO)])))
}

/// The contact forces F1, F2: the residual of each disc divided by the effect of a unit force on it.
fn contact_forces(s: &GovernorLetters) -> [Sym; 2] {
    let [.., first, second] = s.governor.reactions(&s.motion().state);
    let [on_first, on_second, _] = missing(s);
    [on_first / first[1], on_second / second[3]]
}

fn contacts(page: &mut Page, s: &GovernorLetters) {
    let [f1, f2, spin] = letters(["F₁", "F₂", "Jω̇"]);
    let [.., first, second] = s.governor.reactions(&s.motion().state);
    let [on_first, on_second, on_wheel] = missing(s);
    let far = s.distance - s.rho;
    page.claim(
        ENTRY,
        "discs",
        "The theorem of angular momentum for both discs contains the contacts' forces $F_1$ and $F_2$",
    )
    .holds([
        Line::equation(
            on_first - f1 * first[1],
            -s.speed * s.distance * s.drho / s.rho.powi(2) * s.first,
            s.m1 - f1 * s.rho,
        ),
        Line::equation(on_second - f2 * second[3], Sym::ZERO, s.m2 - f2 * far),
    ]);
    let pushed = f1 * first[5] + f2 * second[5];
    let inertia = -s.wheel * s.drho / s.radius * s.speed;
    page.claim(
        ENTRY,
        "wheel",
        r"The theorem of angular momentum for the wheel is $-J\frac{\dot\rho_1}r\omega_2=r(F_1+F_2)$",
    )
    .holds([Line::equation(on_wheel - pushed, inertia, s.radius * (f1 + f2))]);
    page.claim(
        ENTRY,
        "wheel-half",
        r"As printed, the middle of the chain for the wheel is $J\dot\omega=-\frac{J\omega_2}2\dot\rho_1$",
    )
    .why(r"The divisor $r$ is printed as 2.")
    .fails([Line::formula(on_wheel, spin, -s.wheel * s.speed / int(2) * s.drho)]);
    page.claim(
        ENTRY,
        "wheel-half-corrected",
        r"The middle of the chain for the wheel is $J\dot\omega=-\frac{J\omega_2}r\dot\rho_1$",
    )
    .holds([Line::formula(on_wheel, spin, -s.wheel * s.speed / s.radius * s.drho)]);
    page.correct();
    let [by_first, by_second] = contact_forces(s);
    page.claim(ENTRY, "forces", "The forces in the contacts are $F_2$ and $F_1$ as follows").holds([
        Line::formula(by_second, f2, s.m2 / far),
        Line::formula(by_first, f1, s.m1 / s.rho + s.speed * s.distance * s.drho / s.rho.powi(3) * s.first),
    ]);
}

fn motion(page: &mut Page, s: &GovernorLetters) {
    let far = s.distance - s.rho;
    let [condition, wheel] = s.kept();
    // Appell's condition for omega2 as a force at the wheel: divided by its lever arm about the second axis
    let derived = condition * s.radius / far;
    let pull = s.m2 / far + s.m1 / s.rho;
    let of_first = s.speed * s.distance * s.first / s.rho.powi(3);
    let printed = [
        (s.wheel * s.speed / s.radius * s.drho, s.radius * (pull - of_first * s.drho)),
        ((s.wheel * s.speed / s.radius + of_first * s.radius) * s.drho, s.radius * pull),
    ];
    page.claim(ENTRY, "equation",r"The equation of $\rho_1$ holds in both printed forms").why(r"The minus of $J\dot\omega=-J\omega_2\dot\rho_1/r$ is missing on the way: moments that drive make $\rho_1$ fall, so that $\omega_1$ grows.")
        .fails(printed.map(|(left, right)| Line::equation(-derived, left, right)));
    page.claim(ENTRY, "equation-corrected", r"Appell's equations give the equation of $\rho_1$ in both forms").holds([
        Line::equation(-derived, printed[0].0, -(s.radius * (pull + of_first * s.drho))),
        Line::equation(-derived, printed[1].0, -(s.radius * pull)),
    ]);
    page.correct();
    let [f, n1, n2, at1, at2] = letters(["fᶜ", "N₁", "N₂", "F₁₁", "F₂₂"]);
    // outward sliding: both contacts resist with f N
    let outwards = tidy(wheel.substitute(&[(at1, f * n1), (at2, f * n2)]));
    let normal = n1 + n2;
    page.claim(
        ENTRY,
        "wheel-axis",
        r"As printed, for $\dot\rho_1>0$ the wheel moves along its axis by $m\ddot\rho_1=u+f(N_1+N_2)$",
    )
    .why(r"Friction is against the motion, so its sign is wrong.")
    .fails([Line::equation(outwards, s.mass * s.ddrho, s.push + f * normal)]);
    page.claim(
        ENTRY,
        "wheel-axis-corrected",
        r"For $\dot\rho_1>0$ the wheel moves along its axis by $m\ddot\rho_1=u-f(N_1+N_2)$",
    )
    .holds([Line::equation(outwards, s.mass * s.ddrho, s.push - f * normal)]);
    page.correct();
}

/// Additional claims for constant torques: dt/drho of the quadrature and the programmed motion by Appell's equations.
fn quadrature(page: &mut Page, s: &GovernorLetters) {
    let drift = |with: [Sym; 2]| -> Sym {
        let drift: Sym = s.governor.programme(Sym::ZERO, s.rho, s.speed);
        tidy(drift.substitute(&[(s.m1, with[0]), (s.m2, with[1])]))
    };
    let Some(law) = s.governor.between(s.speed) else { return };
    let slow = |with: [Sym; 2], by: fn(&Between<Sym>) -> Quadrature<Sym>| {
        let law = Between { moments: with, ..law };
        Line::formula(int(1) / drift(with), int(1) / s.drho, law.slope(&by(&law), s.rho))
    };
    page.claim(ENTRY, "quadrature", r"Under constant torques $t$ is an elementary function of $\rho_1$, a sum of terms in $\rho_1$, $\rho_1^2$, $1/\rho_1$, $\ln\rho_1$ and $\ln|M_1(a-\rho_1)+M_2\rho_1|$. Its slope is $1/\dot\rho_1$").note(r"The quadrature holds for $M_1\ne0$, $M_1\ne M_2$.")
        .holds([slow([s.m1, s.m2], Between::general)]);
    page.claim(ENTRY, "quadrature-equal",r"With $M_1=M_2$ the time is a function of $\rho_1^2$, $\rho_1^3$, $1/\rho_1$ and $\ln\rho_1$. Its slope is $1/\dot\rho_1$")
        .holds([slow([s.m1, s.m1], Between::equal)]);
    page.claim(ENTRY, "quadrature-free",r"With $M_1=0$ the time is a function of $\rho_1$, $\rho_1^2$, $1/\rho_1$ and $1/\rho_1^2$. Its slope is $1/\dot\rho_1$")
        .holds([slow([Sym::ZERO, s.m2], Between::free_first)]);
    let far = s.distance - s.rho;
    let inertia = s.wheel * s.speed / s.radius + s.speed * s.distance * s.radius * s.first / s.rho.powi(3);
    let both = drift([s.m1, s.m2]);
    page.claim(ENTRY, "first-axis",r"The equation of $\rho_1$, multiplied by $(a-\rho_1)\rho_1^3$, is $\dot\rho_1(a-\rho_1)\left(J\omega_2\rho_1^3/r+J_1\omega_2ar\right)=-r\rho_1^2\left(M_1(a-\rho_1)+M_2\rho_1\right)$").note(r"Near the axis of the first disc $\dot\rho_1$ falls as $\rho_1^2$: the first shaft moves alone under its moment.")
        .in_words()
        .follows([Condition::Equal(
            both * (s.wheel * s.speed * s.rho.powi(3) / s.radius + s.speed * s.distance * s.radius * s.first) * far,
            -(s.radius * s.rho.powi(2) * (s.m1 * far + s.m2 * s.rho)),
        )]);
    page.claim(ENTRY, "second-axis",r"The equation of $\rho_1$, multiplied by $a-\rho_1$, is $(a-\rho_1)\dot\rho_1\left(J\omega_2/r+J_1\omega_2ar/\rho_1^3\right)=-r\left(M_2+M_1(a-\rho_1)/\rho_1\right)$").note(r"Near the axis of the second disc $(a-\rho_1)\dot\rho_1$ tends to a number of the sign of $-M_2$.")
        .in_words()
        .follows([Condition::Equal(both * far * inertia, -(s.radius * (s.m2 + s.m1 * far / s.rho)))]);
}
