//! Several conditions of a steady motion that define one motion together.

use crate::{judged, on, verdict};
use dalembert_manuscript::Finding;

/// A pendulum with a spring as its rod, in a plane that rotates about the vertical.
const SPRING: &str = r#"
title = "Spring"
gravity = "-g*N.y"
[parameters]
m = "kg"
k = "N/m"
l = "m"
g = "m/s^2"
W = "rad/s"
[coordinates]
r = "m"
theta = "rad"
[frames]
B = "N turned W*t about y"
A = "B turned theta about z"
[points]
P = "O - r*A.y"
[bodies.bob]
centre = "P"
mass = "m"
[energies]
potential = "k/2*(r - l)^2"
[letters]
'm' = "m"
'k' = "k"
'l' = "l"
'g' = "g"
'\Omega' = "W"
'r' = "r"
'\theta' = "theta"
"#;

const RESTING: &str = r"resting = ['r', '\theta']
given = ['\sin\theta \neq 0', 'k > 0']";

fn claims(formulas: &[&str]) -> Vec<Finding> {
    let claim = |(place, formula): (usize, &&str)| {
        format!("[[claim]]\nequation = \"{}\"\nkind = \"steady motion\"\nformula = '{formula}'\n{RESTING}\n", place + 1)
    };
    let text = format!("{SPRING}\n{}", formulas.iter().enumerate().map(claim).collect::<String>());
    judged(&text).unwrap_or_else(|error| panic!("{error}"))
}

const ANGLE: &str = r"r \Omega^2 \cos\theta = g";
const LENGTH: &str = r"k (r - l) = m r \Omega^2";

#[test]
fn two_displays_of_one_motion_say_one_thing() {
    for found in claims(&[ANGLE, LENGTH]) {
        assert_eq!(verdict(&found), "proved", "{}", found.text());
        assert!(found.judged.evidence.contains("together with eq"), "{}", found.text());
        assert!(found.judged.requires.iter().any(|(told, _)| told == "r != 0"), "{}", found.text());
    }
    // one condition alone does not determine the motion
    for formula in [ANGLE, LENGTH] {
        assert_eq!(verdict(&claims(&[formula])[0]), "refuted");
    }
}

/// With the first condition the second is `k*(r - l) = m*g/cos(theta)`, which has no value where `cos(theta) = 0`.
#[test]
fn a_line_that_divides_is_judged_where_it_has_values() {
    for found in claims(&[ANGLE, r"k (r - l) = \frac{m g}{\cos\theta}"]) {
        assert_eq!(verdict(&found), "proved", "{}", found.text());
        assert!(found.judged.requires.iter().any(|(told, _)| told.contains("cos")), "{}", found.text());
    }
    // a point refutes one condition only if it satisfies the other
    let lines = claims(&[ANGLE, r"k (r - l) \cos\theta = m g"]);
    assert!(lines.iter().all(|found| verdict(found) != "refuted"), "{}", lines[1].text());
}

#[test]
fn lines_of_one_display_say_one_thing() {
    let display = format!("\\begin{{aligned}} {ANGLE}, \\\\\\\\ {LENGTH} \\end{{aligned}}");
    let found = claims(&[&display.replace("\\\\\\\\", "\\\\")]);
    assert_eq!(found.iter().map(verdict).collect::<Vec<_>>(), ["proved", "proved"], "{}", found[0].text());
}

#[test]
fn a_wrong_partner_is_refuted_and_corrected_and_the_other_one_is_a_part() {
    let found = claims(&[ANGLE, r"k (r - l) = 2 m r \Omega^2"]);
    assert_eq!(found.iter().map(verdict).collect::<Vec<_>>(), ["undecided", "refuted"], "{}", found[0].text());
    assert!(found[0].judged.evidence.contains("a part of the condition"), "{}", found[0].text());
    let [first, ..] = &found[1].corrections[..] else { panic!("{}", found[1].text()) };
    assert_eq!(first.formula, r"k (r - l) = m r \Omega^2", "{}", found[1].text());
}

#[test]
fn a_rate_that_rests_corrects_nothing() {
    let found = claims(&[ANGLE, r"k (r - l) = m g + m r \Omega^2"]);
    let offered: Vec<&str> = found[1].corrections.iter().map(|one| one.formula.as_str()).collect();
    assert!(offered.iter().all(|formula| !formula.contains("dot")), "{offered:?}");
    assert!(offered.iter().any(|formula| !formula.contains("m g")), "{offered:?}");
}

#[test]
fn motions_with_other_hypotheses_are_not_joined() {
    let claim = |given: &str, formula: &str, number: u32| {
        format!(
            "[[claim]]\nequation = \"{number}\"\nkind = \"steady motion\"\nformula = '{formula}'\nresting = ['r', '\\theta']\ngiven = [{given}]\n"
        )
    };
    let text = format!(
        "{SPRING}\n{}{}",
        claim(r"'\sin\theta \neq 0', 'k > 0'", ANGLE, 1),
        claim(r"'\cos\theta \neq 0', 'k > 0'", LENGTH, 2)
    );
    let found = judged(&text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(found.iter().map(verdict).collect::<Vec<_>>(), ["refuted", "refuted"]);
}

#[test]
fn a_root_is_the_square_root_of_one_sign() {
    let found = on(SPRING, "equivalence", r"\Omega^2 r = g \iff \Omega = \sqrt{\frac{g}{r}}", "given = ['r > 0']");
    let offered: Vec<&str> = found.corrections.iter().map(|one| one.changes[0].after.as_str()).collect();
    assert_eq!((verdict(&found), &offered[..]), ("refuted", &[r"\Omega \geq 0"][..]), "{}", found.text());
}

#[test]
fn an_equality_that_always_holds_states_no_condition() {
    for empty in ["r = r", r"\dot{r} = 0", r"r \dot{\theta} = \dot{r}"] {
        let found = claims(&[ANGLE, LENGTH, empty]);
        let verdicts: Vec<&str> = found.iter().map(verdict).collect();
        assert_eq!(verdicts, ["proved", "proved", "undefined"], "{}", found[2].text());
        assert!(found[2].judged.evidence.contains("no condition is stated"), "{}", found[2].text());
        assert!(found[..2].iter().all(|one| !one.judged.evidence.contains("eq3")), "{}", found[0].text());
    }
}

/// A cart with a pendulum, pulled by a force.
const CART: &str = r#"
title = "Cart"
gravity = "-g*N.y"
[parameters]
M = "kg"
m = "kg"
l = "m"
g = "m/s^2"
[coordinates]
x = "m"
theta = "rad"
[inputs]
F = "N"
[frames]
A = "N turned theta about z"
[bodies.cart]
centre = "O + x*N.x"
mass = "M"
[bodies.bob]
centre = "O + x*N.x - l*A.y"
mass = "m"
[[force]]
on = "cart"
is = "F*N.x"
[letters]
'M' = "M"
'm' = "m"
'l' = "l"
'g' = "g"
'x' = "x"
'\theta' = "theta"
'F' = "F"
"#;

#[test]
fn conditions_that_no_letter_solves_are_those_of_the_motion_by_combination() {
    let claim = |number: u32, formula: &str| {
        format!(
            "[[claim]]\nequation = \"{number}\"\nkind = \"steady motion\"\nformula = '{formula}'\nresting = ['x', '\\theta']\n\
             given = ['g > 0', 'M > 0', 'm > 0', 'l > 0']\n"
        )
    };
    let text = format!("{CART}\n{}{}", claim(1, "F = 0"), claim(2, r"\sin\theta = 0"));
    for found in judged(&text).unwrap_or_else(|error| panic!("{error}")) {
        assert_eq!(verdict(&found), "proved", "{}", found.text());
    }
    let text = format!("{CART}\n{}{}", claim(1, "F = 0"), claim(2, r"m g l \sin\theta + F l = 0"));
    for found in judged(&text).unwrap_or_else(|error| panic!("{error}")) {
        assert_eq!(verdict(&found), "proved", "{}", found.text());
    }
}
