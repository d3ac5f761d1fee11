//! Scenes with rough contacts: the project's own end as they say, and whatever is wrong with one is told at its place.

use derivations::friction::log::Names;
use derivations::friction::{ForRough, RoughScene, run};
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use std::path::Path;

struct HowItEnds<'a>(&'a RoughScene);

impl ForRough for HowItEnds<'_> {
    type Output = (usize, String);

    fn apply<Q, const N: usize, const C: usize, const K: usize>(
        self,
        system: &Q,
        start: State<f64, N>,
        names: Names<K>,
    ) -> (usize, String)
    where
        Q: Contacts<N, C, K, Given = f64>,
    {
        let run = run(system, &start, &self.0.plan, &mut ());
        (run.entries.len(), run.ending.describe(&names))
    }
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
        let scene = RoughScene::open(&Path::new("scenes/friction").join(name).with_extension("toml"));
        let scene = scene.unwrap_or_else(|error| panic!("{error}"));
        let (entries, said) = scene.apply(HowItEnds(&scene));
        assert!(said.starts_with(ending), "{name}: {said}");
        assert_eq!(entries, regimes, "{name}");
    }
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
        snapshot_path => "../snapshots/scene_messages", prepend_module_to_snapshot => false, omit_expression => true,
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
