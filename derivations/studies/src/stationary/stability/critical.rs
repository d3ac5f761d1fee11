//! Functions along a family's curve, one of which vanishes wherever a stability verdict changes.
//!
//! A verdict changes where an eigenvalue reaches or leaves the imaginary axis. With the polynomials in s = z^2 of the
//! two classical gyrostats, C(s) = det T_c (s^2 + a_c s + b_c) at constant speed and F(s) of the free rotor, and the
//! motor's operational stiffness Z, the characteristic equation is A' s F(s) + Z(z) C(s) = 0. If the motor damps, Im
//! Z(iy) is nonzero for y nonzero. A root i y is then one of C and of F: their resultant vanishes, or, for y = 0, the
//! constant term of C. Both are claims: `motor/crossing`, `currents/lagging` and `currents/damps`. Without damping the
//! characteristic polynomial is one in s, whose roots change their kind where two are equal or one is zero.

use super::approximation::Approximation;
use super::reduced::Reduced;
use crate::stationary::energies::Energies;
use algebra::real::{Conic, Ordered};
use field::Rational;
use mechanics::linear_stability::{characteristic, derivative, resultant};
use nalgebra::Vector3;
use symbolic::{Formulas, Sym, symbols};

/// The functions that do not vanish identically. `None` where they have irrational coefficients, or not the whole
/// family is steady.
pub fn critical(
    approximation: &Approximation,
    energies: &Energies<Rational>,
    place: &[Conic; 7],
    momentum: Option<Rational>,
) -> Option<Vec<Conic>> {
    let [speed, v1, v2, v3, rotor_speed, ..] = place.clone();
    let classical = Classical::at(energies, [speed, v1, v2, v3, rotor_speed])?;
    let off = momentum.map(|p| Some(classical.momentum.minus(&classical.momentum.fraction(p)?)));
    let off = match off {
        Some(off) => Some(off?),
        None => None,
    };
    if classical.missing.iter().chain(&off).any(|one| !one.is_zero()) {
        return None;
    }
    let all = if approximation.conservative { undamped(approximation, place)? } else { damped(classical) };
    Some(all.into_iter().filter(|function| !function.is_zero()).collect())
}

/// The characteristic polynomial in s of a conservative system.
fn undamped(approximation: &Approximation, place: &[Conic; 7]) -> Option<Vec<Conic>> {
    let one = place[0].integer(1);
    let linear = approximation.at(place, &one)?;
    let mut polynomial = characteristic(&linear.rates, &one);
    while polynomial.len() > 1 && polynomial.last().is_some_and(Conic::is_zero) {
        polynomial.pop();
    }
    let in_squares: Vec<Conic> = polynomial.into_iter().step_by(2).collect();
    Some(changes(&in_squares, &one))
}

/// The functions that vanish where a root is zero, and where two are equal.
fn changes(polynomial: &[Conic], one: &Conic) -> Vec<Conic> {
    let equal = (polynomial.len() > 2).then(|| resultant(polynomial, &derivative(polynomial), one));
    polynomial.last().cloned().into_iter().chain(equal).collect()
}

fn damped(Classical { kept, free, .. }: Classical) -> Vec<Conic> {
    let (mut kept, mut free) = (kept.to_vec(), free.to_vec());
    let one = kept[0].integer(1);
    // a zero root of both belongs to the family itself
    while kept.len() > 1 && [&kept, &free].iter().all(|p| p.last().is_some_and(Conic::is_zero)) {
        kept.pop();
        free.pop();
    }
    let shared = resultant(&kept, &free, &one);
    let mut all = vec![kept[kept.len() - 1].clone(), shared.clone()];
    if shared.is_zero() {
        // roots without effect on the motor change by themselves; the others where the factors' own roots change
        all.extend(changes(&kept, &one));
        all.extend(changes(&free, &one));
        all.extend((1..kept.len()).map(|k| kept[0].times(&free[k]).minus(&free[0].times(&kept[k]))));
    }
    all
}

/// The polynomials in s, and the residuals of a steady motion, from the reduced equations.
struct Classical {
    kept: [Conic; 3],
    free: [Conic; 3],
    missing: [Conic; 3],
    momentum: Conic,
}

impl Classical {
    /// The polynomials at (w0, v, W).
    fn at(energies: &Energies<Rational>, place: [Conic; 5]) -> Option<Self> {
        let energies = energies.written();
        let unknowns = symbols(["w0", "v1", "v2", "v3", "W"]);
        let [speed, v1, v2, v3, rotor_speed] = unknowns;
        let vertical = Vector3::new(v1, v2, v3);
        let kept = Reduced::kept(&energies, speed, vertical, rotor_speed);
        let free = Reduced::free(&energies, speed, vertical, rotor_speed);
        let (all, _) = energies.momenta::<Sym>(vertical * speed, rotor_speed);
        let missing = (all * speed + energies.weight).cross(&vertical);
        let results = kept.polynomial().into_iter().chain(free.polynomial()).chain(missing.iter().copied());
        let results: Vec<Sym> = results.chain([all.dot(&vertical)]).collect();
        let values = Formulas::of(&results, &unknowns).ok()?.values(&place, &place[0].integer(1))?;
        let three = |from: usize| -> Option<[Conic; 3]> { values.get(from..from + 3)?.to_vec().try_into().ok() };
        Some(Classical { kept: three(0)?, free: three(3)?, missing: three(6)?, momentum: values.last()?.clone() })
    }
}
