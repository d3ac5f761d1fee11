//! Section 2.1: nonholonomic systems with friction, (2.1)-(2.9).
//!
//! Four coordinates with one geometric and one nonlinear kinematic constraint: r = 2 free velocities.

use super::alphabet::{indexed, int, letter, letters};
use super::general::{Mixed, dot, first_kind, friction, mixed, with_friction};
use super::work::nowhere_zero;
use claims::{Condition, Line, Page};
use field::Tangent;
use mechanics::constrained::motion::{self, Motion};
use mechanics::constrained::rates::jacobian;
use mechanics::constrained::{Charted, Constrained, Constraint, State};
use mechanics::differentiate::{along, fixed, unit};
use symbolic::Sym;

use Condition::{Equal, Zero};

pub fn claims(page: &mut Page) {
    page.section("2.1. Nonholonomic constraints with friction");
    displacements(page);
    forces(page);
    identities(page);
    dynamics(page);
}

/// Claims on (2.1)-(2.5).
fn displacements(page: &mut Page) {
    page.claim(
        "eq2.1",
        "geometric",
        "(2.1) are geometric constraints. The claims below have one, $x_1=F(x_2,x_3,x_4,t)$, arbitrary to the second order",
    )
    .defines([]);
    page.claim("eq2.2", "kinematic", r"(2.2) are nonlinear kinematic constraints. The claims below have one, $\dot x_2=\Phi(x,\dot x_3,\dot x_4,t)$, arbitrary to the second order in the velocities")
        .defines([]);
    let displacement: [Sym; 4] = indexed("δx#");
    page.claim("eq2.3", "displacements", r"(2.3) defines virtual displacements after Chetaev, where $f_{,\gamma}$ and $\varphi_{,\dot\gamma}$ stand for $\frac{\partial f}{\partial x_\gamma}$ and $\frac{\partial\varphi}{\partial\dot x_\gamma}$").reading(r"The source prints the second condition with $\delta\dot x_\gamma$, which cannot serve (2.5); $\delta x_\gamma$ is read, as (2.5) and (2.14) use it.")
        .defines([
            Line::equation(Sym::ZERO, dot(indexed("f#"), displacement), Sym::ZERO),
            Line::equation(Sym::ZERO, dot(indexed("φ#"), displacement), Sym::ZERO),
        ]);
    let (time, q) = (letter("t"), letters(["x2", "x3", "x4"]));
    let [_, _, v3, v4] = indexed("ẋ#");
    let at = State { time, place: Mixed.place(time, q), velocity: motion::velocity(&Mixed, time, q, [v3, v4]) };
    let closed: [Constraint<Sym>; 2] = Mixed.constraints(&at);
    let rows = {
        let moving = along(q, Mixed.rates(time, q, [v3, v4]));
        let places = Mixed.place(Tangent::variable(time), moving);
        // the first derivative of the geometric constraint along the chart
        let velocity = [fixed([Sym::ZERO])[0]; 4];
        let moved: [Constraint<Tangent<Sym>>; 2] =
            Mixed.constraints(&State { time: Tangent::variable(time), place: places, velocity });
        moved[0].value().slope
    };
    page.claim("eq2.4", "chart", r"The places $x_\gamma=a_\gamma(q,t)$ and velocities $\dot x_\gamma=b_\gamma(q,p,t)$ satisfy (2.1) and (2.2) identically, here with $q=(x_2,x_3,x_4)$, $p=(\dot x_3,\dot x_4)$")
        .follows(closed.map(|constraint| Zero(constraint.value())).into_iter().chain([Zero(rows)]));
    let motion = Motion::at(&Mixed, time, q, [v3, v4]);
    let rows = jacobian(&Mixed, &motion.state);
    page.claim("eq2.5", "along-the-chart",r"$\delta x_\gamma=\sum\frac{\partial b_\gamma}{\partial p_j}\delta\pi_j$ satisfies (2.3) for every $\delta\pi$ (four coordinates, one geometric and one nonlinear kinematic constraint)").in_words()
        .follows(rows.into_iter().flat_map(|row| motion.fields.map(|field| Zero(dot(row, field)))));
    let combined = |i: usize| motion.fields[0][i] * displacement[2] + motion.fields[1][i] * displacement[3];
    page.claim("eq2.5", "all",r"Every virtual displacement has the form $\delta x_\gamma=\sum\frac{\partial b_\gamma}{\partial p_j}\delta\pi_j$ (four coordinates, one geometric and one nonlinear kinematic constraint)")
        .in_words()
        .given(rows.map(|row| Zero(dot(row, displacement))))
        .by_combination([
            (Equal(displacement[0], combined(0)), vec![], vec![(0, int(1)), (1, -rows[0][1])]),
            (Equal(displacement[1], combined(1)), vec![], vec![(1, int(1))]),
        ]);
}

/// Claims on (2.6)-(2.7) and the forms of both parts.
fn forces(page: &mut Page) {
    nowhere_zero(page, "eq2.6", r"$\sum\vec R_k\delta\vec r_k\ne0$");
    let (gradient, steered, displacement): ([Sym; 4], [Sym; 4], [Sym; 4]) =
        (indexed("f#"), indexed("φ#"), indexed("δx#"));
    let [lambda, u] = letters(["λ", "u"]);
    let normal = std::array::from_fn(|i| lambda * gradient[i] + u * steered[i]);
    page.claim(
        "eq2.7",
        "no-work",
        r"$R^n_\gamma=\lambda f_{,\gamma}+u\varphi_{,\dot\gamma}$ does no work on virtual displacements",
    )
    .given([Zero(dot(gradient, displacement)), Zero(dot(steered, displacement))])
    .by_combination([(Zero(dot(normal, displacement)), vec![], vec![(0, lambda), (1, u)])]);
    nowhere_zero(page, "eq2.7", r"$\sum\vec R_k^\tau\delta\vec r_k\ne0$");
    let motion = mixed();
    let masses: [Sym; 4] = indexed("m#");
    let found = friction(motion.fields);
    let displaced = std::array::from_fn(|i| found[i] / masses[i]);
    page.claim("eq2.7", "friction",r"$R^\tau_\gamma=\sum\mu_j\frac{\partial(m_\gamma\dot x_\gamma)}{\partial p_j}$ divided by the masses is a virtual displacement (four coordinates, one geometric and one nonlinear kinematic constraint)").in_words()
        .follows(jacobian(&Mixed, &motion.state).map(|row| Zero(dot(row, displaced))));
}

/// Claims on the two lines after (2.8).
fn identities(page: &mut Page) {
    let motion = mixed();
    let [geometric, steered] = jacobian(&Mixed, &motion.state);
    let [mu1, mu2] = indexed("μ#");
    let pushed: [Sym; 4] = std::array::from_fn(|i| mu1 * motion.fields[0][i] + mu2 * motion.fields[1][i]);
    page.claim(
        "eq2.8",
        "identity-geometric",r"$\sum_\gamma\frac{\partial f}{\partial x_\gamma}\sum_j\mu_j\frac{\partial\dot x_\gamma}{\partial p_j}=0$ holds identically (four coordinates, one geometric and one nonlinear kinematic constraint)",
    )
    .in_words()
    .follows([Zero(dot(geometric, pushed))]);
    let by_place: [Sym; 4] = std::array::from_fn(|i| {
        let at = State {
            time: Tangent::fixed(Sym::ZERO),
            place: along(motion.state.place, unit(i)),
            velocity: fixed(motion.state.velocity),
        };
        let [_, kinematic]: [Constraint<Tangent<Sym>>; 2] = Mixed.constraints(&at);
        kinematic.value().slope
    });
    page.claim("eq2.8", "identity-kinematic",r"$\sum_\gamma\frac{\partial\varphi}{\partial x_\gamma}\sum_j\mu_j\frac{\partial\dot x_\gamma}{\partial p_j}=0$ holds as printed, with $\partial\varphi/\partial x_\gamma$").why(r"A dot is missing: virtual displacements of a kinematic constraint are orthogonal to $\partial\varphi/\partial\dot x_\gamma$.")
        .fails([Line::formula(dot(by_place, pushed), letter("Σ ∂φ/∂x μ ∂ẋ/∂p"), Sym::ZERO)]);
    page.claim("eq2.8", "identity-kinematic-corrected",r"$\sum_\gamma\frac{\partial\varphi}{\partial\dot x_\gamma}\sum_j\mu_j\frac{\partial\dot x_\gamma}{\partial p_j}=0$ holds identically (four coordinates, one geometric and one nonlinear kinematic constraint)")
        .in_words()
        .follows([Zero(dot(steered, pushed))]);
    page.correct();
}

/// Claims on (2.8)-(2.9).
fn dynamics(page: &mut Page) {
    let motion = mixed();
    let masses: [Sym; 4] = indexed("m#");
    let force = with_friction(motion.fields);
    let first = first_kind(&Mixed, &motion.state, force);
    let rows = jacobian(&Mixed, &motion.state);
    page.claim("eq2.8", "motion", "(2.8) are the equations of motion with multipliers. Two linear equations determine these: (2.1) differentiated twice and (2.2) once")
        .reading(r"After (2.8) the source calls the multipliers $u_\beta$ once $\mu_\beta$; $u_\beta$ is read.")
        .defines((0..4).map(|i| {
            let [lambda, u] = letters(["λ", "u"]);
            let ([f, phi], [x, pushed]): ([Sym; 2], [Sym; 2]) = (
                [indexed::<4>("f#")[i], indexed::<4>("φ#")[i]],
                [indexed::<4>("X#")[i], indexed::<4>("R#")[i]],
            );
            let left = masses[i] * indexed::<4>("ẍ#")[i];
            Line::equation(Sym::ZERO, left, x + lambda * f + u * phi + pushed)
        }));
    let mu = indexed::<2>("μ#");
    page.claim(
        "section2.1-independence",
        "multipliers",r"$\lambda$ and $u$ do not depend on friction, for any masses (four coordinates, one geometric and one nonlinear kinematic constraint)",
    )
    .follows(mu.into_iter().flat_map(|mu| first.multipliers.map(|multiplier| Zero(multiplier.diff(mu)))));
    let smooth = first_kind(&Mixed, &motion.state, indexed("X#"));
    page.claim(
        "section2.1-independence",
        "same",r"The forces of constraint with friction are those of the system without friction (four coordinates, one geometric and one nonlinear kinematic constraint)",
    )
    .follows((0..4).map(|i| {
        let of = |[lambda, u]: [Sym; 2]| lambda * rows[0][i] + u * rows[1][i];
        Equal(of(first.multipliers), of(smooth.multipliers))
    }));

    let left: [Sym; 4] = std::array::from_fn(|i| force[i] - masses[i] * first.acceleration[i]);
    page.claim("eq2.9", "necessary",r"$\sum(\vec F_k+\vec R_k^\tau-m_k\vec w_k)\delta\vec r_k=0$ along the motion (2.8), for all virtual displacements (four coordinates, one geometric and one nonlinear kinematic constraint)")
        .follows(motion.fields.map(|field| Zero(dot(left, field))));
    let missing: [Sym; 4] = indexed("R#");
    let of_lambda = missing[0];
    let of_u = missing[1] - of_lambda * rows[0][1];
    page.claim("eq2.9", "sufficient",r"Forces $R$ that do no work on virtual displacements are $\lambda f_{,\gamma}+u\varphi_{,\dot\gamma}$, so that (2.9) gives (2.8) (four coordinates, one geometric and one nonlinear kinematic constraint)").in_words()
        .given(motion.fields.map(|field| Zero(dot(missing, field))))
        .by_combination([(2, 0), (3, 1)].map(|(i, k)| {
            (Equal(missing[i], of_lambda * rows[0][i] + of_u * rows[1][i]), vec![], vec![(k, int(1))])
        }));
}
