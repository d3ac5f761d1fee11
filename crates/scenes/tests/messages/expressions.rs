//! Messages about expressions and definitions.

use super::{messages, one};
use dalembert_scenes::ModelScene;

#[test]
fn unknown_letters_are_named_with_what_was_probably_meant() {
    one(&[("\"-g*N.y\"", "\"-gg*N.y\"")], &["`gg`", "^^", "is `g` meant?"]);
    one(&[("on = \"bob\"", "on = \"bobb\"")], &["`bobb`"]);
    let start = "theta = \"0.3 rad\"";
    one(&[(start, "thetadot = \"1 rad/s\"")], &["no coordinate is called `thetadot`", "is `theta'` meant?"]);
    one(&[(start, "theta_dot = \"1 rad/s\"")], &["is `theta'` meant?"]);
    one(&[("\"reach\"", "\"thetaddot\"")], &["is `theta''` meant?"]);
    one(&[("\"l*sin(theta)\"", "\"l*sinn(theta)\"")], &["no function is called `sinn`", "is `sin` meant?"]);
    one(&[("\"l*sin(theta)\"", "\"l*angular_acceleration(A)\"")], &["`angular_acceleration` is not supported yet"]);
}

#[test]
fn dimensions_are_checked_where_they_meet() {
    one(&[("\"l*sin(theta)\"", "\"l + m\"")], &["different dimensions", "m on the left, kg on the right"]);
    one(&[("\"l*sin(theta)\"", "\"l*sin(l)\"")], &["an angle must have the dimension 1", "this has the dimension m"]);
    one(&[("\"(0.1 N)*N.x\"", "\"(0.1 kg)*N.x\"")], &["the force on a point must have the dimension kg m s^-2"]);
    one(&[("mass = \"m\"", "mass = \"l\"")], &["the mass must have the dimension kg"]);
    one(&[("m = \"2 kg\"", "m = 2")], &["`m = 2` in [parameters] has no unit; with one it is written m = \"2 kg\""]);
    one(&[("l = \"0.5 m\"", "l = 0.5"), ("\"reach\"", "\"1\"")], &["`l = 0.5` in [parameters] has no unit"]);
    one(&[("theta = \"0.3 rad\"", "theta = \"0.3 m\"")], &["the start of `theta`", "this has the dimension m"]);
}

#[test]
fn kinds_are_checked_where_they_meet() {
    one(&[("\"-g*N.y\"", "\"-g\"")], &["is a vector", "this is a scalar", "such as -a*N.y"]);
    let force = messages(&[("\"(0.1 N)*N.x\"", "\"(0.1 N)\"")]).join("");
    assert!(force.contains("a vector, such as a*N.x") && !force.contains("N.z"), "{force}");
    one(&[("\"(0.1 N)*N.x\"", "\"(0.1 N)*N.x*N.y\"")], &["two vectors are multiplied by *", "a . b"]);
    one(&[("centre = \"P\"", "centre = \"l*N.x\"")], &["this is a point", "this is a vector"]);
    one(&[("\"reach\"", "\"P\"")], &["the output `width` is a scalar", "this is a point"]);
}

#[test]
fn a_circle_of_definitions_is_told_once() {
    let circle = [("reach = \"l*sin(theta)\"", "reach = \"2*other\"\nother = \"reach/2\"")];
    one(&circle, &["`reach` is defined by itself", "reach is defined by other is defined by reach"]);
    one(&[("P = \"O - l*A.y\"", "P = \"P - l*A.y\"")], &["`P` is defined by itself"]);
}

/// A quantity with a unit needs no parentheses if it is the whole expression; inside an expression it does.
#[test]
fn a_quantity_that_is_the_whole_expression_stands_as_it_is() {
    let text = "title = \"t\"\n[coordinates]\nx = \"m\"\n[bodies.b]\ncentre = \"O + x*N.x\"\nmass = \"2 kg\"\n\
                [outputs]\nlength = \"-1.5e3 mm\"\n[run]\nspan = \"1 s\"\n";
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(scene.system.outputs(0.0, &[0.0, 1.0])[..2], [-1.5, 1.0]);
    let nan = text.replace("2 kg", "nan kg");
    assert!(ModelScene::parse("scene.toml", &nan).is_err());
    one(&[("\"l*sin(theta)\"", "\"2 l\"")], &["`2*l` is a product", "`(2 l)` a number with a unit"]);
}

#[test]
fn slips_of_the_pen_in_expressions_are_told_with_the_way_out() {
    let told = |text: &str, parts: &[&str]| one(&[("\"l*sin(theta)\"", &format!("\"{text}\""))], parts);
    told("P . N.y", &["a point is no vector", "`(P - O) . N.y`"]);
    told("2l*theta", &["`2*l` is a product", "`(2 l)` a number with a unit"]);
    told("l*sin(30 deg)", &["`(30 deg)` a number with a unit, in parentheses of its own"]);
    told("l*sin theta", &["functions too: sin(a)"]);
    told("velocity(bob at P - l*N.y) . N.x", &["behind `at` stands the name of a point alone", "in [points]"]);
    told("velocity(P) in A . N.x", &["stand within the parentheses: velocity(P in B)"]);
    told("norm(velocity(P) in A + velocity(P))", &["stand within the parentheses: velocity(P in B)"]);
    told(
        "(1 m) - (1 m + (2 m)*theta)",
        &["`1*m` is a product", "`(1 m)` a number with a unit, in parentheses of its own"],
    );
    told("l**2", &["powers are written with ^"]);
    told("theta = 1", &["an expression has no equals sign"]);
    told("if(theta > 0 and theta < 1, l, 0)", &["two are nested: if("]);
    told("l*A", &["a scalar and a frame cannot be multiplied", "A.x, A.y, A.z"]);
    told("P + P", &["a point and a point cannot be added", "point + vector"]);
    told("velocity(bob)/velocity(bob)", &["cannot be divided", "scalar/scalar, vector/scalar"]);
    one(&[("\"reach\"", "\"velocity(bob)\"")], &["the output `width` is a scalar", "v . N.x, or norm(v)"]);
    one(&[("theta = \"0.3 rad\"", "\u{3b8} = \"0.3 rad\"")], &["stands in quotes: \"\u{3b8}\" = ..."]);
    one(&[("theta = \"0.3 rad\"", "theta' = \"0.3 rad/s\"")], &["a key with a prime stands in quotes: \"theta'\""]);
    let event = "[[event]]\nwhen = \"theta < 1\"\nend = true\n\n[outputs]";
    one(&[("[outputs]", event)], &["an expression passes zero", "when = \"theta - 1\", with direction"]);
    one(&[("[outputs]", "[[constraint]]\nzero = \"theta > 0\"\n\n[outputs]")], &["a constraint is an equation"]);
    let set = "[[event]]\nwhen = \"theta\"\nset = \"theta' = 0\"\n\n[outputs]";
    one(&[("[outputs]", set)], &["`set` gives coordinates and speeds their values", "set = { \"x'\""]);
}

#[test]
fn one_slip_is_told_once_and_with_what_was_meant() {
    // a reserved name, and the messages where it is used elsewhere
    one(
        &[("theta = \"rad\"", "theta = \"rad\"\nt = \"m\""), ("\"O - l*A.y\"", "\"O - l*A.y + t*N.x\"")],
        &["`t` has a meaning of its own"],
    );
    let gains = "[[constraint]]\nzero = \"theta - (0.3 rad)\"\nprogrammed = { gains = [8, 16] }\n[outputs]";
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
    one(&[("mass = \"m\"", "mass = \"m - (3.2 kg)\"")], &["it is -1.2 kg"]);
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

#[test]
fn units_of_engineers_and_spaces_about_a_slash_are_read() {
    for spring in ["72 km/h", "20 m / s", "1200 m /min", "1728000 m/day"] {
        let edits =
            [("l = \"0.5 m\"", &*format!("l = \"0.5 m\"\nv = \"{spring}\"")), ("(0.1 N)*N.x", "(0.1 N s/m)*v*N.x")];
        assert_eq!(messages(&edits), Vec::<String>::new(), "{spring}");
    }
}

#[test]
fn what_the_language_will_have_is_refused_by_name() {
    one(
        &[("[outputs]", "[machine]\nmodel = \"text\"\n\n[outputs]")],
        &["a machine belongs to the drive that it moves"],
    );
    one(&[("width = \"reach\"", "width = \"left.i\"")], &["no drive is called `left`"]);
}

#[test]
fn accelerations_and_reactions_have_no_rate() {
    let output = |text: &str| {
        one(&[("width = \"reach\"", &format!("width = \"{text}\""))], &["have no rate here", "scene.toml:30:10"])
    };
    output("rate(theta'')");
    output("rate(rate(theta'))");
    output("rate(acceleration(bob) in A) . N.x");
    output("rate(joint_force(bob)) . N.x");
    assert_eq!(messages(&[("width = \"reach\"", "width = \"rate(rate(reach))\"")]), Vec::<String>::new());
}

#[test]
fn a_reserved_name_that_a_file_defines_is_no_circle() {
    let reserved = |from: &str, to: &str, name: &str| {
        one(&[(from, &format!("{from}\n{to}"))], &[&format!("`{name}` has a meaning of its own")]);
    };
    reserved("A = \"N turned theta about z\"", "N = \"A turned theta about x\"", "N");
    reserved("P = \"O - l*A.y\"", "O = \"P + l*A.x\"", "O");
    reserved("P = \"O - l*A.y\"", "ground = \"P + l*A.x\"", "ground");
}

#[test]
fn a_name_that_stands_for_two_things_is_told_once() {
    one(&[("m = \"2 kg\"", "m = \"2 kg\"\ntheta = \"1 m\"")], &["`theta` is defined twice"]);
    one(&[("m = \"2 kg\"", "m = \"2 kg\"\nP = \"1 m\"")], &["`P` is defined twice", "the name of a parameter already"]);
}

#[test]
fn a_fault_hides_no_fault_of_another_text_or_name() {
    let two = |edits: &[(&str, &str)], parts: [&str; 2]| {
        let found = messages(edits);
        assert_eq!(found.len(), 2, "{found:#?}");
        parts.iter().zip(&found).for_each(|(part, found)| assert!(found.contains(part), "{part}\n{found}"));
    };
    two(&[("O - l*A.y", "O - k*A.y"), ("mass = \"m\"", "mass = \"mm\"")], ["called `k`", "called `mm`"]);
    two(&[("O - l*A.y", "O - k*A.y + j*A.x")], ["called `k`", "called `j`"]);
    two(&[("on = \"bob\"", "on = \"bop\""), ("(0.1 N)*N.x", "(0.1 N)*K.x")], ["called `bop`", "called `K`"]);
    let event = "[[event]]\nwhen = \"thet\"\nset = { theta = \"x0\" }\n\n[outputs]";
    two(&[("[outputs]", event)], ["called `thet`", "called `x0`"]);
    let input = "[inputs]\nu = { unit = \"NN\", value = \"x0\" }\n\n[outputs]";
    two(&[("[outputs]", input)], ["an input has a unit", "called `x0`"]);
}

#[test]
fn an_energy_of_accelerations_is_told_before_its_dimension() {
    for (name, most) in [("kinetic", "coordinates, speeds and the time"), ("potential", "coordinates and the time;")] {
        let energy = format!("[energies]\n{name} = \"m*l^2*theta''^2/2\"\n\n[outputs]");
        one(&[("[outputs]", &energy)], &[&format!("the {name} energy holds accelerations"), most]);
    }
}
