//! Nanoseconds for one right-hand side, for its whole Jacobian as sums of monomials, and for eight directions of it by
//! num-dual, of the gyrostat with 8 states (synchronous motor) and 15 (six damper bars), in both forms; and operations,
//! circle points apart: `cargo bench --bench rates`.

use derivations::machines::Machine;
use derivations::machines::multi_current::{MultiCurrent, Windings};
use derivations::machines::synchronous::Synchronous;
use derivations::systems::gyrostat::driven::Driven;
use derivations::systems::gyrostat::forms::Form;
use derivations::systems::gyrostat::{Carrier, Gyrostat, Rotor};
use field::{Analytic, Over};
use integrators::Directions;
use nalgebra::{Matrix3, Vector3};
use std::time::Instant;
use symbolic::{Polynomials, Sym, Tape};

const REPEATS: usize = 9;
const CALLS: u32 = 200_000;

fn main() {
    let gyrostat = Gyrostat {
        carrier: Carrier {
            mass: 1.5,
            centre: Vector3::new(0.01, -0.02, 0.05),
            inertia: Matrix3::new(0.02, 0.001, -0.002, 0.001, 0.03, 0.0005, -0.002, 0.0005, 0.025),
        },
        rotor: Rotor {
            mass: 0.4,
            centre: Vector3::new(0.0, 0.03, 0.04),
            axis: Vector3::new(2.0, -1.0, 2.0) / 3.0,
            axial: 3e-4,
            transverse: 2e-4,
        },
        gravity: 9.81,
    };
    let windings = Windings {
        field_speed: 300.0,
        b0: 0.5,
        a1: 0.01,
        l1: 0.01,
        r1: 1.0,
        a2: 0.01,
        l2: 0.01,
        r2: 1.0,
        mu: 1e-4,
        f: 1e-4,
    };
    let single = Synchronous { field_speed: windings.field_speed, b0: windings.b0, f: windings.f };
    let bars = MultiCurrent::evenly(windings, 6);
    let (first, second) = (gyrostat.first_form().0, gyrostat.second_form().0);
    println!("states form    value [ns]  flops   Jacobian [ns]  flops   eight directions [ns]");
    row("first", &Driven::new(first, single));
    row("second", &Driven::new(second, single));
    row("first", &Driven::new(first, bars.clone()));
    row("second", &Driven::new(second, bars));
}

fn row<F: Form<f64>, M: Machine<f64>>(form: &str, law: &Driven<f64, F, M>) {
    let n = law.dimension();
    let state: Vec<Sym> = (0..n).map(|i| Sym::symbol(&format!("y{i}"))).collect();
    let mut rates = vec![Sym::ZERO; n];
    law.rates(&state, &mut rates);
    let entries: Vec<Sym> = rates.iter().flat_map(|rate| state.iter().map(|&by| rate.diff(by))).collect();
    let (Ok(tape), Ok(jacobian)) = (Tape::record(&state, &rates), Polynomials::record(&state, &entries, n)) else {
        println!("{n:>6} {form:<7} is no polynomial");
        return;
    };
    let (value, directions) = (nanoseconds::<f64, F, M>(law), nanoseconds::<Directions, F, M>(law));
    let (whole, of_value, of_whole) = (whole(&jacobian, n), tape.flops(), jacobian.flops());
    println!("{n:>6} {form:<7} {value:>10.1} {of_value:>6} {whole:>15.1} {of_whole:>6} {directions:>23.1}");
}

/// The median over repeats of the mean over calls of the whole Jacobian.
fn whole(jacobian: &Polynomials, n: usize) -> f64 {
    let mut state: Vec<f64> = (0..n).map(|i| 0.1 + 0.05 * i as f64).collect();
    let (mut matrix, mut evaluation) = (vec![0.0; n * n], jacobian.ready());
    median(|| {
        evaluation.evaluate(&state, &mut matrix);
        state[0] += matrix[1] * 1e-15;
    })
}

/// The median over repeats of the mean over calls; each call depends on the one before.
fn nanoseconds<S: Over<f64> + Analytic, F: Form<f64>, M: Machine<f64>>(law: &Driven<f64, F, M>) -> f64 {
    let mut state: Vec<S> = (0..law.dimension()).map(|i| S::lift(0.1 + 0.05 * i as f64)).collect();
    let mut rates = state.clone();
    let tiny = S::lift(1e-15);
    median(|| {
        law.rates(&state, &mut rates);
        state[0] += rates[0] * tiny;
    })
}

fn median(mut call: impl FnMut()) -> f64 {
    let mut times: Vec<f64> = (0..REPEATS)
        .map(|_| {
            let start = Instant::now();
            for _ in 0..CALLS {
                call();
            }
            start.elapsed().as_secs_f64() * 1e9 / f64::from(CALLS)
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[REPEATS / 2]
}
