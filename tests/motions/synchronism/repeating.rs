//! Periodic motions by shooting, compared with closed forms.

use field::{Analytic, Over};
use integrators::{ContinuationSettings, Ode, PeriodicMotions, System, continue_branch};
use simulation::CompiledLaw;
use std::f64::consts::TAU;

/// The law x' = x (p - r^2) - y, y' = y (p - r^2) + x: the circle r^2 = p is a periodic motion with the period 2 pi and
/// the multiplier exp(-4 pi p).
struct Circular;

impl<S: Over<f64> + Analytic> Ode<S> for Circular {
    fn dimension(&self) -> usize {
        3
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        let room = y[2] - y[0] * y[0] - y[1] * y[1];
        (dy[0], dy[1], dy[2]) = (y[0] * room - y[1], y[1] * room + y[0], S::zero());
    }
}

/// The law g'' = -p - d g' with d = 0.5: without a field the slip is -p/d, and the multiplier of a turn is exp(-d T).
struct Uniform;

impl<S: Over<f64> + Analytic> Ode<S> for Uniform {
    fn dimension(&self) -> usize {
        3
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        (dy[0], dy[1], dy[2]) = (y[1], -y[2] - y[1].half(), S::zero());
    }
}

#[test]
fn a_limit_cycle_is_followed_with_its_period_and_multiplier() {
    let law = CompiledLaw::new(Circular);
    let law: &dyn System = &law;
    let mut turns = PeriodicMotions::new(law, 1e-14, &[0.0, 0.0], (1, 0.0));
    let within = |x: &[f64]| x[2] < 0.3;
    let walk = ContinuationSettings { sizes: &[0.1, 1.0, 0.1], parameter: 2, step: 0.5, most: 50, within: &within };
    let found = continue_branch(&mut turns, &[0.2, 6.0, 0.04], &[0.0, 0.0, 1.0], &walk).expect("a cycle");
    assert!(found.places.len() > 3 && found.folds().count() == 0);
    for place in &found.places {
        let (start, period) = turns.motion(&place.x);
        let p = start[2];
        assert!((start[0] - p.sqrt()).abs() < 1e-12 && (period - TAU).abs() < 1e-11, "{start:?} {period}");
        let (n, matrix) = turns.returning(&place.x).expect("a turn");
        assert!(n == 1 && (matrix[0] - (-2.0 * TAU * p).exp()).abs() < 1e-12, "{matrix:?}");
    }
}

#[test]
fn a_rotation_is_a_motion_that_repeats_but_for_a_turn() {
    let law = CompiledLaw::new(Uniform);
    let law: &dyn System = &law;
    let mut turns = PeriodicMotions::new(law, 1e-14, &[-TAU, 0.0], (0, 0.3));
    let walk = ContinuationSettings { sizes: &[1.0; 3], parameter: 2, step: 0.5, most: 12, within: &|_| true };
    let found = continue_branch(&mut turns, &[3.0, -2.0, 1.2], &[1.0, 0.0, 0.0], &walk).expect("rotations");
    assert_eq!(found.places.len(), 12);
    for place in &found.places {
        let (start, period) = turns.motion(&place.x);
        assert!((start[1] + 2.0 * start[2]).abs() < 1e-12 && (start[1] * period + TAU).abs() < 1e-11, "{start:?}");
        let (n, matrix) = turns.returning(&place.x).expect("a turn");
        assert!(n == 1 && (matrix[0] - (-0.5 * period).exp()).abs() < 1e-12, "{matrix:?}");
    }
}
