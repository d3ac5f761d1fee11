//! Inverse dynamics: the forces for a prescribed motion.

use super::stored;
use dalembert_scenes::inverse::inverse;
use dalembert_scenes::linearisation::VariedEquations;
use dalembert_scenes::{SystemText, parse_prescribed, read_prescribed};

#[test]
fn inverse_dynamics_gives_the_torque_that_runs_the_motion() {
    let path = stored("models/slider_crank");
    let motion = [("theta".to_owned(), "0.4 + 0.3*sin(t*(5 rad/s))".to_owned())];
    let (model, prescribed) = read_prescribed(&path, &motion).unwrap_or_else(|error| panic!("{error}"));
    let place = model.parameters.iter().position(|parameter| parameter.name == "T").expect("it is there");
    let times = [0.0, 0.1, 0.55];
    let found = inverse(&model, &prescribed, &["T".to_owned()], &times).unwrap_or_else(|why| panic!("{why}"));
    for forces in found.forces {
        let mut driven = model.clone();
        driven.parameters[place].value = Some(forces.unknowns[0]);
        let equations = VariedEquations::of(&driven, &[]).unwrap_or_else(|why| panic!("{why}"));
        let state = [forces.coordinates.clone(), forces.speeds.clone()].concat();
        let point = equations.with_accelerations(equations.point(forces.time, &state)).expect("it is determined");
        let exact = -0.3 * 25.0 * (5.0 * forces.time).sin();
        assert!((point.accelerations[0] - exact).abs() < 1e-9, "{} {exact}", point.accelerations[0]);
        for (k, value) in forces.multipliers.iter().enumerate() {
            assert!((point.multipliers[k] - value).abs() < 1e-9, "{value}");
        }
    }
    let refused = |motion: &[(String, String)], unknowns: &[&str]| {
        let unknowns: Vec<String> = unknowns.iter().map(|name| (*name).to_owned()).collect();
        let (model, prescribed) = read_prescribed(&path, motion).unwrap_or_else(|error| panic!("{error}"));
        inverse(&model, &prescribed, &unknowns, &times).expect_err("it is refused").to_string()
    };
    assert!(refused(&motion, &[]).contains("the system is underactuated: 2 of 3 equations"));
    assert!(refused(&motion, &["theta"]).contains("neither a parameter nor an input"));
    assert!(refused(&motion, &["r"]).contains("not linear in `r`"));
    let state = [("theta".to_owned(), "phi".to_owned())];
    assert!(refused(&state, &["T"]).contains("must be an expression of t"));
    let wrong = read_prescribed(&path, &[("theta".to_owned(), "(1 m)".to_owned())]).expect_err("metres").to_string();
    assert!(wrong.contains("a prescribed motion: ") && wrong.contains("different dimensions"), "{wrong}");
    let zero = [("theta".to_owned(), "(0 deg)".to_owned())];
    let (model, prescribed) = read_prescribed(&path, &zero).unwrap_or_else(|error| panic!("{error}"));
    let resting = inverse(&model, &prescribed, &["T".to_owned()], &[0.0]).unwrap_or_else(|why| panic!("{why}"));
    // horizontal crank: half the weight of the rod acts at its end, at a distance of 0.1 m
    assert!((resting.forces[0].unknowns[0] - 0.4 * 9.81 * 0.1 / 2.0).abs() < 1e-12, "{resting:?}");
}

#[test]
fn an_instant_at_which_no_equation_holds_an_unknown_is_told() {
    let text = "title = \"A mass on a spring\"\n[parameters]\nm = \"2 kg\"\nk = \"0 N/m\"\n[coordinates]\nx = \"m\"\n\
        [bodies.bob]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n[[force]]\non = \"bob\"\nis = \"-k*x*N.x\"\n[run]\nspan = \"1 s\"\n";
    let path = std::env::temp_dir().join(format!("dalembert_{}_idle.toml", std::process::id()));
    std::fs::write(&path, text).expect("it can be written");
    let forces = |times: &[f64]| {
        let motion = [("x".to_owned(), "(0.1 m)*sin(t*(3 rad/s))".to_owned())];
        let (model, prescribed) = read_prescribed(&path, &motion).unwrap_or_else(|error| panic!("{error}"));
        inverse(&model, &prescribed, &["k".to_owned()], times)
    };
    let refused = forces(&[0.0]).expect_err("nothing determines it").to_string();
    assert!(refused.starts_with("at t = 0 s no equation of motion holds `k`"), "{refused}");
    let found = forces(&[0.1, 0.5]).unwrap_or_else(|why| panic!("{why}"));
    assert!(found.forces.iter().all(|forces| (forces.unknowns[0] - 18.0).abs() < 1e-10), "{found:?}");
    let led = text.replace("[run]", "[[constraint]]\nname = \"path\"\nzero = \"x - (0.3 m)\"\nprogrammed = { gains = [\"(2 1/s)\", \"(1 1/s^2)\"] }\n[run]");
    std::fs::write(&path, led).expect("it can be written");
    let refused = forces(&[0.0]).expect_err("it goes elsewhere").to_string();
    std::fs::remove_file(&path).expect("it is there");
    assert!(
        refused
            .starts_with("constraint 1 `path` is programmed, and the prescribed motion does not follow it: at t = 0 s"),
        "{refused}"
    );
    // 2*0.1*3 - 0.3
    assert!(
        refused.contains(" s f'' + g1 f' + g2 f is 0.3 m/s^2, and not zero; a file without this constraint"),
        "{refused}"
    );
}

/// A rod on three parallel cranks does not turn: weight and inertia act on the first crank as those of a mass at its end,
/// T = m r^2 a'' + m g r cos(a). The constraint of the third crank is redundant.
#[test]
fn equations_that_follow_from_others_are_left_out_of_forces_for_a_motion() {
    let text = "title = \"A rod on three cranks\"\ngravity = \"-g*N.y\"\n[parameters]\ng = \"9.81 m/s^2\"\nr = \"0.3 m\"\n[coordinates]\n\
        a = \"rad\"\nb = \"rad\"\nc = \"rad\"\nd = \"rad\"\n[frames]\nA = \"N turned a about z\"\nB = \"N turned b about z\"\n\
        C = \"N turned c about z\"\nD = \"N turned d about z\"\n[points]\nP = \"O + r*A.x\"\n[bodies.crank]\nframe = \"A\"\n\
        inertia = \"(0.01 kg m^2)\"\n[bodies.rod]\nframe = \"D\"\ncentre = \"P + (1.2 m)*D.x\"\nmass = \"(2 kg)\"\n\
        inertia = \"(0.3 kg m^2)\"\n[[constraint]]\nname = \"second\"\nzero = \"P + (1 m)*D.x - O - (1 m)*N.x - r*B.x\"\n\
        [[constraint]]\nname = \"third\"\nzero = \"P + (2 m)*D.x - O - (2 m)*N.x - r*C.x\"\n[inputs]\n\
        T = { unit = \"N m\", value = \"0\" }\n[[torque]]\non = \"crank\"\nis = \"T*N.z\"\n[start]\na = \"60 deg\"\n\
        b = \"60 deg\"\nc = \"60 deg\"\n[run]\nspan = \"1 s\"\n";
    let path = std::env::temp_dir().join(format!("dalembert_{}_cranks.toml", std::process::id()));
    std::fs::write(&path, text).expect("it can be written");
    let read = read_prescribed(&path, &[("a".to_owned(), "1 + t^2*(0.5 1/s^2)".to_owned())]);
    std::fs::remove_file(&path).expect("it is there");
    let (model, prescribed) = read.unwrap_or_else(|error| panic!("{error}"));
    let found = inverse(&model, &prescribed, &["T".to_owned()], &[0.0, 0.3, 0.7]);
    let found = found.unwrap_or_else(|why| panic!("{why}"));
    let [follows] = &found.left_out[..] else { panic!("{:?}", found.left_out) };
    assert!(follows.title.starts_with("constraint 3 `third` along "), "{}", follows.title);
    assert_eq!(found.constraints.len(), 3);
    for forces in found.forces {
        let angle = 1.0 + 0.5 * forces.time * forces.time;
        let exact = (2.0 * 0.09 + 0.01) + 2.0 * 9.81 * 0.3 * angle.cos();
        assert!((forces.unknowns[0] - exact).abs() < 1e-9, "{forces:?} {exact}");
    }
}

/// A body on a slide with unknown force and torques; the markers COORDINATES and FRAMES stand for the definition of its frame.
const TURNED: &str = "title = \"A body\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"2 kg\"\nA = \"0.3 kg m^2\"\nB = \"0.4 kg m^2\"\nC = \"0.6 kg m^2\"\n\
    g = \"9.81 m/s^2\"\nP = \"0 N\"\nT1 = \"0 N m\"\nT2 = \"0 N m\"\nT3 = \"0 N m\"\n[coordinates]\nx = \"m\"\nCOORDINATES\n[frames]\nFRAMES\n\
    [bodies.stone]\nframe = \"F\"\ncentre = \"O + x*N.x + (0.1 m)*F.z\"\nmass = \"m\"\ninertia = { principal = [\"A\", \"B\", \"C\"] }\n\
    [[force]]\non = \"stone at O + x*N.x\"\nis = \"P*N.x\"\n[[torque]]\non = \"stone\"\nis = \"T1*F.x + T2*F.y + T3*F.z\"\n[run]\nspan = \"1 s\"\n";

fn forces_of(name: &str, text: &str, motions: &[(&str, &str)]) -> Vec<dalembert_scenes::inverse::Forces> {
    let path = std::env::temp_dir().join(format!("dalembert_{}_{name}.toml", std::process::id()));
    std::fs::write(&path, text).expect("it can be written");
    let motions: Vec<(String, String)> = motions.iter().map(|&(name, is)| (name.to_owned(), is.to_owned())).collect();
    let read = read_prescribed(&path, &motions);
    std::fs::remove_file(&path).expect("it is there");
    let (model, prescribed) = read.unwrap_or_else(|error| panic!("{error}"));
    let unknowns = ["P", "T1", "T2", "T3"].map(str::to_owned);
    inverse(&model, &prescribed, &unknowns, &[0.0, 0.3, 1.1]).unwrap_or_else(|why| panic!("{why}")).forces
}

/// A free frame with a prescribed sequence of rotations needs the torques of a frame with three angles.
#[test]
fn forces_for_turns_of_a_free_frame_are_those_for_three_angles() {
    let slide = ("x", "(0.2 m)*sin(t*(3 rad/s))");
    let [yaw, tilt, spin] = ["0.4 + t*(0.7 rad/s)", "1 + 0.3*cos(t*(2 rad/s))", "t^2*(3 1/s^2)"];
    let free = TURNED.replace("COORDINATES", "").replace("FRAMES", "F = \"N free\"");
    let free =
        forces_of("free", &free, &[slide, ("F", &format!("{yaw} about z, then {tilt} about x, then {spin} about z"))]);
    let turned = TURNED.replace("COORDINATES", "yaw = \"rad\"\ntilt = \"rad\"\nspin = \"rad\"").replace(
        "FRAMES",
        "Y = \"N turned yaw about z\"\nT = \"Y turned tilt about x\"\nF = \"T turned spin about z\"",
    );
    let turned = forces_of("turned", &turned, &[slide, ("yaw", yaw), ("tilt", tilt), ("spin", spin)]);
    for (free, turned) in free.iter().zip(&turned) {
        assert_eq!([free.coordinates.len(), free.speeds.len(), free.accelerations.len()], [5, 4, 4]);
        for (one, other) in free.unknowns.iter().zip(&turned.unknowns) {
            assert!((one - other).abs() < 1e-9 * (1.0 + other.abs()), "{free:?} {turned:?}");
        }
        // at the start one of the torques is zero
        let act = free.unknowns.iter().filter(|force| force.abs() > 1e-3).count();
        assert_eq!(act, if free.time > 0.0 { 4 } else { 3 }, "{free:?}");
    }
}

/// For rotation about one axis, the torque is C theta''; coordinates coupled to the free frame by a constraint follow.
#[test]
fn a_free_frame_that_turns_about_one_axis_needs_the_torque_of_its_moment() {
    let held = TURNED
        .replace("COORDINATES", "y = \"m\"")
        .replace("FRAMES", "F = \"N free\"")
        .replace("[run]", "[[constraint]]\nname = \"tie\"\nzero = \"y - (0.5 m)*(F.x . N.y)\"\n[run]");
    let found = forces_of("tied", &held, &[("x", "(0 m)"), ("F", "t^2*(2 1/s^2) about z")]);
    for forces in found {
        let angle = 2.0 * forces.time * forces.time;
        assert!((forces.coordinates[1] - 0.5 * angle.sin()).abs() < 1e-12, "{forces:?}");
        assert!((forces.unknowns[3] - 0.6 * 4.0).abs() < 1e-9 && forces.unknowns[0].abs() < 1e-9, "{forces:?}");
    }
}

#[test]
fn a_motion_of_a_free_frame_that_is_no_turn_is_refused() {
    let path = stored("models/tumbling_body");
    let refused = |motion: &[(&str, &str)]| {
        let motion: Vec<_> = motion.iter().map(|&(name, is)| (name.to_owned(), is.to_owned())).collect();
        match read_prescribed(&path, &motion) {
            Err(error) => error.to_string(),
            Ok((model, prescribed)) => {
                inverse(&model, &prescribed, &[], &[0.0]).expect_err("it is refused").to_string()
            }
        }
    };
    assert!(refused(&[("F", "t*(1 rad/s)")]).contains("turns one after the other: F = "));
    assert!(refused(&[("F", "t*(1 rad/s) about w")]).contains("a free frame turns"));
    assert!(refused(&[("F", "t about z")]).contains("different dimensions"));
    assert!(refused(&[("F", "F.wx*t about z")]).contains("the motion of `F` must be an expression of t"));
    assert!(refused(&[("F", "t*(1 rad/s) about z"), ("F", "0 about x")]).contains("it is prescribed twice"));
    assert!(refused(&[("G", "0 about x")]).contains("a motion for each of: x, F"));
    assert!(refused(&[("x", "(1 m)")]).contains("do not determine `F.wx`, `F.wy`, `F.wz`"));
}

/// Three constraints rotate a free frame by 0.5 t^2 about N.z without a prescribed motion. The third constraint contains sin(theta), so that
/// C theta'' = lambda cos(theta).
#[test]
fn a_free_frame_that_constraints_turn_is_found_from_them() {
    let held = TURNED.replace("COORDINATES", "").replace("FRAMES", "F = \"N free\"").replace("(0.1 m)*F.z", "0*x*F.z").replace(
        "[[torque]]\non = \"stone\"\nis = \"T1*F.x + T2*F.y + T3*F.z\"\n",
        "[[constraint]]\nname = \"turn\"\nzero = [\"F.x . N.z\", \"F.y . N.z\", \"F.x . N.y - sin(t^2*(0.5 1/s^2))\"]\n",
    );
    let path = std::env::temp_dir().join(format!("dalembert_{}_held.toml", std::process::id()));
    std::fs::write(&path, &held).expect("it can be written");
    let read = read_prescribed(&path, &[("x".to_owned(), "(0.1 m)*t^2/(1 s^2)".to_owned())]);
    std::fs::remove_file(&path).expect("it is there");
    let (model, prescribed) = read.unwrap_or_else(|error| panic!("{error}"));
    let times: Vec<f64> = (0..=10).map(|k| 0.1 * f64::from(k)).collect();
    for forces in inverse(&model, &prescribed, &["P".to_owned()], &times).unwrap_or_else(|why| panic!("{why}")).forces {
        let angle = 0.5 * forces.time * forces.time;
        let [q0, q3] = [forces.coordinates[1], forces.coordinates[4]];
        assert!((2.0 * q3.atan2(q0) - angle).abs() < 1e-9, "{forces:?}");
        assert!(
            (forces.speeds[3] - forces.time).abs() < 1e-9 && (forces.accelerations[3] - 1.0).abs() < 1e-8,
            "{forces:?}"
        );
        assert!((forces.multipliers[2] * angle.cos() - 0.6).abs() < 1e-8, "{forces:?}");
        assert!((forces.unknowns[0] - 2.0 * 0.2).abs() < 1e-9, "{forces:?}");
    }
}

/// A prescribed motion that contains an unknown quantity is refused, since its value is not known before.
#[test]
fn a_motion_by_a_quantity_that_is_sought_is_refused() {
    let text = "title = \"two carts\"\n[parameters]\nk = \"4 N/m\"\n[coordinates]\nx = \"m\"\n[bodies.a]\ncentre = \"O + x*N.x\"\nmass = \"(1 kg)\"\n\
        [inputs]\nu = \"N\"\n[[force]]\non = \"a\"\nis = \"(u - k*x)*N.x\"\n";
    let system = SystemText { name: "scene.toml".into(), text: text.into(), values: Vec::new() };
    let asked = |motion: &str, sought: &str| {
        let motions = [("x".to_owned(), motion.to_owned())];
        parse_prescribed(&system, &motions, &[sought.to_owned()], "--motion")
            .map(|_| ())
            .map_err(|error| error.to_string())
    };
    assert_eq!(asked("(0.1 m/s)*t", "u"), Ok(()));
    for (motion, sought) in [("(0.1 m)*u/(1 N)", "u"), ("(0.1 m)*k/(1 N/m)", "k")] {
        let told = asked(motion, sought).expect_err("it is sought");
        assert!(told.contains("it depends on a quantity that is sought"), "{told}");
    }
    assert_eq!(asked("(0.1 m)*k/(1 N/m)", "u"), Ok(()));
}
