//! Scenes of mechanisms: they end as they should, beside closed forms and theory, and their energy is the work on them.

use dalembert_derivations::studies::AnyScene;
use dalembert_derivations::studies::governors::{self, SPEED, growth};
use dalembert_derivations::studies::mechanisms::{LIST, MechanismScene};
use dalembert_derivations::studies::stabilisation::experiment;
use integrators::Method;
use reader::Family;
use simulation::models::holds_model;
use simulation::{Axes, Choice, Smooth, Told, Trajectory};
use std::path::Path;

fn open(name: &str) -> MechanismScene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml");
    MechanismScene::open(&path).unwrap_or_else(|error| panic!("{error}"))
}

/// A scene by its own choice.
fn run(name: &str) -> (MechanismScene, Trajectory, Told) {
    let scene = open(name);
    let choice = scene.run.choice();
    let trajectory = scene.simulate(&choice, |_| ());
    let told = scene.told(&choice, &trajectory);
    (scene, trajectory, told)
}

/// (scene, what its diagnosis begins with, if it ends early).
const SCENES: [(&str, Option<&str>); 4] = [
    ("drive/euler_bears", None),
    ("drive/euler_overdamped", Some("the violation of the constraint grows")),
    ("drive/euler_stiff_diode", Some("the currents grow")),
    ("drive/stiff_diode", None),
];

#[test]
fn every_scene_ends_as_it_should_and_is_diagnosed_by_name() {
    for (name, diagnosis) in SCENES {
        let (_, trajectory, told) = run(name);
        assert_eq!(trajectory.outcome.reached(), diagnosis.is_none(), "{name}: {:?}", trajectory.stopped());
        let found = told.diagnosis.as_deref();
        assert_eq!(found.is_some(), diagnosis.is_some(), "{name}: {found:?}");
        assert!(found.unwrap_or_default().starts_with(diagnosis.unwrap_or_default()), "{name}: {found:?}");
        assert!(trajectory.rows.iter().flatten().chain(&trajectory.last).all(|x| x.is_finite()), "{name}");
        assert!(trajectory.rows.iter().all(|row| row.len() == trajectory.names.len()), "{name}");
    }
}

#[test]
fn every_scene_of_the_project_is_looked_at_here() {
    let files: usize = ["governors", "drive"]
        .iter()
        .flat_map(|folder| std::fs::read_dir(Path::new("scenes").join(folder)).expect("it is there"))
        .filter_map(|entry| std::fs::read_to_string(entry.ok()?.path()).ok())
        // those that are text are for `crates/scenes`
        .filter(|text| text.contains("\nsystem = ") && !holds_model(text))
        .count();
    // those that are made to fail are counted by their catalogue
    assert_eq!(files, SCENES.iter().filter(|(name, _)| !name.starts_with("failures")).count());
    let shown: Vec<&str> = SCENES.iter().map(|(name, _)| open(name).name).collect();
    let missing: Vec<&str> =
        MechanismScene::systems().into_iter().map(|(name, _)| name).filter(|name| !shown.contains(name)).collect();
    assert!(missing.is_empty(), "{missing:?}");
    assert_eq!(MechanismScene::systems().len(), LIST.len());
}

/// Euler is far from it: what it violates is no constraint.
#[test]
fn the_energy_is_the_work_on_the_mechanism() {
    for (name, _) in SCENES.iter().filter(|(name, _)| !name.contains("euler")) {
        let (scene, trajectory, _) = run(name);
        let problem = scene.problem();
        let count = scene.columns().iter().position(|quantity| quantity.name == "work").expect("it is counted");
        let work = trajectory.last[count].abs().max(1.0);
        let [deviation] = &trajectory.outcome.deviations[..] else { panic!("{name}: one balance") };
        assert!(deviation.largest < 1e-6 * work, "{name}: {deviation:?}, work {work}");
        assert_eq!(problem.state.len(), count + 1);
    }
}

/// The crate's Radau5 goes on with factors of other steps, and Kvaerno's iteration wants less than rounding: both are dealt with.
#[test]
fn implicit_methods_meet_tight_tolerances_on_stiff_circuits() {
    for name in ["drive/stiff_diode", "drive/euler_bears"] {
        let scene = open(name);
        for (method, tolerance) in
            [(Method::Radau5, 1e-11), (Method::Radau5, 3e-12), (Method::Radau5, 1e-13), (Method::Kvaerno5, 1e-13)]
        {
            let choice = Choice { method, tolerance, samples: 10, ..scene.run.choice() };
            let trajectory = scene.simulate(&choice, |_| ());
            assert!(trajectory.outcome.reached(), "{name}, {method} at {tolerance:e}: {:?}", trajectory.stopped());
        }
    }
}

/// The step that Euler bears is longest for an instant: between a hundred instants it was missed.
#[test]
fn the_longest_step_that_euler_bears_is_found() {
    let (_, _, told) = run("drive/euler_bears");
    let said = told.theory.iter().find(|said| said.contains("longest steps")).expect("theory tells the steps");
    let greatest = said.split(" s to ").nth(1).and_then(|rest| rest.split(' ').next()).map(str::parse::<f64>);
    assert!(greatest.is_some_and(|step| step.is_ok_and(|step| (0.0890..0.0900).contains(&step))), "{said}");
}

/// The rate of the linear theory, seen over forty seconds of the motion.
#[test]
fn the_elastic_governor_leaves_or_regains_its_stationary_motion_as_fast_as_theory_says() {
    for (name, load) in [("elastic_stable", 20.0), ("elastic_unstable", 23.0)] {
        scenes::register(|_| ());
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/governors").join(name).with_extension("toml");
        let Ok(AnyScene::Model(scene)) = AnyScene::open(&path) else { panic!("{name} is text") };
        let choice = scene.run().choice();
        let trajectory = scene.problem(Axes::First).simulate(&choice, |_| ());
        let told = scene.told(&choice, &trajectory);
        let of_the_maps = governors::governor(50.0, load);
        for (name, value) in [("m1", of_the_maps.m1), ("delta2", of_the_maps.delta2), ("beta", of_the_maps.beta)] {
            let given = scene.value(name).expect("it is a parameter");
            assert!((given - value).abs() < 1e-14, "{name}: {given} and {value}");
        }
        let column = trajectory.column("x").expect("a state");
        let largest = |from: f64, to: f64| {
            let rows = trajectory.times.iter().zip(&trajectory.rows);
            let inside = rows.filter(|(time, _)| (from..to).contains(*time));
            inside.map(|(_, row)| (row[column] - of_the_maps.rest).abs()).fold(0.0, f64::max)
        };
        let rate = (largest(80.0, 100.0) / largest(40.0, 60.0)).ln() / 40.0;
        let foretold = growth(&of_the_maps, SPEED).expect("eigenvalues");
        assert_eq!(foretold > 0.0, name.contains("unstable"));
        assert!((rate - foretold).abs() < 0.1 * foretold.abs(), "{name}: {rate} and {foretold}");
        let word = if foretold > 0.0 { "is unstable" } else { "is stable" };
        assert!(told.theory.iter().any(|said| said.contains(word)), "{:?}", told.theory);
    }
}

#[test]
fn the_drive_of_the_scene_is_the_drive_of_the_experiment() {
    let (_, trajectory, told) = run("drive/euler_bears");
    let euler: fn(u32) -> Method = |steps| Method::Euler { steps };
    let track = experiment::run("", euler, experiment::STEP, 200.0, 1e4);
    let (time, state) = track.points[500];
    assert!((time - 5.0).abs() < 1e-12);
    for (found, expected) in trajectory.last.iter().zip(state) {
        assert!((found - expected).abs() < 1e-9, "{found} and {expected}");
    }
    assert!(told.theory.iter().any(|said| said.contains("decays")), "{:?}", told.theory);
}

/// The moments of the one grow with the time, the source of the other alternates: the tape must know the time.
#[test]
fn taylors_method_follows_laws_with_the_time_in_them() {
    for name in ["governors/released", "drive/euler_bears"] {
        scenes::register(|_| ());
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml");
        let scene = AnyScene::open(&path).unwrap_or_else(|error| panic!("{error}"));
        let scene = scene.smooth();
        let by = |method| {
            let choice = Choice { method, tolerance: 1e-10, ..scene.run().choice() };
            let trajectory = scene.problem(choice.axes).simulate(&choice, |_| ());
            assert!(trajectory.outcome.reached(), "{name}: {:?}", trajectory.stopped());
            trajectory.outcome.state
        };
        let (series, stages) = (by(Method::Taylor), by(Method::DormandPrince8));
        for (a, b) in series.iter().zip(&stages) {
            assert!((a - b).abs() < 1e-6 * a.abs().max(1.0), "{name}: {a} and {b}");
        }
    }
}

#[test]
fn what_theory_says_of_a_constant_step_is_what_the_run_does() {
    let overdamped = open("drive/euler_overdamped");
    // h b = 2 + h^2 k/2 at h = 5 s/654
    for (steps, bears) in [(500, false), (600, false), (700, true), (2000, true)] {
        let choice = Choice { method: Method::Euler { steps }, ..overdamped.run.choice() };
        let trajectory = overdamped.simulate(&choice, |_| ());
        let told = overdamped.told(&choice, &trajectory);
        assert_eq!(trajectory.outcome.reached(), bears, "{steps}: {:?}", trajectory.stopped());
        assert_eq!(
            told.theory.iter().any(|said| said.contains("violation of the constraint decays")),
            bears,
            "{told:?}"
        );
    }
}

#[test]
fn the_sound_text_is_accepted() {
    MechanismScene::parse("scene.toml", SOUND).unwrap_or_else(|error| panic!("{error}"));
}

const SOUND: &str = include_str!("../../scenes/drive/stiff_diode.toml");

/// What is wrong stands under the marks, is said, and comes with what would be accepted.
#[test]
fn what_is_wrong_with_a_mechanism_is_told_at_its_place() {
    for (text, from, to, marked, said) in [
        (SOUND, "rod = \"600 mm\"", "rod = \"100 mm\"", "\"100 mm\"", "the rod is no longer than the crank"),
        (SOUND, "mutual = \"300 mH\"", "mutual = \"600 mH\"", "\"600 mH\"", "M^2 < L1 L2 is broken"),
        (SOUND, "reverse = \"10 kohm\"", "reverse = \"1 mohm\"", "\"1 mohm\"", "conducts better backwards"),
        (SOUND, "c3 = \"50 mA s/V\"", "c3 = \"0 A s/V\"", "\"0 A s/V\"", "must be positive"),
        (SOUND, "c3 = \"50 mA s/V\"", "c3 = \"50 mQ\"", "\"50 mQ\"", "cannot be read"),
        (SOUND, "l4 = \"500 mH\"\n", "", "[data]", "`l4` is missing"),
        (SOUND, "q6 = \"0.3 rad\"", "q7 = \"0.3 m\"", "q7", "unknown key `q7`"),
        (SOUND, "\"violation\"]", "\"violaton\"]", "\"violaton\"", "unknown output"),
        (SOUND, "\"crank_drive\"", "\"crank_driv\"", "\"crank_driv\"", "unknown system"),
        (SOUND, "\"crank_drive\"", "\"gyrostat\"", "\"gyrostat\"", "is not a mechanism"),
    ] {
        assert_eq!(text.matches(from).count(), 1, "`{from}` must stand once");
        let text = text.replace(from, to);
        let error = MechanismScene::parse("scene.toml", &text).expect_err(said);
        let found = error.issues.iter().any(|issue| {
            let marks = issue.span.clone().map_or("", |span| &text[span]);
            marks.starts_with(marked) && issue.title.contains(said) && issue.help.is_some()
        });
        assert!(found, "{error}");
    }
}
