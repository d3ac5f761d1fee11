//! Certificates: the equations of the model, the steps from them to a verdict, and the sides as written in the paper.

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
    // 0.25 is equally far from 0.2 and 0.3
    let tie = certificate("number", "h = 0.3", "given = ['l = 0.125']");
    assert!(tie.parts.is_empty() && tie.none.is_some(), "{tie:?}");
}

#[test]
fn an_inequality_by_squares_has_its_sum_of_squares() {
    for (formula, more) in [
        (r"m^2 + l^2 \geq 2 m l", ""),
        (r"m^2 - m l + l^2 \geq 0", ""),
        (r"\theta^2 - 2 \theta + 2 > 0", ""),
        (r"m^4 - m^2 l^2 + l^4 \geq 0", ""),
        (r"\frac{1}{m^2} > 0", ""),
        (r"m > l", "given = ['m > 2 l', 'l > 0']"),
        (r"\frac{g}{m} \geq \frac{l^2}{4 m^2}", r"given = ['l^2 \leq 4 g m', 'm > 0']"),
    ] {
        let found = certificate("inequality", formula, more);
        let proofs: Vec<&PartProof> = found.parts.iter().map(|part| &part.proof).collect();
        let is_shown = matches!(proofs[..], [PartProof::Identity, PartProof::WrittenSigns] | [PartProof::Signs { .. }]);
        assert_eq!((found.verdict.as_str(), is_shown), ("proved", true), "{formula}: {proofs:?} {:?}", found.none);
    }
}

#[test]
fn a_linearised_equation_has_its_first_derivatives() {
    let rest = r"resting = ['\theta']
given = ['\theta = 0']";
    let found = certificate("linearised equation", r"l \ddot\theta + g \theta = 0", rest);
    let kinds: Vec<&str> = found.parts.iter().map(|part| part.then[0].is).collect();
    assert_eq!((found.verdict.as_str(), &kinds[..]), ("proved", &["=", "=", "rate"][..]), "{found:?}");
    let found = certificate("linearised equation", r"l \ddot\theta - g \theta = 0", rest);
    assert_eq!((found.verdict.as_str(), found.parts.len()), ("refuted", 1), "{found:?}");
    assert!(matches!(found.parts[0].proof, PartProof::Counterexample { .. }));
    let upright = r"resting = ['\theta']
given = ['\theta = \pi']";
    let found = certificate("linearised equation", r"l \ddot\theta - g (\theta - \pi) = 0", upright);
    assert_eq!((found.verdict.as_str(), found.parts.len()), ("proved", 3), "{found:?}");
}

#[test]
fn an_inequality_with_roots_has_its_products_and_one_in_one_unknown_its_real_roots() {
    for (formula, more) in [
        (r"\sqrt{\theta} < \theta", r"given = ['\theta > 1']"),
        (r"\sqrt{1 - \theta^2} \leq 1", ""),
        (r"m < l", r"given = ['\sqrt{m} < \sqrt{l}']"),
    ] {
        let found = certificate("inequality", formula, more);
        let is_product = matches!(&found.parts[..], [part] if matches!(part.proof, PartProof::Products { .. }));
        assert_eq!((found.verdict.as_str(), is_product), ("proved", true), "{formula}: {found:?}");
    }
    for (formula, more) in
        [(r"\theta^3 - 3 \theta + 3 > 0", r"given = ['\theta > -2.1']"), (r"\frac{1}{\cos^2\theta} \geq 1", "")]
    {
        let found = certificate("inequality", formula, more);
        let is_by_roots = matches!(&found.parts[..], [part] if part.proof == PartProof::RealRoots);
        assert_eq!((found.verdict.as_str(), is_by_roots), ("proved", true), "{formula}: {found:?}");
    }
}

#[test]
fn a_minimum_of_the_energy_has_its_minors_and_their_signs() {
    let system = PENDULUM
        .replace("theta = \"rad\"\n", "theta = \"rad\"\nphi = \"rad\"\n")
        .replace("[bodies.bob]", "[bodies.other]\ncentre = \"P - l*B.y\"\nmass = \"m\"\n[bodies.bob]")
        .replace("[points]", "B = \"N turned phi about z\"\n[points]")
        .replace("[letters]", "[letters]\n'\\varphi' = \"phi\"");
    let claim = r"
[[claim]]
equation = '1'
kind = 'stability'
formula = 'g > 0'
resting = ['\theta', '\varphi']
given = ['\theta = 0', '\varphi = 0', 'm > 0', 'l > 0']
";
    let paper = PaperText::parse(Path::new("paper.toml"), format!("{system}{claim}"));
    let paper = paper.unwrap_or_else(|error| panic!("{error}"));
    let found = paper.certify_each(|_| (), || true).unwrap_or_else(|error| panic!("{error}"));
    let certificate = found[0].certificate.clone().expect("it was asked for");
    let [part] = &certificate.parts[..] else { panic!("{certificate:?}") };
    let PartProof::Minimum(minimum) = &part.proof else { panic!("{certificate:?}") };
    assert_eq!((minimum.inertia.len(), minimum.leading.len(), minimum.principal.len()), (2, 2, 3));
    assert_eq!(minimum.implied.len(), 5);
}
