//! A file whose system is wrong gets one message for each cause, at its place, with what would be accepted.

use scenes::ModelScene;

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

/// The messages of the sound text with each of some parts replaced.
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

/// One message, which has all of these parts.
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
fn unknown_letters_are_named_with_what_was_probably_meant() {
    one(&[("\"-g*N.y\"", "\"-gg*N.y\"")], &["`gg`", "^^", "is `g` meant?"]);
    one(&[("on = \"bob\"", "on = \"bobb\"")], &["`bobb`"]);
    one(&[("\"l*sin(theta)\"", "\"l*sinn(theta)\"")], &["no function is called `sinn`", "is `sin` meant?"]);
    one(&[("\"l*sin(theta)\"", "\"l*angular_acceleration(A)\"")], &["`angular_acceleration` is not there yet"]);
}

#[test]
fn one_cause_has_one_message_however_much_depends_on_it() {
    one(&[("A = \"N turned theta about z\"", "A = \"N turned thetta about z\"")], &["thetta"]);
    one(&[("reach = \"l*sin(theta)\"", "reach = \"l*sin(thet)\"")], &["thet"]);
    one(&[("theta = \"rad\"", "theta = \"radd\"")], &["a coordinate has a unit", "radd"]);
}

#[test]
fn dimensions_are_checked_where_they_meet() {
    one(&[("\"l*sin(theta)\"", "\"l + m\"")], &["different dimensions", "m and kg"]);
    one(&[("\"l*sin(theta)\"", "\"l*sin(l)\"")], &["an angle has the dimension 1", "this has the dimension m"]);
    one(&[("\"(0.1 N)*N.x\"", "\"(0.1 kg)*N.x\"")], &["the force on a point has the dimension kg m s^-2"]);
    one(&[("mass = \"m\"", "mass = \"l\"")], &["the mass has the dimension kg"]);
    one(&[("theta = \"0.3 rad\"", "theta = \"0.3 m\"")], &["the start of `theta`", "this has the dimension m"]);
}

#[test]
fn kinds_are_checked_where_they_meet() {
    one(&[("\"-g*N.y\"", "\"-g\"")], &["is a vector", "this is a scalar"]);
    one(&[("\"(0.1 N)*N.x\"", "\"(0.1 N)*N.x*N.y\"")], &["two vectors are multiplied by *", "a . b"]);
    one(&[("centre = \"P\"", "centre = \"l*N.x\"")], &["this is a point", "this is a vector"]);
    one(&[("\"reach\"", "\"P\"")], &["the output `width` is a scalar", "this is a point"]);
}

#[test]
fn conditions_events_and_inputs_are_checked_where_they_stand() {
    let reach = |text: &str| [("\"l*sin(theta)\"", format!("\"{text}\""))];
    let told = |text: &str, parts: &[&str]| {
        let [(from, to)] = reach(text);
        one(&[(from, &to)], parts);
    };
    told("if(theta > 0, l)", &["`if` has 3 arguments", "2 stand here"]);
    told("if(theta, l, 2*l)", &["`if` begins with a condition"]);
    told("l*cos(theta > 0)", &["`cos` has no such argument"]);
    told("if(theta > l, l, 2*l)", &["different dimensions", "1 and m"]);
    told("if(theta > 0, l, m)", &["different dimensions", "m and kg"]);
    told("l*exp(l)", &["the argument of `exp` has the dimension 1"]);
    told("l*atan2(l, m)", &["different dimensions"]);
    told("l*table(theta, 0, 1, 0, 2)", &["the places of a table ascend"]);
    told("l*table(theta, 0, 1, 2)", &["a table has pairs of numbers"]);
    let event = |keys: &str| format!("[[event]]\n{keys}\n\n[outputs]");
    let of = |keys: &str, parts: &[&str]| one(&[("[outputs]", &event(keys))], parts);
    of("when = \"theta\"", &["this event changes nothing"]);
    of("when = \"theta\"\ndirection = \"left\"\nend = true", &["no direction"]);
    of("when = \"theta\"\nset = { \"theta''\" = \"0\" }", &["no coordinate is called `theta''`"]);
    of("when = \"theta\"\nset = { \"theta'\" = \"l\" }", &["has the dimension s^-1"]);
    of("when = \"theta\"\nend = \"yes\"", &["`end` has the wrong type", "true or false"]);
    let input = |keys: &str, parts: &[&str]| one(&[("[outputs]", &format!("[inputs]\n{keys}\n\n[outputs]"))], parts);
    input("u = \"N\"", &["the input `u` has no value"]);
    input("u = { unit = \"N\", value = \"l\" }", &["the input `u` has the dimension kg m s^-2"]);
    input("u = { value = \"l\" }", &["`unit` is missing"]);
    let led = "[[constraint]]\nzero = \"theta - 0.4\"\nprogrammed = { gains = [\"(1 1/s)\"] }\n\n[outputs]";
    one(&[("[outputs]", led)], &["a programmed constraint of positions has two gains"]);
}

#[test]
fn a_free_frame_starts_by_turns() {
    let free = |start: &str, parts: &[&str]| {
        let start = format!("theta = \"0.3 rad\"\n{start}");
        one(&[("[points]", "B = \"N free\"\n[points]"), ("theta = \"0.3 rad\"", &start)], parts);
    };
    free("B = \"30 deg\"", &["the start of `B` is a turn", "this is none"]);
    free("B = \"30 deg about w\"", &["about another axis"]);
    free("B = \"3 m about x\"", &["this has the dimension m"]);
    free("\"B.wq\" = \"3 rad/s\"", &["no coordinate is called `B.wq`", "is `B.wz` meant?"]);
    free("\"B.wx\" = \"3 rad\"", &["the start of `B.wx`", "this has the dimension 1"]);
}

#[test]
fn a_circle_of_definitions_is_told_once() {
    let circle = [("reach = \"l*sin(theta)\"", "reach = \"2*other\"\nother = \"reach/2\"")];
    one(&circle, &["`reach` is defined by itself", "reach needs other needs reach"]);
    one(&[("P = \"O - l*A.y\"", "P = \"P - l*A.y\"")], &["`P` is defined by itself"]);
}

#[test]
fn bodies_that_cannot_exist_are_refused() {
    one(&[("m = \"2 kg\"", "m = \"-2 kg\"")], &["the mass of `bob` must be positive", "it is -2 kg"]);
    one(&[("centre = \"P\"\n", "")], &["`bob` has a mass and no centre"]);
    one(&[("centre = \"P\"\nmass = \"m\"\n", "centre = \"P\"\n")], &["`bob` has no mass and no inertia"]);
    let solid = "frame = \"A\"\ninertia = { principal = [\"1 kg m^2\", \"1 kg m^2\", \"3 kg m^2\"] }\nmass = \"m\"";
    one(
        &[("mass = \"m\"", &solid.replace("1 kg m^2", "(1 kg m^2)").replace("\"3 kg m^2\"", "\"(3 kg m^2)\""))],
        &["no body has the moments of inertia of `bob`"],
    );
}

#[test]
fn what_cannot_run_says_why() {
    one(&[("m = \"2 kg\"", "m = \"kg\"")], &["the parameter `m` has no value"]);
    one(
        &[("theta = \"rad\"", "theta = \"rad\"\nidle = \"m\"")],
        &["nothing with a mass or an inertia moves with `idle`"],
    );
    let twice = "[[constraint]]\nzero = \"theta - 0.3\"\n\n[[constraint]]\nzero = \"2*theta - 0.6\"\n\n[outputs]";
    one(&[("[outputs]", twice)], &["follows from those before it"]);
    one(
        &[("[outputs]", "[[constraint]]\nzero = \"theta - 0.4\"\n\n[outputs]")],
        &["does not hold at the start", "-1.000000e-1"],
    );
}

#[test]
fn what_the_language_will_have_is_refused_by_name() {
    one(&[("[outputs]", "[[contact]]\nof = \"bob at P\"\n\n[outputs]")], &["contacts with friction are not there yet"]);
}

#[test]
fn numbers_that_fill_the_memory_are_refused() {
    one(&[("\"l*sin(theta)\"", "\"l*((((2^64)^64)^64)^64)^64\"")], &["more digits than anything needs"]);
    one(&[("\"l*sin(theta)\"", &format!("\"{}l\"", "(".repeat(101)))], &["parentheses deeper than 100"]);
}
