//! Section 3.2: the released governor, (3.23)-(3.29).

use super::alphabet::{int, letters, tidy};
use super::released::ReleasedLetters;
use claims::{Line, Page};
use field::Scalar;
use mechanics::constrained::PointSystem;
use symbolic::Sym;

pub fn claims(page: &mut Page, r: &ReleasedLetters) {
    page.section("3.2. The released governor");
    release(page, r);
    energy(page, r);
    equations(page, r);
    linearised(page, r);
}

/// An expression with omega2 = omega2_0 + zeta, omega2' = zeta', u + u1.
fn released(r: &ReleasedLetters, expression: Sym) -> Sym {
    let s = &r.drum;
    let [zeta, dzeta] = letters(["ζ", "ζ̇"]);
    tidy(expression.substitute(&[(s.speed, s.speed + zeta), (s.dspeed, dzeta), (s.push, s.push + r.control)]))
}

fn release(page: &mut Page, r: &ReleasedLetters) {
    let s = &r.drum;
    let [x, dx, q, p] = letters(["x1", "ẋ1", "δq1", "p1"]);
    page.claim(
        "eq3.23",
        "states",
        "(3.23) expresses places by coordinates and velocities by velocity parameters, for each coordinate of a point",
    )
    .defines([
        Line::equation(Sym::ZERO, x, Sym::function("a", q)),
        Line::equation(Sym::ZERO, dx, Sym::function("b", p)),
    ]);
    let [zeta, dzeta, xi, kept] = letters(["ζ", "ζ̇", "ξ", "ω₀"]);
    page.claim("eq3.24", "release", r"(3.24) releases the condition: $\omega_2=\omega_2^0+\zeta$ and $\dot\zeta=\xi$")
        .reading(r"From (3.34) on the source writes $\xi$ for $\zeta$ itself.")
        .defines([Line::equation(Sym::ZERO, s.speed, kept + zeta), Line::equation(Sym::ZERO, dzeta, xi)]);
    let [[first, _], _, [wheel, _]] = s.spins();
    let rolled = s.rho * (s.speed + zeta);
    let names = letters(["ω1", "ω"]);
    page.claim("eq3.24", "passive", r"The wheel does not slip at the speed $\omega_2^0+\zeta$ either").defines([
        Line::formula(s.drum * released(r, first), s.drum * names[0], rolled),
        Line::formula(s.radius * released(r, wheel), s.radius * names[1], rolled),
    ]);
}

fn energy(page: &mut Page, r: &ReleasedLetters) {
    let s = &r.drum;
    let [zeta, dzeta] = letters(["ζ", "ζ̇"]);
    let energy = released(r, s.acceleration_energy());
    let seen = |energy: Sym| [tidy(energy.diff(dzeta)), energy.diff(s.ddrho)];
    let rim = dzeta * s.rho + (zeta + s.speed) * s.drho;
    let printed = |a: Sym| (r.n * rim.powi(2) + s.mass * a.powi(2) + s.second * dzeta.powi(2)).half();
    let names = letters(["∂S/∂ζ̇", "∂S/∂ϱ̈"]);
    let derived = seen(energy);
    let lines = |a: Sym| {
        let printed = [printed(a).diff(dzeta), tidy(printed(a).diff(s.ddrho))];
        [0, 1].map(|i| Line::formula(derived[i], names[i], printed[i]))
    };
    page.claim(
        "eq3.25",
        "energy",
        r"The derivatives by $\dot\zeta$ and $\ddot\rho$ of $S'$ are those of the print, with $\frac12m\dot\rho^2$",
    )
    .why(r"A dot is missing, so that $\partial S'/\partial\ddot\rho=0$: the inertia term $m\ddot\rho$ is missing.")
    .under(&r.names())
    .fails(lines(s.drho));
    page.claim(
        "eq3.25",
        "energy-corrected",
        r"The derivatives by $\dot\zeta$ and $\ddot\rho$ of $S'$ are those with $\frac12m\ddot\rho^2$",
    )
    .under(&r.names())
    .holds(lines(s.ddrho));
    page.correct();
    let motion = s.motion();
    let work = motion.generalised(s.governor.force(&motion.state)).map(|force| released(r, force));
    let names = letters(["Qζ", "Qρ"]);
    page.claim("eq3.25", "work", r"The work of both shafts gives the generalised force $Q'_\zeta$")
        .holds([Line::formula(work[0], names[0], s.m2 + s.rho / s.drum * s.m1)]);
    page.claim("eq3.25", "work-on-wheel", r"The generalised force of $\rho$ also contains the stabilising push $u_1$")
        .defines([Line::formula(work[1], names[1], s.push + r.control - s.friction)]);
}

fn equations(page: &mut Page, r: &ReleasedLetters) {
    let s = &r.drum;
    let [zeta, dzeta, start, more] = letters(["ζ", "ζ̇", "ϱ₀", "ϱ′"]);
    let [turning, sliding] = s.balance().map(|side| released(r, side));
    let right = s.m2 + s.rho / s.drum * s.m1;
    let left = |lever: Sym| (r.n * s.rho.powi(2) + s.second) * dzeta + r.n * (zeta + s.speed) * lever * s.drho;
    page.claim(
        "eq3.26",
        "rotation",
        r"As printed, the first equation is $(n\rho^2+J_2)\dot\zeta+n(\zeta+\omega_2^0)\dot\rho=M_2+\frac\rho RM_1$",
    )
    .why(r"A factor $\rho$ is missing. (3.27) has it.")
    .under(&r.names())
    .fails([Line::equation(turning, left(int(1)), right)]);
    page.claim(
        "eq3.26",
        "rotation-corrected",
        r"The first equation has $n(\zeta+\omega_2^0)\rho\dot\rho$, as in (3.27)",
    )
    .under(&r.names())
    .holds([Line::equation(turning, left(s.rho), right)]);
    page.correct();
    page.claim("eq3.26", "wheel", r"As printed, the second equation is $m\ddot\rho=F_1+F_2+u+u_1$")
        .reading(r"$F_1+F_2$ is read as the friction $F_{11}+F_{22}$ across.")
        .why(r"The sign of friction is wrong. (3.3) and (3.27) have the minus.")
        .fails([Line::equation(sliding, s.mass * s.ddrho, s.friction + s.push + r.control)]);
    page.claim("eq3.26", "wheel-corrected", r"The second equation has $-(F_{11}+F_{22})$, as in (3.3) and (3.27)")
        .holds([Line::equation(sliding, s.mass * s.ddrho, -s.friction + s.push + r.control)]);
    page.correct();
    let shifted = |side: Sym| side.substitute(&[(s.rho, start + more)]);
    page.claim("eq3.27", "equations", r"The equations with $\rho=\rho_0+\rho'$ are (3.27)").under(&r.names()).holds([
        Line::equation(shifted(turning), shifted(left(s.rho)), shifted(right)),
        Line::equation(sliding, s.mass * s.ddrho, -s.friction + s.push + r.control),
    ]);
}

fn linearised(page: &mut Page, r: &ReleasedLetters) {
    let s = &r.drum;
    let [zeta, more, z] = r.deviation;
    let [dzeta, dmore, dz] = letters(["ζ̇", "ϱ̇′", "ż"]);
    // the derivatives of Appell's equations at the programmed motion: zeta = zeta' = 0, rho = rho_0(t)
    let programme = [(s.speed, s.speed), (s.dspeed, Sym::ZERO), (s.rho, r.rho), (s.drho, r.drho)];
    let deviations =
        [(s.speed, zeta), (s.dspeed, dzeta), (s.rho, more), (s.drho, dmore), (s.ddrho, dz), (s.push, r.control)];
    let linear = s.balance().map(|side| {
        let sum = deviations.iter().fold(Sym::ZERO, |sum, (of, by)| sum + side.diff(*of) * *by);
        sum.substitute(&programme)
    });
    let lever = r.n * r.rho;
    page.claim("eq3.28", "linear", "The first approximation about the programme is (3.28)")
        .reading(r"The source prints $J_3$; there is no third body, so $J_2$ is read, as in (3.27).")
        .under(&r.names())
        .holds([
            Line::equation(
                linear[0],
                r.inertia() * dzeta + lever * r.drho * zeta + lever * s.speed * dmore + r.n * s.speed * r.drho * more,
                s.m1 / s.drum * more,
            ),
            Line::equation(linear[1], s.mass * dz, r.control),
        ]);
    let rates = r.linear.apply(r.deviation);
    let driven: [Sym; 3] = std::array::from_fn(|i| rates[i] + r.linear.control[i] * r.control);
    page.claim("eq3.29", "normal", r"The first approximation solved for $\dot\zeta$ and $\dot z$ is (3.29)")
        .reading(r"The source prints $J_3$; $J_2$ is read, as in (3.27). $z$ is a name for $\dot\rho'$.")
        .under(&r.names())
        .holds([
            Line::formula(
                r.inertia() * driven[0],
                r.inertia() * dzeta,
                -(lever * r.drho * zeta) - lever * s.speed * z + r.slope() * more,
            ),
            Line::formula(s.mass * driven[2], s.mass * dz, r.control),
        ]);
}
