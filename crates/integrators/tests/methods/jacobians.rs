//! The Jacobian by forward differentiation, for more components than one evaluation has directions.

use crate::problems::{Chain, Drive};
use dalembert_integrators::{Jacobian, Ode};

#[test]
fn every_column_is_the_central_difference_of_the_rates() {
    let chain = Chain { bars: 11, frequency: 2.0 };
    let n = 22;
    let y: Vec<f64> = (0..n).map(|i| (0.7 * i as f64).sin()).collect();
    let mut matrix = vec![0.0; n * n];
    Jacobian::new(&chain).matrix(0.3, &y, &mut matrix);
    let step = 1e-5;
    for j in 0..n {
        let rates = |shift: f64| {
            let (mut moved, mut dy) = (y.clone(), vec![0.0; n]);
            moved[j] += shift;
            chain.rates(0.3, &moved, &mut dy);
            dy
        };
        let (above, below) = (rates(step), rates(-step));
        for i in 0..n {
            let difference = (above[i] - below[i]) / (2.0 * step);
            assert!((matrix[i * n + j] - difference).abs() < 1e-8, "row {i}, column {j}");
        }
    }
}

#[test]
fn the_slope_in_time_is_that_of_the_law() {
    let (t, y) = (0.8_f64, 0.5);
    let mut slopes = [0.0];
    Jacobian::new(&Drive).time_derivatives(t, &[y], &mut slopes);
    assert!((slopes[0] + t.sin() * y * y).abs() < 1e-15);
}
