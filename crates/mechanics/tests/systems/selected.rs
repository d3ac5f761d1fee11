//! Motions with a given vertical component of angular momentum, in degenerate cases, each compared with its closed
//! form; none remains undecided.

use algebra::real::{Enclosure, Polynomial, Root};
use dalembert_mechanics::steady_rotations::{Body, Kind, Selected, Shape};
use field::{Rational, Scalar};
use nalgebra::{Matrix3, Vector3};

fn r(n: i64, d: i64) -> Rational {
    Rational::new(n, d)
}

fn diagonal(moments: [i64; 3]) -> Matrix3<Rational> {
    Matrix3::from_diagonal(&Vector3::from(moments).map(Rational::int))
}

fn body(moments: [i64; 3], spin: [Rational; 3], weight: [Rational; 3]) -> Body {
    let one = Root::rational(r(1, 1)).unwrap();
    Body::new(&diagonal(moments), &spin.into(), &one, &weight.into()).unwrap()
}

/// All motions, which must be complete: shape, kind, v (for a circle its centre), w.
fn all(body: &Body, p: Rational) -> Vec<(Shape, Kind, [f64; 3], f64)> {
    let Selected { motions, undecided, .. } = body.at_momentum(p).unwrap();
    assert_eq!(undecided, None);
    let each = motions.iter().map(|motion| {
        let (v, w) = motion.direction_and_speed(80).unwrap();
        // the midpoint of an enclosure of zero is not zero
        let rounded = |x: &Enclosure| (x.to_f64() * 1e14).round() / 1e14 + 0.0;
        (motion.shape, motion.kind, v.each_ref().map(rounded), rounded(&w))
    });
    each.collect()
}

/// The motions that rotate at w.
fn turning(body: &Body, p: Rational, w: f64) -> Vec<(Shape, Kind, [f64; 3])> {
    let all = all(body, p).into_iter().filter(|one| one.3 == w);
    all.map(|(shape, kind, v, _)| (shape, kind, v)).collect()
}

#[test]
fn an_axis_that_is_unseen_at_one_speed_carries_a_motion_with_one_momentum() {
    // s = -1/3 makes s h + s^2 G orthogonal to the first axis: a = (0, 0, 3/5), z = (+-4/5, 0, 0), p = -9 +- 4/5
    let tilted = body([3, 5, 4], [r(1, 1), r(0, 1), r(9, 5)], [r(3, 1), r(0, 1), r(0, 1)]);
    assert_eq!(turning(&tilted, r(-41, 5), -3.0), [(Shape::Point, Kind::Minimum, [0.8, 0.0, 0.6])]);
    assert_eq!(turning(&tilted, r(-49, 5), -3.0), [(Shape::Point, Kind::Minimum, [-0.8, 0.0, 0.6])]);
    // for a neighbouring p the motions are no longer in this special position
    let near = all(&tilted, r(-41, 5) + r(1, 1_000_000_000));
    assert!(near.iter().all(|one| one.3 != -3.0) && near.iter().any(|one| (one.3 + 3.0).abs() < 1e-8));
}

#[test]
fn a_circle_whose_momentum_varies_has_two_points_of_each_momentum_one_or_none() {
    // s = 1/2 makes s h + s^2 G orthogonal to the plane of the equal moments of inertia: v = (v1, v2, 3/5) with
    // v1 = p - 179/25
    let (zero, g) = (r(0, 1), r(14, 5));
    let oblique = body([4, 4, 2], [r(1, 1), zero, r(1, 1)], [r(-2, 1), zero, g]);
    let found = |p: Rational| -> Vec<[f64; 3]> { turning(&oblique, p, 2.0).into_iter().map(|one| one.2).collect() };
    assert_eq!(found(r(179, 25)), [[0.0, 0.8, 0.6], [0.0, -0.8, 0.6]]);
    assert_eq!(found(r(199, 25)), [[0.8, 0.0, 0.6]]);
    assert!(found(r(8, 1)).is_empty());
}

#[test]
fn on_a_sphere_of_motions_a_momentum_selects_a_circle_of_latitude_or_a_pole() {
    // three equal moments of inertia, s = 1/2: every v rotates at w = 2, p = 6 + v3
    let (zero, one) = (r(0, 1), r(1, 1));
    let ball = body([3, 3, 3], [zero, zero, one], [zero, zero, r(-2, 1)]);
    let [(Shape::Circle { .. }, Kind::Degenerate, centre)] = turning(&ball, r(13, 2), 2.0)[..] else { panic!() };
    assert_eq!(centre, [0.0, 0.0, 0.5]);
    assert_eq!(turning(&ball, r(7, 1), 2.0), [(Shape::Point, Kind::Degenerate, [0.0, 0.0, 1.0])]);
    assert!(turning(&ball, r(15, 2), 2.0).is_empty());
}

#[test]
fn without_weight_and_momentum_the_carrier_turns_both_ways_against_its_wheels() {
    // M w v = -h
    let free = body([1, 2, 4], [r(2, 1), r(4, 1), r(4, 1)], [r(0, 1); 3]);
    let found = all(&free, r(0, 1));
    let turning: Vec<_> = found.iter().filter(|one| one.3 != 0.0).collect();
    assert_eq!(turning.len(), 2);
    for (shape, _, v, w) in turning {
        assert_eq!((*shape, v.map(|v| (v * w * 1e12).round() / 1e12)), (Shape::Point, [-2.0, -2.0, -1.0]));
    }
    // and rest with v perpendicular to the rotors' axis
    let rest: Vec<_> = found.iter().filter(|one| one.3 == 0.0).collect();
    assert!(matches!(rest[..], [(Shape::Circle { .. }, _, [0.0, 0.0, 0.0], _)]), "{rest:?}");
}

#[test]
fn rests_without_weight_are_a_circle_a_pole_or_none() {
    let free = body([1, 2, 4], [r(2, 1), r(1, 1), r(2, 1)], [r(0, 1); 3]);
    let [(Shape::Circle { .. }, _, centre)] = turning(&free, r(1, 1), 0.0)[..] else { panic!("a circle") };
    assert_eq!(centre.map(|x| (x * 9.0 * 1e12).round() / 1e12), [2.0, 1.0, 2.0]);
    let pole = turning(&free, r(-3, 1), 0.0);
    assert_eq!(pole.iter().map(|one| (one.0, one.2[1])).collect::<Vec<_>>(), [(Shape::Point, -0.33333333333333)]);
    assert!(turning(&free, r(4, 1), 0.0).is_empty());
    let still = body([1, 2, 4], [r(0, 1); 3], [r(0, 1); 3]);
    assert!(matches!(turning(&still, r(0, 1), 0.0)[..], [(Shape::Sphere, ..)]));
}

#[test]
fn an_irrational_speed_and_irrational_moments_leave_nothing_open() {
    // moments of inertia 5 +- sqrt(2) perpendicular to the common axis of rotor and weight, the rotor at sqrt(3)
    let tensor = Matrix3::new(4, 1, 0, 1, 6, 0, 0, 0, 9).map(Rational::int);
    let along = Vector3::new(0, 0, 1).map(Rational::int);
    let speed = Polynomial::from_integers([-3, 0, 1]).real_roots().pop().unwrap();
    let body = Body::new(&tensor, &along, &speed, &along).unwrap();
    let found = all(&body, r(12, 1));
    // k = s p - s^2 v3 with (9 - k) v3 = -(s h + s^2), |v3| < 1: two motions each
    let mut expected = 0;
    for k in [5.0 - 2f64.sqrt(), 5.0 + 2f64.sqrt()] {
        let third = |s: f64| -(s * 3f64.sqrt() + s * s) / (9.0 - k);
        let missing = |s: f64| k - 12.0 * s - s * s * third(s);
        let grid: Vec<f64> = (-40_000..40_000).map(|n| (f64::from(n) + 0.5) * 2e-4).collect();
        let roots = grid.windows(2).filter(|pair| missing(pair[0]) * missing(pair[1]) < 0.0);
        expected += 2 * roots.filter(|pair| third(pair[0]).abs() < 1.0).count();
    }
    let pairs: Vec<_> = found.iter().filter(|one| matches!(one.0, Shape::Pair { .. })).collect();
    assert!(expected > 0);
    assert_eq!(pairs.len(), expected);
    for (_, _, v, w) in pairs {
        let v = Vector3::from(*v);
        let x = tensor.map(Rational::to_f64) * v * *w + Vector3::z() * 3f64.sqrt();
        assert!((x.dot(&v) - 12.0).abs() < 1e-12 && (x * *w + Vector3::z()).cross(&v).norm() < 1e-12);
    }
}

#[test]
fn a_double_moment_that_the_weight_sees_counts_twice() {
    // W = v.M v/2 + G.v has one minimum and one maximum if G is large
    let zero = r(0, 1);
    let long = body([1, 1, 2], [zero; 3], [r(3, 1), zero, r(4, 1)]);
    let found = long.rotations(r(1, 1)).unwrap();
    assert_eq!(found.motions.iter().map(|one| one.kind).collect::<Vec<_>>(), [Kind::Minimum, Kind::Maximum]);
}
