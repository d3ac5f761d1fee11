//! Marked directions on the sphere: named ones, and principal axes about which no permanent rotation exists.

use charts::Mark;
use nalgebra::Vector3;
use systems::gyrostat::stationary::Stationary;

/// Torques below this fraction of the larger one are rounding errors.
const ROUNDING: f64 = 1e-9;

/// The distinguished directions of the gyrostat.
pub(super) fn named(conditions: &Stationary<f64>) -> [Mark; 3] {
    let mark = |name: &str, at: Vector3<f64>, note: &str| Mark {
        name: name.into(),
        at: at.into(),
        note: note.into(),
        hollow: false,
    };
    let down = conditions.weight.normalize();
    [
        mark("l, rotor", conditions.axis, "the rotor's axis"),
        mark("e, hanging", down, "the centre of mass below the fixed point, at rest"),
        mark("\u{2212}e, upright", -down, "the centre of mass above the fixed point, at rest"),
    ]
}

/// Principal directions about which no angular velocity is a steady motion. They satisfy the equation of the cone for all data.
pub(super) fn idle(conditions: &Stationary<f64>) -> Vec<Mark> {
    let directions = (0..3).flat_map(|i| [1.0, -1.0].map(|sign| Vector3::ith(i, sign)));
    let idle = directions.filter(|direction| !turns_about(conditions, *direction));
    idle.map(|at| Mark {
        at: at.into(),
        note: "principal direction: on the line, but no rotation about it".into(),
        hollow: true,
        ..Mark::default()
    })
    .collect()
}

/// Whether a rotation about a principal direction with some angular velocity w0 is a steady motion. Since A* v × v = 0, the residual torque is
/// b + a w0 with vectors a and b, so that a and b must be parallel.
fn turns_about(conditions: &Stationary<f64>, direction: Vector3<f64>) -> bool {
    let still = conditions.residual_torque(direction, 0.0);
    let slope = conditions.residual_torque(direction, 1.0) - still;
    let (a, b) = (slope.norm(), still.norm());
    if b <= ROUNDING * conditions.weight.norm() {
        return true;
    }
    a > ROUNDING * conditions.spin.abs() && slope.cross(&still).norm() <= ROUNDING * a * b
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gyrostat(axis: [f64; 3], weight: [f64; 3]) -> Stationary<f64> {
        Stationary { moments: Vector3::new(3.0, 4.0, 5.0), axis: axis.into(), spin: 2.0, weight: weight.into() }
    }

    #[test]
    fn principal_directions_are_rings_unless_some_rotation_about_them_is_a_motion() {
        assert_eq!(idle(&gyrostat([0.6, 0.0, 0.8], [0.0, 3.0, 1.0])).len(), 6);
        // rotor and weight in one principal plane: a rotation about each of its two axes, none about the third
        assert_eq!(idle(&gyrostat([0.6, 0.8, 0.0], [1.0, 3.0, 0.0])).len(), 2);
        // a gyrostat whose centre of mass is on a principal axis can at least hang at rest along it
        assert_eq!(idle(&gyrostat([0.6, 0.0, 0.8], [1.0, 0.0, 0.0])).len(), 2);
    }
}
