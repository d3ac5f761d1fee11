//! The integrals and the power balance of every machine in the catalogue.

use crate::physical::machines::{Sample, every_machine, numbers, with_data};
use crate::physical::rate::{Rate, rate};
use crate::physical::{fixed, gyrostat, rounded};
use dalembert_derivations::systems::gyrostat::driven::Driven;
use dalembert_derivations::systems::gyrostat::forms::Form;
use motor::{
    Conserved, Machine, Motor, RotorState, electrical_power, is_fed, joule_heat, motional_torque,
    torque_and_current_rates,
};
use nalgebra::Vector3;
use proptest::prelude::*;

/// The rates, torques and powers of one machine at one state.
#[derive(Clone, Copy, Debug)]
struct Instant {
    /// The rate d(v.v)/dt.
    length: Rate,
    /// The rate d(x.v)/dt.
    vertical_momentum: Rate,
    /// The rate dp/dt.
    rotor_momentum: Rate,
    /// The rate dE/dt.
    energy: Rate,
    /// The rate d(E - W p)/dt.
    jacobi: Rate,
    /// The torque M, N m.
    moment: f64,
    /// The torque law m(g', phi'), N m.
    law: f64,
    /// The torque law at synchronism, m(0, W), N m.
    law_at_synchronism: f64,
    /// The heat sum R_k i_k^2, W.
    heat: f64,
    /// The supplied power sum v_k i_k, W.
    supplied: f64,
    /// The motional torque sum c_k i_k, N m.
    motional: f64,
    /// Whether the machine has a supply or windings with sliding contacts.
    fed: bool,
    slip: f64,
    /// The angular velocity W of the frame, rad/s.
    frame_speed: f64,
    /// The integrals that the machine declares.
    conserved: Conserved,
}

impl Instant {
    /// A machine in a form of the equations.
    fn at(form: impl Form<f64>, machine: Motor, sample: &Sample) -> Self {
        let driven = Driven::new(form, machine);
        let y = sample.state(driven.dimension());
        let mut dy = vec![0.0; y.len()];
        driven.rates(&y, &mut dy);
        let known = driven.machine.rotor();
        let (rotor, currents) = y[6..].split_at(known.dimension());
        let (angle, slip) = known.angle_and_slip(rotor);
        let frame_speed = driven.machine.frame_speed();
        let moment = if known == RotorState::Prescribed {
            let (w, v) = (Vector3::new(y[0], y[1], y[2]), Vector3::new(y[3], y[4], y[5]));
            driven.form.prescribed(w, v, frame_speed).1
        } else {
            torque_and_current_rates(&driven.machine, angle, slip, currents, &mut vec![0.0; currents.len()])
        };
        Instant {
            length: rate(|y| driven.vertical_length(y), &y, &dy),
            vertical_momentum: rate(|y| driven.vertical_momentum(y), &y, &dy),
            rotor_momentum: rate(|y| driven.rotor_momentum(y), &y, &dy),
            energy: rate(|y| driven.energy(y), &y, &dy),
            jacobi: rate(|y| driven.jacobi(y), &y, &dy),
            moment,
            law: driven.machine.torque_law(slip, slip + frame_speed),
            law_at_synchronism: driven.machine.torque_law(0.0, frame_speed),
            heat: joule_heat(&driven.machine, currents),
            supplied: electrical_power(&driven.machine, angle, currents),
            motional: motional_torque(&driven.machine, currents),
            fed: is_fed(&driven.machine),
            slip,
            frame_speed,
            conserved: Conserved::by(&driven.machine),
        }
    }
}

/// Tests a property of every machine in both forms.
fn always(
    g: &dalembert_derivations::systems::gyrostat::Gyrostat<field::Rational>,
    sample: &Sample,
    law: impl Fn(&Instant) -> bool,
) -> Result<(), TestCaseError> {
    every_machine(sample).try_for_each(|machine| in_both_forms(g, sample, machine, &law))
}

fn in_both_forms(
    g: &dalembert_derivations::systems::gyrostat::Gyrostat<field::Rational>,
    sample: &Sample,
    machine: Motor,
    law: impl Fn(&Instant) -> bool,
) -> Result<(), TestCaseError> {
    let (g, name) = (rounded(g), machine.name());
    let first = Instant::at(g.first_form().0, machine.clone(), sample);
    let second = Instant::at(g.second_form().0, machine, sample);
    for (form, instant) in [("first", first), ("second", second)] {
        prop_assert!(law(&instant), "{name}, {form} form: {instant:?}");
    }
    Ok(())
}

/// Exactly the declared integrals are conserved.
fn conserves_what_it_is_said_to(now: &Instant) -> bool {
    now.conserved.jacobi == now.jacobi.is(&[]) && now.conserved.spin == now.rotor_momentum.is(&[])
}

proptest! {
    #![proptest_config(fixed(128))]

    #[test]
    fn the_length_of_the_vertical_is_conserved(g in gyrostat(), sample in numbers()) {
        always(&g, &sample, |now| now.length.is(&[]))?;
    }

    #[test]
    fn the_momentum_about_the_vertical_is_conserved(g in gyrostat(), sample in numbers()) {
        always(&g, &sample, |now| now.vertical_momentum.is(&[]))?;
    }

    #[test]
    fn the_rotors_own_momentum_changes_by_the_moment(g in gyrostat(), sample in numbers()) {
        always(&g, &sample, |now| now.rotor_momentum.is(&[now.moment]))?;
    }

    #[test]
    fn the_energy_changes_by_what_field_and_supply_give_less_friction_and_heat(g in gyrostat(), sample in numbers()) {
        always(&g, &sample, |now| {
            let field = now.frame_speed * (now.moment - now.law - now.motional);
            let friction = (now.slip + now.frame_speed) * now.law;
            now.energy.is(&[field, friction, now.supplied, -now.heat])
        })?;
    }

    #[test]
    fn seen_from_the_turning_field_the_field_does_no_work(g in gyrostat(), sample in numbers()) {
        always(&g, &sample, |now| {
            let feed = [now.supplied, -now.frame_speed * now.motional];
            now.jacobi.is(&[now.law * now.slip, -now.heat, feed[0], feed[1]])
        })?;
    }

    #[test]
    fn every_machine_conserves_what_it_is_said_to_and_nothing_else(g in gyrostat(), sample in numbers()) {
        always(&g, &sample, conserves_what_it_is_said_to)?;
    }

    #[test]
    fn a_motor_with_windings_keeps_its_energy_only_without_friction_and_heat(
        g in gyrostat(), sample in numbers(), friction in 0..2u8, resistance in 0..2u8
    ) {
        let (f, r) = (f64::from(friction), f64::from(resistance));
        let winding = [("a1", 0.5), ("l1", 0.3), ("r1", r), ("a2", 0.4), ("l2", 0.2), ("r2", r)];
        let data = [&winding[..], &[("field_speed", 3.0), ("b0", 0.8), ("mu", f), ("f", f)]].concat();
        in_both_forms(&g, &sample, with_data("multi_current", &data, 3), conserves_what_it_is_said_to)?;
    }

    /// Sliding contacts change E - W p unless their frame is at rest, and so does a supply.
    #[test]
    fn a_motor_without_losses_keeps_its_energy_only_without_supply_and_turning_axes(
        g in gyrostat(), sample in numbers(), voltage in 0..2u8, field_speed in 0..2u8
    ) {
        let (voltage, field_speed) = (f64::from(voltage), 3.0 * f64::from(field_speed));
        let common = [("voltage", voltage), ("flux", 0.5), ("resistance", 0.0), ("f", 0.0)];
        let brushed = [&common[..], &[("inductance", 0.3)]].concat();
        let magnets = [&common[..], &[("field_speed", field_speed), ("along", 0.3), ("across", 0.4)]].concat();
        in_both_forms(&g, &sample, with_data("brushed", &brushed, 1), conserves_what_it_is_said_to)?;
        in_both_forms(&g, &sample, with_data("permanent_magnet", &magnets, 2), conserves_what_it_is_said_to)?;
    }

    /// The function E - W p + c0 g with c0 = -m(0, W).
    #[test]
    fn the_falling_function_never_grows_unless_it_is_fed(g in gyrostat(), sample in numbers()) {
        always(&g, &sample, |now| {
            let c0 = -now.law_at_synchronism;
            now.fed || now.jacobi.value + c0 * now.slip <= 1e-12 * (1.0 + now.jacobi.size + (c0 * now.slip).abs())
        })?;
    }
}
