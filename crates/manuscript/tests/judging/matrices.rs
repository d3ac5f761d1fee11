//! Claims with matrices, and lost terms in their entries.

use crate::{on, verdict};

/// A cart with a pendulum; claims follow.
const CART: &str = r#"
title = "A cart with a pendulum"
gravity = "-g*N.y"
parameters = { M = "kg", m = "kg", l = "m", g = "m/s^2" }
coordinates = { x = "m", a = "rad", b = "rad" }
[frames]
A = "N turned a about z"
B = "A turned b about z"
[bodies]
cart = { centre = "O + x*N.x", mass = "M" }
bob = { centre = "O + x*N.x - l*A.y", mass = "m" }
tip = { centre = "O + x*N.x - l*A.y - l*B.y", mass = "m" }
[letters]
'M' = "M"
'm' = "m"
'l' = "l"
'g' = "g"
'x' = "x"
'\alpha' = "a"
'\beta' = "b"
'p' = "momentum(x)"
'V' = "potential_energy"
'T' = "kinetic_energy"
"#;

fn is_corrected(kind: &str, wrong: &str, right: &str) {
    let found = on(CART, kind, wrong, "");
    assert_eq!(verdict(&found), "refuted", "{}", found.judged.evidence);
    assert!(found.corrections.iter().any(|one| one.formula == right), "{}", found.text());
}

#[test]
fn a_term_is_lost_in_an_entry_of_a_matrix() {
    let row = |mass: &str| {
        format!(
            r"p = \begin{{pmatrix}} {mass} & 2 m l \cos\alpha + m l \cos(\alpha + \beta) & m l \cos(\alpha + \beta) \end{{pmatrix}} \begin{{pmatrix}} \dot{{x}} \\ \dot\alpha \\ \dot\beta \end{{pmatrix}}"
        )
    };
    is_corrected("formula", &row("2 m"), &row("2 m + M"));
}

#[test]
fn an_angle_is_lost_in_an_argument() {
    let potential = |angle: &str| format!(r"V = -2 m g l \cos\alpha - m g l \cos{angle}");
    is_corrected("formula", &potential(r"\beta"), &potential(r"(\beta + \alpha)"));
}

#[test]
fn a_term_is_lost_below_a_rate() {
    let rate = |swing: &str| {
        format!(
            r"\frac{{d}}{{dt}}\left(m l (\dot\alpha + \dot\beta) \cos(\alpha + \beta) + (M + 2 m) \dot{{x}}{swing}\right) = 0"
        )
    };
    let right = rate(r" + 2\dot{\alpha}\cos \alpha\,lm");
    is_corrected("equation of motion", &rate(""), &right);
}

#[test]
fn the_derivative_of_a_derivative_is_rendered_as_printed() {
    let printed = r"\frac{d}{dt}\frac{\partial T}{\partial \dot{x}} = 0";
    let found = on(CART, "equation of motion", printed, "");
    assert_eq!(verdict(&found), "proved", "{}", found.judged.evidence);
    assert!(
        found.judged.latex[0].starts_with(r"\frac{d}{dt}\left(\frac{\partial}{\partial \dot{x}}"),
        "{:?}",
        found.judged.latex
    );
}
