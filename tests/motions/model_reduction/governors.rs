//! Model reduction of the governors.

use super::{of_mechanism, truly};
use dalembert_derivations::studies::model_reduction::{Hierarchy, Loss};

fn effectivity(ladder: &Hierarchy, outputs: &[&str], name: &str) -> (f64, f64) {
    let names: Vec<String> = outputs.iter().map(|name| (*name).to_owned()).collect();
    let (watched, _) = ladder.watched(&names).expect("it runs");
    let reduced =
        ladder.models.iter().find(|reduced| reduced.name == name).unwrap_or_else(|| panic!("{name} is on the ladder"));
    let found = ladder.estimate(reduced, &watched, 1e-8).expect("it is carried");
    let error = truly(ladder, reduced, &found, &watched).expect("it runs");
    (error, found.first / error)
}

#[test]
fn friction_across_never_matters_to_a_wheel_that_is_led_and_does_to_one_that_is_pushed() {
    for (name, exact) in
        [("governors/drum_programme", true), ("governors/between_discs", true), ("governors/released", false)]
    {
        let ladder = of_mechanism(name, "span = \"1 s\"");
        let reduced =
            ladder.models.iter().find(|reduced| reduced.name == "frictionless across").expect("it has friction");
        assert_eq!(reduced.loss == Loss::Nothing { claim: None }, exact, "{name}");
    }
    let released = of_mechanism("governors/released", "span = \"0.2 s\"");
    let (error, effectivity) = effectivity(&released, &["rho", "omega2"], "frictionless across");
    assert!(error > 1e-4 && (effectivity - 1.0).abs() < 0.1, "{error} {effectivity}");
}

#[test]
fn a_series_that_is_cut_off_is_off_by_what_is_estimated() {
    let ladder = of_mechanism("governors/drum_programme", "span = \"0.5 s\"");
    let mut last = f64::INFINITY;
    for name in ["series to eps", "series to eps^2", "series to eps^4"] {
        let (error, effectivity) = effectivity(&ladder, &["rho"], name);
        assert!(error < last && (effectivity - 1.0).abs() < 0.05, "{name}: {error:e} {effectivity}");
        last = error;
    }
}

#[test]
fn rims_that_say_less_are_off_by_what_is_estimated() {
    let ladder = of_mechanism("governors/elastic_stable", "span = \"1 s\"");
    for name in ["rim relaxed", "rigid wheel that slides", "rigid rim"] {
        let (error, effectivity) = effectivity(&ladder, &["omega1", "x"], name);
        assert!(error > 0.0 && (effectivity - 1.0).abs() < 0.1, "{name}: {error:e} {effectivity}");
    }
}
