//! Functions of a coordinate that a paper declares, and their derivatives.

use crate::{PENDULUM, on, refused, verdict};

fn system() -> String {
    PENDULUM.replace("'h' =", "'\\Phi(\\theta)' = \"m*g*l*(1 - cos(theta))\"\n'h' =")
}

#[test]
fn a_function_has_its_value_and_its_derivatives() {
    for (kind, formula, expected) in [
        ("formula", r"\Phi(\theta) = V + m g l", "proved"),
        ("formula", r"\Phi^\prime(\theta) = m g l \sin\theta", "proved"),
        ("formula", r"\Phi^{\prime\prime} = m g l \cos\theta", "proved"),
        ("formula", r"\Phi^\prime(\theta)^2 + \Phi^{\prime\prime}(\theta)^2 = m^2 g^2 l^2", "proved"),
        ("formula", r"\dot{\Phi} = \Phi^\prime(\theta)\dot\theta", "proved"),
        ("equation of motion", r"m l^2 \ddot\theta = -\Phi^\prime(\theta)", "proved"),
        ("equation of motion", r"m l^2 \ddot\theta = \Phi^\prime(\theta)", "refuted"),
        ("integral of motion", r"T + \Phi(\theta) = \mathrm{const}", "proved"),
    ] {
        let found = on(&system(), kind, formula, "");
        assert_eq!(verdict(&found), expected, "{}", found.text());
    }
}

#[test]
fn another_argument_is_asked_for() {
    for formula in [r"\Phi(2\theta) = 0", r"\Phi^2(\theta) = 0", r"\Phi(l) = 0"] {
        let claim = format!("[[claim]]\nequation = \"1\"\nkind = \"formula\"\nformula = '{formula}'\n");
        let told = refused(&format!("{}\n{claim}", system()));
        assert!(told.contains("is declared as a function of") || told.contains("the function twice"), "{told}");
    }
}
