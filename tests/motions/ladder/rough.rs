//! The same ladder under rough contacts.

use super::path;
use dalembert_derivations::studies::friction::RoughScene;
use dalembert_derivations::studies::ladder::rough::RoughLadder;
use dalembert_derivations::studies::ladder::{Loss, Models, Verdict, Wish, choose};
use reader::Family;
use std::time::Duration;

/// A scene with other coefficients of friction and another span.
fn scene(name: &str, friction: &str, span: &str) -> RoughScene {
    let text = std::fs::read_to_string(path(&format!("friction/{name}"))).expect("a scene");
    let edited = text.lines().map(|line| match line.split_once('=') {
        Some((key, _)) if key.starts_with("friction") && !friction.is_empty() => format!("{key}= \"{friction}\""),
        Some(("span ", _)) => format!("span = \"{span}\""),
        _ => line.to_owned(),
    });
    let edited = edited.collect::<Vec<_>>().join("\n");
    RoughScene::parse(name, &edited).unwrap_or_else(|error| panic!("{error}"))
}

fn names(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

/// One regime, a reversal, a contact that is left: the error is carried through all of them.
#[test]
fn what_is_lost_without_friction_is_what_is_estimated() {
    for (name, friction, span, outputs) in [
        ("steered_rod", "0.001", "0.2 s", &["x1", "angle"][..]),
        ("steered_rod", "0.001", "1 s", &["x1", "dx1", "angle"]),
        ("pushed_ladder", "0.001", "0.8 s", &["angle", "angular_velocity"]),
        ("climbed_ladder", "0.001", "0.3 s", &["angle", "x"]),
        ("jam", "0.001", "0.1 s", &["x", "angle"]),
        ("painleve", "0.001", "0.2 s", &["x", "angle"]),
    ] {
        let ladder = RoughLadder::of(&scene(name, friction, span));
        let (watched, _) = ladder.watched(&names(outputs)).unwrap_or_else(|why| panic!("{name}: {why}"));
        let (lines, _) = ladder.lines(&watched, 1e-6);
        assert!(lines.len() > 2, "{name}");
        for (at, line) in lines.iter().enumerate().skip(2) {
            let found = line.model.as_ref().unwrap_or_else(|why| panic!("{name}, {}: {why}", line.name));
            let error = ladder.difference(at, &watched).expect("it runs");
            if line.loss == (Loss::Nothing { claim: None }) {
                assert!(line.name.ends_with("top") && error == 0.0, "{name}, {}: {error:e}", line.name);
                continue;
            }
            let effectivity = found.first / error;
            assert!(error > 1e-6 && (effectivity - 1.0).abs() < 0.1, "{name}, {}: {error:e} {found:?}", line.name);
            assert!(found.second < 0.5 * found.first, "{name}, {}: {found:?}", line.name);
        }
    }
}

#[test]
fn a_regime_that_is_never_left_is_the_motion_and_one_that_is_left_is_refused() {
    let wish = Wish { tolerance: 1e-6, outputs: names(&["angle", "x", "sliding_floor"]), allowed: Duration::ZERO };
    let slides = RoughLadder::of(&scene("pushed_ladder", "", "0.03 s"));
    let receipt = choose(&slides, &wish).expect("it runs");
    let held = &receipt.lines[1];
    let Loss::Held { margin, at } = held.loss else { panic!("{held:?}") };
    assert!(margin > 0.0 && (0.0..=0.03).contains(&at), "{held:?}");
    let (own, held) = (receipt.lines[0].choice.as_ref(), held.choice.as_ref());
    let (own, held) = (own.expect("it serves"), held.expect("it serves"));
    for ((_, own), (_, held)) in own.rows.iter().zip(&held.rows) {
        assert!(receipt.watched.off(own, held) < 1e-6, "{own:?} {held:?}");
    }
    assert_eq!(own.rows.len(), held.rows.len());
    let stays = choose(&RoughLadder::of(&scene("pushed_ladder", "", "1 s")), &wish).expect("it runs");
    let why = stays.lines[1].model.as_ref().expect_err("it stops");
    assert!(stays.lines[1].verdict == Verdict::NotHeld && why.contains("sliding at"), "{why}");
}

/// The rod's guide slides ever faster, then slower: over a long run the end comes closest to rest, over a short one the first place
/// that is looked at behind the start. Both beside rows of the scene's own model; a margin counts the largest speed of its run.
#[test]
fn the_margin_of_a_regime_is_the_least_speed_of_its_run() {
    let run = |span: f64| {
        let ladder = RoughLadder::of(&scene("steered_rod", "", &format!("{span} s")));
        let wish = Wish { tolerance: 1e-8, outputs: names(&["sliding_guide"]), allowed: Duration::ZERO };
        let receipt = choose(&ladder, &wish).expect("it runs");
        let Loss::Held { margin, at } = receipt.lines[1].loss else { panic!("{:?}", receipt.lines[1]) };
        // sizes are those at even instants
        let times: Vec<f64> = (1..=64).map(|k| span * (f64::from(k) / 64.0)).collect();
        let method = integrators::Method::DormandPrince8;
        let (own, _) = ladder.forms(0)[0].run(method, 1e-10, u64::MAX, Some(&times));
        let rows = own.expect("it reaches its end").asked;
        let of =
            |row: &[f64], name: &str| row[ladder.columns().iter().position(|known| known == name).expect("a column")];
        let speed = |row: &[f64]| ["dx1", "dy1", "dx2", "dy2"].iter().map(|name| of(row, name).abs()).sum::<f64>();
        let largest = rows.iter().map(|(_, row)| speed(row)).fold(0.0, f64::max);
        let (_, end) = rows.last().expect("a row");
        (margin * largest, at, of(end, "sliding_guide").abs())
    };
    let (least, at, speed) = run(0.2);
    assert_eq!(at, 0.2);
    assert!((least - speed).abs() < 1e-6 * speed, "{least} {speed}");
    let (least, between, _) = run(0.1);
    assert!(between > 0.0 && between < 0.01, "{between}");
    let (_, _, speed) = run(between);
    assert!((least - speed).abs() < 1e-6 * speed, "{least} {speed}");
}

#[test]
fn friction_that_is_small_is_left_out_and_friction_that_stops_is_not() {
    let taken = |friction: &str, tolerance: f64| {
        let ladder = RoughLadder::of(&scene("pushed_ladder", friction, "0.6 s"));
        let wish = Wish { tolerance, outputs: names(&["angle"]), allowed: Duration::ZERO };
        let receipt = choose(&ladder, &wish).expect("it runs");
        let last = receipt.lines.last().expect("a line");
        assert_eq!(last.name, "no friction");
        last.choice.is_some()
    };
    assert!(taken("0.00001", 1e-2));
    assert!(!taken("0.00001", 1e-7));
    assert!(!taken("0.3", 1e-2));
}

#[test]
fn a_scene_whose_own_model_stops_says_why() {
    for (name, why) in [("jam", "determinant"), ("painleve", "no regime"), ("climbed_ladder", "touches down")] {
        let ladder = RoughLadder::of(&scene(name, "", if name == "climbed_ladder" { "8 s" } else { "1 s" }));
        let told = ladder.watched(&names(&["angle"])).expect_err("it stops");
        assert!(told.contains(why), "{name}: {told}");
    }
}
