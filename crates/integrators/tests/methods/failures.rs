//! A run that cannot reach its end reports the reason, keeps its last valid state, and never panics.

use std::time::Instant;

use crate::problems::{Explosion, Funnel, Growth, Kaps, Pendulum};
use dalembert_integrators::{
    Absolute, Failure, Method, Ode, Outcome, Record, Refusal, Span, System, Tolerance, integrate,
};

const EXPLICIT: [Method; 5] =
    [Method::DormandPrince5, Method::DormandPrince8, Method::Verner6, Method::Verner9, Method::GraggBulirschStoer];

const ADAPTIVE: [Method; 11] = [
    Method::Rodas4,
    Method::BaderDeuflhard,
    Method::DormandPrince5,
    Method::DormandPrince8,
    Method::Verner6,
    Method::Verner9,
    Method::GraggBulirschStoer,
    Method::Radau5,
    Method::Kvaerno5,
    Method::Gauss { stages: 3 },
    Method::RadauIIA { stages: 3 },
];

fn run(system: &dyn System, method: Method, span: &Span<f64>) -> Outcome<f64> {
    let outcome = integrate(system, method, &Tolerance::both(1e-8), span, &mut ());
    assert!(outcome.state.iter().all(|y| y.is_finite()), "{method}: {:?}", outcome.state);
    outcome
}

fn refusal(tolerance: &Tolerance, span: &Span<f64>) -> Refusal {
    match integrate(&Pendulum { frequency: 1.0 }, Method::DormandPrince8, tolerance, span, &mut ()).failure() {
        Some(Failure::Refused(refusal)) => refusal,
        other => panic!("not refused: {other:?}"),
    }
}

#[test]
fn a_solution_that_explodes_stops_before_the_explosion() {
    for method in ADAPTIVE {
        let outcome = run(&Explosion, method, &Span::new(0.0, 2.0, &[1.0]));
        let failure = outcome.failure().unwrap_or_else(|| panic!("{method} passed the pole"));
        assert!(outcome.time > 0.99 && outcome.time < 1.0 + 1e-6, "{method}: {failure}");
    }
}

#[test]
fn a_solution_that_leaves_the_domain_of_its_law_is_named_so() {
    for method in ADAPTIVE {
        let outcome = run(&Funnel, method, &Span::new(0.0, 20.0, &[1.0]));
        assert!(matches!(outcome.failure(), Some(Failure::LeftTheNumbers { .. })), "{method}: {:?}", outcome.failure());
    }
}

/// Embedded pairs square the errors, and these squares overflow although rates and state do not.
#[test]
fn a_step_below_rounding_is_named_so_however_large_the_errors_are() {
    for method in [Method::DormandPrince5, Method::DormandPrince8] {
        let outcome = run(&Growth { rate: -1e200 }, method, &Span::new(0.0, 1.0, &[1.0, 0.0, -2.0]));
        let failure = outcome.failure();
        assert!(
            matches!(failure, Some(Failure::StepCollapsed { .. } | Failure::Stiff { .. })),
            "{method}: {failure:?}"
        );
    }
}

#[test]
fn both_pairs_find_a_stiff_problem_stiff() {
    for method in [Method::DormandPrince5, Method::DormandPrince8] {
        let outcome = run(&Kaps { lambda: 1e4 }, method, &Span::new(0.0, 10.0, &[1.0, 1.0]));
        assert!(matches!(outcome.failure(), Some(Failure::Stiff { .. })), "{method}: {:?}", outcome.failure());
        // a run whose limit of steps is small uses all of them
        let outcome = run(&Kaps { lambda: 1e3 }, method, &Span::new(0.0, 1.0, &[1.0, 1.0]));
        assert!(outcome.reached(), "{method}: {:?}", outcome.failure());
    }
}

#[test]
fn a_stiff_problem_spends_the_budget_of_an_explicit_method_or_is_called_stiff() {
    for method in EXPLICIT {
        let span = Span::new(0.0, 10.0, &[1.0, 1.0]).with_evaluations(50_000);
        let outcome = run(&Kaps { lambda: 1e6 }, method, &span);
        let named = matches!(outcome.failure(), Some(Failure::TooManyEvaluations { .. } | Failure::Stiff { .. }));
        assert!(named, "{method}: {:?}", outcome.failure());
        assert!(outcome.work.rates <= 50_000);
    }
}

#[test]
fn a_failing_run_keeps_the_samples_before_its_failure() {
    let span = Span::new(0.0, 2.0, &[1.0]).with_outputs(&[0.25, 0.5, 0.75, 1.5]);
    for method in ADAPTIVE {
        let mut record = Record::new();
        integrate(&Explosion, method, &Tolerance::both(1e-8), &span, &mut record);
        assert_eq!(record.times, [0.25, 0.5, 0.75], "{method}");
    }
}

#[test]
fn a_system_at_rest_stays_there() {
    for method in ADAPTIVE {
        let outcome = run(&Growth { rate: 0.0 }, method, &Span::new(0.0, 10.0, &[1.0, 0.0, -2.0]));
        assert!(outcome.reached(), "{method}: {:?}", outcome.failure());
        assert_eq!(outcome.state, [1.0, 0.0, -2.0], "{method}");
    }
}

#[test]
fn overflow_within_the_first_step_is_a_failure_with_a_name() {
    for method in ADAPTIVE {
        let outcome = run(&Growth { rate: 1e200 }, method, &Span::new(0.0, 10.0, &[1.0, 1.0, 1.0]));
        assert!(outcome.failure().is_some(), "{method}");
    }
}

#[test]
fn a_budget_of_any_size_is_kept() {
    for method in ADAPTIVE {
        for evaluations in [1, 2, 3, 10, 50] {
            let span = Span::new(0.0, 100.0, &[1.0, 0.0]).with_evaluations(evaluations);
            let outcome = run(&Pendulum { frequency: 1.0 }, method, &span);
            let at = outcome.time;
            let expected = Failure::TooManyEvaluations { at, allowed: evaluations };
            assert_eq!(outcome.failure(), Some(expected), "{method}");
            assert!(outcome.work.rates <= evaluations);
        }
    }
}

#[test]
fn a_deadline_that_has_passed_stops_the_run() {
    for method in ADAPTIVE {
        let span = Span::new(0.0, 1e5, &[1.0, 0.0]).with_deadline(Instant::now());
        let failure = run(&Pendulum { frequency: 1.0 }, method, &span).failure();
        assert!(matches!(failure, Some(Failure::OutOfTime { .. })), "{method}: {failure:?}");
    }
}

#[test]
fn a_method_with_impossible_stages_or_steps_is_refused() {
    let refused = |method| run(&Growth { rate: 0.0 }, method, &Span::new(0.0, 1.0, &[1.0; 3])).failure();
    let stages = |given| Some(Failure::Refused(Refusal::Stages { given, least: 1, most: 20 }));
    assert_eq!(refused(Method::Gauss { stages: 0 }), stages(0));
    assert_eq!(refused(Method::RadauIIA { stages: 21 }), stages(21));
    assert_eq!(refused(Method::Euler { steps: 0 }), Some(Failure::Refused(Refusal::Steps { given: 0 })));
}

#[test]
fn bad_data_are_refused_before_the_first_step() {
    let (fine, state) = (Tolerance::both(1e-6), [1.0, 0.0]);
    let span = || Span::new(0.0, 1.0, &state);
    assert_eq!(refusal(&fine, &Span::new(1.0, 1.0, &state)), Refusal::SpanEmpty { start: 1.0, end: 1.0 });
    assert!(matches!(refusal(&fine, &Span::new(0.0, f64::NAN, &state)), Refusal::SpanNotFinite { .. }));
    assert_eq!(refusal(&fine, &Span::new(0.0, 1.0, &[1.0])), Refusal::Dimension { expected: 2, found: 1 });
    let infinite = [0.0, f64::INFINITY];
    assert_eq!(refusal(&fine, &Span::new(0.0, 1.0, &infinite)), Refusal::StateNotFinite { component: 1 });
    assert!(matches!(refusal(&Tolerance::both(0.0), &span()), Refusal::Relative { .. }));
    assert!(matches!(refusal(&Tolerance::both(f64::NAN), &span()), Refusal::Relative { .. }));
    let zero = Tolerance { relative: 1e-6, absolute: Absolute::Same(0.0) };
    assert_eq!(refusal(&zero, &span()), Refusal::Absolute { given: 0.0 });
    assert!(matches!(refusal(&Tolerance::scaled(1e-6, &[1.0]), &span()), Refusal::AbsoluteCount { .. }));
    assert!(matches!(refusal(&fine, &span().with_outputs(&[0.5, 0.2])), Refusal::Output { index: 1, .. }));
    assert!(matches!(refusal(&fine, &span().with_outputs(&[1.5])), Refusal::Output { index: 0, .. }));
    assert_eq!(refusal(&fine, &span().with_evaluations(0)), Refusal::NoBudget);
}

/// The oscillator x'' = -w^2 x: the Lipschitz constant of a step may be near w^2, but the eigenvalue is w, and accuracy
/// requires steps far below the stability limit.
#[test]
fn fast_oscillations_that_accuracy_resolves_are_not_stiff() {
    struct Fast;
    impl<S: field::Scalar> Ode<S> for Fast {
        fn dimension(&self) -> usize {
            2
        }

        fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
            dy[0] = y[1];
            dy[1] = -S::int(100_000_000) * y[0];
        }
    }
    impl System for Fast {}
    for method in [Method::DormandPrince5, Method::DormandPrince8] {
        let span = Span::new(0.0, 1.0, &[1e-5, 0.0]);
        let outcome = integrate(&Fast, method, &Tolerance::both(1e-11), &span, &mut ());
        assert_eq!(outcome.failure(), None, "{method}");
        assert!((outcome.state[0] - 1e-5 * 1e4_f64.cos()).abs() < 1e-7, "{method}");
    }
}
