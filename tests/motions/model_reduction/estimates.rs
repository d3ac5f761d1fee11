//! Error estimates compared with true errors, and with a second method of estimation.

use super::{corrected, drawn, exactly, ladder, scene, tight, truly};
use dalembert_derivations::studies::model_reduction::Loss;
use dalembert_derivations::studies::model_reduction::sampled_run::followed;
use dalembert_derivations::studies::scene::Scene;
use reader::Family;

/// If the second order is small relative to the first, the estimate equals the error up to the second order.
#[test]
fn an_estimate_is_the_error_up_to_its_second_order_on_every_scene_with_a_motor() {
    let mut believed = 0;
    for name in [
        "spin_up",
        "bench",
        "hanging_rest",
        "permanent_rotation",
        "pull_out",
        "stiff_damper",
        "asynchronous_drive",
        "machines/brushed_bench",
        "machines/permanent_magnet_bench",
        "machines/crossed_windings_bench",
    ] {
        let scene = scene(name);
        let ladder = ladder(&scene);
        let (watched, _) = ladder.watched(&scene.run.outputs).expect("it runs");
        for reduced in ladder.models.iter().filter(|reduced| !reduced.is_exact()) {
            let Ok(found) = ladder.estimate(reduced, &watched, 1e-6) else { continue };
            let doubt = found.second / found.first;
            if doubt > 0.1 {
                continue;
            }
            let Some(error) = truly(&ladder, reduced, &found, &watched) else { continue };
            believed += 1;
            let effectivity = found.first / error;
            assert!(
                (effectivity - 1.0).abs() < 0.01 + 2.0 * doubt,
                "{name}, {}: {effectivity} {found:?}",
                reduced.name
            );
        }
    }
    assert!(believed >= 14, "{believed}");
}

/// A wrong sign or a missing term in the error equation makes this test fail.
#[test]
fn an_estimate_that_is_added_leaves_an_error_of_the_second_order() {
    let scene = scene("hanging_rest");
    let ladder = ladder(&scene);
    let (watched, _) = ladder.watched(&scene.run.outputs).expect("it runs");
    for name in ["currents at the present slip", "no currents", "constant_speed"] {
        let reduced = ladder.models.iter().find(|reduced| reduced.name == name).expect("it is on the ladder");
        let found = ladder.estimate(reduced, &watched, 1e-6).expect("it is carried");
        let off = corrected(&ladder, &found, &watched);
        assert!(off < 0.01 * found.first, "{name}: {off:e} {found:?}");
    }
}

#[test]
fn what_the_first_order_leaves_is_the_second() {
    let scene = scene("stiff_damper");
    let ladder = ladder(&scene);
    let (watched, _) = ladder.watched(&scene.run.outputs).expect("it runs");
    let name = "currents at the present slip";
    let reduced = ladder.models.iter().find(|reduced| reduced.name == name).expect("it is on the ladder");
    let found = ladder.estimate(reduced, &watched, 1e-6).expect("it is carried");
    let off = corrected(&ladder, &found, &watched);
    assert!((off / found.second - 1.0).abs() < 0.1, "{off:e} {:e}", found.second);
}

#[test]
fn an_error_that_cannot_be_estimated_is_not_believed() {
    for (name, model) in [("spin_up", "no currents"), ("bench", "resistive currents"), ("pull_out", "free_rotor")] {
        let scene = scene(name);
        let ladder = ladder(&scene);
        let (watched, _) = ladder.watched(&scene.run.outputs).expect("it runs");
        let reduced = ladder.models.iter().find(|reduced| reduced.name == model).expect("it is on the ladder");
        let found = ladder.estimate(reduced, &watched, 1e-6).expect("it is carried");
        assert!(found.second > 0.5 * found.first, "{name}, {model}: {found:?}");
    }
}

/// The dual-weighted error, backwards in time by transition matrices, compared with the error equation, forwards by
/// derivatives.
#[test]
fn two_routes_to_an_error_agree() {
    for (name, model) in [
        ("hanging_rest", "currents at the present slip"),
        ("hanging_rest", "constant_speed"),
        ("permanent_rotation", "no currents"),
    ] {
        let scene = scene(name);
        let ladder = ladder(&scene);
        let (watched, _) = ladder.watched(&scene.run.outputs).expect("it runs");
        let reduced = ladder.models.iter().find(|reduced| reduced.name == model).expect("it is on the ladder");
        let carried = ladder.estimate(reduced, &watched, 1e-6).expect("it is carried");
        let shares = ladder.shares(reduced, &watched, &*ladder.law, 256, 1e-11).expect("a series");
        let (low, _) = followed(&*reduced.law, &tight(), ladder.own.span, &reduced.start).expect("it reaches its end");
        for (output, errors) in shares.errors.iter().enumerate() {
            for ((time, z), weighed) in low.times.iter().zip(&low.states).zip(errors) {
                let poor = ladder.row(*time, &reduced.lifted(*time, z, ladder.start.len()));
                let (_, row) = carried.corrected.iter().find(|(at, _)| at == time).expect("it is looked at there");
                let column = watched.columns[output];
                let apart = ((row[column] - poor[column]) / watched.sizes[output] - weighed).abs() / carried.first;
                assert!(apart < 0.03, "{name}, {model}, {}, {time} s: {weighed} {row:?}", watched.names[output]);
            }
        }
        let sum: f64 = shares.parts[0].iter().sum::<f64>() + shares.start[0];
        assert!((sum - shares.errors[0][7]).abs() <= 1e-12 + 1e-9 * sum.abs());
    }
}

/// The signs of errors are checked too; the tests above compare absolute values only.
#[test]
fn shares_add_up_to_what_the_richer_run_is_above_the_lower_one_with_its_sign() {
    for (name, model) in [
        ("hanging_rest", "currents at the present slip"),
        ("hanging_rest", "constant_speed"),
        // a linear law; at the start the windings do not have the currents of the reduced model
        ("machines/brushed_bench", "currents at rest"),
    ] {
        let scene = scene(name);
        let ladder = ladder(&scene);
        let (watched, _) = ladder.watched(&scene.run.outputs).expect("it runs");
        let reduced = ladder.models.iter().find(|reduced| reduced.name == model).expect("it is on the ladder");
        let shares = ladder.shares(reduced, &watched, &*ladder.law, 256, 1e-11).expect("a series");
        let (low, _) = followed(&*reduced.law, &tight(), ladder.own.span, &reduced.start).expect("it reaches its end");
        let exact = exactly(&ladder);
        let (mut largest, mut apart) = (0.0f64, 0.0f64);
        for (k, (time, y)) in exact.times.iter().zip(&exact.states).enumerate() {
            let rich = ladder.row(*time, y);
            let poor = ladder.row(*time, &reduced.lifted(*time, &low.states[k], y.len()));
            for (output, (&column, size)) in watched.columns.iter().zip(&watched.sizes).enumerate() {
                let (above, found) = ((rich[column] - poor[column]) / size, shares.errors[output][k]);
                (largest, apart) = (largest.max(above.abs()), apart.max((above - found).abs()));
            }
        }
        assert!(largest > 0.0 && apart < 0.01 * largest, "{name}, {model}: {apart:e} of {largest:e}");
    }
}

#[test]
fn on_thirty_random_motors_what_is_believed_is_right() {
    let mut found = 0;
    for seed in 0..30 {
        let scene = Scene::parse("drawn", &drawn::scene(seed)).unwrap_or_else(|error| panic!("{error}"));
        let ladder = ladder(&scene);
        let (watched, _) = ladder.watched(&scene.run.outputs).expect("it runs");
        for reduced in &ladder.models {
            let Loss::Small { .. } = reduced.loss else { continue };
            let Ok(estimate) = ladder.estimate(reduced, &watched, 1e-6) else { continue };
            let Some(error) = truly(&ladder, reduced, &estimate, &watched).filter(|error| *error > 1e-8) else {
                continue;
            };
            if estimate.second < 0.1 * estimate.first {
                found += 1;
                let effectivity = estimate.first / error;
                assert!(
                    (0.8..1.25).contains(&effectivity),
                    "seed {seed}, {}: {effectivity} {estimate:?}",
                    reduced.name
                );
            }
        }
    }
    assert!(found > 60, "{found}");
}
