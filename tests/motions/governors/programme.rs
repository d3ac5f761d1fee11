//! The programme of the movable wheel: closed form, series, contraction of the distance of two motions, and its end.

use super::*;

#[test]
fn the_closed_form_is_the_programme_of_appells_equations() {
    for (first, second) in [(-0.5, 0.4), (0.5, 0.4), (0.0, 0.4), (0.4, 0.0), (-0.5, -0.1), (1.0, -0.1)] {
        let data = steady(first, second);
        let closed = constant(&data, 0.3);
        let end = match closed.course() {
            ProgrammeEnd::ReachesAxis { time } => 0.9 * time,
            _ => 0.7,
        };
        let followed = run(&Programme(data), Span::new(0.0, end, &[0.3]))[0];
        let direct = closed.distance(end).expect("before the end");
        assert!((followed - direct).abs() < 1e-11, "M1 = {first}, M2 = {second}: {followed} and {direct}");
        assert!((closed.time(direct) - end).abs() < 1e-11, "the quadrature takes it back");
    }
}

#[test]
fn a_braked_second_shaft_drives_the_wheel_to_the_axis_in_finite_time() {
    let data = steady(0.0, -0.4);
    let closed = constant(&data, 0.3);
    let ProgrammeEnd::ReachesAxis { time } = closed.course() else { panic!("{:?}", closed.course()) };
    assert!((time + 0.09 / (2.0 * closed.epsilon * closed.of_second)).abs() < 1e-15);
    assert_eq!(closed.distance(time), None);
    // half of the distance remains after three quarters of the time, since the speed grows without bound
    assert!((closed.distance(0.75 * time).expect("before the end") - 0.15).abs() < 1e-14);
    let span = Span::new(0.0, 1.01 * time, &[0.3]).with_evaluations(200_000);
    let past = integrate(&Programme(data), Method::DormandPrince8, &Tolerance::both(1e-10), &span, &mut ());
    assert!(past.failure().is_some(), "no motion goes on behind the axis");
    assert!(past.time <= time * (1.0 + 1e-9), "{} and {time}", past.time);
}

#[test]
fn the_wheel_tends_to_its_place_where_the_first_shaft_takes_what_the_second_gives() {
    let closed = constant(&steady(-0.5, 0.4), 0.3);
    assert_eq!(closed.course(), ProgrammeEnd::TendsTo { distance: 0.4 });
    assert!((closed.distance(200.0).expect("for ever") - 0.4).abs() < 1e-15);
    assert_eq!(constant(&steady(0.5, 0.4), 0.3).course(), ProgrammeEnd::Grows);
    assert_eq!(constant(&steady(-0.5, 0.4), 0.4).course(), ProgrammeEnd::Rest);
}

#[test]
fn two_motions_approach_by_the_exact_law_of_contraction() {
    /// Two motions, and the integral of k1/(k rho_a rho_b).
    struct Pair(Governor<f64>);
    impl<S: Over<f64> + Analytic> Ode<S> for Pair {
        fn dimension(&self) -> usize {
            3
        }

        fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
            let speed = S::lift(SPEED);
            dy[0] = self.0.programme(t, y[0], speed);
            dy[1] = self.0.programme(t, y[1], speed);
            let moment: S = self.0.moments[1].at(t);
            let inertia = S::lift(0.1 + 0.6 * 0.04 / 0.25);
            dy[2] = S::lift(0.04) * moment / (speed * inertia * y[0] * y[1]);
        }
    }
    impl System for Pair {}
    let moments = [Torque { start: -0.5, growth: 0.1 }, Torque { start: 0.4, growth: 0.2 }];
    let end = run(&Pair(governor(moments)), Span::new(0.0, 1.5, &[0.30, 0.37, 0.0]));
    let contracted = 0.07 * (-end[2]).exp();
    assert!(((end[1] - end[0]) - contracted).abs() < 1e-12, "{} and {contracted}", end[1] - end[0]);
}

#[test]
fn the_series_satisfies_its_equation_to_every_order_exactly() {
    let ratio = Rational::new;
    let data = Governor {
        inertia: [ratio(3, 5), ratio(1, 2), ratio(1, 10)],
        mass: ratio(4, 5),
        radius: ratio(1, 5),
        gearing: Gearing::Drum { radius: ratio(1, 2) },
        moments: [
            Torque { start: ratio(-1, 2), growth: ratio(1, 3) },
            Torque { start: ratio(2, 5), growth: ratio(1, 7) },
        ],
        push: ratio(0, 1),
        lateral: ratio(0, 1),
    };
    let law = data.small_parameter(ratio(2, 1)).expect("a drum");
    let terms = law.series(ratio(3, 10), 7);
    // the coefficient of t^p in rho_0 rho_n' + ... - k2 rho_(n-1) - [n = 1] k1, for every n and p
    let at = |polynomial: &[Rational], p: usize| polynomial.get(p).copied().unwrap_or(Rational::int(0));
    let slope = |polynomial: &[Rational], p: usize| at(polynomial, p + 1) * Rational::int(p as i64 + 1);
    let convolved = |a: &dyn Fn(usize) -> Rational, b: &dyn Fn(usize) -> Rational, p: usize| {
        (0..=p).fold(Rational::int(0), |sum, i| sum + a(i) * b(p - i))
    };
    for n in 1..=7 {
        for p in 0..16 {
            let mut balance = -convolved(&|i| at(&law.of_first, i), &|i| at(&terms[n - 1], i), p);
            if n == 1 {
                balance -= at(&law.of_second, p);
            }
            for i in 0..n {
                balance += convolved(&|q| at(&terms[i], q), &|q| slope(&terms[n - i], q), p);
            }
            assert_eq!(balance, Rational::int(0), "order {n}, power {p}");
        }
    }
}

#[test]
fn the_error_of_the_series_falls_with_every_order() {
    let moments = [Torque { start: -0.5, growth: 0.3 }, Torque { start: 0.4, growth: 0.1 }];
    let data = governor(moments);
    let exact = run(&Programme(data), Span::new(0.0, 0.3, &[0.3]))[0];
    let sums = data.small_parameter(SPEED).expect("a drum").approximations(0.3, 12, 0.3);
    let errors: Vec<f64> = sums.iter().map(|sum| (sum - exact).abs()).collect();
    for pair in errors.windows(2).take(10) {
        assert!(pair[1] < 0.6 * pair[0], "{errors:?}");
    }
    assert!(errors[12] < 1e-8, "{errors:?}");
}

#[test]
fn the_push_that_the_programme_needs_is_what_keeps_the_speed() {
    let moments = [Torque { start: -0.5, growth: 0.3 }, Torque { start: 0.4, growth: 0.1 }];
    let data = governor(moments);
    let (t, rho) = (0.2, 0.35);
    let drift = data.programme(t, rho, SPEED);
    let push = data.control_force(t, rho, SPEED);
    let [spin, _, acceleration] = data.released(t, [SPEED, rho, drift], push).expect("real masses");
    assert!(spin.abs() < 1e-14);
    let wanted: f64 = data.programme_acceleration(t, rho, SPEED);
    assert!((acceleration - wanted).abs() < 1e-13, "{acceleration} and {wanted}");
}

#[test]
fn the_drawn_series_converge_faster_the_higher_the_speed() {
    let errors = dalembert_derivations::studies::governors::series_errors();
    assert_eq!(errors.len(), 4);
    for pair in errors.windows(2) {
        assert!(pair[1].1[5].1 < 0.1 * pair[0].1[5].1, "{pair:?}");
    }
}

#[test]
fn the_counterexamples_to_rank_and_to_staying_on_the_disc_are_governors() {
    // n = 2, J2 = m = omega2 = rho_0 = 1, M1 = 2, M2 = 1: J2 M1/R = n rho_0 M2, and rho_0' = 3/2
    let data = Governor {
        inertia: [1.0, 1.0, 1.0],
        mass: 1.0,
        radius: 1.0,
        gearing: Gearing::Drum { radius: 1.0 },
        moments: [Torque::constant(2.0), Torque::constant(1.0)],
        push: 0.0,
        lateral: 0.0,
    };
    let at = |t: f64| {
        let rho = 1.0 + 1.5 * t;
        let drift = data.programme(0.0, rho, 1.0);
        data.linearised(0.0, [1.0, rho, drift]).expect("real masses")
    };
    assert!((data.programme(0.0, 1.0, 1.0) - 1.5_f64).abs() < 1e-15);
    let (now, h) = (at(0.0), 1e-5);
    let second = |t: f64| at(t).apply(at(t).control).map(|entry| -entry);
    let rate: [f64; 3] = std::array::from_fn(|i| (second(h)[i] - second(-h)[i]) / (2.0 * h));
    let turned = now.apply(second(0.0));
    assert!((rate[0] - turned[0]).abs() < 1e-9, "L3 vanishes: {} and {}", rate[0], turned[0]);
    let leaving = ConstantTorques { epsilon: 1.0, of_second: 1.0, of_first: 0.0, start: 1.0 };
    assert_eq!(leaving.distance(4.0), Some(3.0), "past the edge of a disc of radius 2");
}

/// All cases of the quadrature, of the long-time behaviour, and of the end.
#[test]
fn between_two_discs_the_programme_is_the_quadrature() {
    let between = |first: f64, second: f64| Governor {
        gearing: Gearing::Discs { distance: 0.8 },
        moments: [Torque::constant(first), Torque::constant(second)],
        ..steady(first, second)
    };
    for (first, second, course) in [
        (-0.5, 0.4, ProgrammeEnd::TendsTo { distance: 0.8 * 0.5 / 0.9 }),
        (0.5, 0.4, ProgrammeEnd::TendsTo { distance: 0.0 }),
        (0.4, 0.4, ProgrammeEnd::TendsTo { distance: 0.0 }),
        (0.0, 0.4, ProgrammeEnd::TendsTo { distance: 0.0 }),
        (0.4, 0.0, ProgrammeEnd::TendsTo { distance: 0.0 }),
        (0.5, -0.1, ProgrammeEnd::TendsTo { distance: 0.0 }),
        (0.1, -0.5, ProgrammeEnd::ReachesAxis { time: f64::NAN }),
        (-0.4, -0.4, ProgrammeEnd::ReachesAxis { time: f64::NAN }),
        (0.0, -0.4, ProgrammeEnd::ReachesAxis { time: f64::NAN }),
        (-0.2, -0.4, ProgrammeEnd::ReachesAxis { time: f64::NAN }),
    ] {
        let data = between(first, second);
        let law = data.between(SPEED).expect("two discs");
        let end = match (law.course(0.3), course) {
            (ProgrammeEnd::ReachesAxis { time }, ProgrammeEnd::ReachesAxis { .. }) => {
                assert_eq!(law.distance_at(0.3, time), None);
                let nearly = law.distance_at(0.3, time * (1.0 - 1e-12)).expect("before the end");
                assert!((0.8 - nearly).abs() < 1e-4, "{nearly}");
                0.9 * time
            }
            (ProgrammeEnd::TendsTo { distance: found }, ProgrammeEnd::TendsTo { distance }) => {
                assert!((found - distance).abs() < 1e-15, "{found} and {distance}");
                1.5
            }
            other => panic!("{other:?}"),
        };
        let followed = run(&Programme(data), Span::new(0.0, end, &[0.3]))[0];
        let direct = law.distance_at(0.3, end).expect("before the end");
        assert!((followed - direct).abs() < 1e-11, "M1 = {first}, M2 = {second}: {followed} and {direct}");
        assert!((law.time(0.3, direct) - end).abs() < 1e-11, "the quadrature takes it back");
    }
    assert_eq!(between(-0.5, 0.5).between(SPEED).map(|law| law.course(0.4)), Some(ProgrammeEnd::Rest));
    assert!(between(-0.5, 0.4).between(SPEED).is_some_and(|law| law.time(0.3, 0.5).is_nan()), "behind its place");
}
