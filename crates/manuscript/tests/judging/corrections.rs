//! The smallest edit that makes a refuted claim true.

use crate::{on, on_pendulum, verdict};
use dalembert_manuscript::{EditKind, Finding};

const CART: &str = r#"
title = "A cart on a spring"
[parameters]
m = "kg"
k = "N/m"
c = "N s/m"
g = "m/s^2"
[coordinates]
x = "m"
y = "m"
[inputs]
F = "N"
[points]
P = "O + x*N.x + y*N.y"
[bodies.cart]
centre = "P"
mass = "m"
[[force]]
along = "x"
is = "F - k*x - c*x'"
[[force]]
along = "y"
is = "-m*g"
[letters]
'm' = "m"
'k' = "k"
'c' = "c"
'g' = "g"
'x' = "x"
'y' = "y"
'F' = "F"
'T' = "kinetic_energy"
'V' = "m*g*y"
"#;

fn edits(found: &Finding) -> Vec<(EditKind, &str)> {
    found.corrections.iter().map(|one| (one.changes[0].kind, one.formula.as_str())).collect()
}

#[test]
fn one_edit_of_each_kind_is_found() {
    for (printed, kind, corrected) in [
        (r"m \ddot{x} - c \dot{x} + k x = F", EditKind::Sign, r"m \ddot{x} + c \dot{x} + k x = F"),
        (r"m \ddot{x} + c x + k x = F", EditKind::Dot, r"m \ddot{x} + c \dot{x} + k x = F"),
        (r"m \ddot{x} + c \dot{x} + k y = F", EditKind::Letter, r"m \ddot{x} + c \dot{x} + k x = F"),
        (r"m \ddot{x} + c \dot{x} + k x^2 = F", EditKind::Exponent, r"m \ddot{x} + c \dot{x} + k x = F"),
        (r"m \ddot{x} + 3 c \dot{x} + k x = F", EditKind::Number, r"m \ddot{x} + c \dot{x} + k x = F"),
        (r"m \ddot{x} + c \dot{x} + x = F", EditKind::MissingFactor, r"m \ddot{x} + c \dot{x} + k x = F"),
        (r"m \ddot{x} + c \dot{x} + k c x = F", EditKind::ExtraFactor, r"m \ddot{x} + c \dot{x} + k x = F"),
        (r"m \ddot{x} + c \dot{x} + k x = F + m g", EditKind::ExtraTerm, r"m \ddot{x} + c \dot{x} + k x = F"),
    ] {
        let found = on(CART, "equation of motion", printed, "");
        assert_eq!(edits(&found).first(), Some(&(kind, corrected)), "{}", found.text());
        assert_eq!(found.corrections[0].judged.verdict.name(), "proved");
        let part = &found.corrections[0].parts[0];
        let after = &found.corrections[0].changes[0].after;
        assert_eq!(found.corrections[0].formula[part.clone()].trim(), after, "{}", found.text());
    }
    let lost = on(CART, "equation of motion", r"m \ddot{x} + k x = F", "");
    assert_eq!(edits(&lost)[0].0, EditKind::LostTerm, "{}", lost.text());
}

#[test]
fn a_hypothesis_that_is_missing_is_found() {
    let found = on(CART, "integral of motion", r"m \dot{y} = \mathrm{const}", "");
    let hypotheses: Vec<&str> = found.corrections.iter().map(|one| one.changes[0].after.as_str()).collect();
    assert!(hypotheses.contains(&"g = 0"), "{}", found.text());
}

#[test]
fn no_correction_says_nothing() {
    // y replaced by x would make both sides equal expressions
    let found = on(CART, "formula", r"\dot{y} = \dot{x}", "");
    assert_eq!(verdict(&found), "refuted");
    for correction in &found.corrections {
        let (left, right) = correction.formula.split_once('=').expect("it is an equality");
        assert_ne!(left.trim(), right.trim(), "{}", found.text());
    }
    let proved = on(CART, "equation of motion", r"\ddot{y} = -g", "");
    assert!(proved.corrections.is_empty());
}

#[test]
fn brackets_keep_their_sizes() {
    let found = on(CART, "equation of motion", r"\left(\ddot{y} - g\right) m = 0", "");
    assert_eq!(edits(&found), [(EditKind::Sign, r"\left(\ddot{y} + g\right) m = 0")], "{}", found.text());
    let found = on(CART, "formula", r"\left(\ddot{y}\right) m = \left( m g \right)", "");
    assert!(found.corrections.iter().all(|one| !one.formula.contains(r"\left-")), "{}", found.text());
}

#[test]
fn many_slips_of_one_side_are_told_one_by_one() {
    let system = CART.replace("'T' =", "'S' = \"(x + y)^5\"\n'T' =");
    let printed = r"S = 2 x^5 + 5 x^4 y + 5 x^3 y^2 + 20 x^2 y^3 - 5 x y^4 + y^5";
    let found = on(&system, "formula", printed, "");
    let [first] = &found.corrections[..] else { panic!("{}", found.text()) };
    assert_eq!(first.changes.len(), 4, "{}", found.text());
    assert!(first.changes.iter().all(|change| matches!(change.kind, EditKind::MissingFactor | EditKind::Sign)));
    assert!(first.says().starts_with("4 places differ: "), "{}", first.says());
    // a correction would keep less than half of the printed formula
    let printed = r"S = x^4 y + 5 x^3 y^2 + 10 x^2 y^3 - 7 x^2 y^4 + 3 x^5 y^4 + x^5 y^5 - x^5 y^6";
    assert!(on(&system, "formula", printed, "").corrections.is_empty());
}

#[test]
fn dots_that_are_lost_wherever_a_letter_stands_are_one_edit() {
    let printed = r"T = \frac{1}{4} m (x^2 + y^2) + \frac{1}{4} m (x^2 + y^2)";
    let found = on(CART, "formula", printed, "");
    let [first, ..] = &found.corrections[..] else { panic!("{}", found.text()) };
    let words: Vec<&str> = first.changes.iter().map(|change| change.words.as_str()).collect();
    let expected = ["x", "y"].map(|x| format!(r"`\dot{{{x}}}` for `{x}` wherever it stands on the right side"));
    assert_eq!(words, expected, "{}", found.text());
}

#[test]
fn the_bracket_of_a_power_stays_where_its_letter_is_exchanged() {
    let found = on(CART, "formula", r"T = \frac{1}{2} m ((x)^2 + (\dot{y})^2)", "");
    let formulas: Vec<&str> = found.corrections.iter().map(|one| one.formula.as_str()).collect();
    assert_eq!(formulas, [r"T = \frac{1}{2} m ((\dot{x})^2 + (\dot{y})^2)"], "{}", found.text());
}

#[test]
fn a_letter_for_others_does_not_hide_that_a_correction_says_nothing() {
    // replacing the left side by the right one, with h/2 for l, would make both sides equal
    let found = on_pendulum("identity", r"\sqrt{l^2 + m^2} = \sqrt{l^2} + m", r"given = ['l \geq 0', 'm \geq 0']");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
    assert!(found.corrections.iter().all(|one| !one.formula.contains('h')), "{}", found.text());
}

#[test]
fn no_condition_is_corrected_to_be_equivalent_to_itself() {
    for print in [r"g = l \iff m = l", r"\dot\theta = 0 \iff \theta = 0", r"g = 0 \iff l = 0"] {
        let found = on_pendulum("equivalence", print, "");
        assert_eq!(verdict(&found), "refuted", "{}", found.text());
        for correction in &found.corrections {
            let [one, other] = correction.formula.split(r"\iff").map(str::trim).collect::<Vec<_>>()[..] else {
                panic!("{}", correction.formula)
            };
            assert_ne!(one, other, "{print}");
        }
    }
}

/// A symmetric body about its centre of mass, with a moment of inertia that varies linearly in time.
const BODY: &str = r#"
title = "A free body"
[parameters]
A0 = "kg m^2"
A1 = "kg m^2/s"
C = "kg m^2"
[inputs]
X = "N m"
Y = "N m"
Z = "N m"
[coordinates]
[frames]
F = "N free"
[definitions]
A = "A0 + A1*t"
gamma1 = "F.x . N.z"
gamma2 = "F.y . N.z"
gamma3 = "F.z . N.z"
[bodies.body]
frame = "F"
inertia = { principal = ["A", "A", "C"] }
[[torque]]
on = "body"
is = "X*F.x + Y*F.y + Z*F.z"
[letters]
'A' = "A"
'C' = "C"
'X' = "X"
'Y' = "Y"
'Z' = "Z"
'p' = "F.wx"
'q' = "F.wy"
'r' = "F.wz"
'\gamma_1' = "gamma1"
'\gamma_2' = "gamma2"
'\gamma_3' = "gamma3"
'G' = "A*(F.wx*gamma1 + F.wy*gamma2) + C*F.wz*gamma3"
'H' = "gamma3^2"
"#;

#[test]
fn terms_of_direction_cosines_are_told_by_the_letters_that_a_paper_has_for_them() {
    let printed = r"\dot{G} = \gamma_1 X + \gamma_2 Y + \gamma_3 Z";
    let found = on(BODY, "equation of motion", printed, "");
    let missing = found.judged.difference.as_ref().map(|(text, _)| text.as_str());
    assert_eq!(missing, Some("A'*gamma_1*p + A'*gamma_2*q"), "{}", found.text());
    // the missing term has a product of two direction cosines
    let found = on(BODY, "formula", r"\dot{H} = 2\gamma_3 q \gamma_1", "");
    let missing = found.judged.difference.as_ref().map(|(text, _)| text.as_str());
    assert_eq!(missing, Some("-2*gamma_2*gamma_3*p"), "{}", found.text());
}
