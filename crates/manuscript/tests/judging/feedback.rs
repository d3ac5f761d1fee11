//! Hypotheses that state an input as a function of the state hold at all times.

use crate::cases::BLOCK;
use crate::{on, verdict};

#[test]
fn linear_equations_are_those_of_the_closed_loop() {
    let rest = "resting = ['x']\ngiven = ['x = 0', 'u = 2 k x']";
    let turned = rest.replace("'u = 2 k x'", "'2 k x = u'");
    for (formula, more, expected) in [
        (r"m \ddot{x} + c v - k x = 0", rest, "proved"),
        (r"m \ddot{x} + c v - k x = 0", &turned, "proved"),
        (r"m \ddot{x} + c v + k x = 0", rest, "refuted"),
        (r"m \ddot{x} + c v + k x = u", rest, "proved"),
    ] {
        let found = on(BLOCK, "linearised equation", formula, more);
        assert_eq!(verdict(&found), expected, "{formula}: {}", found.text());
    }
}

#[test]
fn a_motion_is_stable_as_that_of_the_closed_loop() {
    let more = |input: &str| format!("resting = ['x']\ngiven = ['x = 0', {input}, 'm > 0', 'c > 0']");
    for (formula, input, expected) in [
        ("k > 0", "'u = 0'", "proved"),
        ("k > 0", "'u = 2 k x'", "refuted"),
        ("k < 0", "'u = 2 k x'", "proved"),
        ("k > 0", "'u = -c v'", "proved"),
        ("k > 0", "'u = -3 c v'", "proved"),
        ("k > 0", "'u = 2 c v'", "refuted"),
    ] {
        let found = on(BLOCK, "stability", formula, &more(input));
        assert_eq!(verdict(&found), expected, "{formula}, {input}: {}", found.text());
    }
}

#[test]
fn an_integral_has_the_input_that_is_given() {
    for (formula, given, expected) in [
        (r"E - u x = \mathrm{const}", "'c = 0', 'u = F_0'", "proved"),
        (r"E - F_0 x = \mathrm{const}", "'c = 0', 'u = F_0'", "proved"),
        (r"E + u x = \mathrm{const}", "'c = 0', 'u = F_0'", "refuted"),
        (r"E - k x^2 = \mathrm{const}", "'c = 0', 'u = 2 k x'", "proved"),
    ] {
        let found = on(BLOCK, "integral of motion", formula, &format!("given = [{given}]"));
        assert_eq!(verdict(&found), expected, "{formula}: {}", found.text());
    }
}
