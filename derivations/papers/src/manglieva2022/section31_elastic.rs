//! Section 3.1: the governor with balls and an elastic rim, (3.14)-(3.19).

use super::alphabet::{int, letter, letters, tidy};
use super::elastic::{AS_PRINTED, ElasticLetters};
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

/// The derivatives of an acceleration energy in Appell's equations.
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
    let names = letters(["∂S/∂ω̇1", "∂S/∂ẍ"]);
    let lines = |energy: Sym| {
        let printed = s.rates.map(|rate| energy.diff(rate));
        [0, 1].map(|i| Line::formula(derived[i], names[i], printed[i]))
    };
    page.claim("eq3.14", "energy", r"The derivatives by $\dot\omega_1$ and $\ddot x$ of $S$ are those of the print, without the square of $\dot\omega_1$, with $x$ for $\dot x$ and $\dot x$ for $\ddot x$")
        .why(r"Dots and a square are missing: with the printed letters $S$ is no energy of accelerations.")
        .reading(r"The drum with the balls is read as the body 1 and the disc as 2, as in the formulas; the text before has them the other way round.")
        .fails(lines(printed));
    page.claim("eq3.14", "energy-corrected", r"The derivatives by $\dot\omega_1$ and $\ddot x$ are those of $S$ with $\frac12\dot\omega_1^2$, $-\dot\omega_1\omega_1\dot x(\dots)$, $\frac12\ddot x^2(m+\dots)$ and $m_{sp}x\ddot x(\frac12\omega_1^2+2l^2\dot x^2(4l^2-x^2)^{-2})$. Here $m$ is the mass of the sleeve")
        .holds(lines(corrected));
    page.correct();
    let [distance] = letters(["ϱ"]);
    page.claim("eq3.15", "distance", r"(3.15) is the condition $x-\rho=c$").defines([Line::equation(
        Sym::ZERO,
        x - distance,
        s.offset,
    )]);
}

fn constraints(page: &mut Page, s: &ElasticLetters) {
    let [w, x, dx, lambda, psi] = s.state;
    let [w2, dlambda, dpsi] = letters(["ω2", "λ̇ᵉ", "ψ̇"]);
    let [second, across, turn] = s.rolling();
    let rolled = s.drum * w;
    page.claim("eq3.16", "no-slip", r"The contact's centre does not slip, across and along the wheel").defines([
        Line::equation(across - dlambda, dx - dlambda, rolled * psi),
        Line::equation((second - w2) * (x - s.offset), rolled, (x - s.offset) * w2),
    ]);
    let keldysh = |a: Sym, b: Sym| Line::formula(turn, dpsi, (s.alpha * a - s.beta * b) * rolled);
    page.claim(
        "eq3.16",
        "curvature",
        r"The curvature of the line of rolling, printed with dots as $\alpha\dot\lambda-\beta\dot\psi$, gives the law of (3.17)",
    )
    .why(r"With dots (3.16) contradicts (3.17). But the dots are slips, since the text says that the equation links the curvature with $\lambda$ and $\psi$.")
    .reading(r"Keldysh's model, to which the text refers, and (3.17) have $\alpha\lambda-\beta\psi$: that law is taken.")
    .fails([keldysh(dlambda, dpsi)]);
    page.claim(
        "eq3.16",
        "curvature-corrected",
        r"Without dots the constraint is $\dot\psi=(\alpha\lambda-\beta\psi)R\dot\varphi_1$, as in (3.17)",
    )
    .holds([keldysh(lambda, psi)]);
    page.correct();
}

fn work(page: &mut Page, s: &ElasticLetters) {
    let [_, x, _, lambda, psi] = s.state;
    let [turn, push] = letters(["Qφ", "Qx"]);
    let opposite = Hypotheses::none().given(s.drill, -s.b);
    let [rho, _] = s.lengths(x);
    let derived = s.work();
    let printed = s.moments[0] + s.drum / rho * s.moments[1] - s.b * psi * s.drum / rho
        + s.b * psi * s.drum * (s.alpha * lambda - s.beta * psi);
    page.claim("eq3.17", "work-of-rotation",r"The generalised force $Q_{\varphi_1}$ is the printed one, with the torques, the rim and the moment $-b\psi$ on the disc")
        .under(&opposite)
        .why(r"$\delta\lambda=\delta x-R\psi\,\delta\varphi_1$ depends on $\varphi_1$ too: the work $-aR\lambda\psi$ of the rim's force is missing.")
        .reading(format!("The first line prints $+b\\psi\\,\\delta\\varphi_2$, the second and (3.17) the minus, which is taken. {AS_PRINTED}"))
        .fails([Line::formula(derived[0], turn, printed)]);
    page.claim(
        "eq3.17",
        "work-of-rotation-corrected",
        r"$Q_{\varphi_1}$ also contains $-aR\lambda\psi$, by $\delta\lambda=\delta x-R\psi\,\delta\varphi_1$",
    )
    .under(&opposite)
    .holds([Line::formula(derived[0], turn, printed - s.a * s.drum * lambda * psi)]);
    page.correct();
    page.claim(
        "eq3.17",
        "work-of-sleeve",
        r"$Q_x=-(c_1+c_2)(x-x_0)-c_1\delta_1+c_2\delta_2+a\lambda$, by $\partial\lambda/\partial x=1$",
    )
    .reading(AS_PRINTED)
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
    page.claim("eq3.17", "theta", r"The factor $\theta(x)$ of $\dot\omega_1$ is the moment of inertia by the bodies")
        .holds([Line::formula(turning.diff(s.rates[0]), theta, s.theta(x))]);
    let coupling = tidy(turning.diff(dx).diff(w));
    page.claim("eq3.17", "coupling", r"As printed, the factor of $\dot x\omega_1$ is $F(x)=J_2r_1^2/(x-c)^2+m_{sp}x$")
        .why(r"The minus and one power of $x-c$ are missing: $\frac{d}{dt}(x-c)^{-1}$ brings $-(x-c)^{-2}$ together with a further $(x-c)^{-1}$.")
        .fails([Line::formula(coupling, f, s.inertia[1] * s.drum.powi(2) / rho.powi(2) + s.ball * x)]);
    page.claim(
        "eq3.17",
        "coupling-corrected",
        r"The factor of $\dot x\omega_1$ is $F(x)=-\frac{J_2r_1^2}{(x-c)^3}-m_{sp}x$",
    )
    .note(r"$F(x)$ is not $\theta'(x)$, whose first term is twice as large: the rolling on the disc is not integrable.")
    .holds([Line::formula(coupling, f, s.coupling(x))]);
    page.correct();
    let derived = sliding.diff(s.rates[1]);
    page.claim("eq3.17", "mobile-mass", r"As printed, the factor of $\ddot x$ is $m(x)=m_{sp}+2m_{sp}l^2/(4l^2-x^2)$")
        .why(r"The first $m_{sp}$ stands where $m$ should stand, the mass of the sleeve with the wheel. The balls' part is the second term.")
        .fails([Line::formula(derived, mobile, s.ball + balls)]);
    page.claim(
        "eq3.17",
        "mobile-mass-corrected",
        r"The factor of $\ddot x$ is $m(x)=m+2m_{sp}l^2/(4l^2-x^2)$, $m$ being the mass of the sleeve with the wheel",
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
    page.claim("eq3.17", "rotation", r"The equation of $\omega_1$ has the printed moment $b\psi(R(\alpha\lambda-\beta\psi)-1)$ of the rim, with the right $F(x)$")
        .under(&names)
        .why(r"The factor $\frac R{x-c}$ of the moment on the disc is printed as 1, against the work before, and $-aR\lambda\psi$ is missing.")
        .reading(AS_PRINTED)
        .fails([Line::equation(turning, left(f), moments + s.b * psi * (curvature - int(1)))]);
    page.claim(
        "eq3.17",
        "rotation-corrected",
        r"The equation of $\omega_1$ has $-\frac R{x-c}$ in the place of $-1$, and the term $-aR\lambda\psi$",
    )
    .under(&names)
    .reading(AS_PRINTED)
    .holds([Line::equation(
        turning,
        left(f),
        moments + s.b * psi * (curvature - s.drum / rho) - s.a * s.drum * lambda * psi,
    )]);
    page.correct();
    let mobile = letter("mˣ");
    let names = Hypotheses::none().given(mobile, s.mobile(x));
    page.claim("eq3.17", "sleeve", r"The equation of $x$ has the rim's force $+a\lambda$ and the right $m(x)$")
        .under(&names)
        .reading(AS_PRINTED)
        .holds([Line::equation(
            sliding,
            mobile * ddx
                + s.ball.half() * x * w.powi(2)
                + int(2) * s.link.powi(2) * x / height.powi(2) * s.ball * dx.powi(2),
            springs(s, x) + s.a * lambda,
        )]);
}

/// Claims on E' minus the residuals of Appell's equations, which is the power for any accelerations.
fn power(page: &mut Page, s: &ElasticLetters) {
    let ([w, x, dx, lambda, psi], [dw, ddx]) = (s.state, s.rates);
    let [second, across, turn] = s.rolling();
    let energy = tidy(s.governor.energy(s.state));
    let moving = [(w, dw), (x, dx), (dx, ddx), (lambda, across), (psi, turn)];
    let rate = moving.iter().fold(Sym::ZERO, |sum, (of, rate)| sum + energy.diff(*of) * *rate);
    let derived = tidy(rate - s.balance[0] * w - s.balance[1] * dx);
    let [name] = letters(["Ė"]);
    let shafts = s.moments[0] * w + s.moments[1] * second;
    page.claim("eq3.17", "power",r"The rim of the printed (3.17) stores energy. Kinetic energy, springs and $-\frac12a\lambda^2-\frac12b\psi^2$ change by the shafts' power alone")
        .under(&Hypotheses::none().given(s.drill, -s.b))
        .why(r"With (3.16) nothing stores the power $-b\psi\omega_2$ of the moment on the disc.")
        .reading(AS_PRINTED)
        .note(r"The moment $-b\psi$ on the disc is that of a rim which sees the disc turn, $\dot\psi=(\alpha\lambda-\beta\psi)R\omega_1-\omega_2$; then $\lambda=\psi=0$ is no motion.")
        .fails([Line::formula(derived, name, shafts)]);
    page.claim(
        "eq3.17",
        "power-corrected",
        r"With a moment $d\psi$ on the disc the rim's energy changes at a rate equal to the shafts' power and $d\psi\omega_2$. Without this moment the rate is the shafts' power alone",
    )
    .holds([Line::formula(derived, name, shafts + s.drill * psi * second)]);
    page.correct();
}

fn stationary(page: &mut Page, s: &ElasticLetters) {
    let [w, x, _, lambda, psi] = s.state;
    let w0 = letter("ω₀");
    page.claim("eq3.18", "motion", r"(3.18) is the motion $\omega_1=\omega_1^0$, $x=x_0$, $\lambda=\psi=0$").defines([
        Line::equation(Sym::ZERO, w, w0),
        Line::equation(Sym::ZERO, x, s.rest),
        Line::equation(Sym::ZERO, lambda, Sym::ZERO),
        Line::equation(Sym::ZERO, psi, Sym::ZERO),
    ]);
    let [turning, sliding] = s.balance.map(|equation| s.stationary(equation));
    let ([c1, c2], [d1, d2]) = (s.springs, s.tensions);
    let [rho, _] = s.lengths(s.rest);
    page.claim(
        "eq3.19",
        "conditions",
        r"(3.18) is a motion under two conditions, one for the moments, one for the springs",
    )
    .holds([
        Line::equation(-turning, s.moments[0] + s.drum / rho * s.moments[1], Sym::ZERO),
        Line::equation(sliding, s.ball.half() * s.rest * w0.powi(2), -c1 * d1 + c2 * d2),
    ]);
}
