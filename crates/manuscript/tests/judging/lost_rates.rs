//! Rates that are lost as factors.

use crate::{PENDULUM, on, on_pendulum, verdict};

#[test]
fn an_acceleration_is_lost_in_a_linear_equation() {
    let about_rest = r"given = ['\theta = 0']
resting = ['\theta']";
    let found = on_pendulum("linearised equation", r"m l^2 + m g l \theta = 0", about_rest);
    assert_eq!(verdict(&found), "refuted", "{}", found.judged.evidence);
    let right = r"\ddot{\theta} m l^2 + m g l \theta = 0";
    assert!(found.corrections.iter().any(|one| one.formula == right), "{}", found.text());
}

#[test]
fn a_constant_speed_is_lost_in_the_condition_of_a_steady_motion() {
    let system = PENDULUM
        .replace("theta = \"rad\"", "theta = \"rad\"\nphi = \"rad\"")
        .replace("A = \"N turned theta about z\"", "B = \"N turned phi about y\"\nA = \"B turned theta about z\"")
        .replace(r"'\theta' =", "'\\varphi' = \"phi\"\n'\\theta' =");
    let rests = r"given = ['\sin\theta \neq 0']
resting = ['\theta', '\dot{\varphi}']";
    let found = on(&system, "steady motion", r"l \cos\theta = g", rests);
    assert_eq!(verdict(&found), "refuted", "{}", found.judged.evidence);
    let has_speed = |formula: &str| formula.contains(r"\dot{\varphi}^2");
    assert!(found.corrections.iter().any(|one| has_speed(&one.formula)), "{}", found.text());
}

#[test]
fn a_point_of_an_angle_beside_its_sine_is_real() {
    let found = on_pendulum("equation of motion", r"l \ddot\theta + g \theta = \sin\theta", "");
    assert_eq!(verdict(&found), "refuted", "{}", found.judged.evidence);
    assert!(!found.judged.evidence.contains("independent"), "{}", found.text());
}
