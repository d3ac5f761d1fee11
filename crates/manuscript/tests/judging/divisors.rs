//! Steady motions and equivalences: divisors, and the motions at which a divisor vanishes.

use crate::{on, on_pendulum, verdict};

const CARTESIAN: &str = r#"
title = "A pendulum by two lengths"
gravity = "-g*N.y"
[parameters]
m = "kg"
l = "m"
g = "m/s^2"
[coordinates]
x = "m"
y = "m"
[points]
P = "O + x*N.x + y*N.y"
[bodies]
bob = { centre = "P", mass = "m" }
[[constraint]]
name = "rod"
zero = "x^2 + y^2 - l^2"
[letters]
'm' = "m"
'l' = "l"
'g' = "g"
'x' = "x"
'y' = "y"
'\rho' = "sqrt(x^2 + y^2)"
'\lambda' = "reaction(rod)"
"#;

const SPRING: &str = r#"
title = "A bead on a turning rod"
[parameters]
m = "kg"
k = "N/m"
l = "m"
J = "kg m^2"
[coordinates]
r = "m"
phi = "rad"
[frames]
A = "N turned phi about z"
[points]
P = "O + r*A.x"
[bodies]
bead = { centre = "P", mass = "m" }
rod = { frame = "A", centre = "O", mass = "m", inertia = "J" }
[energies]
potential = "k/2*(r-l)^2"
[letters]
'm' = "m"
'k' = "k"
'l' = "l"
'r' = "r"
'\omega' = "phi'"
"#;

#[test]
fn a_pendulum_by_two_lengths_rests_below_and_above() {
    let resting = "resting = ['x', 'y']\ngiven = ['g > 0', 'm > 0', 'l > 0']";
    for formula in ["x = 0", "g x = 0"] {
        let found = on(CARTESIAN, "steady motion", formula, resting);
        assert_eq!(verdict(&found), "proved", "{}", found.text());
    }
    let found = on(CARTESIAN, "steady motion", "y = 0", resting);
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
}

#[test]
fn other_coordinates_move_as_their_equations_say() {
    let found = on(SPRING, "steady motion", r"m r\omega^2 = k(r-l)", "resting = ['r']");
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    let found = on(SPRING, "steady motion", "r = l", "resting = ['r']");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
}

#[test]
fn a_rest_that_a_divisor_leaves_out_refutes_the_condition() {
    let found = on_pendulum("steady motion", "g = 0", r"resting = ['\theta']");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
    assert!(found.text().contains("theta = 0"), "{}", found.text());
    let found = on_pendulum("steady motion", "g = 0", "resting = ['\\theta']\ngiven = ['\\sin\\theta \\neq 0']");
    assert_eq!(verdict(&found), "proved", "{}", found.text());
}

#[test]
fn a_counterexample_lies_on_every_constraint() {
    // the length is a positive root, which a normal form does not represent
    for kind in ["identity", "formula"] {
        let found = on(CARTESIAN, kind, r"\rho = l", "given = ['l > 0']");
        assert_ne!(verdict(&found), "refuted", "{}", found.text());
    }
    let found = on(CARTESIAN, "equivalence", r"x = 0 \iff y = l", "");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
}

#[test]
fn equivalent_conditions_divide_by_what_the_hypotheses_exclude() {
    for formula in [r"g\sin\theta = 0 \iff \sin\theta = 0", r"g\dot\theta = 0 \iff \dot\theta = 0"] {
        let found = on_pendulum("equivalence", formula, "");
        assert_eq!(verdict(&found), "refuted", "{}", found.text());
        let found = on_pendulum("equivalence", formula, "given = ['g > 0']");
        assert_eq!(verdict(&found), "proved", "{}", found.text());
    }
    let found = on(CARTESIAN, "equivalence", r"\frac{x^2}{x} = 0 \iff x = 0", "");
    assert_eq!(verdict(&found), "undefined", "{}", found.text());
    let found = on(CARTESIAN, "equivalence", r"\dot x = 0 \iff y = 0", "");
    assert_ne!(verdict(&found), "proved", "{}", found.text());
}
