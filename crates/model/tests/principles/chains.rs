//! Long systems: verdicts within seconds.

use crate::systems::{chain, spatial_chain};
use dalembert_model::principles::Principle;
use dalembert_model::{Agreement, Model, Trace, forming};
use std::cell::RefCell;
use symbolic::apart;

#[test]
fn principles_and_statements_agree_on_a_chain_of_eight_links() {
    let model = Model::of(&chain(8)).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        let is_known = |found: &Agreement| matches!(found, Agreement::Proved { .. } | Agreement::Identified { .. });
        for other in Principle::ALL.into_iter().skip(1) {
            let found = dalembert_model::agreement(&trace, Principle::Lagrange, other).expect("it applies");
            assert_eq!(found.degree(), "proved", "{}: {found}", other.name());
        }
        for stated in dalembert_model::statements(&trace) {
            assert!(is_known(&stated.agreement), "{}: {}", stated.subject, stated.agreement);
        }
    });
}

#[test]
fn a_chain_too_long_for_its_normal_form_is_proved_for_any_masses() {
    let model = Model::of(&chain(16)).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        for other in Principle::ALL.into_iter().skip(1) {
            let found = dalembert_model::agreement(&trace, Principle::Lagrange, other).expect("it applies");
            assert!(matches!(found, Agreement::Theorem { .. }), "{}: {found}", other.name());
        }
    });
}

/// The effort of each comparison of principles is announced before its start, and the comparisons end in proofs for twenty links.
#[test]
fn a_chain_in_space_has_its_work_told_and_its_principles_proved() {
    let model = Model::of(&spatial_chain(20)).unwrap_or_else(|faults| panic!("{faults:?}"));
    let told = apart(|| {
        let told = RefCell::new(Vec::new());
        let trace = Trace::of(&model).heard_by(|work| told.borrow_mut().push(work.clone()));
        for other in Principle::ALL.into_iter().skip(1) {
            let found = dalembert_model::agreement(&trace, Principle::Lagrange, other).expect("it applies");
            assert!(
                matches!(found, Agreement::Theorem { points, .. } if told.borrow().last().is_some_and(|work| work.points == Some(points)))
            );
        }
        drop(trace);
        told.into_inner()
    });
    assert!(told.iter().all(|work| !work.by_normal_form && work.operations > 10_000 && work.seconds() > 0.0));
    assert!(told[0].to_string().starts_with("lagrange = virtual-power: ") && told.len() == 6, "{told:?}");
    let (seconds, bytes) = forming(&model);
    assert!(seconds < 1.0 && bytes < 100e6, "{seconds} s, {bytes} bytes");
}
