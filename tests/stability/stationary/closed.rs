//! Steady motions in closed form, including families.

use algebra::real::{Enclosure, Root};
use field::{Rational, Scalar};
use mechanics::steady_rotations::{Body, Kind, Shape};
use nalgebra::{Matrix3, Vector3};

fn r(n: i64, d: i64) -> Rational {
    Rational::new(n, d)
}

fn vector(v: [i64; 3]) -> Vector3<Rational> {
    Vector3::from(v).map(Rational::int)
}

fn body(moments: [i64; 3], spin: [i64; 3], weight: [i64; 3]) -> Body {
    let speed = Root::rational(Rational::int(1)).unwrap();
    Body::new(&Matrix3::from_diagonal(&vector(moments)), &vector(spin), &speed, &vector(weight)).unwrap()
}

fn shapes(body: &Body, w: Rational) -> Vec<(Shape, Kind)> {
    let all = body.rotations(w).unwrap();
    assert_eq!((all.roots, all.morse().unwrap_or(2)), (all.roots_by_sturm(), 2));
    all.motions.iter().map(|motion| (motion.shape, motion.kind)).collect()
}

#[test]
fn a_body_without_rotor_and_weight_turns_about_its_principal_axes_alone() {
    let all = body([3, 4, 5], [0; 3], [0; 3]).rotations(r(7, 2)).unwrap();
    assert_eq!(all.isolated(), 6);
    for (motion, v) in all.motions.iter().zip(all.boxes(80).unwrap()) {
        let v = v.each_ref().map(Enclosure::to_f64);
        assert_eq!(v.iter().filter(|x| x.abs() == 1.0).count(), 1, "{v:?}");
        assert!(matches!(motion.shape, Shape::Pair { .. }));
    }
    let kinds: Vec<Kind> = all.motions.iter().map(|motion| motion.kind).collect();
    assert_eq!(kinds, [Kind::Minimum, Kind::Minimum, Kind::Saddle, Kind::Saddle, Kind::Maximum, Kind::Maximum]);
}

#[test]
fn equal_moments_without_rotor_and_weight_allow_every_direction() {
    assert_eq!(shapes(&body([3, 3, 3], [0; 3], [0; 3]), r(1, 1)), [(Shape::Sphere, Kind::Degenerate)]);
}

#[test]
fn two_equal_moments_without_rotor_and_weight_leave_a_circle() {
    let found = shapes(&body([3, 3, 5], [0; 3], [0; 3]), r(1, 1));
    assert_eq!(found[0], (Shape::Circle { place: 0 }, Kind::Minimum));
    assert_eq!(found[1..].iter().filter(|(_, kind)| *kind == Kind::Maximum).count(), 2);
}

#[test]
fn at_rest_the_centre_of_mass_is_above_or_below() {
    let all = body([3, 4, 5], [1, 2, 2], [2, 3, 6]).rotations(r(0, 1)).unwrap();
    let boxes = all.boxes(80).unwrap();
    let first: Vec<f64> = boxes.iter().map(|v| v[2].to_f64()).collect();
    assert_eq!(first, [-6.0 / 7.0, 6.0 / 7.0]);
    assert_eq!(shapes(&body([3, 4, 5], [1, 2, 2], [0; 3]), r(0, 1)), [(Shape::Sphere, Kind::Degenerate)]);
}

#[test]
fn a_heavy_symmetric_top_precesses_on_a_circle_where_it_is_fast_enough() {
    // principal moments (4, 4, 2), weight 8 along the axis: (4 - 2) w^2 cos = 8 up to the sign
    let top = body([4, 4, 2], [0; 3], [0, 0, 8]);
    let slow = shapes(&top, r(1, 1));
    assert_eq!(slow.len(), 2, "{slow:?}");
    let fast = top.rotations(r(4, 1)).unwrap();
    let circle = fast.motions.iter().find(|motion| matches!(motion.shape, Shape::Circle { .. })).unwrap();
    assert_eq!(fast.motions.len(), 3);
    // cos = 8 / (2 w^2) = 1/4
    assert_eq!(circle.direction(80).unwrap()[2].to_f64(), 0.25);
    assert_eq!(circle.radius(80).unwrap().to_f64(), 15f64.sqrt() / 4.0);
    // at w = 2, where the circle shrinks to a point, no motion is counted twice
    let merged = shapes(&top, r(2, 1));
    assert_eq!(merged.len(), 2, "{merged:?}");
    assert!(merged.iter().any(|(_, kind)| *kind == Kind::Degenerate));
}

#[test]
fn a_rotor_and_a_weight_in_a_principal_plane_leave_mirrored_pairs() {
    let plane = body([3, 5, 4], [1, 0, 2], [3, 0, 1]);
    let all = plane.rotations(r(6, 1)).unwrap();
    let pairs: Vec<_> = all.motions.iter().filter(|motion| matches!(motion.shape, Shape::Pair { .. })).collect();
    assert_eq!((pairs.len(), all.isolated() % 2), (2, 0));
    let [a, b] = [0, 1].map(|k| pairs[k].direction(80).unwrap());
    assert_eq!((a[0].to_f64(), a[1].to_f64(), a[2].to_f64()), (b[0].to_f64(), -b[1].to_f64(), b[2].to_f64()));
}

#[test]
fn a_rotor_along_a_principal_axis_lets_it_turn_about_this_axis_at_any_speed() {
    // weight and rotor along the third axis
    for w in [r(1, 3), r(5, 1), r(-7, 2)] {
        let all = body([3, 4, 5], [0, 0, 2], [0, 0, 7]).rotations(w).unwrap();
        let upright = all.boxes(80).unwrap().iter().filter(|v| v[2].to_f64().abs() == 1.0).count();
        assert_eq!(upright, 2, "{w}");
    }
}

#[test]
fn motions_that_merge_are_one_and_the_second_derivative_says_nothing() {
    // two roots merge on the astroid b_1^(2/3) + b_2^(2/3) = gap^(2/3)
    let b = [27, 0, 729].map(Rational::int);
    let tensor = Matrix3::from_diagonal(&Vector3::new(r(0, 1), r(-5000, 1), r(1000, 1)));
    let speed = Root::rational(Rational::int(1)).unwrap();
    // (27^(2/3) + 729^(2/3))^(3/2) = 90^(3/2) is irrational; inside and outside the astroid the number of motions
    // differs by two
    let count = |g: Rational| {
        let tensor = Matrix3::from_diagonal(&Vector3::new(tensor[(0, 0)], tensor[(1, 1)], g));
        Body::new(&tensor, &vector([0; 3]), &speed, &Vector3::from(b)).unwrap().rotations(r(1, 1)).unwrap().isolated()
    };
    // 90^(3/2) = 853.81...
    assert_eq!((count(r(853, 1)), count(r(854, 1))), (4, 6));
    // 27^(2/3) + 64^(2/3) = 25 = 125^(2/3)
    let tensor = Matrix3::from_diagonal(&Vector3::new(r(0, 1), r(-5000, 1), r(125, 1)));
    let exact = Body::new(&tensor, &vector([0; 3]), &speed, &vector([27, 0, 64])).unwrap().rotations(r(1, 1)).unwrap();
    let degenerate = exact.motions.iter().filter(|motion| motion.kind == Kind::Degenerate).count();
    assert_eq!((exact.isolated(), degenerate, exact.morse()), (5, 1, None));
}
