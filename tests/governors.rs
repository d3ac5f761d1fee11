//! The friction governors run: programme, stability, optimal stabilisation, each seen by two routes.

use derivations::systems::elastic_governor::{ElasticGovernor, Rim};
use derivations::systems::governor::constant::{ConstantMoments, Course};
use derivations::systems::governor::{Gearing, Governor, Moment};
use field::{Analytic, Over, Rational, Scalar};
use integrators::{Method, Ode, Span, System, Tolerance, integrate};
use mechanics::bellman::{Regulator, quadratic};
use mechanics::stability::{characteristic, hurwitz};
use nalgebra::SMatrix;

const SPEED: f64 = 2.0;

fn governor(moments: [Moment<f64>; 2]) -> Governor<f64> {
    Governor {
        inertia: [0.6, 0.5, 0.1],
        mass: 0.8,
        radius: 0.2,
        gearing: Gearing::Drum { radius: 0.5 },
        moments,
        push: 0.0,
        lateral: 0.3,
    }
}

fn steady(first: f64, second: f64) -> Governor<f64> {
    governor([Moment::constant(first), Moment::constant(second)])
}

fn constant(governor: &Governor<f64>, start: f64) -> ConstantMoments {
    let law = governor.small_parameter(SPEED).expect("a drum");
    ConstantMoments { epsilon: law.epsilon, of_second: law.of_second[0], of_first: law.of_first[0], start }
}

/// rho along the programme.
struct Programme(Governor<f64>);

impl<S: Over<f64> + Analytic> Ode<S> for Programme {
    fn dimension(&self) -> usize {
        1
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        dy[0] = self.0.programme(t, y[0], S::lift(SPEED));
    }
}

impl System for Programme {}

fn run(system: &dyn System, span: &Span<'_, f64>) -> Vec<f64> {
    let outcome = integrate(system, Method::DormandPrince8, &Tolerance::both(1e-13), span, &mut ());
    assert_eq!(outcome.failure(), None);
    outcome.state
}

#[test]
fn the_closed_form_is_the_programme_of_appells_equations() {
    for (first, second) in [(-0.5, 0.4), (0.5, 0.4), (0.0, 0.4), (0.4, 0.0), (-0.5, -0.1), (1.0, -0.1)] {
        let data = steady(first, second);
        let closed = constant(&data, 0.3);
        let end = match closed.course() {
            Course::ReachesAxis { time } => 0.9 * time,
            _ => 0.7,
        };
        let followed = run(&Programme(data), &Span::new(0.0, end, &[0.3]))[0];
        let direct = closed.distance(end).expect("before the end");
        assert!((followed - direct).abs() < 1e-11, "M1 = {first}, M2 = {second}: {followed} and {direct}");
        assert!((closed.time(direct) - end).abs() < 1e-11, "the quadrature takes it back");
    }
}

#[test]
fn a_braked_second_shaft_drives_the_wheel_to_the_axis_in_finite_time() {
    let data = steady(0.0, -0.4);
    let closed = constant(&data, 0.3);
    let Course::ReachesAxis { time } = closed.course() else { panic!("{:?}", closed.course()) };
    assert!((time + 0.09 / (2.0 * closed.epsilon * closed.of_second)).abs() < 1e-15);
    assert_eq!(closed.distance(time), None);
    // half the distance is left at three quarters of the time: the speed grows without bound
    assert!((closed.distance(0.75 * time).expect("before the end") - 0.15).abs() < 1e-14);
    let span = Span::new(0.0, 1.01 * time, &[0.3]).with_evaluations(200_000);
    let past = integrate(&Programme(data), Method::DormandPrince8, &Tolerance::both(1e-10), &span, &mut ());
    assert!(past.failure().is_some(), "no motion goes on behind the axis");
    assert!(past.time <= time * (1.0 + 1e-9), "{} and {time}", past.time);
}

#[test]
fn the_wheel_tends_to_its_place_where_the_first_shaft_takes_what_the_second_gives() {
    let closed = constant(&steady(-0.5, 0.4), 0.3);
    assert_eq!(closed.course(), Course::TendsTo { distance: 0.4 });
    assert!((closed.distance(200.0).expect("for ever") - 0.4).abs() < 1e-15);
    assert_eq!(constant(&steady(0.5, 0.4), 0.3).course(), Course::Grows);
    assert_eq!(constant(&steady(-0.5, 0.4), 0.4).course(), Course::Rest);
}

#[test]
fn two_motions_approach_by_the_exact_law_of_contraction() {
    /// Two motions and the integral of k1/(k rho_a rho_b).
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
    let moments = [Moment { start: -0.5, growth: 0.1 }, Moment { start: 0.4, growth: 0.2 }];
    let end = run(&Pair(governor(moments)), &Span::new(0.0, 1.5, &[0.30, 0.37, 0.0]));
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
            Moment { start: ratio(-1, 2), growth: ratio(1, 3) },
            Moment { start: ratio(2, 5), growth: ratio(1, 7) },
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
    let moments = [Moment { start: -0.5, growth: 0.3 }, Moment { start: 0.4, growth: 0.1 }];
    let data = governor(moments);
    let exact = run(&Programme(data), &Span::new(0.0, 0.3, &[0.3]))[0];
    let sums = data.small_parameter(SPEED).expect("a drum").approximations(0.3, 12, 0.3);
    let errors: Vec<f64> = sums.iter().map(|sum| (sum - exact).abs()).collect();
    for pair in errors.windows(2).take(10) {
        assert!(pair[1] < 0.6 * pair[0], "{errors:?}");
    }
    assert!(errors[12] < 1e-8, "{errors:?}");
}

#[test]
fn the_push_that_the_programme_needs_is_what_keeps_the_speed() {
    let moments = [Moment { start: -0.5, growth: 0.3 }, Moment { start: 0.4, growth: 0.1 }];
    let data = governor(moments);
    let (t, rho) = (0.2, 0.35);
    let drift = data.programme(t, rho, SPEED);
    let push = data.control_force(t, rho, SPEED);
    let [spin, _, acceleration] = data.released(t, [SPEED, rho, drift], push).expect("real masses");
    assert!(spin.abs() < 1e-14);
    let wanted: f64 = data.programme_acceleration(t, rho, SPEED);
    assert!((acceleration - wanted).abs() < 1e-13, "{acceleration} and {wanted}");
}

fn elastic(load: f64, across: f64) -> ElasticGovernor<f64> {
    let rim = Rim {
        across: -across,
        twist: -2.0,
        drill: 0.0,
        curved_by_displacement: 5.0,
        curved_by_angle: 8.0,
        masses: [0.0; 2],
    };
    ElasticGovernor {
        inertia: [1.0, 1.0, 0.1],
        drum: 0.5,
        wheel: 0.2,
        offset: 0.1,
        sleeve: 1.0,
        ball: 1.0,
        link: 0.5,
        moments: [0.0, load],
        stiffness: [30.0, 20.0],
        tension: [0.1, 0.0],
        rest: 0.6,
        rim,
    }
    .stationary_at(SPEED)
}

#[test]
fn hurwitz_and_the_eigenvalues_agree_on_the_elastic_governor() {
    let (mut stable, mut unstable) = (0, 0);
    for load in [-40.0, -20.0, -5.0, -1.0, 0.5, 5.0] {
        for across in [0.5, 5.0, 50.0, 500.0] {
            let matrix = elastic(load, across).first_approximation(SPEED).expect("real masses");
            let by_minors = hurwitz(characteristic(matrix)).iter().all(|minor| *minor > 0.0);
            let flat = SMatrix::<f64, 5, 5>::from_fn(|i, j| matrix[i][j]);
            let schur = flat.try_schur(f64::EPSILON, 1000).expect("a matrix of numbers");
            let largest = schur.complex_eigenvalues().iter().map(|root| root.re).fold(f64::MIN, f64::max);
            assert_eq!(by_minors, largest < 0.0, "M2 = {load}, a = -{across}: {largest}");
            if by_minors { stable += 1 } else { unstable += 1 }
        }
    }
    assert!(stable > 2 && unstable > 2, "{stable} stable, {unstable} not");
}

struct Elastic(ElasticGovernor<f64>);

impl<S: Over<f64> + Analytic> Ode<S> for Elastic {
    fn dimension(&self) -> usize {
        6
    }

    fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
        let state = [y[0], y[1], y[2], y[3], y[4]];
        let rates = self.0.rates_of_state(state).unwrap_or([S::zero() / S::zero(); 5]);
        dy[..5].copy_from_slice(&rates);
        // the work of the shafts and of the rim's moment on the disc
        let [first, second] = self.0.moments.map(S::lift);
        let disc = S::lift(self.0.drum) * y[0] / (y[1] - S::lift(self.0.offset));
        dy[5] = first * y[0] + (second + S::lift(self.0.rim.drill) * y[4]) * disc;
    }
}

impl System for Elastic {}

#[test]
fn the_energy_of_the_elastic_governor_is_the_work_of_the_shafts() {
    for drill in [0.0, 2.0] {
        let mut data = elastic(-5.0, 50.0);
        data.rim.drill = drill;
        let start = [2.3, 0.62, 0.1, 0.01, 0.05];
        let mut state = start.to_vec();
        state.push(0.0);
        let end = run(&Elastic(data), &Span::new(0.0, 2.0, &state));
        let gained = data.energy([end[0], end[1], end[2], end[3], end[4]]) - data.energy(start);
        assert!((gained - end[5]).abs() < 1e-10, "{gained} and {}", end[5]);
        assert!((end[0] - 2.3).abs() > 1e-3, "the motion is one");
    }
}

/// Riccati's equation backwards with the programme, and the optimal motion with its cost.
struct Backwards(Governor<f64>);

const WEIGHTS: [f64; 3] = [1.0, 1.0, 1.0];

impl Backwards {
    fn regulator<S: Over<f64> + Analytic>(&self, t: S, rho: S) -> Regulator<S, 3>
    where
        field::Tangent<S>: Over<f64>,
    {
        let speed = S::lift(SPEED);
        let drift = self.0.programme(t, rho, speed);
        let first = self.0.first_approximation(t, [speed, rho, drift]).expect("real masses");
        Regulator { matrix: first.matrix, control: first.control, weights: WEIGHTS.map(S::lift), price: S::one() }
    }
}

/// y = (C11, C12, C13, C22, C23, C33, rho_0, x, cost).
impl<S: Over<f64> + Analytic> Ode<S> for Backwards {
    fn dimension(&self) -> usize {
        11
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let regulator = self.regulator(t, y[6]);
        let value = symmetric(y);
        let rate = regulator.riccati(value);
        dy[..6].copy_from_slice(&[rate[0][0], rate[0][1], rate[0][2], rate[1][1], rate[1][2], rate[2][2]]);
        dy[6] = self.0.programme(t, y[6], S::lift(SPEED));
        let x = [y[7], y[8], y[9]];
        let u = regulator.optimal(value, x);
        for i in 0..3 {
            dy[7 + i] = (0..3).fold(regulator.control[i] * u, |sum, j| sum + regulator.matrix[i][j] * x[j]);
        }
        dy[10] = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + u * u;
    }
}

impl System for Backwards {}

fn symmetric<S: Scalar>(y: &[S]) -> [[S; 3]; 3] {
    [[y[0], y[1], y[2]], [y[1], y[3], y[4]], [y[2], y[4], y[5]]]
}

#[test]
fn the_cost_of_the_optimal_motion_is_riccatis_value() {
    let moments = [Moment { start: -0.5, growth: 0.1 }, Moment { start: 0.4, growth: 0.2 }];
    let data = governor(moments);
    let horizon = 3.0;
    let at_end = run(&Programme(data), &Span::new(0.0, horizon, &[0.3]))[0];
    // C(T) = 0; where the motion ends is free, and decides where it begins
    let mut state = vec![0.0; 6];
    state.extend([at_end, 0.05, -0.03, 0.04, 0.0]);
    let begun = run(&Backwards(data), &Span::new(horizon, 0.0, &state));
    let value = quadratic(symmetric(&begun), [begun[7], begun[8], begun[9]]);
    let cost = -begun[10];
    assert!((begun[6] - 0.3).abs() < 1e-11);
    assert!(cost > 0.0 && (value / cost - 1.0).abs() < 1e-10, "{value} and {cost}");
}

/// The nonlinear governor on a resting programme under a constant law of control, with its cost.
struct Closed {
    governor: Governor<f64>,
    rho: f64,
    regulator: Regulator<f64, 3>,
    value: [[f64; 3]; 3],
    push: f64,
}

impl<S: Over<f64> + Analytic> Ode<S> for Closed {
    fn dimension(&self) -> usize {
        4
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let away = [y[0] - S::lift(SPEED), y[1] - S::lift(self.rho), y[2]];
        let gain: [S; 3] = std::array::from_fn(|i| {
            let mut unit = [0.0; 3];
            unit[i] = 1.0;
            S::lift(self.regulator.optimal(self.value, unit))
        });
        let u = gain[0] * away[0] + gain[1] * away[1] + gain[2] * away[2];
        let rates = self.governor.released(t, [y[0], y[1], y[2]], u + S::lift(self.push));
        dy[..3].copy_from_slice(&rates.unwrap_or([S::zero() / S::zero(); 3]));
        dy[3] = away[0] * away[0] + away[1] * away[1] + away[2] * away[2] + u * u;
    }
}

impl System for Closed {}

#[test]
fn the_stationary_solution_stabilises_the_governor_at_its_value() {
    // M2 = -rho M1/R: the wheel rests, A is constant, and Riccati's solution has a limit
    let data = steady(-0.5, 0.4);
    let rho = 0.4;
    let mut state = vec![0.0; 6];
    state.extend([rho, 0.0, 0.0, 0.0, 0.0]);
    let begun = run(&Backwards(data), &Span::new(400.0, 0.0, &state));
    let backwards = Backwards(data);
    let regulator = backwards.regulator(0.0, rho);
    let value = symmetric(&begun);
    let left = regulator.riccati(value);
    assert!(left.iter().flatten().all(|rate| rate.abs() < 1e-8), "{left:?}");
    let push = data.control_force(0.0, rho, SPEED);
    let closed = Closed { governor: data, rho, regulator, value, push };
    let start = [1e-4, -2e-4, 1e-4];
    let end = run(&closed, &Span::new(0.0, 60.0, &[SPEED + start[0], rho + start[1], start[2], 0.0]));
    assert!((end[0] - SPEED).abs() < 1e-9 && (end[1] - rho).abs() < 1e-9, "{end:?}");
    // V is quadratic: the cost differs from it by the third order
    let expected = quadratic(value, start);
    assert!((end[3] / expected - 1.0).abs() < 5e-3, "{} and {expected}", end[3]);
}

#[test]
fn the_map_of_stability_is_bounded_by_hurwitz_curve() {
    for map in derivations::governors::stability() {
        assert!(map.distance < 1e-6, "{}: {}", map.title, map.distance);
        let stable = map.rows.iter().flatten().filter(|stable| **stable).count();
        for (r, row) in map.rows.iter().enumerate() {
            let load = map.y.1[1] * (r as f64 + 0.5) / map.rows.len() as f64;
            // the curve has four points a column
            let agrees =
                row.iter().zip(map.curve.iter().skip(1).step_by(4)).all(|(stable, at)| *stable == (load < at.1));
            assert!(agrees, "{}: row {r}", map.title);
        }
        let all = map.rows.iter().map(Vec::len).sum::<usize>();
        assert!(stable > all / 20 && stable < all - all / 20, "{}: {stable} of {all}", map.title);
    }
}

#[test]
fn the_drawn_series_converge_faster_the_higher_the_speed() {
    let errors = derivations::governors::series_errors();
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
        moments: [Moment::constant(2.0), Moment::constant(1.0)],
        push: 0.0,
        lateral: 0.0,
    };
    let at = |t: f64| {
        let rho = 1.0 + 1.5 * t;
        let drift = data.programme(0.0, rho, 1.0);
        data.first_approximation(0.0, [1.0, rho, drift]).expect("real masses")
    };
    assert!((data.programme(0.0, 1.0, 1.0) - 1.5_f64).abs() < 1e-15);
    let (now, h) = (at(0.0), 1e-5);
    let second = |t: f64| at(t).apply(at(t).control).map(|entry| -entry);
    let rate: [f64; 3] = std::array::from_fn(|i| (second(h)[i] - second(-h)[i]) / (2.0 * h));
    let turned = now.apply(second(0.0));
    assert!((rate[0] - turned[0]).abs() < 1e-9, "L3 vanishes: {} and {}", rate[0], turned[0]);
    let leaving = ConstantMoments { epsilon: 1.0, of_second: 1.0, of_first: 0.0, start: 1.0 };
    assert_eq!(leaving.distance(4.0), Some(3.0), "past the edge of a disc of radius 2");
}
