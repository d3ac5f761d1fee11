//! Messages about faulty files: one for each cause, at its place, with the accepted values.

mod expressions;
mod speeds;
mod starts;
mod tables;
mod warnings;

// registers the motors of the catalogue
use dalembert_scenes::ModelScene;
use machines as _;
use studies as _;

const SOUND: &str = r#"title = "A pendulum"
gravity = "-g*N.y"

[parameters]
m = "2 kg"
l = "0.5 m"
g = "9.81 m/s^2"

[coordinates]
theta = "rad"

[definitions]
reach = "l*sin(theta)"

[frames]
A = "N turned theta about z"

[points]
P = "O - l*A.y"

[bodies.bob]
centre = "P"
mass = "m"

[[force]]
on = "bob"
is = "(0.1 N)*N.x"

[outputs]
width = "reach"

[start]
theta = "0.3 rad"

[run]
span = "1 s"
"#;

/// The messages about the sound text after some replacements.
fn messages(edits: &[(&str, &str)]) -> Vec<String> {
    let text = edits.iter().fold(SOUND.to_owned(), |text, (from, to)| {
        assert_eq!(text.matches(from).count(), 1, "`{from}` must stand once");
        text.replace(from, to)
    });
    match ModelScene::parse("scene.toml", &text) {
        Ok(_) => Vec::new(),
        Err(error) => {
            assert!(error.issues.iter().all(|issue| issue.help.is_some()), "{error}");
            error.to_string().split("\n\n").map(str::to_owned).collect()
        }
    }
}

/// Requires exactly one message, with all of the parts.
fn one(edits: &[(&str, &str)], parts: &[&str]) {
    let found = messages(edits);
    assert_eq!(found.len(), 1, "{found:#?}");
    for part in parts {
        assert!(found[0].contains(part), "{part}\n{}", found[0]);
    }
}

#[test]
fn the_sound_text_is_accepted() {
    assert_eq!(messages(&[]), Vec::<String>::new());
}

#[test]
fn one_cause_has_one_message_however_much_depends_on_it() {
    one(&[("A = \"N turned theta about z\"", "A = \"N turned thetta about z\"")], &["thetta"]);
    one(&[("reach = \"l*sin(theta)\"", "reach = \"l*sin(thet)\"")], &["thet"]);
    one(&[("theta = \"rad\"", "theta = \"radd\"")], &["a coordinate has a unit", "radd"]);
}
