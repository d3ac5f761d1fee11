//! Gauss' principle with friction: with the friction held constant, and with the law of friction substituted.

use super::alphabet::{letter, letters};
use super::any::{AnySystem, numbered};
use super::cases;
use claims::{Condition, Line, Page};
use field::{Analytic, Tangent};
use mechanics::constrained::appell::residual;
use mechanics::constrained::combining::extended;
use mechanics::constrained::rates::jacobian;
use mechanics::constrained::{PointSystem, gauss::constraint, kinetic_energy};
use mechanics::definite::root;
use mechanics::differentiate::{along, fixed, gradient, unit};
use symbolic::Sym;

use Condition::{Equal, Zero};

pub fn claims(page: &mut Page) {
    page.section("Gauss' principle with friction");
    frozen::<2, 1>(page, "frozen-2-1");
    frozen::<4, 2>(page, "frozen-4-2");
    substituted::<2, 1>(page, "substituted-2-1");
    substituted::<3, 2>(page, "substituted-3-2");
    substituted::<4, 2>(page, "substituted-4-2");
    contact(page);
    paradox(page);
}

/// The equations m w = X + J^T lambda and J delta = 0 imply Z(w + delta) - Z(w) = 1/2 sum m delta^2.
fn frozen<const N: usize, const C: usize>(page: &mut Page, slug: &'static str) {
    let any = AnySystem::<N, C>::new();
    let (w, delta, force): ([Sym; N], [Sym; N], [Sym; N]) = (numbered("w"), numbered("δ"), numbered("X"));
    let lambda: [Sym; C] = numbered("λ");
    let reaction = any.reaction(lambda);
    let motion = (0..N).map(|i| Zero(any.masses[i] * w[i] - force[i] - reaction[i]));
    let admissible = any.along_rows(delta).map(Zero);
    let moved = std::array::from_fn(|i| w[i] + delta[i]);
    let more = constraint(any.masses, force, moved) - constraint(any.masses, force, w);
    let cofactors = (0..N).map(|i| (i, delta[i])).chain((0..C).map(|k| (N + k, lambda[k]))).collect();
    page.claim("gauss-friction", slug, format!(r"With friction frozen, $(N,C)=({N},{C})$, let $X$ be the given forces and any friction together, as it is at the true motion. Then $Z(\ddot x+\delta)-Z(\ddot x)=\frac12\sum m\,\delta^2$ for all $\delta$ with $J\delta=0$, so that the motion is the only minimum"))
        .in_words()
        .given(motion.chain(admissible))
        .by_combination([(Equal(more, kinetic_energy(any.masses, delta)), vec![], cofactors)]);
}

/// The case in which R^tau is a function of the accelerations w that satisfies J M^-1 R^tau = 0 at every argument. w0
/// is the acceleration without friction, lambda its multipliers.
fn substituted<const N: usize, const C: usize>(page: &mut Page, slug: &'static str) {
    let any = AnySystem::<N, C>::new();
    let (w, friction, force): ([Sym; N], [Sym; N], [Sym; N]) = (numbered("w"), numbered("R"), numbered("X"));
    let lambda: [Sym; C] = numbered("λ");
    let w0: [Sym; N] = std::array::from_fn(|i| (force[i] + any.reaction(lambda)[i]) / any.masses[i]);
    let keeps = |v: [Sym; N]| -> Vec<Condition> {
        any.along_rows(v).into_iter().zip(any.rest).map(|(moved, rest)| Zero(moved + rest)).collect()
    };
    let orthogonal = any.along_rows(any.per_mass(friction)).map(Zero);
    let with_friction = std::array::from_fn(|i| force[i] + friction[i]);
    let missed: [Sym; N] = std::array::from_fn(|i| w[i] - w0[i] - friction[i] / any.masses[i]);
    let of_constraints = kinetic_energy(any.masses, any.per_mass(any.reaction(lambda)));
    let right = of_constraints + kinetic_energy(any.masses, missed);
    // the mixed term is lambda . J (w - w0 - M^-1 R^tau)
    let cofactors = (0..C).flat_map(|k| [(k, lambda[k]), (C + k, -lambda[k]), (2 * C + k, -lambda[k])]).collect();
    page.claim("gauss-friction", slug, format!(r"With the law of friction substituted, $(N,C)=({N},{C})$, and $R^\tau(\ddot x)$ that of the extended decomposition, $Z = \frac12\sum (J^T\lambda)^2/m + \frac12\sum m\,(\ddot x-\ddot x_0-R^\tau/m)^2$ for all accelerations that the constraints admit, with $\ddot x_0$, $\lambda$ of the motion without friction. The first sum does not depend on $\ddot x$. The second is zero at the motions with friction and nowhere else, so that they are the minima, wherever one exists"))
        .in_words()
        .given(keeps(w).into_iter().chain(keeps(w0)).chain(orthogonal))
        .by_combination([(Equal(constraint(any.masses, with_friction, w), right), vec![], cofactors)]);
}

/// Coulomb's law at the rod's guide, F = -f N along x, with N from the balance of all vertical forces.
fn contact(page: &mut Page) {
    let case = cases::rod();
    let motion = case.motion();
    let [m, m1, l, g, f, dtheta] = letters(["m", "m1", "l", "g", "f", "θ̇"]);
    let given: [Sym; 4] = case.system.force(&motion.state);
    let lifted = motion.fixed();
    let law = |w: [Tangent<Sym>; 4]| {
        let [m, m1, g, f] = [m, m1, g, f].map(Tangent::fixed);
        -f * ((m + m1) * g - m * w[1] - m1 * w[3])
    };
    let rubbed = |rates: [Tangent<Sym>; 2]| {
        let [x, others @ ..] = fixed(given);
        let [y, x1, y1] = others;
        [x + law(lifted.acceleration(rates)), y, x1, y1]
    };
    let z = |rates| constraint(case.system.masses(), rubbed(rates), lifted.acceleration(rates));
    let at_motion = root(|rates| residual(&case.system, &lifted, rubbed(rates), rates)).unwrap_or([Sym::UNDEFINED; 2]);
    let slope = gradient(z, at_motion)[1];
    page.claim("gauss-friction", "contact", r"With the contact's friction $F=-fN(\ddot x)$ itself in $Z$, and not the $R^\tau$ of a decomposition, the rod's motion makes $Z$ stationary: $\partial Z/\partial\ddot\theta=0$ there")
        .why(r"$F$ depends on $\ddot x$, and varying it adds $-(\ddot x-F/m)\,\partial F/\partial\ddot\theta$ to the slope.")
        .fails([Line::formula(slope, letter("slope"), Sym::ZERO)]);
    let point = letter("θ").circle();
    let (cos, sin) = (point.cos, point.sin);
    // S: the force of the rod, whose length is constant, under the friction F = -f (m g - S sin) on M
    let push = -(m * m1 * (l * dtheta * dtheta + g * sin + f * g * cos)) / (m + m1 * cos * (cos - f * sin));
    page.claim(
        "gauss-friction",
        "contact-slope",
        r"With the contact's friction $F=-fN(\ddot x)$ in $Z$ the rod's motion has the slope $\partial Z/\partial\ddot\theta = f l (m_1/m) \cos^2\theta$ times the compressive force of the rod",
    )
    .holds([Line::formula(slope, letter("slope"), f * l * m1 * cos * cos / m * push)]);
    page.correct();
    let rates = letters(["ẍ", "θ̈"]);
    let forces = rubbed(fixed(rates)).map(|force| force.value);
    let moving = residual(&case.system, &motion, forces, rates);
    let slopes = gradient(z, rates);
    let excess = motion.acceleration(rates)[0] - forces[0] / m;
    let of_law = |j: usize| law(lifted.acceleration(along(rates, unit(j)))).slope;
    page.claim("gauss-friction", "contact-frozen", r"With the contact's friction $F(\ddot x)$ in $Z$, $\partial Z/\partial\ddot q_j$ of the rod is the equation of motion less $(\ddot x - F/m)\,\partial F/\partial\ddot q_j$. The friction must therefore be held while $Z$ is varied")
        .in_words()
        .follows((0..2).map(|j| Equal(slopes[j], moving[j] - excess * of_law(j))));
}

/// A state at which the motion that should be the minimum does not exist.
fn paradox(page: &mut Page) {
    let case = cases::rod();
    let state = case.motion().state;
    let [m, m1, g, f, along] = letters(["m", "m1", "g", "f", "R1"]);
    let (masses, rows): ([Sym; 4], [[Sym; 4]; 2]) = (case.system.masses(), jacobian(&case.system, &state));
    let contact = [along, Sym::ZERO, Sym::ZERO, Sym::ZERO];
    let friction = extended(masses, rows, contact).map_or([Sym::UNDEFINED; 4], |split| split.of_friction);
    let free = case.by_multipliers([Sym::ZERO; 4]);
    let w: [Sym; 4] = std::array::from_fn(|i| free.acceleration[i] + friction[i] / masses[i]);
    // R_2 from the balance of all vertical forces, y downwards; the point slides to the right, and the floor pushes
    // upwards
    let across = m * w[1] + m1 * w[3] - (m + m1) * g;
    let point = letter("θ").circle();
    let inertia = m + m1 * point.cos * point.cos;
    let sigma = (inertia - f * m1 * point.sin * point.cos) / inertia;
    page.claim("gauss-friction", "paradox", r"On the rod Coulomb's law $R_1=fR_2$ for the motion with $R^\tau$ is $\sigma R_1 = f\lambda_2$ with $\sigma = (m+m_1\cos^2\theta-f m_1\sin\theta\cos\theta)/(m+m_1\cos^2\theta)$ and $\lambda_2$ of the motion without friction. Where $\sigma=0$ and $\lambda_2\ne0$ no $R_1$ satisfies it (Painlevé's paradox)")
        .in_words()
        .follows([Equal(along - f * across, sigma * along + f * free.multipliers[1])]);
}
