//! Section 8: the two classical gyrostats without a motor.

use super::alphabet::{cyclic, letter, vector};
use super::letters::Letters;
use claims::{Condition, Line, Page};
use mechanics::differentiate::along;
use mechanics::momentum::absolute_rate;
use motor::FreeRotor;
use nalgebra::Vector3;
use symbolic::Sym;
use systems::gyrostat::MotionInstant;
use systems::gyrostat::driven::Driven;
use systems::gyrostat::forms::{FirstForm, Form, SecondForm};

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("8. Gyrostats without a motor");
    constant_speed(page, s);
    free_rotor(page, s);
}

/// Claims on 8.1: the rotor with the prescribed relative speed W.
fn constant_speed(page: &mut Page, s: &Letters) {
    let g = s.in_axes_of_a_star();
    let motion = MotionInstant { rotor_speed: s.omega_field, rotor_acceleration: Sym::ZERO, ..s.motion() };
    let residual = g.by_momentum(&motion);
    let gyrostatic = s.l * (s.axial * s.omega_field);
    let right = (s.a_star.component_mul(&s.w) + gyrostatic).cross(&s.w) + s.e.cross(&s.nu) * s.big_gamma;
    page.claim(
        "eq8.1",
        "carrier",
        r"(8.1) is $A^*\dot\omega = (A^*\omega + \lambda^*)\times\omega + \Gamma e\times\nu$, where $\lambda^* = A'\Omega l$",
    )
    .under(&s.unit_axis)
    .holds((0..3).map(|i| Line::equation(residual[i], s.a_star[i] * s.dw[i], right[i])));
    let dnu = vector("ν̇");
    let absolute = absolute_rate(Vector3::from_fn(|i, _| field::Tangent::moving(s.nu[i], dnu[i])), s.w);
    page.claim("eq8.1", "vertical", r"(8.1) contains $\dot\nu = \nu\times\omega$")
        .holds((0..3).map(|i| Line::equation(absolute[i], dnu[i], s.nu.cross(&s.w)[i])));
    page.claim("section8.1", "reaction", r"At constant rotor speed the rotor's equation gives the moment that keeps it, $M = A'\,l\cdot\dot\omega$, and restricts nothing")
        .in_words()
        .under(&s.unit_axis)
        .follows([Condition::Equal(residual[3], s.axial * s.l.dot(&s.dw) - s.torque)]);
    let still = MotionInstant { torque: Sym::ZERO, ..s.stationary(s.omega_field, Sym::ZERO) };
    let stationary = g.by_momentum(&still);
    page.claim(
        "section8.1",
        "conditions",
        "Stationary motions of the gyrostat with a constant rotor speed satisfy (6.5), as those with the synchronous motor do",
    )
    .in_words()
    .under(&s.unit_axis)
    .follows((0..3).map(|i| Condition::Equal(-stationary[i], s.conditions()[i])));
}

/// Claims on 8.2: the free rotor, in both forms.
fn free_rotor(page: &mut Page, s: &Letters) {
    let p = letter("p′");
    let rest = letter("Ω⁰");
    // first form: the relative speed that corresponds to p'
    let first = s.in_axes_of_a();
    let free = MotionInstant {
        rotor_speed: p - s.w.dot(&s.l),
        rotor_acceleration: -s.l.dot(&s.dw),
        torque: Sym::ZERO,
        ..s.motion()
    };
    let residual = first.by_momentum(&free);
    let right = (s.a.component_mul(&s.w) + s.l * (s.axial * p)).cross(&s.w) + s.e.cross(&s.nu) * s.big_gamma;
    page.claim(
        "section8.2",
        "first-form",
        r"The first form is $A\dot\omega = (A\omega + \lambda)\times\omega + \Gamma e\times\nu$, where $\lambda = A'p'l$ with constant $p'$",
    )
    .under(&s.unit_axis)
    .holds((0..3).map(|i| Line::equation(residual[i], s.a[i] * s.dw[i], right[i])));
    page.claim(
        "section8.2",
        "integral",
        r"$p'$ is an integral, since with $M = 0$ the rotor's equation is $A'\dot p' = 0$",
    )
    .under(&s.unit_axis)
    .follows([Condition::Zero(residual[3])]);
    let forms = (
        FirstForm::new(s.a, s.l, s.axial, s.e * s.big_gamma),
        SecondForm::new(s.a_star, s.l, s.axial, s.e * s.big_gamma),
    );
    page.claim("section8.2", "runs", r"$p'$ of a free rotor has no rate along the motions that the program integrates, in the first form and in the second")
        .under(&s.unit_axis)
        .follows([spin_rate(forms.0, s), spin_rate(forms.1, s)].map(Condition::Zero));
    let still = MotionInstant { torque: Sym::ZERO, ..s.stationary(p - s.omega0 * s.nu.dot(&s.l), Sym::ZERO) };
    let stationary = first.by_momentum(&still);
    let to_first: Vec<(Sym, Sym)> = (0..3).map(|i| (s.a_star[i], s.a[i])).chain([(s.omega_field, p)]).collect();
    let printed = s.conditions().map(|x| x.substitute(&to_first));
    page.claim(
        "section8.2",
        "conditions-first",
        r"Stationary motions of a free rotor in the axes of $A$ satisfy (6.5) with $A_i$ for $A_i^*$ and $p'$ for $\Omega$",
    )
    .in_words()
    .under(&s.unit_axis)
    .follows((0..3).map(|i| Condition::Equal(-stationary[i], printed[i])));
    let (s_star, pi_star) = (s.s_star().substitute(&to_first), s.pi_star());
    page.claim(
        "section8.2",
        "cones-first",
        r"With $A_i$ and $p'$ in (6.5), $e\cdot(6.5) = \omega^0(\omega^0 S - A'p'\Pi)$. A rotation of a free rotor has $\omega^0 S = A'p'\Pi$, which is a cone of its own for each $p'$",
    )
    .in_words()
    .follows([Condition::Equal(s.e.dot(&printed), s.omega0 * (s.omega0 * s_star - s.axial * p * pi_star))]);

    // second form
    let second = s.in_axes_of_a_star();
    let conditions = cyclic(|_, j, k| {
        let w = s.nu * s.omega0;
        (s.a_star[j] - s.a_star[k]) * w[j] * w[k]
            + s.axial * rest * (s.l[j] * w[k] - s.l[k] * w[j])
            + s.big_gamma * (s.e[j] * s.nu[k] - s.e[k] * s.nu[j])
    });
    let still = second.by_momentum(&s.stationary(rest, Sym::ZERO));
    page.claim("eq8.2", "conditions", r"The stationary motions of a free rotor in the axes of $A^*$ satisfy (6.5) with the arbitrary $\Omega^0 = \dot\varphi'(t_0)$ and $\omega = \omega^0\nu$")
        .under(&s.unit_axis)
        .holds((0..3).map(|i| Line::equation(-still[i], conditions[i], Sym::ZERO)));
    let w = s.w;
    let absolute = absolute_rate(s.nu.map(field::Tangent::fixed), w);
    let kinematic = cyclic(|_, j, k| w[k] * s.nu[j] - w[j] * s.nu[k]);
    page.claim("eq8.3", "vertical", r"For a constant vertical $\omega_3\nu_2 - \omega_2\nu_3 = 0$ and cyclically")
        .holds((0..3).map(|i| Line::equation(-absolute[i], kinematic[i], Sym::ZERO)));
    page.claim("section8.2", "second-form", r"The rotor's equation with $M = 0$ holds at any constant state")
        .under(&s.unit_axis)
        .follows([Condition::Zero(still[3])]);
    let same = s.l * (s.axial * (s.omega0 * s.l.dot(&s.nu) + rest));
    let dyad = s.l * s.l.transpose() * s.axial;
    let nu = s.nu * s.omega0;
    let difference = (dyad * nu + s.l * (s.axial * rest) - same).cross(&nu);
    page.claim("section8.2", "same-motions", r"Both forms give the same stationary motions of a free rotor: $(A^*-A)\omega + A'\Omega^0l - A'p'l$, the difference of the momenta, is zero in its vector product with $\omega=\omega^0\nu$ where $p' = \omega^0\,l\cdot\nu + \Omega^0$")
        .in_words()
        .follows(difference.iter().map(|&x| Condition::Zero(x)));
}

/// The rate (A'p')' along the integrated motion with a free rotor.
fn spin_rate(form: impl Form<Sym>, s: &Letters) -> Sym {
    let driven = Driven::new(form, FreeRotor::default());
    let state = [s.w.x, s.w.y, s.w.z, s.nu.x, s.nu.y, s.nu.z, s.dphi];
    let mut rates = [Sym::ZERO; 7];
    driven.rates(&state, &mut rates);
    driven.rotor_momentum(&along(state, rates)).slope
}
