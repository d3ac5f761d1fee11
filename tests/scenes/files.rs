//! The scenes of the project: each can be read, conserves its integrals, gives the same run in both forms, and moves as
//! described.

use dalembert_derivations::studies::scene::Scene;
use integrators::Method;
use motor::Machine;
use reader::Family;
use simulation::{Axes, Choice, Trajectory};
use std::path::PathBuf;

fn scene(name: &str) -> Scene {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml");
    Scene::open(&path).unwrap_or_else(|error| panic!("{error}"))
}

fn all() -> Vec<(String, Scene)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let files = std::fs::read_dir(folder).expect("the project has scenes");
    let mut names: Vec<String> = files
        .map(|file| file.expect("it can be listed").path())
        // scenes with friction contacts have their own folder and tests
        .filter(|path| path.is_file())
        .map(|path| path.file_stem().expect("it has a name").to_string_lossy().into())
        .collect();
    names.sort();
    names.into_iter().map(|name| (name.clone(), scene(&name))).collect()
}

/// A run in the first form, which must reach its end.
fn run(scene: &Scene) -> Trajectory {
    let trajectory = scene.simulate(&scene.choice(), |_| ());
    assert!(trajectory.outcome.reached(), "{}: {:?}", scene.title, trajectory.outcome.end);
    trajectory
}

/// The values of a column from a given time on.
fn from(trajectory: &Trajectory, name: &str, start: f64) -> Vec<f64> {
    let column = trajectory.column(name).unwrap_or_else(|| panic!("no column {name}"));
    let rows = trajectory.times.iter().zip(&trajectory.rows);
    rows.filter(|(time, _)| **time >= start).map(|(_, row)| row[column]).collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, value| value.abs().max(largest))
}

#[test]
fn every_scene_is_accepted_and_runs_to_its_end() {
    let scenes = all();
    assert!(scenes.len() >= 9, "{} scenes", scenes.len());
    for (name, scene) in &scenes {
        let trajectory = run(scene);
        assert_eq!(trajectory.rows.len(), scene.run.samples + 1, "{name}");
        assert!(!scene.description.is_empty(), "{name}");
    }
}

#[test]
fn a_state_of_either_form_turns_back_into_the_data() {
    for (name, scene) in all() {
        let [first, second] = [Axes::First, Axes::Second].map(|axes| {
            let mut state = scene.state(axes);
            scene.back(axes)(&mut state);
            state
        });
        for (a, b) in first.iter().zip(&second) {
            assert!((a - b).abs() <= 1e-14 * a.abs().max(1.0), "{name}: {first:?} {second:?}");
        }
        if name != "bench" {
            let given: Vec<f64> =
                scene.start.angular_velocity.iter().chain(scene.start.vertical.iter()).copied().collect();
            assert!(given.iter().zip(&first).all(|(a, b)| (a - b).abs() < 1e-14), "{name}");
        }
    }
}

/// The two forms have neither axes nor formulas for the accelerations in common; scenes with free rotors amplify a
/// rounding error by 1e5.
#[test]
fn both_forms_give_the_same_motion() {
    for (name, scene) in all() {
        let first = run(&scene);
        let second = scene.simulate(&Choice { axes: Axes::Second, ..scene.choice() }, |_| ());
        let difference = first.last.iter().zip(&second.last).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(difference < 1e-7, "{name}: {difference:e}");
    }
}

#[test]
fn what_must_be_conserved_is_conserved() {
    let expected = |name: &str| match name {
        "bench" => &[][..],
        "constant_speed" => &["vertical_length", "vertical_momentum", "jacobi"],
        "free_rotor" => &["vertical_length", "vertical_momentum", "jacobi", "rotor_momentum"],
        _ => &["vertical_length", "vertical_momentum"],
    };
    for (name, scene) in all() {
        let deviations = run(&scene).outcome.deviations;
        let names: Vec<&str> = deviations.iter().map(|deviation| deviation.name.as_str()).collect();
        assert_eq!(names, expected(&name), "{name}");
        for deviation in &deviations {
            assert!(deviation.largest < 1e-9, "{name}: {deviation:?}");
        }
    }
}

/// The Jacobi integral of a synchronous motor without friction; no scene of the project has such a motor.
#[test]
fn a_synchronous_motor_without_friction_keeps_the_energy_in_the_turning_field() {
    let text =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/stiff_damper.toml")).expect("it is there");
    let frictionless = text.replace("f = \"1e-4 N m s\"", "f = \"0 N m s\"");
    let scene =
        Scene::parse("frictionless", &frictionless).expect("sound").with_model("synchronous").expect("on the ladder");
    let choice = Choice { method: Method::DormandPrince8, tolerance: 1e-10, ..scene.choice() };
    let deviations = scene.simulate(&choice, |_| ()).outcome.deviations;
    let jacobi = deviations.iter().find(|deviation| deviation.name == "jacobi").expect("it is conserved");
    assert!(jacobi.largest < 1e-9 * jacobi.first.abs(), "{jacobi:?}");
}

#[test]
fn spin_up_ends_in_synchronism() {
    for name in ["spin_up", "bench"] {
        let trajectory = run(&scene(name));
        assert!(largest(&from(&trajectory, "slip", 1.8)) < 0.3, "{name}");
        assert!(from(&trajectory, "rotor_speed", 0.0)[0] == 0.0, "{name}");
    }
}

#[test]
fn pull_out_leaves_synchronism_for_good() {
    let trajectory = run(&scene("pull_out"));
    assert!(from(&trajectory, "slip", 1.5).iter().all(|slip| *slip < -90.0));
    assert!(from(&trajectory, "angle", 1.9).iter().all(|angle| *angle < -20.0 * std::f64::consts::TAU));
}

#[test]
fn the_hanging_rest_and_the_permanent_rotation_stay_near() {
    for (name, near) in [("hanging_rest", 0.4), ("permanent_rotation", 0.05)] {
        let scene = scene(name);
        let trajectory = run(&scene);
        for (i, component) in ["w1", "w2", "w3"].into_iter().enumerate() {
            let stationary = if name == "permanent_rotation" { 6.0 * scene.start.vertical[i] } else { 0.0 };
            let off: Vec<f64> = from(&trajectory, component, 0.0).iter().map(|w| w - stationary).collect();
            assert!(largest(&off) < near, "{name} {component}: {}", largest(&off));
        }
    }
}

/// Without the perturbation of 0.02 rad/s the rates are zero: the initial state satisfies the conditions of a steady
/// motion.
#[test]
fn the_permanent_rotation_is_stationary_without_its_push() {
    let mut scene = scene("permanent_rotation");
    scene.start.angular_velocity = scene.start.vertical * 6.0;
    let problem = scene.problem(Axes::Second);
    let mut rates = vec![0.0; problem.state.len()];
    integrators::Ode::<f64>::rates(&*problem.law, 0.0, &problem.state, &mut rates);
    assert!(largest(&rates) < 1e-11, "{rates:?}");
}

#[test]
fn the_asynchronous_drive_settles_below_the_field() {
    let slips = from(&run(&scene("asynchronous_drive")), "slip", 1.0);
    assert!(slips.iter().all(|slip| (-3.5..-2.0).contains(slip)), "{slips:?}");
}

#[test]
fn the_damper_of_the_stiff_scene_is_four_decades_faster_than_the_rotor() {
    let scene = scene("stiff_damper");
    let rotor = 0.04;
    assert!(scene.machine.inductance(1) / scene.machine.resistance(1) <= 1e-4 * rotor);
    assert!(largest(&from(&run(&scene), "angle", 0.4)) < 0.3);
}

#[test]
fn each_rung_of_the_ladder_is_made_of_the_data_or_names_what_is_missing() {
    let spin_up = scene("spin_up");
    for model in ["multi_current", "equivalent_windings", "synchronous", "constant_speed", "free_rotor"] {
        let lower = spin_up.with_model(model).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(lower.machine.name(), model);
        assert!(lower.simulate(&lower.choice(), |_| ()).outcome.reached(), "{model}");
    }
    let error = spin_up.with_model("kloss").expect_err("it has no pull-out slip").to_string();
    assert!(error.contains("`pull_out`"), "{error}");
    let error = scene("asynchronous_drive").with_model("constant_speed").expect_err("it gives no speed").to_string();
    assert!(error.contains("`speed`"), "{error}");
}

/// The equivalent windings are exact: their motion equals that of all eight bars.
#[test]
fn the_equivalent_windings_move_like_all_bars() {
    let all = scene("spin_up");
    let two = all.with_model("equivalent_windings").expect("on the ladder");
    let (all, two) = (run(&all), run(&two));
    for name in ["w1", "w2", "w3", "angle", "slip", "x"] {
        let (a, b) = (from(&all, name, 2.0)[0], from(&two, name, 2.0)[0]);
        assert!((a - b).abs() < 1e-7, "{name}: {a} {b}");
    }
}
