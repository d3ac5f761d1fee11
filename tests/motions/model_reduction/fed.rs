//! Windings with a supply: their steady currents, compared with the circuit equations and with a motor in closed form.

use super::{ladder, scene, tight};
use dalembert_derivations::studies::model_reduction::sampled_run::followed;
use dalembert_derivations::studies::model_reduction::{Hierarchy, ReducedModel};

fn at_rest(ladder: &Hierarchy) -> &ReducedModel {
    ladder.models.iter().find(|reduced| reduced.name == "currents at rest").expect("it is on the ladder")
}

#[test]
fn currents_that_stand_for_fed_ones_leave_their_circuits_at_rest() {
    for name in ["brushed", "brushed_bench", "permanent_magnet", "permanent_magnet_bench"] {
        let ladder = ladder(&scene(&format!("machines/{name}")));
        let (n, reduced) = (ladder.start.len(), at_rest(&ladder));
        let lifted = reduced.lifted(0.0, &reduced.start, n);
        let rates = |state: &[f64]| {
            let mut rates = vec![0.0; n];
            ladder.law.rates(0.0, state, &mut rates);
            rates.split_off(reduced.start.len())
        };
        let mut without = lifted.clone();
        without[reduced.start.len()..].fill(0.0);
        let fed = rates(&without).iter().fold(0.0f64, |largest, rate| largest.max(rate.abs()));
        let left = rates(&lifted).iter().fold(0.0f64, |largest, rate| largest.max(rate.abs()));
        assert!(fed > 0.0 && left <= 1e-12 * fed, "{name}: {left:e} of {fed:e}");
    }
}

/// With the steady current A' W' = k (v - k W)/R - f W: W tends to v k/(k^2 + R f) at the rate (k^2/R + f)/A'.
#[test]
fn a_brushed_motor_without_induction_runs_up_as_its_closed_form() {
    let (voltage, flux, resistance, friction, axial) = (24.0, 0.045, 0.6, 1e-4, 2.4e-4);
    let ladder = ladder(&scene("machines/brushed_bench"));
    let reduced = at_rest(&ladder);
    let (record, _) = followed(&*reduced.law, &tight(), ladder.own.span, &reduced.start).expect("it reaches its end");
    let (end, rate) =
        (voltage * flux / (flux * flux + resistance * friction), (flux * flux / resistance + friction) / axial);
    for (time, state) in record.times.iter().zip(&record.states) {
        let speed = end * -(-rate * time).exp_m1();
        assert!((state[0] / speed - 1.0).abs() < 1e-9, "{time}: {} {speed}", state[0]);
        let current = reduced.lifted(*time, state, ladder.start.len())[1];
        let left = (voltage - flux * speed) / resistance;
        assert!((current / left - 1.0).abs() < 1e-9, "{time}: {current} {left}");
    }
}
