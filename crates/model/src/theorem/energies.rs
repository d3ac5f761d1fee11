//! Lemmas on energies, in the form in which they occur in the equations of each principle.

use super::Equations;
use super::directions::TestDirections;
use symbolic::Sym;

/// Creates a function of positions, speeds and time, with its derivatives and their rates.
fn any_energy(any: &mut TestDirections, name: &str) -> Sym {
    let letter = Sym::symbol(name);
    let of = |what: &str| std::array::from_fn(|k| Sym::symbol(&format!("{name} by {what} {}", k + 1)));
    let (by_place, by_speed): ([Sym; 3], [Sym; 3]) = (of("place"), of("speed"));
    // its rate along a motion depends on the accelerations as the function itself depends on the speeds
    let accelerated = (0..3).fold(Sym::ZERO, |sum, k| sum + by_speed[k] * any.accelerations[k]);
    any.changes(letter, Sym::symbol(&format!("{name} at rest")) + accelerated, by_place);
    any.changes_with_speeds(letter, by_speed);
    letter
}

/// Weights: the derivative of the potential -m g . r by a coordinate is -m g . dv/du, for uniform gravity.
pub(super) fn weights() -> Equations {
    let mut any = TestDirections::any();
    // g . r is a function of positions and time with the rate g . v
    let height = any.function("g . r");
    (0..3).map(|k| (any.by_place(height, k), any.by_speed(any.rate(height), k))).collect()
}

/// Potentials: dV/dq = dV''/du'', the form of Gauss' principle.
pub(super) fn potentials() -> Equations {
    let mut any = TestDirections::any();
    let potential = any.function("V");
    let second = any.rate(any.rate(potential));
    (0..3).map(|k| (any.by_place(potential, k), any.by_acceleration(second, k))).collect()
}

/// Rayleigh's dissipation function: dD/du = dD'/du'.
pub(super) fn dissipation() -> Equations {
    let mut any = TestDirections::any();
    let dissipation = any_energy(&mut any, "D");
    (0..3).map(|k| (any.by_speed(dissipation, k), any.by_acceleration(any.rate(dissipation), k))).collect()
}

/// Hamilton's equations with H = p . u - T + V, expressed by the speeds, are Lagrange's equations.
pub(super) fn canonical() -> Equations {
    let mut any = TestDirections::any();
    let kinetic = any_energy(&mut any, "T");
    let potential = any.function("V");
    // the derivatives of T with respect to the speeds, which are functions of positions and speeds themselves
    let momenta: [Sym; 3] = std::array::from_fn(|j| any.by_speed(kinetic, j));
    for (j, &momentum) in momenta.iter().enumerate() {
        let of = |what: &str| std::array::from_fn(|k| Sym::symbol(&format!("p {} by {what} {}", j + 1, k + 1)));
        any.changes(momentum, Sym::symbol(&format!("p' {}", j + 1)), of("place"));
        any.changes_with_speeds(momentum, of("speed"));
    }
    let energy = (0..3).fold(potential - kinetic, |sum, j| sum + momenta[j] * any.speeds[j]);
    let along = |k: usize| {
        let back = |derivative: &dyn Fn(Sym) -> Sym| {
            (0..3).fold(derivative(energy), |sum, j| sum - any.speeds[j] * derivative(momenta[j]))
        };
        let by_place = back(&|scalar| any.by_place(scalar, k));
        let kinematic = back(&|scalar| any.by_speed(scalar, k));
        let rate = any.rate(momenta[k]) + any.transposed(k, |j| momenta[j]);
        let hamilton = rate + by_place + any.accelerations[k] * kinematic;
        (hamilton, any.lagrange(kinetic, k) + any.by_place(potential, k))
    };
    (0..3).map(along).collect()
}

/// Hamel's equations in quasi-velocities w(q, u, t), for any T(q, w, t), are Lagrange's equations.
///
/// The proof for two quasi-velocities holds for any number, since each one has its own terms.
pub(super) fn quasi_velocities() -> Equations {
    let mut any = TestDirections::any();
    let letters = |name: &str| -> [Sym; 3] { std::array::from_fn(|k| Sym::symbol(&format!("{name} {}", k + 1))) };
    // dT/dq at constant quasi-velocities
    let at_rest = letters("T by place");
    let mut parts = Vec::new();
    for number in ["1", "2"] {
        let momentum = Sym::symbol(&format!("T by w {number}"));
        let rate = Sym::symbol(&format!("T by w' {number}"));
        let (by_place, by_speed) = (letters(&format!("w {number} by place")), letters(&format!("w {number} by speed")));
        any.changes(momentum, rate, [Sym::ZERO; 3]);
        for (slope, rate) in by_speed.into_iter().zip(letters(&format!("w {number} by speed, rate"))) {
            any.changes(slope, rate, [Sym::ZERO; 3]);
        }
        parts.push((momentum, rate, by_place, by_speed));
    }
    // T(q, w(q, u, t), t) by the chain rule
    let kinetic = Sym::symbol("T");
    let chain =
        |of: &dyn Fn(usize) -> Sym| parts.iter().enumerate().fold(Sym::ZERO, |sum, (r, part)| sum + part.0 * of(r));
    let by_place = std::array::from_fn(|k| at_rest[k] + chain(&|r| parts[r].2[k]));
    let by_speed = std::array::from_fn(|k| chain(&|r| parts[r].3[k]));
    any.changes(kinetic, Sym::symbol("T'"), by_place);
    any.changes_with_speeds(kinetic, by_speed);
    let along = |k: usize| {
        let hamel = parts.iter().fold(-at_rest[k], |sum, &(momentum, rate, by_place, by_speed)| {
            let transposed = any.rate(by_speed[k]) + any.transposed(k, |j| by_speed[j]) - by_place[k];
            sum + rate * by_speed[k] + momentum * transposed
        });
        (hamel, any.lagrange(kinetic, k))
    };
    (0..3).map(along).collect()
}

/// Shulgin's equations, with a dependent speed s(q, w, t) substituted into T, are Lagrange's equations along the admissible directions.
///
/// The proof for one dependent speed holds for any number, since each one has its own terms.
pub(super) fn constrained() -> Equations {
    let mut any = TestDirections::any();
    let letters = |name: &str| -> [Sym; 3] { std::array::from_fn(|k| Sym::symbol(&format!("{name} {}", k + 1))) };
    let (momenta, rates, forces) = (letters("p"), letters("p'"), letters("T by place"));
    // the third speed as a function of the first two, and of positions
    let [first, second, _] = letters("s by w");
    let (slopes, slope_rates, by_place) = ([first, second], letters("s' by w"), letters("s by place"));
    for (letter, rate) in momenta.into_iter().zip(rates).chain(slopes.into_iter().zip(slope_rates)) {
        any.changes(letter, rate, [Sym::ZERO; 3]);
    }
    let reduced = Sym::symbol("T*");
    any.changes(reduced, Sym::symbol("T*'"), std::array::from_fn(|i| forces[i] + momenta[2] * by_place[i]));
    let by_speed = |j: usize| momenta[j] + momenta[2] * slopes[j];
    any.changes_with_speeds(reduced, [by_speed(0), by_speed(1), Sym::ZERO]);
    let along = |j: usize| {
        let displaced = any.by_place(reduced, j) + slopes[j] * any.by_place(reduced, 2);
        let lost = momenta[2] * (slope_rates[j] - by_place[j] - slopes[j] * by_place[2]);
        let shulgin = any.rate(any.by_speed(reduced, j)) - displaced - lost;
        (shulgin, rates[j] - forces[j] + slopes[j] * (rates[2] - forces[2]))
    };
    (0..2).map(along).collect()
}
