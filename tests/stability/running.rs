//! The compiled equations: their Jacobian by dual numbers, and runs by the classical Runge-Kutta method.

use dalembert_derivations::systems::gyrostat::driven::Driven;
use dalembert_derivations::systems::gyrostat::forms::{Form, SecondForm};
use field::Tangent;
use integrators::spectrum;
use motor::{Machine, RotorState};
use nalgebra::Vector3;

pub type Law<M> = Driven<f64, SecondForm<f64>, M>;

/// The state of a steady motion: v in the axes of the form, no currents.
pub fn state<M: Machine<f64>>(law: &Law<M>, v: Vector3<f64>, w0: f64, rotor_speed: f64, angle: f64) -> Vec<f64> {
    let mut state: Vec<f64> = (v * w0).iter().chain(v.iter()).copied().collect();
    let slip = rotor_speed - law.machine.frame_speed();
    match law.machine.rotor() {
        RotorState::AngleAndSpeed => state.extend([angle, 0.0]),
        RotorState::Speed => state.push(slip),
        RotorState::Prescribed => {}
    }
    state.resize(law.dimension(), 0.0);
    state
}

/// The eigenvalues of the law's Jacobian, as (real, imaginary).
pub fn eigenvalues<M: Machine<f64>>(law: &Law<M>, state: &[f64]) -> Vec<(f64, f64)> {
    let size = state.len();
    let mut jacobian = vec![0.0; size * size];
    for j in 0..size {
        let slope = |i: usize| if i == j { 1.0 } else { 0.0 };
        let moving: Vec<_> = state.iter().enumerate().map(|(i, &y)| Tangent::moving(y, slope(i))).collect();
        let mut rates = vec![Tangent::fixed(0.0); size];
        law.rates(&moving, &mut rates);
        rates.iter().enumerate().for_each(|(i, rate)| jacobian[i * size + j] = rate.slope);
    }
    spectrum(size, &jacobian).expect("the iteration ends").iter().map(|z| (z.re, z.im)).collect()
}

/// The state after a number of steps of the classical Runge-Kutta method.
pub fn run<F: Form<f64>, M: Machine<f64>>(
    law: &Driven<f64, F, M>,
    mut y: Vec<f64>,
    step: f64,
    steps: usize,
) -> Vec<f64> {
    let rates = |y: &[f64]| {
        let mut dy = vec![0.0; y.len()];
        law.rates(y, &mut dy);
        dy
    };
    let moved = |y: &[f64], dy: &[f64], h: f64| -> Vec<f64> { y.iter().zip(dy).map(|(y, dy)| y + h * dy).collect() };
    for _ in 0..steps {
        let k1 = rates(&y);
        let k2 = rates(&moved(&y, &k1, 0.5 * step));
        let k3 = rates(&moved(&y, &k2, 0.5 * step));
        let k4 = rates(&moved(&y, &k3, step));
        for i in 0..y.len() {
            y[i] += step / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        }
    }
    y
}
