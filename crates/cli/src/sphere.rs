//! The picture of the axes of permanent rotation on the unit sphere.

use charts::{Curve, CurvePoint, Mark, Sphere};
use derivations::machines::{AnyMachine, Catalogued, ForMachine};
use derivations::scene::{Scene, System};
use derivations::systems::gyrostat::stationary::Stationary;
use nalgebra::Vector3;

/// Angular velocities beyond this multiple of the rotor's relative speed are left without colour: they grow without
/// bound where the denominator of the formula vanishes.
const FASTEST: f64 = 2.0;

/// The spherical line of a scene's gyrostat, `None` where there is none to draw: no gyrostat, no weight, or a machine
/// that does not prescribe the speed of its field.
pub fn of(id: &str, scene: &Scene) -> Option<Sphere> {
    let System::Gyrostat(bodies) = &scene.system else { return None };
    let speed = field_speed(&scene.machine)?;
    let principal = bodies.derived().full;
    let own = bodies.in_axes(&principal.axes);
    let spin = own.rotor.axial * speed;
    let weight = own.weight();
    if spin == 0.0 || weight.norm() == 0.0 {
        return None;
    }
    let conditions = Stationary { moments: principal.moments, axis: own.rotor.axis, spin, weight };
    let coloured = |value: &f64| value.abs() <= FASTEST * speed.abs();
    let curves = conditions.spherical_line().into_iter().map(|piece| Curve {
        name: "axes of rotation".into(),
        points: piece
            .into_iter()
            .map(|point| CurvePoint { at: point.direction.into(), value: point.speed.filter(coloured) })
            .collect(),
    });
    Some(Sphere {
        title: format!("Axes of permanent rotation: {}", scene.title),
        description: format!(
            "Where the vertical (downwards) may stand in the carrier, in the principal axes of $A^*$: the spherical line \
             (7.11), for the rotor's relative speed {speed} rad/s. Along it the angular velocity $\\omega^0$ by (7.10). The \
             principal axes lie on the line whatever the data, and carry no rotation unless statement 6 says so."
        ),
        value: "angular velocity, rad/s".into(),
        axes: ["ξ₁".into(), "ξ₂".into(), "ξ₃".into()],
        curves: curves.collect(),
        marks: marks(own.rotor.axis, weight),
        view: (35.0, 25.0),
        note: format!("Scene {id}; uncoloured where the angular velocity exceeds {FASTEST} times the rotor's."),
    })
}

fn marks(axis: Vector3<f64>, weight: Vector3<f64>) -> Vec<Mark> {
    let mark = |name: &str, at: Vector3<f64>, note: &str| Mark { name: name.into(), at: at.into(), note: note.into() };
    vec![
        mark("l", axis, "the rotor's axis"),
        mark("e", weight.normalize(), "towards the centre of mass: hanging rest"),
        mark("−e", -weight.normalize(), "inverted rest"),
    ]
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
