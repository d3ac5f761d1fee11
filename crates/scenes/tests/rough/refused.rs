//! Contacts that cannot be, each with one message at its place.

use super::stored;
use scenes::ModelScene;

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
        said(&[("friction = \"f\"", "friction = \"m\"")]).contains("the coefficient of friction has the dimension")
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
fn friction_in_space_is_not_there_yet() {
    let spatial = "title = \"ball\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"1 kg\"\ng = \"9.81 m/s^2\"\n\
                   [coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y + z*N.z\"\n\
                   [bodies.ball]\ncentre = \"P\"\nmass = \"m\"\n\
                   [[contact]]\nof = \"ball\"\nthrough = \"O\"\nnormal = \"N.z\"\nfriction = \"0.3\"\nrestitution = \"0.5\"\n\
                   [start]\nz = \"1 m\"\n\"x'\" = \"1 m/s\"\n[run]\nspan = \"0.6 s\"\n";
    let said = ModelScene::parse("scene.toml", spatial).expect_err("it is spatial").to_string();
    assert!(said.contains("friction in space is not there yet"), "{said}");
    let smooth = spatial.replace("friction = \"0.3\"\n", "");
    let trajectory = super::runs(&smooth, integrators::Method::DormandPrince8, 1e-12);
    assert_eq!(trajectory.stopped(), None);
    let landed = (2.0_f64 / 9.81).sqrt();
    super::close(super::events(&trajectory)[0], landed, 1e-12);
    super::close(super::last(&trajectory, "z'"), 0.5 * 9.81 * landed - 9.81 * (0.6 - landed), 1e-11);
    super::close(super::last(&trajectory, "x'"), 1.0, 1e-14);
}

#[test]
fn a_start_in_which_a_contact_penetrates_or_closes_is_refused() {
    let start = "alpha = \"17 deg\"\n\"alpha'\" = \"-0.7 rad/s\"";
    let alone = |start_there: &str| {
        let free = stored("models/leaning_ladder").replace("touching = true\n", "").replacen(start, start_there, 1);
        ModelScene::parse("scene.toml", &free).map_or_else(|error| error.to_string(), |_| String::new())
    };
    assert!(alone("x = \"1 m\"\ny = \"1 m\"").contains("a contact penetrates at the start"));
    assert!(alone("x = \"1 m\"\ny = \"2 m\"\n\"y'\" = \"-1 m/s\"").contains("closes with a velocity at the start"));
    assert_eq!(alone("x = \"1 m\"\ny = \"3 m\"\n\"y'\" = \"-1 m/s\""), "");
}
