//! Systems described in a file, at the command line.

mod equations;
mod laws_with_conditions;
mod linear_equations;
mod proofs;
mod quasi_velocities;
mod refusals;
mod runs;
mod steady_motions;

use crate::run;

const MODEL: &str = "scenes/models/double_pendulum.toml";

fn printed(arguments: &[&str]) -> String {
    let output = run(arguments);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {message}");
    String::from_utf8(output.stdout).expect("it is text")
}

fn refused(arguments: &[&str], why: &str) {
    let output = run(arguments);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
    assert!(message.contains(why), "{arguments:?}: {message}");
}

const PENDULUM: &str = "title = \"A pendulum\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[coordinates]\ntheta = \"rad\"\n\
    [frames]\nA = \"N turned theta about z\"\n[bodies.bob]\ncentre = \"O - (1 m)*A.y\"\nmass = \"(1 kg)\"\n\
    [[event]]\nname = \"low\"\nwhen = \"theta - (32 rad)\"\nend = true\n\
    [start]\ntheta = 30\n[run]\nspan = \"9 s\"\n";

/// A block pulled by a drive of limited force, with dry friction, a damping called `c1` and a coordinate called `f1`.
const BLOCK: &str = "title = \"A block\"\n[parameters]\nm = \"2 kg\"\nc1 = \"3 N s/m\"\nF = \"4 N\"\n[coordinates]\nf1 = \"m\"\ny = \"m\"\n\
    [bodies.b]\ncentre = \"O + f1*N.x + y*N.y\"\nmass = \"m\"\n[[force]]\non = \"b\"\nis = \"(-c1*f1' - F*sign(f1'))*N.x\"\n\
    [[force]]\non = \"b\"\nis = \"min(F, F*sin(t*(2 rad/s)) + F*cos(t*(3 rad/s))*sin(t*(5 rad/s)))*N.x\"\n\
    [[constraint]]\nname = \"rail\"\nzero = \"y*N.y\"\n\
    [[event]]\nname = \"wall\"\nwhen = \"f1 - (1 m)\"\ndirection = \"up\"\nset = { \"f1'\" = \"-0.5*f1'\" }\nend = true\n\
    [start]\n\"f1'\" = \"1 m/s\"\n[run]\nspan = \"1 s\"\n";

/// A mass on a spring with a force as input: every entry of its linear equations is known.
const SPRING: &str = "title = \"A mass on a spring\"\n[parameters]\nm = \"2 kg\"\nk = \"18 N/m\"\nF = \"N\"\n[coordinates]\nx = \"mm\"\n\
    [points]\nP = \"O + x*N.x\"\n[bodies.bob]\ncentre = \"P\"\nmass = \"m\"\n[[force]]\non = \"bob\"\nis = \"(F - k*x)*N.x\"\n\
    [outputs]\npull = \"k*x\"\n[run]\nspan = \"1 s\"\n";
