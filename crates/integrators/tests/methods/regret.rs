//! Tests of the costs of methods and of their regret, the excess over the cheapest one.

use dalembert_integrators::{Regrets, Trial, cost};

fn trials(points: &[(f64, f64)]) -> Vec<Trial> {
    points.iter().map(|&(cost, error)| Trial { cost, error: Some(error) }).collect()
}

#[test]
fn a_cost_is_read_straight_between_two_points_where_both_axes_are_logarithms() {
    let trials = trials(&[(100.0, 1e-2), (1000.0, 1e-6)]);
    let between = cost(&trials, 1e-4).expect("between the points");
    assert!((between - 100.0 * 10f64.sqrt()).abs() < 1e-9);
    assert_eq!(cost(&trials, 1e-2), Some(100.0));
    assert!((cost(&trials, 1e-6).expect("the last point") - 1000.0).abs() < 1e-9);
}

#[test]
fn nothing_is_read_beyond_the_points_and_nothing_off_a_failure() {
    let mut trials = trials(&[(100.0, 1e-2), (1000.0, 1e-6)]);
    trials.push(Trial { cost: 10.0, error: None });
    trials.push(Trial { cost: f64::NAN, error: Some(1e-12) });
    assert_eq!(cost(&trials, 1e-7), None);
    assert_eq!(cost(&trials, 1.0), Some(100.0));
    assert_eq!(cost(&[], 1.0), None);
}

#[test]
fn a_method_that_does_more_for_a_looser_tolerance_is_taken_at_its_cheapest_point() {
    // here the cheaper run is also the more accurate one
    let trials = trials(&[(50.0, 1e-5), (100.0, 1e-3)]);
    assert_eq!(cost(&trials, 1e-4), Some(50.0));
}

#[test]
fn the_best_single_choice_serves_most_problems_and_regrets_least() {
    let regrets =
        Regrets::of(&[vec![Some(1.0), None, None], vec![Some(4.0), Some(3.0), None], vec![Some(2.0), Some(9.0), None]]);
    assert_eq!(regrets.best, [Some(0), Some(1), None]);
    assert_eq!((regrets.served(0), regrets.largest(0)), (1, Some(1.0)));
    assert_eq!((regrets.served(1), regrets.largest(1)), (2, Some(4.0)));
    assert_eq!((regrets.served(2), regrets.largest(2)), (2, Some(3.0)));
    assert_eq!(regrets.best_single_choice(), Some(2));
    assert_eq!(Regrets::of(&[]).best_single_choice(), None);
}
