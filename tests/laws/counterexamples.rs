//! The counterexamples to refuted claims of the ledger, checked independently of the paper: each is a gyrostat whose
//! bodies can exist, and the theorem of angular momentum for the mass points decides whether it rotates about the
//! vertical.

use crate::physical::{MassPoint, inertia, rounded, total_mass};
use dalembert_derivations::papers::konosevich2022::gyrostats::{self, Example};
use field::{Rational, Scalar};
use mechanics::rotation::determinant;
use nalgebra::Vector3;
use num_traits::Zero;

type Vector = Vector3<Rational>;

/// The coefficients of the residual torque w0^2 G + w0 u + n, from three values.
fn coefficients(example: &Example) -> [Vector; 3] {
    let at = |w0: i64| example.residual_torques(Rational::int(w0));
    let (rest, plus, minus) = (at(0), at(1), at(-1));
    let half = Rational::new(1, 2);
    [(plus + minus) * half - rest, (plus - minus) * half, rest]
}

/// Whether the rotation with the example's own angular velocity is a motion, by the theorem of angular momentum and by
/// Appell's equations.
fn is_motion(example: &Example) -> bool {
    let w0 = example.angular_velocity.expect("the example has an angular velocity");
    let motion = example.rotation(w0);
    let residual = example.gyrostat.by_momentum(&motion);
    assert_eq!(residual, example.gyrostat.by_appell(&motion), "{}", example.name);
    residual.iter().all(Rational::is_zero)
}

#[test]
fn every_example_is_made_of_bodies_that_exist() {
    let examples = gyrostats::all();
    assert!(examples.len() >= 9);
    for example in examples {
        assert_eq!(rounded(&example.gyrostat).admissible(), Ok(()), "{}", example.name);
        let one = Rational::int(1);
        assert_eq!(example.vertical.dot(&example.vertical), one, "{}", example.name);
        assert_eq!(example.direction.dot(&example.direction), one, "{}", example.name);
        assert_eq!(example.gyrostat.rotor.axis.dot(&example.gyrostat.rotor.axis), one, "{}", example.name);
        assert_eq!(example.gyrostat.weight(), example.direction * example.gamma, "{}", example.name);
    }
}

#[test]
fn the_missing_moments_are_of_second_degree_in_the_angular_velocity() {
    for example in gyrostats::all() {
        let [second, first, rest] = coefficients(&example);
        for w0 in [Rational::int(2), Rational::new(-7, 3)] {
            let expected = second * (w0 * w0) + first * w0 + rest;
            assert_eq!(example.residual_torques(w0), expected, "{}", example.name);
        }
    }
}

#[test]
fn the_rotations_across_and_of_opposite_sign_are_motions() {
    assert!(is_motion(&gyrostats::opposite_sign()));
    assert!(is_motion(&gyrostats::across()));
}

#[test]
fn with_the_printed_sign_of_statement_3d_the_rotation_is_no_motion() {
    let example = gyrostats::opposite_sign();
    let printed = Example { angular_velocity: example.angular_velocity.map(|w0| -w0), ..example };
    assert!(!is_motion(&printed));
}

#[test]
fn the_rotations_along_in_a_plane_and_by_two_of_three_relations_are_no_motions() {
    for example in [gyrostats::along(), gyrostats::plane(), gyrostats::two_of_three()] {
        assert!(!is_motion(&example), "{}", example.name);
    }
}

#[test]
fn by_two_of_three_relations_the_third_moment_alone_is_missing() {
    let example = gyrostats::two_of_three();
    let missing = example.residual_torques(example.angular_velocity.expect("it has one"));
    assert!(missing.x.is_zero() && missing.y.is_zero() && !missing.z.is_zero(), "{missing}");
}

/// In these examples the vertical is a principal direction, and the coefficient of w0^2 is zero: w0 u + n = 0 with w0
/// != 0 requires that n is parallel to u, and u = 0 if n = 0.
#[test]
fn where_no_angular_velocity_is_named_none_but_zero_makes_a_motion() {
    let examples: Vec<Example> = gyrostats::all().into_iter().filter(|e| e.angular_velocity.is_none()).collect();
    assert_eq!(examples.len(), 4);
    for example in examples {
        let [second, first, rest] = coefficients(&example);
        assert!(second.is_zero(), "{}", example.name);
        let excluded = if rest.is_zero() { !first.is_zero() } else { !first.cross(&rest).is_zero() };
        assert!(excluded, "{}: w0 {first} + {rest}", example.name);
    }
}

/// Simpson's rule is exact for the moments of a uniform rod: three mass points have the same moments of mass.
#[test]
fn the_rod_of_section_5_has_d_zero_from_its_masses() {
    let rod = gyrostats::rod();
    let points = [(1, 0), (4, 1), (1, 2)].map(|(sixths, halves)| MassPoint {
        mass: rod.carrier.mass * Rational::new(sixths, 6),
        place: Vector::x() * Rational::new(halves, 2),
    });
    assert_eq!(total_mass(&points), rod.carrier.mass);
    assert_eq!(inertia(&points), rod.carrier.inertia);
    assert!(determinant(&rod.reduced_tensor()).is_zero());
    assert!(!determinant(&rod.full_tensor()).is_zero());
    let told = rounded(&rod).admissible().expect_err("the motion is not determined");
    assert!(told.len() == 1 && told[0].to_string().contains("D > 0 is broken"), "{told:?}");
}
