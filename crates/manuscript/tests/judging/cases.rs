//! Hypotheses that set a product to zero: a claim is judged in each case, one for each factor.

use crate::{on, verdict};

/// A block on a spring with a damper and a force as input.
pub const BLOCK: &str = r#"
title = "A block"
[parameters]
m = "kg"
k = "N/m"
c = "N s/m"
F0 = "N"
[coordinates]
x = "m"
[inputs]
u = "N"
[bodies.block]
centre = "O + x*N.x"
mass = "m"
[[force]]
on = "block"
is = "(u - k*x - c*x')*N.x"
[letters]
'm' = "m"
'k' = "k"
'c' = "c"
'F_0' = "F0"
'x' = "x"
'v' = "x'"
'u' = "u"
'T' = "kinetic_energy"
'E' = "kinetic_energy + k*x^2/2"
'p' = "m*x'"
"#;

#[test]
fn a_claim_under_a_product_holds_in_every_case_of_it() {
    for (kind, formula, given, expected) in [
        ("identity", "x = 0", "'x v = 0'", "refuted"),
        ("identity", "v = 0", "'x v = 0'", "refuted"),
        ("identity", "x^2 v = 0", "'x v = 0'", "proved"),
        ("identity", "v = 0", r"'x v = 0', 'x \neq 0'", "proved"),
        ("identity", "v = 0", r"'x v = 0', 'x > 0'", "proved"),
        ("identity", "x = 0", r"'v x = 0', 'v \neq 0'", "proved"),
        ("inequality", r"x \leq 0", "'x v = 0'", "refuted"),
        ("identity", "k = 1", "'k c = c'", "refuted"),
        ("identity", "k = 1", r"'k c = c', 'c \neq 0'", "proved"),
        ("identity", "x = 0", "'x^2 = 0'", "proved"),
        ("identity", "x = 0", r"'x^2 v = 0', 'v \neq 0'", "proved"),
        // the second hypothesis becomes a product in one case of the first
        ("identity", "c v = 0", "'x v = 0', 'k x = 3 c v'", "proved"),
        ("equation of motion", r"m \ddot{x} + k x = u", "'c v = 0'", "proved"),
        ("identity", "v = 0", "'m v = 0'", "proved"),
    ] {
        let found = on(BLOCK, kind, formula, &format!("given = [{given}]"));
        assert_eq!(verdict(&found), expected, "{formula} where {given}: {}", found.text());
    }
}

#[test]
fn each_case_is_told() {
    let found = on(BLOCK, "identity", "x^2 v = 0", "given = ['x v = 0']");
    for case in ["where x = 0:", "where v = 0:"] {
        assert!(found.judged.evidence.contains(case), "{}", found.text());
    }
    let requires: Vec<&str> = found.judged.requires.iter().map(|(text, _)| text.as_str()).collect();
    assert_eq!(requires, ["x*v = 0"], "{}", found.text());
}

#[test]
fn a_case_that_the_other_hypotheses_exclude_is_none() {
    let told = crate::refused(&format!(
        "{BLOCK}\n[[claim]]\nequation = \"1\"\nkind = \"identity\"\nformula = 'x = 0'\ngiven = ['x v = 0', 'x > 0', 'v < 0']\n"
    ));
    assert!(told.contains("contradict each other") && told.contains("`x*v = 0`"), "{told}");
}

#[test]
fn a_case_that_cannot_be_solved_asks_for_the_factor() {
    let told = crate::refused(&format!(
        "{BLOCK}\n[[claim]]\nequation = \"1\"\nkind = \"identity\"\nformula = 'v = 0'\ngiven = ['v \\sin\\frac{{k x}}{{F_0}} = 0']\n"
    ));
    assert!(told.contains("which factor vanishes?"), "{told}");
}
