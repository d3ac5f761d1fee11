//! Reactions where they have no meaning.

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
