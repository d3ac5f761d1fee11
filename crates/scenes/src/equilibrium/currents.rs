//! Steady currents: rates of charges for which no equation asks.
//!
//! Where an equation holds a charge, as that of a capacitor, no current flows at rest. Where none does, the charge of a motor's winding
//! or of a mesh may grow while everything else stands: its rate is an unknown of the equilibrium in the place of the charge itself.

use crate::kernel::Rows;
use crate::linearisation::{Point, VariedEquations};
use nalgebra::DMatrix;

/// Points at which the equations are asked for charges.
const POINTS: usize = 4;

/// Parts of a point are moved by up to this part of their size, and of one in SI units.
const ASIDE: f64 = 0.3;

/// Multiples of the golden section are spread evenly.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// Directions of charges, orthonormal columns over all speeds, along which no equation changes anywhere near a point.
pub(super) fn cyclic(equations: &VariedEquations, guess: &Point) -> DMatrix<f64> {
    let (n, charges) = (guess.speeds.len(), &equations.charges);
    let mut rows = Rows::none(charges.len());
    let mut is_known = false;
    for number in 0..POINTS {
        let at = equations.at(&beside(equations, guess, number));
        let parts = [&at.motion, &at.zero, &at.rate, &at.acceleration];
        let slopes = parts.map(|values| values.by_coordinates.select_columns(charges));
        // an expression may have no value beside the guess
        if slopes.iter().all(|part| part.iter().all(|slope| slope.is_finite())) {
            slopes.iter().for_each(|part| rows.add(part));
            is_known = true;
        }
    }
    let own = if is_known { rows.kernel() } else { DMatrix::zeros(charges.len(), 0) };
    let mut all = DMatrix::zeros(n, own.ncols());
    for (row, &charge) in charges.iter().enumerate() {
        all.row_mut(charge).copy_from(&own.row(row));
    }
    all
}

/// A point beside another one, at which nothing vanishes by chance; the first is the point itself but for what moves.
fn beside(equations: &VariedEquations, guess: &Point, number: usize) -> Point {
    let mut point = guess.clone();
    let part = |place: usize| ((place + 1 + 31 * number) as f64 * GOLDEN).fract() + 0.5;
    for place in 0..guess.speeds.len() {
        let size = ASIDE * equations.size(guess, place) * number as f64 / POINTS as f64;
        equations.displace(&mut point, place, size * part(place));
    }
    for (first, values) in [(3, &mut point.speeds), (7, &mut point.accelerations), (11, &mut point.multipliers)] {
        values.iter_mut().enumerate().for_each(|(place, value)| *value += part(first + place));
    }
    point
}
