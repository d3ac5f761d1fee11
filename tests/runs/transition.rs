//! The state-transition matrix of a run, compared with differences of runs in double-double by another method.

use dalembert_derivations::studies::AnyScene;
use field::{Analytic, DoubleDouble, Over};
use integrators::{Method, Ode, Span, System, Tolerance, integrate_in, transition};
use reader::Family;
use simulation::{Axes, Choice, CompiledLaw, Problem};
use std::path::Path;

const SPAN: f64 = 0.3;

fn problem(scene: &str) -> Problem {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(scene);
    match AnyScene::open(&path) {
        Ok(AnyScene::Driven(scene)) => scene.problem(Axes::Second),
        _ => panic!("{scene} is a scene of a gyrostat"),
    }
}

/// The final state of the run from these initial values, in double-double.
fn end(law: &dyn System, start: &[DoubleDouble]) -> Vec<DoubleDouble> {
    let span = Span::new(0.0, SPAN, start);
    let outcome = integrate_in(law, Method::GraggBulirschStoer, &Tolerance::both(1e-24), &span, &mut ());
    assert!(outcome.reached());
    outcome.state
}

#[test]
fn the_transition_matrix_has_the_slopes_of_the_end_by_the_beginning() {
    for scene in ["spin_up.toml", "pull_out.toml", "asynchronous_drive.toml"] {
        let Problem { law, state, .. } = problem(scene);
        let n = Ode::<f64>::dimension(&*law);
        let found = transition(&*law, &Tolerance::both(1e-13), (0.0, SPAN), &state).expect("a series");
        let exact: Vec<DoubleDouble> = state.iter().map(|&y| DoubleDouble::from(y)).collect();
        for j in 0..n {
            let step = DoubleDouble::from(1e-9);
            let moved = |by: DoubleDouble| {
                let mut start = exact.clone();
                start[j] += by;
                end(&*law, &start)
            };
            let (ahead, behind) = (moved(step), moved(-step));
            let column: Vec<f64> = ahead.iter().zip(&behind).map(|(a, b)| ((*a - *b) / (step + step)).hi()).collect();
            let size = column.iter().fold(0.0_f64, |size, slope| size.max(slope.abs()));
            for (i, slope) in column.iter().enumerate() {
                let error = (found.matrix[i * n + j] - slope).abs() / size;
                assert!(error < 1e-11, "{scene}: row {i}, column {j}: {error:.1e}");
            }
        }
    }
}

#[test]
fn there_and_back_the_matrices_are_inverse() {
    let Problem { law, state, .. } = problem("spin_up.toml");
    let n = state.len();
    let there = transition(&*law, &Tolerance::both(1e-13), (0.0, SPAN), &state).expect("a series");
    let back = transition(&*law, &Tolerance::both(1e-13), (SPAN, 0.0), &there.state).expect("a series");
    for i in 0..n {
        for j in 0..n {
            let entry: f64 = (0..n).map(|k| back.matrix[i * n + k] * there.matrix[k * n + j]).sum();
            let size: f64 = (0..n).map(|k| (back.matrix[i * n + k] * there.matrix[k * n + j]).abs()).sum();
            let unit = if i == j { 1.0 } else { 0.0 };
            assert!((entry - unit).abs() <= 1e-10 * size.max(1.0), "{i} {j}: {entry}");
        }
    }
}

#[test]
fn in_the_axes_of_the_data_the_matrix_keeps_the_length_of_the_vertical() {
    for axes in [Axes::First, Axes::Second] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/spin_up.toml");
        let Ok(AnyScene::Driven(scene)) = AnyScene::open(&path) else { panic!("a gyrostat") };
        let problem = scene.problem(axes);
        let run = problem.simulate(&Choice { tolerance: 1e-12, axes, ..scene.choice() }, |_| {});
        let matrix = problem.transition(1e-12).expect("a series");
        let (first, last) = (&run.rows[0], &run.last);
        // d(v.v) = 0 for every change of the initial state that does not change v.v: v(end) M = v(start) in the columns
        // of v
        for j in 0..matrix.len() {
            let carried: f64 = (3..6).map(|i| last[i] * matrix[i][j]).sum();
            let wanted = if (3..6).contains(&j) { first[j] } else { 0.0 };
            assert!((carried - wanted).abs() < 1e-9, "{axes:?}, column {j}: {carried} is not {wanted}");
        }
    }
}

/// The law x' = y, y' = x.
struct Saddle;

impl<S: Over<f64> + Analytic> Ode<S> for Saddle {
    fn dimension(&self) -> usize {
        2
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        (dy[0], dy[1]) = (y[1], y[0]);
    }
}

/// The law z' = cos t.
struct Carried;

impl<S: Over<f64> + Analytic> Ode<S> for Carried {
    fn dimension(&self) -> usize {
        1
    }

    fn rates(&self, t: S, _: &[S], dy: &mut [S]) {
        dy[0] = t.circle().cos;
    }
}

/// At a saddle point the state is constant and only the derivatives change; for a law that depends on time only the
/// derivatives are constant.
#[test]
fn value_and_derivatives_are_followed_each_where_the_other_rests() {
    let (tolerance, span) = (Tolerance::both(1e-13), (0.0, 20.0));
    let saddle = transition(&CompiledLaw::new(Saddle), &tolerance, span, &[0.0; 2]).expect("a series");
    let [cosh, sinh] = [20.0_f64.cosh(), 20.0_f64.sinh()];
    for (found, exact) in saddle.matrix.iter().zip([cosh, sinh, sinh, cosh]) {
        assert!((found / exact - 1.0).abs() < 1e-11, "{found} for {exact}");
    }
    let carried = transition(&CompiledLaw::new(Carried), &tolerance, span, &[0.0]).expect("a series");
    assert!((carried.state[0] - 20.0_f64.sin()).abs() < 1e-11 && carried.matrix == [1.0], "{carried:?}");
}
