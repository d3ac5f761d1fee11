//! Derivatives of the equations of motion, compared with differentiated residuals and constraints.

use crate::systems::{chain, double_pendulum, entries, held, rolling_disc, slider_crank, two_bodies};
use dalembert_model::equations::{Equations, constraints_of};
use dalembert_model::principles::Principle;
use dalembert_model::{ConstraintSource, InputSource, LoadSource, Model, Source, Trace, Variations, Varied};
use symbolic::{Hypotheses, Identity, Sym, apart, identified, substitute_all};

fn is_zero(what: &str, difference: Sym) {
    let decided = symbolic::decide(difference, &Hypotheses::none());
    assert!(decided.is_zero(), "{what}: {decided}");
}

/// Asserts that the equations equal those of Gauss's principle and the rates of the constraints, and that all derivatives equal
/// symbolic derivatives of the values.
fn agree(source: &Source) {
    let model = Model::of(source).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        let inputs: Vec<Sym> = model.inputs.iter().map(|input| Sym::symbol(&input.name)).collect();
        let varied = Variations::of(&trace, &inputs);
        let constraints = constraints_of(&trace);
        for (i, residual) in Principle::Gauss.residual(&trace).expect("it applies").into_iter().enumerate() {
            let reactions = constraints.iter().map(|one| one.multiplier * trace.by_speed(one.rate, i));
            is_zero("motion", reactions.fold(residual, |rest, each| rest - each) - varied.motion.values[i]);
        }
        for (k, constraint) in constraints.iter().enumerate() {
            is_zero("zero", varied.zero.values[k] - constraint.zero);
            is_zero("rate", varied.rate.values[k] - constraint.rate);
            is_zero("acceleration", varied.acceleration.values[k] - trace.rate_of(constraint.rate));
        }
        for Varied { values, by_coordinates, by_speeds, by_accelerations, by_multipliers, by_inputs, by_time } in
            [&varied.motion, &varied.zero, &varied.rate, &varied.acceleration, &varied.outputs]
        {
            for (slope, value) in by_time.iter().zip(values) {
                is_zero("a slope by the time", *slope - value.diff(trace.time));
            }
            let tables = [
                (by_coordinates, &trace.coordinates),
                (by_speeds, &trace.speeds),
                (by_accelerations, &trace.accelerations),
                (by_multipliers, &varied.multipliers),
                (by_inputs, &inputs),
            ];
            for (table, letters) in tables {
                assert_eq!(table.len(), values.len());
                for (row, value) in table.iter().zip(values) {
                    assert_eq!(row.len(), letters.len());
                    for (slope, letter) in row.iter().zip(letters) {
                        is_zero("a slope", *slope - value.diff(*letter));
                    }
                }
            }
        }
    });
}

#[test]
fn variations_are_the_equations_and_their_slopes() {
    let mut driven = double_pendulum(true);
    driven.inputs = vec![InputSource { name: "drive".into(), unit: "N m".into(), ..InputSource::default() }];
    driven.torques.push(LoadSource { on: Some("A".into()), is: "drive*N.z*cos(b)".into(), ..LoadSource::default() });
    driven.outputs = entries(&[("height", "(Q - O) . N.y"), ("power", "drive*a'")]);
    for source in [driven, rolling_disc(), slider_crank(), two_bodies()] {
        agree(&source);
    }
}

/// Substituting the solved accelerations and multipliers makes the equations of motion and the constraints' accelerations zero.
#[test]
fn accelerations_and_multipliers_fulfil_the_equations() {
    let closed =
        Source { constraints: vec![held("end", &["E4 - (O + l*N.x)"]), held("lower", &["q1 + q2"])], ..chain(4) };
    for source in [chain(4), closed] {
        let model = Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}"));
        apart(|| {
            let trace = Trace::of(&model);
            let (accelerations, multipliers) = Equations::of(&trace).solved().expect("it is regular");
            let varied = Variations::of(&trace, &[]);
            let symbols = trace.accelerations.iter().chain(&varied.multipliers).copied();
            let known: Vec<(Sym, Sym)> = symbols.zip(accelerations.into_iter().chain(multipliers)).collect();
            let left = substitute_all(&[varied.motion.values, varied.acceleration.values].concat(), &known);
            let found = identified(&left);
            assert!(matches!(found, Identity::Identified { .. }), "{found:?}");
        });
    }
}

/// Stabilised constraints: f'' + g1 f' + g2 f of a position constraint, f' + g1 f of a speed constraint.
#[test]
fn gains_lead_a_constraint_to_zero() {
    let led = |zero: &str, gains: &[&str]| ConstraintSource {
        gains: Some(gains.iter().map(|&gain| gain.into()).collect()),
        ..held("led", &[zero])
    };
    let mut source = double_pendulum(true);
    source.constraints = vec![led("sin(a) - b", &["(8 1/s)", "(16 1/s^2)"]), led("a' - b*(2 1/s)", &["(3 1/s)"])];
    let model = Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        let found = Variations::of(&trace, &[]).acceleration.values;
        use field::{Analytic, Scalar};
        let [place, speed] =
            [Sym::symbol("a").circle().sin - Sym::symbol("b"), Sym::symbol("a'") - Sym::symbol("b") * Sym::int(2)];
        let rate = trace.rate_of(place);
        let by_hand = [
            trace.rate_of(rate) + Sym::int(8) * rate + Sym::int(16) * place,
            trace.rate_of(speed) + Sym::int(3) * speed,
        ];
        for (found, by_hand) in found.into_iter().zip(by_hand) {
            is_zero("led", found - by_hand);
        }
    });
}
