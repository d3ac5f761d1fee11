//! Section 7: the equations of motion (16) from the momentum of body, moving particles and gyroscope; the integrals
//! (17).

use super::alphabet::{indexed, int, letter, letters};
use super::top::{TopLetters, vector};
use claims::{Condition, Line, Page};
use field::Tangent;
use mechanics::differentiate::along;
use mechanics::momentum::absolute_rate;
use nalgebra::{Matrix3, Vector3};
use symbolic::Sym;

pub fn claims(page: &mut Page, s: &TopLetters) {
    page.section("7. Equations of motion and integrals");
    equations(page, s);
    integrals(page, s);
}

type Moving = Vector3<Tangent<Sym>>;

/// Claims on (16): a rigid part, a particle of mass m that moves in it at the position xi while mass leaves it with the
/// relative velocity w, and the gyroscope. A, B, C are the moments of the whole at the instant.
fn equations(page: &mut Page, s: &TopLetters) {
    let (m, dm) = (letter("m"), letter("ṁ"));
    let [place, speed, acceleration, leaving]: [Vector3<Sym>; 4] =
        ["ξ#", "ξ̇#", "ξ̈#", "w#"].map(|name| indexed::<3>(name).into());
    let now = s.now();
    let all = Matrix3::from_diagonal(&Vector3::new(now.equatorial, now.equatorial, now.axial));
    let particle = Matrix3::identity() * (m * place.dot(&place)) - place * place.transpose() * m;
    let rigid = (all - particle).map(Tangent::fixed);
    let spin = s.at.spin;
    let rates = vector(["ṗ", "q̇", "ṙ"]);
    let turning: Moving = Vector3::from(along(spin.into(), rates.into()));
    let at: Moving = Vector3::from(along(place.into(), speed.into()));
    let inside: Moving = Vector3::from(along(speed.into(), acceleration.into()));
    let mass = Tangent::moving(m, dm);
    let gyroscope = Vector3::new(Sym::ZERO, Sym::ZERO, now.gyroscope).map(Tangent::fixed);
    let momentum = rigid * turning + at.cross(&(turning.cross(&at) + inside)) * mass + gyroscope;
    // the momentum carried away by the ejected mass
    let taken = place.cross(&(spin.cross(&place) + leaving)) * dm;
    let moment = vector(["X", "Yᴹ", "Z"]);
    let derived = absolute_rate(momentum, spin) - taken - moment;
    let reactive = place.cross(&(leaving - speed)) * dm;
    let relative = -place.cross(&acceleration) * m;
    let coriolis = -place.cross(&spin.cross(&speed)) * (int(2) * m);
    let others = reactive + relative + coriolis;
    let ([p, q, r], [a, c, nu]) = (spin.into(), [now.equatorial, now.axial, now.gyroscope]);
    let right = [
        (a - c) * q * r - nu * q + moment.x + others.x,
        (c - a) * r * p + nu * p + moment.y + others.y,
        moment.z + others.z,
    ];
    let left = [a * rates.x, a * rates.y, c * rates.z];
    page.claim("eq16", "momentum", r"The moment of momentum of a body with the gyroscope $\nu$ and a particle $m(t)$ that moves in it gives (16). The reactive, inertial and Coriolis moment is $M=\dot m\,\xi\times(w-\dot\xi)-m\,\xi\times\ddot\xi-2m\,\xi\times(\omega\times\dot\xi)$, where the mass leaves with the velocity $w$ relative to the body. $\dot A$ does not stand on the left")
        .note("$A$, $B=A$, $C$ are the moments of body and particles at the instant, whose axes are taken to stay principal. Several particles add up. $\\dot\\gamma_i=\\Gamma_i$ is left open by the paper; on a motion $\\dot\\gamma=\\gamma\\times\\omega$.")
        .in_words()
        .follows((0..3).map(|i| Condition::Equal(derived[i], left[i] - right[i])));
    let [mx, my, mz] = letters(["Mx", "My", "Mz"]);
    let solidified = now.residual(spin, rates, moment + Vector3::new(mx, my, mz));
    page.claim(
        "eq16",
        "solidified",
        "The first three equations of (16) hold, with $M_x$, $M_y$, $M_z$ the moments of eq16/momentum",
    )
    .holds([
        Line::equation(solidified.x, left[0], (a - c) * q * r - nu * q + moment.x + mx),
        Line::equation(solidified.y, left[1], (c - a) * r * p + nu * p + moment.y + my),
        Line::equation(solidified.z, left[2], moment.z + mz),
    ]);
}

/// Claims on (17).
fn integrals(page: &mut Page, s: &TopLetters) {
    let now = s.now();
    let [f1, f2, f3] = s.printed_integrals();
    let across = Vector3::new(Sym::ONE, Sym::ZERO, Sym::ZERO);
    let field = now.force_function(s.at.vertical) - now.force_function(across);
    let energy = int(2) * (now.kinetic_energy(s.at.spin) - field);
    page.claim("eq17", "energy", r"(17) is $f_1=2(T-U)$ with $U$ counted from $\gamma_3=0$, in the field of (20)")
        .under(&s.unit)
        .holds([Line::formula(energy, letter("f₁"), f1)]);
    let momentum = now.momentum(s.at.spin).dot(&s.at.vertical);
    page.claim(
        "eq17",
        "momentum",
        "$f_2$ is the moment of momentum about the vertical, including that of the gyroscope",
    )
    .holds([Line::formula(momentum, letter("f₂"), f2)]);
    page.claim("eq17", "axial", r"(17) names $f_3=C(r-r_0)$ and $f_4=\gamma_1^2+\gamma_2^2+\gamma_3^2-1$; $g=\mu_1/R^2$")
        .note("The value of $f_3$ is not printed. It is a constant in general, and zero on the motion that is studied. The constant $\\mu$ below (17) is $\\mu_1$.")
        .defines([]);
    let law = s.top.map(|x| x.value).integrals(&s.at, s.aim);
    page.claim("eq17", "law", "The integrals of the body that this program computes are $f_1$, $f_2$, $f_3$ of (17)")
        .in_words()
        .follows([
            Condition::Equal(law.energy, f1),
            Condition::Equal(law.vertical_momentum, f2),
            Condition::Equal(law.axial_momentum, f3),
        ]);
}
