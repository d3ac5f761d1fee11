//! Section 3.1: the governor with balls and an elastic rim, (3.14)-(3.19).

use super::alphabet::{int, letter, letters, tidy};
use super::elastic::ElasticLetters;
use claims::{Line, Page};
use field::Scalar;
use symbolic::{Hypotheses, Sym};

pub fn claims(page: &mut Page, s: &ElasticLetters) {
    page.section("3.1. The governor with an elastic rim");
    energy(page, s);
    constraints(page, s);
    work(page, s);
    names(page, s);
    motion(page, s);
    power(page, s);
    stationary(page, s);
}

/// What Appell's equations see of an acceleration energy.
fn seen(s: &ElasticLetters, energy: Sym) -> [Sym; 2] {
    s.rates.map(|rate| tidy(energy.diff(rate)))
}

fn energy(page: &mut Page, s: &ElasticLetters) {
    let ([w, x, dx, ..], [dw, ddx]) = (s.state, s.rates);
    let [rho, height] = s.lengths(x);
    let drum = s.drum.powi(2);
    let balls = int(2) * s.ball * s.link.powi(2) / height;
    let swing = |a: Sym| w.powi(2).half() + int(2) * s.link.powi(2) * a.powi(2) / height.powi(2);
    let of_second = s.inertia[1] * drum / rho.powi(3) + s.ball * x;
    let printed = dw.half() * s.theta(x) - dw * w * x * of_second
        + (dx.powi(2) * (s.ball + balls)).half()
        + s.ball * ddx * dx * swing(x);
    let corrected = (dw.powi(2) * s.theta(x)).half() - dw * w * dx * of_second
        + (ddx.powi(2) * (s.sleeve + balls)).half()
        + s.ball * ddx * x * swing(dx);
    let derived = seen(s, s.acceleration_energy());
    let names = letters(["Qφ", "u"]);
    let lines = |energy: Sym| {
        let printed = s.rates.map(|rate| energy.diff(rate));
        [0, 1].map(|i| Line::formula(derived[i], names[i], printed[i]))
    };
    page.claim("eq3.14", "energy", r"$S$ as printed, without the square of $\dot\omega_1$, with $x$ for $\dot x$ and $\dot x$ for $\ddot x$: its derivatives by $\dot\omega_1$ and $\ddot x$")
        .note(r"The drum with the balls has the index 1 in the formulas, the disc 2: the text before has them the other way round.")
        .fails(lines(printed));
    page.claim("eq3.14", "energy-corrected", r"with $\frac12\dot\omega_1^2$, $-\dot\omega_1\omega_1\dot x(\dots)$, $\frac12\ddot x^2(m+\dots)$, $m_{sp}x\ddot x(\frac12\omega_1^2+2l^2\dot x^2(4l^2-x^2)^{-2})$, $m$ of the sleeve")
        .holds(lines(corrected));
    page.correct();
    let [distance] = letters(["ϱ"]);
    page.claim("eq3.15", "distance", r"$x-\rho=c$").defines([Line::equation(Sym::ZERO, x - distance, s.offset)]);
}

fn constraints(page: &mut Page, s: &ElasticLetters) {
    let [w, x, dx, lambda, psi] = s.state;
    let [w2, dlambda, dpsi] = letters(["ω2", "λ̇ᵉ", "ψ̇"]);
    let [second, across, turn] = s.rolling();
    let rolled = s.drum * w;
    page.claim("eq3.16", "no-slip", r"no slipping of the contact's centre, across and along").holds([
        Line::equation(across - dlambda, dx - dlambda, rolled * psi),
        Line::equation((second - w2) * (x - s.offset), rolled, (x - s.offset) * w2),
    ]);
    let keldysh = |a: Sym, b: Sym| Line::formula(turn, dpsi, (s.alpha * a - s.beta * b) * rolled);
    page.claim(
        "eq3.16",
        "curvature",
        r"the curvature of the line of rolling is $\alpha\dot\lambda-\beta\dot\psi$, as printed with dots",
    )
    .fails([keldysh(dlambda, dpsi)]);
    page.claim(
        "eq3.16",
        "curvature-corrected",
        r"$\dot\psi=(\alpha\lambda-\beta\psi)R\dot\varphi_1$, as (3.17) has it",
    )
    .holds([keldysh(lambda, psi)]);
    page.correct();
}

fn work(page: &mut Page, s: &ElasticLetters) {
    let [_, x, _, lambda, psi] = s.state;
    let [turn, push] = letters(["Qφ", "u"]);
    let opposite = Hypotheses::none().given(s.drill, -s.b);
    let [rho, _] = s.lengths(x);
    let derived = s.work();
    let printed = s.moments[0] + s.drum / rho * s.moments[1] - s.b * psi * s.drum / rho
        + s.b * psi * s.drum * (s.alpha * lambda - s.beta * psi);
    page.claim("eq3.17", "work-of-rotation", r"$Q_{\varphi_1}$ of the moments, of the rim's $a\lambda\,\delta\lambda+b\psi\,\delta\psi$ and of the moment $-b\psi$ on the disc")
        .under(&opposite)
        .note(r"The first line has $+b\psi\,\delta\varphi_2$, the second and (3.17) the minus.")
        .fails([Line::formula(derived[0], turn, printed)]);
    page.claim(
        "eq3.17",
        "work-of-rotation-corrected",
        r"by $\delta\lambda=\delta x-R\psi\,\delta\varphi_1$ there is $-aR\lambda\psi$ besides",
    )
    .under(&opposite)
    .holds([Line::formula(derived[0], turn, printed - s.a * s.drum * lambda * psi)]);
    page.correct();
    page.claim("eq3.17", "work-of-sleeve", r"$Q_x=-(c_1+c_2)(x-x_0)-c_1\delta_1+c_2\delta_2+a\lambda$")
        .holds([Line::formula(tidy(derived[1]), push, springs(s, x) + s.a * lambda)]);
}

fn springs(s: &ElasticLetters, x: Sym) -> Sym {
    let ([c1, c2], [d1, d2]) = (s.springs, s.tensions);
    -(c1 + c2) * (x - s.rest) - c1 * d1 + c2 * d2
}

fn names(page: &mut Page, s: &ElasticLetters) {
    let [w, x, dx, ..] = s.state;
    let [rho, height] = s.lengths(x);
    let [theta, f, mobile] = letters(["θˣ", "Fˣ", "mˣ"]);
    let balls = int(2) * s.ball * s.link.powi(2) / height;
    let [turning, sliding] = s.balance;
    page.claim(
        "eq3.17",
        "theta",
        r"$\theta(x)$: what multiplies $\dot\omega_1$, and it is the moment of inertia by the bodies",
    )
    .holds([Line::formula(turning.diff(s.rates[0]), theta, s.theta(x))]);
    let coupling = tidy(turning.diff(dx).diff(w));
    page.claim("eq3.17", "coupling", r"$F(x)=J_2r_1^2/(x-c)^2+m_{sp}x$: what multiplies $\dot x\omega_1$")
        .fails([Line::formula(coupling, f, s.inertia[1] * s.drum.powi(2) / rho.powi(2) + s.ball * x)]);
    page.claim("eq3.17", "coupling-corrected", r"$F(x)=-\frac{J_2r_1^2}{(x-c)^3}-m_{sp}x$")
        .note(r"Not $\theta'(x)$, whose first term is twice that: the rolling on the disc is not integrable.")
        .holds([Line::formula(coupling, f, s.coupling(x))]);
    page.correct();
    let derived = sliding.diff(s.rates[1]);
    page.claim("eq3.17", "mobile-mass", r"$m(x)=m_{sp}+2m_{sp}l^2/(4l^2-x^2)$: what multiplies $\ddot x$, $m$ being the mass of the sleeve with the wheel")
        .fails([Line::formula(derived, mobile, s.ball + balls)]);
    page.claim(
        "eq3.17",
        "mobile-mass-corrected",
        r"with $m$ for the first $m_{sp}$: the balls' part is in the second term",
    )
    .holds([Line::formula(derived, mobile, s.mobile(x))]);
    page.correct();
}

fn motion(page: &mut Page, s: &ElasticLetters) {
    let ([w, x, dx, lambda, psi], [dw, ddx]) = (s.state, s.rates);
    let [rho, height] = s.lengths(x);
    let opposite = Hypotheses::none().given(s.drill, -s.b);
    let [turning, sliding] = s.balance;
    let moments = s.moments[0] + s.drum / rho * s.moments[1];
    let curvature = s.drum * (s.alpha * lambda - s.beta * psi);
    let left = |f: Sym| s.theta(x) * dw + f * dx * w;
    let f = letter("Fˣ");
    let names = opposite.clone().given(f, s.coupling(x));
    page.claim("eq3.17", "rotation", r"the equation of $\omega_1$ with the right $F(x)$, the rim's moment as printed $b\psi(R(\alpha\lambda-\beta\psi)-1)$")
        .under(&names)
        .fails([Line::equation(turning, left(f), moments + s.b * psi * (curvature - int(1)))]);
    page.claim("eq3.17", "rotation-corrected", r"with $-\frac R{x-c}$ for $-1$, and with $-aR\lambda\psi$")
        .under(&names)
        .holds([Line::equation(
            turning,
            left(f),
            moments + s.b * psi * (curvature - s.drum / rho) - s.a * s.drum * lambda * psi,
        )]);
    page.correct();
    let mobile = letter("mˣ");
    let names = Hypotheses::none().given(mobile, s.mobile(x));
    page.claim("eq3.17", "sleeve", r"the equation of $x$ with the right $m(x)$, and the constraints")
        .under(&names)
        .holds([Line::equation(
            sliding,
            mobile * ddx
                + s.ball.half() * x * w.powi(2)
                + int(2) * s.link.powi(2) * x / height.powi(2) * s.ball * dx.powi(2),
            springs(s, x) + s.a * lambda,
        )]);
}

/// E' less what Appell's equations leave: the power, whatever the accelerations.
fn power(page: &mut Page, s: &ElasticLetters) {
    let ([w, x, dx, lambda, psi], [dw, ddx]) = (s.state, s.rates);
    let [second, across, turn] = s.rolling();
    let energy = tidy(s.governor.energy(s.state));
    let moving = [(w, dw), (x, dx), (dx, ddx), (lambda, across), (psi, turn)];
    let rate = moving.iter().fold(Sym::ZERO, |sum, (of, rate)| sum + energy.diff(*of) * *rate);
    let derived = tidy(rate - s.balance[0] * w - s.balance[1] * dx);
    let [name] = letters(["Ė"]);
    let shafts = s.moments[0] * w + s.moments[1] * second;
    page.claim("eq3.17", "power", r"the rim's moments and forces store energy: kinetic energy, springs and $-\frac12a\lambda^2-\frac12b\psi^2$ change by the shafts' power alone")
        .under(&Hypotheses::none().given(s.drill, -s.b))
        .note(r"The moment $-b\psi$ on the disc is that of a rim which sees the disc turn, $\dot\psi=(\alpha\lambda-\beta\psi)R\omega_1-\omega_2$; then $\lambda=\psi=0$ is no motion. With (3.16) nothing stores the power $-b\psi\omega_2$.")
        .fails([Line::formula(derived, name, shafts)]);
    page.claim(
        "eq3.17",
        "power-corrected",
        r"without a moment on the disc; with $d\psi$ on it, $d\psi\omega_2$ is added",
    )
    .holds([Line::formula(derived, name, shafts + s.drill * psi * second)]);
    page.correct();
}

fn stationary(page: &mut Page, s: &ElasticLetters) {
    let [w, x, _, lambda, psi] = s.state;
    let w0 = letter("ω₀");
    page.claim("eq3.18", "motion", r"$\omega_1=\omega_1^0$, $x=x_0$, $\lambda=\psi=0$").defines([
        Line::equation(Sym::ZERO, w, w0),
        Line::equation(Sym::ZERO, x, s.rest),
        Line::equation(Sym::ZERO, lambda, Sym::ZERO),
        Line::equation(Sym::ZERO, psi, Sym::ZERO),
    ]);
    let [turning, sliding] = s.balance.map(|equation| s.stationary(equation));
    let ([c1, c2], [d1, d2]) = (s.springs, s.tensions);
    let [rho, _] = s.lengths(s.rest);
    page.claim("eq3.19", "conditions", r"when (3.18) is a motion").holds([
        Line::equation(-turning, s.moments[0] + s.drum / rho * s.moments[1], Sym::ZERO),
        Line::equation(sliding, s.ball.half() * s.rest * w0.powi(2), -c1 * d1 + c2 * d2),
    ]);
}
