//! Sections 1 to 3: production, learning, a joint and a point of variable mass as examples of one law of variable
//! inertia.

use super::alphabet::{int, letter, letters};
use claims::{Condition, Line, Page};
use field::{Scalar, Tangent};
use mechanics::lagrange::rheonomic;
use symbolic::Sym;
use systems::variable_inertia::{Growth, Joint, Learning, Plant, VariablePoint};

use Condition::{Equal, NonZero, Zero};

pub fn claims(page: &mut Page) {
    page.section("1-3. Analogies");
    production(page);
    learning(page);
    joint(page);
    point(page);
    closed_forms(page);
    runs(page);
}

/// The residual of a law along y(t), by derivatives with respect to the symbol t.
fn along(law: &impl Growth<Given = Sym>, y: Sym, speed: Sym, rate: impl Fn(Sym) -> Sym) -> Sym {
    law.residual(letter("t"), [y, speed, rate(speed)])
}

fn by_time(e: Sym) -> Sym {
    e.diff(letter("t"))
}

/// Claims on (1).
fn production(page: &mut Page) {
    let [y, dy, ddy, m, dm, wear, supply] = letters(["Y", "Ẏ", "Ÿ", "mᶠ", "ṁᶠ", "δ", "uᶠ"]);
    let plant = Plant { fund: m, fund_rate: dm, wear, supply };
    page.claim("eq1", "growth", r"(1) is the balance $\dot q=u-w$ of the funds $q=m\dot Y$, which come at the rate $u$ and wear at the rate $w$. The program's plant has $w=\delta m\dot Y$")
        .defines([Line::equation(plant.residual(Sym::ZERO, [y, dy, ddy]), m * ddy + dm * dy + wear * m * dy, supply)]);
    let t = letter("t");
    let now = m + dm * t;
    let steady = supply / (wear * now);
    page.claim("eq1", "steady", r"With a constant share $\delta$ of the funds worn out and a constant supply, $\dot Y=u/(\delta m(t))$ solves (1) for $m=m_0+\dot mt$, so that the funds $m\dot Y$ are constant")
        .in_words()
        .given([NonZero(wear), NonZero(now)])
        .follows([Zero(along(&plant, y, steady, by_time))]);
}

/// Claims on (2).
fn learning(page: &mut Page) {
    let [i, di, ddi, inertia, denial, permeability, potential] = letters(["I", "İ", "Ï", "L", "τ", "G", "Mᴵ"]);
    let law = Learning { inertia, denial, permeability, potential };
    page.claim("eq2", "growth", r"(2) as printed has the form of (1) with $m=L$, $w=(\tau-\dot I)\dot I+I/G$, $u=M$. Its terms agree in dimension only where $L$ is measured as information")
        .reading(r"The equation is judged and integrated as printed, with $\tau-\frac{dI}{dt}$, a probable misprint of $\tau-\frac{dL}{dt}$ (eq2/gloss).")
        .defines([Line::equation(
            law.residual(Sym::ZERO, [i, di, ddi]),
            inertia * ddi + (denial - di) * di + i / permeability,
            potential,
        )]);
    // the rate d/dt (L I') with L(t)
    let change = letter("L̇");
    let grown = Tangent::moving(inertia, change) * Tangent::moving(di, ddi);
    let around = |denial: Sym| grown.slope + denial * di + i / permeability - potential;
    let glossed = inertia * ddi + denial * di + i / permeability;
    page.claim("eq2", "gloss", r"The terms of (2) as printed are those which the text names below it, $L\ddot I$ (denial of denial), $\tau\dot I$ (denial) and $I/G$, for $L(t)$ that varies")
        .why(r"$\frac{d}{dt}(L\dot I)=L\ddot I+\dot L\dot I$ has a third term, which $-\dot I^2$ does not cancel and $-\dot L\dot I$ does: $\tau-\frac{dI}{dt}$ is probably a misprint of $\tau-\frac{dL}{dt}$.")
        .fails([Line::equation(around(denial - di), glossed, potential)]);
    page.claim(
        "eq2",
        "gloss-corrected",
        r"With $\tau-\dot L$ in the place of $\tau-\dot I$ the terms of (2) are those which the text names",
    )
    .holds([Line::equation(around(denial - change), glossed, potential)]);
    page.correct();
    let [c, e] = letters(["c", "E"]);
    let speed = denial / (int(1) + c * e);
    let open = Learning { potential: i / permeability, ..law };
    page.claim(
        "eq2",
        "closed-form",
        r"Where $M=I/G$ and $L$ is constant, $\dot I=\tau/(1+cE)$ with $\dot E=\tau E/L$, $E=e^{\tau t/L}$, solves (2) as printed, for every $c$",
    )
    .in_words()
    .given([NonZero(int(1) + c * e)])
    .follows([Zero(along(&open, i, speed, |v| v.diff(e) * denial * e / inertia))]);
    let (t, v0) = (letter("t"), letter("v0"));
    let runaway = inertia * v0 / (inertia - v0 * t);
    page.claim("eq2", "runaway", r"Where $M=I/G$, $L$ is constant and $\tau=0$, $\dot I=Lv_0/(L-v_0t)$ solves (2) as printed and ends at the time $L/v_0$, because the square of $\dot I$ feeds itself")
        .in_words()
        .given([NonZero(inertia - v0 * t)])
        .follows([Zero(along(&Learning { denial: Sym::ZERO, ..open }, i, runaway, by_time))]);
}

/// Claims on (3), from Lagrange's equation of a link with a moving load.
fn joint(page: &mut Page) {
    let [link, load, distance, rate, gravity, motor] = letters(["J₀", "m", "ρ", "ρ̇", "g", "Mᴶ"]);
    let [angle, speed, acceleration] = letters(["φ", "φ̇", "φ̈"]);
    let joint = Joint { link, load, distance, rate, gravity, motor };
    let derived = rheonomic(
        |t, [phi], [dphi]| {
            let [m, g, j] = [load, gravity, link].map(|x| Tangent::fixed(Tangent::fixed(x)));
            let reach: Tangent<Tangent<Sym>> = joint.reach(t);
            let inertia = j + m * reach * reach;
            use field::Analytic;
            (inertia * dphi * dphi).half() - m * g * reach * phi.circle().sin
        },
        Sym::ZERO,
        [angle],
        [speed],
        [acceleration],
    )[0] - motor;
    use field::Analytic;
    let inertia = link + load * distance * distance;
    let change = int(2) * load * distance * rate;
    page.claim("eq3", "lagrange", r"$\frac{d}{dt}(J\omega)+m(\varphi,\omega,t)=M$ is Lagrange's equation of a link with a load at the distance $\rho(t)$, with $J=J_0+m\rho^2$ and the moment of the weight $mg\rho\cos\varphi$, also where the load moves")
        .holds([Line::equation(
            derived,
            inertia * acceleration + change * speed + load * gravity * distance * angle.circle().cos,
            motor,
        )]);
    page.claim(
        "eq3",
        "growth",
        "The program's law of a joint, in the form of (1), is Lagrange's equation of the link with its load",
    )
    .in_words()
    .follows([Equal(joint.residual(Sym::ZERO, [angle, speed, acceleration]), derived)]);
}

/// Claims on (4) and its assumption on the ejected mass.
fn point(page: &mut Page) {
    let [x, dx, ddx, m, dm, beta, k, push, u] = letters(["x", "ẋ", "ẍ", "m", "ṁ", "β", "k", "Rᶠ", "u"]);
    let law = VariablePoint { mass: m, mass_rate: dm, resistance: beta, stiffness: k, push };
    let left = m * ddx + dm * dx + beta * dx + k * x;
    page.claim(
        "eq4",
        "growth",
        r"(4) has the form of (1) with $w=\beta\dot x+kx$, $u=R$, which is the program's law of the point",
    )
    .defines([Line::equation(law.residual(Sym::ZERO, [x, dx, ddx]), left, push)]);
    // the momentum of the point and of the ejected mass
    let carried = Tangent::moving(m, dm) * Tangent::moving(dx, ddx);
    let balance = carried.slope - dm * u + beta * dx + k * x - push;
    page.claim("eq4", "variable-mass", "(4) is the equation of a point of variable mass without other forces. It is judged by the momentum of the point and of the mass that has left with the velocity $u$ in space")
        .why(r"The mass that leaves takes its momentum $\dot mu$ along, a force on the point that (4) lacks.")
        .fails([Line::equation(balance, left, push)]);
    page.claim("eq4", "variable-mass-corrected", r"A point of variable mass has the reactive force $\dot mu$ on the right. (4) is the case $u=0$, in which what leaves or joins stands still in space. Where it leaves with the point's own velocity, $u=\dot x$, the equation is $m\ddot x+\beta\dot x+kx=R$")
        .holds([Line::equation(balance, left, push + dm * u)]);
    page.correct();
}

/// Claims on closed forms of (4).
fn closed_forms(page: &mut Page) {
    let [t, m, dm, omega, x0, x1, x2] = letters(["t", "m", "ṁ", "ω", "x₀", "x₁", "x₂"]);
    let [e, cos, sin, beta] = letters(["E", "cs", "sn", "β"]);
    let free = VariablePoint { mass: m, mass_rate: Sym::ZERO, resistance: beta, stiffness: Sym::ZERO, push: Sym::ZERO };
    let decay = beta / (m + m);
    let damped = VariablePoint { stiffness: m * (omega * omega + decay * decay), ..free };
    // E' = -decay E, cos' = -omega sin, sin' = omega cos
    let rate = |f: Sym| f.diff(cos) * -omega * sin + f.diff(sin) * omega * cos - f.diff(e) * decay * e;
    let x = e * (x1 * cos + x2 * sin);
    page.claim(
        "eq4",
        "oscillator",
        r"(4) with constant mass and $R=0$ is solved by $x=E(x_1\cos\omega t+x_2\sin\omega t)$, $E=e^{-\beta t/2m}$, for $k=m\omega^2+\beta^2/4m$",
    )
    .in_words()
    .follows([Zero(along(&damped, x, rate(x), rate))]);
    let now = m + dm * t;
    let impulse = letter("P₀");
    let coasting = VariablePoint { mass_rate: dm, resistance: Sym::ZERO, ..free };
    page.claim(
        "eq4",
        "coasting",
        r"(4) with a mass linear in $t$ and without forces is solved by a constant $m\dot x=p_0$",
    )
    .in_words()
    .given([NonZero(now)])
    .follows([Zero(along(&coasting, x0, impulse / now, by_time))]);
    let resisted = VariablePoint { mass_rate: dm, resistance: dm, ..free };
    let x = x0 - impulse * m / (dm * now);
    page.claim("eq4", "gathering", r"(4) with mass gathered at the constant rate $\dot m=\beta$ and without other forces is solved by $x=x_0-p_0m_0/(\dot mm)$, whose limit is $x_0$")
        .in_words()
        .given([NonZero(now), NonZero(dm)])
        .follows([Zero(along(&resisted, x, by_time(x), by_time))]);
}

/// Claims on the form in which the laws are integrated.
fn runs(page: &mut Page) {
    page.claim("eq4", "runs", r"The program integrates (1)-(4) solved for the acceleration, $\ddot y=-(\dot m\dot y+w-u)/m$ in the letters of (1)")
        .defines([]);
}
