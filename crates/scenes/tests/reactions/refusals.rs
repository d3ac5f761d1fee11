//! Refusals of reactions in places where they are undefined or not supported.

use super::bead;
use dalembert_scenes::ModelScene;

fn refused(text: &str, parts: &[&str]) {
    let error = ModelScene::parse("scene.toml", text).expect_err("it is refused").to_string();
    for part in parts {
        assert!(error.contains(part), "{part}: {error}");
    }
}

#[test]
fn reactions_stand_where_the_motion_does_not_follow_from_them() {
    let plain = bead("", "-c*velocity(P)*(1 N)", "");
    refused(
        &plain.replace("zero = \"y - a*x^2\"", "zero = \"y - a*x^2 + (1 m/N)*reaction(wire)\""),
        &["a constraint holds a reaction"],
    );
    let second =
        plain.replace("[[force]]", "[[constraint]]\nname = \"stop\"\nzero = \"x - (1 m/N)*reaction(wire)\"\n[[force]]");
    refused(&second, &["a constraint holds a reaction", "`when` of [[event]]"]);
    refused(&plain.replace("mass = \"m\"", "mass = \"m + (1 kg/N)*reaction(wire)\""), &["a mass holds a reaction"]);
    refused(&plain.replace("(1 N)", "reaction(wires)"), &["no constraint is called `wires`", "is `wire` meant?"]);
    refused(&plain.replace("(1 N)", "rate(reaction(wire))*(1 s)"), &["holds accelerations"]);
    refused(&plain.replace("(1 N)", "reaction(wire, 2)"), &["`wire` holds 1 equation"]);
}

#[test]
fn the_reaction_of_a_contact_stands_in_outputs_alone() {
    let floor =
        "[[contact]]\nname = \"floor\"\nof = \"bead\"\nthrough = \"O\"\nnormal = \"N.y\"\nsides = \"one\"\n[start]";
    let text = bead("", "-c*velocity(P)*reaction(floor)", "").replace("[start]", floor);
    refused(&text, &["the reaction of the contact `floor` stands in [outputs] only"]);
    let beside = bead("", "-c*velocity(P)*reaction(wire)", "").replace("[start]", floor);
    refused(&beside, &["are not supported together with the contact `floor` yet"]);
}

/// The reactions of two equivalent constraints are not determined.
#[test]
fn a_load_by_the_reaction_of_a_redundant_constraint_names_that_constraint() {
    refused(
        "title = \"a gear whose constraint stands twice\"\n[parameters]\nJ1 = \"0.01 kg m^2\"\nJ2 = \"0.5 kg m^2\"\nn = \"5\"\n[coordinates]\na = \"rad\"\n\
         b = \"rad\"\n[bodies]\nmotor = { turns = \"a\", inertia = \"J1\" }\nload = { turns = \"b\", inertia = \"J2\" }\n[[constraint]]\nname = \"gear\"\n\
         zero = \"a - n*b\"\n[[constraint]]\nname = \"again\"\nzero = \"2*a - 2*n*b\"\n[[torque]]\nbetween = [\"ground\", \"load\"]\nis = \"-(0.1*abs(reaction(gear)))*sign(b')*N.z\"\n\
         [start]\n\"b'\" = \"1 rad/s\"\n[run]\nspan = \"1 s\"\n",
        &["its law contains reactions, and", "`again` follows from other constraints", "are not determined"],
    );
}

#[test]
fn a_parameter_of_zero_below_a_fraction_is_named() {
    refused(
        "title = \"a capacitor of no capacitance\"\n[parameters]\nR = \"1 kohm\"\nC = \"0 F\"\n[coordinates]\nq = \"C\"\n[energies]\n\
         potential = \"q^2/(2*C)\"\ndissipation = \"R/2*q'^2\"\n[run]\nspan = \"5 ms\"\n",
        &["an expression divides by `2*C`, which is zero", "`C` is 0 F"],
    );
    refused(
        "title = \"a force over a length of zero\"\n[parameters]\nl = \"0 m\"\n[coordinates]\nx = \"m\"\n[bodies.b]\ncentre = \"O + x*N.x\"\nmass = \"(1 kg)\"\n\
         [[force]]\non = \"b\"\nis = \"-(2 N m)/l*N.x\"\n[run]\nspan = \"1 s\"\n",
        &["an expression divides by `l`, which is zero", "`l` is 0 m"],
    );
}
