//! Ladders and rods beside the program's own rough systems.

use super::{METHODS, close, events, last, rod, runs, stored};
use integrators::Method;
use reader::Family;
use studies::friction::RoughScene;

/// The events of a rough scene, without its start.
fn known(name: &str) -> Vec<f64> {
    let scene = RoughScene::parse(name, &stored(&format!("friction/{name}"))).unwrap_or_else(|error| panic!("{error}"));
    scene.follow(&scene.plan, &mut |_| {}).log.iter().skip(1).map(|line| line.time).collect()
}

#[test]
fn a_ladder_that_is_pushed_up_stops_and_stays() {
    for method in METHODS {
        let trajectory = runs(&stored("models/leaning_ladder"), method, 1e-12);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        let (found, known) = (events(&trajectory), known("pushed_ladder"));
        assert_eq!(found.len(), 1, "{method:?} {:?}", trajectory.passages);
        close(found[0], known[0], 1e-11);
        assert!(last(&trajectory, "alpha'").abs() < 1e-14);
        let then = trajectory.passages[1].then.as_deref();
        assert_eq!(then, Some("contact `wall` sticks, contact `floor` sticks"));
    }
}

/// The weight that is carried up slips it, it leaves the wall, and its top falls on the floor.
#[test]
fn a_ladder_under_a_climber_has_the_events_of_the_rough_scene() {
    let climber = "\n[[force]]\non = \"ladder at W\"\nis = \"-P*N.y\"\n\n[[contact]]\nname = \"top\"\nof = \"ladder at A\"\n\
                   through = \"O\"\nnormal = \"N.y\"\nfriction = \"f\"\n\n[outputs]";
    let text = stored("models/leaning_ladder")
        .replacen("\n[outputs]", climber, 1)
        .replacen("B = \"G - l*L.y\"", "B = \"G - l*L.y\"\nW = \"B + v*t*L.y\"", 1)
        .replacen("f = \"0.3\"", "f = \"0.4\"\nP = \"700 N\"\nv = \"0.5 m/s\"", 1)
        .replacen(
            "alpha = \"17 deg\"\n\"alpha'\" = \"-0.7 rad/s\"",
            "alpha = \"40 deg\"\n\"alpha'\" = \"0.5 rad/s\"",
            1,
        )
        .replacen("span = \"1 s\"", "span = \"8 s\"", 1);
    for method in METHODS {
        let trajectory = runs(&text, method, 1e-13);
        let (found, known) = (events(&trajectory), known("climbed_ladder"));
        // it slides and stops, slips, and leaves the wall
        assert_eq!(found.len(), 3, "{method:?} {:?}", trajectory.passages);
        found.iter().zip(&known).for_each(|(found, known)| close(*found, *known, 2e-9));
        let left = trajectory.left.expect("an impact ends it");
        assert!(left.contains("an impact presses other contacts"), "{left}");
        close(trajectory.outcome.time, 5.289275395540, 1e-8);
    }
}

#[test]
fn a_rod_jams_where_the_equations_for_its_reactions_become_singular() {
    let text = rod("34 deg", "3 rad/s", -4.677_578_710_412_241);
    let trajectory = runs(&text, Method::DormandPrince8, 1e-9);
    let left = trajectory.left.expect("it jams");
    assert!(left.contains("become singular"), "{left}");
    close(trajectory.outcome.time, 0.018198204, 2e-9);
}

/// Friction beyond (1 + 3 cos^2)/(3 sin cos) leaves no motion.
#[test]
fn a_rod_pushed_against_its_contact_has_no_motion() {
    let error =
        dalembert_scenes::ModelScene::parse("scene.toml", &rod("63 deg", "0 rad/s", -3.0)).expect_err("no motion");
    let said = error.to_string();
    assert!(said.contains("no case of its conditions and contacts agrees with the motion"), "{said}");
    assert!(said.contains("[[contact]]"), "{said}");
}
