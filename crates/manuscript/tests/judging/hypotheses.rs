//! Hypotheses of claims, and the motions that satisfy them.

use crate::{PENDULUM, on_pendulum, refused, verdict};

fn claim(kind: &str, formula: &str, given: &str) -> String {
    format!("{PENDULUM}\n[[claim]]\nequation = \"1\"\nkind = \"{kind}\"\nformula = '{formula}'\ngiven = [{given}]\n")
}

#[test]
fn a_hypothesis_that_holds_at_an_instant_proves_no_integral() {
    let energy = r"T - V = \mathrm{const}";
    for (formula, given) in [
        (energy, r"'\dot\theta = 0'"),
        (r"\dot\theta = \mathrm{const}", r"'\theta = 0'"),
        (r"\theta^2 = \mathrm{const}", r"'\dot\theta = 0', 'm > 0'"),
    ] {
        let told = refused(&claim("integral of motion", formula, given));
        assert!(told.contains("holds at an instant alone"), "{told}");
    }
    // at rest in an equilibrium both hypotheses hold at all times
    let found = on_pendulum("integral of motion", energy, r"given = ['\theta = 0', '\dot\theta = 0']");
    assert_eq!(verdict(&found), "proved", "{}", found.text());
}

#[test]
fn hypotheses_that_contradict_each_other_state_nothing() {
    for given in ["'m > 0', 'm < 0'", r"'m = 0', 'm \neq 0'", "'g = -1', 'g > 0'"] {
        let told = refused(&claim("formula", "V = V", given));
        assert!(told.contains("contradict each other"), "{told}");
    }
    // the rational bounds of pi are internal, and not printed
    let told = refused(&claim("formula", "V = V", r"'\theta > \pi', '\theta < 2'"));
    assert!(told.contains("`theta < 2`") && !told.contains("333/106"), "{told}");
}

#[test]
fn what_vanishes_along_every_motion_divides_nothing() {
    let own = r"l\ddot\theta + g\sin\theta";
    for formula in [
        format!(r"\frac{{{own}}}{{{own}}} = 1"),
        format!(r"\frac{{m l\ddot\theta}}{{{own}}} + \frac{{m g\sin\theta}}{{{own}}} = m"),
    ] {
        let found = on_pendulum("equation of motion", &formula, "");
        assert_eq!(verdict(&found), "undefined", "{}", found.text());
    }
}

#[test]
fn a_root_of_what_is_negative_is_no_value() {
    let found = on_pendulum("identity", r"\sqrt{-l^2 - 1} = \sqrt{-l^2 - 1} + 0 m", "");
    assert_eq!(verdict(&found), "undefined", "{}", found.text());
    assert!(found.text().contains("has no real value"), "{}", found.text());
}

#[test]
fn a_tie_is_told_and_a_printed_zero_confirms_nothing() {
    let data = r"given = ['m = 1', 'l = 0.5', '\dot\theta = 1']";
    for printed in ["0.12", "0.13"] {
        let found = on_pendulum("number", &format!("T = {printed}"), data);
        assert_eq!(verdict(&found), "enclosed", "{}", found.text());
        assert!(found.text().contains("a tie"), "{}", found.text());
    }
    assert_eq!(verdict(&on_pendulum("number", "T = 0.11", data)), "refuted");
    let found = on_pendulum("number", "T = 0", data);
    assert_eq!(verdict(&found), "undecided", "{}", found.text());
    assert!(found.text().contains("no significant digit"), "{}", found.text());
}

#[test]
fn an_angle_that_is_a_part_of_pi_has_its_cosine() {
    for (given, formula, expected) in [
        (r"\theta = \pi", "V = m g l", "proved"),
        (r"\theta = \pi", "V = -m g l", "refuted"),
        (r"\theta = \frac{\pi}{3}", r"V = -\frac{1}{2} m g l", "proved"),
    ] {
        let found = on_pendulum("formula", formula, &format!("given = ['{given}']"));
        assert_eq!(verdict(&found), expected, "{}", found.text());
    }
}

/// A hypothesis with a numerical value sets a scale; an equality of letters does not.
#[test]
fn an_equality_of_letters_keeps_the_check_of_dimensions() {
    for (given, is_checked) in [("h = l", true), (r"\theta = \frac{\pi}{3}", true), ("l = 1", false)] {
        let found = on_pendulum("formula", "m = 2 g", &format!("given = ['{given}']"));
        assert_eq!(found.judged.evidence.contains("has the dimension"), is_checked, "{}", found.text());
    }
}

#[test]
fn the_order_of_hypotheses_does_not_matter() {
    for (formula, given) in [
        (r"\ddot\theta = 0", ["'m = 0'", "'g = 0'", "'l = 2'"]),
        ("T = 0", ["'l = 0'", "'m = 2'", "'g = 3'"]),
        (r"T = m \dot\theta^2", ["'m = 3'", r"'l = \sqrt{2}'", r"'\theta = \pi'"]),
    ] {
        let orders = [[0, 1, 2], [2, 1, 0], [1, 0, 2], [1, 2, 0]];
        let verdicts = orders.map(|order| {
            let given = order.map(|place| given[place]).join(", ");
            let found = on_pendulum("formula", formula, &format!("given = [{given}]"));
            assert!(found.judged.objections.is_empty(), "{}", found.text());
            verdict(&found)
        });
        assert!(verdicts.iter().all(|one| *one == verdicts[0]), "{formula}: {verdicts:?}");
    }
}

#[test]
fn a_formula_that_holds_for_all_values_of_its_letters_says_nothing() {
    for formula in ["0 = 0", "T = T", "m l + g = g + l m"] {
        let found = on_pendulum("formula", formula, "");
        assert!(found.judged.evidence.ends_with("says nothing of the model"), "{}", found.text());
    }
    let found = on_pendulum("formula", r"T = \frac{1}{2} m l^2 \dot\theta^2", "");
    assert!(!found.judged.evidence.contains("says nothing"), "{}", found.text());
}
