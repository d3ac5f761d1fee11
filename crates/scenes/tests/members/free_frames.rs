//! Members of ensembles with free frames.

use crate::{ensemble, rows, rows_are_runs, with};

/// A heavy top; the marker FRAMES stands for the definition of its frame.
const TOP: &str = r#"
title = "A heavy top"
gravity = "-g*N.z"
[parameters]
m = "1.5 kg"
l = "0.2 m"
A = "0.03 kg m^2"
C = "0.01 kg m^2"
g = "9.81 m/s^2"
[coordinates]
COORDINATES
[frames]
FRAMES
[bodies.top]
frame = "F"
centre = "O + l*F.z"
mass = "m"
inertia = { principal = ["A", "1.2*A", "C"] }
[outputs]
north = "l*F.z . N.y"
mark = "F.x . N.z"
[start]
START
[run]
span = "1 s"
tolerance = 1e-11
[ensemble]
members = 4
[ensemble.vary]
parameters.l = { from = "0.18 m", to = "0.22 m" }
"#;

fn free_top() -> String {
    let start = "F = \"10 deg about z, then 40 deg about x\"\n\"F.wx\" = \"0.5 rad/s\"\n\"F.wz\" = \"30 rad/s\"";
    TOP.replace("COORDINATES", "").replace("FRAMES", "F = \"N free\"").replace("START", start)
}

fn turned_top() -> String {
    TOP.replace("COORDINATES", "yaw = \"rad\"\ntilt = \"rad\"\nspin = \"rad\"")
        .replace("FRAMES", "Y = \"N turned yaw about z\"\nT = \"Y turned tilt about x\"\nF = \"T turned spin about z\"")
        .replace("START", "yaw = \"10 deg\"\ntilt = \"40 deg\"\n\"spin'\" = \"30 rad/s\"\n\"tilt'\" = \"0.5 rad/s\"")
}

/// Rotations of a free frame and its angular velocity vary: each member equals the run of a file with its values.
#[test]
fn every_member_with_a_free_frame_is_the_run_of_a_file_with_its_numbers() {
    let varied = free_top()
        + "start.F = { from = \"0 0 -20 deg\", to = \"0 0 20 deg\" }\n\
           start.\"F.wx\" = { mean = \"0.5 rad/s\", deviation = \"0.2 rad/s\" }\n";
    rows_are_runs(&varied, 1e-11, |text, drawn| {
        let [l, wx, x, y, z] = drawn else { panic!("five numbers vary: {drawn:?}") };
        assert_eq!((*x, *y), (0.0, 0.0));
        let text = with(text, "l = \"0.2 m\"", &format!("l = \"{l} m\""));
        let text = with(&text, "40 deg about x\"", &format!("40 deg about x, then {z} rad about z\""));
        with(&text, "\"F.wx\" = \"0.5 rad/s\"", &format!("\"F.wx\" = \"{wx} rad/s\""))
    });
}

/// Rotation about the frame's own axis z is the third of the three rotations; at zero spin, rotation about its axis x is the second.
#[test]
fn members_with_a_free_frame_move_as_those_of_three_turns() {
    for (free, turned) in [
        ("\"0 0 0; 0 0 10; 0 0 -35; 0 0 80 deg\"", "start.spin = { values = \"0 10 -35 80 deg\" }\n"),
        ("\"0 0 0; 10 0 0; -25 0 0; 5 0 0 deg\"", "start.tilt = { values = \"40 50 15 45 deg\" }\n"),
    ] {
        // "F.wx" is a component in the frame, whereas tilt' does not rotate with the spin
        let slow = |text: String| {
            text.replace("\"F.wx\" = \"0.5 rad/s\"\n", "")
                .replace("\"tilt'\" = \"0.5 rad/s\"", "\"tilt'\" = \"0 rad/s\"")
        };
        let free = ensemble(&(slow(free_top()) + &format!("start.F = {{ values = {free} }}\n")));
        let turned = ensemble(&(slow(turned_top()) + turned));
        let mut compared = 0;
        for (one, other) in rows(&free, 1).into_iter().zip(rows(&turned, 1)) {
            assert_eq!(one.drawn[0], other.drawn[0], "the lengths are of one name");
            let [one, other] = [one, other].map(|row| row.last.clone().unwrap_or_else(|| panic!("{row:?}")).derived);
            for (one, other) in one.iter().zip(&other).take(4) {
                let (one, other) = (one.expect("a number"), other.expect("a number"));
                assert!((one - other).abs() < 1e-8 * (1.0 + one.abs()), "{one} {other}");
                compared += 1;
            }
        }
        assert_eq!(compared, 16);
    }
}

/// A guess of the orientation is completed for every member, so that the pin holds.
#[test]
fn the_orientation_of_a_free_frame_is_completed_for_every_member() {
    let plate = r#"
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
[start]
F = "guess 5 deg about x, then 20 deg about y"
x = "-0.25 m"
"F.wz" = "0.4 rad/s"
[run]
span = "0.5 s"
[ensemble]
members = 5
[ensemble.vary]
parameters.a = { from = "0.27 m", to = "0.35 m" }
"#;
    rows_are_runs(plate, 1e-10, |text, drawn| with(text, "a = \"0.3 m\"", &format!("a = \"{} m\"", drawn[0])));
}
