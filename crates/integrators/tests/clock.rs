//! The time limit of the process ends every run, whatever the run's own limits. It can be set only once, hence this
//! separate program.

use dalembert_integrators::{Failure, Method, Ode, Span, System, Tolerance, clock, integrate};
use field::Scalar;
use std::time::Instant;

/// The oscillator y'' = -y.
struct Swinging;

impl<S: Scalar> Ode<S> for Swinging {
    fn dimension(&self) -> usize {
        2
    }

    fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
        (dy[0], dy[1]) = (y[1], -y[0]);
    }
}

impl System for Swinging {}

const METHODS: [Method; 8] = [
    Method::RungeKutta4 { steps: 10_000_000 },
    Method::DormandPrince8,
    Method::Verner9,
    Method::GraggBulirschStoer,
    Method::Radau5,
    Method::Rodas4,
    Method::Gauss { stages: 3 },
    Method::RadauIIA { stages: 3 },
];

fn failures() -> Vec<Option<Failure>> {
    let span = Span::new(0.0, 1e6, &[1.0, 0.0]);
    METHODS.map(|method| integrate(&Swinging, method, &Tolerance::both(1e-8), &span, &mut ()).failure()).into()
}

#[test]
fn every_run_ends_when_the_time_of_the_process_is_over_and_when_the_user_asks() {
    assert!(clock::over().is_none() && !clock::was_obeyed());
    clock::set_deadline(Instant::now());
    let late = failures();
    assert!(late.iter().all(|failure| matches!(failure, Some(Failure::OutOfTime { .. }))), "{late:?}");
    clock::request_end();
    let asked = failures();
    assert!(asked.iter().all(|failure| matches!(failure, Some(Failure::Interrupted { .. }))), "{asked:?}");
    assert!(clock::was_obeyed());
}
