//! Stability with several degrees of freedom: minima of the energy, conserved momenta, gyroscopic terms, exact points of instability.

use crate::{on, verdict};
use dalembert_manuscript::Finding;

/// A plane system with given energies, and letters for parameters of every kind.
fn plane(kinetic: &str, potential: &str) -> String {
    format!(
        r#"
title = "Plane"
[parameters]
m = "kg"
k = "N/m"
q = "N/m"
c = "kg/s"
[coordinates]
x = "m"
y = "m"
[energies]
kinetic = "{kinetic}"
potential = "{potential}"
[letters]
'm' = "m"
'k' = "k"
'q' = "q"
'c' = "c"
'x' = "x"
'y' = "y"
"#
    )
}

const BOTH: &str = "m/2*(x'^2 + y'^2)";

fn claimed(system: &str, formula: &str, given: &str) -> Finding {
    let more = format!("resting = ['x', 'y']\ngiven = ['x = 0', 'y = 0', 'm > 0', {given}]");
    on(system, "stability", formula, &more)
}

#[test]
fn a_minimum_of_the_potential_energy_is_stable_and_a_negative_value_of_its_form_is_not() {
    for (potential, formula, given, expected) in [
        ("k/2*x^2 + q/2*y^2", "k > 0", "'q > 0'", "proved"),
        // a minimum is strict for equal frequencies too
        ("k/2*x^2 + k/2*y^2", "k > 0", "", "proved"),
        ("k/2*x^2 + q/2*y^2", "q > 0", "'k > 0', 'q = 4 k'", "proved"),
        ("k/2*x^2 + q/2*y^2", "q > 0", "'k > q'", "proved"),
        ("k/2*(x^2 + y^2) + q*x*y", "k^2 > q^2", "'k > 0'", "proved"),
        ("k/2*(x^2 + y^2) + q*x*y", "k > q", "'k > 0', 'q > 0'", "proved"),
        ("k/2*(x^2 + y^2) + q*x*y", "k > 2 q", "'k > 0', 'q > 0'", "refuted"),
        ("k/2*(x^2 + y^2) + q*x*y", "k^2 > q^2", "", "refuted"),
        ("k/2*x^2 + q/2*y^2", "q < 0", "'k > 0'", "refuted"),
    ] {
        let found = claimed(&plane(BOTH, potential), formula, given);
        assert_eq!(verdict(&found), expected, "{potential}: {}", found.text());
        let theorem = if expected == "proved" { "(Lagrange, Dirichlet)" } else { "exact point" };
        assert!(found.judged.evidence.contains(theorem), "{}", found.text());
    }
}

#[test]
fn the_edge_of_a_minimum_is_told_to_be_open() {
    let found = claimed(&plane(BOTH, "k/2*x^2 + q/2*y^2"), "k > 0", "'q > 0'");
    assert!(found.judged.evidence.contains("where they are equal nothing is decided"), "{}", found.text());
}

#[test]
fn an_inequality_that_the_hypotheses_exclude_claims_no_stable_motion() {
    let system = plane(BOTH, "k/2*x^2 + q/2*y^2");
    for (formula, given) in [("k > 0", "'k < 0'"), ("k > q", "'q > 0', 'k < 0'")] {
        let found = claimed(&system, formula, given);
        assert_eq!(verdict(&found), "undefined", "{}", found.text());
        assert!(found.judged.evidence.contains("no stable motion is claimed"), "{}", found.text());
    }
    let found = claimed(&system, "q > k", "'k < 0', 'q > 0'");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
}

#[test]
fn gyroscopic_stability_is_linear_alone_and_gyroscopic_instability_is_not() {
    let system = plane(&format!("{BOTH} + c/2*(x*y' - y*x')"), "-k/2*(x^2 + y^2)");
    for (formula, given, expected, told) in [
        ("c^2 > 4 m k", "'k > 0'", "proved", "in the first approximation alone"),
        (r"c > 2\sqrt{m k}", "'k > 0', 'c > 0'", "proved", "in the first approximation alone"),
        ("c^2 > 4 m k", "'k < 0'", "proved", "(Lagrange, Dirichlet)"),
        ("c^2 > 2 m k", "'k > 0'", "refuted", "a root has a positive real part"),
        ("c^2 > 8 m k", "'k > 0'", "refuted", "stable in the first approximation"),
    ] {
        let found = claimed(&system, formula, given);
        assert_eq!(verdict(&found), expected, "{}", found.text());
        assert!(found.judged.evidence.contains(told), "{}", found.text());
    }
}

#[test]
fn forces_that_are_no_energy_are_stable_in_the_first_approximation() {
    let system = r#"
title = "Springs as forces"
[parameters]
m = "kg"
k = "N/m"
q = "N/m"
[coordinates]
x = "m"
y = "m"
[bodies.bob]
centre = "O + x*N.x + y*N.y"
mass = "m"
[[force]]
on = "bob"
is = "-k*x*N.x - q*y*N.y"
[letters]
'm' = "m"
'k' = "k"
'q' = "q"
'x' = "x"
'y' = "y"
"#;
    let found = claimed(system, "k > 0", "'q > 0'");
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    assert!(!found.judged.evidence.contains("Dirichlet"), "{}", found.text());
    assert!(found.judged.evidence.contains("first approximation"), "{}", found.text());
}

#[test]
fn a_circular_orbit_is_stable_by_its_momentum() {
    // V = -k/r - q/r^3: the radius of the last stable orbit has k r^2 = 3 q
    let system = r#"
title = "Orbit"
[parameters]
m = "kg"
k = "N m^2"
q = "N m^4"
[coordinates]
r = "m"
phi = "rad"
[energies]
kinetic = "m/2*(r'^2 + r^2*phi'^2)"
potential = "-k/r - q/r^3"
[letters]
'm' = "m"
'k' = "k"
'q' = "q"
'r' = "r"
'\varphi' = "phi"
"#;
    let given = r"given = ['k = m r^3 \dot\varphi^2 - \frac{3 q}{r^2}', 'm > 0', 'r > 0', 'q > 0']";
    let more = format!("resting = ['r', '\\dot\\varphi']\n{given}");
    for (formula, expected) in [(r"k r^2 > 3 q", "proved"), (r"k r^2 > 2 q", "refuted"), (r"k r^2 > 4 q", "refuted")] {
        let found = on(system, "stability", formula, &more);
        assert_eq!(verdict(&found), expected, "{}", found.text());
        let is_told = found.judged.evidence.contains("Dirichlet");
        assert!(is_told || expected == "refuted", "{}", found.text());
    }
}

/// Three masses between springs; the stiffness of the first spring is the condition of the claim.
#[test]
fn three_degrees_of_freedom_are_decided_by_minors() {
    let system = r#"
title = "Chain"
[parameters]
m = "kg"
k = "N/m"
q = "N/m"
[coordinates]
x = "m"
y = "m"
z = "m"
[energies]
kinetic = "m/2*(x'^2 + y'^2 + z'^2)"
potential = "k/2*x^2 + q/2*(y - x)^2 + q/2*(z - y)^2"
[letters]
'm' = "m"
'k' = "k"
'q' = "q"
'x' = "x"
'y' = "y"
'z' = "z"
"#;
    let more = "resting = ['x', 'y', 'z']\ngiven = ['x = 0', 'y = 0', 'z = 0', 'm > 0', 'q > 0']";
    for (formula, expected) in [("k > 0", "proved"), ("k > q", "refuted"), ("k > -q", "refuted")] {
        let found = on(system, "stability", formula, more);
        assert_eq!(verdict(&found), expected, "{}", found.text());
    }
}

/// An inequality that no value satisfies is a condition of no stable motion.
#[test]
fn an_inequality_that_holds_nowhere_is_no_condition_of_stability() {
    let stiff = plane(BOTH, "k/2*x^2 + q/2*y^2");
    for (formula, given) in [
        ("c > 0", "'k > 0', 'q > 0', 'c = 0'"),
        ("k > k", "'q > 0'"),
        ("x > 0", "'q > 0'"),
        ("k > 3 q", "'q > 0', 'k = 0'"),
        ("c < 0", "'k < 0', 'q < 0', 'c = 0'"),
    ] {
        let found = claimed(&stiff, formula, given);
        assert_eq!(verdict(&found), "undefined", "{formula}: {}", found.text());
        assert!(found.text().contains("holds nowhere"), "{}", found.text());
    }
}

/// A pendulum below its pivot is stable only for a positive length; without mass it has no equation of motion.
#[test]
fn the_sign_of_a_length_is_a_missing_hypothesis() {
    let hanging = "resting = ['\\theta']\ngiven = ['\\theta = 0']";
    let found = on(crate::PENDULUM, "stability", r"g > 0", hanging);
    let offered: Vec<&str> = found.corrections.iter().map(|one| one.changes[0].after.as_str()).collect();
    assert_eq!((verdict(&found), &offered[..]), ("refuted", &["l > 0"][..]), "{}", found.text());
    let found = on(crate::PENDULUM, "stability", r"g > 0", &hanging.replace("0']", "0', 'l > 0']"));
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    assert!(found.judged.requires.iter().any(|(told, _)| told == "m != 0"), "{}", found.text());
}
