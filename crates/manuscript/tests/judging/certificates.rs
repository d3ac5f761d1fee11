//! Certificates: the equations of the model, the steps from them to a verdict, and the sides as they were read.

use crate::PENDULUM;
use claims::certificate::{Certificate, PartProof, Step};
use dalembert_manuscript::PaperText;
use std::path::Path;

/// The certificate of a claim on the pendulum.
fn certificate(kind: &str, formula: &str, more: &str) -> Certificate {
    let text = format!("{PENDULUM}\n[[claim]]\nequation = \"1\"\nkind = \"{kind}\"\nformula = '{formula}'\n{more}\n");
    let paper = PaperText::parse(Path::new("paper.toml"), text).unwrap_or_else(|error| panic!("{error}"));
    let found = paper.certify_each(|_| (), || true).unwrap_or_else(|error| panic!("{error}"));
    found[0].certificate.clone().expect("it was asked for")
}

#[test]
fn an_equation_of_motion_follows_from_that_of_the_model() {
    let found = certificate("equation of motion", r"l \ddot{\theta} + g \sin\theta = 0", "");
    let [part] = &found.parts[..] else { panic!("{found:?}") };
    let [Step::Solve { letters, by, .. }] = &part.steps[..] else { panic!("{:?}", part.steps) };
    assert_eq!((letters.len(), &by[..], &part.proof), (1, &[0][..], &PartProof::Identity));
    assert_eq!((found.verdict.as_str(), part.given.len(), part.then[0].is), ("proved", 1, "="));
}

#[test]
fn a_false_equation_has_a_point_and_its_correction_has_a_proof() {
    let found = certificate("equation of motion", r"l \ddot{\theta} - g \sin\theta = 0", "");
    assert_eq!(found.verdict, "refuted");
    let is_point = |proof: &PartProof| matches!(proof, PartProof::Counterexample { point } if !point.is_empty());
    assert!(found.parts.iter().all(|part| is_point(&part.proof)), "{found:?}");
}

#[test]
fn an_integral_states_a_rate_and_a_number_its_last_digit() {
    let energy = certificate("integral of motion", r"T + V = \mathrm{const}", "");
    let part = &energy.parts[0];
    assert_eq!((part.then[0].is, &part.proof), ("rate", &PartProof::Identity));
    assert!(part.rates.len() >= 2, "{:?}", part.rates);
    let data = r"given = ['l = 1', 'g = 9.81', '\theta = 0.5', 'm = 1']";
    let number = certificate("number", r"\ddot{\theta} = -4.703", data);
    assert_eq!((number.verdict.as_str(), &number.parts[0].proof), ("enclosed", &PartProof::Enclosure));
}

#[test]
fn a_verdict_without_a_certificate_says_why() {
    // 0.25 is as far from 0.2 as from 0.3
    let tie = certificate("number", "h = 0.3", "given = ['l = 0.125']");
    assert!(tie.parts.is_empty() && tie.none.is_some(), "{tie:?}");
}
