//! The four routes to the gyrostat's equations of motion agree, and the solved forms satisfy them.

use derivations::systems::gyrostat::forms::Form;
use derivations::systems::gyrostat::{Carrier, Gyrostat, Motion, Rotor};
use mechanics::rotation::{euler, euler_forms, vertical};
use nalgebra::{Matrix3, Vector3};

fn specimen() -> Gyrostat<f64> {
    Gyrostat {
        carrier: Carrier {
            mass: 1.5,
            centre: Vector3::new(0.01, -0.02, 0.05),
            inertia: Matrix3::new(0.02, 0.001, -0.002, 0.001, 0.03, 0.0005, -0.002, 0.0005, 0.025),
        },
        rotor: Rotor {
            mass: 0.4,
            centre: Vector3::new(0.0, 0.03, 0.04),
            axis: Vector3::new(2.0, -1.0, 2.0) / 3.0,
            axial: 3e-4,
            transverse: 2e-4,
        },
        gravity: 9.81,
    }
}

#[test]
fn four_routes_give_the_same_equations() {
    let g = specimen();
    let (angles, rates, accelerations) = ([0.3, 0.9, -1.1, 0.4], [1.0, -2.0, 0.7, 100.0], [3.0, 0.2, -0.5, 20.0]);
    let turning = mechanics::differentiate::along([angles[0], angles[1], angles[2]], [rates[0], rates[1], rates[2]]);
    let forms = euler_forms(turning);
    let w_moving = forms
        * Vector3::from(mechanics::differentiate::along(
            [rates[0], rates[1], rates[2]],
            [accelerations[0], accelerations[1], accelerations[2]],
        ));
    let motion = Motion {
        angular_velocity: w_moving.map(|x| x.value),
        vertical: vertical(&euler([angles[0], angles[1], angles[2]])),
        rotor_speed: rates[3],
        angular_acceleration: w_moving.map(|x| x.slope),
        rotor_acceleration: accelerations[3],
        moment: 0.37,
    };
    let momentum = g.by_momentum(&motion);
    let close = |a: [f64; 4], b: [f64; 4]| a.iter().zip(b).all(|(x, y)| (x - y).abs() < 1e-12);
    assert!(close(momentum, g.by_appell(&motion)));
    assert!(close(momentum, g.by_hamel(angles, &motion)));
    let w = forms.map(|x| x.value).transpose() * Vector3::new(momentum[0], momentum[1], momentum[2]);
    assert!(close([w.x, w.y, w.z, momentum[3]], g.by_lagrange(angles, rates, accelerations, 0.37)));
}

#[test]
fn both_forms_solve_the_equations() {
    let g = specimen();
    let (w, v, rotor_speed, moment) = (Vector3::new(1.0, -2.0, 0.5), Vector3::new(0.6, 0.0, 0.8), 120.0, 0.2);
    let (first, axes) = g.first_form();
    let back = axes.transpose();
    let check = |axes: Matrix3<f64>, (a, f): (Vector3<f64>, f64)| {
        let motion = Motion {
            angular_velocity: w,
            vertical: v,
            rotor_speed,
            moment,
            angular_acceleration: axes * a,
            rotor_acceleration: f,
        };
        assert!(g.by_momentum(&motion).iter().all(|x| x.abs() < 1e-10), "{:?}", g.by_momentum(&motion));
    };
    check(axes, first.accelerations(back * w, back * v, rotor_speed, moment));
    let (second, axes) = g.second_form();
    let back = axes.transpose();
    check(axes, second.accelerations(back * w, back * v, rotor_speed, moment));
}
