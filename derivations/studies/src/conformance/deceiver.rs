//! Test laws that are no functions of the state: the checks must reject them.

use super::instant::Instant;
use super::rest::Rest;
use super::slopes::compared;
use super::{frames, housing, power};
use crate::stationary::motor::MotorStates;
use claims::finding::PropertyVerdict;
use field::{Base, Circle, Over};
use machines as _;
use motor::{Bench, Machine, Motor, RotorState, catalogue};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use symbolic::Sym;

/// A machine whose fluxes differ from call to call.
#[derive(Clone, Debug)]
struct Deceiver<P> {
    calls: Arc<AtomicUsize>,
    friction: P,
}

impl<P> Deceiver<P> {
    fn new(friction: P) -> Self {
        Deceiver { calls: Arc::default(), friction }
    }

    fn call(&self) -> usize {
        self.calls.fetch_add(1, Ordering::Relaxed)
    }
}

impl<P: Base> Machine<P> for Deceiver<P> {
    fn rotor(&self) -> RotorState {
        RotorState::AngleAndSpeed
    }

    fn frame_speed(&self) -> P {
        P::int(3)
    }

    fn windings(&self) -> usize {
        2
    }

    fn resistance(&self, _winding: usize) -> P {
        P::one()
    }

    fn linkage<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> S {
        let flux = if winding == 0 { angle.cos } else { angle.sin };
        S::int((self.call() % 7) as i64) * flux
    }

    fn torque_law<S: Over<P>>(&self, slip: S, _speed: S) -> S {
        -S::lift(self.friction) * slip
    }
}

fn fails(verdict: &PropertyVerdict) -> bool {
    matches!(verdict, PropertyVerdict::Fails(_))
}

#[test]
fn a_law_that_is_no_function_of_the_state_is_found_out_by_every_identity() {
    let machine = Deceiver::new(Sym::symbol("f"));
    let at = Instant::of(&machine);
    assert!(fails(&power::balance(&machine, &at)), "power");
    assert!(fails(&frames::stator(&machine, &at)), "frame");
    assert!(fails(&frames::turned_windings(&machine, &at)), "windings");
    assert!(fails(&housing::momentum(&machine, &at)), "housing");
    assert!(fails(&housing::bench(&machine)), "bench");
    let running = Bench { machine: Deceiver::new(0.5), axial: 0.7 };
    assert!(compared(Arc::new(running)).is_err(), "jacobian");
}

/// A motor whose laws do not depend on the angle, with friction.
fn braked(k: f64) -> Motor {
    let value = |name: &str| if name == "k" { k } else { 0.5 };
    catalogue::sampled("asynchronous", |quantity| value(&quantity.name), 1).expect("it is in the catalogue")
}

#[test]
fn a_law_that_runs_with_other_data_does_not_rest_where_the_exact_one_does() {
    let rest = Rest::beside(MotorStates::of(&braked(0.1)), &braked(7.0));
    assert!(fails(&rest.stationary()), "{:?}", rest.stationary());
    let own = Rest::beside(MotorStates::of(&braked(7.0)), &braked(7.0));
    assert!(!fails(&own.stationary()) && !fails(&own.stability()));
}
