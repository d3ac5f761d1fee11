//! Errors of a paper, each with its line.

use crate::{PENDULUM, refused};

fn claim(formula: &str) -> String {
    format!("{PENDULUM}\n[[claim]]\nequation = \"1\"\nkind = \"formula\"\nformula = {formula}\n")
}

#[test]
fn a_formula_with_two_readings_is_shown_with_a_caret() {
    let told = refused(&claim(r"'T = m \sin \theta l'"));
    assert!(told.contains(r"it is not clear where the argument of `\sin` ends"), "{told}");
    assert!(told.contains(r"formula = 'T = m \sin \theta l'") && told.contains("^^^^"), "{told}");
    let told = refused(&claim(r"'T = k l'"));
    assert!(told.contains("unknown letter `k`") && told.contains("declared letters: m, l, g"), "{told}");
    // in a string with escapes the whole formula is marked
    let told = refused(&claim(r#""T = \\sin \\theta l""#));
    assert!(told.contains("argument of"), "{told}");
}

#[test]
fn every_fault_of_a_file_is_told_at_once() {
    let told = refused(&format!(
        "{}{}",
        claim("'T = k'"),
        "\n[[claim]]\nequation = \"2\"\nkind = \"formula\"\nformula = 'V = n'\n"
    ));
    assert!(told.contains("`k`") && told.contains("`n`"), "{told}");
}

#[test]
fn meanings_are_expressions_of_the_model() {
    let told = refused(&claim("'T = 0'").replace("'h' = \"2*l\"", "'h' = \"2*length\""));
    assert!(told.contains("length") && told.contains("'h' = "), "{told}");
    let told = refused(&claim("'T = 0'").replace("'h' = \"2*l\"", "'h' = \"l + m\""));
    assert!(told.contains("'h' = \"l + m\""), "{told}");
    let told = refused(&claim("'T = 0'").replace("'h' =", "'h + l' ="));
    assert!(told.contains("`h + l` is no letter"), "{told}");
    let told = refused(&claim("'T = 0'").replace("'h' =", r"'\dot{\theta}' ="));
    assert!(told.contains("a rate is known by itself"), "{told}");
    let told = refused(&claim("'T = 0'").replace("'h' =", "'m_1' = \"m\"\n'm_{1}' ="));
    assert!(told.contains("are one letter"), "{told}");
}

#[test]
fn claims_have_a_kind_and_names_of_their_own() {
    let told = refused(&claim("'T = 0'").replace("\"formula\"", "\"formulla\""));
    assert!(told.contains("no kind of claim") && told.contains("is `formula` meant"), "{told}");
    let told = refused(&format!(
        "{}{}",
        claim("'T = 0'"),
        "\n[[claim]]\nequation = \"1\"\nkind = \"formula\"\nformula = 'V = 0'\n"
    ));
    assert!(told.contains("two claims have the name `eq1`"), "{told}");
    let told = refused(PENDULUM);
    assert!(told.contains("states no claim"), "{told}");
    let told = refused(&claim("'T'"));
    assert!(told.contains("one side"), "{told}");
    let told = refused(&claim("'T > 0'"));
    assert!(told.contains("inequality"), "{told}");
    let told = refused(&claim("'T = 0'").replace("\"formula\"", "\"equation of motion\""));
    assert!(told.contains("no acceleration"), "{told}");
}

#[test]
fn hypotheses_are_solved_or_refused() {
    let with = |given: &str| refused(&(claim("'T = 0'") + given));
    assert!(with("given = ['g = 1', 'g = 2']").contains("contradicts"));
    assert!(with(r"given = ['\sin\theta = 0']").contains("linear in none of its letters"));
    assert!(with("given = ['m']").contains("two sides"));
}

#[test]
fn the_system_of_a_paper_is_a_file_that_is_there() {
    let told = refused(
        "title = \"x\"\nmodel = \"nowhere.toml\"\n[letters]\n'm' = \"m\"\n[[claim]]\nequation = \"1\"\nkind = \"formula\"\nformula = 'm = 1'\n",
    );
    assert!(told.contains("nowhere.toml") && told.contains("there is no such file"), "{told}");
    let told = refused(&claim("'T = 0'").replace("[points]", "[point]"));
    assert!(told.contains("point"), "{told}");
}
