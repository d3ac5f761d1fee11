//! Every principle of mechanics gives the same equations, for every model.

mod chains;
mod free_frames;
mod loads;
mod motions;
mod projected;
mod quasi_velocities;
mod rates;
mod reactions;
mod statements;
mod systems;
mod trees;
mod variations;
mod verdicts;

use dalembert_model::principles::Principle;
use dalembert_model::{BodySource, LoadSource, Model, Source, Trace};
use symbolic::{Decision, Hypotheses, apart};
use systems::{chain, disc, double_pendulum, held, sleigh, slider_crank, two_bodies};

fn agree(source: &Source) {
    let model = Model::of(source).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        let all = Principle::ALL.map(|principle| principle.residual(&trace).expect("it applies"));
        for (principle, residual) in Principle::ALL.iter().zip(&all).skip(1) {
            for (i, (own, first)) in residual.iter().zip(&all[0]).enumerate() {
                let decided = Hypotheses::none().equal(*own, *first);
                assert!(matches!(decided, Decision::Zero(_)), "{principle:?}, equation {i}: {decided}");
            }
        }
    });
}

#[test]
fn principles_agree_on_a_double_pendulum() {
    agree(&double_pendulum(false));
    agree(&double_pendulum(true));
}

#[test]
fn principles_agree_on_a_leaning_disc() {
    agree(&disc());
}

#[test]
fn principles_agree_on_systems_with_constraints_and_in_space() {
    agree(&sleigh());
    agree(&slider_crank());
    agree(&two_bodies());
    agree(&chain(3));
    let held_by = |source: Source, zero: &[&str]| Source { constraints: vec![held("held", zero)], ..source };
    // constraints on coordinates, along moving axes, and nonlinear in the speeds
    agree(&held_by(disc(), &["lean - (1 rad/s)*t", "x'^2 + y'^2 - (1 m/s)^2", "(G - F) . C.x"]));
    agree(&held_by(disc(), &["velocity(G in C) . B.y", "rate((G - F) . B.x)", "angular_velocity(disc in B) . C.y"]));
    agree(&held_by(two_bodies(), &["cross(K - G, S.y)", "distance(O, K) - (1 m)"]));
    // every operation that can occur in a constraint
    agree(&held_by(disc(), &["x/(y - r) - tan(spin)", "unit(G - F) . C.y", "atan2(x, y) - exp(lean)*tanh(heading)"]));
    agree(&held_by(disc(), &["norm(rate(G - F in C)) - h*heading'^2/lean'", "cross(velocity(G in D), C.x) . B.z"]));
}

/// Loads on a point and a frame that belong to no body but depend on the coordinates.
#[test]
fn loads_act_on_points_and_frames_without_a_body() {
    let on = |on: &str, is: &str| LoadSource { on: Some(on.into()), is: is.into(), ..LoadSource::default() };
    let mut source = double_pendulum(true);
    source.coordinates.push(("s", "m").into());
    source.points.extend([("R", "P + s*A.x").into(), ("S", "P - s*A.x").into()]);
    source.frames.push(("M", "N turned 2*b - s/l1 about z").into());
    source.bodies.push(BodySource::particle("counterweight", "S", "m1"));
    source.forces = vec![on("R", "k*l1*B.y"), on("R", "k*s*A.y")];
    source.torques.push(on("M", "c*a'*N.z"));
    agree(&source);
}

/// A mass that depends on position or time is treated as constant at each instant.
#[test]
fn a_mass_that_varies_has_one_law_by_every_principle() {
    let mut source = sleigh();
    source.bodies[0].mass = Some("m + (1 kg/m)*x - (0.1 kg/s)*t".into());
    agree(&source);
}

#[test]
fn constraints_of_speeds_are_integrable_or_not_as_frobenius_says() {
    let kind = |source: &Source| {
        let model = Model::of(source).unwrap_or_else(|faults| panic!("{faults:?}"));
        apart(|| dalembert_model::constraints(&Trace::of(&model)).pop().unwrap_or_default())
    };
    let rolls = "constraints of speeds: not integrable (Frobenius)";
    assert_eq!(kind(&sleigh()), rolls);
    let held_by = |zero: &[&str]| Source { constraints: vec![held("held", zero)], ..disc() };
    assert_eq!(kind(&held_by(&["velocity(disc at P) . N.x", "velocity(disc at P) . N.y"])), rolls);
    // rolling straight ahead: x' = r spin'
    let straight = ["x' - r*spin'", "y'", "heading'", "lean'"];
    assert_eq!(kind(&held_by(&straight)), "constraints of speeds: integrable (Frobenius, identified)");
    // integrable constraints with variable gradients; three degrees of freedom remain
    let on_sphere = ["x*x' + y*y' + (1 m^2)*lean*lean'", "heading' - lean*spin' - spin*lean'"];
    assert_eq!(kind(&held_by(&on_sphere)), "constraints of speeds: integrable (Frobenius, identified)");
    // Frobenius' theorem is applied only to constraints that are linear and homogeneous in the speeds and free of time
    for (open, why) in [
        ("x' - r*spin' - (1 m/s)", "a constraint is affine, and not homogeneous, in the speeds"),
        ("x' - (1 m/s)*t*spin'", "a constraint holds the time"),
        ("x'^2 + y'^2 - (1 m/s)^2", "a constraint is nonlinear in the speeds"),
    ] {
        let told = format!("constraints of speeds: it is not decided whether they are integrable, since {why}");
        assert_eq!(kind(&held_by(&[open])), told, "{open}");
    }
    // one degree of freedom remains: a one-dimensional distribution is integrable
    assert_eq!(
        kind(&held_by(&["x' - r*spin'*cos(lean)", "y' - heading'*x", "lean' - spin'", "heading' - spin'*cos(lean)"])),
        "constraints of speeds: integrable (Frobenius, identified)"
    );
}

#[test]
fn constraints_are_told_apart_by_what_they_speak_of() {
    let mut source = disc();
    let one = |zero: &str| dalembert_model::ConstraintSource {
        zero: vec![zero.into()],
        ..dalembert_model::ConstraintSource::default()
    };
    source.parameters.push(("w", "1 rad/s").into());
    source.constraints = vec![
        one("velocity(disc at P) . N.x"),
        one("lean - w*t"),
        one("x' - w*y - (1 m/s)"),
        one("x'^2 + y'^2 - (1 m/s)^2"),
    ];
    let model = Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}"));
    let told = apart(|| dalembert_model::constraints(&Trace::of(&model)));
    let kinds = ["of speeds, linear", "of positions, with the time", "of speeds, affine", "of speeds, nonlinear"];
    // one more sentence states whether all are integrable
    assert_eq!(told.len(), kinds.len() + 1);
    for (told, kind) in told.iter().zip(kinds) {
        assert!(told.ends_with(kind), "{told}");
    }
}
