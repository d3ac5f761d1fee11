//! Section 1.3, task 1: Lagrange's equation of the steered rod, (1.92)-(1.99).

use super::alphabet::{int, letter, letters, tidy};
use super::steered::SteeredLetters;
use claims::{Condition, Line, Page};
use field::{Analytic, Tangent};
use mechanics::constrained::{PointSystem, kinetic_energy};
use symbolic::Sym;

use Condition::Zero;

pub fn claims(page: &mut Page, s: &SteeredLetters) {
    page.section("1.3. Task 1, Lagrange's equation");
    integral(page, s);
    work(page, s);
    equation(page, s);
    redundant(page, s);
}

fn integral(page: &mut Page, s: &SteeredLetters) {
    let sin = s.point.sin;
    page.claim("eq1.92", "speed", r"The constraint of the middle, expressed by $\theta$, is (1.92)")
        .holds([Line::formula(s.speed(), s.dx1, s.l * s.dtheta / (int(2) * sin))]);
    // tan(theta/2) along the constraint, with theta' expressed by x1'
    let half = (Tangent::moving(s.theta, s.turning()) / Tangent::fixed(int(2))).circle();
    let tangent = half.sin / half.cos;
    let name = letter("d(tg θ/2)/dt");
    page.claim(
        "section1.3-integral",
        "exponential",
        r"The paper prints the integral $\operatorname{tg}\frac\theta2=e^{x_1}$ of the constraint of the middle, judged by its rate",
    )
    .why(r"The factor $2/l$ of (1.92) and the constant of integration are missing. The printed exponent has a dimension.")
    .fails([Line::formula(tangent.slope, name, s.dx1 * tangent.value)]);
    page.claim("section1.3-integral", "exponential-corrected",r"The constraint of the middle has the integral $\operatorname{tg}\frac\theta2=Ce^{2x_1/l}$, by its rate: $\frac{d}{dt}\operatorname{tg}\frac\theta2=\frac2l\dot x_1\operatorname{tg}\frac\theta2$")
        .holds([Line::formula(tangent.slope, name, int(2) / s.l * s.dx1 * tangent.value)]);
    page.correct();
    let at_rest = [(s.dtheta, Sym::ZERO)];
    page.claim("section1.3-integral", "geometric",r"Where $\sin\theta=0$ and $\dot\theta=0$ the constraint of the middle leaves $\dot x_1$ free, and the rod along the guide slides without turning").note(r"The integral $\operatorname{tg}\frac\theta2=Ce^{2x_1/l}$ does not hold there.")
        .follows([Zero(s.turning().substitute(&[(sin, Sym::ZERO)]).substitute(&at_rest))]);
}

/// An expression with x1' replaced by theta'.
fn by_angle(s: &SteeredLetters, expression: Sym) -> Sym {
    expression.substitute(&[(s.dx1, s.speed())])
}

/// The generalised force of theta: the product with the chart's field for theta' = 1.
fn along_angle(s: &SteeredLetters, force: [Sym; 4]) -> Sym {
    let [work] = s.motion().generalised(force);
    work * s.speed() / s.dtheta
}

fn work(page: &mut Page, s: &SteeredLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let (m1, m2, l) = (s.m1, s.m2, s.l);
    let energy = by_angle(s, kinetic_energy(s.rod.masses(), s.motion().state.velocity));
    let eighth = int(1) / int(8);
    page.claim(
        "eq1.93",
        "kinetic-energy",
        r"The kinetic energy of the steered rod, expressed by $\theta$ and $\dot\theta$, is (1.93)",
    )
    .holds([Line::formula(energy, letter("T"), eighth * ((m1 + m2) * l.powi(2) / sin.powi(2)) * s.dtheta.powi(2))]);
    let two = int(2);
    page.claim("eq1.93", "given-forces", "The generalised force of $X$ and the weights is that of (1.93)")
        .reading(r"The source prints $mgl$, where the index is missing; $m_2gl$ is read, as (1.96) has it.")
        .holds([Line::formula(
            along_angle(s, s.given_force()),
            letter("Q"),
            s.drive * l / (two * sin) + m2 * s.g * l * c,
        )]);

    // the reactions: R on M1, R_21 and R_22 at both ends
    let [rx, ry, r21, r22] = letters(["Rx", "Ry", "R1", "R2"]);
    let rod = s.of_constraints([r21, r22, Sym::ZERO]);
    let all = along_angle(s, [rx + rod[0], ry + rod[1], rod[2], rod[3]]);
    let [name, turned] = letters(["δAτ", "δθ"]);
    let across = l / (two * sin) * turned;
    let at_m1 = s.friction()[0];
    let guide = [(rx, (m1 + m2) * s.mu)];
    page.claim("eq1.94", "work",r"The work of the reactions is (1.94) as printed, $\rho_1\delta x_1 = m_1\mu\,\delta x_1$ and terms that cancel, with $\delta x_1=\frac{l}{2\sin\theta}\delta\theta$").why(r"The work at $M_2$ is missing: in $\vec R+\vec R_{22}$ the text puts $\vec Y+\vec\rho_1$ for $\vec R$, without $\vec\rho_{21}-\vec\rho_{22}$ of (1.68).").note(r"The reaction across the rod does no work at all.")
        .fails([Line::formula(all.substitute(&guide) * turned, name, at_m1 * across)]);
    page.claim(
        "eq1.94",
        "work-corrected",
        r"Among the reactions the guide's $R_x$ alone does work, $R_x\delta x_1=(m_1+m_2)\mu\,\delta x_1$",
    )
    .holds([Line::formula(all.substitute(&guide) * turned, name, (m1 + m2) * s.mu * across)]);
    page.correct();
    page.claim("eq1.95", "friction", r"The generalised force of friction is (1.95) as printed, with $m_1\mu$")
        .why(r"The friction at $M_2$ works too and is missing.")
        .fails([Line::formula(along_angle(s, s.friction()), letter("Qτ"), m1 * s.mu * l / (two * sin))]);
    page.claim("eq1.95", "friction-corrected", r"The generalised force of friction is (1.95) with $(m_1+m_2)\mu$")
        .holds([Line::formula(along_angle(s, s.friction()), letter("Qτ"), (m1 + m2) * s.mu * l / (two * sin))]);
    page.correct();
}

/// The residual of the equation of motion along the chart for theta' = 1, as a function of theta''.
fn balance(s: &SteeredLetters, friction: [Sym; 4]) -> Sym {
    let speed = s.speed();
    let moving = Tangent::moving(s.theta, s.dtheta).circle().sin;
    // x1'' from theta', theta'' by the constraint
    let fixed = |value: Sym| Tangent::fixed(value);
    let ratio = fixed(s.l) / (fixed(int(2)) * moving) * Tangent::moving(s.dtheta, s.ddtheta);
    let acceleration = s.motion().acceleration([ratio.slope]).map(|a| a.substitute(&[(s.dx1, speed)]));
    along_angle(s, s.newton(acceleration, friction))
}

fn equation(page: &mut Page, s: &SteeredLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let (m1, m2, l, two) = (s.m1, s.m2, s.l, int(2));
    let derived = balance(s, s.friction());
    let rate = |power: i32| {
        let fixed = |value: Sym| Tangent::fixed(value);
        let sine = Tangent::moving(s.theta, s.dtheta).circle().sin;
        let below = (1..power).fold(sine, |product, _| product * sine);
        tidy((fixed((m1 + m2) * l.powi(2)) * Tangent::moving(s.dtheta, s.ddtheta) / (fixed(int(4)) * below)).slope)
    };
    let right = |mass: Sym| s.drive * l / (two * sin) + m2 * s.g * l * c + mass * s.mu * l / (two * sin);
    page.claim("eq1.96", "motion",r"Lagrange's equation is (1.96) as printed, with $\frac{d}{dt}[(m_1+m_2)\frac{l^2\dot\theta}{4\sin\theta}]$ on the left and $m_1\mu$ on the right").why(r"The factor $\frac1{\sin\theta}$ is missing on the left, and the friction at $M_2$ on the right.")
        .fails([Line::equation(derived, rate(1), right(m1))]);
    page.claim("eq1.96", "motion-corrected",r"Lagrange's equation is (1.96) with $\frac1{\sin\theta}$ before the derivative and with $(m_1+m_2)\mu$. The term $\frac{\partial T}{\partial\theta}$ reduces $\sin^2\theta$ within the derivative to this factor")
        .holds([Line::equation(derived, rate(1) / sin, right(m1 + m2))]);
    page.correct();

    let sign = letter("ε");
    let lambda = by_angle(s, s.multipliers(s.friction())[2]);
    let printed = -(m1 + m2) * s.g - m2 * (l * s.dtheta.powi(2) / sin - two * s.g * c.powi(2));
    let mu = sign * s.f * lambda / (m1 + m2);
    page.claim(
        "eq1.97",
        "law",
        r"$\mu$ is (1.97) by the law of friction and the multiplier, $(m_1+m_2)\mu=\varepsilon f\lambda$",
    )
    .note("With the corrected (1.82) the sign is that of the velocity of M1 where the floor pushes.")
    .holds([Line::formula(mu, s.mu, sign * s.f / (m1 + m2) * printed)]);
    let friction = s.friction().map(|force| force.substitute(&[(s.mu, mu)]));
    let quarter = int(1) / int(4);
    page.claim(
        "eq1.98",
        "motion",
        r"The equation of motion with friction put in is (1.98) as printed, with $(m_1+m_2)\mu$ and $\sin^2\theta$",
    )
    .holds([Line::equation(
        balance(s, friction) / l,
        quarter * (m1 + m2) * l * (s.ddtheta / sin.powi(2) - c * s.dtheta.powi(2) / sin.powi(3)),
        m2 * s.g * c + s.drive / (two * sin) + s.f * sign / (two * sin) * printed,
    )]);
}

/// Claims on (1.99), where x1 is kept as a redundant coordinate.
fn redundant(page: &mut Page, s: &SteeredLetters) {
    let (c, sin) = (s.point.cos, s.point.sin);
    let (m1, m2, l) = (s.m1, s.m2, s.l);
    let acceleration = s.motion().acceleration([s.ddx1]);
    let [derived] = s.motion().generalised(s.newton(acceleration, s.friction()));
    let left = (m1 + m2) * s.ddx1;
    page.claim("eq1.99", "motion",r"The equation for $x_1$ is (1.99) as printed, with $m_1\mu+m_2lg\cos\theta$").why(r"The friction at $M_2$ is missing, and the weight falls by $2\sin\theta\cos\theta$ for a unit of $x_1$, not by $l\cos\theta$.")
        .fails([Line::equation(derived, left, s.drive + m1 * s.mu + m2 * l * s.g * c)]);
    page.claim("eq1.99", "motion-corrected", r"The equation for $x_1$ is (1.99) with $(m_1+m_2)\mu + m_2g\sin2\theta$")
        .holds([Line::equation(derived, left, s.drive + (m1 + m2) * s.mu + int(2) * m2 * s.g * sin * c)]);
    page.correct();
    let across = s.middle();
    page.claim("eq1.99", "speed", r"As printed, the constraint of the middle is $\dot x_1\sin\theta=l\dot\theta$")
        .why(r"The factor 2 of (1.92) is missing.")
        .fails([Line::equation(across, s.dx1 * sin, l * s.dtheta)]);
    page.claim("eq1.99", "speed-corrected", "The constraint of the middle has the factor 2, as in (1.92)")
        .holds([Line::equation(across, int(2) * s.dx1 * sin, l * s.dtheta)]);
    page.correct();
}
