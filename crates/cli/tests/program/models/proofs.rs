//! Verdicts that `prove` prints.

use super::{MODEL, printed};
use crate::{json, root, run, temporary};

/// Quasi-velocities are chosen such that no divisor of a proof vanishes at the initial state of the file.
#[test]
fn divisors_of_a_proof_do_not_vanish_at_the_start() {
    let path = temporary("divisors.toml");
    let file = path.display().to_string();
    let at = |psi: &str| {
        let text = std::fs::read_to_string(root().join("scenes/models/chaplygin_sleigh.toml")).expect("it is there");
        let start = text.lines().find(|line| line.starts_with("[start]")).expect("it has a start");
        std::fs::write(&path, text.replace(start, &format!("[start]\n{psi}")).replace("\"1 m/s\"", "\"guess 1 m/s\""))
            .expect("it is written");
        printed(&["prove", &file])
    };
    let divisors = "equal for all values for which none of these vanishes:";
    let (apart, across) = (at("psi = \"0.3 rad\""), at("psi = \"90 deg\""));
    std::fs::remove_file(&path).expect("it is there");
    assert!(apart.contains(&format!("{divisors} cos(psi) (true at the start)")), "{apart}");
    assert!(across.contains(&format!("{divisors} sin(psi) (true at the start)")), "{across}");
}

/// Divisors of free frames have names, a long list is printed once, and a nonzero constant such as pi is not listed.
#[test]
fn divisors_are_named_and_a_long_list_stands_once() {
    let path = temporary("named_divisors.toml");
    let text = "title = \"A plate on a spring\"\n[parameters]\nk = \"40 N/m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n[frames]\nF = \"N free\"\n\
        [points]\nG = \"O + x*N.x + y*N.y + z*N.z\"\nA = \"G + (0.5 m)*F.x + (0.433 m)*F.y\"\n[bodies.plate]\nframe = \"F\"\ncentre = \"G\"\nmass = \"(2 kg)\"\n\
        inertia = { principal = [\"(0.12 kg m^2)\", \"(0.15 kg m^2)\", \"(0.27 kg m^2)\"] }\n[[constraint]]\nname = \"rail\"\nzero = \"(A - O) . N.z\"\n\
        [[force]]\nbetween = [\"ground at O - (1 m)*N.x\", \"plate at A\"]\nis = \"-k*(distance(O - (1 m)*N.x, A) - (0.8 m))\"\n";
    std::fs::write(&path, text).expect("it is written");
    let proved = printed(&["prove", &path.display().to_string()]);
    std::fs::remove_file(&path).expect("it is there");
    assert!(!proved.contains("F.q0^2"), "{proved}");
    let first = proved.lines().next().unwrap_or_default();
    let length = "the length in a distance, a norm or a force `between`";
    assert!(first.contains("|F.q|^2") && first.contains(length), "{proved}");
    assert!(proved.lines().all(|line| line.len() < 400), "{proved}");
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

/// Standard error announces each long step, unless `--quiet` is given.
#[test]
fn long_judgements_are_told_before_they_begin() {
    let told = |arguments: &[&str]| String::from_utf8_lossy(&run(arguments).stderr).into_owned();
    let bicycle = told(&["prove", "scenes/foreign/bicycle.toml"]);
    assert!(bicycle.starts_with("energy: normal forms of 2278 operations; about "), "{bicycle}");
    assert_eq!(told(&["prove", "scenes/foreign/bicycle.toml", "--quiet"]), "");
    assert_eq!(told(&["prove", MODEL]), "");
}

/// A rolling disc: every line has a verdict, and a common error about the disc is refuted.
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
        none.status.code() != Some(0) && message.contains("the system has no constraint that contains speeds"),
        "{message}"
    );
}
