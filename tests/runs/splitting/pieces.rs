//! Consistency of the sub-flows: it is proved that their vector fields sum to the law; each has the flow property.

use crate::physical::machines::{every_machine, numbers};
use crate::physical::{fixed, gyrostat, rounded};
use dalembert_derivations::machines::asynchronous::Asynchronous;
use dalembert_derivations::machines::kloss::Kloss;
use dalembert_derivations::machines::multi_current::{MultiCurrent, Windings};
use dalembert_derivations::machines::synchronous::Synchronous;
use dalembert_derivations::systems::gyrostat::Gyrostat;
use dalembert_derivations::systems::gyrostat::driven::Driven;
use dalembert_derivations::systems::gyrostat::forms::{FirstForm, Form, SecondForm};
use dalembert_derivations::systems::gyrostat::momenta::{Flows, Point};
use field::{Analytic, Base, Circle, DoubleDouble, Over, Scalar, Tangent};
use integrators::{Pieces, Real};
use motor::ConstantSpeed;
use motor::FreeRotor;
use motor::{Bench, Kick, Law, Machine, Motor, Point as RotorPoint, RotorState, Rule, Separable, has_known_flow};
use nalgebra::Vector3;
use proptest::prelude::*;
use std::convert::Infallible;
use symbolic::{Hypotheses, Sym, decide};

/// The sum of the sub-flows' derivatives at time zero, and the rates of the law: (sum, law).
fn both<P: Base, S: Over<P> + Analytic, F: Form<P>, M: Machine<P>>(
    driven: &Driven<P, F, M>,
    law: Law,
    at: &Point<S>,
) -> (Vec<S>, Vec<S>) {
    let Driven { form, machine, .. } = driven;
    let flows = Flows::<Tangent<S>>::new(form, machine);
    let moment = Tangent::variable(S::zero());
    let fixed = |x: S| Tangent::fixed(x);
    let start = Point {
        momentum: at.momentum.map(fixed),
        vertical: at.vertical.map(fixed),
        rotor: RotorPoint {
            angle: fixed(at.rotor.angle),
            momentum: fixed(at.rotor.momentum),
            fluxes: at.rotor.fluxes.iter().copied().map(fixed).collect(),
        },
    };
    // to first order in time exponentials are linear, and every rule whose weights sum to one is exact
    let line = |a: Tangent<S>, b: Tangent<S>| Tangent::fixed(S::one()) - (a + b).half();
    let quarter = Tangent::fixed(S::ratio(1, 4));
    let zero = Tangent::fixed(S::zero());
    let rule = Rule { nodes: [zero; 4], weights: [quarter; 4], matrix: [[zero; 4]; 4] };
    let kick = Kick::new(machine, law, moment, flows.compliance(), line, rule);
    let mut y = vec![Tangent::fixed(S::zero()); driven.dimension()];
    let mut sum = vec![S::zero(); driven.dimension()];
    for piece in 0..=flows.squares() {
        let mut point = start.clone();
        match piece {
            0 => drop(flows.push(machine, &kick, &mut point)),
            1..=3 => flows.turn(piece - 1, moment, &mut point),
            _ => flows.turn_oblique(moment, &mut point),
        }
        flows.leave(machine, &point, &mut y);
        sum.iter_mut().zip(&y).for_each(|(sum, y)| *sum += y.slope);
    }
    let state: Vec<S> = y.iter().map(|y| y.value).collect();
    let mut rates = vec![S::zero(); state.len()];
    driven.rates(&state, &mut rates);
    (sum, rates)
}

/// A point whose coordinates are symbols; a rotor with prescribed speed has the momentum A' W.
fn symbolic<M: Machine<Sym>>(machine: &M, axial: Sym) -> Point<Sym> {
    let three = |stem: &str| Vector3::from_fn(|k, _| Sym::symbol(&format!("{stem}{}", k + 1)));
    let kept = machine.rotor() == RotorState::Prescribed;
    Point {
        momentum: three("x"),
        vertical: three("v"),
        rotor: RotorPoint {
            angle: Sym::symbol("g"),
            momentum: if kept { axial * machine.frame_speed() } else { Sym::symbol("p") },
            fluxes: (0..machine.windings()).map(|k| Sym::symbol(&format!("c{k}"))).collect(),
        },
    }
}

fn proved<M: Machine<Sym> + Clone>(name: &str, machine: M, law: Law) {
    let three = |stem: &str| Vector3::from_fn(|k, _| Sym::symbol(&format!("{stem}{}", k + 1)));
    let (moments, axis, weight, axial) = (three("A"), three("l"), three("G"), Sym::symbol("A'"));
    let at = symbolic(&machine, axial);
    let check = |form: &str, (sum, law): (Vec<Sym>, Vec<Sym>)| {
        for (k, (sum, law)) in sum.into_iter().zip(law).enumerate() {
            let decision = decide(sum - law, &Hypotheses::none());
            assert!(decision.is_zero(), "{name}, {form} form, component {k}: {decision}");
        }
    };
    let first = Driven::new(FirstForm::new(moments, axis, axial, weight), machine.clone());
    check("first", both(&first, law, &at));
    let second = Driven::new(SecondForm::new(moments, axis, axial, weight), machine);
    check("second", both(&second, law, &at));
}

fn symbol<E>(quantity: &'static reader::Quantity) -> Result<Sym, E> {
    Ok(Sym::symbol(&quantity.name))
}

#[test]
fn the_fields_of_the_pieces_sum_to_the_law_for_every_motor_in_both_forms_proved() {
    let Ok(windings) = Windings::<Sym>::read(symbol::<Infallible>);
    let bars = [Circle::from_half_tangent(Sym::symbol("t1")), Circle::from_half_tangent(Sym::symbol("t2"))];
    proved("multi_current", MultiCurrent { windings, bars: bars.into() }, Law::Linear);
    let Ok(synchronous) = Synchronous::<Sym>::read(symbol::<Infallible>);
    proved("synchronous", synchronous, Law::Linear);
    let Ok(asynchronous) = Asynchronous::<Sym>::read(symbol::<Infallible>);
    proved("asynchronous", asynchronous, Law::Linear);
    proved("free_rotor", FreeRotor::<Sym>::default(), Law::Linear);
    let Ok(kloss) = Kloss::<Sym>::read(symbol::<Infallible>);
    proved("kloss", kloss, Law::Curved);
    let Ok(kept) = ConstantSpeed::<Sym>::read(symbol::<Infallible>);
    proved("constant_speed", kept, Law::Linear);
}

#[test]
fn which_moments_are_linear_in_the_slip_is_decided_exactly() {
    let Ok(kloss) = Kloss::read(|_| Ok::<f64, Infallible>(0.7));
    assert_eq!(Law::of(&kloss), Law::Curved);
    let Ok(asynchronous) = Asynchronous::read(|_| Ok::<f64, Infallible>(0.7));
    assert_eq!(Law::of(&asynchronous), Law::Linear);
}

/// The largest difference between states, each component relative to its magnitude or to one.
fn gap<S: Real>(a: &[S], b: &[S]) -> f64 {
    let size = |x: S| 1.0 + x.magnitude().approx();
    a.iter().zip(b).map(|(a, b)| (*a - *b).magnitude().approx() / size(*b)).fold(0.0, f64::max)
}

/// Tests that the sub-flows of a machine sum to the law, and that each has the flow property.
fn is_sound(g: &Gyrostat<f64>, machine: Motor, state: &[f64]) -> Result<(), TestCaseError> {
    if !has_known_flow(&machine) {
        let driven = Driven::new(g.first_form().0, machine.clone());
        let none = driven.pieces::<f64>().is_none() && Bench { machine, axial: 0.7 }.pieces::<f64>().is_none();
        prop_assert!(none, "pieces without a known flow");
        return Ok(());
    }
    in_form(Driven::new(g.first_form().0, machine.clone()), state)?;
    in_form(Driven::new(g.second_form().0, machine.clone()), state)?;
    if machine.rotor() != RotorState::Prescribed {
        let bench = Bench { machine, axial: 0.7 };
        are_flows(&bench, &state[6..6 + bench.dimension()])?;
    }
    Ok(())
}

fn in_form<F: Form<f64>, M: Machine<f64> + Sync>(
    driven: Driven<f64, F, M>,
    state: &[f64],
) -> Result<(), TestCaseError> {
    let state = &state[..driven.dimension()];
    let at = Flows::<f64>::new(&driven.form, &driven.machine).enter(&driven.form, &driven.machine, state);
    for law in [Law::of(&driven.machine), Law::Curved] {
        let (sum, rates) = both(&driven, law, &at);
        prop_assert!(gap(&sum, &rates) < 1e-11, "{:e}", gap(&sum, &rates));
    }
    are_flows(&driven, state)
}

/// Tests inversion and composition of each flow: to 28 digits, or, for a flow computed by a method of order 8, up to
/// the error of this method for such short steps.
fn are_flows(separable: &impl Separable, state: &[f64]) -> Result<(), TestCaseError> {
    let Some(pieces) = separable.pieces::<DoubleDouble>() else { return Err(TestCaseError::fail("no pieces")) };
    let state: Vec<DoubleDouble> = state.iter().map(|y| DoubleDouble::from(*y)).collect();
    let after = |piece: usize, lengths: &[f64]| {
        let mut point = pieces.enter(&state);
        for length in lengths {
            let substep = pieces.substep(piece, DoubleDouble::from(*length));
            assert!(pieces.flow(piece, &substep, &mut point), "piece {piece} over {length}");
        }
        let mut y = state.clone();
        pieces.leave(&point, &mut y);
        y
    };
    let t = 2.0_f64.powi(-10);
    for piece in 0..pieces.pieces() {
        // the data are rounded to f64, the mobilities independently of the moments of inertia, hence the change of
        // coordinates is not exactly invertible
        let back = gap(&after(piece, &[t, -t]), &after(piece, &[]));
        prop_assert!(back < 1e-26, "piece {piece} back: {back:e}");
        let parts = gap(&after(piece, &[t, 2.0 * t]), &after(piece, &[3.0 * t]));
        prop_assert!(parts < 1e-17, "piece {piece} in parts: {parts:e}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(fixed(16))]

    #[test]
    fn every_machine_whose_flow_is_known_has_pieces_that_sum_to_its_law_and_flows_that_are_flows(
        g in gyrostat(), sample in numbers()
    ) {
        let (g, state) = (rounded(&g), sample.state(40));
        for machine in every_machine(&sample) {
            is_sound(&g, machine, &state)?;
        }
    }
}
