//! Conditions of steady motions of constrained systems: a cart on a spring with a pendulum in Cartesian coordinates.

use crate::{judged, verdict};
use dalembert_manuscript::Finding;

const CART: &str = r#"
title = "A cart with a pendulum by its length"
gravity = "g*N.y"
parameters = { M = "kg", m = "kg", l = "m", g = "m/s^2", k = "N/m" }
coordinates = { X = "m", x = "m", y = "m" }
inputs = { F = "N" }
energies = { potential = "k*X^2/2" }
[points]
C = "O + X*N.x"
P = "C + x*N.x + y*N.y"
[bodies]
cart = { centre = "C", mass = "M" }
bob = { centre = "P", mass = "m" }
[[constraint]]
name = "rod"
zero = "x^2 + y^2 - l^2"
[[force]]
on = "bob"
is = "F*N.x"
[letters]
'm' = "m"
'g' = "g"
'k' = "k"
'X' = "X"
'x' = "x"
'y' = "y"
'F' = "F"
"#;

fn claims(formulas: [&str; 2]) -> Vec<Finding> {
    let claim = |(place, formula): (usize, &&str)| {
        let table = format!("equation = \"{}\"\nkind = \"steady motion\"\nformula = '{formula}'", place + 1);
        format!("[[claim]]\n{table}\nresting = ['X', 'x', 'y']\n")
    };
    let text = format!("{CART}\n{}", formulas.iter().enumerate().map(claim).collect::<String>());
    judged(&text).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_cart_and_the_rod_have_a_condition_each() {
    for found in claims(["F y = m g x", "k X = F"]) {
        assert_eq!(verdict(&found), "proved", "{}", found.text());
    }
}

#[test]
fn a_wrong_condition_beside_a_true_one_is_refuted_by_bodies_that_exist() {
    for (formulas, wrong, right) in
        [(["F y = m g x", "k X = 2 F"], 1, "k X = F"), (["F y = 2 m g x", "k X = F"], 0, "F y = m g x")]
    {
        let found = claims(formulas);
        assert_eq!(verdict(&found[wrong]), "refuted", "{}", found[wrong].text());
        assert_eq!(verdict(&found[1 - wrong]), "undecided", "{}", found[1 - wrong].text());
        assert!(!found[wrong].judged.evidence.contains("no point was found"), "{}", found[wrong].text());
        assert_eq!(found[wrong].corrections[0].formula, right, "{}", found[wrong].text());
    }
}
