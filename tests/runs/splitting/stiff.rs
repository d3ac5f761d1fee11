//! Stiff windings: a negative substep in which their currents would grow is rejected, and the error of accepted steps
//! is moderate.

use super::runs::{self, split};
use integrators::{End, Failure, Method, Outcome, Span, Splitting, Tolerance, integrate};
use simulation::{Axes, Problem};

const TIME: f64 = 0.1;
/// The rate R2/L2 of the damper's windings, 1/s.
const RATE: f64 = 0.5 / 1e-6;

fn run(problem: &Problem, method: Method) -> Outcome<f64> {
    let span = Span::new(0.0, TIME, &problem.state);
    integrate(&*problem.law, method, &Tolerance::both(1e-10), &span, &mut ())
}

/// Accepted steps have a smaller error than the splitting of order 2, which has no negative substeps, at the same step
/// size.
#[test]
fn a_step_that_would_let_currents_grow_backwards_is_refused_by_name_before_it_is_taken() {
    let problem = runs::problem("stiff_damper", None, Axes::First);
    let exact = run(&problem, Method::RadauIIA { stages: 5 });
    assert!(exact.reached());
    for splitting in [Splitting::BlanesMoan4, Splitting::BlanesMoan6, Splitting::KahanLi8] {
        let (mut refused, mut taken) = (0, 0);
        for steps in (0..9).map(|k| 100 << k) {
            let (outcome, step) = (run(&problem, split(splitting, steps)), TIME / f64::from(steps));
            let grows = RATE * step * splitting.most_negative_substep();
            if let End::Stopped(Failure::GoesBack { at, step: asked, back, rate, most }) = outcome.end {
                assert!(grows > 2.0, "{splitting:?}, {steps} steps");
                assert_eq!((at, back), (0.0, splitting.most_negative_substep()));
                assert!((rate / RATE - 1.0).abs() < 1e-9 && (asked / step - 1.0).abs() < 1e-9);
                assert!((most * rate * back - 2.0).abs() < 1e-9 && most < step);
                assert_eq!(outcome.state, problem.state);
                refused += 1;
            } else {
                assert!(outcome.reached() && grows <= 2.0, "{splitting:?}, {steps} steps: {:?}", outcome.end);
                let second = run(&problem, split(Splitting::Strang, steps));
                let [error, bound] = [&outcome, &second].map(|run| runs::error(&run.state, &exact.state));
                assert!(error < bound, "{splitting:?}, {steps} steps, exp({grows:.2}): {error:.1e} and {bound:.1e}");
                taken += 1;
            }
        }
        assert!(refused > 0 && taken > 1, "{splitting:?}: {refused} refused, {taken} taken");
    }
}

/// The longest step that the message names is accepted, a longer one is not.
#[test]
fn the_longest_step_that_is_named_is_the_longest_that_is_taken() {
    let problem = runs::problem("stiff_damper", None, Axes::Second);
    for splitting in [Splitting::BlanesMoan4, Splitting::BlanesMoan6, Splitting::KahanLi8] {
        let most = 2.0 / (RATE * splitting.most_negative_substep());
        let ends = [0.999, 1.001].map(|by| {
            let span = Span::new(0.0, 10.0 * by * most, &problem.state);
            integrate(&*problem.law, split(splitting, 10), &Tolerance::both(1e-9), &span, &mut ()).end
        });
        assert!(ends[0] == End::Reached && ends[1] != End::Reached, "{splitting:?}: {ends:?}");
    }
}
