//! Free frames (quaternions), compared with frames by successive rotations.

use dalembert_scenes::ModelScene;
use integrators::Method;
use model::principles::Principle;
use model::{Agreement, Trace, agreement};
use simulation::{Choice, IvpScene, Trajectory};

fn open(text: &str) -> ModelScene {
    ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn runs(text: &str, method: Method) -> Trajectory {
    let scene = open(text);
    let choice = Choice { method, tolerance: 1e-12, ..scene.run().choice() };
    let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
    assert_eq!(trajectory.stopped(), None);
    trajectory
}

fn last(trajectory: &Trajectory, name: &str) -> f64 {
    trajectory.last[trajectory.column(name).unwrap_or_else(|| panic!("{name}: {:?}", trajectory.names))]
}

/// A heavy top about a fixed point with air drag; the marker FRAMES stands for the definition of its frame.
const TOP: &str = r#"
title = "A heavy top"
gravity = "-g*N.z"
[parameters]
m = "1.5 kg"
l = "0.2 m"
A = "0.03 kg m^2"
C = "0.01 kg m^2"
g = "9.81 m/s^2"
k = "0.02 N m s"
[coordinates]
COORDINATES
[frames]
FRAMES
[bodies.top]
frame = "F"
centre = "O + l*F.z"
mass = "m"
inertia = { principal = ["A", "1.2*A", "C"] }
[[torque]]
on = "top"
is = "-k*angular_velocity(top)"
[outputs]
north = "l*F.z . N.y"
east = "l*F.z . N.x"
mark = "F.x . N.z"
[start]
START
[run]
span = "2 s"
"#;

fn free_top() -> String {
    TOP.replace("COORDINATES", "").replace("FRAMES", "F = \"N free\"").replace(
        "START",
        "F = \"10 deg about z, then 40 deg about x\"\n\"F.wz\" = \"30 rad/s\"\n\"F.wx\" = \"0.5 rad/s\"",
    )
}

fn turned_top() -> String {
    let start = "yaw = \"10 deg\"\ntilt = \"40 deg\"\n\"spin'\" = \"30 rad/s\"\n\"tilt'\" = \"0.5 rad/s\"";
    TOP.replace("COORDINATES", "yaw = \"rad\"\ntilt = \"rad\"\nspin = \"rad\"")
        .replace("FRAMES", "Y = \"N turned yaw about z\"\nT = \"Y turned tilt about x\"\nF = \"T turned spin about z\"")
        .replace("START", start)
}

#[test]
fn a_free_top_moves_as_one_of_three_turns() {
    let turned = runs(&turned_top(), Method::Taylor);
    for method in [Method::DormandPrince8, Method::Taylor, Method::Radau5] {
        let free = runs(&free_top(), method);
        for name in ["north", "east", "mark", "kinetic_energy"] {
            let [one, other] = [&free, &turned].map(|run| last(run, name));
            assert!((one - other).abs() < 1e-8, "{method:?}: {name} {one} {other}");
        }
    }
}

#[test]
fn every_principle_gives_a_free_top_the_same_equations() {
    let scene = open(&free_top());
    symbolic::apart(|| {
        let trace = Trace::of(&scene.model);
        for other in Principle::ALL {
            let found = agreement(&trace, Principle::Lagrange, other).expect("it applies");
            let known = matches!(found, Agreement::Proved { .. } | Agreement::Identified { .. });
            assert!(known, "{}: {found}", other.name());
        }
    });
}

#[test]
fn a_free_body_keeps_its_energy_and_its_moment_of_momentum() {
    let path = format!("{}/../../scenes/models/tumbling_body.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("it is there");
    let trajectory = runs(&text, Method::DormandPrince8);
    let column = trajectory.column("momentum").expect("an output");
    let first = trajectory.rows[0][column];
    assert!(trajectory.rows.iter().all(|row| (row[column] - first).abs() < 1e-10));
    let [energy] = trajectory.outcome.deviations.as_slice() else { panic!("the energy is watched") };
    assert!(energy.largest < 1e-10, "{energy:?}");
    // rotation about the middle principal axis is unstable: the body turns over
    let along = trajectory.column("F.wy").expect("a speed");
    assert!(trajectory.rows.iter().any(|row| row[along] < -0.9));
}

/// A plate with a pinned corner: three constraints determine a free frame and a point at the start.
#[test]
fn a_start_of_a_free_frame_is_completed_by_turns() {
    let text = r#"
title = "A plate on a pin"
gravity = "-(9.81 m/s^2)*N.z"
[parameters]
m = "1 kg"
a = "0.3 m"
J = "0.01 kg m^2"
[coordinates]
x = "m"
y = "m"
z = "m"
[frames]
F = "N free"
[points]
G = "O + x*N.x + y*N.y + z*N.z"
[bodies.plate]
frame = "F"
centre = "G"
mass = "m"
inertia = { principal = ["J", "J", "2*J"] }
[[constraint]]
zero = "G + a*F.x - O"
[[constraint]]
zero = "F.y . N.z"
[start]
F = "guess 5 deg about x, then 20 deg about y"
x = "-0.25 m"
"F.wz" = "0.4 rad/s"
[run]
span = "1 s"
"#;
    let trajectory = runs(text, Method::DormandPrince8);
    let [energy] = trajectory.outcome.deviations.as_slice() else { panic!("the energy is watched") };
    assert!(energy.largest < 1e-9, "{energy:?}");
    let at = |name: &str| last(&trajectory, name);
    let length = at("x").powi(2) + at("y").powi(2) + at("z").powi(2);
    assert!((length - 0.09).abs() < 1e-9, "{length}");
}
