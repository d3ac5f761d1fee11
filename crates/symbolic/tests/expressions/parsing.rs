//! The parser reads printed expressions back and refuses malformed texts with the position of the error.

use dalembert_symbolic::{Hypotheses, NotExpression, Reason, Sym, parse, symbols};
use field::{Analytic, Rational, Scalar};
use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestRunner};

fn read(text: &str) -> Result<Sym, NotExpression> {
    parse(text, &|name| (name != "unknown").then(|| Sym::symbol(name)))
}

fn wrong(text: &str) -> (&str, Reason) {
    let error = read(text).expect_err("it is no expression");
    (&text[error.span], error.reason)
}

#[test]
fn precedence_is_that_of_print() {
    let [a, b, c] = symbols(["a", "b", "c"]);
    for (text, expected) in [
        ("a - b - c", (a - b) - c),
        ("a/b*c", a / b * c),
        ("a/(b*c)", a / (b * c)),
        ("-a^2*b", -(a * a) * b),
        ("a*-b", -(a * b)),
        ("2*a + 0.25*b", Sym::int(2) * a + Sym::ratio(1, 4) * b),
        ("1.5e-2*a", Sym::constant(Rational::new(3, 200)) * a),
        ("a^-1", Sym::int(1) / a),
        ("cos(a)^2 + sin(a)^2", Sym::int(1)),
        ("sqrt(a + b)^2", a + b),
        ("γ̇*φ̈′*A⋆1", Sym::symbol("γ̇") * Sym::symbol("φ̈′") * Sym::symbol("A⋆1")),
    ] {
        let found = read(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert!(Hypotheses::none().equal(found, expected).is_zero(), "{text}: {found}");
    }
}

#[test]
fn what_cannot_be_read_is_told_at_its_place() {
    assert_eq!(wrong("a + * b"), ("*", Reason::Operand));
    assert_eq!(wrong("a b"), ("b", Reason::Operator));
    assert_eq!(wrong("2a"), ("a", Reason::Operator));
    assert_eq!(wrong("(a + b"), ("(", Reason::Parenthesis));
    assert_eq!(wrong("a)"), (")", Reason::Parenthesis));
    assert_eq!(wrong("a + unknown"), ("unknown", Reason::Name("unknown".into())));
    assert_eq!(wrong("tan(a)"), ("tan", Reason::Function("tan".into())));
    assert_eq!(wrong("a ? b"), ("?", Reason::Letter('?')));
    assert_eq!(wrong("a^b"), ("b", Reason::Exponent));
    assert_eq!(wrong("a^999"), ("999", Reason::Exponent));
    assert_eq!(wrong("(((9^64)^64)^64)^64").1, Reason::Number);
    assert_eq!(wrong("a/0"), ("0", Reason::Zero));
    assert_eq!(wrong("."), (".", Reason::Number));
    assert_eq!(wrong("1e99"), ("1e99", Reason::Number));
    assert_eq!(wrong(""), ("", Reason::Operand));
    assert_eq!(wrong(&"(".repeat(500)).1, Reason::Depth);
}

fn expression() -> impl Strategy<Value = Sym> {
    let leaf = prop_oneof![
        (-9i64..10, 1i64..5).prop_map(|(above, below)| Sym::ratio(above, below)),
        prop::sample::select(vec!["x", "omega3", "γ̇", "A⋆1", "φ′"]).prop_map(Sym::symbol),
    ];
    leaf.prop_recursive(5, 40, 2, |part| {
        prop_oneof![
            (part.clone(), part.clone()).prop_map(|(a, b)| a + b),
            (part.clone(), part.clone()).prop_map(|(a, b)| a - b),
            (part.clone(), part.clone()).prop_map(|(a, b)| a * b),
            (part.clone(), part.clone()).prop_map(|(a, b)| a / (b * b + Sym::int(1))),
            (part.clone(), 0i32..4).prop_map(|(a, n)| a.powi(n)),
            part.clone().prop_map(|a| -a),
            part.prop_map(|a| a.circle().sin),
        ]
    })
}

fn runner(cases: u32) -> TestRunner {
    let cases = std::env::var("PROPTEST_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(cases);
    let seed = RngSeed::Fixed(1743);
    TestRunner::new(ProptestConfig { cases, rng_seed: seed, failure_persistence: None, ..ProptestConfig::default() })
}

#[test]
fn what_is_printed_is_read_as_what_it_was() {
    let checked = runner(500).run(&expression(), |written| {
        let text = written.to_string();
        prop_assume!(!text.contains("an expression of"));
        let found = read(&text).map_err(|error| TestCaseError::fail(format!("{text}: {error}")))?;
        let value =
            |x: Sym| x.evaluate_analytic(&|name| Some(0.3 + name.len() as f64 * 0.17)).expect("all names have values");
        let (a, b): (f64, f64) = (value(written), value(found));
        prop_assert!((a - b).abs() <= 1e-9 * a.abs().max(1.0) || !a.is_finite(), "{text}: {a} {b}");
        Ok(())
    });
    checked.unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn any_text_is_read_or_refused_inside_it() {
    let piece = prop_oneof![
        3 => prop::sample::select(vec!["x", "1", "(", ")", "+", "-", "*", "/", "^", "sqrt(", "cos(", ".", "1e9", "e", "γ̇", " ", "′"])
            .prop_map(str::to_owned),
        1 => any::<char>().prop_map(String::from),
    ];
    let checked = runner(3000).run(&prop::collection::vec(piece, 0..30), |pieces| {
        let text = pieces.concat();
        if let Err(NotExpression { span, .. }) = read(&text) {
            prop_assert!(text.get(span).is_some(), "{text:?}");
        }
        Ok(())
    });
    checked.unwrap_or_else(|error| panic!("{error}"));
}
