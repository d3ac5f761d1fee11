//! Rolling bodies, run with every method.

use super::{folder, open};
use dalembert_scenes::ModelScene;
use integrators::{Failure, Method, Refusal};
use simulation::{Choice, IvpScene, Trajectory, methods};

fn body(name: &str) -> ModelScene {
    open(&folder().join("bodies").join(name).with_extension("toml"))
}

fn run(scene: &ModelScene, choice: Choice) -> Trajectory {
    scene.problem(choice.axes).simulate(&choice, |_| ())
}

/// The adaptive methods, and one with a sufficiently small constant step.
fn accurate_methods() -> impl Iterator<Item = Method> {
    let named = methods::list().filter_map(|(written, _)| methods::method(&written).ok());
    named.chain([Method::RungeKutta4 { steps: 5000 }])
}

/// The angle passes zero smoothly, but the law is undefined at singular positions of Euler's angles.
#[test]
fn the_disc_lies_flat_at_one_time_by_every_method_at_every_tolerance() {
    let scene = body("falling_disc");
    for method in accurate_methods() {
        for tolerance in [1e-4, 1e-6, 1e-9, 1e-12] {
            let choice = Choice { method, tolerance, ..scene.run.choice() };
            let trajectory = run(&scene, choice);
            let told = scene.told(&choice, &trajectory);
            assert_eq!(trajectory.stopped(), None, "{method} at {tolerance:e}");
            assert!(told.diagnosis.is_some_and(|what| what.contains("the disc lies flat")), "{method}");
            let (time, theta) = (trajectory.outcome.time, trajectory.last[3]);
            assert!(trajectory.last.iter().all(|number| number.is_finite()), "{method}: {:?}", trajectory.last);
            assert!((time - 0.804643811).abs() < (10.0 * tolerance).max(1e-6), "{method} at {tolerance:e}: {time}");
            assert!(theta.abs() < (1e-2 * tolerance).max(1e-7), "{method} at {tolerance:e}: {theta:e}");
        }
    }
}

#[test]
fn samples_change_no_step_of_any_method() {
    let scene = body("coin");
    let steps = |written: String| methods::method(&written.replace("STEPS", "977")).expect("it is in the list");
    for method in methods::list().map(|(written, _)| steps(written)) {
        let by = |samples: usize| run(&scene, Choice { method, tolerance: 1e-8, samples, ..scene.run.choice() });
        let few = by(5);
        if !few.outcome.reached() {
            let is_refused = matches!(few.outcome.failure(), Some(Failure::Refused(Refusal::NoPieces)));
            assert!(is_refused || method.steps().is_some(), "{method}: {:?}", few.stopped());
            continue;
        }
        let many = by(1234);
        let work = |run: &Trajectory| (run.outcome.work.steps, run.outcome.work.rates, run.outcome.work.rejected);
        assert_eq!((work(&many), &many.last), (work(&few), &few.last), "{method}");
        assert_eq!((few.times.len(), many.times.len()), (6, 1235), "{method}");
    }
}
