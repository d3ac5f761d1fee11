//! Claims on closed chains, whose accelerations and reactions are long expressions.

use crate::{on, verdict};
use dalembert_manuscript::PaperText;
use std::path::Path;

/// A four-bar linkage; claims follow.
const FOUR_BARS: &str = r#"
title = "A four-bar linkage"
parameters = { a = "m", b = "m", c = "m", d = "m", J1 = "kg m^2", J3 = "kg m^2", m = "kg" }
coordinates = { q1 = "rad", q2 = "rad", q3 = "rad" }
inputs = { T = "N m" }
points = { P = "O + a*A.x", D = "O + d*N.x" }
[frames]
A = "N turned q1 about z"
B = "N turned q2 about z"
C = "N turned q3 about z"
[bodies]
crank = { frame = "A", centre = "O", mass = "(1 kg)", inertia = "J1" }
rocker = { frame = "C", centre = "D", mass = "(1 kg)", inertia = "J3" }
coupler = { centre = "P + b/2*B.x", mass = "m" }
[[force]]
along = "q1"
is = "T"
[[constraint]]
name = "across"
zero = "a*cos(q1) + b*cos(q2) - c*cos(q3) - d"
[[constraint]]
name = "along"
zero = "a*sin(q1) + b*sin(q2) - c*sin(q3)"
[letters]
'a' = "a"
'b' = "b"
'c' = "c"
'd' = "d"
'J_1' = "J1"
'J_3' = "J3"
'm' = "m"
'\theta_1' = "q1"
'\theta_2' = "q2"
'\theta_3' = "q3"
'\tau' = "T"
'\lambda_1' = "reaction(across)"
'\lambda_2' = "reaction(along)"
"#;

const CRANK: &str = r"\frac{d}{dt}\left(a^2 m \dot\theta_1 + J_1 \dot\theta_1 + \frac{a b m \dot\theta_2 \cos(\theta_1 - \theta_2)}{2}\right) + \frac{a b m \dot\theta_2 \dot\theta_1 \sin(\theta_1 - \theta_2)}{2} = a \lambda_2 \cos\theta_1 - a \lambda_1 \sin\theta_1 + \tau";
const ROCKER: &str = r"\frac{d}{dt}(J_3 \dot\theta_3) = c \lambda_1 \sin\theta_3 - c \lambda_2 \cos\theta_3";

#[test]
fn an_equation_with_reactions_is_a_combination_of_those_of_the_model() {
    let found = on(FOUR_BARS, "equation of motion", ROCKER, "");
    assert_eq!(verdict(&found), "proved", "{}", found.judged.evidence);
    assert!(found.judged.requires.is_empty(), "{:?}", found.judged.requires);
    assert!(found.allowed.ends_with("here the equation of q3"), "{}", found.allowed);
}

#[test]
fn a_wrong_equation_of_a_linkage_is_refuted_at_a_point() {
    assert_eq!(verdict(&on(FOUR_BARS, "equation of motion", CRANK, "")), "proved");
    let wrong = CRANK.replace("a^2 m", "a^2");
    let claim = format!("[[claim]]\nequation = \"1\"\nkind = \"equation of motion\"\nformula = '{wrong}'\n");
    let paper = PaperText::parse(Path::new("paper.toml"), format!("{FOUR_BARS}\n{claim}")).expect("it is a paper");
    // without the search for corrections
    let found = paper.judge_each(|_| (), || false).expect("its formula is read");
    assert_eq!(verdict(&found[0]), "refuted", "{}", found[0].judged.evidence);
    assert!(!found[0].judged.counterexample.is_empty());
}
