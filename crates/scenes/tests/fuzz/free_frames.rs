//! Fuzz tests of files with a free frame, with every command.

use super::{Drawn, changed};
use dalembert_scenes::{ModelScene, parse_ensemble};

/// A free body on a spring, with an ensemble; every command accepts it.
const FREE: &str = r#"
title = "A free body"
gravity = "-g*N.z"

[parameters]
m = "2 kg"
l = "0.5 m"
J = "0.3 kg m^2"
g = "9.81 m/s^2"

[coordinates]
z = "m"
y = "m"

[speeds]
p = "F.wx"
q = "F.w . A.y"
r = "F.wz - F.wy"
n = "velocity(stone) . A.z"

[frames]
F = "N free"
A = "F turned (30 deg) about x"

[points]
P = "O + z*N.z + y*N.y"
Q = "P + l*A.x"

[bodies.stone]
frame = "F"
centre = "P"
mass = "m"
inertia = { axes = "A", principal = ["J", "J", "1.5*J"] }

[[force]]
between = ["ground at O + l*N.x", "stone at Q"]
is = "-(30 N/m)*(distance(O + l*N.x, Q) - l)"

[[constraint]]
name = "slide"
zero = "y - l*(F.x . N.y)"

[outputs]
slip = "reaction(slide) + (1 N/rad)*F.wx*(1 s)"

[start]
F = "20 deg about z, then 5 deg about y"
"F.wz" = "2 rad/s"
q = "0.3 rad/s"
y = "guess 0.1 m"

[run]
span = "1 s"

[ensemble]
members = 2

[ensemble.vary]
start.F = { mean = "0 0 0 deg", deviation = "5 5 5 deg" }
start."F.wx" = { from = "-1 rad/s", to = "1 rad/s" }
start.q = { from = "-1 rad/s", to = "1 rad/s" }
parameters.l = { from = "0.4 m", to = "0.6 m" }
"#;

/// Linear equations, equilibria, code and members of files with a free frame and random changes.
#[test]
fn free_frames_are_taken_by_every_command_or_refused() {
    use dalembert_scenes::linearisation::VariedEquations;
    use model::{MatrixForm, QuasiPrinciple, QuasiVelocities, Trace, principles::Principle};
    let sound = ModelScene::parse("scene.toml", FREE).unwrap_or_else(|error| panic!("{error}"));
    assert!(sound.model.warnings.is_empty());
    let rounds = std::env::var("FUZZ_ROUNDS").ok().and_then(|rounds| rounds.parse().ok()).unwrap_or(600);
    let mut drawn = Drawn(38);
    let (mut linear, mut written, mut started, mut rested) = (0, 0, 0, 0);
    for _ in 0..rounds {
        let text = changed(FREE, &mut drawn);
        if let Ok(scene) = parse_ensemble("scene.toml", &text) {
            started += (1..=scene.members.min(2)).filter(|number| scene.member(*number).is_ok()).count();
        }
        let Ok(scene) = ModelScene::parse("scene.toml", &text) else { continue };
        if let Ok(equations) = VariedEquations::of(&scene.model, &[])
            && let Ok(found) = equations.linearised(equations.point(0.0, &scene.start))
        {
            linear += 1;
            let size = found.coordinates.len() + found.speeds.len();
            assert_eq!(found.a.shape(), (size, size), "{text}");
            assert!(found.a.iter().all(|entry| entry.is_finite()), "{text}");
        }
        rested += usize::from(dalembert_scenes::equilibrium_of(&scene.model).is_ok());
        written += symbolic::apart(|| {
            let trace = Trace::of(&scene.model);
            let form = MatrixForm::of(&trace, Principle::VirtualPower).ok();
            if !scene.model.quasi_velocities.is_empty() {
                let quasi = QuasiVelocities::of(&trace).unwrap_or_else(|faults| panic!("{faults:?}\n{text}"));
                let form = MatrixForm::in_quasi_velocities(&trace, &quasi, QuasiPrinciple::Hamel).ok();
                form.and_then(|form| model::code(&trace, &form, symbolic::Language::C).ok());
            }
            form.is_some_and(|form| model::code(&trace, &form, symbolic::Language::C).is_ok()) as usize
        });
    }
    println!("{linear} linear, {written} written, {started} members, {rested} at rest");
    assert!(linear > 50 && written > 50 && started > 50, "{linear} {written} {started}");
}
