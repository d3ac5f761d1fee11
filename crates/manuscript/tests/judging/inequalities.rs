//! Inequalities of polynomials: squares, discriminants, real roots, and hypotheses.

use crate::{PENDULUM, on, on_pendulum, verdict};
use dalembert_manuscript::EditKind;

fn found(formula: &str, given: &str) -> (&'static str, String) {
    let found = on_pendulum("inequality", formula, &format!("given = [{given}]"));
    (verdict(&found), found.text())
}

#[test]
fn squares_are_seen_behind_a_sum() {
    for (formula, given, expected) in [
        (r"m^2 - m l + l^2 \geq 0", "", "proved"),
        (r"m^2 + l^2 \geq 2 m l", "", "proved"),
        (r"m^2 - 2 m l + l^2 > 0", "", "refuted"),
        (r"m^2 + l^2 + g^2 - m l - l g - g m \geq 0", "", "proved"),
        (r"m^2 + l^2 + g^2 - 2 m l - 2 l g - 2 g m \geq 0", "", "refuted"),
        (r"m^4 - m^2 l^2 + l^4 \geq 0", "", "proved"),
        (r"\theta^2 - 2\theta + 2 > 0", "", "proved"),
        (r"\theta^4 - 2\theta^2 + 1 \geq 0", "", "proved"),
        (r"\theta^4 - 2\theta^2 + 1 > 0", "", "refuted"),
        (r"1000\theta^2 - 2001\theta + 1001 > 0", "", "refuted"),
    ] {
        let (verdict, text) = found(formula, given);
        assert_eq!(verdict, expected, "{text}");
    }
}

#[test]
fn hypotheses_about_signs_are_used() {
    for (formula, given, expected) in [
        (r"m^3 - 3 m l^2 + 2 l^3 \geq 0", "'m > 0', 'l > 0'", "proved"),
        (r"m^3 - 3 m l^2 + 2 l^3 \geq 0", "", "refuted"),
        (r"m > l", "'m > 2 l', 'l > 0'", "proved"),
        (r"m > l", "'m > 2 l'", "refuted"),
        (r"m l > l^2", "'m > l', 'l > 0'", "proved"),
        (r"\frac{m}{m + l} < 1", "'m > 0', 'l > 0'", "proved"),
        (r"T \geq 0", "'m > 0'", "proved"),
        (r"V \leq m g l", "'m > 0', 'g > 0', 'l > 0'", "proved"),
        (r"\sin\theta \leq 1", "", "proved"),
        (r"\sin\theta < 1", "", "refuted"),
        (r"\sin\theta + \cos\theta \leq 1", "", "refuted"),
    ] {
        let (verdict, text) = found(formula, given);
        assert_eq!(verdict, expected, "{text}");
    }
}

#[test]
fn what_is_open_says_why() {
    let (verdict, text) = found(r"m^2 l^4 + m^4 l^2 + g^6 - 3 m^2 l^2 g^2 \geq 0", "");
    // Motzkin's polynomial is not negative, and no sum of squares
    assert_eq!(verdict, "undecided", "{text}");
    assert!(text.contains("neither the signs of its terms nor squares"), "{text}");
    assert!(PENDULUM.contains("theta"));
}

#[test]
fn an_inequality_has_one_dimension_and_its_correction_says_something() {
    let found = on_pendulum("inequality", r"m + 1 > 0", "given = ['m > 0']");
    assert!(!found.judged.objections.is_empty(), "{}", found.text());
    let found = on_pendulum("inequality", r"\frac{1}{\theta} \geq 0", "");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
    assert!(found.corrections.iter().all(|one| one.formula != r"\frac{\theta}{\theta} \geq 0"), "{}", found.text());
}

/// No counterexample gives pi another value, or the sine of an angle a value that belongs to another angle.
#[test]
fn a_point_that_refutes_is_one_of_real_numbers() {
    for (formula, given) in [
        (r"\pi > 3", ""),
        (r"\pi m > 3 m", r"'m > 0'"),
        (r"l > 3 m", r"'l > \pi m', 'm > 0'"),
        (r"\theta > 1", r"'\theta > \pi/3'"),
        (r"\cos\theta > 0", r"'\theta > -1', '\theta < 1'"),
        (r"\sin\theta > 0", r"'\theta > 0', '\theta < \pi'"),
    ] {
        let (verdict, text) = found(formula, given);
        assert_ne!(verdict, "refuted", "{text}");
    }
    // both sides are equal under the hypothesis
    let found =
        on_pendulum("identity", r"\sqrt{1 - \sin^2\theta} = \cos\theta", r"given = ['\theta \geq 0', '\theta \leq 1']");
    assert_ne!(verdict(&found), "refuted", "{}", found.text());
    // without a hypothesis angle and sine are chosen independently: some angle violates this equation
    let found = on_pendulum("identity", r"\sin\theta = \theta", "");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
}

#[test]
fn a_relation_that_admits_equality_is_a_correction_with_the_point_of_equality() {
    for (formula, given, corrected, at) in [
        ("T > 0", "'m > 0'", r"T \geq 0", "T = 0"),
        (r"\theta^2 + 1 > 2 \theta", "", r"\theta^2 + 1 \geq 2 \theta", "theta = 1"),
        (r"2 \cos\theta < 2", "", r"2 \cos\theta \leq 2", "cos(theta) = 1"),
        (r"\sqrt{m^2} > m", "", r"\sqrt{m^2} \geq m", "m = "),
    ] {
        let found = on_pendulum("inequality", formula, &format!("given = [{given}]"));
        let [first] = &found.corrections[..] else { panic!("{}", found.text()) };
        assert_eq!((verdict(&found), first.formula.as_str()), ("refuted", corrected), "{}", found.text());
        assert_eq!(first.changes[0].kind, EditKind::Strictness);
        let words = &first.changes[0].words;
        assert!(words.contains("both sides are equal at") && words.contains(at), "{words}");
    }
    // at a point of equality the inequality fails too, so that the direction is corrected
    let found = on_pendulum("inequality", r"\theta^2 + 2 < 2 \theta", "");
    let directions: Vec<EditKind> = found.corrections.iter().map(|one| one.changes[0].kind).collect();
    assert_eq!(directions, [EditKind::Direction], "{}", found.text());
}

/// A rod pendulum in Cartesian coordinates.
const ROD: &str = r#"
title = "Rod"
[parameters]
m = "kg"
l = "m"
[coordinates]
x = "m"
y = "m"
[bodies.bob]
centre = "O + x*N.x + y*N.y"
mass = "m"
[[constraint]]
name = "rod"
zero = "x^2 + y^2 - l^2"
[letters]
'l' = "l"
'x' = "x"
'y' = "y"
"#;

#[test]
fn points_on_a_constraint_of_squares_refute() {
    let found = on(ROD, "inequality", "x^2 < l^2", "");
    let [first] = &found.corrections[..] else { panic!("{}", found.text()) };
    assert_eq!((verdict(&found), first.formula.as_str()), ("refuted", r"x^2 \leq l^2"), "{}", found.text());
    assert!(found.judged.counterexample.contains(&("y".to_owned(), "0".to_owned())), "{}", found.text());
    assert_eq!(verdict(&on(ROD, "inequality", "x < y", "")), "refuted");
}
