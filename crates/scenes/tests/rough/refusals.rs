//! Impossible contacts, with one message each at its place.

use super::stored;
use dalembert_scenes::ModelScene;

fn said(edits: &[(&str, &str)]) -> String {
    let text = edits.iter().fold(stored("models/leaning_ladder"), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    });
    ModelScene::parse("scene.toml", &text).map_or_else(|error| error.to_string(), |_| panic!("it is read: {edits:?}"))
}

#[test]
fn a_contact_that_is_incomplete_is_refused_with_an_example() {
    let normal = "normal = \"N.x\"\n";
    assert!(said(&[(normal, "")]).contains("a contact has a normal"));
    assert!(said(&[("through = \"O\"\n", "")]).contains("a contact has a point of the plane, or a gap"));
    assert!(said(&[("of = \"ladder at A\"\n", "")]).contains("a contact has one of `of` and `between`"));
    assert!(
        said(&[("of = \"ladder at A\"", "of = \"ground at O\"")]).contains("a contact is one of a point that moves")
    );
    assert!(said(&[(normal, "normal = \"N.x\"\nsides = \"two\"\n")]).contains("on one side or on both"));
    assert!(said(&[("name = \"floor\"", "name = \"wall\"")]).contains("the name of another contact"));
    assert!(
        said(&[("friction = \"f\"", "friction = \"m\"")])
            .contains("the coefficient of friction must have the dimension")
    );
    assert!(said(&[("reaction(wall)", "reaction(wal)")]).contains("is `wall` meant?"));
    assert!(said(&[("friction(floor)", "friction(flor)")]).contains("no contact is called `flor`"));
    let guide = "between = \"ladder, N along z\"\n";
    assert!(
        said(&[("of = \"ladder at A\"\nthrough = \"O\"\nnormal = \"N.x\"\n", guide)])
            .contains("a guide is read differently")
    );
}

#[test]
fn a_smooth_contact_in_space_takes_the_bounce_alone() {
    let smooth = "title = \"ball\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"1 kg\"\ng = \"9.81 m/s^2\"\n\
                   [coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y + z*N.z\"\n\
                   [bodies.ball]\ncentre = \"P\"\nmass = \"m\"\n\
                   [[contact]]\nof = \"ball\"\nthrough = \"O\"\nnormal = \"N.z\"\nrestitution = \"0.5\"\n\
                   [start]\nz = \"1 m\"\n\"x'\" = \"1 m/s\"\n[run]\nspan = \"0.6 s\"\n";
    let trajectory = super::runs(smooth, integrators::Method::DormandPrince8, 1e-12);
    assert_eq!(trajectory.stopped(), None);
    let landed = (2.0_f64 / 9.81).sqrt();
    super::close(super::events(&trajectory)[0], landed, 1e-12);
    super::close(super::last(&trajectory, "z'"), 0.5 * 9.81 * landed - 9.81 * (0.6 - landed), 1e-11);
    super::close(super::last(&trajectory, "x'"), 1.0, 1e-14);
}

/// The reaction of a line in space has two components, and Coulomb's law limits their resultant.
#[test]
fn a_rough_guide_along_a_line_in_space_is_refused() {
    let guide = |gravity: &str, friction: &str| {
        format!(
            "title = \"bead\"\ngravity = \"-(9.81 m/s^2)*{gravity}\"\n[coordinates]\ns = \"m\"\n[points]\nP = \"O + s*N.x\"\n\
             [bodies.bead]\ncentre = \"P\"\nmass = \"(1 kg)\"\n[[contact]]\nbetween = \"bead, N along x\"\n{friction}\n\
             [start]\n\"s'\" = \"1 m/s\"\n[run]\nspan = \"0.1 s\"\n"
        )
    };
    let said =
        |text: &str| ModelScene::parse("scene.toml", text).map_or_else(|error| error.to_string(), |_| String::new());
    let rough = "friction = \"0.2\"";
    assert!(said(&guide("N.z", rough)).contains("guides along a line in space are not supported yet"));
    assert_eq!(said(&guide("N.y", rough)), "");
    assert_eq!(said(&guide("N.z", "")), "");
}

#[test]
fn a_start_in_which_a_contact_penetrates_or_closes_is_refused() {
    let start = "alpha = \"17 deg\"\n\"alpha'\" = \"-0.7 rad/s\"";
    let alone = |start_there: &str| {
        let free = stored("models/leaning_ladder").replace("touching = true\n", "").replacen(start, start_there, 1);
        ModelScene::parse("scene.toml", &free).map_or_else(|error| error.to_string(), |_| String::new())
    };
    assert!(alone("x = \"1 m\"\ny = \"1 m\"").contains("a contact penetrates where a motion should begin"));
    assert!(
        alone("x = \"1 m\"\ny = \"2 m\"\n\"y'\" = \"-1 m/s\"")
            .contains("closes with a velocity where a motion should begin")
    );
    assert_eq!(alone("x = \"1 m\"\ny = \"3 m\"\n\"y'\" = \"-1 m/s\""), "");
}

#[test]
fn a_contact_that_means_nothing_is_refused_at_its_place() {
    let normal = "normal = \"N.x\"\n";
    for (edits, message) in [
        ([(normal, "normal = \"0*N.x\"\n"); 1], "the normal of a contact has a direction"),
        ([("through = \"O\"\n", "gap = \"x^2/l\"\n")], "the gap of contact `wall` does not grow along its normal"),
        ([("through = \"O\"\n", "gap = \"x + x'*(1 s)\"\n")], "the gap of a contact is a length by positions"),
        ([("through = \"O\"\n", "through = \"G\"\n")], "moves with the coordinates, and no body has it"),
        ([("through = \"O\"\n", "through = \"O\"\nwith = \"ladder\"\n")], "this one touches itself"),
        (
            [(normal, "normal = \"N.x\"\nrestitution = \"1\"\nimpact = \"hunt\"\n")],
            "the law of restitution is Newton's, Poisson's or Moreau's",
        ),
        (
            [(normal, "normal = \"N.x\"\nsides = \"both\"\nrestitution = \"1\"\n")],
            "a contact that holds on both sides has no impacts",
        ),
        ([("f = \"0.3\"", "f = \"-0.3\"")], "a coefficient of friction is negative"),
        (
            [(normal, "normal = \"N.x\"\nrestitution = \"1.1\"\n")],
            "a coefficient of restitution is not between 0 and 1",
        ),
    ] {
        let said = said(&edits);
        assert!(said.contains(message), "{message}: {said}");
    }
    let wall = "through = \"O\"\nnormal = \"N.x\"\n";
    assert!(said(&[(wall, "gap = \"-x\"\nnormal = \"N.x\"\n")]).contains("its gap"));
    let held = said(&[("x = \"m\"\n", ""), ("\"O + x*N.x + y*N.y\"", "\"O + y*N.y\""), ("at A", "at G")]);
    assert!(held.contains("no motion changes the gap of contact `wall`"), "{held}");
}

#[test]
fn contacts_that_no_position_meets_together_are_named() {
    let second = "\n[[contact]]\nname = \"ceiling\"\nof = \"ladder at B\"\nthrough = \"O + l*N.y\"\nnormal = \"N.y\"\ntouching = true\n\n[outputs]";
    let said = said(&[("\n[outputs]", second)]);
    assert!(said.contains("contact `ceiling` contradicts contact `floor`"), "{said}");
}

/// mu(t) = 0.3 - t/(1 s).
#[test]
fn friction_that_would_become_negative_ends_the_run() {
    let trajectory = super::runs(
        &stored("models/leaning_ladder").replace("friction = \"f\"", "friction = \"f - t/(1 s)\""),
        integrators::Method::DormandPrince8,
        1e-10,
    );
    assert!(trajectory.stopped().is_some());
    super::close(trajectory.outcome.time, 0.3, 1e-12);
}
