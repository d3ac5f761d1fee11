//! The two tensors, their axes, and the determinant D.

use crate::physical::{axes, fixed, gyrostat, motion, rounded};
use dalembert_derivations::systems::gyrostat::tensors::Principal;
use field::Rational;
use mechanics::rotation::{determinant, inverse};
use nalgebra::Matrix3;
use num_traits::One;
use proptest::prelude::*;

fn positive(x: Rational) -> bool {
    x.sign() == Some(1)
}

fn is_rotation(axes: &Matrix3<f64>) -> bool {
    (axes.transpose() * axes - Matrix3::identity()).norm() < 1e-14 && (determinant(axes) - 1.0).abs() < 1e-14
}

proptest! {
    #![proptest_config(fixed(128))]

    #[test]
    fn the_full_tensor_exceeds_the_reduced_one_by_the_rotors_own_moment(g in gyrostat()) {
        let (l, axial) = (g.rotor.axis, g.rotor.axial);
        prop_assert_eq!(g.full_tensor() - g.reduced_tensor(), l * l.transpose() * axial);
        prop_assert_eq!(l.dot(&l), Rational::one());
    }

    /// Sherman and Morrison: (A + A' l l^T)^-1 = A^-1 - (A' / (1 + A' l.A^-1 l)) A^-1 l (A^-1 l)^T.
    #[test]
    fn sherman_and_morrisons_formula_joins_the_inverses(g in gyrostat()) {
        let (l, axial) = (g.rotor.axis, g.rotor.axial);
        let (reduced, full) = (inverse(&g.reduced_tensor()), inverse(&g.full_tensor()));
        let response = reduced * l;
        let growth = Rational::one() + axial * l.dot(&response);
        prop_assert_eq!(full, reduced - response * response.transpose() * (axial / growth));
    }

    #[test]
    fn d_is_the_quotient_of_the_determinants_and_lies_between_zero_and_one(g in gyrostat()) {
        let (l, axial) = (g.rotor.axis, g.rotor.axial);
        let d = determinant(&g.reduced_tensor()) / determinant(&g.full_tensor());
        prop_assert_eq!(d, Rational::one() - axial * l.dot(&(inverse(&g.full_tensor()) * l)));
        prop_assert_eq!(d * (Rational::one() + axial * l.dot(&(inverse(&g.reduced_tensor()) * l))), Rational::one());
        prop_assert!(positive(d) && positive(Rational::one() - d));
        prop_assert!((rounded(&g).derived().singularity - d.to_f64()).abs() < 1e-12);
    }

    #[test]
    fn d_lies_between_the_bounds_by_the_least_moment_and_by_the_moment_about_the_axis(g in gyrostat()) {
        let (l, axial) = (g.rotor.axis, g.rotor.axial);
        let d = determinant(&g.reduced_tensor()) / determinant(&g.full_tensor());
        let along = l.dot(&(g.reduced_tensor() * l));
        prop_assert!(!positive(d - along / (along + axial)));
        let least = rounded(&g).derived().reduced.moments[0];
        prop_assert!(d.to_f64() >= least / (least + axial.to_f64()) - 1e-13);
    }

    #[test]
    fn principal_axes_are_right_handed_and_reproduce_the_tensors(g in gyrostat()) {
        let g = rounded(&g);
        let derived = g.derived();
        for (tensor, principal) in [(g.reduced_tensor(), derived.reduced), (g.full_tensor(), derived.full)] {
            let Principal { moments, axes } = principal;
            prop_assert!(is_rotation(&axes), "{}", axes);
            prop_assert!((axes * Matrix3::from_diagonal(&moments) * axes.transpose() - tensor).norm() < 1e-14 * tensor.norm());
            prop_assert!(moments[0] <= moments[1] && moments[1] <= moments[2]);
        }
        prop_assert!((derived.reduced.axes * derived.rotation - derived.full.axes).norm() < 1e-14);
    }

    #[test]
    fn the_weight_is_gamma_along_e(g in gyrostat()) {
        let g = rounded(&g);
        let derived = g.derived();
        prop_assert!((derived.direction * derived.gamma - g.weight()).norm() <= 1e-13 * g.weight().norm());
        prop_assert!((derived.centre * g.mass() - g.first_moment()).norm() <= 1e-14 * g.first_moment().norm());
    }

    #[test]
    fn other_axes_and_back_are_the_same_data(g in gyrostat(), axes in axes()) {
        prop_assert_eq!(g.in_axes(&axes).in_axes(&axes.transpose()), g);
    }

    #[test]
    fn energies_and_residuals_do_not_depend_on_the_axes(g in gyrostat(), axes in axes(), motion in motion()) {
        let (turned, back) = (g.in_axes(&axes), axes.transpose());
        let seen = dalembert_derivations::systems::gyrostat::MotionInstant {
            angular_velocity: back * motion.angular_velocity,
            vertical: back * motion.vertical,
            angular_acceleration: back * motion.angular_acceleration,
            ..motion
        };
        prop_assert_eq!(
            turned.kinetic_energy::<Rational>(seen.angular_velocity, seen.rotor_speed),
            g.kinetic_energy::<Rational>(motion.angular_velocity, motion.rotor_speed)
        );
        let [x, y, z, axial] = g.by_momentum(&motion);
        let moments = back * nalgebra::Vector3::new(x, y, z);
        prop_assert_eq!(turned.by_momentum(&seen), [moments.x, moments.y, moments.z, axial]);
    }
}
