//! What is chosen for systems that are written in their files: promises are kept, and a smaller model that serves is taken.

use super::drawn_texts::{KINDS, scene};
use dalembert_derivations::studies::model_reduction::{Choice, Models, Receipt, TextModels, Wish, choose};
use integrators::Method;
use simulation::models::{Modelled, readers};
use std::sync::Arc;
use std::time::Duration;

/// Instants at which a run is compared with the exact one.
const DENSE: usize = 2_000;

pub fn opened(text: &str) -> Arc<dyn Modelled> {
    scenes::register(|_| ());
    (readers().expect("they were given").scene)("drawn", text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn chosen(scene: &Arc<dyn Modelled>, tolerance: f64) -> (TextModels, Receipt) {
    let models = TextModels::of(scene, None);
    let wish = Wish { tolerance, outputs: scene.run().outputs.clone(), allowed: Duration::ZERO };
    let receipt = choose(&models, &wish).expect("it runs");
    (models, receipt)
}

/// The largest error of a choice over a dense run.
fn off(models: &TextModels, receipt: &Receipt, line: usize, choice: &Choice) -> f64 {
    let own = &models.forms(0)[0];
    let dense: Vec<f64> = (1..=DENSE).map(|k| own.span * k as f64 / DENSE as f64).collect();
    let implicit = receipt.lines[0].choice.as_ref().is_some_and(|own| own.plan.method.traits().implicit);
    let method = if implicit { Method::RadauIIA { stages: 7 } } else { Method::DormandPrince8 };
    let (exact, _) = own.run(method, 1e-11, u64::MAX, Some(&dense));
    let (run, _) = models.forms(line)[0].run(choice.plan.method, choice.plan.tolerance, u64::MAX, Some(&dense));
    let (exact, run) = (exact.expect("it runs"), run.expect("it runs"));
    let rows = run.asked.iter().zip(&exact.asked);
    rows.map(|((_, row), (_, exact))| receipt.watched.off(row, exact)).fold(0.0, f64::max)
}

#[test]
fn what_is_taken_of_random_systems_keeps_its_tolerance_over_the_whole_run() {
    let mut smaller = 0;
    for seed in 0..3 * KINDS {
        let (kind, text) = scene(seed);
        let scene = opened(&text);
        for tolerance in [1e-2, 1e-5] {
            let (models, receipt) = chosen(&scene, tolerance);
            let line = receipt.taken.unwrap_or_else(|| panic!("{kind}, seed {seed}, {tolerance:e}: nothing is taken"));
            let choice = receipt.lines[line].choice.as_ref().expect("it runs");
            let off = off(&models, &receipt, line, choice);
            let name = &receipt.lines[line].name;
            assert!(off <= tolerance, "{kind}, seed {seed}, {tolerance:e}: {name} is off by {off:e}\n{text}");
            smaller += usize::from(line > 0);
        }
    }
    assert!(smaller >= 20, "{smaller}");
}

#[test]
#[ignore]
fn survey() {
    let count: u64 = std::env::var("COUNT").ok().and_then(|n| n.parse().ok()).unwrap_or(120);
    let mut all: std::collections::BTreeMap<&str, [usize; 6]> = Default::default();
    for seed in 0..count {
        let (kind, text) = scene(seed);
        let scene = opened(&text);
        for tolerance in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
            let (models, receipt) = chosen(&scene, tolerance);
            let row = all.entry(kind).or_default();
            row[0] += 1;
            let Some(line) = receipt.taken else {
                row[1] += 1;
                println!(
                    "{kind} {seed} {tolerance:e}: nothing taken: own {:?}",
                    receipt.lines[0].choice.as_ref().map(|c| c.promised)
                );
                continue;
            };
            let choice = receipt.lines[line].choice.as_ref().expect("it runs");
            let off = off(&models, &receipt, line, choice);
            if off > tolerance {
                row[2] += 1;
                println!(
                    "BROKEN {kind} {seed} {tolerance:e}: {} off {off:e} promised {:e} {:?} {:e}",
                    receipt.lines[line].name, choice.promised, choice.plan.method, choice.plan.tolerance
                );
            } else if off > choice.promised {
                row[3] += 1;
                println!(
                    "ABOVE {:.2} {kind} {seed} {tolerance:e} {} promised {:e} own T {:e} P2 {:e} {:?}",
                    off / choice.promised,
                    receipt.lines[line].name,
                    choice.promised,
                    choice.plan.tolerance,
                    choice.plan.pilots[1].tolerance,
                    choice.plan.method
                );
            }
            row[4] += usize::from(line > 0);
            let worth = receipt.worth().unwrap_or(f64::NAN);
            if worth > 4.0 {
                row[5] += 1;
            }
        }
    }
    println!("kind: total, nothing, broken, above promise, smaller, price>4");
    for (kind, row) in all {
        println!("{kind}: {row:?}");
    }
}
