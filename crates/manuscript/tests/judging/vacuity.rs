//! Vacuous claims: no point satisfies the hypotheses within the domain of the formula.

use crate::{PENDULUM, on, refused, verdict};

/// The pendulum with three numbers as further parameters.
fn system() -> String {
    let letters = "[letters]\n'a' = \"a\"\n'b' = \"b\"\n'c' = \"c\"\n";
    PENDULUM
        .replace("[parameters]\n", "[parameters]\na = \"[1]\"\nb = \"[1]\"\nc = \"[1]\"\n")
        .replace("[letters]\n", letters)
}

fn claim(kind: &str, formula: &str, given: &str) -> String {
    let system = system();
    format!("{system}\n[[claim]]\nequation = \"1\"\nkind = \"{kind}\"\nformula = '{formula}'\ngiven = [{given}]\n")
}

#[test]
fn contradicting_hypotheses_are_named_with_their_lines() {
    for (given, named) in [
        ("'a > 0', 'c > 0', 'a < 0'", "`a > 0` (line 37), `a < 0` (line 37)"),
        ("'a > b', 'b > c', 'c > a'", "`a > b` (line 37), `b > c` (line 37), `c > a` (line 37)"),
        ("'a = b + 1', 'a < b'", "`a = b + 1` (line 37), `a < b` (line 37)"),
        ("'a^2 + b^2 < 2 a b'", "`a^2 + b^2 < 2*a*b` (line 37)"),
        ("'a b > 1', 'a > 0', 'b < 0'", "`a*b > 1` (line 37), `a > 0` (line 37), `b < 0` (line 37)"),
        (r"'\cos\theta > 0.9', '\sin\theta > 0.9'", "`cos(theta) > 9/10` (line 37), `sin(theta) > 9/10` (line 37)"),
        (r"'a \geq b', 'a \leq b', 'a \neq b'", "`a >= b` (line 37), `a <= b` (line 37), `a != b` (line 37)"),
        (r"'\sqrt{a} > 2', 'a < 4'", "`sqrt(a) > 2` (line 37), `a < 4` (line 37)"),
        (
            "'a^3 - 3 a + 1 > 0', 'a^2 < 1', 'a > 0.5'",
            "`a^3 - 3*a + 1 > 0` (line 37), `a^2 < 1` (line 37), `a > 1/2` (line 37)",
        ),
    ] {
        let told = refused(&claim("formula", "V = V", given));
        assert!(told.contains("contradict each other"), "{given}: {told}");
        assert!(told.contains(named), "{given}: {told}");
    }
}

#[test]
fn each_hypothesis_has_its_own_line() {
    let told = refused(&claim("formula", "V = V", "\n'a > 1',\n'c > 0',\n'a < 1'"));
    assert!(told.contains("`a > 1` (line 38), `a < 1` (line 40)"), "{told}");
}

#[test]
fn a_formula_that_has_a_value_nowhere_is_undefined() {
    for (kind, formula, given) in [
        ("identity", r"\sqrt{a b} = \sqrt{a}\sqrt{b}", "'a < 0', 'b < 0'"),
        ("inequality", r"\sqrt{a} > 0", "'a = -b', 'b > 0'"),
        ("inequality", r"\sqrt{a} + \sqrt{-a - 1} \geq 0", ""),
        ("identity", r"\sqrt{a}\sqrt{a} + \sqrt{-a - 1} - \sqrt{-a - 1} = a", ""),
        ("identity", r"\sqrt{1 - a^2}\sqrt{1 - a^2} = 1 - a^2", "'a > 1'"),
        ("identity", r"\sqrt{\cos\theta - 1}\sqrt{\cos\theta - 1} = \cos\theta - 1", r"'\sin\theta \neq 0'"),
    ] {
        let found = on(&system(), kind, formula, &format!("given = [{given}]"));
        assert_eq!(verdict(&found), "undefined", "{}", found.text());
        assert!(found.judged.evidence.contains("has a value nowhere"), "{}", found.text());
        assert_eq!(found.judged.evidence.contains("(line "), !given.is_empty(), "{}", found.text());
    }
}

#[test]
fn what_holds_somewhere_is_proved() {
    for (formula, given) in [
        (r"\sqrt{a b} = \sqrt{a}\sqrt{b}", r"'a \geq 0', 'b \geq 0'"),
        (r"\sqrt{1 - a^2}\sqrt{1 - a^2} = 1 - a^2", "'a > 0.5'"),
        // the domain is the point a = 0, which suffices
        (r"\sqrt{a}\sqrt{a} + \sqrt{-a} - \sqrt{-a} = a", ""),
        ("a b = b a", r"'a \geq b', 'a \leq b'"),
    ] {
        let found = on(&system(), "identity", formula, &format!("given = [{given}]"));
        assert_eq!(verdict(&found), "proved", "{}", found.text());
    }
}

#[test]
fn no_correction_holds_at_the_edges_of_its_formula_alone() {
    for (kind, formula) in [("inequality", r"\sqrt{a^2 - b^2} \leq a"), ("inequality", r"\sqrt{a^2 + b^2} < a")] {
        let found = on(&system(), kind, formula, "");
        assert_eq!(verdict(&found), "refuted", "{}", found.text());
        let listed = found.corrections.iter().flat_map(|one| &one.judged.requires);
        let is_thin = |told: &str| told == "-a^2 - b^2 >= 0" || told == "a < 0";
        assert!(!listed.into_iter().any(|(told, _)| is_thin(told)), "{}", found.text());
    }
}

#[test]
fn a_model_without_inertia_corrects_nothing() {
    let found = on(&system(), "formula", "V = -m g l", "");
    assert!(found.corrections.iter().all(|one| one.changes[0].after != "m = 0"), "{}", found.text());
}

/// A body under a central force: its angular momentum p is an integral.
const CENTRAL: &str = r#"
title = "Central force"
parameters = { M = "kg", mu = "m^3/s^2" }
coordinates = { R = "m", nu = "rad" }
frames = { K = "N turned nu about z" }
bodies = { s = { centre = "O + R*K.x", mass = "M" } }
energies = { potential = "-mu*M/R" }
[letters]
'M' = "M"
'R' = "R"
'\nu' = "nu"
'p' = "momentum(nu)"
'\mu' = "mu"
"#;

#[test]
fn what_is_divided_by_the_rate_of_an_integral_claims_nothing() {
    for formula in [r"\frac{M}{\dot p} > 0", r"\frac{M}{\dot p} < 0"] {
        assert_eq!(verdict(&on(CENTRAL, "inequality", formula, "")), "undefined", "{formula}");
    }
    // a rate that is zero is no factor of a correction either
    let found = on(CENTRAL, "formula", r"\ddot\nu = 0", "");
    assert!(!found.corrections.is_empty(), "{}", found.text());
    assert!(found.corrections.iter().all(|one| !one.formula.contains(r"\dot{p}")), "{}", found.text());
}
