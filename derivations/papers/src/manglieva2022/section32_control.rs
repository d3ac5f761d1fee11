//! Section 3.2: controllability of the linearised equations, (3.30)-(3.32).

use super::alphabet::{exact, letter, letters, tidy};
use super::released::ReleasedLetters;
use algebra::linear::determinant;
use claims::{Condition, Line, Page};
use symbolic::Sym;

use Condition::{NonZero, Positive};

pub fn claims(page: &mut Page, r: &ReleasedLetters) {
    page.section("3.2. Controllability");
    columns(page, r);
    matrix(page, r);
    rank(page, r);
}

fn columns(page: &mut Page, r: &ReleasedLetters) {
    let s = &r.drum;
    let [name1, name2, slope2, name3, det] = letters(["L₁", "L₂", "L̇₂", "L₃", "W"]);
    let inertia = r.inertia();
    page.claim("eq3.30", "matrix", r"The determinant of the matrix $W=\{L_1,L_2,L_3\}$ decides controllability")
        .defines([Line::equation(Sym::ZERO, det, Sym::function("det", name1))]);
    let [first, second, third] = r.krasovskii();
    page.claim("eq3.31", "first", r"The first column is $L_1=(0,0,1)$ as printed, with $L_{i+1}=\dot L_i-PL_i$")
        .why(r"$u_1$ stands in $m\dot z=u_1$: the divisor $m$ is missing.")
        .fails([Line::formula(first[2], name1, Sym::ONE)]);
    page.claim("eq3.31", "first-corrected", r"The column is $L_1=(0,0,\frac1m)$, since $m\dot z=u_1$")
        .holds([Line::formula(s.mass * first[2], s.mass * name1, Sym::ONE)]);
    page.correct();
    let p = r.linear.matrix[0];
    let entries = letters(["p₁₁", "p₁₂", "p₁₃"]);
    let printed = [-(r.n * r.rho * r.drho), r.slope(), -(r.n * s.speed * r.rho)];
    page.claim("eq3.32", "p", "As printed, the first row of $P$ is as below")
        .why(r"(3.29) is not divided by $n\rho_0^2+J_2$, which depends on the time.")
        .under(&r.names())
        .fails((0..3).map(|j| Line::formula(p[j], entries[j], printed[j])));
    page.claim("eq3.32", "p-corrected", r"The first row of $P$ has the divisor $n\rho_0^2+J_2$")
        .under(&r.names())
        .holds((0..3).map(|j| Line::formula(p[j], entries[j], printed[j] / inertia)));
    page.correct();
    let lever = r.n * s.speed * r.rho;
    page.claim("eq3.32", "l2", r"As printed, the column $L_2$ is $(n\omega_2^0\rho_0,-1,0)$")
        .why(r"The divisors $n\rho_0^2+J_2$ and $m$ are missing, as in $P$ and $L_1$.")
        .under(&r.names())
        .fails([Line::formula(second[0], name2, lever)]);
    page.claim("eq3.32", "l2-corrected", r"The column is $L_2=\frac1m(\frac{n\omega_2^0\rho_0}{n\rho_0^2+J_2},-1,0)$")
        .under(&r.names())
        .holds([
            Line::formula(second[0], name2, lever / (inertia * s.mass)),
            Line::formula(s.mass * second[1], s.mass * letter("L₂ₓ"), -Sym::ONE),
        ]);
    page.correct();
    let rate = r.along_programme(second[0]);
    page.claim("eq3.32", "l2-rate", r"As printed, the rate of $L_2$ is $(n\omega_2^0\dot\rho_0,0,0)$")
        .why(r"The divisor $n\rho_0^2+J_2$ is missing and changes too.")
        .under(&r.names())
        .fails([Line::formula(rate, slope2, r.n * s.speed * r.drho)]);
    page.claim(
        "eq3.32",
        "l2-rate-corrected",
        r"The rate of $L_2$ is $n\omega_2^0\dot\rho_0\frac{J_2-n\rho_0^2}{m(n\rho_0^2+J_2)^2}$ in its first component",
    )
    .under(&r.names())
    .holds([Line::formula(
        rate,
        slope2,
        r.n * s.speed * r.drho * (s.second - r.n * r.rho.powi(2)) / (s.mass * inertia.powi(2)),
    )]);
    page.correct();
    let moment = s.m1 / s.drum;
    page.claim("eq3.32", "l3", r"As printed, the column $L_3$ is $(\frac{M_1}R+n^2\omega_2^0\rho_0^2\dot\rho_0,0,0)$")
        .reading(r"The source prints $\frac{\mu_1}r$; $\frac{M_1}R$ is read, as in (3.28).")
        .why(r"The divisors are missing, and the sign of the second term is wrong.")
        .under(&r.names())
        .fails([Line::formula(third[0], name3, moment + r.n.powi(2) * s.speed * r.rho.powi(2) * r.drho)]);
    page.claim("eq3.32", "l3-corrected", r"The right $P$ and $\dot L_2$ give the first component of $L_3$")
        .under(&r.names())
        .holds([Line::formula(third[0], name3, reduced(r) / (s.mass * inertia.powi(2)))]);
    page.correct();
}

/// The expression M1 (n rho_0^2 + J2)/R - n^2 omega2 rho_0^2 rho_0'.
fn reduced(r: &ReleasedLetters) -> Sym {
    let s = &r.drum;
    s.m1 / s.drum * r.inertia() - r.n.powi(2) * s.speed * r.rho.powi(2) * r.drho
}

fn matrix(page: &mut Page, r: &ReleasedLetters) {
    let s = &r.drum;
    let columns = r.krasovskii();
    let det = tidy(determinant(&columns).unwrap_or(Sym::ZERO));
    let name = letter("W");
    // printed: L2 = (n omega2 rho_0', -1, 0), L3 with a product; L1 = (0, 0, 1)
    let moment = s.m1 / s.drum;
    let printed = moment * r.n.powi(2) * s.speed * r.rho.powi(2) * r.drho;
    page.claim(
        "eq3.32",
        "w",
        r"$\det W$ is that of the printed matrix, with $\dot\rho_0$ in $L_2$ and a product in $L_3$",
    )
    .why(r"The sum in $L_3$ is printed as a product; the divisors and the sign are those of $L_3$.")
    .under(&r.names())
    .fails([Line::formula(det, name, printed)]);
    page.claim("eq3.32", "w-corrected", r"The right columns give $\det W$").under(&r.names()).holds([Line::formula(
        det,
        name,
        reduced(r) / (s.mass.powi(3) * r.inertia().powi(2)),
    )]);
    page.correct();
}

fn rank(page: &mut Page, r: &ReleasedLetters) {
    let s = &r.drum;
    let entry = "section3.2-controllability";
    let det = tidy(determinant(&r.krasovskii()).unwrap_or(Sym::ZERO));
    let w = r.rho.powi(2) * r.drho * s.speed;
    page.claim(entry, "rank", r"As printed, the rank of $W$ is 3 because $w=\rho_0^2\dot\rho_0\omega_2^0\ne0$")
        .why(r"$\det W$ is a difference of two terms, which can cancel where $w\ne0$.")
        .given(s.real())
        .given([Positive(r.rho), NonZero(w)])
        .refuted(
            [NonZero(det)],
            exact([
                ("J1", 1, 1),
                ("J2", 1, 1),
                ("J", 1, 1),
                ("m", 1, 1),
                ("R", 1, 1),
                ("r", 1, 1),
                ("M1", 2, 1),
                ("ω2", 1, 1),
                ("ϱ₀", 1, 1),
                ("ϱ̇₀", 3, 2),
            ]),
        );
    let programme = (s.m2 + r.rho * s.m1 / s.drum) / (s.reduced() * r.rho * s.speed);
    let condition = s.m1 * s.second / s.drum - r.n * r.rho * s.m2;
    let names = r.names().given(r.drho, programme);
    let name = letter("W");
    page.claim(entry, "rank-corrected", r"On the programme $\det W$ is proportional to $J_2M_1/R-n\rho_0M_2$")
        .under(&names)
        .holds([Line::formula(det, name, condition / (s.mass.powi(3) * r.inertia().powi(2)))]);
    page.correct();
    page.claim(entry, "resting-wheel", r"With $\dot\rho_0=0$, $w=0$, the determinant of $W$ vanishes with $M_1$ alone")
        .under(&r.names())
        .follows([Condition::Equal(
            det.substitute(&[(r.drho, Sym::ZERO)]),
            s.m1 / (s.drum * s.mass.powi(3) * r.inertia()),
        )]);
}
