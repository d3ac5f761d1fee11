//! From where a system is seen: across the plane in which it moves, else from the side and a little from above.

use super::parts::Vector;
use ::scenes::geometry::{Figure, Geometry};
use charts::View;

/// Degrees from the first horizontal axis, and above the horizon.
const AZIMUTH: f64 = -58.0;
const HEIGHT: f64 = 22.0;

/// The view that is asked for, or the usual one.
pub fn view(geometry: &Geometry, figures: &[Figure], towards: Option<Vector>) -> View {
    let weight = figures.first().and_then(|figure| unit(figure.gravity)).map(|fall| fall.map(|part| -part));
    if let Some(towards) = towards {
        return View { towards, up: weight.unwrap_or([0.0, 0.0, 1.0]) };
    }
    let Some(normal) = geometry.plane else {
        let up = weight.unwrap_or([0.0, 0.0, 1.0]);
        let [first, second] = horizontal(up);
        let ((sin_a, cos_a), (sin_h, cos_h)) = (AZIMUTH.to_radians().sin_cos(), HEIGHT.to_radians().sin_cos());
        let towards = |k: usize| cos_h * (cos_a * first[k] + sin_a * second[k]) + sin_h * up[k];
        return View { towards: std::array::from_fn(towards), up };
    };
    let across = |direction: &Vector| dot(*direction, normal).abs() < 0.1;
    let upright = if normal[2].abs() > 0.9 { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
    let up = weight.filter(across).unwrap_or(upright);
    // from the side from which the first axis points to the right
    let right = cross(up, normal);
    let first = [right[0], right[1], right[2]].into_iter().find(|part| part.abs() > 0.1).unwrap_or(1.0);
    View { towards: normal.map(|part| part * first.signum()), up }
}

/// Two axes that make with the upright one a right-handed frame, near those of the ground.
fn horizontal(up: Vector) -> [Vector; 2] {
    let near = if up[0].abs() < 0.8 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let share = dot(near, up);
    let first = unit(std::array::from_fn(|k| near[k] - share * up[k])).unwrap_or(near);
    [first, cross(up, first)]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(direction: Vector) -> Option<Vector> {
    let length = dot(direction, direction).sqrt();
    (length > 0.0 && length.is_finite()).then(|| direction.map(|part| part / length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_horizontal_axes_and_the_upright_one_are_right_handed() {
        for up in [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]] {
            let [first, second] = horizontal(up);
            assert!(dot(cross(first, second), up) > 0.999 && dot(first, up).abs() < 1e-12, "{up:?}");
        }
    }
}
