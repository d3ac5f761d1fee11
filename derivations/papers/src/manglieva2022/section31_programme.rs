//! Section 3.1: the programmed motion of the movable wheel: solution, force and stability, (3.7)-(3.13).

use super::alphabet::{exact, int, letter, letters, tidy};
use super::governor::GovernorLetters;
use claims::{Condition, Line, Page};
use field::{Scalar, Tangent};
use symbolic::{Sym, coefficients};

use Condition::{Equal, Positive};

pub fn claims(page: &mut Page, s: &GovernorLetters) {
    page.section("3.1. The programme of the movable wheel");
    series(page, s);
    force(page, s);
    quadrature(page, s);
    perturbed(page, s);
    persidskii(page, s);
}

/// The condition rho rho' - eps (k1 + k2 rho) of (3.3), with J, M1, M2 expressed by eps, k1, k2.
fn by_small_parameter(s: &GovernorLetters) -> Sym {
    let [epsilon, k1, k2] = letters(["εᵏ", "k₁", "k₂"]);
    let [condition, _] = s.kept();
    let square = s.radius.squared();
    let wheel = int(1) / (epsilon * s.speed) - s.first * square / s.drum.squared();
    tidy((epsilon * square * condition).substitute(&[
        (s.wheel, wheel),
        (s.m1, k2 * s.drum / square),
        (s.m2, k1 / square),
    ]))
}

fn series(page: &mut Page, s: &GovernorLetters) {
    let [epsilon, k1, k2, start] = letters(["εᵏ", "k₁", "k₂", "ϱ₀"]);
    let [r1, r2, r3] = letters(["ϱ^1", "ϱ^2", "ϱ^3"]);
    let [d1, d2, d3] = letters(["ϱ̇^1", "ϱ̇^2", "ϱ̇^3"]);
    let sum = |terms: [Sym; 3]| terms[0] * epsilon + terms[1] * epsilon.powi(2) + terms[2] * epsilon.powi(3);
    page.claim("eq3.7", "series", r"(3.7) is the series $\rho=\rho_0+\sum\varepsilon^i\rho_i$")
        .defines([Line::equation(Sym::ZERO, s.rho, start + sum([r1, r2, r3]))]);
    let residual = by_small_parameter(s).substitute(&[(s.rho, start + sum([r1, r2, r3])), (s.drho, sum([d1, d2, d3]))]);
    let orders = coefficients(residual, &[epsilon]).unwrap_or_default();
    let order = |i: u32| {
        orders.iter().find(|(exponents, _)| exponents[0] == i).map_or(Sym::ZERO, |(_, coefficient)| tidy(*coefficient))
    };
    page.claim("eq3.8", "orders", r"(3.8) are the powers $\varepsilon$, $\varepsilon^2$, $\varepsilon^3$ of $\rho\dot\rho=\varepsilon(k_1+k_2\rho)$")
        .note(r"The equation of the third order is printed as $\rho_0\dot\rho_3=F$, with a function of what is known. That of any order is $\rho_0\dot\rho_n=k_2\rho_{n-1}-\sum_{0<i<n}\rho_i\dot\rho_{n-i}$.")
        .holds([
            Line::equation(order(1), start * d1, k1 + k2 * start),
            Line::equation(order(2), r1 * d1 + start * d2, k2 * r1),
            Line::equation(order(3), start * d3, k2 * r2 - r1 * d2 - r2 * d1),
        ]);
}

fn force(page: &mut Page, s: &GovernorLetters) {
    let [k, k1, k2, rate1, rate2, epsilon] = letters(["k", "k₁", "k₂", "k̇₁", "k̇₂", "εᵏ"]);
    let [growth1, growth2] = letters(["Ṁ1", "Ṁ2"]);
    let square = s.radius.squared();
    let names = s.names().given(rate1, square * growth2).given(rate2, square * growth1 / s.drum);
    let derived: Sym = tidy(s.governor.control_force(Sym::ZERO, s.rho, s.speed));
    let along = k1 / s.rho + k2;
    // the derivative of k1/rho + k2 along k rho' = k1/rho + k2
    let differentiated = rate1 / s.rho - k1 * along / (k * s.rho.powi(2)) + rate2;
    page.claim(
        "eq3.9",
        "force",
        r"As printed, the push is $u=m\ddot\rho=\frac mk\frac d{dt}(k_1/\rho+k_2)-(F_{11}+F_{22})$",
    )
    .why(r"By (3.3) $u=m\ddot\rho+(F_{11}+F_{22})$: the push has to overcome friction, and is not $m\ddot\rho$.")
    .under(&names)
    .fails([Line::formula(derived, s.push, s.mass / k * differentiated - s.friction)]);
    page.claim("eq3.9", "force-corrected", r"The push is $u=\frac mk\frac d{dt}(k_1/\rho+k_2)+(F_{11}+F_{22})$")
        .under(&names)
        .holds([Line::formula(derived, s.push, s.mass / k * differentiated + s.friction)]);
    page.correct();
    let small = names.clone().given(epsilon, int(1) / (s.speed * (s.wheel + s.first * square / s.drum.squared())));
    let expanded = |of_first: Sym, friction: Sym| {
        s.mass / k * ((rate1 * s.rho - k1 * epsilon * along) / s.rho.powi(2) + of_first) + friction
    };
    page.claim(
        "section3.1-control-force",
        "variable",
        r"As printed, the push with the derivative carried out has $-\dot k_2$",
    )
    .why(r"The signs of $\dot k_2$ and of friction are wrong.")
    .under(&small)
    .fails([Line::formula(derived, s.push, expanded(-rate2, -s.friction))]);
    page.claim(
        "section3.1-control-force",
        "variable-corrected",
        r"The push with the derivative carried out has $+\dot k_2$ and $+(F_{11}+F_{22})$",
    )
    .under(&small)
    .holds([Line::formula(derived, s.push, expanded(rate2, s.friction))]);
    page.correct();
    let steady = derived.substitute(&[(growth1, Sym::ZERO), (growth2, Sym::ZERO)]);
    let constant = -(s.mass * epsilon.powi(2) * k1 * along / s.rho.powi(2));
    page.claim(
        "section3.1-control-force",
        "constant",
        "(3.9) with the right sign of friction has no rates of $k_1$ and $k_2$ under constant torques",
    )
    .under(&small)
    .holds([Line::formula(steady, s.push, constant + s.friction)]);
}

fn quadrature(page: &mut Page, s: &GovernorLetters) {
    let [k, k1, k2, start, log] = letters(["k", "k₁", "k₂", "ϱ₀", "ℓ"]);
    // the logarithm as a function of rho: d ln|k2 rho + k1| = k2 d rho / (k2 rho + k1); it is zero at rho_0
    let rho = Tangent::variable(s.rho);
    let fixed = Tangent::fixed;
    let argument = fixed(k2) * rho + fixed(k1);
    let logarithm = |value: Sym| Tangent::moving(value, argument.slope / argument.value);
    let time = |log: Tangent<Sym>| fixed(k / k2) * (rho - fixed(start) - fixed(k1 / k2) * log);
    let drift: Sym = tidy(s.governor.programme(Sym::ZERO, s.rho, s.speed));
    page.claim("eq3.10", "quadrature", r"The condition of the kept speed has the quadrature $t=\frac k{k_2}\left(\rho-\rho_0-\frac{k_1}{k_2}\ln\left|\frac{k_2\rho+k_1}{k_2\rho_0+k_1}\right|\right)$, whose $dt/d\rho$ is $1/\dot\rho$")
        .under(&s.names())
        .note(r"The quadrature holds for $k_2\ne0$. With $k_2=0$ it is $\rho^2=\rho_0^2+2k_1t/k$.")
        .holds([Line::formula(int(1) / drift, int(1) / s.drho, time(logarithm(log)).slope)]);
    let at_start = time(logarithm(Sym::ZERO)).value.substitute(&[(s.rho, start)]);
    page.claim("eq3.10", "start", r"The quadrature (3.10) gives $t=0$ at $\rho=\rho_0$")
        .follows([Condition::Zero(at_start)]);
    let free = drift.substitute(&[(s.m1, Sym::ZERO)]);
    page.claim("eq3.10", "no-first-moment", r"With $M_1=0$ the rate of $\rho^2$ is constant")
        .under(&s.names())
        .follows([Equal(int(2) * s.rho * free, int(2) * k1 / k)]);
}

fn perturbed(page: &mut Page, s: &GovernorLetters) {
    let [k, k1, k2, start, more, drift, drift_more] = letters(["k", "k₁", "k₂", "ϱ₀", "ϱ′", "ϱ̇₀", "ϱ̇′"]);
    let law = |rho: Sym| -> Sym { tidy(s.governor.programme(Sym::ZERO, rho, s.speed)) };
    page.claim("eq3.11", "perturbed", r"(3.11) is the perturbed programme $\rho=\rho_0+\rho'$")
        .defines([Line::equation(Sym::ZERO, s.rho, start + more)]);
    page.claim(
        "eq3.12",
        "perturbed-law",
        r"$\dot\rho_0+\dot\rho'$, expressed by $k_1'=k_1/k$, $k_2'=k_2/k$, is (3.12)",
    )
    .under(&s.names())
    .holds([Line::formula(law(start + more), drift + drift_more, (k1 / (start + more) + k2) / k)]);
    let [scaled, grown] = letters(["k′₁", "Eᵖ"]);
    let names = s.names().given(
        scaled,
        s.radius.squared() * s.m2 / (s.speed * (s.wheel + s.first * s.radius.squared() / s.drum.squared())),
    );
    page.claim("eq3.13", "first-approximation", r"The coefficient of $\rho'$ is $-k_1'/\rho_0^2$")
        .under(&names)
        .holds([Line::formula(tidy(law(start).diff(start)), letter("ν"), -scaled / start.powi(2))]);
    let rest = law(start + more) - law(start) - law(start).diff(start) * more;
    page.claim(
        "eq3.13",
        "remainder",
        r"The remainder is exactly $R=k_1'\rho'^2/(\rho_0^2(\rho_0+\rho'))$, of the second order",
    )
    .under(&names)
    .follows([Equal(rest, scaled * more.powi(2) / (start.powi(2) * (start + more)))]);
    let rate = law(start).diff(start);
    let solution = Tangent::moving(grown, -scaled / start.powi(2) * grown) * Tangent::fixed(more);
    page.claim("eq3.13", "solution", r"$\rho'=\rho_0'e^{-\int k_1'\rho_0^{-2}dt}$ solves the first approximation")
        .in_words()
        .under(&names)
        .follows([Equal(solution.slope, rate * solution.value)]);
}

fn persidskii(page: &mut Page, s: &GovernorLetters) {
    let entry = "section3.1-persidskii";
    let [k, k1, start, time, radius] = letters(["k", "k₁", "ϱ₀", "t", "r₂"]);
    let names = s.names();
    let law = |rho: Sym| -> Sym { tidy(s.governor.programme(Sym::ZERO, rho, s.speed)) };
    let exponent = -law(start).diff(start);
    let nu = letter("ν");
    page.claim(
        entry,
        "exponent",
        r"As printed, the exponent in $|\rho'|=|\rho_0'|\exp(-\int k_1\rho_0^{-2}d\tau)$ has $k_1$",
    )
    .why(r"$k_1$ stands where $k_1'=k_1/k$ of (3.13) should stand.")
    .under(&names)
    .fails([Line::formula(exponent, nu, k1 / start.powi(2))]);
    page.claim(entry, "exponent-corrected", r"The exponent has $k_1'=k_1/k$, as in (3.13)")
        .under(&names)
        .holds([Line::formula(exponent, nu, k1 / (k * start.powi(2)))]);
    page.correct();

    let [a, b] = letters(["ϱa", "ϱb"]);
    page.claim(
        entry,
        "contraction",
        r"Any two motions satisfy $\frac d{dt}(\rho_a-\rho_b)=-\frac{k_1}{k\rho_a\rho_b}(\rho_a-\rho_b)$ exactly",
    )
    .under(&names)
    .follows([Equal(law(a) - law(b), -k1 / (k * a * b) * (a - b))]);

    let premises = [
        Equal(s.rho.powi(2), start.powi(2) + int(2) * k1 * time / k),
        Positive(start),
        Positive(radius - start),
        Positive(s.rho),
        Positive(k1),
        Positive(k),
        Positive(time),
    ];
    page.claim(
        entry,
        "stays",
        r"As printed, with $M_2>M_2'>0$ the motion keeps $0<\rho<r_2$ for all time and satisfies Persidskii's criterion",
    )
    .why(r"With $M_1=0$ the wheel leaves the disc at $t=k(r_2^2-\rho_0^2)/(2k_1)$.")
    .given(premises)
    .refuted(
        [Positive(radius - s.rho)],
        exact([("k", 1, 1), ("k₁", 1, 1), ("ϱ₀", 1, 1), ("r₂", 2, 1), ("t", 4, 1), ("ϱ", 3, 1)]),
    );
    // rho_a = r2 - s_a, rho_b = r2 - s_b, M2 = M2' + an excess
    let [least, more, from_a, from_b] = letters(["M′", "ΔM", "sₐ", "s_b"]);
    let rate = s.radius.powi(2) * (least + more) / (k * a * b);
    let bound = |edge_a: Sym, edge_b: Sym| s.radius.powi(2) * least / (k * edge_a * edge_b);
    let positive = [least, more, from_a, from_b, a, b, k, s.radius].map(Positive);
    page.claim(entry, "stays-corrected", r"While both motions are on the disc, $\rho_{a,b}=r_2-s_{a,b}$, and $M_2=M_2'+\Delta M_2$, the exact rate of contraction exceeds $\alpha=r^2M_2'/(kr_2^2)$")
        .given(positive)
        .by_signs([Positive(rate - bound(a + from_a, b + from_b))]);
    page.correct();
    let free = |rho: Sym| rho * law(rho).substitute(&[(s.m1, Sym::ZERO)]);
    page.claim(entry, "algebraic", r"With $M_1=0$ the difference $\rho_a^2-\rho_b^2$ of two motions does not change")
        .in_words()
        .follows([Condition::Zero(free(a) - free(b))]);
}
