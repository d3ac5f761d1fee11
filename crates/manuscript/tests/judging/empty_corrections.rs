//! Corrections without content are not proposed: factors that vanish on the motion, or that multiply the whole claim.

use crate::{PENDULUM, on, on_pendulum};

#[test]
fn no_factor_of_a_correction_vanishes() {
    let given = r"given = ['\dot\theta = 0']";
    for formula in ["T = m l", r"T + V = 2 m g", r"T = m l^2 \dot\theta + m"] {
        let found = on_pendulum("formula", formula, given);
        let rates = |of: &str| of.matches(r"\dot").count();
        assert!(found.corrections.iter().all(|one| rates(&one.formula) <= rates(formula)), "{}", found.text());
    }
    let found = on_pendulum("equation of motion", r"m l^2 \ddot\theta + m g l \sin\theta = 2 m", "");
    assert_eq!(found.corrections[0].formula, r"m l^2 \ddot\theta + m g l \sin\theta = 0", "{}", found.text());
}

#[test]
fn no_input_multiplies_a_whole_correction() {
    let system = PENDULUM.replace("[letters]", "[inputs]\nu = \"N*m\"\n[letters]\n'u' = \"u\"");
    let found = on(&system, "equation of motion", r"m l^2 \ddot\theta = u m g l \sin\theta", "");
    assert!(!found.corrections.is_empty(), "{}", found.text());
    assert!(found.corrections.iter().all(|one| !one.formula.contains('u')), "{}", found.text());
}

/// An acceleration would be zero only without gravity.
#[test]
fn no_hypothesis_takes_the_weight_away() {
    let found = on_pendulum("formula", "T + V = 0", r"given = ['\dot\theta = 0']");
    assert!(found.corrections.iter().all(|one| !one.changes[0].after.contains("ddot")), "{}", found.text());
}
