//! Step-halving checks of runs with constant steps: no accurate run is flagged, and every run that crosses a pole is.

use dalembert_derivations::studies::AnyScene;
use integrators::{Method, StepHalvingVerdict};
use reader::Family as _;
use simulation::{Axes, Choice, IvpScene, Problem, Trajectory, methods};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Duration;

fn run(problem: &Problem, method: Method) -> (Choice, Trajectory) {
    let allowed = Duration::from_secs(60);
    let through_singular_positions = false;
    let choice =
        Choice { method, tolerance: 1e-9, axes: Axes::First, samples: 40, allowed, through_singular_positions };
    let trajectory = problem.simulate(&choice, |_| ());
    (choice, trajectory)
}

fn judged(problem: &Problem, method: Method) -> (Trajectory, Option<StepHalvingVerdict>) {
    let (choice, trajectory) = run(problem, method);
    let beside = problem.check_by_step_halving(&choice, &trajectory, || ControlFlow::Continue(()));
    (trajectory, beside.map(|beside| beside.verdict))
}

/// Every scene that is one initial value problem.
fn scenes() -> Vec<(PathBuf, AnyScene)> {
    scenes::register(|_| ());
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes")];
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("it is there").map(|entry| entry.expect("it can be read").path())
        {
            match entry.extension().and_then(|end| end.to_str()) {
                None => folders.push(entry),
                Some("toml") => found.extend(AnyScene::open(&entry).ok().map(|scene| (entry, scene))),
                Some(_) => {}
            }
        }
    }
    found.sort_by(|a, b| a.0.cmp(&b.0));
    found
}

/// The largest distance of a column from that of another run, relative to its magnitude.
fn apart(a: &Trajectory, b: &Trajectory) -> f64 {
    let sizes = |i: usize| b.rows.iter().map(|row| row[i].abs()).fold(0.0, f64::max);
    let all: Vec<f64> = (0..b.names.len()).map(sizes).collect();
    let nothing = 1e-9 * all.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let rows = a.rows.iter().zip(&b.rows);
    rows.flat_map(|(a, b)| a.iter().zip(b).zip(&all).map(|((a, b), size)| (a - b).abs() / size.max(nothing)))
        .fold(0.0, f64::max)
}

/// The methods and numbers of steps with errors below 1/100 of every column's magnitude, on every scene, and those with
/// larger errors.
#[test]
fn what_is_right_is_never_named() {
    let (mut right, mut wrong, mut named, mut failed) = (0, 0, 0, Vec::new());
    for (path, scene) in scenes() {
        let smooth: &dyn IvpScene = scene.smooth();
        let problem = smooth.problem(Axes::First);
        let (_, reference) = run(&problem, Method::RadauIIA { stages: 5 });
        if !reference.outcome.reached() {
            continue;
        }
        for steps in [200, 2_000, 8_000] {
            let implicit = [Method::ImplicitMidpoint { steps }];
            let explicit = [Method::Euler { steps }, Method::RungeKutta4 { steps }];
            for method in explicit.into_iter().chain(implicit.into_iter().filter(|_| steps == 2_000)) {
                let (trajectory, verdict) = judged(&problem, method);
                let Some(verdict) = verdict else { continue };
                let off = apart(&trajectory, &reference);
                (right, wrong) = (right + usize::from(off < 0.01), wrong + usize::from(off > 1.0));
                named += usize::from(off > 1.0 && verdict.departs());
                if off < 0.01 && verdict.departs() || off > 1.0 && !verdict.departs() {
                    println!("{}, {method}: off by {off:.1e}, {verdict:?}", path.display());
                }
                if off < 0.01 && verdict.departs() {
                    failed.push(format!("{}, {method}: off by {off:.1e}, {verdict:?}", path.display()));
                }
            }
        }
    }
    println!("{right} right, none named; {wrong} off by more than the size, {named} named");
    assert!(failed.is_empty() && right > 100 && 2 * named > wrong, "{failed:#?}");
}

/// The scenes run with their own methods.
#[test]
fn no_scene_with_constant_steps_of_its_own_is_named() {
    let mut seen = 0;
    for (path, scene) in scenes() {
        let smooth: &dyn IvpScene = scene.smooth();
        let own = smooth.run().choice();
        if own.method.steps().is_some() {
            let (trajectory, verdict) = judged(&smooth.problem(Axes::First), own.method);
            println!("{}: {:?} {verdict:?}", path.display(), trajectory.stopped());
            seen += 1;
        }
    }
    assert!(seen > 0);
}

/// The blow-up of a governor, and (19) at p g2 = q g1: runs with constant steps either end where the law is undefined,
/// or step over this point and are flagged.
#[test]
fn whoever_crosses_a_pole_is_named() {
    scenes::register(|_| ());
    let mut crossed = 0;
    for name in ["governors/blow_up", "failures/nodding_top"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("scenes/{name}.toml"));
        let scene = AnyScene::open(&path).unwrap_or_else(|_| panic!("{name} is a scene"));
        let problem = scene.smooth().problem(Axes::First);
        for steps in [20, 30, 50, 200, 500, 1_000, 3_000, 10_000] {
            for method in ["euler", "runge_kutta_4"] {
                let method = methods::method(&format!("{method}:{steps}")).expect("it is a method");
                let (trajectory, verdict) = judged(&problem, method);
                println!("{name}, {method}: {:?} {verdict:?}", trajectory.stopped());
                match verdict {
                    Some(verdict) => assert!(verdict.departs(), "{name}, {method}: {verdict:?}"),
                    None => assert!(trajectory.left.is_some(), "{name}, {method}: {:?}", trajectory.stopped()),
                }
                crossed += usize::from(verdict.is_some());
            }
        }
    }
    assert!(crossed > 0, "{crossed}");
}
