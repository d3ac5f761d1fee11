//! Solutions of (mu I - J) x = b with a real mu: the linear equations of implicit methods that solve stage by stage.

use super::condensation::Condensation;
use super::lu::Lu;

/// A Jacobian J, and the factorisation of mu I - J for one mu.
pub(crate) struct Shifted {
    condensation: Condensation,
    lu: Lu,
    mu: f64,
    room: Vec<f64>,
}

impl Shifted {
    /// Buffers for `states` states.
    pub fn new(states: usize) -> Self {
        let condensation = Condensation::new(states);
        Shifted { condensation, lu: Lu::new(states), mu: 0.0, room: vec![0.0; states] }
    }

    /// Sets J, given row by row.
    pub fn take(&mut self, jacobian: &[f64]) {
        self.condensation.take(jacobian);
    }

    /// Factorises mu I - J. Returns false if the matrix is singular or not finite.
    pub fn factorise(&mut self, mu: f64) -> bool {
        self.mu = mu;
        self.lu.factorise_shifted(mu, &self.condensation)
    }

    /// Replaces b by the solution x.
    pub fn solve(&mut self, b: &mut [f64]) {
        self.lu.solve_shifted(self.mu, &self.condensation, &mut self.room, b);
    }
}

#[cfg(test)]
mod tests {
    use super::Shifted;

    /// A mechanism with 5 coordinates, an integrator of one of them, and one independent state.
    #[test]
    fn systems_with_states_that_follow_others_are_solved() {
        let n = 12;
        let entry = |i: usize, j: usize| match i {
            0..5 => f64::from(u8::from(j == i + 5)),
            10 => f64::from(u8::from(j == 6)) * -3.0,
            _ => ((3 * i + 7 * j + 5 * i * j) as f64).sin() * if i.is_multiple_of(2) { 1e4 } else { 1.0 },
        };
        let jacobian: Vec<f64> = (0..n * n).map(|place| entry(place / n, place % n)).collect();
        let solution: Vec<f64> = (0..n).map(|j| 1.0 + j as f64).collect();
        let mut shifted = Shifted::new(n);
        shifted.take(&jacobian);
        for mu in [1e-3, 1.0, -40.0, 1e7] {
            assert!(shifted.factorise(mu));
            let row = |i: usize| (0..n).map(|j| -entry(i, j) * solution[j]).sum::<f64>() + mu * solution[i];
            let mut x: Vec<f64> = (0..n).map(row).collect();
            shifted.solve(&mut x);
            for (x, exact) in x.iter().zip(&solution) {
                assert!((x - exact).abs() < 1e-8, "{mu}: {x} for {exact}");
            }
        }
    }

    #[test]
    fn an_eigenvalue_is_refused() {
        let mut shifted = Shifted::new(2);
        shifted.take(&[0.0, 1.0, 4.0, 0.0]);
        assert!(!shifted.factorise(2.0));
    }
}
