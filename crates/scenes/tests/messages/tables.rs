//! Messages about keys and tables.

use super::{messages, one};

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
fn words_of_other_programs_are_sent_to_the_tables_that_have_their_content() {
    let table = |name: &str, parts: &[&str]| one(&[("[outputs]", &format!("[{name}]\nx = \"1\"\n[outputs]"))], parts);
    table("potential", &["unknown key `potential`", "stand under [energies]"]);
    table("circuit", &["unknown key `circuit`", "charges are [coordinates] with the unit C"]);
    table("[spring]", &["unknown key `spring`", "[[force]] with `between`"]);
    table("initial_conditions", &["unknown key `initial_conditions`", "[start]"]);
    let along = "[[force]]\non = \"theta\"\nis = \"(1 N m)*theta\"\n[outputs]";
    one(&[("[outputs]", along)], &["the target of a force is a point", "`along = \"x\"` in the place of `on`"]);
}

#[test]
fn knowledge_is_asked_for_by_a_name_that_is_known_and_fits() {
    let of = |name: &str, parts: &[&str]| one(&[("gravity = ", &format!("known_as = \"{name}\"\ngravity = "))], parts);
    of("friction_govenor", &["no system is known as `friction_govenor`", "is `friction_governor` meant?"]);
    of("zebra", &["no system is known as `zebra`", "known: crank_drive, elastic_governor, friction_governor"]);
    of("friction_governor", &["a system with `lateral`, which is no parameter with a value here", "lateral, rho"]);
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
fn conditions_events_and_inputs_are_checked_where_they_stand() {
    let reach = |text: &str| [("\"l*sin(theta)\"", format!("\"{text}\""))];
    let told = |text: &str, parts: &[&str]| {
        let [(from, to)] = reach(text);
        one(&[(from, &to)], parts);
    };
    told("if(theta > 0, l)", &["`if` has 3 arguments", "2 stand here"]);
    told("if(theta, l, 2*l)", &["`if` begins with a condition"]);
    told("l*cos(theta > 0)", &["`cos` has no such argument"]);
    told("if(theta > l, l, 2*l)", &["different dimensions", "1 on the left, m on the right"]);
    told("if(theta > 0, l, m)", &["different dimensions", "m on the left, kg on the right"]);
    told("l*exp(l)", &["the argument of `exp` must have the dimension 1"]);
    told("l*atan2(l, m)", &["different dimensions"]);
    told("l*table(theta, 0, 1, 0, 2)", &["the places x1, x2, ... of a table must increase"]);
    told("l*table(theta, 0, 1, 2)", &["a table must have at least two pairs of numbers"]);
    let event = |keys: &str| format!("[[event]]\n{keys}\n\n[outputs]");
    let of = |keys: &str, parts: &[&str]| one(&[("[outputs]", &event(keys))], parts);
    of("when = \"theta\"", &["this event changes nothing"]);
    of("when = \"theta\"\ndirection = \"left\"\nend = true", &["`left` is not a direction"]);
    of("when = \"theta\"\nset = { \"theta''\" = \"0\" }", &["no coordinate is called `theta''`"]);
    of("when = \"theta\"\nset = { \"theta'\" = \"l\" }", &["must have the dimension s^-1"]);
    of("when = \"theta\"\nend = \"yes\"", &["`end` has the wrong type", "true or false"]);
    let input = |keys: &str, parts: &[&str]| one(&[("[outputs]", &format!("[inputs]\n{keys}\n\n[outputs]"))], parts);
    input("u = \"N\"", &["the input `u` has no value"]);
    input("u = { unit = \"N\", value = \"l\" }", &["the input `u` must have the dimension kg m s^-2"]);
    input("u = { value = \"l\" }", &["`unit` is missing"]);
    let led = "[[constraint]]\nzero = \"theta - 0.4\"\nprogrammed = { gains = [\"(1 1/s)\"] }\n\n[outputs]";
    one(&[("[outputs]", led)], &["a programmed constraint of positions needs two gains"]);
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
fn reactions_and_conditions_are_refused_where_they_cannot_be() {
    let rod = |rest: &str| format!("[[constraint]]\nname = \"rod\"\nzero = \"theta - 0.3\"\n\n{rest}");
    let output = |text: &str| rod(&format!("[outputs]\nload = \"{text}\""));
    let told = |text: &str, parts: &[&str]| one(&[("[outputs]", &output(text))], parts);
    told("reaction(pod)", &["no constraint is called `pod`", "is `rod` meant?"]);
    told("reaction(left wheel)", &["a name with spaces stands in quotes", "reaction(\"left wheel\")"]);
    let spaced = output("reaction(\\\"left wheel\\\")").replace("name = \"rod\"", "name = \"left wheel\"");
    let still = ("theta = \"0.3 rad\"", "theta = \"0.3 rad\"");
    assert_eq!(messages(&[("[outputs]", &spaced), still]), Vec::<String>::new());
    // a condition in an output does not change the law
    assert_eq!(messages(&[("[outputs]", &output("abs(reaction(rod))"))]), Vec::<String>::new());
    told("joint_force(bob)", &["the output `load` is a scalar", "this is a vector"]);
    told("joint_force(P) . N.x", &["a body has a joint"]);
    let force = rod("[[force]]\non = \"bob\"\nis = \"(joint_force(bob) . N.x)*N.x\"\n\n[outputs]");
    one(&[("[outputs]", &force)], &["`joint_force` stands in [outputs] only"]);
    let event = "[[event]]\nwhen = \"theta'' - (1 rad/s^2)\"\nend = true\n\n[outputs]";
    one(&[("[outputs]", event)], &["depends on accelerations or reactions is not supported yet", "^^^"]);
    let piecewise = "[[constraint]]\nzero = \"if(t < (1 s), theta - 0.3, theta)\"\n\n[outputs]";
    one(&[("[outputs]", piecewise)], &["a constraint that changes at a condition is not supported yet"]);
}

#[test]
fn bodies_that_cannot_exist_are_refused() {
    one(&[("m = \"2 kg\"", "m = \"-2 kg\"")], &["the mass of `bob` must be positive", "it is -2 kg"]);
    one(&[("centre = \"P\"\n", "")], &["`bob` has a mass and no centre"]);
    one(&[("centre = \"P\"\nmass = \"m\"\n", "centre = \"P\"\n")], &["`bob` has no mass and no inertia"]);
    let solid = "frame = \"A\"\ninertia = { principal = [\"1 kg m^2\", \"1 kg m^2\", \"3 kg m^2\"] }\nmass = \"m\"";
    one(
        &[("mass = \"m\"", &solid.replace("1 kg m^2", "(1 kg m^2)").replace("\"3 kg m^2\"", "\"(3 kg m^2)\""))],
        &["the moments of inertia of `bob` are impossible"],
    );
}

#[test]
fn an_inertia_that_would_change_in_its_body_is_refused() {
    let spun = |inertia: &str| {
        let frames = "B = \"N turned tilt about x\"\nA = \"B turned theta about z\"";
        let body = format!("[bodies.bob]\nframe = \"A\"\ninertia = {inertia}");
        let edits = [
            ("theta = \"rad\"", "theta = \"rad\"\ntilt = \"rad\""),
            ("A = \"N turned theta about z\"", frames),
            ("[bodies.bob]", body.as_str()),
        ];
        messages(&edits)
    };
    let moments = |axes: &str, second: &str| {
        spun(&format!("{{ {axes}principal = [\"(0.3 kg m^2)\", \"{second}\", \"(0.4 kg m^2)\"] }}"))
    };
    let round = "3*(0.1 kg m^2)";
    assert_eq!(moments("axes = \"B\", ", round), Vec::<String>::new());
    assert_eq!(moments("", "(0.2 kg m^2)"), Vec::<String>::new());
    let refused = moments("axes = \"B\", ", "(0.2 kg m^2)");
    assert_eq!(refused.len(), 1, "{refused:?}");
    let told = [
        "`bob` turns with `A` in the axes of its inertia, `B`",
        "its moments differ about axes of `B`",
        "axes that rest in `A`",
    ];
    assert!(told.iter().all(|part| refused[0].contains(part)), "{}", refused[0]);
    let axial = spun("\"(0.3 kg m^2)\"");
    assert!(axial[0].contains("turns about more than its z axis"), "{axial:?}");
}

#[test]
fn products_of_inertia_leave_principal_moments_that_a_body_can_have() {
    let solid = |products: &str| {
        let moments = "xx = \"(1 kg m^2)\", yy = \"(1 kg m^2)\", zz = \"(1 kg m^2)\"";
        format!("frame = \"A\"\ninertia = {{ {moments}, {products} }}\nmass = \"m\"")
    };
    let refused = |products: &str, told: &str| {
        one(&[("mass = \"m\"", &solid(products))], &["the moments of inertia of `bob` are impossible", told]);
    };
    refused("xy = \"(2 kg m^2)\"", "about its principal axes they are -1, 1 and 3 kg m^2");
    refused("xy = \"(0.9 kg m^2)\"", "about its principal axes they are 0.1, 1 and 1.9 kg m^2");
    refused("xz = \"0.9*m*l^2*2\"", "about its principal axes they are 0.1, 1 and 1.9 kg m^2");
    assert_eq!(messages(&[("mass = \"m\"", &solid("xy = \"(0.5 kg m^2)\""))]), Vec::<String>::new());
}

#[test]
fn a_unit_in_brackets_leaves_a_parameter_without_a_value() {
    for unit in ["[1]", "[ m/s ]"] {
        let open = format!("m = \"2 kg\"\nmu = \"{unit}\"");
        one(&[("m = \"2 kg\"", &open)], &["the parameter `mu` has no value"]);
    }
    one(&[("m = \"2 kg\"", "m = \"2 kg\"\nmu = \"[]\"")], &["nothing stands here", "\"[1]\""]);
    one(&[("m = \"2 kg\"", "m = \"2 kg\"\nmu = \"[2 kg]\"")], &["the parameter `mu` cannot be read"]);
}

#[test]
fn a_mass_that_is_not_positive_is_told_at_its_own_text() {
    one(&[("mass = \"m\"", "mass = \"m - (3 kg)\"")], &["scene.toml:23:9", "it is -1 kg"]);
}
