//! Section 1.2: systems with geometric constraints and friction, (1.43)-(1.57).

use super::alphabet::{indexed, int, letter, letters};
use super::general::{Resolved, dot, first_kind, friction, on_surface, or_undefined, with_friction};
use super::work::{nowhere_zero, own_displacement};
use claims::{Condition, Line, Page};
use mechanics::constrained::combining::extended;
use mechanics::constrained::motion::Motion;
use mechanics::constrained::rates::jacobian;
use mechanics::constrained::second_kind;
use symbolic::Sym;

use Condition::{Equal, NonZero, Zero};

pub fn claims(page: &mut Page) {
    page.section("1.2. Geometric constraints with friction");
    displacements(page);
    reactions(page);
    friction_and_multipliers(page);
    second_kind_equations(page);
}

/// Claims on (1.43)-(1.46).
fn displacements(page: &mut Page) {
    let (gradient, displacement): ([Sym; 3], [Sym; 3]) = (indexed("f#"), indexed("δx#"));
    page.claim("eq1.43", "constraint", r"(1.43) are geometric constraints. The claims below have one in three coordinates, arbitrary to the second order. Its derivatives are $f_{,\gamma}$, $f_{,\gamma\delta}$, or $F_{,\gamma}$ where it is solved for $x_1=F(x_2,x_3,t)$")
        .defines([]);
    page.claim("eq1.44", "displacement", r"Virtual displacements satisfy the linear condition")
        .defines([Line::equation(Sym::ZERO, dot(gradient, displacement), Sym::ZERO)]);
    page.claim(
        "eq1.45",
        "chart",
        r"(1.45) gives the configurations by generalised coordinates, $x_\gamma=a_\gamma(q_i,t)$",
    )
    .defines([]);
    let [_, q2, q3] = indexed("x#");
    let [_, v2, v3] = indexed("ẋ#");
    let motion = Motion::at(&Resolved, letter("t"), [q2, q3], [v2, v3]);
    let [row] = jacobian(&Resolved, &motion.state);
    page.claim(
        "eq1.46",
        "along-the-chart",r"$\delta x_\gamma=\sum\frac{\partial x_\gamma}{\partial q_i}\delta q_i$ satisfies (1.44) for every $\delta q$ (one constraint on three coordinates, arbitrary to the second order)",
    )
    .in_words()
    .follows(motion.fields.map(|field| Zero(dot(row, field))));
    let [_, d2, d3] = displacement;
    page.claim("eq1.46", "all",r"Every virtual displacement has the form $\delta x_\gamma=\sum\frac{\partial x_\gamma}{\partial q_i}\delta q_i$ (one constraint on three coordinates, arbitrary to the second order)")
        .in_words()
        .given([Zero(dot(row, displacement))])
        .by_combination([(
            Equal(displacement[0], motion.fields[0][0] * d2 + motion.fields[1][0] * d3),
            vec![],
            vec![(0, int(1))],
        )]);
}

/// Claims on (1.47)-(1.51).
fn reactions(page: &mut Page) {
    let (gradient, displacement, reaction): ([Sym; 3], [Sym; 3], [Sym; 3]) =
        (indexed("f#"), indexed("δx#"), indexed("R#"));
    let lambda = letter("λ");
    page.claim("eq1.47", "ideal", "(1.47) defines ideal constraints").defines([Line::equation(
        Sym::ZERO,
        dot(reaction, displacement),
        Sym::ZERO,
    )]);
    page.claim("eq1.48", "sufficient", r"$R_\gamma=\lambda f_{,\gamma}$ does no work on virtual displacements")
        .given([Zero(dot(gradient, displacement))])
        .by_combination([(Zero(dot(gradient.map(|f| lambda * f), displacement)), vec![], vec![(0, lambda)])]);
    let [f1, f2, f3] = gradient;
    let (second, third) = ([-f2, f1, Sym::ZERO], [-f3, Sym::ZERO, f1]);
    page.claim("eq1.48", "necessary", r"A reaction that does no work on two independent virtual displacements is $\lambda f_{,\gamma}$, $\lambda=R_1/f_{,1}$")
        .given([Zero(dot(reaction, second)), Zero(dot(reaction, third)), NonZero(f1)])
        .by_combination([1, 2].map(|i| (Equal(reaction[i], reaction[0] / f1 * gradient[i]), vec![2], vec![(i - 1, int(1))])));
    nowhere_zero(page, "eq1.49", r"with friction $\sum R_\gamma\delta x_\gamma\ne0$");

    let masses: [Sym; 3] = indexed("m#");
    let weighted = |a: [Sym; 3], b: [Sym; 3]| dot(a, std::array::from_fn(|i| b[i] / masses[i]));
    let rest: [Sym; 3] = std::array::from_fn(|i| reaction[i] - lambda * gradient[i]);
    let parts = or_undefined(extended(masses, [gradient], reaction));
    page.claim("eq1.50", "exists",r"Every reaction is a force of constraint $\lambda f_{,\gamma}$ and a friction with $R^\tau_\gamma/m_\gamma$ a virtual displacement (one constraint on three coordinates, arbitrary to the second order)").in_words()
        .follows([Zero(weighted(gradient, parts.of_friction))]);
    page.claim(
        "eq1.50",
        "unique",
        r"The splitting of a reaction into a force of constraint and friction is unique: $\lambda$ is determined",
    )
    .given([Zero(weighted(gradient, rest)), NonZero(weighted(gradient, gradient))])
    .by_combination([(Equal(lambda, parts.multipliers[0]), vec![1], vec![(0, int(-1))])]);
    page.claim("eq1.50", "no-work", r"The force of constraint does no work on virtual displacements")
        .in_words()
        .given([Zero(dot(gradient, displacement))])
        .by_combination([(Zero(dot(parts.of_constraints, displacement)), vec![], vec![(0, parts.multipliers[0])])]);
    own_displacement(page, "eq1.51", r"$\sum R^\tau_\gamma\delta x_\gamma\ne0$ holds");
}

/// Claims on (1.52)-(1.54).
fn friction_and_multipliers(page: &mut Page) {
    let motion = on_surface();
    let [row] = jacobian(&Resolved, &motion.state);
    let masses: [Sym; 3] = indexed("m#");
    let found = friction(motion.fields);
    let displaced = std::array::from_fn(|i| found[i] / masses[i]);
    page.claim("eq1.52", "virtual",r"$R^\tau_\gamma=\sum\mu_i\frac{\partial(m_\gamma x_\gamma)}{\partial q_i}$ divided by the masses is a virtual displacement (one constraint on three coordinates, arbitrary to the second order)").in_words()
        .follows([Zero(dot(row, displaced))]);
    let any: [Sym; 3] = indexed("R#");
    let weighted = std::array::from_fn(|i| any[i] / masses[i]);
    let replaced = [(letter("μ1"), any[1] / masses[1]), (letter("μ2"), any[2] / masses[2])];
    page.claim("eq1.52", "all",r"Every friction whose $R^\tau_\gamma/m_\gamma$ is a virtual displacement has the form (1.52) (one constraint on three coordinates, arbitrary to the second order)")
        .given([Zero(dot(row, weighted))])
        .by_combination([(Equal(any[0], found[0].substitute(&replaced)), vec![], vec![(0, masses[0])])]);

    let lagrange = first_kind(&Resolved, &motion.state, with_friction(motion.fields));
    let [_, v2, v3] = indexed("ẋ#");
    let [_, f2, f3] = indexed("F#");
    let [f22, f23, f33, f2t, f3t, ftt] = letters(["F22", "F23", "F33", "F2t", "F3t", "Ftt"]);
    let known =
        f22 * v2.powi(2) + int(2) * f23 * v2 * v3 + f33 * v3.powi(2) + int(2) * f2t * v2 + int(2) * f3t * v3 + ftt;
    let [x1, x2, x3] = indexed("X#");
    let [m1, m2, m3] = masses;
    page.claim("eq1.53", "multipliers", r"The constraint differentiated twice determines $\lambda$ by place, velocities and given forces, and friction drops out (constraint $x_1=F(x_2,x_3,t)$)").reading(r#"The text differentiates (1.43), then multiplies "each of (1.54)" by the displacements; (1.53) is read there."#)
        .holds([Line::formula(
            lagrange.multipliers[0],
            letter("λ"),
            (known - x1 / m1 + f2 * x2 / m2 + f3 * x3 / m3)
                / (int(1) / m1 + f2.powi(2) / m2 + f3.powi(2) / m3),
        )]);
    page.claim("eq1.54", "constraints", "(1.54) repeats the constraints (1.43) in addition to the equations of motion")
        .defines([]);
}

/// Claims on (1.55)-(1.57).
fn second_kind_equations(page: &mut Page) {
    let motion = on_surface();
    let found = friction(motion.fields);
    let force = with_friction(motion.fields);
    let [_, v2, v3] = indexed("ẋ#");
    let [w2, w3] = letters(["q̈2", "q̈3"]);
    let at = (Sym::ZERO, [Sym::ZERO; 2], [v2, v3]);
    let masses: [Sym; 3] = indexed("m#");
    let moved = motion.acceleration([w2, w3]);
    let missing = std::array::from_fn(|i| masses[i] * moved[i] - force[i]);
    let lagrange = second_kind::residual(&Resolved, at, force, [w2, w3]);
    page.claim("eq1.55", "principle",r"$\sum(m_\gamma\ddot x_\gamma-X_\gamma-R^\tau_\gamma)\delta x_\gamma=\sum[\frac{d}{dt}\frac{\partial T}{\partial\dot q_i}-\frac{\partial T}{\partial q_i}-Q_i-Q_i^\tau]\delta q_i$ for each $\delta q_i$ (one constraint on three coordinates, arbitrary to the second order)").in_words()
        .follows((0..2).map(|i| Equal(dot(missing, motion.fields[i]), lagrange[i])));
    let [mu1, mu2] = indexed("μ#");
    let names = letters(["Q1", "Q2"]);
    page.claim("eq1.55", "friction",r"As printed, the generalised forces of friction are $Q_i^\tau=\sum_\gamma\mu_i\frac{\partial x_\gamma}{\partial q_i}$").why(r"The friction (1.52) is not put in, and the masses and the second factor $\frac{\partial x_\gamma}{\partial q_j}$ are missing.")
        .fails((0..2).map(|i| {
            let printed = (0..3).fold(Sym::ZERO, |sum, k| sum + [mu1, mu2][i] * motion.fields[i][k]);
            Line::formula(dot(found, motion.fields[i]), names[i], printed)
        }));
    page.claim("eq1.55", "friction-corrected",r"$Q_i^\tau=\sum_\gamma R^\tau_\gamma\frac{\partial x_\gamma}{\partial q_i}=\sum_j\mu_j\sum_\gamma m_\gamma\frac{\partial x_\gamma}{\partial q_i}\frac{\partial x_\gamma}{\partial q_j}$, for $q=(x_2,x_3)$")
        .holds({
            let [_, f2, f3] = indexed("F#");
            let [m1, m2, m3] = masses;
            [
                Line::formula(
                    dot(found, motion.fields[0]),
                    names[0],
                    mu1 * (m1 * f2.powi(2) + m2) + mu2 * m1 * f2 * f3,
                ),
                Line::formula(
                    dot(found, motion.fields[1]),
                    names[1],
                    mu1 * m1 * f2 * f3 + mu2 * (m1 * f3.powi(2) + m3),
                ),
            ]
        });
    page.correct();
    let first = first_kind(&Resolved, &motion.state, force);
    let [_, a2, a3] = first.acceleration;
    page.claim("eq1.56", "motion",r"The accelerations of Lagrange's equations of the first kind satisfy those of the second kind with friction (one constraint on three coordinates, arbitrary to the second order)")
        .follows(second_kind::residual(&Resolved, at, force, [a2, a3]).map(Zero));
    let left = std::array::from_fn(|i| force[i] - masses[i] * first.acceleration[i]);
    page.claim("eq1.57", "general-equation",r"$\sum(X_\gamma+R^\tau_\gamma-m_\gamma\ddot x_\gamma)\delta x_\gamma=0$ along the motion (1.53), for all virtual displacements (one constraint on three coordinates, arbitrary to the second order)")
        .follows(motion.fields.map(|field| Zero(dot(left, field))));
}
