//! Corrections that an author would accept: they state something about the model, and change little of the printed formula.

use crate::{PENDULUM, on, on_pendulum, verdict};
use dalembert_manuscript::{EditKind, Finding};

/// A physical pendulum on a cart.
const CART: &str = r#"
title = "A physical pendulum on a cart"
gravity = "-g*N.y"
[parameters]
M = "kg"
m = "kg"
l = "m"
J = "kg m^2"
g = "m/s^2"
[coordinates]
x = "m"
a = "rad"
[frames]
A = "N turned a about z"
[points]
C = "O + x*N.x"
P = "C - l*A.y"
[bodies.cart]
centre = "C"
mass = "M"
[bodies.rod]
frame = "A"
centre = "P"
mass = "m"
inertia = "J"
[letters]
'M' = "M"
'm' = "m"
'l' = "l"
'J' = "J"
'g' = "g"
'x' = "x"
'\alpha' = "a"
'\Omega' = "a'"
'H' = "angular_momentum(rod) . N.z"
'T' = "kinetic_energy"
"#;

fn formulas(found: &Finding) -> Vec<&str> {
    found.corrections.iter().map(|one| one.formula.as_str()).collect()
}

fn has_hypothesis(found: &Finding, wanted: &str) -> bool {
    found
        .corrections
        .iter()
        .flat_map(|one| &one.changes)
        .any(|change| change.kind == EditKind::Hypothesis && change.after.contains(wanted))
}

#[test]
fn edits_that_overlap_are_not_made_together() {
    let given = "given = ['\\alpha = \\pi', '\\dot{x} = 0']\nresting = ['\\alpha', '\\dot{x}']";
    let printed = r"\ddot{\alpha} \left( m^2 l^2 + J \right) - g l m (\alpha - \pi) = 0";
    let found = on(CART, "linearised equation", printed, given);
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
}

#[test]
fn a_region_of_stability_is_not_corrected_to_all_models() {
    let given = r"given = ['\alpha = 0', '\dot{x} = 0', 'J > 0', 'm > 0', 'M > 0', 'l > 0', 'g > 0']";
    let found = on(CART, "stability", "m > M", &format!("{given}\nresting = ['\\dot{{x}}', '\\alpha']"));
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
    assert!(!formulas(&found).contains(&"m > -M"), "{}", found.text());
}

#[test]
fn a_letter_for_a_rate_is_no_correction_of_its_definition() {
    let found = on(CART, "formula", r"\dot\alpha = 0", "");
    assert!(formulas(&found).iter().all(|one| !one.contains("Omega")), "{}", found.text());
}

#[test]
fn a_number_on_a_side_of_its_own_becomes_zero() {
    let printed = r"J\ddot\alpha + m l(\ddot{x}\cos\alpha + l\ddot\alpha + g\sin\alpha) = 1";
    let found = on(CART, "equation of motion", printed, "");
    assert_eq!(formulas(&found), [printed.replace("= 1", "= 0")], "{}", found.text());
}

#[test]
fn a_quantity_is_not_corrected_to_zero() {
    let system = CART.replace("kinetic_energy", "0*kinetic_energy");
    let found = on(&system, "formula", r"T = \frac{1}{2} J \dot\alpha^2", "");
    assert!(!formulas(&found).contains(&"T = 0"), "{}", found.text());
}

#[test]
fn no_parameter_of_a_linear_equation_is_zero_by_a_hypothesis() {
    let given = "given = ['\\alpha = 0', '\\dot{x} = 0']\nresting = ['\\alpha', '\\dot{x}']";
    let found = on(CART, "linearised equation", r"(J + m l^2 + m l)\ddot\alpha + 3 m g l\alpha + 2 m g = m", given);
    assert!(!has_hypothesis(&found, "= 0"), "{}", found.text());
}

#[test]
fn an_integral_is_no_ratio_that_only_parameters_make_up() {
    let found = on(CART, "integral of motion", r"H = \mathrm{const}", "");
    for quotient in [r"\frac{H}{\Omega}", r"\frac{H}{\dot{\alpha}}"] {
        assert!(formulas(&found).iter().all(|one| !one.starts_with(quotient)), "{}", found.text());
    }
}

#[test]
fn of_equal_equations_the_one_without_a_quotient_is_offered() {
    let found = on_pendulum("equation of motion", r"l \ddot\theta = -\sin\theta", "");
    assert_eq!(formulas(&found), [r"l \ddot\theta = -g \sin\theta"], "{}", found.text());
    let found = on_pendulum("formula", r"T = m l^2 \dot\theta^2", "");
    assert_eq!(formulas(&found), [r"T = \frac{m l^2 \dot\theta^2}{2}"], "{}", found.text());
}

#[test]
fn an_inequality_is_not_saved_by_a_vanishing_coordinate() {
    let system = PENDULUM.replace("'h' =", "'s' = \"l*theta\"\n'h' =");
    let found = on(&system, "inequality", r"s < l", "given = ['l > 0']");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
    assert!(!has_hypothesis(&found, "= 0"), "{}", found.text());
}

#[test]
fn a_lost_dot_of_an_acceleration_is_refuted_and_corrected() {
    let found = on_pendulum("equation of motion", r"\dot\theta = -\frac{g}{l} \sin\theta", "");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
    assert_eq!(formulas(&found), [r"\ddot{\theta} = -\frac{g}{l} \sin\theta"], "{}", found.text());
}

#[test]
fn a_lost_term_of_a_linear_equation_is_found() {
    let given = "given = ['\\alpha = 0', '\\dot{x} = 0']\nresting = ['\\alpha', '\\dot{x}']";
    for (printed, corrected) in [
        (r"m l \ddot{x} + (J + m l^2) \ddot\alpha = 0", r"m l \ddot{x} + (J + m l^2) \ddot\alpha + \alpha glm = 0"),
        (r"(J + m l^2) \ddot\alpha + m g l \alpha = 0", r"(J + m l^2) \ddot\alpha + m g l \alpha + lm\ddot{x} = 0"),
    ] {
        let found = on(CART, "linearised equation", printed, given);
        assert_eq!(formulas(&found), [corrected], "{}", found.text());
    }
}

#[test]
fn a_lost_term_of_an_integral_is_found_by_the_integrals_of_the_model() {
    let found = on_pendulum("integral of motion", r"\frac{1}{2} m l^2 \dot\theta^2 = \mathrm{const}", "");
    let [first, ..] = &found.corrections[..] else { panic!("{}", found.text()) };
    assert_eq!(first.changes[0].kind, EditKind::LostTerm, "{}", found.text());
    let found = on(CART, "integral of motion", r"M \dot{x} + m l \dot\alpha \cos\alpha = \mathrm{const}", "");
    assert_eq!(
        formulas(&found),
        [r"M \dot{x} + m l \dot\alpha \cos\alpha + m\dot{x} = \mathrm{const}"],
        "{}",
        found.text()
    );
}

#[test]
fn a_lost_term_below_a_bar_is_found() {
    let system = PENDULUM.replace("mass = \"m\"", "mass = \"m\"\nframe = \"A\"\ninertia = \"J\"");
    let system =
        system.replace("g = \"m/s^2\"", "g = \"m/s^2\"\nJ = \"kg m^2\"").replace("'T' =", "'J' = \"J\"\n'T' =");
    let found = on(&system, "formula", r"\ddot\theta = -\frac{m g l \sin\theta}{J}", "");
    assert_eq!(
        formulas(&found).first(),
        Some(&r"\ddot\theta = -\frac{m g l \sin\theta}{J + l^2m}"),
        "{}",
        found.text()
    );
}

#[test]
fn the_sign_of_a_lone_left_side_is_the_last_to_be_wrong() {
    let found = on_pendulum("equation of motion", r"\ddot\theta = \frac{g}{l} \sin\theta", "");
    assert_eq!(formulas(&found), [r"\ddot\theta = -\frac{g}{l} \sin\theta"], "{}", found.text());
}
