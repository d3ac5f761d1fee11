//! Uniform rotations (M - k) v = -b, b = s h + s^2 G, at eigenvalues k of M whose eigenvector u is not orthogonal to
//! both h and G. For s not zero, b is orthogonal to u only for s = -h.u/G.u. Then v = a + z, where (M - k) a = -b with
//! a orthogonal to the eigenspace and z in the eigenspace.
//!
//! With P a multiple of the projection onto the eigenspace (adj(M - k), M - tr M + 2 k, or 1 for a simple, double or
//! triple k) and u = P G, g = G.u, c = h.u, the momentum gives the component of z along u, and |v| = 1 the rest:
//!
//!   s = -c/g ,   G.z = (k - p s)/s^2 - G.a ,   |z|^2 = 1 - |a|^2 .
//!
//! All quantities are polynomials in x at x = k. The sign of |z|^2 is therefore exact, and decides between one motion,
//! two, a circle and none.

use super::{Case, Momentum, RotationPlace, Selected, Turning};
use crate::steady_rotations::spectrum::{Matrix, Vector, adjugate, along, dot, scaled, sum};
use crate::steady_rotations::{Kind, Shape};
use algebra::real::{Enclosure, Number, Polynomial, Root};
use std::sync::Arc;

/// A solution v = (centre + side sqrt(-excess) (n x u) / |u|) / below, where n is a unit vector orthogonal to the
/// eigenspace.
#[derive(Clone)]
pub(super) struct Special {
    eigenvalue: usize,
    /// The polynomials c (of the spin) and g (of the weight) along u; the angular velocity is -g/c.
    speed: [Polynomial; 2],
    along: Vector<Polynomial>,
    centre: Vector<Polynomial>,
    below: Polynomial,
    /// The quantity |z.u/|u||^2 - |z|^2, times a square.
    excess: Polynomial,
    /// The side of the plane of n and u: 1, -1, or 0 in the plane.
    side: i64,
}

impl Selected {
    pub(super) fn seen(&mut self, case: &Arc<Case>, momentum: &Momentum) {
        for place in (0..case.spectrum.eigenvalues.len()).filter(|place| !case.spectrum.unseen.contains(place)) {
            let (eigenvalue, multiplicity) = &case.spectrum.eigenvalues[place];
            let Some(special) = Special::of(case, place, momentum) else { continue };
            let excess = eigenvalue.sign_of(&special.excess);
            let [below, _] = case.spectrum.beside(place);
            let (sides, shape, kind) = match (multiplicity, excess) {
                (1, 0) => (vec![0], Shape::Point, special.kind(eigenvalue, below)),
                (2, 0) => (vec![0], Shape::Point, if below == 0 { Kind::Minimum } else { Kind::Maximum }),
                (2, -1) => (vec![1, -1], Shape::Point, if below == 0 { Kind::Minimum } else { Kind::Maximum }),
                (3, 0) => (vec![0], Shape::Point, Kind::Degenerate),
                (3, -1) => (vec![0], Shape::Circle { place }, Kind::Degenerate),
                _ => continue,
            };
            let special = Arc::new(special);
            let of_side = |side: i64| {
                let at = Arc::new(Special { side, ..special.as_ref().clone() });
                Turning { shape, kind, place: RotationPlace::Seen(at), case: Arc::clone(case) }
            };
            self.motions.extend(sides.into_iter().map(of_side));
        }
    }
}

impl Special {
    /// The solution at an eigenvalue; `None` where no s gives a motion.
    fn of(case: &Case, place: usize, momentum: &Momentum) -> Option<Self> {
        let (spectrum, body) = (&case.spectrum, &case.body);
        let (eigenvalue, multiplicity) = &spectrum.eigenvalues[place];
        let number = |n: &Number| Polynomial::constant(n.clone());
        let x = Polynomial::from_integers([0, 1]);
        let shifted: Matrix<Polynomial> = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let entry = number(&body.tensor[i][j]);
                if i == j { &entry - &x } else { entry }
            })
        });
        let projection: Matrix<Polynomial> = match multiplicity {
            1 => spectrum.adjugate.clone(),
            2 => {
                let trace = sum((0..3).map(|i| number(&body.tensor[i][i])));
                let more = &scaled(&x, &Number::from(3)) - &trace;
                std::array::from_fn(|i| {
                    std::array::from_fn(|j| if i == j { &shifted[i][j] + &more } else { shifted[i][j].clone() })
                })
            }
            _ => std::array::from_fn(|i| std::array::from_fn(|j| Polynomial::from_integers([i64::from(i == j)]))),
        };
        let projected = |v: &Vector<Number>| -> Vector<Polynomial> { projection.each_ref().map(|row| along(row, v)) };
        let (u, of_spin) = (projected(&body.weight), projected(&body.spin));
        let (c, g) = (along(&u, &body.spin), along(&u, &body.weight));
        if eigenvalue.sign_of(&c) == 0 || eigenvalue.sign_of(&g) == 0 {
            return None;
        }
        // in an eigenspace of higher dimension the projections of h and G may differ in direction
        if (0..3).any(|i| eigenvalue.sign_of(&(&(&c * &u[i]) - &(&g * &of_spin[i]))) != 0) {
            return None;
        }
        // g^2 b
        let (of_h, of_g) = (-&(&c * &g), &c * &c);
        let b: Vector<Polynomial> =
            std::array::from_fn(|i| &scaled(&of_h, &body.spin[i]) + &scaled(&of_g, &body.weight[i]));
        let regular: Matrix<Polynomial> =
            std::array::from_fn(|i| std::array::from_fn(|j| &shifted[i][j] + &projection[i][j]));
        let inverse = adjugate(&regular);
        let determinant = sum((0..3).map(|j| &regular[0][j] * &inverse[j][0]));
        // g^2 det a
        let across: Vector<Polynomial> = std::array::from_fn(|i| -&dot(&inverse[i], &b));
        let (g2, c2) = (&g * &g, &c * &c);
        let g4 = &g2 * &g2;
        // (denominator of p) g^4 det (k - p s - s^2 G.a)
        let kept = scaled(&(&(&g4 * &determinant) * &x), &momentum.denominator);
        let carried = scaled(&(&(&(&g2 * &g) * &determinant) * &c), &momentum.numerator);
        let lifted = scaled(&(&c2 * &along(&across, &body.weight)), &momentum.denominator);
        let gap = &(&kept + &carried) - &lifted;
        // v = a + gap g / (c^2) u
        let scale = &(&g * &c2) * &Polynomial::constant(momentum.denominator.clone());
        let centre: Vector<Polynomial> = std::array::from_fn(|i| &(&across[i] * &scale) + &(&gap * &u[i]));
        let below = &(&g2 * &determinant) * &scale;
        let room = &(&(&g4 * &determinant) * &determinant) - &dot(&across, &across);
        let excess = &(&(&gap * &gap) * &dot(&u, &u)) - &(&(&scale * &scale) * &room);
        Some(Special { eigenvalue: place, speed: [c, g], along: u, centre, below, excess, side: 0 })
    }

    /// The kind of an isolated motion: on the tangent plane M - k has the signs of the other eigenvalues, unless the
    /// plane contains u.
    fn kind(&self, eigenvalue: &Root, below: usize) -> Kind {
        // z = 0 if v is orthogonal to u
        if eigenvalue.sign_of(&dot(&self.centre, &self.along)) == 0 { Kind::Degenerate } else { Kind::of(below) }
    }

    /// (v, w), with the centre of a circle as v.
    pub(super) fn at(&self, case: &Case, bits: usize) -> Option<(Vector<Enclosure>, Enclosure)> {
        let at = case.spectrum.eigenvalues[self.eigenvalue].0.enclosure(bits);
        let value = |p: &Polynomial| p.enclosure(&at, bits);
        let below = value(&self.below);
        let mut v: Vector<Enclosure> = self.centre.each_ref().map(value);
        if self.side != 0 {
            let n = case.spectrum.normal(self.eigenvalue, bits)?;
            let u = self.along.each_ref().map(value);
            let size = u.iter().fold(Enclosure::integer(0, bits), |sum, u| &sum + &(u * u)).sqrt()?;
            let reach = (-&value(&self.excess)).sqrt()?.over(&size)?;
            let reach = &reach * &Enclosure::integer(self.side, bits);
            v = std::array::from_fn(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                &v[i] + &(&reach * &(&(&n[j] * &u[k]) - &(&n[k] * &u[j])))
            });
        }
        let v: Vec<Enclosure> = v.iter().map(|v| v.over(&below)).collect::<Option<_>>()?;
        let w = -&value(&self.speed[1]).over(&value(&self.speed[0]))?;
        Some((v.try_into().ok()?, w))
    }

    /// A unit vector along u: the axis of a circle.
    pub(super) fn axis(&self, case: &Case, bits: usize) -> Option<Vector<Enclosure>> {
        let at = case.spectrum.eigenvalues[self.eigenvalue].0.enclosure(bits);
        let u = self.along.each_ref().map(|p| p.enclosure(&at, bits));
        let size = u.iter().fold(Enclosure::integer(0, bits), |sum, u| &sum + &(u * u)).sqrt()?;
        let unit: Vec<Enclosure> = u.iter().map(|u| u.over(&size)).collect::<Option<_>>()?;
        unit.try_into().ok()
    }
}
