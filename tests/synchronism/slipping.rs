//! Pull-in: motions that slip turn after turn, and the load below which there is none.

use super::{loaded, pendulum, scene};
use derivations::synchronism::branches::Slipping;
use integrators::{Method, Span, Tolerance, integrate};
use std::f64::consts::PI;

/// The drag M + f W from which on the pendulum can slip, in units of what holds.
fn pull_in(damping: f64) -> f64 {
    let motor = loaded(&pendulum(damping));
    let found = motor.out_of_step().expect("it slips");
    found.least().expect("under some load") + motor.facts.friction
}

/// Tricomi's load for small damping is 4/pi of it, with an error of the third order: the equation is odd in both.
#[test]
fn for_small_damping_the_pull_in_is_that_of_the_work_along_the_separatrix_to_third_order() {
    let dampings = [0.05, 0.1, 0.2];
    let off = dampings.map(|damping| pull_in(damping) - 4.0 / PI * damping);
    for pair in off.windows(2) {
        let order = (pair[1] / pair[0]).log2();
        assert!((order - 3.0).abs() < 0.1, "order {order}: {off:?}");
    }
}

/// The second route: the motion that leaves the balance, run until it falls back into the next well or passes it.
fn by_the_unstable_motion(damping: f64) -> f64 {
    let motor = loaded(&pendulum(damping));
    let passes = |drag: f64| {
        let top = PI - drag.asin();
        let growth = -0.5 * damping + (0.25 * damping * damping + drag.asin().cos()).sqrt();
        // along the eigenvector, so far that the next term of the motion is below 1e-10
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
        let (turns, motion) = (pull_in(damping), by_the_unstable_motion(damping));
        assert!((turns - motion).abs() < 2e-9, "{damping}: {turns:.12} and {motion:.12}");
    }
}

/// Beyond the damping 1.19 (Tricomi's curve meets the pull-out) slipping begins where standing ends.
#[test]
fn strong_damping_leaves_no_hysteresis() {
    let motor = loaded(&pendulum(1.4));
    let found = motor.out_of_step().expect("it slips");
    let least = found.least().expect("under some load") + motor.facts.friction;
    assert!((1.0..1.1).contains(&least) && found.limit.is_none(), "{least} {:?}", found.limit);
    assert!(found.motions.iter().all(Slipping::stable));
    let below = pull_in(1.1);
    assert!(below < 1.0 && below > 0.98, "{below}");
}

#[test]
fn damper_bars_raise_the_pull_in_and_leave_the_pull_out() {
    let motor = loaded(&scene("bench"));
    let with = |bars: usize| {
        let motor = motor.with_bars(bars).expect("it has bars").expect("they make a motor");
        let found = motor.out_of_step().expect("it slips");
        println!(
            "{bars} bars: least {:?}, limit {:?}, {} motions, slips {:.1}..{:.1}, folds {:?}",
            found.least(),
            found.limit,
            found.motions.len(),
            found.motions[0].slip(),
            found.motions.last().unwrap().slip(),
            found.motions.iter().filter(|m| m.fold).map(|m| (m.slip(), m.load)).collect::<Vec<_>>()
        );
        found.least().expect("it slips under some load")
    };
    let loads = [0, 1, 2, 3, 8].map(with);
    assert!(loads.windows(2).all(|pair| pair[0] < pair[1]), "{loads:?}");
}
