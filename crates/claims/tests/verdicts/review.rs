//! The difference of two pages is reported as a difference of statements.

use dalembert_claims::review::{Change, Edit, review};
use symbolic::Dimension;

const PAGE: &str = "2 claims: 2 proved\n\n\
    proved     top/eq1/moment  the moment\n           \
    | A*dw1 = (B - C)*w2*w3 + K*w2 - M\n           requires A != 0\n\n\
    proved     top/eq2/current  the current\n           | L*di = -R*i - a*sin(g)*w1\n";

fn dimension(name: &str) -> Option<Dimension> {
    Some(match name {
        "A" | "B" | "C" => Dimension::of(1, 2, 0, 0),
        "w1" | "w2" | "w3" => Dimension::of(0, 0, -1, 0),
        "dw1" => Dimension::of(0, 0, -2, 0),
        "K" => Dimension::of(1, 2, -1, 0),
        "M" => Dimension::of(1, 2, -2, 0),
        "R" => Dimension::of(1, 2, -3, -2),
        "L" => Dimension::of(1, 2, -2, -2),
        "i" => Dimension::of(0, 0, 0, 1),
        "a" => Dimension::of(1, 2, -2, -1),
        _ => return None,
    })
}

/// The changes that a review reports after one edit of the page.
fn after(from: &str, to: &str) -> Vec<Change> {
    assert_eq!(PAGE.matches(from).count(), 1, "{from}");
    review(PAGE, &PAGE.replace(from, to), &dimension)
}

/// The only term that a review reports as changed.
fn term(from: &str, to: &str) -> (Edit, String, &'static str) {
    match after(from, to).as_slice() {
        [Change::Terms { terms, .. }] => match terms.as_slice() {
            [term] => (term.edit, term.term.clone(), term.meaning),
            other => panic!("{other:?}"),
        },
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_lost_term_is_told_with_its_meaning() {
    assert_eq!(
        term("(B - C)*w2*w3", "B*w2*w3"),
        (Edit::Gone, "C*w2*w3".into(), "product of two speeds: Coriolis, or gyroscopic")
    );
    assert_eq!(term("-R*i ", "").2, "voltage over a resistance: dissipation");
}

#[test]
fn a_turned_sign_and_a_factor_are_told_apart() {
    assert_eq!(term("- M", "+ M"), (Edit::Sign, "-M".into(), "a given moment or force: weight, load, field"));
    let (edit, _, meaning) = term("K*w2", "2*K*w2");
    assert_eq!(
        (edit, meaning),
        (Edit::Factor(field::Rational::new(2, 1)), "viscous friction, or a spin's gyroscopic moment")
    );
    assert_eq!(term("a*sin(g)*w1", "-a*sin(g)*w1").2, "voltage induced by the motion");
}

#[test]
fn the_same_written_otherwise_is_no_change_of_a_term() {
    let changes = after("(B - C)*w2*w3 + K*w2 - M", "K*w2 + w3*w2*B - M - C*w2*w3");
    assert!(matches!(changes.as_slice(), [Change::Rewritten { place: 0, .. }]), "{changes:?}");
}

#[test]
fn letters_inside_a_root_count_with_those_outside() {
    let changes = after("K*w2", "K*w2*sqrt(w1^2 + w2^2)");
    let [Change::Terms { terms, .. }] = &changes[..] else { panic!("{changes:?}") };
    let [lost, new] = &terms[..] else { panic!("{terms:?}") };
    assert_eq!((lost.edit, new.edit), (Edit::Gone, Edit::New));
    assert_eq!([lost.meaning, new.meaning], ["viscous friction, or a spin's gyroscopic moment"; 2]);
}

/// Both sides are brought to a common denominator, so that numerators of undivided terms are equal before and after.
#[test]
fn a_term_that_is_divided_now_is_lost_and_new_and_no_other_changed() {
    let changes = after("- M", "- M/(A + B)");
    let [Change::Terms { terms, .. }] = &changes[..] else { panic!("{changes:?}") };
    let told: Vec<(Edit, &str)> = terms.iter().map(|term| (term.edit, term.term.as_str())).collect();
    assert!(told.iter().all(|(_, term)| term.ends_with('M') || term.contains("M*")), "{told:?}");
    assert!(told.len() >= 2 && told.iter().any(|(edit, term)| *edit == Edit::New && !term.contains('A')), "{told:?}");
}

#[test]
fn verdicts_conditions_and_claims_that_come_and_go_are_told() {
    let changes = after("proved     top/eq2/current  the current", "refuted    top/eq2/current  the current");
    assert!(matches!(changes.as_slice(), [Change::Verdict { to, .. }] if to == "refuted"), "{changes:?}");
    let changes = after("requires A != 0", "requires A != 0, B != 0");
    assert!(
        matches!(changes.as_slice(), [Change::Requires { gained, lost, .. }] if gained == &["B != 0"] && lost.is_empty())
    );
    let changes = after("top/eq2/current", "top/eq3/current");
    assert!(matches!(changes.as_slice(), [Change::Gone { .. }, Change::New { .. }]), "{changes:?}");
    assert_eq!(after("2 claims", "3 claims"), []);
}

#[test]
fn another_reading_is_told_as_a_remark_and_a_sign_as_a_condition() {
    let read =
        PAGE.replace("requires A != 0", "requires A != 0\n           signs A > 0\n           reading: B is restored.");
    let changes = review(PAGE, &read, &dimension);
    let [Change::Requires { gained, .. }, Change::Remarks { gained: remarks, lost, .. }] = &changes[..] else {
        panic!("{changes:?}")
    };
    assert_eq!(
        (gained.as_slice(), remarks.as_slice()),
        (&["A > 0".to_owned()][..], &["reading: B is restored.".to_owned()][..])
    );
    assert!(lost.is_empty());
}
