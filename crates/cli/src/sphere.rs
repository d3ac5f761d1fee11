//! The picture of the axes of permanent rotation on the unit sphere.

use charts::{Curve, CurvePoint, Mark, Sphere, significant};
use derivations::machines::{AnyMachine, Catalogued, ForMachine};
use derivations::scene::{Scene, System};
use derivations::systems::gyrostat::stationary::Stationary;
use nalgebra::Vector3;

/// Angular velocities beyond this multiple of the rotor's relative speed are left without colour: they grow without
/// bound where the denominator of the formula vanishes.
const FASTEST: f64 = 2.0;
/// Moments below this share of the larger one are rounding.
const ROUNDING: f64 = 1e-9;

/// One picture for each gyrostat and speed of its rotor: scenes that share these share the picture.
pub fn all<'a>(scenes: impl Iterator<Item = &'a Scene>) -> Vec<Sphere> {
    let mut found: Vec<(Case, Vec<&str>)> = Vec::new();
    for scene in scenes {
        let Some(case) = case(scene) else { continue };
        match found.iter_mut().find(|(known, _)| known.conditions == case.conditions) {
            Some((_, titles)) => titles.push(&scene.title),
            None => found.push((case, vec![&scene.title])),
        }
    }
    found.iter().map(|(case, titles)| sphere(case, titles)).collect()
}

/// Where a gyrostat may turn for ever, and what it is.
struct Case {
    conditions: Stationary<f64>,
    /// The rotor's relative speed, rad/s.
    speed: f64,
    /// D = det A / det A*
    singularity: f64,
}

/// `None` where there is no line to draw: no gyrostat, no weight, or a machine that does not prescribe the speed of its
/// field.
fn case(scene: &Scene) -> Option<Case> {
    let System::Gyrostat(bodies) = &scene.system else { return None };
    let speed = field_speed(&scene.machine)?;
    let derived = bodies.derived();
    let principal = derived.full;
    let own = bodies.in_axes(&principal.axes);
    let spin = own.rotor.axial * speed;
    let weight = own.weight();
    if spin == 0.0 || weight.norm() == 0.0 {
        return None;
    }
    let conditions = Stationary { moments: principal.moments, axis: own.rotor.axis, spin, weight };
    Some(Case { conditions, speed, singularity: derived.singularity })
}

fn sphere(case: &Case, titles: &[&str]) -> Sphere {
    let (conditions, speed) = (&case.conditions, case.speed);
    let coloured = |value: &f64| value.abs() <= FASTEST * speed.abs();
    let curves = conditions.spherical_line().into_iter().map(|piece| Curve {
        name: format!("faster than {} rad/s, without bound", significant(FASTEST * speed.abs(), 3)),
        points: piece
            .into_iter()
            .map(|point| CurvePoint { at: point.direction.into(), value: point.speed.filter(coloured) })
            .collect(),
    });
    let marks = idle(conditions).into_iter().chain(named(conditions)).collect();
    Sphere {
        title: format!("Axes of permanent rotation, the rotor at {} rad/s", significant(speed, 4)),
        description: "Each point of the line is a direction in the carrier, in the principal axes of $A^*$, that can \
                      point straight down while the carrier turns about it for ever and the rotor keeps its relative \
                      speed: the spherical line (7.11). The colour is the angular velocity $\\omega^0$ of (7.10), the \
                      only one that goes with the direction. At $e$ and $-e$ the carrier rests."
            .to_owned(),
        facts: facts(case),
        value: "angular velocity of the carrier, rad/s".to_owned(),
        axes: ["\u{3be}₁".into(), "\u{3be}₂".into(), "\u{3be}₃".into()],
        curves: curves.collect(),
        marks,
        view: (35.0, 25.0),
        note: format!("The gyrostat of: {}.", titles.join("; ")),
    }
}

/// What carrier and rotor come to, in the principal axes of A*.
fn facts(case: &Case) -> Vec<(String, String)> {
    let Case { conditions, speed, singularity } = case;
    let numbers = |v: Vector3<f64>| v.iter().map(|x| significant(*x, 3)).collect::<Vec<_>>().join(", ");
    let weight = conditions.weight;
    let facts = [
        ("principal moments of $A^*$", format!("{} kg m²", numbers(conditions.moments))),
        ("rotor's axis $l$", format!("({})", numbers(conditions.axis))),
        ("direction $e$ of the centre of mass", format!("({})", numbers(weight.normalize()))),
        ("$\\Gamma$, weight times distance", format!("{} N m", significant(weight.norm(), 3))),
        ("$A'\\Omega$, the rotor's own momentum", format!("{} N m s", significant(conditions.spin, 3))),
        ("$\\Omega$, its relative speed", format!("{} rad/s", significant(*speed, 4))),
        ("$D = \\det A / \\det A^*$", significant(*singularity, 4)),
    ];
    facts.map(|(name, value)| (name.to_owned(), value)).into()
}

/// The directions that the gyrostat itself has.
fn named(conditions: &Stationary<f64>) -> [Mark; 3] {
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

/// The principal directions, which lie on the line whatever the data, where no angular velocity makes a motion.
fn idle(conditions: &Stationary<f64>) -> Vec<Mark> {
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

/// Whether some angular velocity about a principal direction is a motion. The missing moment there is b + a w0, because
/// A* v x v vanishes: so a and b must be parallel.
fn turns_about(conditions: &Stationary<f64>, direction: Vector3<f64>) -> bool {
    let still = conditions.missing_moment(direction, 0.0);
    let slope = conditions.missing_moment(direction, 1.0) - still;
    let (a, b) = (slope.norm(), still.norm());
    if b <= ROUNDING * conditions.weight.norm() {
        return true;
    }
    a > ROUNDING * conditions.spin.abs() && slope.cross(&still).norm() <= ROUNDING * a * b
}

/// The speed that a motor keeps in step, if it is one that does.
fn field_speed(machine: &AnyMachine) -> Option<f64> {
    struct Speed;
    impl ForMachine for Speed {
        type Output = f64;
        fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> f64 {
            machine.frame_speed()
        }
    }
    Some(machine.clone().apply(Speed)).filter(|speed| *speed != 0.0)
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
        // rotor and weight in one principal plane: a rotation about each of its two axes, the rest along none
        assert_eq!(idle(&gyrostat([0.6, 0.8, 0.0], [1.0, 3.0, 0.0])).len(), 2);
        // hanging on a principal axis is a rest at least
        assert_eq!(idle(&gyrostat([0.6, 0.0, 0.8], [1.0, 0.0, 0.0])).len(), 2);
    }
}
