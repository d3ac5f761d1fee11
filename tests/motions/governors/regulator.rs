//! Optimal stabilisation: the cost of a run compared with the value from Riccati's equation.

use super::*;

/// Riccati's equation backwards in time together with the programme, and the optimal motion with its cost.
struct Backwards(Governor<f64>);

const WEIGHTS: [f64; 3] = [1.0, 1.0, 1.0];

impl Backwards {
    fn regulator<S: Over<f64> + Analytic>(&self, t: S, rho: S) -> Regulator<S, 3>
    where
        field::Tangent<S>: Over<f64>,
    {
        let speed = S::lift(SPEED);
        let drift = self.0.programme(t, rho, speed);
        let first = self.0.linearised(t, [speed, rho, drift]).expect("real masses");
        Regulator { matrix: first.matrix, control: first.control, weights: WEIGHTS.map(S::lift), price: S::one() }
    }
}

/// The state y = (C11, C12, C13, C22, C23, C33, rho_0, x, cost).
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
    let moments = [Torque { start: -0.5, growth: 0.1 }, Torque { start: 0.4, growth: 0.2 }];
    let data = governor(moments);
    let horizon = 3.0;
    let at_end = run(&Programme(data), Span::new(0.0, horizon, &[0.3]))[0];
    // C(T) = 0; the final position is free and determines the initial one
    let mut state = vec![0.0; 6];
    state.extend([at_end, 0.05, -0.03, 0.04, 0.0]);
    let begun = run(&Backwards(data), Span::new(horizon, 0.0, &state));
    let value = quadratic(symmetric(&begun), [begun[7], begun[8], begun[9]]);
    let cost = -begun[10];
    assert!((begun[6] - 0.3).abs() < 1e-11);
    assert!(cost > 0.0 && (value / cost - 1.0).abs() < 1e-10, "{value} and {cost}");
}

/// The nonlinear governor near a programme at rest, under a constant control law, with its cost.
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
    // M2 = -rho M1/R: the wheel is at rest, A is constant, and Riccati's solution has a limit
    let data = steady(-0.5, 0.4);
    let rho = 0.4;
    let mut state = vec![0.0; 6];
    state.extend([rho, 0.0, 0.0, 0.0, 0.0]);
    let begun = run(&Backwards(data), Span::new(400.0, 0.0, &state));
    let backwards = Backwards(data);
    let regulator = backwards.regulator(0.0, rho);
    let value = symmetric(&begun);
    let left = regulator.riccati(value);
    assert!(left.iter().flatten().all(|rate| rate.abs() < 1e-8), "{left:?}");
    let push = data.control_force(0.0, rho, SPEED);
    let closed = Closed { governor: data, rho, regulator, value, push };
    let start = [1e-4, -2e-4, 1e-4];
    let end = run(&closed, Span::new(0.0, 60.0, &[SPEED + start[0], rho + start[1], start[2], 0.0]));
    assert!((end[0] - SPEED).abs() < 1e-9 && (end[1] - rho).abs() < 1e-9, "{end:?}");
    // V is quadratic; the cost differs from it in third order
    let expected = quadratic(value, start);
    assert!((end[3] / expected - 1.0).abs() < 5e-3, "{} and {expected}", end[3]);
}
