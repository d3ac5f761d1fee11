//! One of the selected rotations: its kind, direction and angular velocity.

use super::{Case, RotationPlace};
use crate::steady_rotations::spectrum::Vector;
use crate::steady_rotations::{Kind, Shape};
use algebra::real::{Enclosure, Number};
use std::sync::Arc;

/// A rotation, or a connected family of rotations.
#[derive(Clone)]
pub struct Turning {
    pub shape: Shape,
    pub kind: Kind,
    pub(super) place: RotationPlace,
    pub(super) case: Arc<Case>,
}

/// The working precisions tried in turn, in bits.
const BITS: [usize; 7] = [160, 320, 640, 1280, 2560, 5120, 8192];

impl Turning {
    /// The kind, from the signature of M - x on the tangent plane.
    pub(super) fn kind_by_signature(&self) -> Option<Kind> {
        let (RotationPlace::Regular(x) | RotationPlace::Shared(_, x)) = &self.place else { return None };
        let [below, above] = self.case.spectrum.around(x)?;
        let adjugate = &self.case.spectrum.adjugate;
        let slope = BITS[..4].iter().find_map(|&bits| {
            let (at, (v, _)) = (x.enclosure(bits), self.at(bits)?);
            let mut sum = Enclosure::integer(0, bits);
            for i in 0..3 {
                for j in 0..3 {
                    sum = &sum + &(&(&v[i] * &v[j]) * &adjugate[i][j].enclosure(&at, bits));
                }
            }
            sum.sign()
        })?;
        // the sign of the determinant follows from the number of eigenvalues below
        let determinant = if (3 - above) % 2 == 0 { 1 } else { -1 };
        Some(Kind::of(below - usize::from(slope * determinant < 0)))
    }

    /// The direction v (for a circle its centre, for the sphere zero) and w (rad/s), to 2^-bits. `None` where 8192 bits
    /// do not suffice.
    pub fn direction_and_speed(&self, bits: usize) -> Option<(Vector<Enclosure>, Enclosure)> {
        let close = |(v, w): &(Vector<Enclosure>, Enclosure)| v.iter().chain([w]).all(|x| x.is_within(bits));
        BITS.into_iter().filter(|work| *work > bits).filter_map(|work| self.at(work)).find(close)
    }

    /// A unit vector along the axis of a circle.
    pub fn axis(&self, bits: usize) -> Option<Vector<Enclosure>> {
        let Shape::Circle { place } = self.shape else { return None };
        let at = |work: usize| match &self.place {
            RotationPlace::Seen(special) => special.axis(&self.case, work),
            RotationPlace::Circle { axis, .. } => unit(axis, work),
            _ => self.case.spectrum.normal(place, work),
        };
        let close = |v: &Vector<Enclosure>| v.iter().all(|x| x.is_within(bits));
        BITS.into_iter().filter(|work| *work > bits).filter_map(at).find(close)
    }

    fn at(&self, bits: usize) -> Option<(Vector<Enclosure>, Enclosure)> {
        let (case, spectrum) = (&*self.case, &self.case.spectrum);
        let still = Enclosure::integer(0, bits);
        let (x, s) = match &self.place {
            RotationPlace::Rest { along, vector } => {
                let v = unit(vector, bits)?;
                return Some((if *along { v } else { v.map(|v| -&v) }, still));
            }
            RotationPlace::Circle { axis, momentum, denominator } => {
                let share = momentum.enclosure(bits).over(&denominator.enclosure(bits))?;
                return Some((axis.each_ref().map(|h| &share * &h.enclosure(bits)), still));
            }
            RotationPlace::Everywhere => return Some(([still.clone(), still.clone(), still.clone()], still)),
            RotationPlace::Seen(special) => return special.at(case, bits),
            RotationPlace::Regular(x) => {
                let x = x.enclosure(bits);
                let [constant, slope] = [0, 1].map(|k| case.ratio[k].enclosure(&x, bits));
                (x, (-&constant).over(&slope)?)
            }
            RotationPlace::Shared(s, x) => (x.enclosure(bits), s.enclosure(bits)),
            RotationPlace::Unseen { eigenvalue, s } => {
                (spectrum.eigenvalues[*eigenvalue].0.enclosure(bits), s.enclosure(bits))
            }
        };
        let q = spectrum.seen.enclosure(&x, bits);
        let share = |k: usize, i: usize| spectrum.numerators[k][i].enclosure(&x, bits).over(&q);
        let component = |i: usize| Some(-&(&s * &(&share(0, i)? + &(&s * &share(1, i)?))));
        let centre: Vec<_> = (0..3).map(component).collect::<Option<_>>()?;
        let mut v: Vector<Enclosure> = centre.try_into().ok()?;
        let one = Enclosure::integer(1, bits);
        if let Shape::Pair { place, positive } = self.shape {
            let reach = v.iter().fold(one.clone(), |rest, v| &rest - &(v * v)).sqrt()?;
            let reach = if positive { reach } else { -&reach };
            let along = spectrum.eigenvector(place, bits)?;
            v = std::array::from_fn(|i| &v[i] + &(&reach * &along[i]));
        }
        Some((v, one.over(&s)?))
    }
}

/// A vector divided by its length.
fn unit(vector: &Vector<Number>, bits: usize) -> Option<Vector<Enclosure>> {
    let vector = vector.each_ref().map(|c| c.enclosure(bits));
    let length = vector.iter().fold(Enclosure::integer(0, bits), |sum, c| &sum + &(c * c)).sqrt()?;
    let unit: Vec<_> = vector.iter().map(|c| c.over(&length)).collect::<Option<_>>()?;
    unit.try_into().ok()
}
