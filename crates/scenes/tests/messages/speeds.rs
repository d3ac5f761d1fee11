//! Messages about quasi-velocities: their number, their starts, their names.

use super::{messages, one};

/// Replacements that turn the pendulum into a body with three successive rotations; components of its angular velocity are quasi-velocities.
fn gimbal(start: &str) -> Vec<(&'static str, String)> {
    let inertia =
        "frame = \"A\"\ninertia = { principal = [\"(1 kg m^2)\", \"(2 kg m^2)\", \"(2.5 kg m^2)\"] }\nmass = \"m\"";
    let speeds = "[speeds]\np = \"angular_velocity(A) . A.x\"\nq = \"angular_velocity(A) . A.y\"\nr = \"angular_velocity(A) . A.z\"\n\n[frames]";
    vec![
        ("theta = \"rad\"", "psi = \"rad\"\ntheta = \"rad\"\nphi = \"rad\"".to_owned()),
        ("[frames]", speeds.to_owned()),
        (
            "A = \"N turned theta about z\"",
            "B = \"N turned psi about z\"\nC = \"B turned theta about x\"\nA = \"C turned phi about z\"".to_owned(),
        ),
        ("mass = \"m\"", inertia.to_owned()),
        ("theta = \"0.3 rad\"", start.to_owned()),
    ]
}

fn told(edits: &[(&'static str, String)], parts: &[&str]) {
    let edits: Vec<(&str, &str)> = edits.iter().map(|(from, to)| (*from, to.as_str())).collect();
    one(&edits, parts);
}

#[test]
fn a_position_to_which_quasi_velocities_do_not_belong_is_told_as_one() {
    let locked = [
        "the value of `q` in [start] cannot hold in this position",
        "no rates of coordinates give it here; in neighbouring positions some do",
        "three angles of rotation are not defined where their first and third axes coincide",
    ];
    told(&gimbal("p = \"0.1 rad/s\"\nq = \"1.5 rad/s\"\nr = \"0.05 rad/s\""), &locked);
    told(&gimbal("p = \"0.1 rad/s\"\nq = \"1.5 rad/s\"\nphi = \"0.4 rad\""), &locked);
    let edits = gimbal("theta = \"0.2 rad\"\np = \"0.1 rad/s\"\nq = \"1.5 rad/s\"\nr = \"0.05 rad/s\"");
    let edits: Vec<(&str, &str)> = edits.iter().map(|(from, to)| (*from, to.as_str())).collect();
    assert_eq!(messages(&edits), Vec::<String>::new());
}

#[test]
fn a_rate_that_stands_beside_a_quasi_velocity_is_named() {
    let edits = [
        ("[frames]", "[speeds]\nw = \"2*theta'\"\n\n[frames]"),
        ("theta = \"0.3 rad\"", "theta = \"0.3 rad\"\nw = \"2 rad/s\"\n\"theta'\" = \"1.5 rad/s\""),
    ];
    one(
        &edits,
        &["the value of `w` in [start] does not hold", "3 rad/s by `theta'`, which [start] gives too", "one of them"],
    );
}

/// If a constraint determines the only coordinate, a quasi-velocity of the start can have one value only.
#[test]
fn speeds_that_leave_no_motion_are_named() {
    let with = |slope: &str, start: &str, parts: &[&str]| {
        let slides = format!("[[constraint]]\nname = \"slot\"\nzero = \"{slope}\"\n\n[outputs]");
        let edits = [
            ("theta = \"rad\"", "theta = \"rad\"\nx = \"m\"\ny = \"m\""),
            ("centre = \"P\"", "centre = \"P + x*N.x + y*N.y\""),
            ("[frames]", "[speeds]\nv = \"x' + y'\"\nw = \"theta'\"\n\n[frames]"),
            ("[outputs]", &slides),
            ("theta = \"0.3 rad\"", start),
        ];
        one(&edits, parts);
    };
    let across = [
        "the value of `v` in [start] cannot hold in this position",
        "here the constraints and the others determine it",
    ];
    with("x'*cos(theta) + y'*sin(theta)", "theta = \"45 deg\"\nv = \"1 m/s\"", &across);
    let three = [
        "constraint 1 `slot` was not met from this start",
        "adjusted",
        "fewer or other speeds in [start], which gives `x'`, `v`",
    ];
    with("x'*cos(theta) + y'*sin(theta)", "theta = \"0.3 rad\"\n\"x'\" = \"2 m/s\"\nv = \"1 m/s\"", &three);
}

#[test]
fn a_definition_that_is_wrong_is_told_before_its_start() {
    let with = |definition: &str, start: &str, parts: &[&str]| {
        let speeds = format!("[speeds]\nw = \"{definition}\"\n\n[frames]");
        let start = format!("theta = \"0.3 rad\"\nw = \"{start}\"");
        one(&[("[frames]", &speeds), ("theta = \"0.3 rad\"", &start)], parts);
    };
    with("theta'^2", "2 rad/s", &["`w` is not linear in the speeds"]);
    with("theta", "2 rad/s", &["`w` holds no speed"]);
    with("theta''", "2 rad/s", &["`w` holds accelerations"]);
    with("l*theta'", "2 rad/s", &["the start of the quasi-velocity `w` cannot be read", "this has the dimension s^-1"]);
}

#[test]
fn a_name_that_is_taken_is_no_circle() {
    one(
        &[("[frames]", "[speeds]\ntheta = \"theta'\"\n\n[frames]")],
        &["`theta` is defined twice", "it is the name of a coordinate already"],
    );
    one(
        &[("reach = \"l*sin(theta)\"", "reach = \"l*sin(theta)\"\nA = \"2*l\"")],
        &["`A` is defined twice", "it is the name of a definition already"],
    );
}

#[test]
fn those_that_depend_on_each_other_are_all_named() {
    let speeds = |text: &str, parts: &[&str]| one(&[("[frames]", &format!("[speeds]\n{text}\n\n[frames]"))], parts);
    let two = [
        "one degree of freedom, and [speeds] has 2: 1 too many",
        "`v` and `w` depend on each other",
        "without `v` or `w`",
    ];
    speeds("v = \"velocity(P) . A.x\"\nw = \"theta'\"", &two);
    speeds(
        "w = \"theta'\"\nv = \"velocity(P) . A.x\"",
        &["`w` and `v` depend on each other", "without `w` or `v`", ":17:1"],
    );
}
