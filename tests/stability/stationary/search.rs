//! An independent search: Newton's method on the equations of motion, in `f64`, from many initial points on the sphere.

use dalembert_derivations::systems::gyrostat::{Gyrostat, MotionInstant};
use field::Tangent;
use nalgebra::{Matrix3, Vector3};

/// The number of initial points, on a spiral that covers the sphere uniformly.
const STARTS: usize = 120;

/// The directions for which the carrier's equations of motion hold with w = w0 v and the given relative speed of the
/// rotor.
pub fn search(g: &Gyrostat<f64>, w0: f64, rotor_speed: f64) -> Vec<Vector3<f64>> {
    let mut found: Vec<Vector3<f64>> = Vec::new();
    for k in 0..STARTS {
        let height = 1.0 - 2.0 * (k as f64 + 0.5) / STARTS as f64;
        let turn = 2.399_963 * k as f64;
        let flat = (1.0 - height * height).sqrt();
        let start = Vector3::new(flat * turn.cos(), flat * turn.sin(), height);
        if let Some(v) = newton(g, w0, rotor_speed, start)
            && found.iter().all(|known| (known - v).norm() > 1e-7)
        {
            found.push(v);
        }
    }
    found
}

/// The residual of the theorem of angular momentum, and its derivatives with respect to v.
fn residual(g: &Gyrostat<f64>, w0: f64, rotor_speed: f64, v: Vector3<f64>) -> (Vector3<f64>, Matrix3<f64>) {
    let mut value = Vector3::zeros();
    let mut slopes = Matrix3::zeros();
    for j in 0..3 {
        let moving = Vector3::from_fn(|i, _| Tangent::moving(v[i], if i == j { 1.0 } else { 0.0 }));
        let zero = Tangent::fixed(0.0);
        let motion = MotionInstant {
            angular_velocity: moving * Tangent::fixed(w0),
            vertical: moving,
            rotor_speed: Tangent::fixed(rotor_speed),
            angular_acceleration: Vector3::repeat(zero),
            rotor_acceleration: zero,
            torque: zero,
        };
        let [x, y, z, _] = g.by_momentum(&motion);
        value = Vector3::new(x.value, y.value, z.value);
        slopes.set_column(j, &Vector3::new(x.slope, y.slope, z.slope));
    }
    (value, slopes)
}

fn newton(g: &Gyrostat<f64>, w0: f64, rotor_speed: f64, mut v: Vector3<f64>) -> Option<Vector3<f64>> {
    for _ in 0..60 {
        let (f, slopes) = residual(g, w0, rotor_speed, v);
        // f is orthogonal to v, and so must be the steps: (J + f v^T + v v^T size) step = -f on the tangent plane
        let a = v.cross(&Vector3::ith(v.iamin(), 1.0)).normalize();
        let b = v.cross(&a);
        let matrix = nalgebra::Matrix2::new(
            a.dot(&(slopes * a)),
            a.dot(&(slopes * b)),
            b.dot(&(slopes * a)),
            b.dot(&(slopes * b)),
        );
        let step = matrix.try_inverse()? * nalgebra::Vector2::new(-a.dot(&f), -b.dot(&f));
        let length = step.norm();
        let step = if length > 0.3 { step * (0.3 / length) } else { step };
        v = (v + a * step.x + b * step.y).normalize();
        if length < 1e-13 {
            return Some(v);
        }
    }
    None
}
