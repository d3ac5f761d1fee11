//! Warnings of accepted texts that may not mean what their author intended.

use super::SOUND;
use dalembert_scenes::ModelScene;

/// For each warning about the sound text after some replacements: the marked text and the message.
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
fn a_parameter_that_nothing_uses_is_a_warning() {
    let found = warnings(&[("m = \"2 kg\"", "m = \"2 kg\"\nidle = \"1 m\"")]);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].0 == "idle" && found[0].1.contains("the parameter `idle` is not used"), "{found:?}");
    let used = [("m = \"2 kg\"", "m = \"2 kg\"\nidle = \"1 m\""), ("\"reach\"", "\"reach - idle\"")];
    assert_eq!(warnings(&used), Vec::new());
    let of_cost = "[inputs]\nu = \"N m\"\n[[force]]\nalong = \"theta\"\nis = \"u\"\n[regulator]\ncost = \"(theta/idle)^2 + (u/(1 N m))^2\"\n[outputs]";
    let used = [("m = \"2 kg\"", "m = \"2 kg\"\nidle = \"0.1 rad\""), ("[outputs]", of_cost)];
    assert_eq!(warnings(&used), Vec::new());
}

#[test]
fn an_inertia_about_a_moving_centre_without_a_mass_is_a_warning() {
    let rod = |rest: &str| {
        let rod = format!("[bodies.rod]\nframe = \"A\"\ninertia = \"(1 kg m^2)\"\n{rest}[bodies.bob]");
        warnings(&[("[bodies.bob]", &rod)])
    };
    let found = rod("centre = \"P\"\n");
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].1.contains("the body `rod` has an inertia, a centre that moves, and no mass"), "{found:?}");
    for rest in ["", "centre = \"O\"\n", "centre = \"P\"\nmass = \"m\"\n"] {
        assert_eq!(rod(rest), Vec::new(), "{rest}");
    }
}

/// A ball rolls on a fixed ball. The contact is maintained by the coordinates, not by the constraint, so that its reaction has no normal component.
#[test]
fn an_output_of_a_reaction_where_its_component_vanishes_is_a_warning() {
    const BALL: &str = "title = \"A ball on a ball\"\n[parameters]\nR = \"0.3 m\"\nr = \"0.1 m\"\n[coordinates]\naz = \"rad\"\npol = \"rad\"\n\
        [frames]\nA = \"N turned az about z\"\nP = \"A turned pol about y\"\nB = \"N free\"\n[points]\nG = \"O + (R + r)*P.z\"\n\
        C = \"O + R*P.z\"\n[bodies.ball]\nframe = \"B\"\ncentre = \"G\"\nmass = \"(1 kg)\"\n\
        inertia = { principal = [\"(1 kg m^2)\", \"(1 kg m^2)\", \"(1 kg m^2)\"] }\n[[constraint]]\nname = \"roll\"\n\
        zero = \"velocity(ball at C)\"\n[speeds]\nw1 = \"az'\"\nw2 = \"pol'\"\nn = \"angular_velocity(ball) . P.z\"\n\
        [outputs]\nseen = \"SEEN\"\n[start]\npol = \"1 rad\"\n[run]\nspan = \"1 s\"\n";
    let warned = |seen: &str| {
        let scene = ModelScene::parse("scene.toml", &BALL.replace("SEEN", seen));
        let scene = scene.unwrap_or_else(|error| panic!("{error}"));
        scene.model.warnings.iter().map(|warning| warning.title.clone()).collect::<Vec<_>>()
    };
    let told = ["the component of `roll` along P.z vanishes identically, and has no reaction"];
    for seen in ["reaction(roll) . P.z", "reaction(roll) . N.z", "norm(reaction(roll))"] {
        assert_eq!(warned(seen), told, "{seen}");
    }
    for seen in ["reaction(roll) . P.x", "norm(cross(reaction(roll), P.z))", "pol"] {
        assert_eq!(warned(seen), Vec::<String>::new(), "{seen}");
    }
}

/// A torque -c w^2 drives a fan that turns backwards; -c abs(w)*w and -c w^3 brake it in both directions.
#[test]
fn a_load_with_even_powers_of_its_speed_is_warned_of() {
    let warned = |table: &str, law: &str| {
        let text = format!(
            "title = \"fan\"\n[parameters]\nJ = \"0.01 kg*m^2\"\nc = \"1e-3 N*m*s^2\"\nd = \"1e-2 N*m*s\"\n[coordinates]\nth = \"rad\"\n\
             [bodies.fan]\nturns = \"th\"\ninertia = \"J\"\n{table}\n{law}\n[start]\n\"th'\" = \"3 rad/s\"\n[run]\nspan = \"1 s\"\n"
        );
        let scene = dalembert_scenes::ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"));
        scene.model.warnings.iter().any(|warning| warning.title.contains("drives it the other way"))
    };
    let torque = |law: &str| warned("[[torque]]\non = \"fan\"", &format!("is = \"({law})*N.z\""));
    assert!(torque("-c*th'^2") && torque("-d*th' - c*th'^2") && torque("(1 N m) - c*th'^2"));
    for law in ["-c*abs(th')*th'", "-d*th'", "-c*th'^3*(1 s)", "(1 N m)*sin(th)", "(1 N m)*sign(th')"] {
        assert!(!torque(law), "{law}");
    }
    assert!(warned("[[force]]\nalong = \"th\"", "is = \"-c*th'^2\""));
    assert!(warned("[[drive]]\nname = \"m\"\nturns = \"th\"", "torque = \"-c*m.speed^2\""));
    // the torque of a motor may be proportional to the square of its current
    let motor =
        "[[drive]]\nname = \"m\"\nturns = \"th\"\n[[drive.winding]]\ninductance = \"(1 mH)\"\nresistance = \"(1 ohm)\"";
    assert!(!warned(motor, "supply = \"(3 V)\"\nmotional = \"(0.1 H)*m.i\""));
}
