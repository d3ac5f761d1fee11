//! Scenes of mechanisms: they end as they should, beside closed forms and theory, and their energy is the work on them.

use dalembert_derivations::studies::AnyScene;
use dalembert_derivations::studies::governors::{self, SPEED, growth};
use dalembert_derivations::studies::mechanisms::governors::{Discs, Drum, Programme};
use dalembert_derivations::studies::mechanisms::{LIST, Mechanism, MechanismScene};
use integrators::{Failure, Method, Refusal};
use reader::Family;
use simulation::models::holds_model;
use simulation::{Axes, Choice, Smooth, Told, Trajectory, methods};
use std::convert::Infallible;
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
const SCENES: [(&str, Option<&str>); 5] = [
    ("governors/drum_programme", None),
    ("governors/blow_up", Some("blow-up in finite time: the wheel comes to the axis of the second disc")),
    ("governors/between_discs", None),
    ("governors/between_discs_blow_up", Some("blow-up in finite time: the wheel comes to the axis of the second disc")),
    ("failures/nodding_top", Some("p g2 = q g1")),
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
    let files: usize = std::fs::read_dir("scenes/governors")
        .expect("it is there")
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

#[test]
fn the_energy_is_the_work_on_the_mechanism() {
    for (name, _) in SCENES {
        let (scene, trajectory, _) = run(name);
        let problem = scene.problem();
        let count = scene.columns().iter().position(|quantity| quantity.name == "work").expect("it is counted");
        let work = trajectory.last[count].abs().max(1.0);
        let [deviation] = &trajectory.outcome.deviations[..] else { panic!("{name}: one balance") };
        assert!(deviation.largest < 1e-6 * work, "{name}: {deviation:?}, work {work}");
        assert_eq!(problem.state.len(), count + 1);
    }
}

#[test]
fn runs_agree_with_their_closed_forms() {
    for name in ["drum_programme", "blow_up", "between_discs", "between_discs_blow_up"] {
        let (_, _, told) = run(&format!("governors/{name}"));
        let (what, off) = told.closed_form.unwrap_or_else(|| panic!("{name} has a closed form"));
        assert!(off < 1e-10, "{name}: {what}: {off:.1e}");
    }
}

#[test]
fn a_blow_up_is_where_the_closed_form_says() {
    for (name, time) in [("blow_up", 1.1025), ("between_discs_blow_up", 7.265608828656)] {
        let (_, trajectory, told) = run(&format!("governors/{name}"));
        assert!((trajectory.outcome.time - time).abs() < 1e-9, "{name}: {}", trajectory.outcome.time);
        let diagnosis = told.diagnosis.expect("it is named");
        assert!(diagnosis.contains(&format!("by the closed form at t = {time}")), "{diagnosis}");
    }
}

/// A step that is as long as ever would land on the other side, where the law has values again.
#[test]
fn no_method_steps_over_the_axis() {
    let scene = open("governors/blow_up");
    for (written, _) in methods::list() {
        let method = methods::method(&written.replace("STEPS", "70")).expect("it is in the list");
        let choice = Choice { method, ..scene.run.choice() };
        let trajectory = scene.simulate(&choice, |_| ());
        if let Some(Failure::Refused(refusal)) = trajectory.outcome.failure() {
            assert_eq!(refusal, Refusal::NoPieces, "{method}");
            continue;
        }
        let told = scene.told(&choice, &trajectory);
        assert!(!trajectory.outcome.reached() && trajectory.last[0] > 0.0, "{method}: {:?}", trajectory.last);
        // backward Euler's equation has no root two steps before the end: what theory foretells is all that is said
        let named = told.diagnosis.is_some_and(|what| what.starts_with("blow-up"));
        assert_eq!(named, !matches!(method, Method::BackwardEuler { .. }), "{method}: {:?}", trajectory.stopped());
        assert!(told.theory[0].contains("t = 1.1025"), "{:?}", told.theory);
        assert!(trajectory.rows.iter().all(|row| row[0] > 0.0), "{method}");
    }
}

/// What a mechanism shows at a state; every datum is 1 but those that are told.
fn shown<M: Mechanism>(name: &str, y: &[f64], told: &[(&str, f64)]) -> f64 {
    let datum = |name: &str| told.iter().find(|(told, _)| *told == name).map_or(1.0, |(_, value)| *value);
    let Ok(mechanism) = M::read(&mut |quantity| Ok::<_, Infallible>(datum(&quantity.name)));
    let place = M::SHOWN.iter().position(|quantity| quantity.name == name).expect("it is shown");
    mechanism.shown(0.0, y)[place]
}

/// No contact slips: R omega1 = rho omega2 at a drum, rho omega1 = (a - rho) omega2 between two discs.
#[test]
fn the_other_shaft_is_shown_as_fast_as_the_wheel_rolls() {
    let (drum, discs) = ([("drum", 0.5), ("speed", 3.0)], [("distance", 1.0), ("speed", 3.0)]);
    assert_eq!(shown::<Programme<Drum>>("omega1", &[0.25], &drum), 1.5);
    assert_eq!(shown::<Programme<Discs>>("omega1", &[0.25], &discs), 9.0);
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
fn the_sound_text_is_accepted() {
    MechanismScene::parse("scene.toml", SOUND).unwrap_or_else(|error| panic!("{error}"));
}

const SOUND: &str = include_str!("../../scenes/governors/drum_programme.toml");
const GOVERNOR: &str = include_str!("../../scenes/governors/between_discs.toml");

/// What is wrong stands under the marks, is said, and comes with what would be accepted.
#[test]
fn what_is_wrong_with_a_mechanism_is_told_at_its_place() {
    for (text, from, to, marked, said) in [
        (SOUND, "j2 = \"0.5 kg m^2\"", "j2 = \"0 kg m^2\"", "\"0 kg m^2\"", "must be positive"),
        (SOUND, "j2 = \"0.5 kg m^2\"", "j2 = \"500 mQ\"", "\"500 mQ\"", "cannot be read"),
        (SOUND, "j2 = \"0.5 kg m^2\"\n", "", "[data]", "`j2` is missing"),
        (SOUND, "rho = \"300 mm\"", "sigma = \"0.3 m\"", "sigma", "unknown key `sigma`"),
        (SOUND, "\"push\"]", "\"pusch\"]", "\"pusch\"", "unknown output"),
        (SOUND, "\"drum_programme\"", "\"drum_program\"", "\"drum_program\"", "unknown system"),
        (SOUND, "\"drum_programme\"", "\"gyrostat\"", "\"gyrostat\"", "is not a mechanism"),
        (GOVERNOR, "rho = \"300 mm\"", "rho = \"900 mm\"", "\"900 mm\"", "axis of the second disc"),
        (GOVERNOR, "rho = \"300 mm\"", "rho = \"-1 mm\"", "\"-1 mm\"", "axis of the first disc"),
        (GOVERNOR, "speed = \"2 rad/s\"", "speed = \"0 rad/s\"", "\"0 rad/s\"", "no wheel keeps a shaft at rest"),
        (GOVERNOR, "j1 = \"0.6 kg m^2\"", "j1 = \"-0.6 kg m^2\"", "\"-0.6 kg m^2\"", "must be positive"),
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
