//! The terms missing in a printed formula, in the letters of the paper.

use crate::{PENDULUM, on, verdict};
use dalembert_manuscript::Finding;

fn missing(found: &Finding) -> &str {
    found.judged.difference.as_ref().map_or_else(|| panic!("{}", found.text()), |(text, _)| text.as_str())
}

/// A bead on a hoop that turns about the vertical.
const HOOP: &str = r#"
title = "A bead on a hoop"
gravity = "-g*N.y"
[parameters]
m = "kg"
l = "m"
g = "m/s^2"
W = "rad/s"
[coordinates]
theta = "rad"
[frames]
B = "N turned W*t about y"
A = "B turned theta about z"
[bodies.bead]
centre = "O - l*A.y"
mass = "m"
[letters]
'm' = "m"
'l' = "l"
'g' = "g"
'\Omega' = "W"
'\theta' = "theta"
"#;

#[test]
fn a_condition_of_a_steady_motion_is_told_the_term_that_it_lacks() {
    let more = "resting = ['\\theta']\ngiven = ['m > 0', 'l > 0']";
    let found = on(HOOP, "steady motion", r"m g l \sin\theta = 0", more);
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
    let told = missing(&found);
    assert!(told.contains("Omega^2") && !told.contains("*g*"), "{}", found.text());
    assert!(found.judged.evidence.contains("a multiple of the equation of theta"), "{}", found.text());
}

#[test]
fn a_wrong_condition_beside_the_right_one_is_refuted_on_a_motion() {
    let claim = |number: u32, formula: &str| {
        format!(
            "[[claim]]\nequation = \"{number}\"\nkind = \"steady motion\"\nformula = '{formula}'\nresting = ['\\theta']\n"
        )
    };
    let given = "given = ['g > 0', 'm > 0', 'l > 0']\n";
    for (system, right, wrong) in [
        (PENDULUM, r"\sin\theta = 0", r"\cos\theta = 0"),
        (HOOP, r"(\sin\theta) (l \Omega^2 \cos\theta - g) = 0", r"(\sin\theta) (l \Omega^2 - g) = 0"),
        (HOOP, r"(\sin\theta) (l \Omega^2 \cos\theta - g) = 0", r"\cos\theta = 1"),
    ] {
        for order in [[right, wrong], [wrong, right]] {
            let text = format!("{system}\n{}{given}{}{given}", claim(1, order[0]), claim(2, order[1]));
            let found = crate::judged(&text).unwrap_or_else(|error| panic!("{error}"));
            for (finding, formula) in found.iter().zip(order) {
                let expected = if formula == right { "proved" } else { "refuted" };
                assert_eq!(verdict(finding), expected, "{}", finding.text());
            }
        }
    }
}

#[test]
fn a_letter_for_a_product_is_told_where_the_print_has_it() {
    let system = PENDULUM.replace(
        "'h' =",
        r"'\kappa' = 'm*g*l'
'h' =",
    );
    let found = on(&system, "equation of motion", r"m l^2 \ddot\theta + \kappa \cos\theta = 0", "");
    assert_eq!(missing(&found), "cos(theta)*kappa - kappa*sin(theta)", "{}", found.text());
    let found = on(&system, "equation of motion", r"m l^2 \ddot\theta + m g l \cos\theta = 0", "");
    assert!(!missing(&found).contains("kappa"), "{}", found.text());
}

/// A satellite whose direction cosines are letters of the paper.
const SATELLITE: &str = r#"
title = "A satellite"
[parameters]
A = "kg m^2"
B = "kg m^2"
C = "kg m^2"
w = "rad/s"
[coordinates]
[frames]
F = "N free"
[definitions]
g1 = "F.x . N.z"
g2 = "F.y . N.z"
g3 = "F.z . N.z"
[bodies.body]
frame = "F"
inertia = { principal = ["A", "B", "C"] }
[[torque]]
on = "body"
is = "3*w^2*((C - B)*g2*g3*F.x + (A - C)*g3*g1*F.y + (B - A)*g1*g2*F.z)"
[letters]
'A' = "A"
'B' = "B"
'C' = "C"
'\omega_0' = "w"
'p' = "F.wx"
'q' = "F.wy"
'r' = "F.wz"
'\gamma_1' = "F.x . N.z"
'\gamma_2' = "F.y . N.z"
'\gamma_3' = "F.z . N.z"
'\alpha_1' = "F.x . N.x"
'\alpha_2' = "F.y . N.x"
'\alpha_3' = "F.z . N.x"
'\beta_1' = "F.x . N.y"
'\beta_2' = "F.y . N.y"
'\beta_3' = "F.z . N.y"
"#;

#[test]
fn direction_cosines_are_told_by_the_fewest_products() {
    let printed = r"B \dot{q} + (A - C) p r = 3 \omega_0^2 (A - C) \gamma_1 \gamma_3 + \omega_0^2 A (\alpha_1\alpha_3 + \beta_1\beta_3)";
    let found = on(SATELLITE, "equation of motion", printed, "");
    assert_eq!(missing(&found), "A*gamma_1*gamma_3*omega_0^2", "{}", found.text());
}

#[test]
fn conditions_that_always_hold_are_left_out() {
    let printed = r"\dot{q} + \frac{A - C}{B} p r = \frac{3 \omega_0^2 (A - C)}{B} \gamma_1 \gamma_3";
    let found = on(SATELLITE, "equation of motion", printed, "given = ['B > 0']");
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    let requires: Vec<&str> = found.judged.requires.iter().map(|(text, _)| text.as_str()).collect();
    assert!(requires.iter().all(|line| !line.contains("F.q") && !line.starts_with("B !=")), "{requires:?}");
}
