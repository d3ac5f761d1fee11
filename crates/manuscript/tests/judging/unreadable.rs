//! A formula that cannot be read does not prevent verdicts on the other claims.

use crate::PENDULUM;
use dalembert_manuscript::{PaperFindings, PaperText};

fn findings(formulas: &[&str]) -> PaperFindings {
    let claim = |(place, formula): (usize, &&str)| {
        format!("[[claim]]\nequation = \"{}\"\nkind = \"formula\"\nformula = '{formula}'\n", place + 1)
    };
    let text = format!("{PENDULUM}\n{}", formulas.iter().enumerate().map(claim).collect::<String>());
    let paper = PaperText::parse("paper.toml".as_ref(), text).unwrap_or_else(|error| panic!("{error}"));
    paper.findings(false, |_| (), || true).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_other_claims_have_their_verdicts_and_corrections() {
    let found = findings(&[
        r"T = \frac12 m l^2 \dot\theta^2",
        r"T = m \sin \theta l",
        r"T = m l^2 \dot\theta^2",
        r"\begin{aligned} T = 0 \\ - V = 0 \end{aligned}",
    ]);
    let verdicts: Vec<&str> = found.findings.iter().map(|finding| finding.judged.verdict.name()).collect();
    assert_eq!(verdicts, ["proved", "refuted"]);
    assert!(!found.findings[1].corrections.is_empty());
    let ids: Vec<&str> = found.unjudged.iter().map(|claim| claim.id.as_str()).collect();
    assert_eq!(ids, ["paper/eq2", "paper/eq4"]);
    assert!(found.unjudged[0].fault.contains(r"the argument of `\sin` ends"), "{}", found.unjudged[0].fault);
    let told = found.error.expect("two claims were not read").to_string();
    assert!(told.contains(r"T = m \sin \theta l") && told.contains("^^^^"), "{told}");
}

#[test]
fn a_hypothesis_that_cannot_be_read_is_the_fault_of_its_claim() {
    let text = format!(
        "{PENDULUM}\n[[claim]]\nequation = \"1\"\nkind = \"formula\"\nformula = 'T = 0'\ngiven = ['m ==']\n\
         [[claim]]\nequation = \"2\"\nkind = \"formula\"\nformula = 'T = 0'\n"
    );
    let paper = PaperText::parse("paper.toml".as_ref(), text).unwrap_or_else(|error| panic!("{error}"));
    let found = paper.findings(false, |_| (), || true).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((found.findings.len(), found.unjudged.len()), (1, 1));
    assert!(found.whole().is_err());
}

#[test]
fn a_fault_of_a_table_is_that_of_its_claim() {
    let claim = |number: &str, kind: &str, formula: &str| {
        format!("[[claim]]\nequation = \"{number}\"\nkind = \"{kind}\"\nformula = '{formula}'\n")
    };
    let text = [
        PENDULUM.to_owned(),
        claim("1", "formula", ""),
        claim("2", "steady motion", r"\sin\theta = 0"),
        claim("3", "formula", "V = V"),
        claim("3", "formula", "T = T"),
        claim("4", "equality", "T = T"),
        claim("5", "formula", "T = T") + "givn = ['m > 0']\n",
        claim("6", "formula", "0^0 = 1"),
        claim("7", "formula", "T = T"),
    ];
    let paper = PaperText::parse("paper.toml".as_ref(), text.concat()).unwrap_or_else(|error| panic!("{error}"));
    let found = paper.findings(false, |_| (), || true).unwrap_or_else(|error| panic!("{error}"));
    let judged: Vec<&str> = found.findings.iter().map(|finding| finding.judged.id.as_str()).collect();
    assert_eq!(judged, ["paper/eq3", "paper/eq7"]);
    let faults: Vec<(&str, &str)> =
        found.unjudged.iter().map(|claim| (claim.id.as_str(), claim.fault.as_str())).collect();
    for (id, fault) in [
        ("paper/eq1", "`formula` is empty"),
        ("paper/eq2", "the letters that rest on the motion are not named"),
        ("paper/eq3", "two claims have the name `eq3`"),
        ("paper/eq4", "no kind of claim is called `equality`"),
        ("paper/eq5", "`givn`"),
        ("paper/eq6", "zero to the power zero has no value"),
    ] {
        assert!(faults.iter().any(|(known, told)| *known == id && told.contains(fault)), "{id}: {faults:?}");
    }
    let told = found.error.expect("six claims were not read").to_string();
    assert!(told.contains("0^0") && told.contains("^^^"), "{told}");
}
