//! Counterexamples are physically possible: masses, lengths and inertias have admissible values.

use crate::{PENDULUM, on, on_pendulum, verdict};
use dalembert_manuscript::Finding;

fn value(found: &Finding, letter: &str) -> String {
    let all = &found.judged.counterexample;
    all.iter().find(|(name, _)| name == letter).map_or_else(|| panic!("{}", found.text()), |(_, value)| value.clone())
}

#[test]
fn masses_and_lengths_are_positive_wherever_the_claim_fails_so() {
    for (kind, formula, given) in [
        ("inequality", r"m g l > m", ""),
        ("inequality", r"\frac{l}{m} < g", ""),
        ("identity", r"\sqrt{l^2 + m^2} = l + m", ""),
        ("equivalence", r"m l = g \iff m = g", ""),
        ("formula", r"T = m l", "given = ['m + l = g']"),
    ] {
        let found = on_pendulum(kind, formula, given);
        assert_eq!(verdict(&found), "refuted", "{}", found.text());
        for letter in ["m", "l"] {
            assert!(!value(&found, letter).starts_with(['-', '0']), "{}", found.text());
        }
        assert!(!found.judged.evidence.contains("no point was found"), "{}", found.text());
    }
}

#[test]
fn a_negative_mass_is_told_in_words() {
    let found = on_pendulum("inequality", r"m l^2 \geq 0", "");
    assert!(value(&found, "m").starts_with('-'), "{}", found.text());
    assert!(
        found.judged.evidence.ends_with("no point was found at which it fails with positive m"),
        "{}",
        found.text()
    );
    // the hypothesis fixes the mass, so that no choice is reported
    let found = on_pendulum("inequality", r"m l^2 \geq 0", "given = ['m = -1']");
    assert!(!found.judged.evidence.contains("no point was found"), "{}", found.text());
}

#[test]
fn a_parameter_that_vanishes_at_every_counterexample_is_told() {
    let given = r"resting = ['\theta']";
    let found = on_pendulum("steady motion", r"\sin\theta = 0", given);
    assert_eq!(value(&found, "g"), "0", "{}", found.text());
    assert!(found.judged.evidence.ends_with("at which it fails and g does not vanish"), "{}", found.text());
    let offered: Vec<&str> = found.corrections.iter().map(|one| one.changes[0].after.as_str()).collect();
    assert_eq!(offered, [r"g \neq 0"], "{}", found.text());
}

#[test]
fn cosine_and_sine_of_an_angle_are_on_one_circle() {
    let found = on(PENDULUM, "equivalence", r"g \cos\theta = l \iff g = l", r"given = ['\sin\theta \neq 0']");
    let [cos, sin] = ["cos(theta)", "sin(theta)"].map(|name| {
        let text = value(&found, name);
        let (above, below) = text.split_once('/').unwrap_or((&text, "1"));
        above.parse::<f64>().expect("a number") / below.parse::<f64>().expect("a number")
    });
    assert!((cos * cos + sin * sin - 1.0).abs() < 1e-12, "{}", found.text());
}

#[test]
fn another_rest_is_shown_rather_than_a_world_without_weight() {
    let found = on_pendulum("steady motion", r"\theta = 0", r"resting = ['\theta']");
    assert_eq!(value(&found, "theta"), "pi", "{}", found.text());
    assert!(!value(&found, "g").starts_with(['-', '0']), "{}", found.text());
}
