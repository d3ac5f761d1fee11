//! False statements are not proved: one false statement for each method of deciding a claim.

use dalembert_claims::{Claim, Condition, Judged, Line, Page, Point, Verdict};
use field::{Rational, Scalar};
use symbolic::{Dimension, Hypotheses, Sym, symbols};

fn dimensionless(name: &str) -> Option<Dimension> {
    match name {
        "length" => Some(Dimension::length()),
        "time" => Some(Dimension::time()),
        _ => Some(Dimension::none()),
    }
}

fn judged(draft: impl FnOnce(&mut Page)) -> Judged {
    let mut page = Page::of("test", dimensionless);
    draft(&mut page);
    let claim: &Claim = &page.claims()[0];
    claim.judge(dimensionless)
}

fn int(n: i64) -> Sym {
    Sym::int(n)
}

#[test]
fn a_true_formula_is_proved_and_its_denominator_required() {
    let [a, b, y] = symbols(["a", "b", "y"]);
    let claim = judged(|page| {
        page.claim("eq1", "x", "").holds([Line::formula((a * a - b * b) / (a - b) / b, y, a / b + int(1))]);
    });
    assert_eq!(claim.verdict, Verdict::Proved);
    assert!(claim.requires.iter().any(|(text, _)| text == "b != 0"), "{:?}", claim.requires);
    assert_eq!(claim.sound(), Ok(()));
}

#[test]
fn a_false_formula_is_refuted_at_an_exact_point() {
    let [a, b, y] = symbols(["a", "b", "y"]);
    let claim = judged(|page| {
        page.claim("eq1", "x", "").holds([Line::formula((a + b).powi(2), y, a * a + b * b)]);
    });
    assert_eq!(claim.verdict, Verdict::Refuted);
    assert_eq!(claim.difference.as_ref().map(|(text, _)| text.as_str()), Some("2*a*b"));
    assert!(!claim.counterexample.is_empty());
    assert!(claim.sound().is_err(), "the author expected a proof");
}

#[test]
fn a_line_compared_with_itself_is_objected_to() {
    let [a, y] = symbols(["a", "y"]);
    let claim = judged(|page| {
        page.claim("eq1", "x", "").holds([Line::formula(a, y, a)]);
    });
    assert!(claim.objections[0].contains("nothing was compared"));
}

#[test]
fn a_sum_of_a_length_and_a_time_is_objected_to() {
    let [l, t, y] = symbols(["length", "time", "y"]);
    let claim = judged(|page| {
        page.claim("eq1", "x", "").holds([Line::formula((l + t) - t + t, y, l + t)]);
    });
    assert!(claim.objections.iter().any(|o| o.contains("length") && o.contains("time")), "{:?}", claim.objections);
}

#[test]
fn a_false_formula_of_mixed_dimensions_is_refuted_and_they_are_told() {
    let [l, t, y] = symbols(["length", "time", "y"]);
    let claim = judged(|page| {
        page.claim("eq1", "x", "").fails([Line::formula(l + l, y, l + t)]);
    });
    assert_eq!(claim.sound(), Ok(()));
    assert!(claim.evidence.contains("length") && claim.evidence.contains("time"), "{}", claim.evidence);
}

#[test]
fn a_derivation_of_mixed_dimensions_is_objected_to_whatever_the_print() {
    let [l, t, y] = symbols(["length", "time", "y"]);
    let claim = judged(|page| {
        page.claim("eq1", "x", "").fails([Line::formula(l + t, y, l)]);
    });
    assert!(claim.objections.iter().any(|o| o.contains("length") && o.contains("time")), "{:?}", claim.objections);
}

#[test]
fn contradictory_hypotheses_are_objected_to() {
    let [a, b, y] = symbols(["a", "b", "y"]);
    let impossible = Hypotheses::none().rule(a, 2, int(-1));
    let claim = judged(|page| {
        page.claim("eq1", "x", "").under(&impossible).holds([Line::formula(b + b, y, int(2) * b)]);
    });
    assert!(claim.objections.iter().any(|o| o.contains("no exact point")), "{:?}", claim.objections);
}

#[test]
fn a_certificate_with_a_wrong_cofactor_proves_nothing() {
    let [a, b] = symbols(["a", "b"]);
    let with = |cofactor: Sym| {
        judged(|page| {
            page.claim("eq1", "x", "").given([Condition::Zero(a - b)]).by_combination([(
                Condition::Zero(a * a - b * b),
                vec![],
                vec![(0, cofactor)],
            )]);
        })
        .verdict
    };
    assert_eq!(with(a + b), Verdict::Proved);
    assert_eq!(with(a - b), Verdict::Undecided);
}

/// A nonzero normal form refutes a claim, unless hypotheses that are not rules exclude the counterexample.
#[test]
fn what_a_point_contradicts_is_refuted_and_shows_the_point() {
    let [a, b] = symbols(["a", "b"]);
    let with = |given: &[Condition]| {
        judged(|page| {
            page.claim("eq1", "x", "").given(given.iter().copied()).follows([Condition::Equal(a, b)]);
        })
    };
    let refuted = with(&[]);
    assert_eq!(refuted.verdict, Verdict::Refuted, "{}", refuted.evidence);
    assert_eq!(refuted.counterexample.len(), 2, "{:?}", refuted.counterexample);
    let unused = with(&[Condition::Equal(a, b)]);
    assert_eq!(unused.verdict, Verdict::Undecided, "{}", unused.evidence);
    assert!(unused.counterexample.is_empty() && !unused.evidence.contains(" at "), "{}", unused.evidence);
}

#[test]
fn a_certificate_may_not_divide_by_what_may_vanish() {
    let [a, b] = symbols(["a", "b"]);
    let claim = judged(|page| {
        page.claim("eq1", "x", "").given([Condition::Zero(a * b)]).by_combination([(
            Condition::Zero(b),
            vec![0],
            vec![(0, int(1))],
        )]);
    });
    assert_eq!(claim.verdict, Verdict::Open, "{}", claim.evidence);
}

#[test]
fn signs_need_every_term_and_one_that_cannot_vanish() {
    let [a, x] = symbols(["a", "x"]);
    let decide = |expression: Sym| {
        judged(|page| {
            page.claim("eq1", "x", "").given([Condition::Positive(a)]).by_signs([Condition::Positive(expression)]);
        })
        .verdict
    };
    assert_eq!(decide(a + x * x), Verdict::Proved);
    assert_eq!(decide(x * x), Verdict::Undecided, "x may be zero");
    assert_eq!(decide(a + x), Verdict::Undecided, "x may be negative");
    assert_eq!(decide(a - x * x), Verdict::Undecided);
}

#[test]
fn a_sum_of_squares_is_positive_where_not_all_of_them_vanish() {
    let [x, y, z] = symbols(["x", "y", "z"]);
    let decide = |given: Sym| {
        judged(|page| {
            let given = [Condition::NonZero(given)];
            page.claim("eq1", "x", "").given(given).by_signs([Condition::Positive(x * x + y * y)]);
        })
        .verdict
    };
    assert_eq!(decide(x * x + y * y), Verdict::Proved);
    assert_eq!(decide(x + y), Verdict::Proved, "a sum that differs from zero has a summand that does");
    assert_eq!(decide(x * x + y * y + z * z), Verdict::Undecided, "z alone may differ from zero");
    assert_eq!(decide(x + z), Verdict::Undecided);
}

#[test]
fn what_was_divided_by_and_what_is_given_in_words_is_listed() {
    let [a, b, c] = symbols(["a", "b", "c"]);
    let claim = judged(|page| {
        page.claim("eq1", "x", "in words")
            .in_words()
            .given([Condition::Positive(a), Condition::NonZero(c)])
            .follows([Condition::Equal(b / (a * c) * (a * c), b), Condition::Equal((b * b - c * c) / (b - c), b + c)]);
    });
    let text = |list: &[(String, String)]| list.iter().map(|(text, _)| text.clone()).collect::<Vec<_>>();
    assert_eq!((claim.verdict, text(&claim.signs)), (Verdict::Proved, vec!["a > 0".to_owned()]));
    assert_eq!(text(&claim.requires), ["c != 0", "b - c != 0"]);
    assert_eq!(dalembert_claims::entries(&[claim])[0].requires, ["c != 0", "b - c != 0", "a > 0"]);
}

#[test]
fn a_derived_divisor_that_the_printed_side_does_not_show_is_listed() {
    let [a, b, y] = symbols(["a", "b", "y"]);
    let claim = judged(|page| {
        page.claim("eq1", "x", "").holds([Line::formula((a * a - b * b) / (a - b), y, a + b)]);
    });
    assert!(claim.requires.iter().any(|(text, _)| text == "a - b != 0"), "{:?}", claim.requires);
}

#[test]
fn a_reading_a_reason_and_a_note_stand_in_every_output() {
    let [a, y] = symbols(["a", "y"]);
    let claim = judged(|page| {
        let draft = page.claim("eq1", "x", "printed with a lost 2").why("The 2 is lost.");
        draft.reading("b is read as a.").note("For all a.").fails([Line::formula(a + a, y, a)]);
    });
    let page = dalembert_claims::render(std::slice::from_ref(&claim));
    for line in ["why: The 2 is lost.", "reading: b is read as a.", "note: For all a."] {
        assert!(page.contains(line), "{page}");
    }
    let row = &dalembert_claims::entries(&[claim])[0];
    assert_eq!(row.why.as_deref(), Some("The 2 is lost."));
    assert_eq!(row.reading.as_deref(), Some("b is read as a."));
    assert_eq!(row.note.as_deref(), Some("For all a."));
}

#[test]
fn a_counterexample_must_satisfy_what_is_given_and_break_the_conclusion() {
    let [a, b] = symbols(["a", "b"]);
    let at = |x: i64, y: i64| {
        judged(|page| {
            page.claim("eq1", "x", "")
                .given([Condition::Zero(a * a - b * b)])
                .refuted([Condition::Equal(a, b)], Point::of([(a, Rational::int(x)), (b, Rational::int(y))]));
        })
        .verdict
    };
    assert_eq!(at(1, -1), Verdict::Refuted);
    assert_eq!(at(1, 2), Verdict::Undecided, "the premise fails there");
    assert_eq!(at(1, 1), Verdict::Undecided, "the conclusion holds there");
}

#[test]
fn no_root_is_told_from_some_root() {
    let [a, x] = symbols(["a", "x"]);
    let with = |value: i64| {
        judged(|page| {
            let conclusions = [Condition::Zero(x * x - a * x), Condition::Zero(x * x * x - int(2) * x * x)];
            page.claim("eq1", "x", "").without_root(conclusions, x, Point::of([(a, Rational::int(value))]));
        })
        .verdict
    };
    assert_eq!(with(3), Verdict::Refuted, "x = 3 and x = 2 have nothing in common but zero");
    assert_eq!(with(2), Verdict::Undecided, "x = 2 satisfies both");
}

#[test]
fn an_identically_vanishing_denominator_is_undefined() {
    let [a, y] = symbols(["a", "y"]);
    let nothing = (a + int(1)).powi(2) - a * a - int(2) * a - int(1);
    let claim = judged(|page| {
        page.claim("eq1", "x", "").holds([Line::formula(a / nothing, y, a)]);
    });
    assert_eq!(claim.verdict, Verdict::Undefined);
}

/// `times * a^2` as a sum of unreduced terms.
fn written_out(times: u32) -> Sym {
    let [a, b] = symbols(["a", "b"]);
    (0..times).fold(Sym::ZERO, |sum, _| sum + ((a + b) * (a - b) + b * b))
}

#[test]
fn a_long_derived_side_is_shown_in_normal_form() {
    let [a] = symbols(["a"]);
    let shown = |then: Condition| {
        let claim = judged(|page| {
            page.claim("eq1", "x", "").follows([then]);
        });
        claim.text
    };
    assert_eq!(shown(Condition::Equal(written_out(8), int(4) * a * (a + a))), ["8*a^2 = 4*a*(a + a)"]);
    assert_eq!(shown(Condition::Equal(written_out(1), a * a)), ["(a + b)*(a - b) + b^2 = a^2"], "short: as it stands");
    assert_eq!(shown(Condition::Equal(written_out(8), written_out(9) - a * a)), Vec::<String>::new());
    let nothing = written_out(8) - int(8) * a * a;
    assert!(shown(Condition::Zero(nothing))[0].ends_with("= 0"), "that it vanishes is what it says");
}
