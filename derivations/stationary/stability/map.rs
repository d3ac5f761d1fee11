//! Where rotation about an axis that carries rotor and weight is stable: over its angular velocity and the rotor's speed.
//!
//! At one angular velocity what decides are two polynomials in the rotor's speed W: b, and a^2 - 4 b (`reduced`). Their real
//! roots are isolated, and between two neighbours nothing changes: so every column of the map is exact, edges included.

use super::reduced::{Fate, Reduced};
use crate::stationary::energies::Energies;
use field::{Rational, Scalar};
use nalgebra::Vector3;
use symbolic::real::Polynomial;

/// A gyrostat whose rotor and weight lie along one principal axis of A*, and which end of it points down.
#[derive(Clone, Copy, Debug)]
pub struct OneAxis {
    energies: Energies<Rational>,
    vertical: Vector3<Rational>,
}

/// What is known of one angular velocity: edges in the rotor's speed, in ascending order, and what is between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// w0, rad/s
    pub speed: Rational,
    /// rad/s; one fate more than edges
    pub edges: Vec<Edge>,
    pub fates: Vec<Fate>,
}

/// Where a decisive polynomial vanishes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// W, rad/s
    pub rotor_speed: f64,
    /// A tilt costs no energy: b = 0; otherwise two pairs of roots meet.
    pub neutral: bool,
}

/// The degree of a^2 - 4 b in W.
const DEGREE: i64 = 4;

impl OneAxis {
    /// `None` where rotor, weight and a principal axis do not agree. `hanging`: the weight points down.
    pub fn of(energies: &Energies<Rational>, hanging: bool) -> Option<Self> {
        let zero = Rational::int(0);
        let alone = |v: &Vector3<Rational>, i: usize| (0..3).all(|j| (v[j] == zero) == (j != i));
        let agrees = |i: &usize| {
            let row: Vector3<Rational> = energies.tensor.column(*i).into();
            alone(&row, *i) && alone(&energies.mixed, *i) && alone(&energies.weight, *i)
        };
        let axis = (0..3).find(agrees)?;
        let down = energies.weight[axis].sign()? > 0;
        let side = Rational::int(if down == hanging { 1 } else { -1 });
        let vertical = Vector3::from_fn(|j, _| if j == axis { side } else { zero });
        Some(OneAxis { energies: *energies, vertical })
    }

    /// The motion with these speeds.
    pub fn motion(&self, speed: Rational, rotor_speed: Rational) -> Reduced<Rational> {
        Reduced::kept(&self.energies, speed, self.vertical, rotor_speed)
    }

    /// What becomes of it, exactly.
    pub fn fate(&self, speed: Rational, rotor_speed: Rational) -> Fate {
        // the data are defined, and so are all signs
        Fate::of(&self.motion(speed, rotor_speed), |x: Rational| x.sign().unwrap_or(0))
    }

    /// So many columns, evenly from -`most` to `most` rad/s.
    pub fn columns(&self, most: f64, count: usize) -> Vec<Column> {
        let centre = |k: usize| most * ((2 * k + 1) as f64 / count as f64 - 1.0);
        (0..count).map(|k| self.column(Rational::exactly(centre(k)))).collect()
    }

    /// All rotor speeds at one angular velocity.
    pub fn column(&self, speed: Rational) -> Column {
        let values = (0..=DEGREE).map(|node| self.motion(speed, Rational::int(node)).polynomial());
        let values: Vec<[Rational; 3]> = values.collect();
        let neutral: Vec<Rational> = values.iter().map(|[_, _, b]| *b).collect();
        let meeting: Vec<Rational> = values.iter().map(|[det, a, b]| *a * *a - *det * *b * Rational::int(4)).collect();
        let roots = |values: &[Rational], neutral: bool| -> Vec<Edge> {
            let polynomial = Polynomial::from_rationals(&interpolated(values)).unwrap_or_default();
            polynomial.real_roots().iter().map(|root| Edge { rotor_speed: root.to_f64(), neutral }).collect()
        };
        let mut edges = [roots(&neutral, true), roots(&meeting, false)].concat();
        edges.sort_by(|a, b| a.rotor_speed.total_cmp(&b.rotor_speed));
        let ends = [
            &[f64::NEG_INFINITY],
            &edges.iter().map(|edge| edge.rotor_speed).collect::<Vec<_>>()[..],
            &[f64::INFINITY],
        ]
        .concat();
        let between = |pair: &[f64]| match (pair[0].is_finite(), pair[1].is_finite()) {
            (true, true) => 0.5 * (pair[0] + pair[1]),
            (true, false) => pair[0] + pair[0].abs() + 1.0,
            (false, true) => pair[1] - pair[1].abs() - 1.0,
            (false, false) => 0.0,
        };
        let fates = ends.windows(2).map(|pair| self.fate(speed, Rational::exactly(between(pair)))).collect();
        Column { speed, edges, fates }
    }
}

impl Column {
    /// At a rotor speed that is no edge.
    pub fn at(&self, rotor_speed: f64) -> Fate {
        let below = self.edges.iter().filter(|edge| edge.rotor_speed < rotor_speed).count();
        self.fates.get(below).copied().unwrap_or(Fate::Edge)
    }
}

/// The coefficients, constant first, of the polynomial with these values at 0, 1, 2, ... (Newton).
fn interpolated(values: &[Rational]) -> Vec<Rational> {
    let mut differences = values.to_vec();
    for order in 1..values.len() {
        for k in (order..values.len()).rev() {
            differences[k] = (differences[k] - differences[k - 1]) / Rational::int(order as i64);
        }
    }
    let mut coefficients: Vec<Rational> = Vec::new();
    for (node, difference) in differences.iter().enumerate().rev() {
        // p (x - node) + difference
        let node = Rational::int(node as i64);
        let mut next = vec![*difference];
        next.extend(&coefficients);
        for (k, c) in coefficients.iter().enumerate() {
            next[k] -= node * *c;
        }
        coefficients = next;
    }
    coefficients
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_is_found_again_from_its_values() {
        let c = [3, -1, 0, 7, -2].map(Rational::int);
        let value = |x: i64| c.iter().rev().fold(Rational::int(0), |sum, c| sum * Rational::int(x) + *c);
        assert_eq!(interpolated(&(0..5).map(value).collect::<Vec<_>>()), c);
    }
}
