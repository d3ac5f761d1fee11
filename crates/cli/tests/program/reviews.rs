//! `review` of files: changed terms of equations, steady motions, runs and claims.

use super::{json, run, temporary};
use std::path::PathBuf;

const CART: &str = "title = \"A cart with a pendulum\"\ngravity = \"-g*N.y\"\n[parameters]\nM = \"2 kg\"\nm = \"1 kg\"\nl = \"0.5 m\"\ng = \"9.81 m/s^2\"\n\
    k = \"20 N/m\"\nd = \"0.3 N s/m\"\n[coordinates]\nx = \"m\"\ntheta = \"rad\"\n[frames]\nB = \"N turned theta about z\"\n[points]\n\
    A = \"O + x*N.x\"\nP = \"A - l*B.y\"\n[bodies]\ncart = { centre = \"A\", mass = \"M\" }\nbob = { centre = \"P\", mass = \"m\" }\n[[force]]\non = \"cart\"\n\
    is = \"(-k*x - d*x')*N.x\"\n[start]\ntheta = \"0.3 rad\"\n[run]\nspan = \"2 s\"\n";

fn written(name: &str, text: &str) -> (PathBuf, String) {
    let file = temporary(name);
    std::fs::write(&file, text).expect("it can be written");
    let path = file.to_string_lossy().into_owned();
    (file, path)
}

#[test]
fn a_term_of_another_sign_is_told_with_the_motions_and_the_run_that_moved() {
    let (old, before) = written("review_old.toml", CART);
    let (new, now) = written("review_new.toml", &CART.replace("(-k*x - d*x')", "(k*x)").replace("2 kg", "3 kg"));
    let output = run(&["review", &now, "--against", &before, "--range", "x=-1..1"]);
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(output.status.code(), Some(0), "{told}");
    assert!(told.contains("equation of x:"), "{told}");
    assert!(told.contains("sign turned: -k*x") && told.contains("lost: d*x'"), "{told}");
    assert!(told.contains("asymptotically stable before") && told.contains("unstable now"), "{told}");
    assert!(told.contains("x: ") && told.contains("apart at t = "), "{told}");
    assert!(told.contains("M: 2 kg before, 3 kg now"), "{told}");
    // one equation, equal by every principle
    assert!(told.contains("equations, by virtual-power, lagrange, ") && told.contains("newton-euler"), "{told}");
    let same = run(&["review", &before, "--against", &before]);
    assert!(String::from_utf8_lossy(&same.stdout).contains("no equation, run or other entry differs"));
    [old, new].iter().for_each(|file| std::fs::remove_file(file).expect("it is there"));
}

#[test]
fn a_coordinate_with_another_name_is_told_as_renamed() {
    let text = CART.replace("x = \"m\"", "s = \"m\"").replace("x*N", "s*N").replace("k*x - d*x'", "k*s - d*s'");
    let (old, before) = written("review_x.toml", CART);
    let (new, now) = written("review_s.toml", &text);
    let output = run(&["review", &now, "--against", &before]);
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(told.contains("x: s now, and the same in its equation"), "{told}");
    assert!(!told.contains("equation of s: new") && !told.contains("s: a new column"), "{told}");
    [old, new].iter().for_each(|file| std::fs::remove_file(file).expect("it is there"));
}

#[test]
fn a_claim_whose_formula_is_broken_is_told_with_its_verdict_and_correction() {
    let paper = CART.split("[[force]]").next().expect("a beginning").to_owned()
        + "[letters]\n'm' = \"m\"\n'M' = \"M\"\n'l' = \"l\"\n'g' = \"g\"\n'x' = \"x\"\n'\\theta' = \"theta\"\n[[claim]]\nequation = \"1\"\nkind = \"equation of motion\"\n\
        formula = '\\ddot{x} \\cos\\theta + l \\ddot{\\theta} + g \\sin\\theta = 0'\n";
    let (old, before) = written("paper_old.toml", &paper);
    let (new, now) = written("paper_new.toml", &paper.replace("+ g \\sin", "- g \\sin"));
    let found = json(&run(&["review", &now, "--against", &before, "--format", "json"]));
    let told = found.to_string();
    assert!(told.contains("proved before, refuted now") && told.contains("correction: none before"), "{told}");
    [old, new].iter().for_each(|file| std::fs::remove_file(file).expect("it is there"));
}

#[test]
fn a_paper_is_compared_with_its_system_and_a_system_with_no_paper() {
    let [paper, scene] = ["papers/cart_pole.toml", "scenes/foreign/pushed_cart_pole.toml"];
    let same = run(&["review", paper, "--against", paper]);
    let told = String::from_utf8_lossy(&same.stdout).into_owned();
    assert!(same.status.code() == Some(0) && told.contains("no equation, run or other entry differs"), "{told}");
    let mixed = run(&["review", paper, "--against", scene]);
    let why = String::from_utf8_lossy(&mixed.stderr).into_owned();
    assert!(mixed.status.code() == Some(2) && why.contains("two systems, or two papers, are accepted"), "{why}");
}

#[test]
fn a_file_that_no_commit_has_is_refused_with_what_is_accepted() {
    let (file, path) = written("no_commit.toml", CART);
    let output = run(&["review", &path, "--against", "nowhere"]);
    let why = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        output.status.code() == Some(2) && why.contains("the file is not in a git repository; give --against FILE"),
        "{why}"
    );
    std::fs::remove_file(file).expect("it is there");
}

#[test]
fn a_claim_that_cannot_be_read_leaves_the_others_reviewed() {
    let claim = |number: u32, formula: &str| {
        format!("[[claim]]\nequation = \"{number}\"\nkind = \"formula\"\nformula = '{formula}'\n")
    };
    let paper = |formulas: [&str; 2]| {
        let head = CART.split("[[force]]").next().expect("a beginning");
        let letters = "[letters]\n'm' = \"m\"\n'V' = \"potential_energy\"\n'T' = \"kinetic_energy\"\n";
        format!("{head}{letters}{}{}", claim(1, formulas[0]), claim(2, formulas[1]))
    };
    let (old, before) = written("faults_old.toml", &paper(["T = T", "V = V"]));
    let (new, now) = written("faults_new.toml", &paper(["T = 2 T", "V = q"]));
    let output = run(&["review", &now, "--against", &before]);
    let (told, faults) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert_eq!(output.status.code(), Some(2), "{told}{faults}");
    assert!(told.contains("proved before, refuted now"), "{told}");
    assert!(told.contains("proved before, not read now: unknown letter `q`"), "{told}");
    assert!(faults.contains("V = q"), "{faults}");
    [old, new].iter().for_each(|file| std::fs::remove_file(file).expect("it is there"));
}

/// A stop makes cases of the law: its steady motions are those of `stationary`, and the early end of a run is reported.
#[test]
fn steady_motions_in_cases_of_a_law_and_the_end_of_a_run_are_compared() {
    let law = "title = \"A mass at a stop\"\n[coordinates]\nx = \"m\"\n[bodies.b]\ncentre = \"O + x*N.x\"\nmass = \"(1 kg)\"\n[[force]]\non = \"b\"\n\
        is = \"(-(3 N/m)*x + (2 N/m)*max(0, x - (0.1 m)) + (1 N))*N.x\"\n[[event]]\nwhen = \"x - (2 m)\"\nend = true\n[start]\n\"x'\" = \"0 m/s\"\n[run]\nspan = \"2 s\"\n";
    let (old, before) = written("review_stop.toml", law);
    let (new, now) = written("review_stop_now.toml", &law.replace("3 N/m", "4 N/m").replace("0 m/s", "9 m/s"));
    let output = run(&["review", &now, "--against", &before, "--range", "x=-1..2"]);
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    let warned = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!warned.contains("not compared"), "{warned}");
    // x = 0.8 m where 3 x = 2 (x - 0.1) + 1; x = 0.4 m where 4 x = 2 (x - 0.1) + 1
    assert!(told.contains("x = 0.8 m") && told.contains("x = 0.4 m"), "{told}");
    assert!(told.contains("the run reaches t = 2 s before; it reaches t = 0.2"), "{told}");
    [old, new].iter().for_each(|file| std::fs::remove_file(file).expect("it is there"));
}

#[test]
fn a_parameter_without_a_value_leaves_the_equations_compared() {
    let open = CART.replace("k = \"20 N/m\"", "k = \"N/m\"");
    let (old, before) = written("review_open.toml", &open);
    let (new, now) = written("review_open_now.toml", &open.replace("-k*x", "k*x"));
    let output = run(&["review", &now, "--against", &before]);
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(told.contains("sign turned: -k*x"), "{told}");
    [old, new].iter().for_each(|file| std::fs::remove_file(file).expect("it is there"));
}
