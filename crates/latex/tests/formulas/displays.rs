//! Displays with several lines and double signs are split into formulas.

use dalembert_latex::formulas;

fn parts(text: &str) -> Vec<(String, String)> {
    let squeezed = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let found = formulas(text).unwrap_or_else(|fault| panic!("{fault}"));
    for part in &found {
        assert!(part.start + part.text.len() <= text.len());
    }
    found.into_iter().map(|part| (part.name, squeezed(&part.text))).collect()
}

fn told(parts: &[(String, String)]) -> Vec<(&str, &str)> {
    parts.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect()
}

#[test]
fn lines_are_formulas_of_their_own() {
    let found = parts(r"\begin{aligned} m \ddot{x} &= F, \\ m \ddot{y} &= -m g. \end{aligned}");
    assert_eq!(told(&found), [("1", r"m \ddot{x} = F"), ("2", r"m \ddot{y} = -m g")]);
    let found = parts(r"a = b \\ c = d \tag{5}");
    assert_eq!(told(&found), [("1", "a = b"), ("2", "c = d")]);
}

#[test]
fn a_line_that_begins_with_a_relation_or_a_term_goes_on() {
    let found = parts(r"\begin{split} a &= b \\ &= c + \\ &\quad d \end{split}");
    assert_eq!(told(&found), [("", r"a = b = c + \quad d")]);
    let found = parts(r"\begin{multline} a = b \\ - c \end{multline}");
    assert_eq!(told(&found), [("", "a = b - c")]);
}

#[test]
fn a_matrix_keeps_its_lines() {
    let text = r"\begin{pmatrix} a & b \\ c & d \end{pmatrix} x = 0";
    assert_eq!(told(&parts(text)), [("", text)]);
    let found = parts(&format!(r"\begin{{equation}} {text} \end{{equation}}"));
    assert_eq!(told(&found), [("", text)]);
}

#[test]
fn double_signs_are_two_formulas() {
    let found = parts(r"x = a \pm b \mp c");
    assert_eq!(told(&found), [("upper", "x = a + b - c"), ("lower", "x = a - b + c")]);
    let found = parts(r"\begin{align} x &= \pm a \\ y &= b \end{align}");
    assert_eq!(told(&found), [("1/upper", "x = + a"), ("1/lower", "x = - a"), ("2", "y = b")]);
}

#[test]
fn places_are_those_of_the_display() {
    let text = r"\begin{aligned} a &= b \\ c &= d \end{aligned}";
    let found = formulas(text).expect("it is taken apart");
    let second = &found[1];
    let at = second.start + second.text.find('d').expect("it has the letter");
    assert_eq!(&text[at..=at], "d");
}

#[test]
fn a_line_with_a_sign_and_a_relation_is_asked_for() {
    let text = r"a = b \\ - c = d";
    let fault = formulas(text).expect_err("it has two readings");
    assert_eq!(&text[fault.span], "-");
    assert!(fault.title.contains("goes on with the line before"), "{}", fault.title);
}

#[test]
fn a_display_without_a_formula_is_no_formula() {
    for text in [r"\begin{aligned} \end{aligned}", r"\\", r"\begin{aligned} \\ & \end{aligned}", ""] {
        assert_eq!(told(&parts(text)), [("", text.trim())], "{text}");
    }
}
