//! Inequalities proved by sums of squares with sines, and by monotonic functions.

use crate::{PENDULUM, on, on_pendulum, verdict};

/// A hoop with a bob on its rim that rolls along a line.
const HOOP: &str = r#"
title = "A hoop with a bob"
[parameters]
m = "kg"
R = "m"
c = "m"
J = "kg m^2"
[coordinates]
x = "m"
p = "rad"
[frames]
A = "N turned -p about z"
[points]
C = "O + x*N.x + R*N.y"
G = "C + c*A.x"
K = "C - R*N.y"
[bodies.hoop]
frame = "A"
centre = "G"
mass = "m"
inertia = "J"
[[constraint]]
name = "roll"
zero = "x' - R*p'"
[letters]
'm' = "m"
'R' = "R"
'c' = "c"
'J' = "J"
'\varphi' = "p"
'H_K' = "angular_momentum(hoop, K) . N.z"
'v' = "norm(velocity(G))"
'T' = "kinetic_energy"
'p_x' = "momentum(x)"
"#;

#[test]
fn a_function_that_grows_from_equality_on_is_greater() {
    for (formula, given, expected) in [
        (r"\sin\theta \leq \theta", r"'\theta \geq 0'", "proved"),
        (r"\sin\theta < \theta", r"'\theta > 0'", "proved"),
        (r"\theta \neq \sin\theta", r"'\theta > 0'", "proved"),
        (r"\cos\theta \geq 1 - \frac{\theta^2}{2}", r"'\theta \geq 0'", "proved"),
        (r"\sin\theta \geq \theta - \frac{\theta^3}{6}", r"'\theta \geq 0'", "proved"),
        (r"\tan\theta > \theta", r"'\theta > 0', '\theta < \frac{\pi}{2}'", "proved"),
    ] {
        let found = on_pendulum("inequality", formula, &format!("given = [{given}]"));
        assert_eq!(verdict(&found), expected, "{}", found.text());
    }
    for (formula, given) in [
        (r"\sin\theta < \theta", r"'\theta \geq 0'"),
        (r"\sin\theta < \frac{\theta}{2}", r"'\theta > 0'"),
        (r"\tan\theta > \theta", r"'\theta > 0'"),
    ] {
        let found = on_pendulum("inequality", formula, &format!("given = [{given}]"));
        assert_ne!(verdict(&found), "proved", "{}", found.text());
    }
}

#[test]
fn squares_of_cosines_are_one_less_those_of_sines() {
    for (formula, given) in [
        (r"(m + l)(g + m l^2) \geq m^2 l^2 \cos^2\theta", "'m > 0', 'l > 0', 'g > 0'"),
        (r"m^2 \cos^2\theta \geq m^2 \cos^4\theta", ""),
        (r"m^2 + l^2 \geq 2 m l \sin\theta", "'m > 0', 'l > 0'"),
    ] {
        let found = on_pendulum("inequality", formula, &format!("given = [{given}]"));
        assert_eq!(verdict(&found), "proved", "{}", found.text());
    }
    let found = on(PENDULUM, "inequality", r"m^2 \cos^2\theta > m^2 \cos^4\theta", "");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
}

#[test]
fn a_speed_of_a_point_that_never_rests_is_positive() {
    let found = on(HOOP, "inequality", "v > 0", r"given = ['\dot\varphi > 0', 'c < R', 'c > 0']");
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    let found = on(HOOP, "inequality", "v > 0", r"given = ['\dot\varphi > 0', 'c > 0', 'R > 0']");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
}

#[test]
fn a_factor_that_is_a_sum_of_squares_divides_a_condition() {
    let given = "given = ['J > 0', 'm > 0', 'R > 0']";
    let found = on(HOOP, "equivalence", r"H_K = 0 \iff \dot\varphi = 0", given);
    assert_eq!(verdict(&found), "proved", "{}", found.text());
}
