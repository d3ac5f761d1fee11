//! Orders of splittings on nonlinear motions, compared with references by another family of methods; symmetry: a
//! backward run inverts a forward run.

use super::runs::{self, SCENES, error, split};
use field::DoubleDouble;
use integrators::{End, Failure, Method, Refusal, Span, Splitting, Tolerance, integrate, integrate_in};
use simulation::{Axes, Problem};

const TIME: f64 = 0.5;

fn after(problem: &Problem, splitting: Splitting, steps: u32, [from, to]: [f64; 2], state: &[f64]) -> Vec<f64> {
    let outcome = runs::run(problem, split(splitting, steps), &Span::new(from, to, state));
    outcome.state
}

/// The final state by Gauss' collocation in double-double.
fn exact(problem: &Problem) -> Vec<f64> {
    let twice: Vec<DoubleDouble> = problem.state.iter().map(|y| DoubleDouble::from(*y)).collect();
    let (gauss, span) = (Method::Gauss { stages: 8 }, Span::new(0.0, TIME, &twice));
    let outcome = integrate_in(&*problem.law, gauss, &Tolerance::both(1e-18), &span, &mut ());
    assert!(outcome.reached(), "{:?}", outcome.end);
    outcome.state.iter().map(|y| y.hi()).collect()
}

#[test]
fn every_composition_has_its_order_with_every_kind_of_motor_in_both_forms() {
    for (name, model) in SCENES {
        for axes in [Axes::First, Axes::Second] {
            let problem = runs::problem(name, model, axes);
            let exact = exact(&problem);
            for splitting in Splitting::ALL {
                // double the number of steps until the error is small, but far above rounding
                let small = match splitting {
                    Splitting::Strang => 1e-5,
                    Splitting::KahanLi8 => 1e-7,
                    _ => 1e-8,
                };
                let span = Span::new(0.0, TIME, &problem.state);
                let run = |steps| {
                    let method = split(splitting, steps);
                    let outcome = integrate(&*problem.law, method, &Tolerance::both(1e-9), &span, &mut ());
                    // a step may be too long for an iteration to converge
                    if outcome.reached() { error(&outcome.state, &exact) } else { f64::INFINITY }
                };
                let steps = (0..14).map(|k| 10 << k).find(|steps| run(*steps) < small).expect("it converges");
                let pair = [run(steps), run(2 * steps)];
                let (order, theory) = ((pair[0] / pair[1]).log2(), f64::from(splitting.order()));
                let what = format!("{name} {model:?} {axes} {}", splitting.name());
                // the limits -0.5 and +1 distinguish even orders
                assert!(
                    (-0.5..1.0).contains(&(order - theory)),
                    "{what}: {:.1e} {:.1e}, order {order:.2}",
                    pair[0],
                    pair[1]
                );
            }
        }
    }
}

/// A composition is symmetric: its step with -h is the inverse of the step with h, also with friction.
#[test]
fn a_run_back_undoes_a_run_to_rounding() {
    for (name, model) in SCENES {
        let problem = runs::problem(name, model, Axes::First);
        for splitting in Splitting::ALL {
            let steps = 400;
            let there = after(&problem, splitting, steps, [0.0, 0.1], &problem.state);
            let back = after(&problem, splitting, steps, [0.1, 0.0], &there);
            let far = error(&there, &problem.state);
            let left = error(&back, &problem.state);
            assert!(far > 1e-3 && left < 1e-11, "{name} {model:?} {}: {far:.1e} {left:.1e}", splitting.name());
        }
    }
    // for comparison: an explicit Runge-Kutta method is not symmetric
    let problem = runs::problem("free_rotor", None, Axes::First);
    let kutta = |span: Span<'_, f64>| runs::run(&problem, Method::RungeKutta4 { steps: 10 }, &span).state;
    let back = kutta(Span::new(0.1, 0.0, &kutta(Span::new(0.0, 0.1, &problem.state))));
    assert!(error(&back, &problem.state) > 1e-9);
}

#[test]
fn in_double_double_only_what_is_known_to_as_many_digits_runs() {
    let problem = runs::problem("free_rotor", None, Axes::First);
    let twice: Vec<DoubleDouble> = problem.state.iter().map(|y| DoubleDouble::from(*y)).collect();
    let exact = exact(&problem);
    let refused = End::Stopped(Failure::Refused(Refusal::Field));
    for splitting in Splitting::ALL {
        let span = Span::new(0.0, TIME, &twice);
        let outcome = integrate_in(&*problem.law, split(splitting, 2000), &Tolerance::both(1e-9), &span, &mut ());
        assert_eq!(outcome.end == refused, !splitting.exact(), "{}", splitting.name());
        if splitting == Splitting::KahanLi8 {
            let state: Vec<f64> = outcome.state.iter().map(|y| y.hi()).collect();
            assert!(error(&state, &exact) < 1e-15);
        }
    }
}

/// The flow at constant position solves for a nonlinear torque by iteration; for a step that is far too long it fails
/// with a named reason.
#[test]
fn a_step_too_long_for_the_iteration_fails_by_name() {
    let problem = runs::problem("asynchronous_drive", None, Axes::First);
    let span = Span::new(0.0, 1e4, &problem.state);
    let outcome = integrate(&*problem.law, split(Splitting::Strang, 1), &Tolerance::both(1e-9), &span, &mut ());
    assert!(matches!(outcome.end, End::Stopped(Failure::NewtonFailed { .. })), "{:?}", outcome.end);
}
