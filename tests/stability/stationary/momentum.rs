//! Motions with a given vertical component of angular momentum, compared with those with a given angular velocity;
//! folds compared with counts.

use crate::physical::{fixed, gyrostat};
use algebra::real::{Enclosure, Root};
use dalembert_derivations::studies::stationary::energies::{Energies, Kept};
use field::Rational;
use mechanics::steady_rotations::{Body, Shape};
use nalgebra::Vector3;
use proptest::prelude::*;

proptest! {
    #![proptest_config(fixed(60))]

    /// Each motion with a given w must be found again from its momentum.
    #[test]
    fn every_motion_is_found_again_by_its_momentum(bodies in gyrostat(), w in 1..60i64, speed in -900..900i64) {
        let (w, speed) = (Rational::new(w, 10), Rational::new(speed, 10));
        let energies = Energies::of(&bodies);
        let (tensor, share) = energies.quadratic(Kept::RelativeSpeed);
        let value = Root::rational(speed).unwrap();
        let body = Body::new(&tensor, &share, &value, &energies.weight).unwrap();
        let turning = body.rotations(w).unwrap();
        prop_assume!(turning.isolated() == turning.motions.len());
        let (tensor, spin) = (tensor.map(Rational::to_f64), (share * speed).map(Rational::to_f64));
        for v in turning.boxes(70).unwrap().iter().take(2) {
            let v = Vector3::from(v.each_ref().map(Enclosure::to_f64));
            let p = w.to_f64() * v.dot(&(tensor * v)) + spin.dot(&v);
            let all = body.at_momentum(Rational::exactly(p)).unwrap();
            prop_assert!(all.undecided.is_none(), "{:?}", all.undecided);
            let near = all.motions.iter().map(|motion| {
                let (u, speed) = motion.direction_and_speed(60).unwrap();
                let u = Vector3::from(u.each_ref().map(Enclosure::to_f64));
                // each has the prescribed momentum
                let momentum = speed.to_f64() * u.dot(&(tensor * u)) + spin.dot(&u);
                assert!((momentum - p).abs() <= 1e-9 * (p.abs() + spin.norm()), "{momentum} is not {p}");
                (u - v).norm() + (speed.to_f64() - w.to_f64()).abs()
            });
            let near = near.fold(f64::INFINITY, f64::min);
            prop_assert!(near < 1e-5, "the nearest is {near:e} away");
        }
    }

    /// The number of motions changes by two at a fold, and nowhere else.
    #[test]
    fn the_number_of_motions_changes_at_folds_alone(bodies in gyrostat(), speed in -900..900i64) {
        let energies = Energies::of(&bodies);
        let (tensor, share) = energies.quadratic(Kept::RelativeSpeed);
        let value = Root::rational(Rational::new(speed, 10)).unwrap();
        let body = Body::new(&tensor, &share, &value, &energies.weight).unwrap();
        let Ok(census) = body.census() else { return Ok(()) };
        for pair in census.stretches.windows(2) {
            let (before, after) = (pair[0].isolated as i64, pair[1].isolated as i64);
            prop_assert!(pair[0].to == 0.0 || (before - after).abs() <= 2, "{before} to {after}");
        }
        // counts at samples inside each interval agree
        for stretch in &census.stretches {
            let (from, to) = (stretch.from.max(-1e3), stretch.to.min(1e3));
            for share in [0.03, 0.37, 0.91] {
                let w = from + share * (to - from);
                if stretch.from < w && w < stretch.to {
                    let found = body.rotations(Rational::exactly(w)).unwrap();
                    prop_assert_eq!(found.isolated(), stretch.isolated);
                }
            }
        }
    }
}

#[test]
fn a_free_body_turns_about_each_principal_axis_with_the_momentum_over_its_moment() {
    let moments = Vector3::new(3, 4, 5).map(|n| Rational::new(n, 1));
    let zero = Vector3::repeat(Rational::new(0, 1));
    let speed = Root::rational(Rational::new(0, 1)).unwrap();
    let body = Body::new(&nalgebra::Matrix3::from_diagonal(&moments), &zero, &speed, &zero).unwrap();
    let all = body.at_momentum(Rational::new(60, 1)).unwrap();
    assert!(all.undecided.is_none());
    let mut speeds: Vec<f64> = all.motions.iter().map(|m| m.direction_and_speed(80).unwrap().1.to_f64()).collect();
    speeds.sort_by(f64::total_cmp);
    assert_eq!(speeds, [12.0, 12.0, 15.0, 15.0, 20.0, 20.0]);
}

#[test]
fn a_heavy_top_with_a_momentum_precesses_on_circles() {
    // moments (4, 4, 2), weight 8: on a circle with c = cos, 2 w^2 c = 8 and p = w (4 - 2 c^2)
    let moments = Vector3::new(4, 4, 2).map(|n| Rational::new(n, 1));
    let (zero, weight) = (Rational::new(0, 1), Vector3::new(0, 0, 8).map(|n| Rational::new(n, 1)));
    let speed = Root::rational(zero).unwrap();
    let body = Body::new(&nalgebra::Matrix3::from_diagonal(&moments), &Vector3::repeat(zero), &speed, &weight).unwrap();
    let all = body.at_momentum(Rational::new(31, 2)).unwrap();
    assert!(all.undecided.is_none(), "{:?}", all.undecided);
    let circles: Vec<_> = all.motions.iter().filter(|m| matches!(m.shape, Shape::Circle { .. })).collect();
    assert!(!circles.is_empty());
    for circle in circles {
        let (centre, w) = circle.direction_and_speed(80).unwrap();
        let (c, w) = (centre[2].to_f64(), w.to_f64());
        assert!((2.0 * w * w * c - 8.0).abs() < 1e-9 && (w * (4.0 - 2.0 * c * c) - 15.5).abs() < 1e-9, "{c} {w}");
    }
    // and the two upright motions: p = 2 w
    let upright = all.motions.iter().filter(|m| m.direction_and_speed(80).unwrap().1.to_f64() == 7.75).count();
    assert_eq!(upright, 2);
}
