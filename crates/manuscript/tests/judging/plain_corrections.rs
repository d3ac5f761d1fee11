//! Corrections as a reader would write them: nothing cancels, no term is repeated, and the model keeps its inertia.

use crate::{on, on_pendulum};
use dalembert_manuscript::Finding;

/// A heavy symmetric top with Euler's angles.
const TOP: &str = r#"
title = "A heavy top"
[parameters]
m = "kg"
l = "m"
A = "kg m^2"
C = "kg m^2"
g = "m/s^2"
[coordinates]
phi = "rad"
theta = "rad"
psi = "rad"
[frames]
E = "N turned phi about z"
F = "E turned theta about x"
B = "F turned psi about z"
[bodies.top]
frame = "B"
inertia = { principal = ["A", "A", "C"] }
[energies]
potential = "m*g*l*cos(theta)"
[letters]
'A' = "A"
'C' = "C"
'\varphi' = "phi"
'\theta' = "theta"
'\psi' = "psi"
'n' = "psi' + phi'*cos(theta)"
'p_\psi' = "momentum(psi)"
'E' = "kinetic_energy + potential_energy"
"#;

fn formulas(found: &Finding) -> Vec<&str> {
    found.corrections.iter().map(|one| one.formula.as_str()).collect()
}

#[test]
fn a_fraction_of_numbers_is_one_number() {
    let found = on_pendulum("formula", r"T = \frac{2}{3} m l^2 \dot\theta^2", "");
    assert_eq!(formulas(&found), [r"T = \frac{1}{2} m l^2 \dot\theta^2"], "{}", found.text());
    let found = on_pendulum("formula", r"2 T = \frac12 m l^2 \dot\theta^2", "");
    assert!(formulas(&found).iter().all(|one| !one.contains(r"\frac22")), "{}", found.text());
}

#[test]
fn a_divisor_stands_below_its_term() {
    let found = on(TOP, "formula", r"n = C p_\psi", "");
    assert_eq!(formulas(&found), [r"n = \frac{p_\psi}{C}"], "{}", found.text());
    let found = on(TOP, "formula", r"n = p_\psi", "");
    assert!(formulas(&found).contains(&r"n = \frac{p_\psi}{C}"), "{}", found.text());
}

#[test]
fn no_term_stands_beside_its_multiple() {
    let found = on_pendulum("formula", r"V = \frac12 m g l^2 \cos\theta", "");
    for formula in formulas(&found) {
        assert_eq!(formula.matches(r"\cos").count(), 1, "{}", found.text());
    }
    // a rate that is zero on every motion corrects no integral
    let found = on(TOP, "integral of motion", r"\dot\psi + \dot\varphi = \mathrm{const}", "");
    assert!(formulas(&found).iter().all(|one| !one.contains('E')), "{}", found.text());
}

#[test]
fn no_correction_tells_a_hypothesis_or_the_letter_by_itself() {
    let found = on_pendulum("identity", r"l = 2 m", r"given = ['l = \pi m']");
    assert!(formulas(&found).is_empty(), "{}", found.text());
    let found = on_pendulum("formula", r"h = m l", "");
    assert!(formulas(&found).iter().all(|one| one.matches('h').count() == 1), "{}", found.text());
}

#[test]
fn an_integral_and_its_opposite_are_one() {
    let found = on_pendulum("integral of motion", r"T - V = \mathrm{const}", "");
    assert_eq!(formulas(&found), [r"T + V = \mathrm{const}"], "{}", found.text());
}

#[test]
fn no_square_of_small_quantities_corrects_a_linear_equation() {
    let more = "resting = ['\\theta']\ngiven = ['\\theta = \\pi']";
    let found = on_pendulum("linearised equation", r"l \ddot\theta + g \theta = 0", more);
    assert!(formulas(&found).is_empty(), "{}", found.text());
}

#[test]
fn no_hypothesis_contradicts_the_given_ones_or_takes_the_inertia() {
    for (formula, given) in [
        (r"A \dot\varphi \sin^2\theta + p_\psi \cos\theta = \mathrm{const}", ""),
        (r"\dot\psi + \dot\varphi = \mathrm{const}", ""),
        (r"A \dot\theta = \mathrm{const}", r"given = ['C = A']"),
    ] {
        let found = on(TOP, "integral of motion", formula, given);
        let offered: Vec<&str> = found.corrections.iter().map(|one| one.changes[0].after.as_str()).collect();
        assert!(!offered.contains(&r"\theta = 0") && !offered.contains(&"A = 0"), "{}", found.text());
    }
    let more = r"given = ['\theta = \pi']";
    let found = on_pendulum("equation of motion", r"l \ddot\theta + g \cos\theta = 0", more);
    let offered: Vec<&str> = found.corrections.iter().map(|one| one.changes[0].after.as_str()).collect();
    assert!(!offered.contains(&r"\theta = 0"), "{}", found.text());
}
