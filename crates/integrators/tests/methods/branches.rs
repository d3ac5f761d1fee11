//! Branches of solutions: textbook examples of folds, their positions, and the stability on either side.

use dalembert_integrators::{
    BranchEnd, ContinuationSettings, Curve, Equilibria, Failure, Ode, System, continue_branch, spectrum,
};
use field::{Analytic, Over};

/// f(x, p) = 0 with its two derivatives.
struct Plane(fn(f64, f64) -> [f64; 3]);

impl Curve for Plane {
    fn unknowns(&self) -> usize {
        2
    }

    fn evaluate(&mut self, x: &[f64], residual: &mut [f64], matrix: &mut [f64]) -> Result<(), Failure> {
        let [f, by_x, by_p] = (self.0)(x[0], x[1]);
        (residual[0], matrix[0], matrix[1]) = (f, by_x, by_p);
        if f.is_finite() { Ok(()) } else { Err(Failure::LeftTheNumbers { at: x[1] }) }
    }
}

fn walk<'a>(sizes: &'a [f64], within: &'a dyn Fn(&[f64]) -> bool) -> ContinuationSettings<'a> {
    ContinuationSettings { sizes, parameter: sizes.len() - 1, step: 0.2, most: 400, within }
}

#[test]
fn a_circle_closes_and_its_folds_are_known_to_rounding() {
    let mut circle = Plane(|x, p| [x * x + p * p - 1.0, 2.0 * x, 2.0 * p]);
    let found = continue_branch(&mut circle, &[1.1, 0.0], &[0.0, 1.0], &walk(&[1.0; 2], &|_| true)).expect("a circle");
    assert_eq!(found.last, BranchEnd::Closed);
    let folds: Vec<&[f64]> = found.folds().map(|fold| &fold.x[..]).collect();
    assert_eq!(folds.len(), 2, "{folds:?}");
    for (fold, p) in folds.iter().zip([1.0, -1.0]) {
        assert!(fold[0].abs() < 1e-14 && (fold[1] - p).abs() < 1e-15, "{fold:?}");
    }
    let off = |x: &[f64]| (x[0].hypot(x[1]) - 1.0).abs();
    assert!(found.places.iter().all(|place| off(&place.x) < 1e-15));
}

#[test]
fn a_cubic_turns_back_twice_in_units_of_any_size() {
    // p = x^3 - 3 x has folds at x = -1, p = 2 and at x = 1, p = -2; here x is in units of 1e-6 and p in units of 1e6
    let mut cubic = Plane(|x, p| {
        let (x, p) = (x * 1e6, p * 1e-6);
        [p - x * x * x + 3.0 * x, (3.0 - 3.0 * x * x) * 1e6, 1e-6]
    });
    let within = |x: &[f64]| x[1].abs() < 1e7;
    let found =
        continue_branch(&mut cubic, &[-3e-6, -18e6], &[1.0, 0.0], &walk(&[1e-6, 1e6], &|_| true)).expect("a curve");
    let folds: Vec<&[f64]> = found.folds().map(|fold| &fold.x[..]).collect();
    assert_eq!(folds.len(), 2);
    for (fold, x) in folds.iter().zip([-1.0, 1.0]) {
        assert!((fold[0] * 1e6 - x).abs() < 1e-13 && (fold[1] * 1e-6 + 2.0 * x).abs() < 1e-14, "{fold:?}");
    }
    let bounded =
        continue_branch(&mut cubic, &[-2e-6, -2e6], &[1.0, 0.0], &walk(&[1e-6, 1e6], &within)).expect("a curve");
    assert_eq!(bounded.last, BranchEnd::Outside);
    assert!(bounded.places.iter().all(|place| within(&place.x)));
}

#[test]
fn where_the_equations_end_the_walk_stalls_and_where_there_is_none_it_does_not_begin() {
    let mut root = Plane(|x, p| [x - p.sqrt(), 1.0, -0.5 / p.sqrt()]);
    let found = continue_branch(&mut root, &[1.0, 1.0], &[0.0, -1.0], &walk(&[1.0; 2], &|_| true)).expect("a curve");
    let end = found.places.last().expect("the start at least");
    assert!(found.last == BranchEnd::Stalled && end.x[1] < 1e-3, "{:?} {end:?}", found.last);
    let mut none = Plane(|x, p| [x * x + p * p + 1.0, 2.0 * x, 2.0 * p]);
    assert_eq!(continue_branch(&mut none, &[1.0, 1.0], &[1.0, 0.0], &walk(&[1.0; 2], &|_| true)), None);
}

/// The equation x'' = p - sin x - 0.3 x', where p is a component of the state with zero rate.
struct Turned;

impl<S: Over<f64> + Analytic> Ode<S> for Turned {
    fn dimension(&self) -> usize {
        3
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        (dy[0], dy[1], dy[2]) = (y[1], y[2] - y[0].circle().sin - S::lift(0.3) * y[1], S::zero());
    }
}

impl System for Turned {}

#[test]
fn stability_is_exchanged_at_the_fold_of_a_pendulum_with_a_torque() {
    let mut rest = Equilibria::new(&Turned);
    let within = |x: &[f64]| x[0] < 3.0;
    let start = [0.0; 3];
    let found = continue_branch(&mut rest, &start, &[0.0, 0.0, 1.0], &walk(&[1.0; 3], &within)).expect("a branch");
    let fold = found.places.iter().position(|place| place.fold).expect("a fold");
    let at = &found.places[fold].x;
    assert!((at[2] - 1.0).abs() < 1e-15 && (at[0] - std::f64::consts::FRAC_PI_2).abs() < 1e-14, "{at:?}");
    for (number, place) in found.places.iter().enumerate() {
        let (n, matrix) = rest.linearised(&place.x);
        let largest = spectrum(n, &matrix).expect("two eigenvalues")[0].re;
        match place.fold {
            true => assert!(largest.abs() < 1e-14, "{largest:e}"),
            false => assert_eq!(largest > 0.0, number > fold, "{place:?}"),
        }
    }
}

#[test]
fn eigenvalues_are_those_of_the_companion_matrix() {
    // (z - 2)(z^2 + 2 z + 5)
    let found = spectrum(3, &[0.0, -1.0, 10.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]).expect("three");
    for (found, (re, im)) in found.iter().zip([(2.0, 0.0), (-1.0, 2.0), (-1.0, -2.0)]) {
        assert!((found.re - re).abs() < 1e-13 && (found.im - im).abs() < 1e-13, "{found}");
    }
    assert_eq!((spectrum(0, &[]), spectrum(1, &[f64::NAN]), spectrum(2, &[1.0])), (Some(vec![]), None, None));
}
