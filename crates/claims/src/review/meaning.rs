//! The physical meaning of a term of an equation of motion, by the dimensions of its letters.

use field::{Rational, Scalar};
use symbolic::{Dimension, Sym};

/// The exponents of kg, m, s and A.
const fn is(kg: i64, m: i64, s: i64, a: i64) -> [i64; 4] {
    [kg, m, s, a]
}

const SPEEDS: [[i64; 4]; 2] = [is(0, 0, -1, 0), is(0, 1, -1, 0)];
const ACCELERATIONS: [[i64; 4]; 2] = [is(0, 0, -2, 0), is(0, 1, -2, 0)];
const CURRENT: [i64; 4] = is(0, 0, 0, 1);
const FLUX: [i64; 4] = is(1, 2, -2, -1);
const RESISTANCE: [i64; 4] = is(1, 2, -3, -2);
const VOLTAGE: [i64; 4] = is(1, 2, -3, -1);
const VISCOUS: [[i64; 4]; 2] = [is(1, 2, -1, 0), is(1, 0, -1, 0)];
const MOMENTS: [[i64; 4]; 2] = [is(1, 2, -2, 0), is(1, 1, -2, 0)];

/// The physical meaning of a term in words, as far as the dimensions of its factors decide it.
pub fn meaning(monomial: Sym, dimension: &dyn Fn(&str) -> Option<Dimension>) -> &'static str {
    let factors = powers(monomial);
    let count = |kinds: &[[i64; 4]]| -> u32 {
        let of_kind = |name: &str| dimension(name).is_some_and(|found| kinds.iter().any(|kind| same(found, *kind)));
        factors.iter().filter(|(name, _)| of_kind(name)).map(|(_, power)| power).sum()
    };
    let different = factors
        .iter()
        .filter(|(name, _)| dimension(name).is_some_and(|found| SPEEDS.iter().any(|kind| same(found, *kind))));
    let (speeds, letters) = (count(&SPEEDS), different.count());
    let (currents, fluxes) = (count(&[CURRENT]), count(&[FLUX]));
    if count(&ACCELERATIONS) > 0 && speeds == 0 {
        return "inertia, or the weight's acceleration";
    }
    match (count(&[RESISTANCE]), currents, fluxes, speeds) {
        (1.., 2.., ..) => "heat in a resistance",
        (1.., ..) => "voltage over a resistance: dissipation",
        (0, 1.., 1.., 0) => "electromagnetic moment of a current",
        (0, _, 1.., 1..) => "voltage induced by the motion",
        _ if count(&[VOLTAGE]) > 0 => "a supplied voltage",
        _ if count(&VISCOUS) > 0 && speeds > 0 => "viscous friction, or a spin's gyroscopic moment",
        (_, _, _, 2..) if letters >= 2 => "product of two speeds: Coriolis, or gyroscopic",
        (_, _, _, 2..) => "square of a speed: centrifugal",
        _ if count(&MOMENTS) > 0 && speeds == 0 => "a given moment or force: weight, load, field",
        (_, 1.., ..) => "linear in a current",
        (_, _, _, 1) => "linear in a speed",
        _ => "neither speeds nor currents in it",
    }
}

fn same(dimension: Dimension, exponents: [i64; 4]) -> bool {
    dimension.exponents() == exponents.map(Rational::int)
}

/// The letters of a monomial with their powers; letters inside roots and functions are included.
fn powers(monomial: Sym) -> Vec<(String, u32)> {
    let mut letters: Vec<(String, u32)> = Vec::new();
    let mut open = vec![(monomial, 1)];
    while let Some((next, power)) = open.pop() {
        match (next.symbol_name(), next.node()) {
            (Some(name), _) => match letters.iter_mut().find(|(known, _)| *known == name) {
                Some((_, total)) => *total += power,
                None => letters.push((name, power)),
            },
            (None, symbolic::Node::Power(base, n)) => open.push((base, power * n)),
            // the sine or cosine of an angle counts as a pure number
            (None, symbolic::Node::Cos(_) | symbolic::Node::Sin(_)) => {}
            (None, node) => open.extend(node.children().map(|child| (child, power))),
        }
    }
    letters
}
