//! Corrections of conclusions: several relations together, roots with given signs, divisors that must not vanish.

use claims::{Condition, Proof, Theorem};
use dalembert_manuscript::{EditKind, LineCorrection, theorem_corrections};
use symbolic::{Dimension, Hypotheses, Sym};

use Condition::{Equal, NonZero, Positive, Zero};

fn letters<const N: usize>(names: [&str; N]) -> [Sym; N] {
    names.map(Sym::symbol)
}

/// The kinds of edits after which the conclusion follows, each with the new right side.
fn corrected(given: &[Condition], left: Sym, right: Sym) -> Vec<(Vec<EditKind>, String)> {
    let theorem = Theorem {
        given: given.to_vec(),
        then: vec![Equal(left, right)],
        rules: Hypotheses::none(),
        proof: Proof::NormalForm,
    };
    let found =
        theorem_corrections(&theorem, |_| Some(Dimension::none()), &|| true).unwrap_or_else(|why| panic!("{why:?}"));
    let mut all = Vec::new();
    for LineCorrection { correction, line } in found {
        all.push((correction.changes.iter().map(|change| change.kind).collect(), line.right.to_string()));
    }
    all
}

#[test]
fn a_root_has_the_sign_that_is_given() {
    let [a, b, f, x] = letters(["a", "b", "f", "x"]);
    let squares = Equal((a * x).powi(2), f.powi(2) * (b + x).powi(2));
    // a x = f (b + x) gives x = f b/(a - f)
    let given = [squares, Positive(f), Positive(a * x), Positive(b + x)];
    let found = corrected(&given, x, f * b / (a + f));
    assert_eq!(found.first(), Some(&(vec![EditKind::Sign], "f*b/(a - f)".to_owned())), "{found:?}");
    // without the sign of f both roots are possible
    assert!(corrected(&[squares, Positive(a * x), Positive(b + x)], x, f * b / (a + f)).is_empty());
}

#[test]
fn relations_for_one_letter_are_taken_together() {
    let [p, q, a, b, x] = letters(["p", "q", "a", "b", "x"]);
    let given = [Zero(x * p + a), Zero(x * q + b)];
    let right = (p * a + q * b) / (p.powi(2) + q.powi(2));
    let found = corrected(&given, x, right);
    assert_eq!(found[0].0, [EditKind::Sign], "{found:?}");
}

#[test]
fn a_conclusion_that_lacks_a_hypothesis_gets_it() {
    let [a, b, c] = letters(["a", "b", "c"]);
    let given = [Zero(c * (a - b))];
    let found = corrected(&given, a, b);
    assert_eq!(found[0].0, [EditKind::Hypothesis], "{found:?}");
    assert!(corrected(&[given[0], NonZero(c)], a, b + b).iter().all(|(_, right)| right != "b + b"));
}
