//! The default view of a sketch: normal to the plane of a plane motion, otherwise from the side and slightly from above.

use ::scenes::geometry::{Figure, Geometry};
use charts::View;
use nalgebra::Vector3;

/// The azimuth of the view from the first horizontal axis, in degrees; [`HEIGHT`] is its elevation above the horizon.
const AZIMUTH: f64 = -58.0;
const HEIGHT: f64 = 22.0;

/// The requested view, or the default view of the system.
pub fn view(geometry: &Geometry, figures: &[Figure], towards: Option<[f64; 3]>) -> View {
    let weight = figures.first().and_then(|figure| figure.gravity.try_normalize(0.0)).map(|fall| -fall);
    if let Some(towards) = towards {
        return View { towards, up: weight.unwrap_or_else(Vector3::z).into() };
    }
    let Some(normal) = geometry.plane else {
        let up = weight.unwrap_or_else(Vector3::z);
        let [first, second] = horizontal(up);
        let ((sin_a, cos_a), (sin_h, cos_h)) = (AZIMUTH.to_radians().sin_cos(), HEIGHT.to_radians().sin_cos());
        let towards = cos_h * (cos_a * first + sin_a * second) + sin_h * up;
        return View { towards: towards.into(), up: up.into() };
    };
    let across = |direction: &Vector3<f64>| direction.dot(&normal).abs() < 0.1;
    let upright = if normal.z.abs() > 0.9 { Vector3::y() } else { Vector3::z() };
    let up = weight.filter(across).unwrap_or(upright);
    // from the side on which the first axis of the plane points to the right
    let right = up.cross(&normal);
    let first = right.iter().copied().find(|part| part.abs() > 0.1).unwrap_or(1.0);
    View { towards: (first.signum() * normal).into(), up: up.into() }
}

/// Two horizontal unit vectors, close to axes of the ground, that form a right-handed frame with `up`.
fn horizontal(up: Vector3<f64>) -> [Vector3<f64>; 2] {
    let near = if up.x.abs() < 0.8 { Vector3::x() } else { Vector3::y() };
    let first = (near - near.dot(&up) * up).normalize();
    [first, up.cross(&first)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_horizontal_axes_and_the_upright_one_are_right_handed() {
        for up in [Vector3::z(), Vector3::y(), -Vector3::z(), Vector3::x()] {
            let [first, second] = horizontal(up);
            assert!(first.cross(&second).dot(&up) > 0.999 && first.dot(&up).abs() < 1e-12, "{up:?}");
        }
    }
}
