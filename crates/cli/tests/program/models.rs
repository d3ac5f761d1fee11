//! A system that is written in its file, as its users meet it.

use crate::{json, program, root, run, temporary};
use std::path::Path;

const MODEL: &str = "scenes/models/double_pendulum.toml";

#[test]
fn every_principle_and_notation_gives_the_equations() {
    let body = "scenes/models/tumbling_body.toml";
    for format in ["text", "latex", "mathml", "sympy", "c", "python", "rust"] {
        assert!(
            printed(&["derive", body, "--format", format]).contains("q0") || format == "latex" || format == "mathml"
        );
    }
    for principle in ["lagrange", "virtual-power", "appell", "gauss", "newton-euler", "hamel", "hamilton"] {
        for format in ["text", "latex", "mathml", "sympy", "c", "python", "rust"] {
            let output = run(&["derive", MODEL, "--principle", principle, "--format", format]);
            assert_eq!(
                output.status.code(),
                Some(0),
                "{principle} {format}: {}",
                String::from_utf8_lossy(&output.stderr)
            );
            assert!(output.stdout.len() > 100, "{principle} {format}");
        }
    }
    let text = printed(&["derive", MODEL, "--echo"]);
    for line in ["acceleration(P) = l1*a''*A.x + l1*a'^2*A.y", "m1 = 1 kg", "M[a, b] = m2*l1*l2*cos(a - b)"] {
        assert!(text.lines().any(|known| known.trim() == line), "{line}\n{text}");
    }
    let latex = printed(&["derive", MODEL, "--format", "latex"]);
    assert!(latex.contains(r"\begin{align}") && latex.contains(r"\dot{a}^2\sin(a - b)"), "{latex}");
    let refused = run(&["derive", MODEL, "--principle", "momentum"]);
    let message = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(
        refused.status.code() == Some(2)
            && message.contains("virtual-power, lagrange, appell, gauss, newton-euler, hamel, hamilton"),
        "{message}"
    );
}

fn printed(arguments: &[&str]) -> String {
    let output = run(arguments);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {message}");
    String::from_utf8(output.stdout).expect("it is text")
}

fn refused(arguments: &[&str], why: &str) {
    let output = run(arguments);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
    assert!(message.contains(why), "{arguments:?}: {message}");
}

/// A mass on a spring, pushed by a force: every entry of its linear equations is known.
const SPRING: &str = "title = \"A mass on a spring\"\n[parameters]\nm = \"2 kg\"\nk = \"18 N/m\"\nF = \"N\"\n[coordinates]\nx = \"mm\"\n\
    [points]\nP = \"O + x*N.x\"\n[bodies.bob]\ncentre = \"P\"\nmass = \"m\"\n[[force]]\non = \"bob\"\nis = \"(F - k*x)*N.x\"\n\
    [outputs]\npull = \"k*x\"\n[run]\nspan = \"1 s\"\n";

#[test]
fn linear_equations_are_printed_in_every_format() {
    let path = temporary("spring.toml");
    std::fs::write(&path, SPRING).expect("it is written");
    let path = path.display().to_string();
    let point = &json(&run(&["linearise", &path, "--input", "F", "--format", "json"]))["points"][0];
    assert_eq!(point["states"], serde_json::json!(["x", "x'"]));
    assert_eq!(point["A"], serde_json::json!([[0.0, 1.0], [-9.0, 0.0]]));
    assert_eq!(point["B"], serde_json::json!([[0.0], [0.5]]));
    assert_eq!((&point["C"], &point["D"]), (&serde_json::json!([[18.0, 0.0]]), &serde_json::json!([[0.0]])));
    assert_eq!(point["point"], "equilibrium");
    let text = printed(&["linearise", &path, "--input", "F"]);
    assert!(text.contains("+ 3 i") && text.contains("do not decide stability"), "{text}");
    let table = printed(&["linearize", &path, "--input", "F", "--format", "csv"]);
    assert!(table.contains("0.0,A,x' [m/s],x [m],-9.0") && table.contains("0.0,B,x' [m/s],F [N],0.5"), "{table}");
    refused(&["linearise", &path], "the parameter `F` has no value");
    refused(&["linearise", &path, "--input", "G"], "no parameter is called `G`");
    refused(&["linearise", &path, "--times", "-1"], "a time that is not negative");
    std::fs::remove_file(&path).expect("it is there");
}

#[test]
fn a_run_is_linearised_at_its_instants() {
    let along = json(&run(&["linearise", MODEL, "--times", "0.5,0,0.25", "--format", "json"]));
    let points = along["points"].as_array().expect("a list");
    let times: Vec<f64> = points.iter().filter_map(|point| point["time"].as_f64()).collect();
    assert_eq!(times, [0.5, 0.0, 0.25]);
    let start = json(&run(&["linearise", MODEL, "--format", "json"]));
    assert_eq!(points[1]["A"], start["points"][0]["A"]);
    assert_eq!(points[0]["point"], "moving point");
}

/// About its middle axis a body turns over: a free frame has three turns and three speeds in its linear equations.
#[test]
fn a_free_frame_is_linearised_by_its_turns() {
    let body = "scenes/models/tumbling_body.toml";
    let point = &json(&run(&["linearise", body, "--format", "json"]))["points"][0];
    let turns = ["turn about F.x", "turn about F.y", "turn about F.z"];
    let states = ["x", turns[0], turns[1], turns[2], "x'", "F.wx", "F.wy", "F.wz"];
    assert_eq!(point["states"], serde_json::json!(states));
    assert_eq!(
        (point["A"].as_array().map(Vec::len), point["coordinates"].as_array().map(Vec::len)),
        (Some(8), Some(5))
    );
    let text = printed(&["linearise", body]);
    assert!(text.contains("  F.wx = 0.01, F.wx' = 0") && text.contains("F.q0 = "), "{text}");
    let table = printed(&["linearise", body, "--times", "0,1", "--format", "csv"]);
    assert!(table.contains("1.0,A,turn about F.x [rad],F.wx [rad/s],1.0"), "{table}");
}

#[test]
fn forces_for_a_motion_are_printed_or_refused_with_the_rank() {
    let crank = "scenes/models/slider_crank.toml";
    let motion = ["inverse", crank, "--motion", "theta = 0.3*sin(t*(5 rad/s))", "--samples", "4"];
    let table = printed(&[&motion[..], &["--unknown", "T"]].concat());
    assert_eq!(table.lines().count(), 6);
    assert!(
        table.starts_with("time [s],theta [rad],phi [rad],s [m],theta' [rad/s],")
            && table.contains(",theta'' [rad/s^2],")
            && table.contains(",T [N m],lambda1 pin along R.x [N],lambda2 pin along R.y [N]"),
        "{table}"
    );
    refused(&motion, "2 of 3 equations (the rank): underactuated");
    refused(&["inverse", crank, "--motion", "theta"], "a coordinate and an expression of t");
    refused(&["inverse", crank, "--motion", "omega = t/(1 s)"], "no coordinate has this name");
    refused(&["inverse", crank, "--motion", "theta = 2*q"], "a prescribed motion");
    let body = "scenes/models/tumbling_body.toml";
    let free = ["inverse", body, "--motion", "x = (0 m)", "--motion"];
    refused(&[&free[..], &["F = t*(1 rad/s) about z"]].concat(), "0 of 4 equations (the rank): underactuated");
    refused(&[&free[..], &["F = t*(1 rad/s)"]].concat(), "turns one after the other");
}

#[test]
fn rows_of_a_run_have_the_units_of_their_values() {
    let (path, table) = (temporary("units.toml"), temporary("units.csv"));
    std::fs::write(&path, SPRING.replace("F = \"N\"", "F = \"1 N\"")).expect("it is written");
    let (path, table) = (path.display().to_string(), table.display().to_string());
    printed(&["run", &path, "--out", &table]);
    let rows = std::fs::read_to_string(&table).expect("it is there");
    let heading = rows.lines().next().unwrap_or_default();
    // x is written in millimetres, and runs in metres
    assert_eq!(heading, "time [s],x [m],x' [m/s],pull [N],kinetic_energy [J],potential_energy [J]");
    for file in [path, table] {
        std::fs::remove_file(file).expect("it is there");
    }
}

#[test]
fn verdicts_of_a_proof_are_read_by_programs() {
    let proved = json(&run(&["prove", MODEL, "--format", "json"]));
    let rows = proved.as_array().expect("a list");
    let principles: Vec<_> = rows.iter().filter(|row| row["principles"][0] == "lagrange").collect();
    assert_eq!(principles.len(), 8);
    let without_constraints =
        |row: &serde_json::Value| row["principles"][1] == "maggi" || row["principles"][1] == "shulgin";
    for row in rows {
        let verdict = if without_constraints(row) { "does not apply" } else { "proved" };
        assert_eq!(row["verdict"], verdict, "{row}");
    }
    let energy = rows.iter().find(|row| row["about"] == "energy").expect("it has an energy");
    assert_eq!(energy["says"], "(T + V)' is zero");
}

/// A rolling disc: every line has a verdict, and the mistake that is usual with the disc is refuted.
#[test]
fn a_proof_says_what_it_rests_on_and_what_a_mistake_loses() {
    let output = run(&["prove", "scenes/models/rolling_disc.toml"]);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(output.status.code(), Some(0), "{text}");
    for line in [
        "lagrange = maggi: proved by normal form",
        "for any inertia and any forces: multipliers drop out along du/dw, with x', y' by heading', lean', spin'",
        "lagrange = shulgin: proved by normal form",
        "energy: (T + V)' is zero: proved",
        "constraint 2 `rolling`: J u' + c is its rate; its reaction does no work: proved",
        "mistake: Lagrange's equations with the constraints put into T: refuted",
        "lost in the equation of heading: ",
        "lost in the equation of spin: ",
    ] {
        assert!(text.contains(line), "{line}: {text}");
    }
    let mistake =
        ["prove", "scenes/models/rolling_disc.toml", "--mistake", "constraints-in-energy", "--format", "json"];
    let refuted = json(&run(&mistake));
    assert!(refuted[0]["verdict"] == "refuted" && refuted[0]["behind"].as_array().is_some_and(|lost| lost.len() == 2));
    let none = run(&["prove", MODEL, "--mistake", "constraints-in-energy"]);
    let message = String::from_utf8_lossy(&none.stdout).into_owned();
    assert!(
        none.status.code() != Some(0) && message.contains("no constraint of the system speaks of speeds"),
        "{message}"
    );
}

#[test]
fn what_does_not_read_such_a_file_says_so() {
    for command in ["bodies", "stationary", "regimes", "motor"] {
        let output = run(&[command, MODEL]);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{command}: {message}");
        assert!(message.contains("does not read a system that is written in its file"), "{command}: {message}");
    }
}

#[test]
fn an_ensemble_of_a_file_goes_on_where_it_was_killed() {
    let [scene, path, whole] = ["pendula.toml", "pendula.csv", "pendula_whole.csv"].map(temporary);
    let text = std::fs::read_to_string(root().join(MODEL)).expect("it is there");
    std::fs::write(&scene, text.replace("members = 10000", "members = 60")).expect("it can be written");
    let asked = |out: &Path, threads: &str| {
        let arguments = ["ensemble", &scene.to_string_lossy(), "--threads", threads, "--out"];
        program(&arguments).arg(out).output().expect("it starts")
    };
    assert!(asked(&whole, "1").status.success());
    let table = std::fs::read_to_string(&whole).expect("it was written");
    assert_eq!(table.lines().count(), 61);
    assert!(table.starts_with(
        "member,parameters.m2 [kg],parameters.l2 [m],start.a [rad],start.b' [rad/s],stopped,time [s],steps,a [rad],"
    ));
    // a row that is cut in the middle, as by a kill
    std::fs::write(&path, &table[..table.len() / 2]).expect("it can be written");
    let again = asked(&path, "3");
    let told = String::from_utf8_lossy(&again.stdout).into_owned();
    assert!(again.status.success() && told.contains("were there already"), "{told}");
    assert_eq!(std::fs::read_to_string(&path).expect("it was written"), table);
    // another length of a rod is another ensemble
    std::fs::write(&scene, text.replace("members = 10000", "members = 60").replace("l1 = \"1 m\"", "l1 = \"2 m\""))
        .expect("it can be written");
    let other = asked(&path, "1");
    let said = String::from_utf8_lossy(&other.stderr).into_owned();
    assert!(other.status.code() == Some(2) && said.contains("line 2: another ensemble"), "{said}");
    [scene, path, whole].iter().for_each(|path| std::fs::remove_file(path).expect("it is there"));
}

const PENDULUM: &str = "title = \"A pendulum\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[coordinates]\ntheta = \"rad\"\n\
    [frames]\nA = \"N turned theta about z\"\n[bodies.bob]\ncentre = \"O - (1 m)*A.y\"\nmass = \"(1 kg)\"\n\
    [[event]]\nname = \"low\"\nwhen = \"theta - (32 rad)\"\nend = true\n\
    [start]\ntheta = 30\n[run]\nspan = \"9 s\"\n";

#[test]
fn an_angle_of_several_turns_is_told_by_its_place_and_the_event_that_ends_a_run_by_its_name() {
    let scene = temporary("warned.toml");
    std::fs::write(&scene, PENDULUM).expect("it can be written");
    let file = scene.to_string_lossy().into_owned();
    for command in [&["run"][..], &["derive"], &["prove"], &["linearise"]] {
        let output = run(&[command, &[file.as_str()]].concat());
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{message}");
        let place = format!("warning: {file}:15:9: 30 rad are 4.8 turns");
        assert!(message.contains(&place) && message.contains("\"30 deg\""), "{message}");
    }
    let members = "[ensemble]\nmembers = 2\n[ensemble.vary]\nstart.theta = { from = 20, to = \"30 deg\" }\n";
    let start = PENDULUM.replace("theta = 30", "theta = \"30 deg\"");
    let start = start.replace("[[event]]\nname = \"low\"\nwhen = \"theta - (32 rad)\"\nend = true\n", "");
    std::fs::write(&scene, start + members).expect("it can be written");
    let table = temporary("warned.csv");
    let output = run(&["ensemble", &file, "--out", &table.to_string_lossy()]);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.contains(": 20 rad are 3.2 turns") && message.contains("\"20 deg\""), "{message}");
    // 20 rad are more than 30 deg: nothing ran
    assert!(output.status.code() == Some(2) && !table.exists(), "{message}");
    std::fs::write(&scene, PENDULUM).expect("it can be written");
    let quiet = run(&["run", &file, "--quiet"]);
    assert!(quiet.stderr.is_empty(), "{}", String::from_utf8_lossy(&quiet.stderr));
    let text = String::from_utf8_lossy(&quiet.stdout).into_owned();
    let reached = text.lines().find(|line| line.starts_with("reached")).expect("it reaches its end");
    assert!(reached.contains("t = ") && reached.ends_with("s: the event `low` ends the run"), "{reached}");
    assert!(!text.contains("diagnosis"), "{text}");
    std::fs::remove_file(&scene).expect("it is there");
}

#[test]
fn a_file_that_names_no_system_is_led_to_one() {
    let scene = temporary("nameless.toml");
    let file = scene.to_string_lossy().into_owned();
    let told = |text: &str, command: &str, parts: &[&str]| {
        std::fs::write(&scene, text).expect("it can be written");
        let output = run(&[command, &file]);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert_eq!(message.matches("error:").count(), 1, "{message}");
        parts.iter().for_each(|part| assert!(message.contains(part), "{part}\n{message}"));
    };
    let ways = ["this file names no system", "[coordinates] names what moves", "`system = "];
    let without = PENDULUM.replace("[coordinates]\ntheta = \"rad\"\n", "");
    for command in ["run", "derive", "prove", "chart", "linearise", "reference"] {
        told(&without, command, &[&ways[..], &["nameless.toml:2:1"]].concat());
    }
    told(&PENDULUM.replace("[coordinates]", "[coordinate]"), "run", &["nameless.toml:3:2", "is `coordinates` meant?"]);
    told("title = \"Empty\"\n", "run", &["this file names no system", "`dalembert scenes` lists them"]);
    std::fs::remove_file(&scene).expect("it is there");
}

/// The crossing of 32 rad lies between two samples; a run that stops ends between two samples too.
#[test]
fn the_table_of_a_run_ends_where_the_run_ends() {
    let (scene, table) = (temporary("ends.toml"), temporary("ends.csv"));
    std::fs::write(&scene, PENDULUM.replace("theta = 30", "theta = \"30 rad\"")).expect("it can be written");
    let (file, out) = (scene.to_string_lossy().into_owned(), table.to_string_lossy().into_owned());
    let output = run(&["run", &file, "--samples", "3", "--format", "json", "--out", &out]);
    let found = json(&output);
    let text = std::fs::read_to_string(&table).expect("it was written");
    let last: Vec<f64> = text.lines().last().expect("rows").split(',').filter_map(|cell| cell.parse().ok()).collect();
    let end = found["time"].as_f64().expect("a number");
    assert!(last[0].to_bits() == end.to_bits() && end % 3.0 != 0.0, "{text}");
    assert!(found["state"]["theta"].as_f64().is_some_and(|theta| theta.to_bits() == last[1].to_bits()), "{text}");
    assert_eq!(text.lines().count(), 2 + 1 + (end / 3.0) as usize, "{text}");
    [scene, table].iter().for_each(|path| std::fs::remove_file(path).expect("it is there"));
}

/// A block that a limited drive pulls, with dry friction, a damping called c1 and a coordinate called f1.
const BLOCK: &str = "title = \"A block\"\n[parameters]\nm = \"2 kg\"\nc1 = \"3 N s/m\"\nF = \"4 N\"\n[coordinates]\nf1 = \"m\"\ny = \"m\"\n\
    [bodies.b]\ncentre = \"O + f1*N.x + y*N.y\"\nmass = \"m\"\n[[force]]\non = \"b\"\nis = \"(-c1*f1' - F*sign(f1'))*N.x\"\n\
    [[force]]\non = \"b\"\nis = \"min(F, F*sin(t*(2 rad/s)) + F*cos(t*(3 rad/s))*sin(t*(5 rad/s)))*N.x\"\n\
    [[constraint]]\nname = \"rail\"\nzero = \"y*N.y\"\n\
    [[event]]\nname = \"wall\"\nwhen = \"f1 - (1 m)\"\ndirection = \"up\"\nset = { \"f1'\" = \"-0.5*f1'\" }\nend = true\n\
    [start]\n\"f1'\" = \"1 m/s\"\n[run]\nspan = \"1 s\"\n";

#[test]
fn equations_say_what_their_conditions_are_and_what_they_leave_out() {
    let path = temporary("block.toml");
    std::fs::write(&path, BLOCK).expect("it is written");
    let file = path.display().to_string();
    let text = printed(&["derive", &file]);
    for line in [
        "Conditions; a bracket is 1 where its condition is positive, else 0",
        "  [f1' > 0]: condition 1 = f1', in m/s, line 14",
        "in N, line 17",
        "  constraint 1 `rail` along N.y: of positions",
        "  F1 = y",
        "A positive lambda acts along the gradient of F",
        "A condition that stays at zero, such as the speed of dry friction that sticks, is not part of these equations",
        "  event `wall` (line 21): where f1 - 1 passes zero upwards, f1' becomes -1/2*f1', the run ends",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    let bracket = text.lines().find(|line| line.starts_with("  [condition 2 > 0]: condition 2 = "));
    assert!(bracket.is_some_and(|line| line.contains("sin(2*t)")), "{text}");
    let latex = printed(&["derive", &file, "--format", "latex"]);
    for part in [r"\text{condition 2} &= ", r"0 = \mathbf{f}_{1} &= y \quad \text{along N.y}", "% Events are not part"]
    {
        assert!(latex.contains(part), "{part}\n{latex}");
    }
    printed(&["derive", &file, "--format", "mathml"]);
    for (format, sign) in [("python", "#"), ("sympy", "#"), ("c", "//"), ("rust", "//")] {
        let code = printed(&["derive", &file, "--format", format]);
        let event = format!("\n{sign}   event `wall` (line 21): where ");
        assert!(code.contains(&event) && code.contains("along N.y"), "{format}\n{code}");
    }
    std::fs::remove_file(&path).expect("it is there");
}

#[test]
fn the_place_of_what_a_command_cannot_take_is_shown() {
    let path = temporary("taken.toml");
    let file = path.display().to_string();
    std::fs::write(&path, BLOCK.replace("\"f1'\" = \"1 m/s\"\n", "")).expect("it is written");
    refused(&["linearise", &file], "taken.toml:14:20");
    std::fs::write(
        &path,
        BLOCK.to_owned()
            + "[ensemble]\nmembers = 2\n[ensemble.vary]\nparameters.m = { from = \"1 kg\", to = \"2 kg\" }\n",
    )
    .expect("it is written");
    refused(
        &["ensemble", &file, "--out", "none.csv"],
        "`ensemble` cannot run this system: its law or its start changes",
    );
    refused(&["ensemble", &file, "--out", "none.csv"], "taken.toml:21:1");
    refused(&["run", &file, "--method", "strang:1000"], "strang:1000 does not apply to");
    refused(&["inverse", &file, "--motion", "f1 = (1 m)*sin(tt)"], "--motion:1:16");
    refused(&["inverse", &file, "--motion", "f1 = 30 mm"], "30 mm");
    refused(&["inverse", &file, "--motion", "f1 = (1 s)"], "--motion:1:6");
    std::fs::remove_file(&path).expect("it is there");
}

#[test]
fn redundant_coordinates_are_called_so() {
    let said = |scene: &str| printed(&["chart", scene, "--seconds", "2"]);
    let (crank, pendulum) = (said("scenes/models/slider_crank.toml"), said("scenes/models/double_pendulum.toml"));
    assert!(crank.contains("redundant coordinates") && !crank.contains("minimal coordinates"), "{crank}");
    assert!(pendulum.contains("minimal coordinates"), "{pendulum}");
}

#[test]
fn a_completed_start_and_a_feedback_that_is_no_part_of_a_are_told() {
    let path = temporary("told.toml");
    let file = path.display().to_string();
    let tied = SPRING.replace("F = \"N\"", "F = \"1 N\"").replace("[coordinates]\n", "[coordinates]\ny = \"m\"\n");
    let tied = tied.replace(
        "[outputs]",
        "[[constraint]]\nzero = \"y - 2*x - (1 m)\"\n[start]\nx = \"0.25 m\"\ny = \"guess 1 m\"\n[outputs]",
    );
    std::fs::write(&path, &tied).expect("it is written");
    let text = printed(&["run", &file]);
    assert!(text.contains("start                completed: y = 1.500000000 m\n"), "{text}");
    let object = json(&run(&["run", &file, "--format", "json"]));
    assert_eq!(object["completed_start"], serde_json::json!({ "y": 1.5 }));
    let pushed = SPRING
        .replace("F = \"N\"\n", "")
        .replace("[[force]]", "[inputs]\nF = { unit = \"N\", value = \"-k*x\" }\n[[force]]");
    std::fs::write(&path, &pushed).expect("it is written");
    let said = String::from_utf8_lossy(&run(&["linearise", &file]).stderr).into_owned();
    assert!(said.contains("A does not hold the feedback by `F`"), "{said}");
    let timed = pushed.replace("-k*x\" }", "(1 N)*sin(t*(1 rad/s))\" }");
    std::fs::write(&path, &timed).expect("it is written");
    assert!(run(&["linearise", &file]).stderr.is_empty());
    std::fs::remove_file(&path).expect("it is there");
}
