//! Gyrostats for which carrier, rotor and weight have a common axis of symmetry.

use super::approximation::Approximation;
use super::family::beside;
use super::reduced::Reduced;
use crate::stationary::energies::Energies;
use algebra::real::Enclosure;
use field::Rational;
use nalgebra::Vector3;
use symbolic::{Formulas, symbols};

/// Whether the gyrostat is symmetric about an axis; `value`: the rotor's speed, if the machine prescribes it.
pub fn is_symmetric(
    approximation: &Approximation,
    energies: &Energies<Rational>,
    axis: &Vector3<Rational>,
    value: Option<Rational>,
) -> bool {
    let vanishes = |v: &Vector3<Rational>| v.iter().all(|c| c.sign() == Some(0));
    let still = approximation.layout.slip().is_none() && value.is_some_and(|value| value.sign() == Some(0));
    let [first, second] = beside(axis);
    let of = |v: &Vector3<Rational>| energies.tensor * v;
    let equal = of(&first).dot(&first) * second.dot(&second) == of(&second).dot(&second) * first.dot(&first);
    equal
        && vanishes(&of(axis).cross(axis))
        && of(&first).dot(&second).sign() == Some(0)
        && (still || vanishes(&energies.mixed.cross(axis)))
        && vanishes(&energies.weight.cross(axis))
}

/// The number a_c for which s + a_c divides both classical polynomials: a rotor along an axis of symmetry does not
/// respond to nutation, hence its own decay rate is an eigenvalue.
pub fn unfelt(energies: &Energies<Rational>, place: &[Enclosure; 7], one: &Enclosure) -> Option<Enclosure> {
    let unknowns = symbols(["w0", "v1", "v2", "v3", "W"]);
    let [speed, v1, v2, v3, rotor_speed] = unknowns;
    let [det, a, _] = Reduced::kept(&energies.written(), speed, Vector3::new(v1, v2, v3), rotor_speed).polynomial();
    Formulas::of(&[a / det], &unknowns).ok()?.values(&place[..5], one)?.pop()
}
