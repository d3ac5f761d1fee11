//! Signs over the real numbers: in one unknown, of roots, by hypotheses, on the domain of a formula.

use crate::{PENDULUM, on, on_pendulum, verdict};

/// The pendulum with two numbers, a stiffness and a damping.
fn system() -> String {
    let letters = "[letters]\n'a' = \"a\"\n'b' = \"b\"\n'k' = \"k\"\n'c' = \"c\"\n";
    PENDULUM
        .replace("[parameters]\n", "[parameters]\na = \"[1]\"\nb = \"[1]\"\nk = \"N/m\"\nc = \"N s/m\"\n")
        .replace("[letters]\n", letters)
}

fn all(kind: &str, claims: &[(&str, &str, &str)]) {
    let system = system();
    for (formula, given, expected) in claims {
        let found = on(&system, kind, formula, &format!("given = [{given}]"));
        assert_eq!(verdict(&found), *expected, "{}", found.text());
    }
}

#[test]
fn divisors_of_a_formula_do_not_vanish_where_it_has_a_value() {
    all(
        "inequality",
        &[
            (r"\frac{1}{b^2} > 0", "", "proved"),
            (r"\frac{a^2}{b^2} \geq 0", "", "proved"),
            (r"\frac{a^2}{b^2} > 0", "", "refuted"),
            (r"\frac{1}{\cos^2\theta} \geq 1", "", "proved"),
            (r"\frac{b^2 + 1}{\cos^2\theta} > 0", "", "proved"),
            (r"\frac{1}{\cos\theta} \geq 1", r"'\cos\theta > 0'", "proved"),
            (r"\frac{1}{\cos\theta} \geq 1", "", "refuted"),
        ],
    );
    let found = on(&system(), "inequality", r"\frac{1}{b^2} > 0", "");
    assert!(found.text().contains("b != 0"), "{}", found.text());
}

#[test]
fn an_expression_in_one_unknown_is_decided() {
    all(
        "inequality",
        &[
            (r"(b - 1)^4 > 0", r"'b \neq 1'", "proved"),
            (r"(b - 1)^4 > 0", "", "refuted"),
            (r"(b^2 - 2)^2 > 0", "", "refuted"),
            (r"(b^2 - 2)^2 > 0", "'b > 2'", "proved"),
            (r"b^3 - 3 b + 3 > 0", "'b > -2.1'", "proved"),
            (r"b^3 - 3 b + 3 > 0", "'b > -2.104'", "refuted"),
            (r"b^3 \geq b", r"'b \geq 1'", "proved"),
            (r"b^3 > b", r"'b \geq 1'", "refuted"),
            (r"(b - 1)(b - 2) \geq 0", r"'b \leq 1'", "proved"),
            (r"(b - 1)(b - 2) \geq 0", r"'b \geq 1'", "refuted"),
            (r"\cos\theta + \frac{\sin^2\theta}{2} < 1", r"'\sin\theta \neq 0'", "proved"),
            (r"\cos\theta + \frac{\sin^2\theta}{2} < 1", "", "refuted"),
            (r"1 + \cos\theta > 0", "", "refuted"),
        ],
    );
}

#[test]
fn what_is_given_is_used_as_a_factor() {
    all(
        "inequality",
        &[
            (r"\frac{k}{m} > \frac{c^2}{4 m^2}", "'c^2 < 4 k m', 'm > 0'", "proved"),
            (r"\frac{k}{m} > \frac{c^2}{4 m^2}", "'c^2 < 4 k m'", "proved"),
            (r"\frac{k}{m} \geq \frac{c^2}{4 m^2}", r"'c^2 \leq 4 k m', 'm > 0'", "proved"),
            (r"\frac{k}{m} > \frac{c^2}{4 m^2}", r"'c^2 \leq 4 k m', 'm > 0'", "refuted"),
            (r"a^3 b^3 > 0", "'a b > 0'", "proved"),
            (r"(a - b)^4 > 0", r"'a \neq b'", "proved"),
            (r"a^2 + b^2 \geq 2 a b", "", "proved"),
            (r"a^2 + b^2 > 2 a b", r"'a \neq b'", "proved"),
            (r"a b \geq 0", r"'a \geq 0', 'b \geq 0'", "proved"),
            (r"a b > 0", r"'a \geq 0', 'b > 0'", "refuted"),
            (r"a + b > 0", r"'a \geq 0', 'b > 0'", "proved"),
            (r"a^3 - 3 a b^2 + 2 b^3 \geq 0", r"'a \geq 0', 'b \geq 0'", "proved"),
        ],
    );
}

#[test]
fn roots_are_squared_where_both_sides_have_one_sign() {
    all(
        "inequality",
        &[
            (r"\sqrt{b} < b", "'b > 1'", "proved"),
            (r"\sqrt{b} < b", "'b > 0.5'", "refuted"),
            (r"\sqrt{1 - b^2} \leq 1", "", "proved"),
            (r"\sqrt{b^2 + 1} > b", "", "proved"),
            (r"a \sqrt{b} > 0", "'a > 0'", "refuted"),
            (r"c < 2\sqrt{k m}", "'c^2 < 4 k m', 'k > 0', 'm > 0'", "proved"),
            (r"2\sqrt{k m} > c", "'c^2 < 4 k m'", "proved"),
            (r"2\sqrt{k m} > c", "'c^2 > 4 k m', 'k > 0', 'm > 0'", "refuted"),
        ],
    );
    all(
        "identity",
        &[
            (r"\sqrt{b^2} = b", "'b > 0'", "proved"),
            (r"\sqrt{b^2} = b", r"'b \geq 0'", "proved"),
            (r"\sqrt{b^2} = -b", "'b < 0'", "proved"),
            (r"\sqrt{b^2} = b", "", "refuted"),
            (r"\sqrt{b^4} = b^2", "", "proved"),
            (r"\sqrt{(a - b)^2} = b - a", "'b > a'", "proved"),
            (r"\sqrt{k m}\sqrt{\frac{k}{m}} = k", "'m > 0', 'k > 0'", "proved"),
            (r"\sqrt{k m}\sqrt{\frac{k}{m}} = k", "'m < 0'", "refuted"),
        ],
    );
}

/// A rod pendulum in Cartesian coordinates.
const ROD: &str = r#"
title = "Rod"
[parameters]
m = "kg"
l = "m"
[coordinates]
x = "m"
y = "m"
[bodies.bob]
centre = "O + x*N.x + y*N.y"
mass = "m"
[[constraint]]
name = "rod"
zero = "x^2 + y^2 - l^2"
[letters]
'l' = "l"
'x' = "x"
'y' = "y"
"#;

#[test]
fn constraints_of_positions_give_squares() {
    let found = on(ROD, "inequality", r"x^2 \leq l^2", "");
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    // the hypothesis of a zero speed would leave the bob on one axis, where the claim is trivial
    let found = on(ROD, "identity", r"y = -\sqrt{l^2 - x^2}", "");
    let offered: Vec<&str> = found.corrections.iter().map(|one| one.changes[0].after.as_str()).collect();
    assert_eq!(offered, [r"y \leq 0"], "{}", found.text());
}

#[test]
fn a_correction_is_no_longer_than_the_print() {
    let found = on_pendulum("equation of motion", r"m \ddot\theta (\ddot\theta + g) = 0", "");
    assert!(found.corrections.iter().all(|one| one.formula.len() < 100), "{}", found.text());
}

#[test]
fn hypotheses_with_roots_leave_points() {
    let system = crate::cases::BLOCK.replace("[letters]\n", "[letters]\n'\\zeta' = \"c/(2*sqrt(k*m))\"\n");
    let given = |more: &str| format!("given = ['m > 0', 'k > 0', {more}]");
    let found = on(&system, "inequality", r"\zeta < 1", &given("'c^2 < 4 k m'"));
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    // with a negative damping the ratio is negative, and the claim may fail
    let found = on(&system, "inequality", "c^2 < 4 k m", &given(r"'\zeta < 1'"));
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
}

#[test]
fn a_power_vanishes_where_its_base_does() {
    let given = "given = ['u = 0', 'c > 0']";
    let found = on(crate::cases::BLOCK, "equivalence", r"v = 0 \iff \dot{E} = 0", given);
    assert_eq!(verdict(&found), "proved", "{}", found.text());
}
