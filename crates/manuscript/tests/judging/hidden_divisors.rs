//! Hypotheses under which solving the constraints or the equations of motion for a rate divides by zero.

use crate::{on, verdict};

const WIRE: &str = r#"
title = "A bead on a circle"
[parameters]
m = "kg"
R = "m"
[coordinates]
x = "m"
y = "m"
[bodies.b]
centre = "O + x*N.x + y*N.y"
mass = "m"
[[constraint]]
name = "wire"
zero = "x^2 + y^2 - R^2"
[letters]
'x' = "x"
'y' = "y"
"#;

const SLEIGH: &str = r#"
title = "A sleigh: its edge does not slip sideways"
[parameters]
m = "kg"
J = "kg m^2"
[coordinates]
x = "m"
y = "m"
h = "rad"
[frames]
A = "N turned h about z"
[points]
K = "O + x*N.x + y*N.y"
[bodies.sled]
frame = "A"
centre = "K"
mass = "m"
inertia = "J"
[[constraint]]
zero = "velocity(K) . A.y"
[letters]
'x' = "x"
'\theta' = "h"
'u' = "velocity(K) . A.x"
"#;

const BLOCK: &str = r#"
title = "A block"
[parameters]
m = "kg"
M = "kg"
[coordinates]
x = "m"
[bodies.b]
centre = "O + x*N.x"
mass = "m + M"
[letters]
'm' = "m"
'M' = "M"
'x' = "x"
"#;

/// At the top and the bottom of the circle a bead moves with y' = 0.
#[test]
fn a_divisor_that_a_hypothesis_hides_is_listed() {
    let found = on(WIRE, "formula", r"\dot{x} = 0", r"given = ['\dot{y} = 0']");
    assert!(found.text().contains("x != 0"), "{}", found.text());
    let found = on(WIRE, "formula", r"\dot{x} = 0", r"given = ['\dot{y} = 0', 'x = 0']");
    assert_ne!(verdict(&found), "proved", "{}", found.text());
}

/// x' = u cos(theta) vanishes at theta = pi/2 for every u.
#[test]
fn a_divisor_that_hypotheses_make_zero_proves_nothing() {
    let given = r"given = ['\dot{x} = 0', '\theta = \frac{\pi}{2}']";
    for (kind, formula) in [("formula", "u = 0"), ("identity", "u = 0"), ("inequality", r"u \leq 0")] {
        let found = on(SLEIGH, kind, formula, given);
        assert_ne!(verdict(&found), "proved", "{}", found.text());
    }
    let found = on(SLEIGH, "equivalence", r"u = 0 \iff \dot{x} = 0", "");
    assert!(found.text().contains("cos(theta) != 0"), "{}", found.text());
}

#[test]
fn hypotheses_that_leave_no_inertia_determine_no_acceleration() {
    for given in ["given = ['m = 0', 'M = 0']", "given = ['M = -m']"] {
        let found = on(BLOCK, "formula", r"\ddot{x} = 0", given);
        assert_eq!(verdict(&found), "undecided", "{}", found.text());
    }
    assert_eq!(verdict(&on(BLOCK, "formula", r"\ddot{x} = 0", "given = ['m = 0']")), "proved");
}
