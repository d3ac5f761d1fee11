//! Section 3.2: the criterion, Bellman's function and Riccati's equation, (3.33)-(3.37).
//!
//! The criterion adds squares of quantities with different dimensions: its units are represented by the weights q1, q2,
//! q3 and s.

use super::alphabet::{exact, int, letter, letters, tidy};
use super::released::ReleasedLetters;
use claims::{Condition, Line, Page};
use mechanics::bellman::quadratic;
use symbolic::{Hypotheses, Sym};

use Condition::{Equal, NonZero, Zero};

pub fn claims(page: &mut Page, r: &ReleasedLetters) {
    page.section("3.2. Optimal stabilisation");
    criterion(page, r);
    function(page, r);
    riccati(page, r);
    ends(page, r);
}

fn criterion(page: &mut Page, r: &ReleasedLetters) {
    let s = &r.drum;
    let ([zeta, more, z], u) = (r.deviation, r.control);
    let [density, dzeta, n1, slope] = letters(["B", "ζ̇", "n₁", "S₁′"]);
    page.claim("eq3.33", "criterion", r"(3.33) is the integrand of the criterion, integrated from 0 to $\infty$")
        .defines([Line::equation(Sym::ZERO, density, zeta.powi(2) + more.powi(2) + z.powi(2) + u.powi(2))]);
    let rates = r.linear.apply(r.deviation);
    let inertia = r.inertia();
    let by = |lever: Sym, of_second: Sym| (-(lever * zeta) - r.n * s.speed * r.rho * z + r.slope() * more) / of_second;
    page.claim("eq3.34", "normal", r"As printed, $\dot\zeta$ in normal form has $n\rho_0\cdot n\dot\rho_0$ and $J^2$")
        .under(&r.names())
        .why(r"A factor $n$ stands twice, and $J^2$ stands where $J_2$ should stand.")
        .reading(r"From (3.34) on the source writes $\xi$ for $\zeta$ itself.")
        .fails([Line::formula(rates[0], dzeta, by(r.n * r.rho * r.n * r.drho, r.n * r.rho.powi(2) + s.wheel.powi(2)))]);
    page.claim("eq3.34", "normal-corrected", r"$\dot\zeta$ in normal form has $n\rho_0\dot\rho_0$ and $J_2$")
        .under(&r.names())
        .holds([Line::formula(rates[0], dzeta, by(r.n * r.rho * r.drho, inertia))]);
    page.correct();
    let row = r.linear.matrix[0];
    let lever = -(row[2] / (s.speed * r.rho));
    page.claim(
        "eq3.34",
        "names",
        r"As printed, the abbreviations are $n_1=\frac n{\omega\rho_0^2+J^2}$ and $S_1'=\frac{M_1-n\omega_2^0\dot\rho_0}{n\rho_0^2+J_2}$",
    )
    .why(r"$\omega$ stands where $n$ should stand, $J^2$ where $J_2$ should stand, and the divisor $R$ of $M_1$ is missing.")
    .under(&r.names())
    .fails([
        Line::formula(lever, n1, r.n / (s.speed * r.rho.powi(2) + s.wheel.powi(2))),
        Line::formula(row[1], slope, (s.m1 - r.n * s.speed * r.drho) / inertia),
    ]);
    page.claim("eq3.34", "names-corrected", r"The abbreviations have $n\rho_0^2+J_2$ below and $M_1/R$")
        .under(&r.names())
        .holds([Line::formula(lever, n1, r.n / inertia), Line::formula(row[1], slope, r.slope() / inertia)]);
    page.correct();
}

fn function(page: &mut Page, r: &ReleasedLetters) {
    let s = &r.drum;
    let ([zeta, more, z], u) = (r.deviation, r.control);
    let [c11, c22, c33, c12, c13, c23] = letters(["C₁₁", "C₂₂", "C₃₃", "C₁₂", "C₁₃", "C₂₃"]);
    let rates = letters(["Ċ₁₁", "Ċ₂₂", "Ċ₃₃", "Ċ₁₂", "Ċ₁₃", "Ċ₂₃"]);
    let [d11, d22, d33, d12, d13, d23] = rates;
    let [value, name] = letters(["Vᴮ", "B"]);
    let squares = c11 * zeta.powi(2) + c22 * z.powi(2) + c33 * more.powi(2);
    let two = int(2);
    page.claim(
        "eq3.35",
        "value",
        r"$V$, printed with $2C_{12}\xi z+C_{23}\rho'z$, is the form whose gradient Bellman's function uses",
    )
    .why(r"Two products are missing or misprinted: $2C_{12}\zeta\rho'$ and $2C_{13}\zeta z$ stand in one term, and the 2 of $C_{23}$ is missing.")
    .fails([Line::formula(
        quadratic(r.value, r.deviation),
        value,
        squares + two * c12 * zeta * z + c23 * more * z,
    )]);
    page.claim("eq3.35", "value-corrected", r"$V$ has the products $2C_{12}\zeta\rho'+2C_{13}\zeta z+2C_{23}\rho'z$")
        .holds([Line::formula(
            quadratic(r.value, r.deviation),
            value,
            squares + two * c12 * zeta * more + two * c13 * zeta * z + two * c23 * more * z,
        )]);
    page.correct();

    let entry = "section3.2-bellman";
    let regulator = r.regulator();
    let moved = quadratic([[d11, d12, d13], [d12, d33, d23], [d13, d23, d22]], r.deviation);
    let derived = moved + regulator.bellman(r.value, r.deviation, u);
    let [q1, q2, q3, price] = r.weights;
    let [n1, slope] = letters(["n₁", "S₁′"]);
    let weighed = q1 * zeta.powi(2) + q2 * z.powi(2) + q3 * more.powi(2) + price * u.powi(2);
    let gradient = [
        two * c11 * zeta + two * c12 * more + two * c13 * z,
        two * c33 * more + two * c12 * zeta + two * c23 * z,
        two * c22 * z + two * c13 * zeta + two * c23 * more,
    ];
    let turning = |lever: Sym| -(n1 * lever * zeta) - n1 * s.speed * r.rho * z + slope * more;
    let printed = d11 * zeta.powi(2)
        + d22 * z.powi(2)
        + c33 * more.powi(2)
        + two * c12 * zeta * z
        + two * c13 * zeta * z
        + d23 * more * z
        + gradient[0] * turning(r.rho * r.rho)
        + two * c22 * z
        + two * c13 * zeta
        + two * c23 * more * u
        + gradient[1] * z
        + weighed;
    let names = r.normal_names();
    page.claim(entry, "function", "Bellman's function is the printed one, without dots, brackets, a factor 2 and $m$")
        .under(&with_unit_weights(r, names.clone()))
        .why(r"Dots over $C_{33}$, $C_{12}$, $C_{13}$, the bracket around $\partial V/\partial z$, a factor 2 and $1/m$ are missing, and $\rho_0^2$ stands where $\rho_0\dot\rho_0$ should stand.")
        .fails([Line::formula(derived, name, printed)]);
    let right = d11 * zeta.powi(2)
        + d22 * z.powi(2)
        + d33 * more.powi(2)
        + two * d12 * zeta * more
        + two * d13 * zeta * z
        + two * d23 * more * z
        + gradient[0] * turning(r.rho * r.drho)
        + gradient[1] * z
        + gradient[2] * u / s.mass
        + weighed;
    page.claim(
        entry,
        "function-corrected",
        r"Bellman's function is $B=\partial V/\partial t+\nabla V\cdot(Ax+bu_1)+$ the integrand",
    )
    .under(&names)
    .holds([Line::formula(derived, name, right)]);
    page.correct();
    let slope = regulator.bellman(r.value, r.deviation, u).diff(u);
    let push = letter("u₁");
    page.claim(
        entry,
        "least",
        r"As printed, at the minimum of $B$, $\partial B/\partial u_1=2u_1+2C_{22}z+2C_{13}\xi+2C_{23}\rho^{\prime}=0$",
    )
    .under(&with_unit_weights(r, Hypotheses::none()))
    .why(r"By $m\dot z=u_1$ the bracket has the factor $1/m$, which is missing.")
    .fails([Line::equation(slope, two * price * push, -gradient[2])]);
    page.claim(
        entry,
        "least-corrected",
        r"At the minimum of $B$, $\partial B/\partial u_1=2su_1+\frac1m(2C_{22}z+2C_{13}\zeta+2C_{23}\rho')=0$",
    )
    .holds([Line::equation(slope, two * price * push, -gradient[2] / s.mass)]);
    page.correct();
}

fn riccati(page: &mut Page, r: &ReleasedLetters) {
    let s = &r.drum;
    let [c11, c22, c33, c12, c13, c23] = letters(["C₁₁", "C₂₂", "C₃₃", "C₁₂", "C₁₃", "C₂₃"]);
    let [n1, slope] = letters(["n₁", "S₁′"]);
    let [q1, q2, q3, price] = r.weights;
    let rates = r.regulator().riccati(r.value).map(|row| row.map(tidy));
    let (damping, lever) = (n1 * r.rho * r.drho, n1 * s.speed * r.rho);
    let two = int(2);
    // m is missing in all six equations; n1 is printed as u1 in three of them
    let of = |unit: Sym| {
        [
            two * c11 * damping + c13.powi(2) / unit - q1,
            two * c13 * lever + c22.powi(2) / unit - two * c23 - q2,
            -(two * c12 * slope) + c23.powi(2) / unit - q3,
            lever * c11 + c13 * damping + c13 * c22 / unit - c12,
            -(c11 * slope) + c12 * damping + c13 * c23 / unit,
            lever * c12 - slope * c13 - c33 + c22 * c23 / unit,
        ]
    };
    let [first, second, third, ..] = of(price);
    let printed = [
        first,
        second,
        third,
        lever * c11 + c13 * damping + two * c13 * c22 / price - two * c12,
        -(c11 * slope) + c12 * damping + two * c13 * c23 / price,
        lever * c12 - slope * c13 + two * c22 * c23 / price,
    ];
    let (lost, twice) =
        (r"The factor $1/m^2$ is missing. With $m=1$ the equation is right.", r"The factor $1/m^2$ is missing, and");
    let lines = [
        ("c11", "c11-corrected", r"the equation of $\dot C_{11}$", lost.to_owned(), rates[0][0], "Ċ₁₁"),
        ("c22", "c22-corrected", r"the equation of $\dot C_{22}$", lost.to_owned(), rates[2][2], "Ċ₂₂"),
        ("c33", "c33-corrected", r"the equation of $\dot C_{33}$", lost.to_owned(), rates[1][1], "Ċ₃₃"),
        (
            "c13",
            "c13-corrected",
            r"the equation of $\dot C_{13}$",
            format!("{twice} $2C_{{13}}C_{{22}}-2C_{{12}}$ is twice the right one."),
            rates[0][2],
            "Ċ₁₃",
        ),
        (
            "c12",
            "c12-corrected",
            r"the equation of $\dot C_{12}$",
            format!("{twice} $2C_{{13}}C_{{23}}$ is twice the right one."),
            rates[0][1],
            "Ċ₁₂",
        ),
        (
            "c23",
            "c23-corrected",
            r"the equation of $\dot C_{23}$",
            format!("{twice} $2C_{{22}}C_{{23}}$ is twice the right one. Besides, $-C_{{33}}$ is missing."),
            rates[1][2],
            "Ċ₂₃",
        ),
    ];
    let right = of(price * s.mass.powi(2));
    let names = r.normal_names();
    for (k, (slug, corrected, says, why, derived, name)) in lines.into_iter().enumerate() {
        page.claim("eq3.36", slug, format!("As printed, {says} is right"))
            .under(&with_unit_weights(r, names.clone()))
            .why(why)
            .reading(match slug {
                "c22" => "The source prints $C_{22}$ without its dot, which is restored.",
                "c13" | "c12" | "c23" => "The source prints $u_1$ for $n_1$, which (3.34) has: $n_1$ is read.",
                _ => "",
            })
            .fails([Line::formula(derived, letter(name), printed[k])]);
        page.claim("eq3.36", corrected, format!("Bellman's equation with these weights gives {says}"))
            .under(&names)
            .holds([Line::formula(derived, letter(name), right[k])]);
        page.correct();
    }
    let [zeta, more, z] = r.deviation;
    let optimal = r.regulator().optimal(r.value, r.deviation);
    page.claim("eq3.37", "control", r"As printed, the optimal control is $u_1=-(c_{33}z+c_{13}\xi+c_{23}\rho')$")
        .under(&with_unit_weights(r, Hypotheses::none()))
        .why(r"$c_{33}$ stands where $c_{22}$ should stand, and the factor $1/m$ is missing.")
        .fails([Line::formula(optimal, r.control, -(c33 * z + c13 * zeta + c23 * more) / price)]);
    page.claim(
        "eq3.37",
        "control-corrected",
        r"The optimal control is $u_1=-\frac1{sm}(C_{22}z+C_{13}\zeta+C_{23}\rho')$",
    )
    .holds([Line::formula(optimal, r.control, -(c22 * z + c13 * zeta + c23 * more) / (price * s.mass))]);
    page.correct();
}

/// The paper's weights of the criterion: all of them 1, each in its own unit.
fn with_unit_weights(r: &ReleasedLetters, names: Hypotheses) -> Hypotheses {
    r.weights.into_iter().fold(names, |names, weight| names.given(weight, Sym::ONE))
}

/// Claims on c(0) = 0: the condition belongs to the final time.
fn ends(page: &mut Page, r: &ReleasedLetters) {
    let names = ["C₁₁", "C₂₂", "C₃₃", "C₁₂", "C₁₃", "C₂₃"];
    let [zeta, ..] = r.deviation;
    page.claim(
        "eq3.36",
        "initial",
        "As printed, $c_{ij}(0)=0$ and $V$ is positive definite at any time, therefore also at $t=0$",
    )
    .why(r"With $c_{ij}(0)=0$ the form vanishes at $t=0$; the condition belongs to the other end of the interval.")
    .given(letters::<6>(names).map(Zero))
    .given([NonZero(zeta)])
    .refuted(
        [NonZero(quadratic(r.value, r.deviation))],
        exact([
            ("C₁₁", 0, 1),
            ("C₂₂", 0, 1),
            ("C₃₃", 0, 1),
            ("C₁₂", 0, 1),
            ("C₁₃", 0, 1),
            ("C₂₃", 0, 1),
            ("ζ", 1, 1),
            ("ϱ′", 0, 1),
            ("z", 0, 1),
        ]),
    );
    let regulator = r.regulator();
    let moved = quadratic(regulator.riccati(r.value), r.deviation);
    let derived = moved + regulator.bellman(r.value, r.deviation, r.control);
    let away = r.control - regulator.optimal(r.value, r.deviation);
    let [_, _, _, price] = r.weights;
    page.claim(
        "eq3.36",
        "initial-corrected",
        r"Where $C$ satisfies Riccati's equation, $B=s(u_1-u_1^{opt})^2$ for every $u_1$",
    )
    .note(
        r"Integrated, the criterion from 0 to $T$ is $V(0)-V(T)+\int s(u_1-u_1^{opt})^2dt$: the condition is $C(T)=0$.",
    )
    .in_words()
    .follows([Equal(derived, price * away.powi(2))]);
    page.correct();
}
