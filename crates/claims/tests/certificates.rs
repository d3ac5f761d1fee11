//! Certificates can be checked without the library of expressions: the evaluator below shows that both sides of a proved claim are equal
//! at a chosen point, and that the sides of a refuted claim differ at the point of the certificate.

use dalembert_claims::certificate::{Certificate, Operation, Part, PartProof};
use dalembert_claims::{Condition, Line, Page};
use field::{Analytic, Rational, Scalar};
use std::collections::HashMap;
use symbolic::{Hypotheses, Sym, symbols};

/// The certificates of a page with one claim, which `write` adds.
fn certificates(write: impl FnOnce(&mut Page)) -> Vec<Certificate> {
    let mut page = Page::of("test", |_| None);
    write(&mut page);
    page.certified(|_| true).flat_map(|(_, certificates)| certificates).collect()
}

/// The values of all entries; an entry without a value in `point` has a rational number chosen by its position.
fn values(program: &[Operation], point: &HashMap<usize, Rational>) -> Vec<Rational> {
    let mut values: Vec<Rational> = Vec::new();
    for (place, operation) in program.iter().enumerate() {
        let value = match operation {
            Operation::Constant(text) => {
                let mut parts = text.split('/').map(|part| part.parse().unwrap_or(0));
                Rational::new(parts.next().unwrap_or(0), parts.next().unwrap_or(1))
            }
            Operation::Binary("+", a, b) => values[*a] + values[*b],
            Operation::Binary("-", a, b) => values[*a] - values[*b],
            Operation::Binary("*", a, b) => values[*a] * values[*b],
            Operation::Binary(_, a, b) => values[*a] / values[*b],
            Operation::Unary("neg", a) => -values[*a],
            Operation::Power(a, exponent) => num_traits::pow(values[*a], *exponent as usize),
            _ => point.get(&place).copied().unwrap_or(Rational::new(2 + place as i64, 3)),
        };
        values.push(value);
    }
    values
}

/// Whether the two sides of each conclusion are equal at the point.
fn agree(program: &[Operation], part: &Part, point: &HashMap<usize, Rational>) -> bool {
    let values = values(program, point);
    part.then.iter().all(|relation| values[relation.left] == values[relation.right])
}

#[test]
fn sides_that_are_proved_to_agree_do_in_the_program() {
    let [a, b] = symbols(["a", "b"]);
    let square = (a + b).powi(2);
    let written = a * a + Sym::int(2) * a * b + b * b;
    let all = certificates(|page| {
        page.claim("eq1", "square", "a square").holds([Line::formula(square, Sym::symbol("s"), written)]);
    });
    let part = &all[0].parts[0];
    assert_eq!((all[0].verdict.as_str(), &part.proof), ("proved", &PartProof::Identity));
    assert!(agree(&all[0].program, part, &HashMap::new()));
    // the certificate has the sides as they were recorded, not their common normal form
    assert_ne!(part.then[0].left, part.then[0].right);
}

#[test]
fn a_false_claim_has_no_identity_but_a_point_at_which_its_sides_differ() {
    let [a, b] = symbols(["a", "b"]);
    let point = Sym::symbol("x").circle();
    let all = certificates(|page| {
        let wrong = Line::formula(a * point.cos + b, Sym::symbol("s"), a * point.cos - b);
        page.claim("eq1", "sign", "a sign").fails([wrong]);
        page.claim("eq1", "right", "the same").holds([Line::formula(a * b, Sym::symbol("s"), b * a)]);
        page.correct();
    });
    assert_eq!(all.iter().map(|one| one.verdict.as_str()).collect::<Vec<_>>(), ["refuted", "proved"]);
    assert_eq!(all[1].id, "test/eq1/right (correction)");
    let [part] = &all[0].parts[..] else { panic!("one part refutes") };
    let PartProof::Counterexample { point } = &part.proof else { panic!("{:?}", part.proof) };
    let constants = values(&all[0].program, &HashMap::new());
    let point = point.iter().map(|&(leaf, value)| (leaf, constants[value])).collect();
    assert!(!agree(&all[0].program, part, &point));
}

#[test]
fn rules_and_cofactors_keep_their_places_among_what_is_given() {
    let [l1, l2, l3, x, y] = symbols(["l1", "l2", "l3", "x", "y"]);
    let unit = Hypotheses::none().unit_vector([l1, l2, l3]).given(y, l1 + l2);
    let all = certificates(|page| {
        let given = [Condition::NonZero(l3), Condition::Zero(x - y)];
        let conclusion = Condition::Zero(l3 * (x - l1 - l2));
        page.claim("eq1", "rules", "a conclusion").given(given).under(&unit).by_combination([(
            conclusion,
            vec![],
            vec![(1, l3)],
        )]);
    });
    let text = serde_json::to_string(&all[0].parts[0]).unwrap_or_default();
    assert!(text.contains(r#""cofactors":[[1,"#), "{text}");
    assert!(text.contains(r#"{"step":"rewrite","letter":"#) && text.contains(r#""power":2,"by":2}"#), "{text}");
    assert!(text.contains(r#"{"step":"solve","letters":["#) && text.contains(r#""by":[3]}"#), "{text}");
}

#[test]
fn a_claim_without_a_certificate_says_why() {
    let [a, b] = symbols(["a", "b"]);
    let all = certificates(|page| {
        page.claim("eq1", "name", "a name").defines([Line::formula(a, a, b)]);
    });
    assert_eq!((all[0].none.as_deref(), all[0].parts.len()), (Some("a definition makes no claim"), 0));
}
