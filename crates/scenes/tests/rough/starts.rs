//! Starts from which no motion, or more than one, continues: the scene is read, and its run ends with the reason.

use super::{edited, rod, runs, stored};
use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::models::Modelled;
use simulation::{Axes, IvpScene, Trajectory};

fn begins(text: &str) -> Trajectory {
    runs(text, Method::DormandPrince8, 1e-9)
}

/// With friction beyond (1 + 3 cos^2)/(3 sin cos) there is no motion.
#[test]
fn a_rod_pushed_against_its_contact_has_no_motion() {
    let text = stored("friction/painleve");
    let scene = ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"));
    let choice = scene.run().choice();
    let trajectory = scene.problem(Axes::First).simulate(&choice, |_| ());
    let stopped = trajectory.stopped().expect("it does not begin");
    assert!(
        stopped.starts_with("does not begin: no combination of cases of conditions and contacts is consistent"),
        "{stopped}"
    );
    assert!(!trajectory.outcome.reached() && trajectory.outcome.time == 0.0);
    assert!(trajectory.passages.is_empty() && trajectory.rows.is_empty());
    // the state is defined, reactions are not
    assert_eq!(trajectory.undefined(), ["N_end", "T_end"]);
    let told = scene.told(&choice, &trajectory).diagnosis.expect("it has a place");
    let line = text.lines().position(|line| line == "[[contact]]").expect("a contact") + 1;
    assert!(told.starts_with(&format!("line {line}: these contacts; accepted is another start")), "{told}");
}

#[test]
fn several_motions_and_motions_without_end_are_told_by_the_run() {
    let several = begins(&rod("63 deg", "4 rad/s", -4.0));
    assert!(several.stopped().is_some_and(|why| why.contains("several motions are possible from here")));
}

/// A driving force sign(v) at rest has several motions, a force with sign(x) at x = 0 is undecided: the message gives the line and the probable intention.
#[test]
fn a_condition_that_no_case_agrees_with_is_told_with_its_line() {
    for (force, why, meant) in [
        ("(1 N)*sign(x')*N.x", "several motions", "accepted is another start"),
        (
            "-(1 N)*sign(x)*N.x",
            "",
            "accepted is `x'`, if the sign of a speed is meant, as in dry friction -F*sign(x'); or another start",
        ),
    ] {
        let text = format!(
            "title = \"block\"\n[coordinates]\nx = \"m\"\n[points]\nP = \"O + x*N.x\"\n[bodies.block]\ncentre = \"P\"\n\
             mass = \"(1 kg)\"\n[[force]]\non = \"block\"\nis = \"{force}\"\n[run]\nspan = \"1 s\"\n"
        );
        let scene = ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"));
        let choice = scene.run().choice();
        let trajectory = scene.problem(Axes::First).simulate(&choice, |_| ());
        let stopped = trajectory.stopped().expect("it does not begin");
        assert!(stopped.starts_with(&format!("does not begin: {why}")), "{stopped}");
        let told = scene.told(&choice, &trajectory).diagnosis.expect("it has a place");
        assert!(told.starts_with("line 11: this is at zero at the start; ") && told.contains(meant), "{told}");
    }
}

/// A scene with changed values starts as a file with these values.
#[test]
fn a_scene_with_other_values_is_that_of_the_text_with_them() {
    let scene = ModelScene::parse("scene.toml", &stored("friction/jam")).unwrap_or_else(|error| panic!("{error}"));
    let changed = scene.with_values(&[("f", 0.5), ("theta", 1.0)]).unwrap_or_else(|why| panic!("{why}"));
    let text = edited("friction/jam", &[("f", "0.5"), ("theta", "1 rad")]);
    let written = ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((changed.value("f"), changed.value("theta")), (Some(0.5), Some(1.0)));
    let end = |scene: &dyn IvpScene| scene.problem(Axes::First).simulate(&written.run().choice(), |_| ()).outcome.state;
    assert_eq!(end(&*changed), end(&written));
    let unknown = scene.with_values(&[("mu", 0.1)]).expect_err("no such datum");
    assert!(unknown.starts_with("nothing is called `mu`") && unknown.contains("there are: "), "{unknown}");
    let heavier = scene.with_values(&[("m", -1.0)]).expect_err("no such body");
    assert!(heavier.contains("mass"), "{heavier}");
}
