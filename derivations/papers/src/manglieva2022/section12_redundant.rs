//! Section 1.2, end: redundant coordinates after Shulgin, Appell's equations, (1.58)-(1.65).

use super::alphabet::{indexed, letter};
use super::general::{Mixed, Surface, dot, first_kind, friction, mixed, with_friction};
use super::work::nowhere_zero;
use claims::{Condition, Line, Page};
use mechanics::constrained::appell;
use mechanics::constrained::motion::Motion;
use mechanics::constrained::quasi::operator;
use mechanics::constrained::rates::jacobian;
use mechanics::constrained::redundant::{Redundant, Split};
use symbolic::Sym;

use Condition::{Equal, Zero};

pub fn claims(page: &mut Page) {
    page.section("1.2. Redundant coordinates");
    let Some(split) = Split::<3, 1, 2>::new([0]) else { return };
    let Ok(chart) = Redundant::about(&Surface, split, Sym::ZERO, [Sym::ZERO; 3]) else { return };
    let [_, v2, v3] = indexed("ẋ#");
    let motion = Motion::at(&chart, Sym::ZERO, [Sym::ZERO; 3], [v2, v3]);
    velocities(page, &motion);

    let (masses, given): ([Sym; 3], [Sym; 3]) = (indexed("m#"), indexed("X#"));
    let force = with_friction(motion.fields);
    let first = first_kind(&Surface, &motion.state, force);
    let left = std::array::from_fn(|i| masses[i] * first.acceleration[i] - force[i]);
    page.claim(
        "eq1.62",
        "general-equation",r"$\sum(m_k\vec w_k-\vec F_k-\vec R_k^\tau)\delta\vec r_k=0$ along the motion, for all displacements (1.61) (one constraint on three coordinates, arbitrary to the second order)",
    )
    .follows(motion.fields.map(|field| Zero(dot(left, field))));
    let [_, a2, a3] = first.acceleration;
    let shulgin = operator(&chart, (Sym::ZERO, [Sym::ZERO; 3], [v2, v3]), [a2, a3]);
    page.claim("eq1.63", "operator",r"$\frac{d}{dt}\frac{\partial T^*}{\partial\dot x_j}-E_j(T^*)=\sum m_k\vec w_k\cdot\partial\vec v_k/\partial\dot x_j$, $E_j=\frac{\partial}{\partial x_j}+\sum A_{\alpha j}\frac{\partial}{\partial x_\alpha}$, also where the constraint moves (one constraint on three coordinates, arbitrary to the second order)").note(r"For constraints that are not integrable the operator loses a term; the text has geometric ones.")
        .follows((0..2).map(|j| {
            let inertia = std::array::from_fn(|i| masses[i] * first.acceleration[i]);
            Equal(shulgin.energy[j], dot(inertia, motion.fields[j]))
        }));
    let found = friction(motion.fields);
    let [f1, f2, f3] = indexed("f#");
    page.claim("eq1.64", "motion",r"$\frac{d}{dt}\frac{\partial T^*}{\partial\dot x_j}-E_j(T^*)=X_j+A_{1j}X_1+R_j^\tau+A_{1j}R_1^\tau$, $A_{1j}=-f_{,j}/f_{,1}$, along the motion of Lagrange's equations of the first kind (one constraint on three coordinates, arbitrary to the second order)").in_words()
        .follows([(0, 1, f2), (1, 2, f3)].map(|(j, i, slope)| {
            let dependent = -(slope / f1);
            Equal(shulgin.energy[j], given[i] + dependent * given[0] + found[i] + dependent * found[0])
        }));
    page.claim(
        "eq1.65",
        "appell",r"Appell's equations $\partial S'/\partial\dot p_j=Q_j'+(R_j^\tau)'$, $p_j=\dot x_j$, hold along the motion of Lagrange's equations of the first kind (one constraint on three coordinates, arbitrary to the second order)",
    )
    .follows(appell::residual(&chart, &motion, force, [a2, a3]).map(Zero));
    let kinematic = mixed();
    let force = with_friction(kinematic.fields);
    let [_, _, a3, a4] = first_kind(&Mixed, &kinematic.state, force).acceleration;
    page.claim(
        "eq1.65",
        "nonholonomic",r"Appell's equations hold along the motion of Lagrange's equations of the first kind also with a kinematic constraint nonlinear in the velocities (four coordinates, one geometric and one kinematic constraint)",
    )
    .follows(appell::residual(&Mixed, &kinematic, force, [a3, a4]).map(Zero));
}

/// Claims on (1.58)-(1.61).
fn velocities(page: &mut Page, motion: &Motion<Sym, 3, 2>) {
    page.claim(
        "eq1.58",
        "constraints",
        "(1.58) are geometric constraints $f(x,t)=0$. The claims below have one in three coordinates, arbitrary to the second order",
    )
    .defines([]);
    nowhere_zero(page, "eq1.59", r"$\sum\vec R_k\delta\vec r_k\ne0$");
    let [row] = jacobian(&Surface, &motion.state);
    let masses: [Sym; 3] = indexed("m#");
    let found = friction(motion.fields);
    let displaced = std::array::from_fn(|i| found[i] / masses[i]);
    page.claim("eq1.60", "virtual",r"$R^\tau_\gamma=\sum\mu_m\frac{\partial(m_\gamma\dot x_\gamma)}{\partial p_m}$ divided by the masses is a virtual displacement (one constraint on three coordinates, arbitrary to the second order)").reading(r"The source prints the index of $x$ as $\gamma_i$; $x_\gamma$ is read.").in_words()
        .follows([Zero(dot(row, displaced))]);
    let force = with_friction(motion.fields);
    let [multiplier] = first_kind(&Surface, &motion.state, force).multipliers;
    page.claim("eq1.60", "independent",r"The force of constraint does not depend on friction: $\partial\lambda/\partial\mu_j=0$ (one constraint on three coordinates, arbitrary to the second order)")
        .in_words()
        .follows(indexed::<2>("μ#").map(|mu| Zero(multiplier.diff(mu))));
    let [_, v2, v3] = indexed("ẋ#");
    let [f1, f2, f3] = indexed("f#");
    let linear = -(f2 / f1) * v2 - f3 / f1 * v3;
    let name = letter("ẋ1");
    page.claim("eq1.61", "velocities",r"The dependent velocity is $\dot x_1=A_{12}\dot x_2+A_{13}\dot x_3$, $A_{1j}=-f_{,j}/f_{,1}$, as printed, without a free term for $f(x,t)=0$").why(r"The constraint contains the time: its rate has the term $f_{,t}$, which is missing.")
        .fails([Line::formula(motion.state.velocity[0], name, linear)]);
    page.claim("eq1.61", "velocities-corrected", r"The dependent velocity has the term $-f_{,t}/f_{,1}$")
        .holds([Line::formula(motion.state.velocity[0], name, linear - letter("ft") / f1)]);
    page.correct();
    let [d2, d3] = [letter("δx2"), letter("δx3")];
    let [first, second] = motion.fields.map(|field| field[0]);
    page.claim("eq1.61", "variations",r"Virtual displacements are $\delta x_1=A_{12}\delta x_2+A_{13}\delta x_3$, without a term in $f_{,t}$, since time is not varied")
        .holds([Line::formula(first * d2 + second * d3, letter("δx1"), -(f2 / f1) * d2 - f3 / f1 * d3)]);
}
