//! A system that is written in its file, as its users meet it.

use crate::{json, run, temporary};

const MODEL: &str = "scenes/models/double_pendulum.toml";

#[test]
fn every_principle_and_notation_gives_the_equations() {
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
    assert!(table.contains("0.0,A,x',x,-9.0") && table.contains("0.0,B,x',F,0.5"), "{table}");
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

#[test]
fn forces_for_a_motion_are_printed_or_refused_with_the_rank() {
    let crank = "scenes/models/slider_crank.toml";
    let motion = ["inverse", crank, "--motion", "theta = 0.3*sin(t*(5 rad/s))", "--samples", "4"];
    let table = printed(&[&motion[..], &["--unknown", "T"]].concat());
    assert_eq!(table.lines().count(), 6);
    assert!(table.starts_with("time,theta,phi,s,theta',") && table.contains(",T,lambda1,lambda2"), "{table}");
    refused(&motion, "2 of 3 equations (the rank): underactuated");
    refused(&["inverse", crank, "--motion", "theta"], "a coordinate and an expression of t");
    refused(&["inverse", crank, "--motion", "omega = t/(1 s)"], "no coordinate has this name");
    refused(&["inverse", crank, "--motion", "theta = 2*q"], "a prescribed motion");
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
    for command in ["ensemble", "bodies", "stationary", "regimes", "motor"] {
        let output = run(&[command, MODEL]);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{command}: {message}");
        assert!(message.contains("does not read a system that is written in its file"), "{command}: {message}");
    }
}
