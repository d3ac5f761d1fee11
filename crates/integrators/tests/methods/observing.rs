//! Outputs, monitors and progress of a run.

use crate::problems::{Drive, Kepler, Pendulum, distance};
use dalembert_integrators::{Method, Progress, Record, Samples, Span, Tolerance, integrate};

const METHODS: [Method; 10] = [
    Method::Rodas4,
    Method::DormandPrince5,
    Method::DormandPrince8,
    Method::Verner6,
    Method::Verner9,
    Method::Radau5,
    Method::Kvaerno5,
    Method::GraggBulirschStoer,
    Method::Gauss { stages: 4 },
    Method::RadauIIA { stages: 4 },
];

#[test]
fn every_output_is_as_accurate_as_the_end() {
    let ellipse = Kepler { eccentricity: 0.3 };
    let span = Span::new(0.0, 5.0, &ellipse.state::<f64>(0.0)).with_even_outputs(50);
    for method in METHODS {
        let mut record = Record::new();
        assert!(integrate(&ellipse, method, &Tolerance::both(1e-9), &span, &mut record).reached());
        assert_eq!(record.times, span.outputs, "{method}");
        let errors = record.times.iter().zip(&record.states).map(|(t, y)| distance(y, &ellipse.state::<f64>(*t)));
        let largest = errors.fold(0.0, f64::max);
        assert!(largest < 3e-7, "{method}: {largest:.1e}");
    }
}

/// Two outputs lie within two of the steps; with 1000 outputs, many lie in each step.
#[test]
fn outputs_change_no_step_and_are_as_accurate_as_steps() {
    let ellipse = Kepler { eccentricity: 0.3 };
    let start = ellipse.state::<f64>(0.0);
    let fixed =
        [Method::Euler { steps: 300_000 }, Method::RungeKutta4 { steps: 400 }, Method::ImplicitMidpoint { steps: 997 }];
    for method in METHODS.into_iter().chain([Method::Taylor, Method::BaderDeuflhard]).chain(fixed) {
        let run = |outputs: usize| {
            let span = Span::new(0.0, 5.0, &start).with_even_outputs(outputs);
            let mut record = Record::new();
            let outcome = integrate(&ellipse, method, &Tolerance::both(1e-9), &span, &mut record);
            (outcome, record, span.outputs)
        };
        let (alone, _, _) = run(1);
        if !alone.reached() {
            assert_eq!(method, Method::Taylor);
            continue;
        }
        let end = distance(&alone.state, &ellipse.state::<f64>(5.0));
        for outputs in [2, 7, 1000] {
            let (outcome, record, times) = run(outputs);
            assert_eq!((&outcome.state, outcome.work.steps), (&alone.state, alone.work.steps), "{method}, {outputs}");
            assert_eq!(
                (outcome.work.rates, outcome.work.rejected),
                (alone.work.rates, alone.work.rejected),
                "{method}"
            );
            assert_eq!(record.times, times, "{method}");
            let errors = record.times.iter().zip(&record.states).map(|(t, y)| distance(y, &ellipse.state::<f64>(*t)));
            let largest = errors.fold(0.0, f64::max);
            assert!(largest < (2.0 * end).max(1e-7), "{method}, {outputs}: {largest:.1e}, at the end {end:.1e}");
        }
    }
}

#[test]
fn outputs_at_the_start_and_between_are_shown_at_their_exact_times() {
    let times = [0.0, 0.1, 0.7000000000000001, 1.0];
    let span = Span::new(0.0, 1.5, &[0.5]).with_outputs(&times);
    for method in METHODS.into_iter().chain([Method::RungeKutta4 { steps: 100 }]) {
        let mut seen = Vec::new();
        let outcome =
            integrate(&Drive, method, &Tolerance::both(1e-8), &span, &mut Samples(|t: f64, _: &[f64]| seen.push(t)));
        assert_eq!(seen, times, "{method}");
        assert_eq!(outcome.time, 1.5, "{method}");
    }
}

#[test]
fn a_run_backwards_returns_to_where_the_run_forwards_began() {
    for method in METHODS {
        let there = integrate(&Drive, method, &Tolerance::both(1e-9), &Span::new(-1.0, 4.0, &[0.5]), &mut ());
        let back = integrate(&Drive, method, &Tolerance::both(1e-9), &Span::new(4.0, -1.0, &there.state), &mut ());
        assert_eq!(back.time, -1.0);
        assert!((back.state[0] - 0.5).abs() < 1e-7, "{method}: {}", back.state[0]);
    }
}

#[test]
fn the_energy_of_a_pendulum_deviates_as_far_as_the_tolerance_lets_it() {
    let pendulum = Pendulum { frequency: 2.0 };
    for method in METHODS {
        let span = Span::new(0.0, 5.0, &[1.0, 0.0]).with_monitor("energy", |_, y: &[f64]| pendulum.energy(y));
        let outcome = integrate(&pendulum, method, &Tolerance::both(1e-8), &span, &mut ());
        let deviation = &outcome.deviations[0];
        assert_eq!((deviation.name.as_str(), deviation.first), ("energy", pendulum.energy(&[1.0, 0.0])));
        assert!(deviation.largest > 0.0 && deviation.largest < 1e-5, "{method}: {deviation:?}");
    }
}

#[test]
fn progress_grows_from_above_zero_to_one() {
    for method in METHODS {
        let mut fractions = Vec::new();
        let span = Span::new(0.0, 3.0, &[0.5]);
        integrate(&Drive, method, &Tolerance::both(1e-6), &span, &mut Progress(|done| fractions.push(done)));
        assert!(fractions.is_sorted() && fractions[0] > 0.0, "{method}: {fractions:?}");
        assert_eq!(fractions.last(), Some(&1.0), "{method}");
    }
}

#[test]
fn a_tolerance_by_component_is_the_same_in_any_units() {
    let ellipse = Kepler { eccentricity: 0.3 };
    let span = Span::new(0.0, 5.0, &ellipse.state::<f64>(0.0));
    for method in [Method::DormandPrince5, Method::DormandPrince8] {
        let same = integrate(&ellipse, method, &Tolerance::both(1e-8), &span, &mut ());
        let each = integrate(&ellipse, method, &Tolerance::scaled(1e-8, &[1.0; 4]), &span, &mut ());
        assert_eq!(same.state, each.state, "{method}");
        let uneven = integrate(&ellipse, method, &Tolerance::scaled(1e-8, &[1.0, 4.0, 0.25, 2.0]), &span, &mut ());
        assert!(distance(&uneven.state, &same.state) < 1e-5, "{method}");
    }
}
