//! Where rotation about an axis that carries rotor and weight is stable, over two data.
//!
//! At one value of the first datum what decides are two polynomials in the second: b, and a^2 - 4 b (`reduced`). Their real
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

/// What is known of one value of the first datum: edges in the second, in ascending order, and what is between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// One fate more than edges.
    pub edges: Vec<Edge>,
    pub fates: Vec<Fate>,
}

/// Where a decisive polynomial vanishes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// The second datum.
    pub at: f64,
    /// A tilt costs no energy: b = 0; otherwise two pairs of roots meet.
    pub neutral: bool,
}

impl OneAxis {
    /// `None` where rotor, weight and a principal axis do not agree. `hanging`: the weight points down.
    pub fn of(energies: &Energies<Rational>, hanging: bool) -> Option<Self> {
        let down = energies.weight.iter().find_map(|g| g.sign().filter(|sign| *sign != 0))? > 0;
        Self::about(energies, down == hanging)
    }

    /// The same, whichever way the weight points: about the axis itself, or its opposite.
    pub fn about(energies: &Energies<Rational>, along: bool) -> Option<Self> {
        let zero = Rational::int(0);
        let axis = (0..3).find(|i| energies.mixed[*i] != zero)?;
        let alone = |v: &Vector3<Rational>| (0..3).all(|j| j == axis || v[j] == zero);
        let row: Vector3<Rational> = energies.tensor.column(axis).into();
        let agrees = alone(&row) && alone(&energies.mixed) && alone(&energies.weight);
        let side = Rational::int(if along { 1 } else { -1 });
        let vertical = Vector3::from_fn(|j, _| if j == axis { side } else { zero });
        agrees.then_some(OneAxis { energies: *energies, vertical })
    }

    /// The motion with these speeds.
    pub fn motion(&self, speed: Rational, rotor_speed: Rational) -> Reduced<Rational> {
        Reduced::kept(&self.energies, speed, self.vertical, rotor_speed)
    }

    /// All rotor speeds at one angular velocity.
    pub fn column(&self, speed: Rational) -> Column {
        // a^2 - 4 b is of degree 4 in W
        let nodes: Vec<Rational> = (0..=4).map(Rational::int).collect();
        let motion = |rotor_speed: Rational| Some(self.motion(speed, rotor_speed));
        let column = Column::of(&nodes, [f64::NEG_INFINITY, f64::INFINITY], &motion);
        column.unwrap_or(Column { edges: Vec::new(), fates: vec![Fate::Edge] })
    }
}

impl Column {
    /// By the motions at values of the second datum, of which b and a^2 - 4 b are polynomials with degrees below the number of
    /// nodes; within a range. `None` where there is no motion.
    pub fn of(
        nodes: &[Rational],
        [low, high]: [f64; 2],
        motion: &dyn Fn(Rational) -> Option<Reduced<Rational>>,
    ) -> Option<Self> {
        let values = nodes.iter().map(|node| Some(motion(*node)?.polynomial()));
        let values: Vec<[Rational; 3]> = values.collect::<Option<_>>()?;
        let neutral: Vec<Rational> = values.iter().map(|[_, _, b]| *b).collect();
        let meeting: Vec<Rational> = values.iter().map(|[det, a, b]| *a * *a - *det * *b * Rational::int(4)).collect();
        let roots = |values: &[Rational], neutral: bool| -> Vec<Edge> {
            let polynomial = Polynomial::from_rationals(&interpolated(nodes, values)).unwrap_or_default();
            let all = polynomial.real_roots().into_iter().map(|root| Edge { at: root.to_f64(), neutral });
            all.filter(|edge| low < edge.at && edge.at < high).collect()
        };
        let mut edges = [roots(&neutral, true), roots(&meeting, false)].concat();
        edges.sort_by(|a, b| a.at.total_cmp(&b.at));
        let ends = [&[low], &edges.iter().map(|edge| edge.at).collect::<Vec<_>>()[..], &[high]].concat();
        let between = |pair: &[f64]| match (pair[0].is_finite(), pair[1].is_finite()) {
            (true, true) => 0.5 * (pair[0] + pair[1]),
            (true, false) => pair[0] + pair[0].abs() + 1.0,
            (false, true) => pair[1] - pair[1].abs() - 1.0,
            (false, false) => 0.0,
        };
        // the data are defined, and so are all signs
        let fate = |at: f64| Some(Fate::of(&motion(Rational::decimal(at))?, |x: Rational| x.sign().unwrap_or(0)));
        let fates = ends.windows(2).map(|pair| fate(between(pair))).collect::<Option<_>>()?;
        Some(Column { edges, fates })
    }

    /// At a value that is no edge.
    pub fn at(&self, value: f64) -> Fate {
        let below = self.edges.iter().filter(|edge| edge.at < value).count();
        self.fates.get(below).copied().unwrap_or(Fate::Edge)
    }
}

/// The coefficients, constant first, of the polynomial with these values at these nodes (Newton).
fn interpolated(nodes: &[Rational], values: &[Rational]) -> Vec<Rational> {
    let mut differences = values.to_vec();
    for order in 1..values.len() {
        for k in (order..values.len()).rev() {
            differences[k] = (differences[k] - differences[k - 1]) / (nodes[k] - nodes[k - order]);
        }
    }
    let mut coefficients: Vec<Rational> = Vec::new();
    for (node, difference) in nodes.iter().zip(differences).rev() {
        // p (x - node) + difference
        let mut next = vec![difference];
        next.extend(&coefficients);
        for (k, c) in coefficients.iter().enumerate() {
            next[k] -= *node * *c;
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
        let value = |x: &Rational| c.iter().rev().fold(Rational::int(0), |sum, c| sum * *x + *c);
        let nodes = [0, 1, 3, -2, 7].map(|n| Rational::new(n, 2));
        assert_eq!(interpolated(&nodes, &nodes.each_ref().map(value)), c);
    }
}
