//! The ellipsoid with the inertia of a body: homogeneous, or a thin plate if one of its axes has no length.

use super::Geometry;
use super::figure::Figure;
use model::Inertia;
use nalgebra::{Matrix3, SymmetricEigen, Vector3};

/// Half axes shorter than this part of the longest are drawn as zero.
const FLAT: f64 = 1e-3;

/// An ellipsoid in the frame of a body's inertia.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipsoid {
    /// Unit vectors of the principal axes, in the frame of [`Geometry::inertia_frame`].
    pub axes: [Vector3<f64>; 3],
    /// The half axes, m; for a body without mass, the half axes for one kilogram.
    pub lengths: [f64; 3],
    /// True if the body has a positive mass.
    pub has_mass: bool,
}

impl Geometry {
    /// The index of the frame in whose axes a body's inertia is given; `None` without inertia.
    pub fn inertia_frame(&self, body: usize) -> Option<usize> {
        let body = self.model.bodies.get(body)?;
        match body.inertia.as_ref()? {
            Inertia::Tensor { axes, .. } => Some(axes.0),
            Inertia::Axial(_) | Inertia::OfShaft { .. } => body.frame.map(|frame| frame.0),
        }
    }

    /// The ellipsoid of a body, in the axes of [`Geometry::inertia_frame`]. `None` if the body has no inertia or its tensor is not
    /// finite.
    pub fn ellipsoid(&self, figure: &Figure, body: usize) -> Option<Ellipsoid> {
        let [mass, xx, yy, zz, xy, xz, yz] = *figure.inertias.get(body)?;
        let has_mass = mass > 0.0;
        let mass = if has_mass { mass } else { 1.0 };
        let unit = [Vector3::x(), Vector3::y(), Vector3::z()];
        let (axes, lengths) = match self.model.bodies.get(body)?.inertia.as_ref()? {
            // the radius of gyration
            Inertia::Axial(_) => (unit, [(zz / mass).sqrt(), (zz / mass).sqrt(), 0.0]),
            Inertia::OfShaft { axis, .. } => {
                let radius = ([xx, yy, zz][*axis] / mass).sqrt();
                (unit, std::array::from_fn(|k| if k == *axis { 0.0 } else { radius }))
            }
            Inertia::Tensor { .. } => {
                let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
                if !tensor.iter().all(|entry| entry.is_finite()) {
                    return None;
                }
                let SymmetricEigen { eigenvalues, eigenvectors } = SymmetricEigen::new(tensor);
                let is_diagonal = [xy, xz, yz].iter().all(|entry| *entry == 0.0);
                let (moments, axes) = match is_diagonal {
                    true => (Vector3::new(xx, yy, zz), unit),
                    false => (eigenvalues, std::array::from_fn(|k| eigenvectors.column(k).into_owned())),
                };
                // the mean square of the distance along each axis: a²/5 for an ellipsoid, a²/4 for a thin elliptic plate
                let squares: [f64; 3] = std::array::from_fn(|k| (0.5 * moments.sum() - moments[k]).max(0.0) / mass);
                let largest = squares.iter().copied().fold(0.0, f64::max);
                let is_plate = squares.iter().any(|square| *square <= FLAT * FLAT * largest);
                (axes, squares.map(|square| if is_plate { 2.0 * square.sqrt() } else { (5.0 * square).sqrt() }))
            }
        };
        let longest = lengths.iter().copied().fold(0.0, f64::max);
        if !(longest > 0.0 && longest.is_finite()) {
            return None;
        }
        let lengths = lengths.map(|length| if length <= FLAT * longest { 0.0 } else { length });
        Some(Ellipsoid { axes, lengths, has_mass })
    }
}
