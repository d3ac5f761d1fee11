//! Multiples and fractions of one angle, and cosines of rational multiples of pi.

use crate::{PENDULUM, on, verdict};

fn value(text: &str) -> f64 {
    let (above, below) = text.split_once('/').unwrap_or((text, "1"));
    above.parse::<f64>().expect("a number") / below.parse::<f64>().expect("a number")
}

#[test]
fn multiples_of_an_angle_are_expanded_up_to_a_bound() {
    let identity = r"\sin(32\theta) = 2\sin(16\theta)\cos(16\theta)";
    assert_eq!(verdict(&on(PENDULUM, "identity", identity, "")), "proved");
    let beyond = r"\sin(64\theta) = 2\sin(32\theta)\cos(32\theta)";
    let found = on(PENDULUM, "identity", beyond, "");
    assert_eq!(verdict(&found), "undecided", "{}", found.text());
    assert!(found.judged.evidence.contains("more than 32 times an angle"), "{}", found.text());
}

#[test]
fn the_values_of_an_angle_and_of_its_half_belong_together() {
    let printed = r"m l^2 \ddot\theta + 2 m g l \sin\frac{\theta}{2}\cos\frac{\theta}{2} = \sin\theta";
    let found = on(PENDULUM, "equation of motion", &printed.replace(r"= \sin", r"= m g l \sin"), "");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
    let all = &found.judged.counterexample;
    let of = |letter: &str| all.iter().find(|(name, _)| name == letter).map(|(_, text)| value(text));
    let Some((cos, sin)) = of("cos(theta/2)").zip(of("sin(theta/2)")) else { panic!("{}", found.text()) };
    assert!((cos * cos + sin * sin - 1.0).abs() < 1e-12, "{}", found.text());
    let accelerated = of("theta''").expect("it is listed");
    let [g, l] = ["g", "l"].map(|letter| of(letter).expect("it is listed"));
    assert!((l * accelerated + 2.0 * g * sin * cos).abs() < 1e-9, "{}", found.text());
}

#[test]
fn numbers_of_parts_of_pi_have_signs() {
    for (kind, formula, given, expected) in [
        ("inequality", r"\sin\frac{\pi}{5} > \frac35", "", "refuted"),
        ("inequality", r"\sin\frac{\pi}{5} < \frac35", "", "enclosed"),
        ("inequality", r"m \sin\frac{\pi}{5} < \frac{3 m}{5}", "'m > 0'", "proved"),
        ("inequality", r"\pi \theta^2 + \theta + \frac{1}{12} > 0", "", "proved"),
        ("inequality", r"\pi \theta^2 + \theta + \frac{1}{13} > 0", "", "refuted"),
        ("inequality", r"\exp(\theta) > 0", "", "proved"),
        ("inequality", r"\theta^2 + \exp(-\theta) > 0", "", "proved"),
        ("identity", r"\sin(1000\pi) = 0", "", "proved"),
        ("identity", r"\cos(7\pi) = -1", "", "proved"),
        ("identity", r"\cos\left(\theta + 101\pi\right) = -\cos\theta", "", "proved"),
    ] {
        let found = on(PENDULUM, kind, formula, &format!("given = [{given}]"));
        assert_eq!(verdict(&found), expected, "{}", found.text());
    }
}

/// A bead on an arc of radius R, with its distance s along the arc as coordinate.
const ARC: &str = r#"
title = "Bead"
gravity = "-g*N.y"
parameters = { m = "kg", R = "m", g = "m/s^2", K = "J" }
coordinates = { s = "m" }
frames = { A = "N turned s/R about z" }
bodies = { b = { centre = "O - R*A.y", mass = "m" } }
energies = { potential = "K*sin(s/R)^2" }
letters = { m = "m", R = "R", g = "g", K = "K", s = "s" }
"#;

#[test]
fn multiples_of_an_angle_that_is_divided_by_a_letter_belong_together() {
    for (kind, formula, given, expected) in [
        ("equation of motion", r"m\ddot{s} + m g\sin\frac{s}{R} + \frac{K}{R}\sin\frac{2s}{R} = 0", "", "proved"),
        ("identity", r"\cos\frac{2s}{R} = 2\cos^2\frac{s}{R} - 1", "", "proved"),
        ("identity", r"\sin\frac{s}{R} = 2\sin\frac{s}{2R}\cos\frac{s}{2R}", "", "proved"),
        ("identity", r"\cos\frac{2s}{R} = 2\cos^2\frac{s}{R} + 1", "", "refuted"),
        // for angles between 0 and 1 the sine is positive
        ("identity", r"\sqrt{\sin^2\frac{s}{R}} = \sin\frac{s}{R}", "given = ['s > 0', 's < R']", "proved"),
    ] {
        let found = on(ARC, kind, formula, given);
        assert_eq!(verdict(&found), expected, "{}", found.text());
    }
}
