//! Gauss' principle with friction: frozen, and with the law of friction substituted.

use super::alphabet::letters;
use super::any::{AnySystem, numbered};
use super::systems;
use claims::{Condition, Page, Point};
use field::{Rational, Tangent};
use mechanics::constrained::appell::residual;
use mechanics::constrained::{System, gauss::constraint, kinetic_energy};
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
}

/// m w = X + J^T lambda and J delta = 0 give Z(w + delta) - Z(w) = 1/2 sum m delta^2.
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
    page.claim("gauss-friction", slug, format!(r"friction frozen, {N} coordinates and {C} constraints: with $X$ the given forces and any friction beside them, as it is at the true motion, $Z(\ddot x+\delta)-Z(\ddot x)=\frac12\sum m\,\delta^2$ for all $\delta$ with $J\delta=0$; the motion is the only minimum"))
        .given(motion.chain(admissible))
        .by_combination([(Equal(more, kinetic_energy(any.masses, delta)), vec![], cofactors)]);
}

/// With R^tau a function of the accelerations w that satisfies J M^-1 R^tau = 0 wherever it is evaluated. w0 is the motion
/// without friction, lambda its multipliers.
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
    page.claim("gauss-friction", slug, format!(r"the law of friction substituted, {N} coordinates and {C} constraints: where $R^\tau(\ddot x)$ is that of the extended decomposition, $Z = \frac12\sum (J^T\lambda)^2/m + \frac12\sum m\,(\ddot x-\ddot x_0-R^\tau/m)^2$ for all accelerations that the constraints admit, with $\ddot x_0$, $\lambda$ of the motion without friction. The first sum does not depend on $\ddot x$; the second is zero at the motions with friction and nowhere else: they are the minima, wherever one exists"))
        .given(keeps(w).into_iter().chain(keeps(w0)).chain(orthogonal))
        .by_combination([(Equal(constraint(any.masses, with_friction, w), right), vec![], cofactors)]);
}

/// Coulomb's law at the rod's guide, F = -f N along x, with N from the balance of all vertical forces.
fn contact(page: &mut Page) {
    let case = systems::rod();
    let motion = case.motion();
    let [m, m1, g, f] = letters(["m", "m1", "g", "f"]);
    let rates = letters(["ẍ", "θ̈"]);
    let given: [Sym; 4] = case.system.force(&motion.state);
    let law = |w: [Tangent<Sym>; 4]| {
        let [m, m1, g, f] = [m, m1, g, f].map(Tangent::fixed);
        -f * ((m + m1) * g - m * w[1] - m1 * w[3])
    };
    let lifted = motion.fixed();
    let z = |rates: [Tangent<Sym>; 2]| {
        let w = lifted.acceleration(rates);
        let force = fixed(given);
        constraint(case.system.masses(), [force[0] + law(w), force[1], force[2], force[3]], w)
    };
    let slopes = gradient(z, rates);
    let w = motion.acceleration(rates);
    let friction = law(fixed(w)).value;
    let force = [given[0] + friction, given[1], given[2], given[3]];
    let moving = residual(&case.system, &motion, force, rates);

    let rational = Rational::new;
    let values = [
        ("m", rational(1, 1)),
        ("m1", rational(1, 1)),
        ("l", rational(1, 1)),
        ("g", rational(10, 1)),
        ("f", rational(1, 2)),
        ("cos θ", rational(3, 5)),
        ("sin θ", rational(4, 5)),
        ("ẋ", rational(1, 1)),
        ("θ̇", rational(0, 1)),
        ("x", rational(0, 1)),
        ("t", rational(0, 1)),
    ];
    let point = at_motion(&moving, rates, &values);
    page.claim("gauss-friction", "contact", r"with the contact's friction $F=-fN(\ddot x)$ itself in $Z$, and not the $R^\tau$ of a decomposition, the rod's motion makes $Z$ stationary")
        .given(moving.map(Zero))
        .refuted(slopes.map(Zero), point);
    let excess = w[0] - force[0] / m;
    let slope = |j: usize| law(lifted.acceleration(along(rates, unit(j)))).slope;
    page.claim("gauss-friction", "contact-slope", r"$\partial Z/\partial\ddot q_j$ is the equation of motion less $(\ddot x - F/m)\,\partial F/\partial\ddot q_j$: friction must be held while $Z$ is varied, or the rod must not pull along the guide")
        .follows((0..2).map(|j| Equal(slopes[j], moving[j] - excess * slope(j))));
    page.correct();
}

/// The exact point at which the equations of motion hold: their two unknowns from the other values.
fn at_motion(moving: &[Sym; 2], rates: [Sym; 2], values: &[(&str, Rational)]) -> Point {
    let named: Vec<(String, Rational)> = values.iter().map(|(name, value)| (name.to_string(), *value)).collect();
    let with = |first: i64, second: i64| {
        let mut all = named.clone();
        all.push((rates[0].to_string(), Rational::new(first, 1)));
        all.push((rates[1].to_string(), Rational::new(second, 1)));
        Point::named(all)
    };
    let value = |point: &Point, i: usize| point.value(moving[i]).unwrap_or(Rational::UNDEFINED);
    let (origin, first, second) = (with(0, 0), with(1, 0), with(0, 1));
    let rest = [0, 1].map(|i| value(&origin, i));
    let matrix = [0, 1].map(|i| [value(&first, i) - rest[i], value(&second, i) - rest[i]]);
    let solved = mechanics::definite::solve(matrix, rest.map(|r| -r)).unwrap_or([Rational::UNDEFINED; 2]);
    let mut all = named.clone();
    all.extend(rates.iter().zip(solved).map(|(rate, value)| (rate.to_string(), value)));
    Point::named(all)
}
