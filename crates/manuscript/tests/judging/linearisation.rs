//! Linearised equations have no terms of second order, and all terms of first order.

use crate::{PENDULUM, on, on_pendulum, verdict};

#[test]
fn small_angles_make_an_oscillator() {
    let about = |given: &str| format!("resting = ['\\theta']\ngiven = ['{given}']");
    for (formula, given, expected) in [
        (r"\ddot\theta + \frac{g}{l} \theta = 0", r"\theta = 0", "proved"),
        (r"m l^2 \ddot\theta + m g l \sin\theta = 0", r"\theta = 0", "proved"),
        (r"\ddot\theta + \frac{g}{l} \left(\theta + \theta^3\right) + \dot\theta^2 = 0", r"\theta = 0", "proved"),
        (r"\ddot\theta - \frac{g}{l} \theta = 0", r"\theta = 0", "refuted"),
        (r"\ddot\theta + \frac{g}{l} \theta + \dot\theta = 0", r"\theta = 0", "refuted"),
        (r"\ddot\theta + \frac{g}{l} = 0", r"\theta = 0", "refuted"),
        (r"\ddot\theta - \frac{g}{l} (\theta - \pi) = 0", r"\theta = \pi", "proved"),
        (r"\ddot\theta + \frac{g}{l} (\theta - \pi) = 0", r"\theta = \pi", "refuted"),
    ] {
        let found = on_pendulum("linearised equation", formula, &about(given));
        assert_eq!(verdict(&found), expected, "{}", found.text());
    }
}

#[test]
fn a_slip_in_a_linearised_equation_is_corrected() {
    let more = "resting = ['\\theta']\ngiven = ['\\theta = 0']";
    let found = on_pendulum("linearised equation", r"\ddot\theta - \frac{g}{l} \theta = 0", more);
    assert_eq!(found.corrections[0].formula, r"\ddot\theta + \frac{g}{l} \theta = 0", "{}", found.text());
    assert!(found.judged.evidence.contains("first order in theta"), "{}", found.text());
}

#[test]
fn inputs_are_small_where_no_hypothesis_gives_them() {
    let driven = PENDULUM.replace(
        "[letters]",
        "[inputs]\ntau = \"N m\"\n[[force]]\nalong = \"theta\"\nis = \"tau\"\n[letters]\n'\\tau' = \"tau\"",
    );
    let more = "resting = ['\\theta']\ngiven = ['\\theta = 0']";
    let found = on(&driven, "linearised equation", r"m l^2 \ddot\theta + m g l \theta = \tau", more);
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    let found = on(&driven, "linearised equation", r"m l^2 \ddot\theta + m g l \theta = 0", more);
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
}

/// At a right angle the weight accelerates the pendulum: small motions about this angle do not exist.
#[test]
fn letters_that_do_not_stay_constant_are_told_with_their_acceleration() {
    let about = |given: &str| format!("resting = ['\\theta']\ngiven = [{given}]");
    for (formula, given) in
        [(r"l \ddot\theta + g = 0", r"'\theta = \frac{\pi}{2}'"), (r"l \ddot\theta = 0", r"'\theta = 1'")]
    {
        let found = on_pendulum("linearised equation", formula, &about(given));
        assert_eq!(verdict(&found), "undefined", "{}", found.text());
        assert!(found.judged.evidence.contains("give theta'' = -g"), "{}", found.text());
    }
    // without a value of the angle the equation holds at equilibria, and a wrong equation fails at one of them
    let found = on_pendulum("linearised equation", r"l \ddot\theta + g\sin\theta = 0", &about(""));
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    assert!(found.judged.requires.iter().any(|(told, _)| told == "sin(theta) = 0"), "{}", found.text());
    let found = on_pendulum("linearised equation", r"l \ddot\theta + g \theta = 0", &about(""));
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
    assert!(found.judged.counterexample.contains(&("theta".to_owned(), "pi".to_owned())), "{}", found.text());
}
