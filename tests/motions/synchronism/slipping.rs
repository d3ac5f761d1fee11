//! Pull-in: periodic slipping motions, and the load below which there is none.

use super::{loaded, pendulum, scene};
use dalembert_derivations::studies::synchronism::branches::Slipping;
use dalembert_derivations::studies::synchronism::loaded::{Loaded, with_bars};
use dalembert_derivations::studies::synchronism::pull_in::Onset;
use integrators::{Method, Ode, Span, Tolerance, integrate, transition};
use std::f64::consts::PI;

/// The tolerance of the integration over one period.
const TOLERANCE: f64 = 1e-13;
/// The longest period for which rounding errors grow by less than a factor exp(10), in units of 1/frequency.
const SHORT: f64 = 10.0;

/// The least total braking torque M + f W for which the pendulum can slip, in units of the pull-out torque.
fn pull_in(damping: f64) -> (f64, Onset) {
    let motor = loaded(&pendulum(damping));
    let found = motor.out_of_step().expect("it slips");
    let least = found.pull_in(1.0 - motor.facts.friction).expect("under some load");
    (least.load + motor.facts.friction, least.by)
}

/// Tricomi's load for small damping d is 4 d/pi with an error of third order, since the relation is odd.
#[test]
fn for_small_damping_the_pull_in_is_that_of_the_work_along_the_separatrix_to_third_order() {
    let dampings = [0.05, 0.1, 0.2];
    let off = dampings.map(|damping| pull_in(damping).0 - 4.0 / PI * damping);
    for pair in off.windows(2) {
        let order = (pair[1] / pair[0]).log2();
        assert!((order - 3.0).abs() < 0.1, "order {order}: {off:?}");
    }
}

/// An independent method: the motion that leaves the unstable equilibrium is integrated until it falls back into the
/// next potential well or passes it.
fn by_the_unstable_motion(damping: f64) -> f64 {
    let motor = loaded(&pendulum(damping));
    let passes = |drag: f64| {
        let top = PI - drag.asin();
        let growth = -0.5 * damping + (0.25 * damping * damping + drag.asin().cos()).sqrt();
        // along the eigenvector, at a distance for which the next term of the expansion is below 1e-10
        let start = [-PI + drag.asin() - 1e-5, -1e-5 * growth, drag - motor.facts.friction];
        let outcome = integrate(
            &*motor.law,
            Method::DormandPrince8,
            &Tolerance::both(1e-13),
            &Span::new(0.0, 80.0, &start),
            &mut (),
        );
        assert!(outcome.reached());
        outcome.state[0] < -2.0 * PI - top
    };
    let (mut low, mut high) = (damping, 1.0);
    for _ in 0..34 {
        let middle = 0.5 * (low + high);
        if passes(middle) { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

#[test]
fn the_limit_of_ever_longer_turns_is_the_load_at_which_the_motion_from_one_balance_comes_to_the_next() {
    for damping in [0.1, 0.4, 0.8] {
        let (turns, motion) = (pull_in(damping).0, by_the_unstable_motion(damping));
        assert!((turns - motion).abs() < 2e-10, "{damping}: {turns:.12} and {motion:.12}");
    }
}

/// By Liouville's theorem the only multiplier for one turn of the motor without currents is exp(-d T) with its damping
/// d: along a motion the bracket [a, b] = a_1 b_2 - a_2 b_1 of two deviations decreases as exp(-d t), at every state.
#[test]
fn multipliers_are_what_friction_leaves_of_a_turn() {
    for damping in [0.05, 0.4] {
        let motor = loaded(&pendulum(damping));
        let found = motor.out_of_step().expect("it slips");
        for one in &found.motions {
            let known = (-damping * one.period).exp();
            let bound = error_of_the_multiplier(&motor, one);
            assert!((one.multiplier - known).abs() <= bound, "{one:?} {known} {bound:e}");
            // near the equilibrium the error grows as long as the motion remains there, and so does the bound
            assert!(one.period > SHORT || bound < 1e-6, "{one:?} {bound:e}");
        }
        assert!(found.motions.iter().all(Slipping::stable));
    }
}

/// A bound on the error of the multiplier. The multiplier is [f, u]/s at the end of a turn, where u is the deviation
/// that was a unit slip at the start, and f = (s, s'). With the tolerance e, a step has the error e |u| in u, and e
/// (1 + |y|) in the state y; the latter changes f by |Df| times as much. Every such error enters through a bracket with
/// f or with u, which only decreases until the end. Hence the error of N steps is below N e |u| (|f| + |Df|
/// (1 + |y|))/s. All factors are largest at the start of the turn, at the minimum of the field's energy.
fn error_of_the_multiplier(motor: &Loaded, one: &Slipping) -> f64 {
    let start = [&one.state[..], &[one.load]].concat();
    let found = transition(&*motor.law, &Tolerance::both(TOLERANCE), (0.0, one.period), &start).expect("a turn");
    let n = start.len();
    let u = found.matrix[1].hypot(found.matrix[n + 1]);
    let mut f = vec![0.0; n];
    Ode::<f64>::rates(&*motor.law, 0.0, &found.state, &mut f);
    // |Df| <= 1 + 1 + d: contributions of slip, field and friction
    let slopes = 2.0 + motor.facts.friction / motor.facts.field_speed;
    let size = 1.0 + found.state[0].hypot(found.state[1]);
    found.steps as f64 * TOLERANCE * u * (f[0].hypot(f[1]) + slopes * size) / f[0].abs()
}

/// For dampings above 1.19, where Tricomi's curve reaches the pull-out, slipping begins where the synchronous
/// equilibria end.
#[test]
fn strong_damping_leaves_no_hysteresis() {
    assert_eq!(pull_in(1.25), (1.0, Onset::PullOut));
    let (below, by) = pull_in(1.1);
    assert!(below < 0.999 && below > 0.98 && by == Onset::Balance, "{below} {by:?}");
    let motor = loaded(&pendulum(1.25));
    assert!(motor.out_of_step().expect("it slips").motions.iter().all(Slipping::stable));
}

/// The torque of three or more bars is Kloss' torque, and the slipping motions have folds at its extrema.
#[test]
fn damper_bars_raise_the_pull_in_and_leave_the_pull_out() {
    let scene = scene("bench");
    let with = |bars: usize| {
        let motor = loaded(&with_bars(&scene, bars).expect("it has bars"));
        let all = motor.in_step();
        let pull_out = Loaded::pull_out(&all).expect("it holds").load;
        assert!((pull_out - 0.135).abs() < 1e-13, "{bars} bars: {pull_out}");
        let found = motor.out_of_step().expect("it slips");
        let least = found.pull_in(pull_out).expect("it slips under some load");
        // between the two loads some slipping motion is stable
        let between = motor.slipping_under(0.5 * (least.load + pull_out), &found).expect("they are followed");
        assert!(between.iter().any(Slipping::stable), "{between:?}");
        let below = motor.slipping_under(least.load - 1e-3, &found).expect("they are followed");
        assert!(!below.iter().any(Slipping::stable), "{below:?}");
        (least.load, found.limit.expect("long turns"))
    };
    let loads = [0, 1, 2, 3, 8].map(with);
    assert!(loads.windows(2).all(|pair| pair[0].0 < pair[1].0 && pair[0].1 < pair[1].1), "{loads:?}");
}
