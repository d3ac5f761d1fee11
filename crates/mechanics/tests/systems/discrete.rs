//! Single steps of methods applied to modes, with thresholds known from textbooks.

use algebra::complex::Rectangle;
use algebra::real::Enclosure;
use dalembert_mechanics::linear_stability::characteristic;
use dalembert_mechanics::one_step_stability::{Fates, HalfPlane, Judgement, Spectrum, StabilityFunction, Steps};
use field::Rational;

const BITS: usize = 192;

fn function(numerator: &[(i64, i64)], denominator: &[(i64, i64)]) -> StabilityFunction {
    let rational = |c: &[(i64, i64)]| c.iter().map(|(n, d)| Rational::new(*n, *d)).collect();
    StabilityFunction { numerator: rational(numerator), denominator: rational(denominator) }
}

fn euler() -> StabilityFunction {
    function(&[(1, 1), (1, 1)], &[(1, 1)])
}

fn runge_kutta_4() -> StabilityFunction {
    function(&[(1, 1), (1, 1), (1, 2), (1, 6), (1, 24)], &[(1, 1)])
}

fn backward_euler() -> StabilityFunction {
    function(&[(1, 1)], &[(1, 1), (-1, 1)])
}

fn midpoint() -> StabilityFunction {
    function(&[(1, 1), (1, 2)], &[(1, 1), (-1, 2)])
}

fn number(n: i64) -> Enclosure {
    Enclosure::integer(n, BITS)
}

fn cuts(fates: &Fates) -> Vec<f64> {
    fates.cuts.iter().map(Enclosure::to_f64).collect()
}

fn fates(place: &HalfPlane, function: &StabilityFunction) -> (Vec<f64>, Vec<i32>) {
    let found = Fates::of(place, function).expect("thresholds are apart");
    (cuts(&found), found.signs)
}

#[test]
fn a_centre_grows_under_euler_at_every_step_and_under_runge_kutta_beyond_the_root_of_eight() {
    let centre = HalfPlane::Imaginary(number(2));
    assert_eq!(fates(&centre, &euler()), (vec![], vec![1]));
    assert_eq!(fates(&centre, &runge_kutta_4()), (vec![8f64.sqrt() / 2.0], vec![-1, 1]));
    assert_eq!(fates(&centre, &backward_euler()), (vec![], vec![-1]));
    assert_eq!(fates(&centre, &midpoint()), (vec![], vec![0]));
}

#[test]
fn a_growing_mode_is_hidden_by_backward_euler_from_two_over_its_rate_on() {
    assert_eq!(fates(&HalfPlane::Real(number(4)), &backward_euler()), (vec![0.5], vec![1, -1]));
    let pair = HalfPlane::Pair(Rectangle { re: number(3), im: number(4) });
    // 2 a / |mu|^2
    assert_eq!(fates(&pair, &backward_euler()), (vec![6.0 / 25.0], vec![1, -1]));
    assert_eq!(fates(&pair, &midpoint()), (vec![], vec![1]));
}

#[test]
fn a_fading_mode_grows_under_explicit_methods_from_their_textbook_thresholds_on() {
    let real = HalfPlane::Real(number(-1));
    assert_eq!(fates(&real, &euler()), (vec![2.0], vec![-1, 1]));
    let (found, signs) = fates(&real, &runge_kutta_4());
    assert!((found[0] - 2.785_293_563_405_28).abs() < 1e-13 && signs == [-1, 1]);
    let pair = HalfPlane::Pair(Rectangle { re: number(-3), im: number(4) });
    assert_eq!(fates(&pair, &euler()), (vec![6.0 / 25.0], vec![-1, 1]));
}

/// The polynomial (mu + 1)(mu^2 + 2 mu + 5), by its companion matrix.
#[test]
fn all_modes_together_have_the_least_threshold_and_every_stretch_its_judgement() {
    let matrix = [[0, 1, 0], [0, 0, 1], [-5, -7, -3]].map(|row| row.map(number).to_vec());
    let polynomial: Vec<Enclosure> = characteristic(&matrix, &number(1)).into_iter().rev().collect();
    let spectrum = Spectrum::of(&polynomial, false).expect("all are simple");
    assert_eq!(spectrum.growing(), [0, 0]);
    let steps = Steps::of(&spectrum.modes, &euler()).expect("thresholds are apart");
    let ends: Vec<f64> = steps.cuts.iter().map(Enclosure::to_f64).collect();
    assert_eq!(ends, [0.4, 2.0]);
    let judged: Vec<_> = steps.stretches.iter().map(|stretch| (stretch.judgement, stretch.growing)).collect();
    assert_eq!(judged, [(Judgement::Correct, 0), (Judgement::Invents, 2), (Judgement::Invents, 3)]);
    assert_eq!(steps.at(0.3).map(|stretch| stretch.judgement), Some(Judgement::Correct));
    assert_eq!(steps.at(0.5).map(|stretch| stretch.judgement), Some(Judgement::Invents));
}

/// The polynomial mu^4 - 3 mu^2 - 4 = (mu^2 - 4)(mu^2 + 1).
#[test]
fn what_keeps_an_energy_has_its_eigenvalues_in_opposite_pairs() {
    let polynomial = [-4, 0, -3, 0, 1].map(number);
    let spectrum = Spectrum::of(&polynomial, true).expect("all are simple");
    assert_eq!(spectrum.growing(), [1, 2]);
    let steps = Steps::of(&spectrum.modes, &backward_euler()).expect("thresholds are apart");
    let judged: Vec<_> = steps.stretches.iter().map(|stretch| stretch.judgement).collect();
    assert_eq!(judged, [Judgement::Confuses, Judgement::Hides]);
    assert_eq!(steps.cuts[0].to_f64(), 1.0);
}

/// The polynomial mu^4 - 6 mu^2 + 25: mu^2 = 3 ± 4i, mu = ±(2 ± i).
#[test]
fn pairs_of_complex_squares_have_their_own_real_and_imaginary_parts() {
    let spectrum = Spectrum::of(&[25, 0, -6, 0, 1].map(number), true).expect("all are simple");
    let points: Vec<[f64; 2]> = spectrum.modes.iter().map(|mode| mode.place.point()).collect();
    assert_eq!(points, [[-2.0, 1.0], [2.0, 1.0]]);
}

#[test]
fn growth_changes_with_the_step_as_differences_of_it_do() {
    for function in [euler(), runge_kutta_4(), backward_euler(), midpoint()] {
        let at = |longer: f64| function.growth([-0.7 * longer, 0.4 * longer]);
        let by = 1e-5_f64;
        let difference = (at(by.exp()).0 - at((-by).exp()).0) / (2.0 * by);
        assert!((at(1.0).1 - difference).abs() < 1e-9, "{} for {difference}", at(1.0).1);
    }
}
