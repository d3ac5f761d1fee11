//! Scenes with rough contacts: the project's own end as they say, and whatever is wrong with one is told at its place.

use dalembert_derivations::studies::friction::RoughScene;
use dalembert_derivations::studies::friction::run::Plan;
use reader::Family;
use std::ops::ControlFlow;
use std::path::Path;

fn open(name: &str) -> RoughScene {
    let scene = RoughScene::open(&Path::new("scenes/friction").join(name).with_extension("toml"));
    scene.unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_scenes_end_as_they_should() {
    for (name, regimes, ending) in [
        ("climbed_ladder", 4, "top touches down"),
        ("pushed_ladder", 2, "the end of the span"),
        ("painleve", 0, "no regime is consistent"),
        ("jam", 1, "the determinant of the regime vanishes"),
        ("steered_rod", 3, "the end of the span"),
    ] {
        let scene = open(name);
        let course = scene.follow(&scene.plan, &mut |_| ());
        assert!(course.ending.starts_with(ending), "{name}: {}", course.ending);
        assert_eq!((course.log.len(), course.reached), (regimes, ending.contains("span")), "{name}");
        assert!(course.imbalance.abs() < 1e-9, "{name}: {:.1e}", course.imbalance);
    }
}

#[test]
fn the_runs_of_scenes_agree_with_their_closed_forms() {
    for name in ["climbed_ladder", "pushed_ladder", "jam", "steered_rod"] {
        let scene = open(name);
        let course = scene.follow(&scene.plan, &mut |_| ());
        let check = scene.check(&course).unwrap_or_else(|| panic!("{name} has a closed form"));
        assert!(check.deviation < 1e-9, "{name}: {}: {:.1e}", check.what, check.deviation);
    }
}

/// Which condition of a regime fails first where its reactions grow beyond every bound is rounding: no method names another ending.
#[test]
fn a_rod_that_jams_does_so_by_every_method() {
    use integrators::Method;
    let scene = open("jam");
    for method in [
        Method::DormandPrince5,
        Method::DormandPrince8,
        Method::Verner6,
        Method::Verner9,
        Method::GraggBulirschStoer,
        Method::Radau5,
    ] {
        let course = scene.follow(&Plan { method, ..scene.plan.clone() }, &mut |_| ());
        assert!(course.ending.starts_with("the determinant of the regime vanishes"), "{method}: {}", course.ending);
    }
}

/// Also where a run stops early.
#[test]
fn the_rows_of_a_run_go_to_its_last_state() {
    for (name, rows) in [("pushed_ladder", 11..12), ("climbed_ladder", 5..11), ("painleve", 1..2)] {
        let scene = open(name);
        let course = scene.follow(&scene.plan.clone().with_samples(10), &mut |_| ());
        assert!(rows.contains(&course.rows.len()), "{name}: {}", course.rows.len());
        assert!(course.times.is_sorted_by(|a, b| a < b), "{name}: {:?}", course.times);
        assert_eq!(course.times[0], 0.0);
        assert!(course.rows.iter().all(|row| row.len() == course.names.len() && row.iter().all(|x| x.is_finite())));
    }
}

#[test]
fn a_run_that_is_broken_off_keeps_what_there_is() {
    let scene = open("climbed_ladder");
    let mut steps = 0;
    let course = scene.follow_while(&scene.plan, &mut |_| {
        steps += 1;
        if steps < 20 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    assert!(course.broken_off && !course.reached && course.ending == "interrupted", "{}", course.ending);
    assert_eq!((steps, course.rows.is_empty(), course.log.is_empty()), (20, false, false));
    assert!(course.times.last().is_some_and(|last| *last < scene.plan.end));
}

const SOUND: &str = r#"title = "A ladder"
system = "ladder"
gravity = "9.81 m/s^2"

[body]
mass = "20 kg"
half_length = "2 m"
friction_wall = "0.3"
friction_floor = "0.3"

[start]
angle = "17 deg"
angular_velocity = "-0.7 rad/s"

[run]
span = "1 s"
"#;

/// Asserts that the marks stand under these texts, in the order of the file, then compares the message.
fn refused(name: &str, edits: &[(&str, &str)], marked: &[&str]) {
    let text = edits.iter().fold(SOUND.to_owned(), |text, (from, to)| {
        assert_eq!(text.matches(from).count(), 1, "`{from}` must stand once in the scene");
        text.replace(from, to)
    });
    let error = RoughScene::parse("scene.toml", &text).expect_err("the scene must be refused");
    let found: Vec<&str> = error.issues.iter().map(|issue| issue.span.clone().map_or("", |span| &text[span])).collect();
    assert_eq!(found, marked, "{error}");
    assert!(error.issues.iter().all(|issue| issue.help.is_some()), "{error}");
    insta::with_settings!({
        snapshot_path => "../../snapshots/scene_messages", prepend_module_to_snapshot => false, omit_expression => true,
    }, { insta::assert_snapshot!(name, error.render(false)) });
}

#[test]
fn the_sound_scene_is_sound() {
    assert!(RoughScene::parse("scene.toml", SOUND).is_ok());
}

#[test]
fn negative_friction_and_a_mass_of_zero() {
    let edits = [("wall = \"0.3\"", "wall = \"-0.3\""), ("\"20 kg\"", "\"0 kg\"")];
    refused("rough_negative_friction_and_a_mass_of_zero", &edits, &["\"0 kg\"", "\"-0.3\""]);
}

#[test]
fn the_load_of_a_climbed_ladder_is_missing() {
    refused("rough_a_missing_load", &[("\"ladder\"", "\"climbed_ladder\"")], &[""]);
}

#[test]
fn a_ladder_has_no_sliding_velocity() {
    let edits = [("angle =", "sliding = \"1 m/s\"\nangle =")];
    refused("rough_a_key_of_another_system", &edits, &["sliding"]);
}

#[test]
fn a_system_without_contacts() {
    refused("rough_a_system_without_contacts", &[("\"ladder\"", "\"gyrostat\"")], &["\"gyrostat\""]);
}
