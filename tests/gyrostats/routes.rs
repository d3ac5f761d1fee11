//! Independent principles give the same motion, and both forms of the equations agree with it.

use crate::physical::machines::numbers;
use crate::physical::{fixed, gyrostat, motion, rounded, rounded_twice};
use dalembert_derivations::systems::gyrostat::forms::{FirstForm, Form, SecondForm};
use dalembert_derivations::systems::gyrostat::{Carrier, Gyrostat, MotionInstant, Rotor};
use field::{DoubleDouble, Rational, Scalar};
use mechanics::differentiate::along;
use mechanics::rotation::{euler, euler_forms, vertical};
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;
use proptest::prelude::*;

/// Euler's angles with the sine of the nutation angle away from zero, and the rotor's angle; their rates; their
/// accelerations.
fn orientation() -> impl Strategy<Value = [[DoubleDouble; 4]; 3]> {
    let rates = || [-3.0..3.0f64, -3.0..3.0, -3.0..3.0, -3.0..3.0];
    ([-3.0..3.0f64, 0.3..2.8, -3.0..3.0, -3.0..3.0], rates(), rates())
        .prop_map(|(angles, rates, accelerations)| [angles, rates, accelerations].map(|x| x.map(DoubleDouble::from)))
}

/// The motion in quasi-velocities, which refer to the body.
fn seen_from_the_body([angles, rates, accelerations]: [[DoubleDouble; 4]; 3]) -> MotionInstant<DoubleDouble> {
    let three = |[a, b, c, _]: [DoubleDouble; 4]| [a, b, c];
    let forms = euler_forms(along(three(angles), three(rates)));
    let w = forms * Vector3::from(along(three(rates), three(accelerations)));
    MotionInstant {
        angular_velocity: w.map(|x| x.value),
        vertical: vertical(&euler(three(angles))),
        rotor_speed: rates[3],
        angular_acceleration: w.map(|x| x.slope),
        rotor_acceleration: accelerations[3],
        torque: DoubleDouble::from(0.37),
    }
}

fn largest<S: Into<DoubleDouble>>(parts: impl IntoIterator<Item = S>) -> f64 {
    parts.into_iter().map(|x| x.into().hi().abs()).fold(0.0, f64::max)
}

/// The magnitude of the terms of the equations, N m.
fn size(g: &Gyrostat<f64>, m: &MotionInstant<f64>) -> f64 {
    let speed = 1.0 + m.angular_velocity.norm() + m.rotor_speed.abs();
    let rates = m.angular_acceleration.norm() + m.rotor_acceleration.abs();
    g.full_tensor().norm() * (speed * speed + rates) + g.weight().norm() + m.torque.abs()
}

fn approximate(m: &MotionInstant<DoubleDouble>) -> MotionInstant<f64> {
    let near = |x: DoubleDouble| x.hi();
    MotionInstant {
        angular_velocity: m.angular_velocity.map(near),
        vertical: m.vertical.map(near),
        rotor_speed: near(m.rotor_speed),
        angular_acceleration: m.angular_acceleration.map(near),
        rotor_acceleration: near(m.rotor_acceleration),
        torque: near(m.torque),
    }
}

proptest! {
    #![proptest_config(fixed(64))]

    #[test]
    fn the_theorem_of_angular_momentum_and_appells_equations_agree_exactly(g in gyrostat(), motion in motion()) {
        prop_assert_eq!(g.by_momentum(&motion), g.by_appell(&motion));
    }

    #[test]
    fn four_routes_agree_to_28_digits(g in gyrostat(), way in orientation()) {
        let (rough, g, motion) = (rounded(&g), rounded_twice(&g), seen_from_the_body(way));
        let [angles, rates, accelerations] = way;
        let momentum = g.by_momentum(&motion);
        let allowed = 1e-28 * size(&rough, &approximate(&motion)) / angles[1].hi().sin().powi(3);
        let off = |other: [DoubleDouble; 4]| largest((0..4).map(|i| momentum[i] - other[i]));
        prop_assert!(off(g.by_appell(&motion)) <= allowed);
        prop_assert!(off(g.by_hamel(angles, &motion)) <= allowed, "{:e} {allowed:e}", off(g.by_hamel(angles, &motion)));
        // in Lagrange's equations the torques are multiplied by the transpose of W, where w = W q'
        let lagrange = g.by_lagrange(angles, rates, accelerations, motion.torque);
        let forms: Matrix3<DoubleDouble> = euler_forms([angles[0], angles[1], angles[2]]);
        let seen = forms.transpose() * Vector3::new(momentum[0], momentum[1], momentum[2]);
        let gap = [seen.x - lagrange[0], seen.y - lagrange[1], seen.z - lagrange[2], momentum[3] - lagrange[3]];
        prop_assert!(largest(gap) <= allowed, "{:e} {allowed:e}", largest(gap));
    }

    #[test]
    fn both_forms_satisfy_the_momentum_equations(g in gyrostat(), sample in numbers()) {
        let g = rounded(&g);
        let state = sample.state(8);
        let (w, v) = (Vector3::new(state[0], state[1], state[2]), Vector3::new(state[3], state[4], state[5]));
        let (first, axes) = g.first_form();
        satisfies(&g, &first, &axes, [w, v], [state[6], state[7]])?;
        let (second, axes) = g.second_form();
        satisfies(&g, &second, &axes, [w, v], [state[6], state[7]])?;
    }

    #[test]
    fn both_forms_have_the_energy_and_the_momentum_of_the_bodies(g in gyrostat(), sample in numbers()) {
        let g = rounded(&g);
        let state = sample.state(7);
        let (w, v) = (Vector3::new(state[0], state[1], state[2]), Vector3::new(state[3], state[4], state[5]));
        let energy = g.kinetic_energy::<f64>(w, state[6]) + g.potential_energy::<f64>(v);
        let [momentum, _] = g.angular_momentum(w, state[6]);
        let (first, a) = g.first_form();
        let (second, b) = g.second_form();
        let allowed = 1e-13 * (g.full_tensor().norm() * (1.0 + w.norm() + state[6].abs()).powi(2) + g.weight().norm());
        for (form_energy, form_momentum) in [
            (first.energy(a.transpose() * w, a.transpose() * v, state[6]), a * first.momentum(a.transpose() * w, state[6])),
            (second.energy(b.transpose() * w, b.transpose() * v, state[6]), b * second.momentum(b.transpose() * w, state[6])),
        ] {
            prop_assert!((form_energy - energy).abs() <= allowed);
            prop_assert!((form_momentum - momentum).norm() <= allowed);
        }
    }

    #[test]
    fn in_principal_axes_both_forms_satisfy_the_equations_exactly(
        masses in [1..9i64, 1..9, 1..9], arm in [1..9i64, 1..9, 1..9], motion in motion(), weight in motion()
    ) {
        // a carrier of three pairs of points on the axes, and a rotor along the first axis: A and A* are both diagonal
        let g = exact(masses, arm, weight.vertical);
        let full = g.full_tensor();
        let second = SecondForm::new(full.diagonal(), g.rotor.axis, g.rotor.axial, g.weight());
        let first = FirstForm::new(g.reduced_tensor().diagonal(), g.rotor.axis, g.rotor.axial, g.weight());
        prop_assert_eq!(full, Matrix3::from_diagonal(&full.diagonal()));
        let (w, v) = (motion.angular_velocity, motion.vertical);
        let free = [
            first.accelerations(w, v, motion.rotor_speed, motion.torque),
            second.accelerations(w, v, motion.rotor_speed, motion.torque),
        ];
        for (angular_acceleration, rotor_acceleration) in free {
            let solved = MotionInstant { angular_acceleration, rotor_acceleration, ..motion };
            prop_assert_eq!(g.by_momentum(&solved), [Rational::zero(); 4]);
        }
        for (angular_acceleration, torque) in
            [first.prescribed(w, v, motion.rotor_speed), second.prescribed(w, v, motion.rotor_speed)]
        {
            let kept = MotionInstant { angular_acceleration, rotor_acceleration: Rational::zero(), torque, ..motion };
            prop_assert_eq!(g.by_momentum(&kept), [Rational::zero(); 4]);
        }
    }
}

fn satisfies(
    g: &Gyrostat<f64>,
    form: &impl Form<f64>,
    axes: &Matrix3<f64>,
    [w, v]: [Vector3<f64>; 2],
    [rotor_speed, torque]: [f64; 2],
) -> Result<(), TestCaseError> {
    let back = axes.transpose();
    let (free, rotor_acceleration) = form.accelerations(back * w, back * v, rotor_speed, torque);
    let (kept, reaction) = form.prescribed(back * w, back * v, rotor_speed);
    for (acceleration, rotor_acceleration, torque) in [(free, rotor_acceleration, torque), (kept, 0.0, reaction)] {
        let motion = MotionInstant {
            angular_velocity: w,
            vertical: v,
            rotor_speed,
            angular_acceleration: axes * acceleration,
            rotor_acceleration,
            torque,
        };
        let (off, allowed) = (largest(g.by_momentum(&motion)), 1e-13 * size(g, &motion));
        prop_assert!(off <= allowed, "{off:e} where rounding explains {allowed:e}");
    }
    Ok(())
}

/// Three pairs of points on the axes with this centre of mass, and a rotor along the first axis through O.
fn exact(masses: [i64; 3], arms: [i64; 3], centre: Vector3<Rational>) -> Gyrostat<Rational> {
    let second = Vector3::from_fn(|i, _| Rational::int(masses[i] * arms[i] * arms[i]));
    Gyrostat {
        carrier: Carrier {
            mass: Rational::int(masses.iter().sum()),
            centre,
            inertia: Matrix3::from_diagonal(&second.map(|s| second.sum() - s)),
        },
        rotor: Rotor {
            mass: Rational::int(2),
            centre: Vector3::zeros(),
            axis: Vector3::x(),
            axial: Rational::new(3, 2),
            transverse: Rational::int(1),
        },
        gravity: Rational::int(10),
    }
}
