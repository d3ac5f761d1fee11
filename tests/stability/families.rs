//! Families of motions of degenerate gyrostats: their verdicts compared with eigenvalues of the compiled equations.

use crate::running::{Law, eigenvalues, run, state};
use crate::tops::{
    Top, along, at_constant_speed, by_slip, circling, free, in_step, lagrange, oblique, r, without_friction,
};
use dalembert_derivations::studies::stationary::stability::along::Along;
use dalembert_derivations::studies::stationary::stability::{Reason, StabilityVerdict};
use dalembert_derivations::systems::gyrostat::forms::SecondForm;
use field::Rational;
use mechanics::steady_rotations::Shape;
use motor::ConstantSpeed;
use nalgebra::Vector3;

/// The verdicts on all arcs with one angle, and those on isolated directions.
fn told(along: &Along) -> (Vec<StabilityVerdict>, Vec<([f64; 3], StabilityVerdict)>) {
    let rounded = |v: Vector3<f64>| [v.x, v.y, v.z].map(|x| (x * 1e12).round() / 1e12 + 0.0);
    let edges = along.edges.iter().map(|edge| (rounded(edge.direction), edge.judged.verdict));
    (along.arcs.iter().map(|arc| arc.judged.verdict).collect(), edges.collect())
}

const ASYMPTOTIC: StabilityVerdict = StabilityVerdict::AsymptoticallyStableModuloIntegrals;

#[test]
fn a_symmetric_top_that_precesses_is_stable_as_a_family_with_every_motor_that_holds_its_angle() {
    let top = lagrange();
    let whole = |all: Vec<(Shape, Vec<Along>)>| -> Vec<StabilityVerdict> {
        let [(Shape::Circle { .. }, along)] = &all[..] else { panic!("one circle: {all:?}") };
        // the tangent of the circle adds one zero eigenvalue, and one integral
        let one = |along: &Along| {
            assert!(along.edges.is_empty() && along.arcs[0].judged.along == 1, "{along:?}");
            along.arcs[0].judged.verdict
        };
        along.iter().map(one).collect()
    };
    assert_eq!(whole(top.families(at_constant_speed(r(2, 1)), r(2, 1))), [StabilityVerdict::Stable]);
    assert_eq!(whole(top.families(free(r(1, 1)), r(2, 1))), [StabilityVerdict::Stable]);
    assert_eq!(whole(top.families(by_slip(r(2, 1)), r(2, 1))), [StabilityVerdict::Stable]);
    let in_step = whole(top.families(in_step(r(2, 1)), r(2, 1)));
    assert_eq!(in_step, [StabilityVerdict::Stable, StabilityVerdict::Unstable { right: 1 }]);
}

#[test]
fn beside_an_oblique_rotor_a_circle_is_stable_where_its_axis_has_the_smaller_moment() {
    // except where the momentum has its maximum and minimum along the circle
    let open = StabilityVerdict::CannotTell(Reason::Edge);
    let ends = [([-0.8, 0.0, 0.6], open), ([0.8, 0.0, 0.6], open)];
    let verdicts = |all: Vec<(Shape, Vec<Along>)>, angle: usize| -> Vec<StabilityVerdict> {
        let (arcs, mut edges) = told(&all[0].1[angle]);
        edges.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
        assert_eq!((all.len(), &edges[..]), (1, &ends[..]));
        arcs
    };
    let top = oblique([4, 4, 2]);
    assert_eq!(verdicts(top.families(at_constant_speed(r(5, 1)), r(2, 1)), 0), [StabilityVerdict::Stable; 2]);
    assert_eq!(verdicts(top.families(by_slip(r(5, 1)), r(2, 1)), 0), [ASYMPTOTIC; 2]);
    assert_eq!(told(&top.families(in_step(r(5, 1)), r(2, 1))[0].1[0]).0, [ASYMPTOTIC; 2]);
    let flat = oblique([4, 4, 7]).families(at_constant_speed(r(5, 1)), r(2, 1));
    assert!(told(&flat[0].1[0]).0.iter().all(|one| matches!(one, StabilityVerdict::Unstable { .. })), "{flat:?}");
}

/// With the rotor orthogonal to the axis of symmetry and v3 = 0, the body nutates without rotation about the rotor's
/// axis if A1 w l.v = A'W; no motor damps this nutation.
#[test]
fn beside_a_rotor_that_does_not_feel_the_nutation_two_directions_of_a_circle_are_not_asymptotically_stable() {
    let top = circling([5, 5, 2], along([1, 0, 0]), r(0, 1), [r(1, 1), r(3, 1)]);
    let all = top.families(by_slip(r(6, 1)), r(1, 1));
    let (arcs, edges) = told(&all[0].1[0]);
    let mut apart: Vec<[f64; 3]> =
        edges.into_iter().filter(|edge| edge.1 == StabilityVerdict::Stable).map(|edge| edge.0).collect();
    apart.sort_by(|a, b| a[1].total_cmp(&b[1]));
    assert_eq!((&arcs[..], &apart[..]), (&[ASYMPTOTIC; 4][..], &[[0.6, -0.8, 0.0], [0.6, 0.8, 0.0]][..]));
}

/// If the energy has a minimum neither for the angle nor for the circle, both may be stabilised gyroscopically on a
/// part of the circle.
#[test]
fn along_a_circle_two_pairs_meet_and_what_gyroscopes_keep_is_lost() {
    let top = circling([4, 4, 7], [r(3, 5), r(0, 1), r(4, 5)], r(4, 5), [r(3, 1), r(1, 1)]);
    let all = top.families(without_friction(r(2, 1), r(1, 100)), r(3, 1));
    let arcs = told(&all[0].1[1]).0;
    let kept = |one: &&StabilityVerdict| **one == StabilityVerdict::CannotTell(Reason::Gyroscopic { negative: 2 });
    let lost = |one: &&StabilityVerdict| **one == StabilityVerdict::Unstable { right: 2 };
    assert_eq!(
        (arcs.iter().filter(kept).count(), arcs.iter().filter(lost).count(), arcs.len()),
        (2, 8, 10),
        "{arcs:?}"
    );
}

#[test]
fn a_ball_turns_about_any_direction_with_its_rotor_and_weight_in_balance() {
    let ball = Top { moments: [3, 3, 3], axis: along([0, 0, 1]), weight: along([0, 0, -2]) };
    let all = ball.families(at_constant_speed(r(2, 1)), r(2, 1));
    let [(Shape::Sphere, belts)] = &all[..] else { panic!("a sphere: {all:?}") };
    assert_eq!(told(&belts[0]).0, [StabilityVerdict::Stable]);
    assert_eq!(belts[0].arcs[0].judged.along, 1, "along the parallels");
}

#[test]
fn without_weight_the_size_of_the_momentum_makes_a_family_stable() {
    let weightless = Top { moments: [3, 4, 5], axis: [r(3, 5), r(0, 1), r(4, 5)], weight: along([0, 0, 0]) };
    let rests = weightless.families(at_constant_speed(r(2, 1)), r(0, 1));
    let (arcs, poles) = told(&rests[0].1[0]);
    assert_eq!((rests[0].0, &arcs[..]), (Shape::Sphere, &[StabilityVerdict::Stable][..]));
    assert!(poles.iter().all(|pole| pole.1 == StabilityVerdict::Stable), "{poles:?}");
    // a symmetric body rotates about a circle of axes perpendicular to its own axis
    let symmetric = Top { moments: [4, 4, 2], axis: along([0, 0, 1]), weight: along([0, 0, 0]) };
    for speed in [0, 2] {
        let all = symmetric.families(at_constant_speed(r(speed, 1)), r(2, 1));
        assert_eq!(told(&all[0].1[0]), (vec![StabilityVerdict::Stable], vec![]), "{all:?}");
    }
}

#[test]
fn a_family_that_is_stable_stays_near_and_one_that_is_not_leaves() {
    /// The distance from w = 2 v with this v3.
    fn off(state: &[f64], v3: f64) -> f64 {
        let apart = (0..3).map(|i| (state[i] - 2.0 * state[3 + i]).powi(2)).sum::<f64>().sqrt();
        apart + (state[5] - v3).abs()
    }
    let push = |mut state: Vec<f64>| {
        state[0] += 8e-7;
        state[1] -= 5e-7;
        state
    };
    let law = |top: Top, speed: f64| {
        let floats = |v: [Rational; 3]| Vector3::from(v).map(Rational::to_f64);
        let moments = Vector3::from(top.moments).map(|n| n as f64);
        Law::new(SecondForm::new(moments, floats(top.axis), 0.5, floats(top.weight)), ConstantSpeed { speed })
    };
    let stays = law(lagrange(), 2.0);
    let at = state(&stays, Vector3::new((1.0f64 - 0.140625).sqrt(), 0.0, 0.375), 2.0, 2.0, 0.0);
    let after = run(&stays, push(at), 0.01, 10_000);
    assert!(off(&after, 0.375) < 1e-5, "{:e}", off(&after, 0.375));
    let leaves = law(oblique([4, 4, 7]), 5.0);
    let at = state(&leaves, Vector3::new(0.0, 0.8, 0.6), 2.0, 5.0, 0.0);
    let rate = eigenvalues(&leaves, &at).iter().map(|one| one.0).fold(0.0, f64::max);
    let after = run(&leaves, push(at), 0.01, (100.0 * 1e4f64.ln() / rate) as usize);
    assert!(rate > 0.05 && off(&after, 0.6) > 1e-4, "{rate} {:e}", off(&after, 0.6));
}
