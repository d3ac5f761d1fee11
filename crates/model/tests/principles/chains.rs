//! Long systems: verdicts come in seconds.

use crate::systems::chain;
use dalembert_model::principles::Principle;
use dalembert_model::{Agreement, Model, Trace};
use symbolic::apart;

#[test]
fn principles_and_statements_agree_on_a_chain_of_eight_links() {
    let model = Model::of(&chain(8)).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        let is_known = |found: &Agreement| matches!(found, Agreement::Proved { .. } | Agreement::Identified { .. });
        for other in Principle::ALL.into_iter().skip(1) {
            let found = dalembert_model::agreement(&trace, Principle::Lagrange, other).expect("it applies");
            assert_eq!(found.rung(), "proved", "{}: {found}", other.name());
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
