//! The domain of a formula, which a proved claim lists as conditions.

use crate::{Finding, PENDULUM, on, on_pendulum, verdict};

fn listed(found: &Finding) -> Vec<&str> {
    found.judged.requires.iter().chain(&found.judged.signs).map(|(text, _)| text.as_str()).collect()
}

#[test]
fn roots_logarithms_divisions_and_tangents_list_their_domains() {
    for (formula, needed) in [
        (r"\sqrt{\theta}\sqrt{\theta} = \theta", "theta >= 0"),
        (r"\ln\theta - \ln\theta = 0", "theta > 0"),
        (r"\frac{m}{\theta} - \frac{m}{\theta} = 0", "theta != 0"),
        (r"\tan\theta\cos\theta = \sin\theta", "cos(theta) != 0"),
        (r"\cot\theta\sin\theta = \cos\theta", "sin(theta) != 0"),
        (r"\theta^{-2} \theta^2 = 1", "theta != 0"),
    ] {
        let found = on_pendulum("identity", formula, "");
        assert_eq!(verdict(&found), "proved", "{}", found.text());
        assert!(listed(&found).contains(&needed), "{}", found.text());
    }
}

#[test]
fn what_hypotheses_say_is_listed_once() {
    let found = on_pendulum("identity", r"\sqrt{m}\sqrt{m} = m", "given = ['m > 0']");
    assert_eq!(listed(&found), ["m > 0"], "{}", found.text());
    let found = on_pendulum("identity", r"\sqrt{\theta^2 + 1}\sqrt{\theta^2 + 1} = \theta^2 + 1", "");
    assert!(listed(&found).is_empty(), "{}", found.text());
}

#[test]
fn a_root_whose_sign_matters_is_refuted() {
    let found = on_pendulum("identity", r"\sqrt{\theta^2} = \theta", "");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
    let offered: Vec<&str> = found.corrections.iter().map(|one| one.changes[0].after.as_str()).collect();
    assert_eq!(offered, [r"\theta \geq 0"], "{}", found.text());
}

#[test]
fn a_divisor_that_vanishes_along_every_motion_makes_a_claim_undefined() {
    let own = r"l\ddot\theta + g\sin\theta";
    let found = on_pendulum("formula", &format!(r"\frac{{m}}{{{own}}} - \frac{{m}}{{{own}}} = 0"), "");
    assert_eq!(verdict(&found), "undefined", "{}", found.text());
}

#[test]
fn hypotheses_have_one_dimension() {
    let found = on_pendulum("formula", r"V = V", r"given = ['m > l']");
    let told = "in the hypothesis m > l";
    assert!(found.judged.objections.iter().any(|objection| objection.contains(told)), "{}", found.text());
    // numbers in hypotheses are in SI units
    let found = on_pendulum("formula", r"V = V", r"given = ['m > 2', 'l = 3']");
    assert!(found.judged.objections.iter().all(|objection| !objection.contains("hypothesis")), "{}", found.text());
}

#[test]
fn identity_testing_has_a_verdict_of_its_own() {
    // a power of a sum with many letters, too long to be expanded
    let system = PENDULUM.replace("[letters]", "[letters]\n'\\mu' = \"theta'\"\n'\\nu' = \"m*l\"");
    let sum = r"(m + l + g + \theta + \mu + \nu + T + V)";
    let formula = format!(r"{sum}^{{40}} - {sum}^{{20}} \cdot {sum}^{{20}} = 0");
    let found = on(&system, "identity", &formula, "");
    assert!(["proved", "identified"].contains(&verdict(&found)), "{}", found.text());
    assert!(verdict(&found) == "proved" || found.judged.evidence.contains("probability of error"), "{}", found.text());
}
