//! Solutions at eigenvalues whose eigenvectors are orthogonal to h and G: v = -N/q + z with z in the eigenspace,
//! wherever |z|^2 > 0.

use super::{Case, RotationPlace, Selected, Turning};
use crate::steady_rotations::{Kind, Shape};
use algebra::real::{Nested, Polynomial};
use std::sync::Arc;

impl Selected {
    pub(super) fn unseen(&mut self, case: &Arc<Case>, length: &[Polynomial], balance: &[Polynomial]) {
        for &place in &case.spectrum.unseen {
            let (eigenvalue, multiplicity) = &case.spectrum.eigenvalues[place];
            // s = 0 is no motion; solutions with |z| = 0 are among the regular ones
            let s_itself = [Polynomial::default(), Polynomial::from_integers([1])];
            let inside = |s: &Nested| s.sign_of(&s_itself) != 0 && s.sign_of(length) < 0;
            let [below, _] = case.spectrum.beside(place);
            for s in Nested::roots(eigenvalue, balance).into_iter().filter(inside) {
                let shapes = match multiplicity {
                    1 => [true, false].map(|positive| Shape::Pair { place, positive }).to_vec(),
                    2 => vec![Shape::Circle { place }],
                    _ => vec![Shape::Sphere],
                };
                let kind = match (multiplicity, below) {
                    (1, falling) => Kind::of(falling),
                    (2, 0) => Kind::Minimum,
                    (2, _) => Kind::Maximum,
                    _ => Kind::Degenerate,
                };
                let at = RotationPlace::Unseen { eigenvalue: place, s };
                let of_shape = |shape| Turning { shape, kind, place: at.clone(), case: Arc::clone(case) };
                self.motions.extend(shapes.into_iter().map(of_shape));
            }
        }
    }
}
