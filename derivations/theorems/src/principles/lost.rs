//! Substitution of a constraint into an energy: the condition under which it is valid, and the term that is missing
//! otherwise.

use super::alphabet::{letter, letters};
use super::cases;
use super::equal::Case;
use claims::{Condition, Line, Page};
use field::{Analytic, Tangent};
use mechanics::constrained::appell;
use mechanics::constrained::newton::Reactions;
use mechanics::constrained::quasi::{Operator, operator};
use mechanics::constrained::redundant::{Redundant, Split};
use mechanics::constrained::{Charted, Constrained, PointSystem, motion::Motion};
use mechanics::differentiate::{along, fixed, unit};
use symbolic::Sym;

use Condition::{Equal, Zero};

pub fn claims(page: &mut Page) {
    page.section("Constraints put into the energy: the lost term");
    nothing_lost(page);
    condition(page);
    knife_edge(page);
    disc(page);
    prescribed_speed_point(page);
}

/// The Euler-Lagrange operator in redundant coordinates, and the inertia sum m x'' dx'/dp that it should equal;
/// undefined if the constraints do not determine the dependent coordinates.
fn redundant<Q, const N: usize, const C: usize, const K: usize, const R: usize>(
    case: &Case<Q, N, C, K, R>,
    rates: [Sym; R],
) -> (Operator<Sym, R>, [Sym; R])
where
    Q: Charted<N, K, R, Given = Sym> + Constrained<N, C> + Reactions<N, C>,
{
    let state = case.motion().state;
    let undefined = [Sym::UNDEFINED; R];
    Split::<N, C, R>::new(case.dependent)
        .and_then(|split| Redundant::about(&case.system, split, state.time, state.place).ok())
        .map_or((Operator { energy: undefined, lost: undefined }, undefined), |chart| {
            let (time, x, p) = (state.time, state.place, chart.free(state.velocity));
            (operator(&chart, (time, x, p), rates), inertia(&chart, &Motion::at(&chart, time, x, p), rates))
        })
}

/// The inertia sum m_i x''_i dx'_i/dp_j.
fn inertia<Q: Charted<N, K, R, Given = Sym>, const N: usize, const K: usize, const R: usize>(
    system: &Q,
    motion: &Motion<Sym, N, R>,
    rates: [Sym; R],
) -> [Sym; R] {
    appell::residual(system, motion, [Sym::ZERO; N], rates)
}

/// The missing term of a chart whose velocities are linear in p: the sum over k of p_k times the momentum along the
/// bracket [X_k, X_j].
fn by_brackets<Q: Charted<N, K, R, Given = Sym>, const N: usize, const K: usize, const R: usize>(
    system: &Q,
    (time, q, p): (Sym, [Sym; K], [Sym; R]),
) -> [Sym; R] {
    let masses: [Sym; N] = system.masses();
    let velocity = Motion::at(system, time, q, p).state.velocity;
    // X_k(dx'_i/dp_j)
    let slopes: [[[Sym; N]; R]; R] = std::array::from_fn(|k| {
        let field = system.rates(Tangent::fixed(time), fixed(q), along(p, unit(k))).map(|speed| speed.slope);
        let moved = Motion::at(system, Tangent::fixed(time), along(q, field), fixed(p));
        moved.fields.map(|field| field.map(|component| component.slope))
    });
    std::array::from_fn(|j| {
        let terms = (0..R).flat_map(|k| (0..N).map(move |i| (k, i)));
        terms.fold(Sym::ZERO, |sum, (k, i)| sum + p[k] * masses[i] * velocity[i] * (slopes[k][j][i] - slopes[j][k][i]))
    })
}

fn nothing_lost(page: &mut Page) {
    let (rod, steered, ladder, swing) = (cases::rod(), cases::steered_rod(), cases::ladder(), cases::swing());
    let lost = [
        redundant(&rod, letters(["ẍ", "v̇"])).0.lost.to_vec(),
        redundant(&steered, letters(["ẍ"])).0.lost.to_vec(),
        redundant(&ladder, letters(["θ̈"])).0.lost.to_vec(),
        redundant(&swing, letters(["ẍ"])).0.lost.to_vec(),
    ];
    page.claim("shulgin", "integrable", r"Shulgin's equations $\frac{d}{dt}\frac{\partial T^*}{\partial\dot x_j} - E_j(T^*) = X_j + \sum A_{\alpha j}X_\alpha$ lose nothing on the rod, the steered rod on its guide, the ladder and the pendulum with a moving pivot: their constraints are geometric, or integrable")
        .follows(lost.concat().into_iter().map(Zero));
}

fn knife_edge(page: &mut Page) {
    let case = cases::knife_edge();
    let [m, j, d, g, v, dtheta, ddx] = letters(["m", "J", "d", "g", "v", "θ̇", "ẍ"]);
    let point = letter("θ").circle();
    let (in_all, is) = redundant(&case, [ddx, letter("κ1")]);
    page.claim("shulgin", "identity", r"On the knife edge $\frac{d}{dt}\frac{\partial T^*}{\partial\dot x_j} - E_j(T^*) - \sum m\ddot x\frac{\partial\dot x}{\partial\dot x_j} = \sum_\alpha m_\alpha\dot x_\alpha\bigl(\frac{dA_{\alpha j}}{dt} - E_j(\dot x_\alpha)\bigr)$, the lost term, at all accelerations")
        .in_words()
        .follows((0..2).map(|j| Equal(in_all.energy[j] - is[j], in_all.lost[j])));
    page.claim(
        "shulgin",
        "knife-edge",
        "Shulgin's equations hold for nonholonomic systems too, so that the first of them loses nothing on the knife edge",
    )
    .why("The constraint is not integrable: the fields of the virtual displacements do not commute.")
    .fails([Line::formula(in_all.lost[0], letter("lost1"), Sym::ZERO)]);
    page.claim(
        "shulgin",
        "knife-edge-lost",
        r"The first of Shulgin's equations loses a term of the inertia of the knife edge",
    )
    .holds([Line::formula(
        in_all.lost[0],
        letter("lost1"),
        m * dtheta * (d * dtheta * point.cos + v * point.sin) / point.cos.powi(2),
    )]);
    page.correct();
    let (in_blade, on_way) = (operator(&case.system, case.at, letters(["v̇", "θ̈"])), case.motion());
    let is = inertia(&case.system, &on_way, letters(["v̇", "θ̈"]));
    let weight = on_way.generalised(case.system.force(&on_way.state));
    let (dv, ddtheta) = (letter("v̇"), letter("θ̈"));
    page.claim("shulgin", "sleigh", r"Lagrange's equations with the constraint put into the energy, $T^*=\frac12m(v^2+d^2\dot\theta^2)+\frac12J\dot\theta^2$, are the equations of motion of the knife edge in the blade's speed $v$ and $\dot\theta$")
        .why("The constraint is not integrable, and the momentum along the bracket of its fields is missing from the energy.")
        .fails([
            Line::equation(is[0] - weight[0], m * dv, m * g * point.cos),
            Line::equation(is[1] - weight[1], (j + m * d * d) * ddtheta, -(m * g * d * point.sin)),
        ]);
    page.claim(
        "shulgin",
        "sleigh-right",
        r"Chaplygin's equations of the knife edge in $v$ and $\dot\theta$ contain the missing terms, which are $m d\dot\theta^2$ and $-m d v\dot\theta$",
    )
    .holds([
        Line::equation(is[0] - weight[0], m * dv, m * g * point.cos + m * d * dtheta * dtheta),
        Line::equation(is[1] - weight[1], (j + m * d * d) * ddtheta, -(m * g * d * point.sin) - m * d * v * dtheta),
    ]);
    page.correct();
    page.claim("shulgin", "momentum", r"On the knife edge with its centre on the blade, $d=0$, nothing is lost in $v$, $\dot\theta$, although its constraint is not integrable: integrability is enough, not necessary")
        .in_words()
        .follows(in_blade.lost.map(|term| Zero(term.substitute(&[(d, Sym::ZERO)]))));
    page.claim("shulgin", "coordinates", r"The lost term depends on the velocities chosen. In $\dot x$ of the redundant coordinates the knife edge loses a term with $d=0$ too")
        .holds([Line::formula(
            in_all.lost[0].substitute(&[(d, Sym::ZERO)]),
            letter("lost1"),
            m * v * dtheta * point.sin / point.cos.powi(2),
        )]);
}

/// The condition under which the missing term is zero.
fn condition(page: &mut Page) {
    let (sleigh, disc) = (cases::knife_edge(), cases::disc());
    let (of_sleigh, of_disc) = (
        operator(&sleigh.system, sleigh.at, letters(["v̇", "θ̈"])).lost,
        operator(&disc.system, disc.at, letters(["ψ̈", "θ̈", "φ̈"])).lost,
    );
    let pairs = of_sleigh.into_iter().zip(by_brackets(&sleigh.system, sleigh.at));
    let all = pairs.chain(of_disc.into_iter().zip(by_brackets(&disc.system, disc.at)));
    page.claim("shulgin", "brackets", r"The lost term on the knife edge and on the disc is $\sum_k p_k\sum_i m_i\dot x_i\,(X_kX_j-X_jX_k)x_i$, the momentum along the brackets of the fields. It vanishes where these do, which is Frobenius' condition, or where the momentum along them does")
        .in_words()
        .follows(all.map(|(lost, brackets)| Equal(lost, brackets)));
}

/// A common error: the condition of rolling is substituted into T, and Lagrange's equations are written for Euler's
/// angles only.
fn disc(page: &mut Page) {
    let case = cases::disc();
    let rates = letters(["ψ̈", "θ̈", "φ̈"]);
    let motion = case.motion();
    let weight = motion.generalised(case.system.force(&motion.state));
    let is = inertia(&case.system, &motion, rates);
    let found = operator(&case.system, case.at, rates);
    let [m, p, a, g, dpsi, dtheta, dphi] = letters(["m", "P", "a", "g", "ψ̇", "θ̇", "φ̇"]);
    let [ddpsi, ddtheta, ddphi] = rates;
    let (cos, sin) = (letter("θ").circle().cos, letter("θ").circle().sin);
    let (axial, rolling) = (p + p, (p + p) + m * a * a);
    // the angular velocity about the axis, and its rate
    let spin = dphi + dpsi * cos;
    let dspin = ddphi + ddpsi * cos - dpsi * dtheta * sin;
    let wrong = [
        (
            rolling * dspin * cos + p * sin * (ddpsi * sin + (dpsi * dtheta * cos) + (dpsi * dtheta * cos)),
            rolling * spin * dtheta * sin,
        ),
        ((p + m * a * a) * ddtheta, p * dpsi * dpsi * sin * cos - rolling * spin * dpsi * sin - m * g * a * cos),
        (rolling * dspin, Sym::ZERO),
    ];
    let right = [
        (wrong[0].0, axial * spin * dtheta * sin + m * a * a * dpsi * dtheta * sin * cos),
        wrong[1],
        (wrong[2].0, m * a * a * dpsi * dtheta * sin),
    ];
    let lines = |sides: [(Sym, Sym); 3]| -> Vec<Line> {
        sides.into_iter().enumerate().map(|(i, (left, r))| Line::equation(is[i] - weight[i], left, r)).collect()
    };
    page.claim("museum", "disc-wrong", r"If the velocity of the rolling disc's centre is put into $T$, which is a fault, Lagrange's equations for $\psi$, $\theta$, $\varphi$ are those of principles/museum/disc")
        .in_words()
        .follows((0..3).map(|i| Equal(found.energy[i] - weight[i], wrong[i].0 - wrong[i].1)));
    page.claim("museum", "disc", r"Lagrange's equations for $\psi$, $\theta$, $\varphi$, with the rolling put into $T$, are the equations of motion of the rolling disc")
        .why("Rolling is not integrable, and the momentum along the brackets of its fields is missing from the energy.")
        .fails(lines(wrong));
    page.claim("museum", "disc-right", r"The equations of motion of the rolling disc have $-m a^2\sin\theta\,\dot\theta\dot\varphi$ in the first and $m a^2\sin\theta\,\dot\theta\dot\psi$ in the third in addition to those of Lagrange with the rolling put into $T$")
        .holds(lines(right));
    page.correct();
    page.claim("museum", "disc-lost", r"The terms that Lagrange's equations of the rolling disc lose with the rolling put into $T$ are $\sum m\dot x\bigl(\frac{d}{dt}\frac{\partial\dot x}{\partial p_j} - X_j(\dot x)\bigr)$")
        .in_words()
        .follows([
            Equal(found.lost[0], -(m * a * a * sin * dtheta * dphi)),
            Zero(found.lost[1]),
            Equal(found.lost[2], m * a * a * sin * dtheta * dpsi),
        ]);
}

/// If a nonlinear kinematic constraint is substituted into the energy, the whole inertia term is lost.
fn prescribed_speed_point(page: &mut Page) {
    let case = cases::prescribed_speed_point();
    let rates = [letter("χ̇")];
    let found = operator(&case.system, case.at, rates);
    let [m, u, b, t] = letters(["m", "u", "b", "t"]);
    let is = inertia(&case.system, &case.motion(), rates);
    page.claim(
        "shulgin",
        "nonlinear",
        r"With a prescribed speed $v=u+bt$, $T^*=\frac12mv^2$ contains no $\chi$, so that the whole term $m v^2\dot\chi$ is missing",
    )
    .follows([
        Zero(found.energy[0]),
        Equal(is[0], m * (u + b * t).powi(2) * rates[0]),
        Equal(is[0], -found.lost[0]),
    ]);
}
