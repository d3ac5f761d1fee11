//! Section 4: the first form of the equations of motion, in the principal axes of A.

use super::alphabet::{cyclic, letter, tensor, vector};
use super::letters::Letters;
use super::section2::formulas;
use super::section3::{WithFriction, current_equations, friction};
use claims::{Condition, Line, Page};
use field::{Scalar, Tangent};
use mechanics::differentiate::along;
use mechanics::momentum::absolute_rate;
use mechanics::rotation::{angular_velocity, euler, vertical};
use nalgebra::Vector3;
use symbolic::Sym;
use systems::gyrostat::driven::Driven;
use systems::gyrostat::forms::{FirstForm, Form};

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("4. First form of the equations");
    momentum_theorem(page, s);
    page.claim(
        "eq4.2",
        "components",
        "(4.2) names the components of the unit vector $e$ from $O$ to the centre of mass",
    )
    .defines([]);
    first_form(page, s);
    kinematics(page, s);
    currents(page, s);
    solved(page, s);
}

/// Claims on (4.1) in arbitrary axes, from the mass points.
fn momentum_theorem(page: &mut Page, s: &Letters) {
    let full = tensor("A⋆");
    let residual = s.with_reduced_tensor(full - s.l * s.l.transpose() * s.axial).by_momentum(&s.motion());
    let x = full * s.w + s.l * (s.axial * s.dphi);
    let rate = full * s.dw + s.l * (s.axial * s.ddphi);
    let gained = x.cross(&s.w) + s.e.cross(&s.nu) * s.big_gamma;
    let g = s.general();
    let weight = g.weight();
    page.claim("eq4.1", "theorem", r"(4.1) is the theorem of angular momentum, $d'x/dt = x\times\omega + \Gamma e\times\nu$, with $\Gamma e = g(m^0c^0 + m'h)$")
        .under(&s.unit_axis)
        .holds((0..3).map(|i| Line::equation(residual[i], rate[i], gained[i])));
    page.claim("eq4.1", "weight", r"$m c$ is the first moment: $\Gamma e = m g c$ with $c = (m^0c^0 + m'h)/m$").holds(
        (0..3).map(|i| {
            let c = (g.carrier.mass * g.carrier.centre[i] + s.m_rotor * s.h[i]) / (g.carrier.mass + s.m_rotor);
            Line::formula(weight[i], s.big_gamma * s.e[i], (g.carrier.mass + s.m_rotor) * g.gravity * c)
        }),
    );
}

fn first_form(page: &mut Page, s: &Letters) {
    let g = s.in_axes_of_a();
    let (a, w, l, nu, e) = (s.a, s.w, s.l, s.nu, s.e);
    let [x, _] = g.angular_momentum(w, s.dphi);
    let p = w.dot(&l) + s.dphi;
    page.claim(
        "eq4.3",
        "momentum",
        "$x$ in the principal axes of $A$ has the components that stand unnumbered before (4.3)",
    )
    .under(&s.unit_axis)
    .holds(formulas(vector("x"), x, cyclic(|i, _, _| a[i] * w[i] + s.axial * p * l[i])));

    let right = |spin: Sym| {
        cyclic(|i, j, k| {
            (a[j] - a[k]) * w[j] * w[k]
                + s.axial * spin * (l[j] * w[k] - l[k] * w[j])
                + s.big_gamma * (e[j] * nu[k] - e[k] * nu[j])
                - l[i] * s.torque
        })
    };
    let less_rotor = |motion| {
        let [r1, r2, r3, rotor] = g.by_momentum(&motion);
        Vector3::new(r1, r2, r3) - l * rotor
    };
    let by_momentum = less_rotor(s.motion());
    page.claim(
        "eq4.3",
        "carrier",
        "The first form of the carrier's equations is (4.3), where the rotor's equation (2.9) is used",
    )
    .under(&s.unit_axis)
    .holds((0..3).map(|i| Line::equation(by_momentum[i], a[i] * s.dw[i], right(p)[i])));
    let [r1, r2, r3, rotor] = g.by_appell(&s.motion());
    let by_appell = Vector3::new(r1, r2, r3) - l * rotor;
    page.claim(
        "eq4.3",
        "by-appell",
        "Appell's equations, from the acceleration energy of the mass points, give (4.3), the first form of the carrier's equations",
    )
    .under(&s.unit_axis)
    .holds((0..3).map(|i| Line::equation(by_appell[i], a[i] * s.dw[i], right(p)[i])));

    let from_field = less_rotor(s.motion_from_field());
    let spin = w.x * l.x + w.y * l.y + w.z * l.z + s.dgamma + s.omega_field;
    page.claim(
        "eq4.4",
        "carrier",
        r"The first form of the carrier's equations with $p' = \omega\cdot l + \dot\gamma + \Omega$ is (4.4)",
    )
    .under(&s.unit_axis)
    .holds((0..3).map(|i| Line::equation(from_field[i], a[i] * s.dw[i], right(spin)[i])));
    let rotor = g.by_momentum(&s.motion_from_field())[3];
    let right = -(s.axial * (l.x * s.dw.x + l.y * s.dw.y + l.z * s.dw.z)) + s.torque;
    page.claim("eq4.5", "rotor", "The rotor's equation in the angle from the field is (4.5)")
        .under(&s.unit_axis)
        .holds([Line::equation(rotor, s.axial * s.ddgamma, right)]);
}

/// Claims on (4.6) from the constancy of the vertical in space, and from the rotation matrix of Euler angles.
fn kinematics(page: &mut Page, s: &Letters) {
    let (w, nu, dnu) = (s.w, s.nu, vector("ν̇"));
    let absolute = absolute_rate(Vector3::from_fn(|i, _| Tangent::moving(nu[i], dnu[i])), w);
    let printed = |w: Vector3<Sym>, nu: Vector3<Sym>| {
        Vector3::new(w.z * nu.y - w.y * nu.z, w.x * nu.z - w.z * nu.x, w.y * nu.x - w.x * nu.y)
    };
    let right = printed(w, nu);
    page.claim("eq4.6", "vertical", "The vertical is at rest in space")
        .holds((0..3).map(|i| Line::equation(absolute[i], dnu[i], right[i])));

    let angles = ["ψ", "θ", "φ"].map(letter);
    let rates = ["ψ̇", "θ̇", "φ̇"].map(letter);
    let turning = euler(along(angles, rates));
    let moving = vertical(&turning);
    let right = printed(angular_velocity(turning), moving.map(|x| x.value));
    page.claim("eq4.6", "from-angles", r"$\dot\nu = \nu\times\omega$ follows from the rotation matrix $R$ of Euler's angles, where $\nu$ is the third row of $R$ and $[\omega] = R^T\dot R$")
        .in_words()
        .follows((0..3).map(|i| Condition::Equal(moving[i].slope, right[i])));
}

/// Claims on (4.7): the currents of the motor in the gyrostat, as in the first-order equations that are integrated.
fn currents(page: &mut Page, s: &Letters) {
    let bars = 3;
    let form = FirstForm::new(s.a, s.l, s.axial, s.e * s.big_gamma);
    let machine = WithFriction { machine: s.motor(bars), friction: friction(s.dgamma + s.omega_field) };
    let mechanical = [s.w.x, s.w.y, s.w.z, s.nu.x, s.nu.y, s.nu.z, s.gamma, s.dgamma];
    let state: Vec<Sym> = mechanical.into_iter().chain(s.currents(bars)).collect();
    let mut rates = vec![Sym::ZERO; state.len()];
    Driven::new(form, machine).rates(&state, &mut rates);
    page.claim(
        "eq4.7",
        "currents",
        "The equations of the currents that the program integrates with $n_2 = 3$ are those of (4.7)",
    )
    .holds(current_equations(s, bars, &rates[mechanical.len()..]));
}

/// Claims: the accelerations of the integrated equations satisfy the derived equations.
fn solved(page: &mut Page, s: &Letters) {
    let g = s.in_axes_of_a();
    let form = FirstForm::new(s.a, s.l, s.axial, s.e * s.big_gamma);
    let (dw, ddphi) = form.accelerations(s.w, s.nu, s.dphi, s.torque);
    let motion = systems::gyrostat::MotionInstant { angular_acceleration: dw, rotor_acceleration: ddphi, ..s.motion() };
    page.claim("eq4.3", "runs", "In the first form, the accelerations that the program integrates satisfy the angular momentum equations of the mass points")
        .under(&s.unit_axis)
        .follows(g.by_momentum(&motion).map(Condition::Zero));
    let (dw, reaction) = form.prescribed(s.w, s.nu, s.dphi);
    let motion = systems::gyrostat::MotionInstant {
        angular_acceleration: dw,
        rotor_acceleration: Sym::int(0),
        torque: reaction,
        ..s.motion()
    };
    page.claim("eq4.3", "runs-prescribed", "In the first form with prescribed rotor speed, the accelerations and the reaction that the program integrates satisfy the angular momentum equations of the mass points")
        .under(&s.unit_axis)
        .follows(g.by_momentum(&motion).map(Condition::Zero));
}
