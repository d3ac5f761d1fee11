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
    one(
        &[("[outputs]", "[[constraint]]\nzero = \"theta - 0.4\"\n\n[outputs]")],
        &["does not hold at the start", "-1.000000e-1"],
    );
}

#[test]
fn a_place_of_the_ground_takes_forces_and_the_ground_itself_none() {
    let force = |keys: &str| format!("[[force]]\n{keys}\n\n[outputs]");
    let spring = force("between = [\"ground at O + (1 m)*N.x\", \"bob\"]\nis = \"(3 N)\"");
    assert_eq!(messages(&[("[outputs]", &spring)]), Vec::<String>::new());
    let of = |keys: &str, parts: &[&str]| one(&[("[outputs]", &force(keys))], parts);
    of("between = [\"ground\", \"bob\"]\nis = \"(3 N)\"", &["the ground is everywhere", "\"ground at O\""]);
    of("on = \"ground at O\"\nis = \"(3 N)*N.x\"", &["a force on the ground moves nothing"]);
    of("between = [\"P\", \"bob\"]\nis = \"(3 N)\"", &["a force acts between two points, and these are one"]);
    of("on = \"bob\"", &["`is` is missing"]);
    let torque = |keys: &str, parts: &[&str]| one(&[("[outputs]", &format!("[[torque]]\n{keys}\n\n[outputs]"))], parts);
    torque("on = \"bob at P\"\nis = \"(3 N m)*N.z\"", &["a torque acts on a body as a whole", "\"bob\""]);
    torque("on = \"ground\"\nis = \"(3 N m)*N.z\"", &["a torque on the ground moves nothing"]);
    torque("between = [\"A\", \"A\"]\nis = \"(3 N m)*N.z\"", &["these turn together"]);
    torque("on = \"A\"\nis = \"(3 N m)\"", &["a torque is a vector", "about the axis of a planar system a*N.z"]);
    one(&[("[[force]]", "[force]")], &["`force` has the wrong type", "[[force]] in double brackets"]);
}

#[test]
fn a_heading_that_is_missing_is_told_once() {
    one(&[("[bodies.bob]\n", "")], &["`mass` stands under [points]", "`mass` is a key of [bodies.NAME]"]);
    one(&[("[[force]]\n", "")], &["`on` stands under [bodies.bob]", "[[force]] or [[torque]]"]);
    one(&[("[run]\n", "")], &["`span` stands under [start]", "a key of [run]"]);
    one(&[("[bodies.bob]", "[bodies]")], &["`centre` stands under [bodies]", "each body has a name of its own"]);
    one(&[("[bodies.bob]", "[body.bob]")], &["unknown key `body`", "is `bodies` meant?"]);
    let between = "[outputs]\nbetween = [\"O\", \"bob\"]\nis = \"(1 N)\"";
    one(&[("[outputs]", between)], &["`between` stands under [outputs]"]);
}

#[test]
fn what_stands_in_the_wrong_table_is_sent_to_its_own() {
    let parameter = |text: &str| format!("g = \"9.81 m/s^2\"\nI = \"{text}\"");
    one(&[("g = \"9.81 m/s^2\"", &parameter("m*l^2/3"))], &["an expression stands under [definitions]"]);
    one(&[("g = \"9.81 m/s^2\"", &parameter("N turned theta about z"))], &["a frame stands under [frames]"]);
    one(&[("theta = \"rad\"", "theta = \"0.3 rad\"")], &["the value at time zero stands under [start]"]);
    one(&[("theta = \"rad\"", "thetta = \"rad\"")], &["`theta`", "is `thetta` meant?"]);
}

#[test]
fn slips_of_the_pen_in_expressions_are_told_with_the_way_out() {
    let told = |text: &str, parts: &[&str]| one(&[("\"l*sin(theta)\"", &format!("\"{text}\""))], parts);
    told("P . N.y", &["a point is no vector", "`(P - O) . N.y`"]);
    told("2l*theta", &["`2*l` is a product", "`(2 l)` a number with a unit"]);
    told("l*sin(30 deg)", &["`(30 deg)` a number with a unit, in parentheses of its own"]);
    told("l*sin theta", &["functions too: sin(a)"]);
    told("l**2", &["powers are written with ^"]);
    told("theta = 1", &["an expression has no equals sign"]);
    told("if(theta > 0 and theta < 1, l, 0)", &["two are nested: if("]);
    told("l*A", &["a scalar and a frame cannot be multiplied", "A.x, A.y, A.z"]);
    told("P + P", &["a point and a point cannot be added", "point + vector"]);
    told("velocity(bob)/velocity(bob)", &["cannot be divided", "scalar/scalar, vector/scalar"]);
    told("theta^(1/3)", &["no multiple of 1/2 is not there yet", "exp(ln(x)/3)"]);
    one(&[("\"reach\"", "\"velocity(bob)\"")], &["the output `width` is a scalar", "v . N.x, or norm(v)"]);
    one(&[("theta = \"0.3 rad\"", "theta' = \"0.3 rad/s\"")], &["a key with a prime stands in quotes: \"theta'\""]);
    let event = "[[event]]\nwhen = \"theta < 1\"\nend = true\n\n[outputs]";
    one(&[("[outputs]", event)], &["an expression passes zero", "when = \"theta - 1\", with direction"]);
    one(&[("[outputs]", "[[constraint]]\nzero = \"theta > 0\"\n\n[outputs]")], &["a constraint is an equation"]);
    let set = "[[event]]\nwhen = \"theta\"\nset = \"theta' = 0\"\n\n[outputs]";
    one(&[("[outputs]", set)], &["`set` gives coordinates and speeds their values", "set = { \"x'\""]);
}

#[test]
fn reactions_and_conditions_are_refused_where_they_cannot_be() {
    let rod = |rest: &str| format!("[[constraint]]\nname = \"rod\"\nzero = \"theta - 0.3\"\n\n{rest}");
    let output = |text: &str| rod(&format!("[outputs]\nload = \"{text}\""));
    let told = |text: &str, parts: &[&str]| one(&[("[outputs]", &output(text))], parts);
    told("reaction(pod)", &["no constraint is called `pod`", "is `rod` meant?"]);
    told("abs(reaction(rod))", &["depends on accelerations or reactions is not there yet", "sqrt(r^2)"]);
    told("joint_force(bob)", &["the output `load` is a scalar", "this is a vector"]);
    told("joint_force(P) . N.x", &["a body has a joint"]);
    let force = rod("[[force]]\non = \"bob\"\nis = \"reaction(rod)*N.x/l\"\n\n[outputs]");
    one(&[("[outputs]", &force)], &["`reaction` stands in [outputs] only"]);
    let event = "[[event]]\nwhen = \"theta'' - (1 rad/s^2)\"\nend = true\n\n[outputs]";
    one(&[("[outputs]", event)], &["depends on accelerations or reactions is not there yet", "^^^"]);
    let piecewise = "[[constraint]]\nzero = \"if(t < (1 s), theta - 0.3, theta)\"\n\n[outputs]";
    one(&[("[outputs]", piecewise)], &["a constraint that changes at a condition is not there yet"]);
}

#[test]
fn a_start_without_a_motion_names_what_stops_it() {
    one(&[("[run]\nspan = \"1 s\"\n", "")], &["the table [run] is missing", "the file ends here"]);
    one(&[("m = \"2 kg\"", "m = \"kg\"")], &["the parameter `m` has no value", ":5:1"]);
    let high = "[[constraint]]\nname = \"high\"\nzero = \"(P - O) . N.y - 2*l\"\n\n[outputs]";
    let guessed = [("[outputs]", high), ("theta = \"0.3 rad\"", "theta = \"guess 0.3 rad\"")];
    one(
        &guessed,
        &["the constraint `high` was not met from this start", "moving `theta` left", "theta = \"guess ...\""],
    );
    let same = "[[constraint]]\nzero = \"l - l\"\n\n[outputs]";
    one(&[("[outputs]", same)], &["this constraint holds no coordinate and no speed"]);
    let pole = [
        ("theta = \"rad\"", "phi = \"rad\"\ntheta = \"rad\""),
        ("N turned theta about z", "B turned theta about x\"\nB = \"N turned phi about y"),
        ("theta = \"0.3 rad\"", "theta = \"0 rad\""),
    ];
    one(&pole, &["the acceleration of `phi` is not determined at the start", "no azimuth at the pole"]);
    one(&[("\"(0.1 N)*N.x\"", "\"(0.1 N)*ln(theta - 1)*N.x\"")], &["the forces on `theta` have no value at the start"]);
    one(&[("\"(0.1 N)*N.x\"", "\"(100 N)*sign(theta')*N.x\"")], &["this is at zero at the start"]);
}

#[test]
fn what_the_language_will_have_is_refused_by_name() {
    one(&[("[outputs]", "[[contact]]\nof = \"bob at P\"\n\n[outputs]")], &["contacts with friction are not there yet"]);
}

#[test]
fn numbers_that_fill_the_memory_are_refused() {
    one(&[("\"l*sin(theta)\"", "\"l*((((2^64)^64)^64)^64)^64\"")], &["this number is too large"]);
    one(&[("\"l*sin(theta)\"", "\"l*(1e-9)^40\"")], &["this number is too small"]);
    one(
        &[("\"l*sin(theta)\"", "\"l*((g/(1.234567891 m/s^2))^40)^10\"")],
        &["more digits than a run can hold", "a parameter of its own"],
    );
    one(&[("\"l*sin(theta)\"", "\"l*1/(2 - 2)\"")], &[]);
    one(&[("\"l*sin(theta)\"", &format!("\"{}l\"", "(".repeat(101)))], &["parentheses deeper than 100"]);
}

/// The warnings of the sound text with each of some parts replaced: the marked text, and the message.
fn warnings(edits: &[(&str, &str)]) -> Vec<(String, String)> {
    let text = edits.iter().fold(SOUND.to_owned(), |text, (from, to)| text.replace(from, to));
    let scene = ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"));
    let told =
        |fault: &model::Fault| (text[fault.span.clone()].to_owned(), format!("{}; {}", fault.title, fault.accepted));
    scene.model.warnings.iter().map(told).collect()
}

#[test]
fn a_number_alone_that_is_an_angle_of_more_than_a_turn_is_accepted_with_a_warning() {
    let one = |edits: &[(&str, &str)], marked: &str, parts: &[&str]| {
        let found = warnings(edits);
        assert_eq!(found.len(), 1, "{found:#?}");
        assert_eq!(found[0].0, marked, "{found:#?}");
        parts.iter().for_each(|part| assert!(found[0].1.contains(part), "{part}\n{found:#?}"));
    };
    let start = "theta = \"0.3 rad\"";
    one(&[(start, "theta = 30")], "30", &["30 rad are 4.8 turns", "degrees are written \"30 deg\""]);
    one(&[(start, "theta = \"-90\"")], "-90", &["-90 rad are 14.3 turns", "\"-90 deg\""]);
    one(&[(start, "theta = \"guess 30\"")], "guess 30", &["4.8 turns"]);
    one(&[("turned theta", "turned theta + 45")], "45", &["7.2 turns", "(45 deg)"]);
    one(&[("sin(theta)", "sin(theta - 45)")], "45", &["7.2 turns"]);
    one(
        &[("sin(theta)", "cos(inclination)"), ("m = \"2 kg\"", "m = \"2 kg\"\ninclination = \"45\"")],
        "45",
        &["\"45 deg\""],
    );
    one(&[("\"reach\"", "\"if(theta < 90, reach, 0*reach)\"")], "90", &["(90 deg)"]);
    let event = "[[event]]\nwhen = \"theta - (90 deg)\"\nset = { theta = \"180\" }\n[run]";
    one(&[("[run]", event)], "180", &["28.6 turns"]);
    let body = "[bodies.top]\nframe = \"F\"\ninertia = { xx = \"J\", yy = \"J\", zz = \"J\" }\n[bodies.bob]";
    let free = [
        ("m = \"2 kg\"", "m = \"2 kg\"\nJ = \"1 kg m^2\""),
        ("[frames]", "[frames]\nF = \"N free\""),
        ("[bodies.bob]", body),
        (start, "F = \"30 about x\""),
    ];
    one(&free, "30 about x", &["30 deg about x"]);
}

#[test]
fn a_start_without_its_unit_is_shown_one_of_its_own() {
    let metres = ("[coordinates]\ntheta = \"rad\"", "[coordinates]\ntheta = \"rad\"\nx = \"mm\"");
    let start = "theta = \"0.3 rad\"";
    one(&[metres, (start, "x = 100")], &["the start of `x` cannot be read", "such as \"0.3 m\""]);
    one(&[metres, (start, "\"x'\" = 100")], &["such as \"0.3 m/s\" or \"guess 0.3 m/s\""]);
}

#[test]
fn angles_with_units_small_ones_and_numbers_that_are_no_angles_are_no_warning() {
    for edits in [
        &[("theta = \"0.3 rad\"", "theta = \"30 rad\"")][..],
        &[("theta = \"0.3 rad\"", "theta = 6.28")],
        &[("theta = \"rad\"", "theta = \"1\""), ("theta = \"0.3 rad\"", "theta = 30")],
        &[("sin(theta)", "sin(10*theta + (45 deg))")],
        &[("\"reach\"", "\"30 + theta/(1 rad)*30\"")],
        &[("theta = \"0.3 rad\"", "\"theta'\" = \"30 rad/s\"")],
    ] {
        assert_eq!(warnings(edits), Vec::new(), "{edits:?}");
    }
}

#[test]
fn units_in_which_nothing_is_shown_are_a_warning() {
    let metres = |unit: &str| format!("[coordinates]\nx = \"{unit}\"");
    let body = ("centre = \"P\"", "centre = \"P + x*N.x\"");
    for (unit, shown) in [("mm", "m"), ("km", "m"), ("m", ""), ("in", "m")] {
        let found = warnings(&[("[coordinates]", &metres(unit)), body]);
        let told = format!("`x` is computed and shown in {shown}, not in {unit}");
        assert_eq!(found.len(), usize::from(!shown.is_empty()), "{found:?}");
        assert!(found.iter().all(|(at, text)| at == unit && text.starts_with(&told)), "{found:?}");
    }
    let found = warnings(&[("theta = \"rad\"", "theta = \"deg\"")]);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].1.contains("in rad, not in deg") && found[0].1.contains("(20 deg)"), "{found:?}");
    let found = warnings(&[("[outputs]", "[inputs]\nu = { unit = \"kN\", value = \"(2 kN)\" }\n[outputs]")]);
    assert_eq!(found.len(), 1, "{found:?}");
}

#[test]
fn an_inertia_by_the_motion_has_the_law_of_a_solid_body_and_a_warning() {
    let mass = |mass: &str| warnings(&[("mass = \"m\"", &format!("mass = \"{mass}\""))]);
    let found = mass("m + (0.1 kg)*theta");
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].1.contains("the inertia of `bob` depends on the motion: its law is m a = F"), "{found:?}");
    assert!(found[0].1.contains("[energies] kinetic"), "{found:?}");
    assert_eq!(mass("m + (0.1 kg s)*theta'").len(), 1);
    assert_eq!(mass("m + (0.1 kg/s)*t"), Vec::new());
}

#[test]
fn one_slip_is_told_once_and_with_what_was_meant() {
    // a name that is reserved, and what stands for it elsewhere
    one(
        &[("theta = \"rad\"", "theta = \"rad\"\nt = \"m\""), ("\"O - l*A.y\"", "\"O - l*A.y + t*N.x\"")],
        &["`t` has a meaning of its own"],
    );
    let gains = "[[constraint]]\nzero = \"theta - (0.3 rad)\"\nprogrammed = { gains = 8 }\n[outputs]";
    one(&[("[outputs]", gains)], &["`gains` has the wrong type"]);
    let free = ("[frames]", "[frames]\nF1 = \"N free\"");
    let start = |start: &str| format!("[start]\n{start}");
    one(&[free, ("[start]", &start("F = \"30 deg about x\""))], &["is `F1` meant?"]);
    one(&[free, ("[start]", &start("\"F1.w\" = \"1 rad/s\""))], &["is `F1.w"]);
    let event = |when: &str| format!("[[event]]\nwhen = \"{when}\"\nend = true\n[outputs]");
    for (when, meant) in [
        ("theta > (1 rad)", "theta - (1 rad)"),
        ("theta > 1", "theta - 1"),
        ("theta > theta' + (1 rad/s)", "theta - (theta' + (1 rad/s))"),
        ("theta > (1 rad)*(2 rad)", "theta - ((1 rad)*(2 rad))"),
    ] {
        one(&[("[outputs]", &event(when))], &[&format!("when = \"{meant}\", with direction")]);
    }
    let friction =
        [("(0.1 N)*N.x", "-(0.1 N)*sign(theta)*N.x - (3 N)*theta*N.x"), ("theta = \"0.3 rad\"", "theta = \"0 rad\"")];
    one(&friction, &["`theta'`, if the sign of a speed is meant, as in dry friction -F*sign(theta')"]);
    one(&[("mass = \"m\"", "mass = \"m - (3.2 kg)\"")], &["it is -1.2 kg"]);
}

#[test]
fn columns_of_one_name_are_refused_at_the_second() {
    let again = |name: &str, parts: &[&str]| {
        one(&[("width = \"reach\"", &format!("width = \"reach\"\n{name} = \"l\""))], parts)
    };
    again("theta", &["`theta` has the name of a coordinate", "scene.toml:31:1"]);
    again("\"theta'\"", &["has the name of a coordinate or a speed"]);
    again("kinetic_energy", &["has the name of an energy of the run"]);
    again("time", &["has the name of the column of times"]);
}

#[test]
fn constraints_that_contradict_each_other_are_both_named() {
    let two = |one: &str, other: &str| {
        format!("[[constraint]]\nname = \"low\"\nzero = \"{one}\"\n[[constraint]]\nzero = \"{other}\"\n[outputs]")
    };
    let found = |one_zero: &str, other: &str, parts: &[&str]| {
        one(&[("[outputs]", &two(one_zero, other)), ("theta = \"0.3 rad\"", "theta = \"guess 0.3 rad\"")], parts)
    };
    let both = ["constraint 2 contradicts constraint 1 `low`", "-1.000000e-1", "zero = \"2*theta - 0.1\""];
    found("theta", "2*theta - 0.1", &both);
    found("sin(theta)", "3*sin(theta) + 1", &["constraint 2 contradicts constraint 1 `low`"]);
    // out of reach of each other, by no identity
    found("sin(theta)", "cos(theta)", &["was not met from this start"]);
}

#[test]
fn what_is_wrong_with_a_constraint_is_told_once() {
    let load = "[[constraint]]\nname = \"low\"\nzero = \"thata\"\n[outputs]\nload = \"reaction(low)\"";
    one(&[("[outputs]", load)], &["is called `thata`"]);
    one(&[("theta = \"rad\"", "theta = \"radd\""), ("[outputs]", &load.replace("thata", "theta"))], &["`radd`"]);
    let none = load.replace("zero = \"thata\"", "zero = \"theta\"").replace("reaction(low)", "reaction(high)");
    one(&[("[outputs]", &none)], &["no constraint is called `high`"]);
}

#[test]
fn a_mass_that_is_not_positive_is_told_at_its_own_text() {
    one(&[("mass = \"m\"", "mass = \"m - (3 kg)\"")], &["scene.toml:23:9", "it is -1 kg"]);
}

#[test]
fn units_of_engineers_and_spaces_about_a_slash_are_read() {
    for spring in ["72 km/h", "20 m / s", "1200 m /min", "1728000 m/day"] {
        let edits =
            [("l = \"0.5 m\"", &*format!("l = \"0.5 m\"\nv = \"{spring}\"")), ("(0.1 N)*N.x", "(0.1 N s/m)*v*N.x")];
        assert_eq!(messages(&edits), Vec::<String>::new(), "{spring}");
    }
}
