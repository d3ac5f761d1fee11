//! Runs of the friction governors: programme, stability, optimal stabilisation, each by two methods.

mod elastic;
mod programme;
mod regulator;
mod servo;

use dalembert_derivations::systems::elastic_governor::ElasticGovernor;
use dalembert_derivations::systems::governor::constant::{ConstantTorques, ProgrammeEnd};
use dalembert_derivations::systems::governor::{Gearing, Governor, Torque};
use field::{Analytic, Over, Rational, Scalar};
use integrators::{Method, Ode, Span, System, Tolerance, integrate};
use mechanics::bellman::{Regulator, quadratic};

const SPEED: f64 = 2.0;

fn governor(moments: [Torque<f64>; 2]) -> Governor<f64> {
    Governor {
        inertia: [0.6, 0.5, 0.1],
        mass: 0.8,
        radius: 0.2,
        gearing: Gearing::Drum { radius: 0.5 },
        moments,
        push: 0.0,
        lateral: 0.3,
    }
}

fn steady(first: f64, second: f64) -> Governor<f64> {
    governor([Torque::constant(first), Torque::constant(second)])
}

fn constant(governor: &Governor<f64>, start: f64) -> ConstantTorques {
    let law = governor.small_parameter(SPEED).expect("a drum");
    ConstantTorques { epsilon: law.epsilon, of_second: law.of_second[0], of_first: law.of_first[0], start }
}

/// The distance rho along the programme.
struct Programme(Governor<f64>);

impl<S: Over<f64> + Analytic> Ode<S> for Programme {
    fn dimension(&self) -> usize {
        1
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        dy[0] = self.0.programme(t, y[0], S::lift(SPEED));
    }
}

impl System for Programme {}

fn run(system: &dyn System, span: Span<'_, f64>) -> Vec<f64> {
    // many times the evaluations that any of the runs needs: a law without a motion then ends with a failure, not with
    // endless steps
    let span = span.with_evaluations(100_000);
    let outcome = integrate(system, Method::DormandPrince8, &Tolerance::both(1e-13), &span, &mut ());
    assert_eq!(outcome.failure(), None);
    outcome.state
}
