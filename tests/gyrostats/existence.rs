//! Data of bodies that can exist are accepted; if a single condition of existence is violated, the error names it with
//! its value.

use crate::physical::{MassPoint, bodies, fixed, gyrostat, inertia, rounded, total_mass};
use dalembert_derivations::systems::gyrostat::Gyrostat;
use dalembert_derivations::systems::gyrostat::admissible::Inadmissible;
use dalembert_derivations::systems::gyrostat::tensors::Principal;
use field::Rational;
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;
use proptest::prelude::*;

/// The single violated condition.
fn only(g: &Gyrostat<f64>) -> Result<Inadmissible, TestCaseError> {
    match g.admissible() {
        Err(broken) if broken.len() == 1 => Ok(broken[0].clone()),
        other => Err(TestCaseError::fail(format!("one broken condition was expected, not {other:?}"))),
    }
}

macro_rules! broken {
    ($g:expr, $condition:pat $(if $when:expr)?) => {{
        let only = only($g)?;
        prop_assert!(matches!(only, $condition $(if $when)?), "{only}");
    }};
}

/// The carrier's tensor with its principal moments replaced.
fn with_moments(g: &Gyrostat<f64>, change: impl Fn(Vector3<f64>) -> Vector3<f64>) -> Gyrostat<f64> {
    let mut g = *g;
    let Principal { moments, axes } = Principal::of(&g.carrier.inertia);
    let tensor = axes * Matrix3::from_diagonal(&change(moments)) * axes.transpose();
    g.carrier.inertia = (tensor + tensor.transpose()) / 2.0;
    g
}

proptest! {
    #![proptest_config(fixed(128))]

    #[test]
    fn every_gyrostat_of_mass_points_is_accepted(g in gyrostat()) {
        prop_assert_eq!(rounded(&g).admissible(), Ok(()));
    }

    /// Plates have J1 = J2 + J3, and single points no inertia about one axis: rounding must not turn these equalities
    /// into violations.
    #[test]
    fn plates_rods_and_single_points_are_accepted(bodies in bodies(), points in 1..7usize, flat in 0..3usize) {
        let mut g = bodies.gyrostat();
        let mut carrier: Vec<MassPoint> = bodies.carrier.into_iter().take(points).collect();
        carrier.iter_mut().for_each(|point| point.place[flat] = Rational::zero());
        g.carrier.mass = total_mass(&carrier);
        g.carrier.inertia = inertia(&carrier);
        g.carrier.centre = carrier.iter().map(|p| p.place * p.mass).sum::<Vector3<Rational>>() / g.carrier.mass;
        prop_assert_eq!(rounded(&g).admissible(), Ok(()));
    }

    #[test]
    fn an_indefinite_tensor_is_rejected(g in gyrostat(), excess in 0.01..2.0f64) {
        broken!(&with_moments(&rounded(&g), |m| Vector3::new(-excess * m[2], m[1], m[2])),
            Inadmissible::Indefinite { moment } if moment < 0.0);
    }

    #[test]
    fn a_tensor_that_breaks_the_triangle_inequality_about_o_is_rejected(g in gyrostat(), excess in 1e-9..1.0f64) {
        broken!(&with_moments(&rounded(&g), |m| Vector3::new(m[0], m[1], (m[0] + m[1]) * (1.0 + excess))),
            Inadmissible::Triangle { about: "O", largest, sum_of_others } if largest > sum_of_others);
    }

    #[test]
    fn a_centre_too_far_out_for_the_tensor_is_rejected(g in gyrostat(), direction in 0..3usize, excess in 0.01..1.0f64) {
        let mut g = rounded(&g);
        // m c^2 greater than the whole integral of r^2 dm
        let whole = g.carrier.inertia.trace() / 2.0;
        g.carrier.centre = Vector3::ith(direction, ((1.0 + excess) * whole / g.carrier.mass).sqrt());
        broken!(&g, Inadmissible::Triangle { about: "its centre of mass", .. });
    }

    /// A rod from O along the rotor's axis, with the rotor's centre on it: bodies that can exist, but with D = 0.
    #[test]
    fn a_carrier_without_inertia_about_the_rotors_axis_is_rejected(g in gyrostat(), length in 0.1..2.0f64) {
        let mut g = rounded(&g);
        let l = g.rotor.axis;
        g.rotor.centre = l * length;
        g.carrier.centre = l * length / 2.0;
        g.carrier.inertia = (Matrix3::identity() - l * l.transpose()) * (g.carrier.mass * length * length / 3.0);
        broken!(&g, Inadmissible::Undetermined { moment } if moment.abs() < 1e-14 * g.full_tensor().norm());
    }

    #[test]
    fn a_rotor_flatter_than_a_disc_is_rejected(g in gyrostat(), excess in 1e-9..1.0f64) {
        let mut g = rounded(&g);
        g.rotor.axial = 2.0 * g.rotor.transverse * (1.0 + excess);
        broken!(&g, Inadmissible::RotorTriangle { axial, twice_transverse } if axial > twice_transverse);
    }

    #[test]
    fn an_axis_that_is_no_unit_vector_is_rejected(g in gyrostat(), excess in prop_oneof![-1.0..-1e-9f64, 1e-9..1.0f64]) {
        let mut g = rounded(&g);
        g.rotor.axis *= 1.0 + excess;
        broken!(&g, Inadmissible::AxisNotUnit { length } if f64::abs(length - 1.0 - excess) < 1e-14);
    }

    #[test]
    fn a_tensor_that_is_not_symmetric_is_rejected(g in gyrostat(), pair in 0..3usize, excess in 1e-9..1.0f64) {
        let mut g = rounded(&g);
        let (i, j) = [(0, 1), (0, 2), (1, 2)][pair];
        g.carrier.inertia[(i, j)] += excess * g.carrier.inertia.norm();
        broken!(&g, Inadmissible::NotSymmetric { row, column, .. } if (row, column) == (i + 1, j + 1));
    }

    #[test]
    fn what_must_be_positive_is(g in gyrostat(), which in 0..4usize, size in 0.0..9.0f64) {
        let mut g = rounded(&g);
        let (data, name) = scalar(&mut g, which);
        *data = -size;
        let told = g.admissible().expect_err("it is not");
        prop_assert!(told.contains(&Inadmissible::NotPositive { quantity: name, value: -size }), "{told:?}");
    }

    #[test]
    fn what_is_no_number_is_rejected_wherever_it_stands(
        g in gyrostat(), place in 0..23usize, value in prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(f64::NEG_INFINITY)]
    ) {
        let mut g = rounded(&g);
        let name = match place {
            0..4 => { let (data, name) = scalar(&mut g, place); *data = value; name }
            4 => { g.gravity = value; "g" }
            5..8 => { g.carrier.centre[place - 5] = value; "c0" }
            8..11 => { g.rotor.centre[place - 8] = value; "h" }
            11..14 => { g.rotor.axis[place - 11] = value; "l" }
            _ => { g.carrier.inertia[place - 14] = value; "A0" }
        };
        let told = only(&g)?.to_string();
        prop_assert!(told.starts_with(&format!("{name} is beyond the range of numbers")), "{told}");
    }

    #[test]
    fn everything_that_is_wrong_is_told(g in gyrostat()) {
        let mut g = rounded(&g);
        (g.rotor.mass, g.gravity, g.rotor.axis) = (-1.0, -9.81, Vector3::zeros());
        let told = g.admissible().expect_err("three conditions are broken");
        prop_assert_eq!(told.len(), 3, "{:?}", told);
    }
}

fn scalar(g: &mut Gyrostat<f64>, which: usize) -> (&mut f64, &'static str) {
    match which {
        0 => (&mut g.carrier.mass, "m0"),
        1 => (&mut g.rotor.mass, "m'"),
        2 => (&mut g.rotor.axial, "A'"),
        _ => (&mut g.rotor.transverse, "B'"),
    }
}

#[test]
fn messages_name_the_inequality_and_its_value() {
    use Inadmissible::*;
    let says = |condition: Inadmissible, parts: &[&str]| {
        let text = condition.to_string();
        assert!(parts.iter().all(|part| text.contains(part)), "{text}");
    };
    says(NotPositive { quantity: "m'", value: -2.5 }, &["m' > 0", "-2.5"]);
    says(NegativeGravity { value: -9.81 }, &["g >= 0", "-9.81", "downwards"]);
    says(AxisNotUnit { length: 1.25 }, &["|l| = 1", "1.25"]);
    says(NotSymmetric { row: 1, column: 3, difference: 0.5 }, &["A0[1][3] = A0[3][1]", "5e-1"]);
    says(Indefinite { moment: -0.125 }, &["A0 positive", "-1.25e-1 kg m^2"]);
    says(Triangle { about: "O", largest: 5.0, sum_of_others: 3.0 }, &["J1 <= J2 + J3", "about O", "5e0 > 3e0 kg m^2"]);
    says(Undetermined { moment: 0.0 }, &["D > 0", "0e0 kg m^2"]);
    says(RotorTriangle { axial: 0.5, twice_transverse: 0.25 }, &["A' <= 2 B'", "5e-1 > 2.5e-1 kg m^2"]);
    says(NotFinite { quantity: "h", value: f64::NAN }, &["h is beyond", "finite"]);
}
