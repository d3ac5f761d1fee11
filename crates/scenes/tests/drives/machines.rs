//! Machines given by their co-energies and windings: steady states compared with closed forms.

use super::{close, last, runs, stored};
use std::f64::consts::PI;

/// Angular frequency of the voltages, 50 Hz, in rad/s.
const W: f64 = 100.0 * PI;

/// U cos lag = R id - w psi_q, U sin lag = R iq + w psi_d, p (psi_d iq - psi_q id) = load, with psi_d = psi0 tanh(id/i0) + Ls id.
#[test]
fn a_reluctance_machine_settles_where_its_saturated_flux_carries_the_load() {
    let trajectory = runs(&stored("synchronous_reluctance"));
    let [speed, d, q, torque, lag] = ["theta'", "id", "iq", "torque", "lag"].map(|name| last(&trajectory, name));
    let (flux_d, flux_q) = (0.9 * (d / 6.0).tanh() + 6e-3 * d, 40e-3 * q);
    close(300.0 * lag.cos(), 1.5 * d - W * flux_q, 1e-5);
    close(300.0 * lag.sin(), 1.5 * q + W * flux_d, 1e-5);
    close(torque, 2.0 * (flux_d * q - flux_q * d), 1e-12);
    close(torque, 0.06 * speed, 1e-6);
    close(speed, W / 2.0, 1e-6);
}

/// The same equations with psi_d = Ld id + psi_m and psi_q = Lq iq.
#[test]
fn a_machine_with_magnets_inside_has_the_torque_of_its_shape_too() {
    let trajectory = runs(&stored("interior_magnet").replace("span = \"2 s\"", "span = \"4 s\""));
    let [speed, d, q, lag] = ["theta'", "id", "iq", "lag"].map(|name| last(&trajectory, name));
    close(170.0 * lag.cos(), 1.2 * d - W * 45e-3 * q, 1e-5);
    close(170.0 * lag.sin(), 1.2 * q + W * (20e-3 * d + 0.5), 1e-5);
    close(2.0 * (0.5 * q + (20e-3 - 45e-3) * d * q), 0.04 * speed + 4.0, 1e-6);
    close(speed, W / 2.0, 1e-6);
    let [magnets, shape] = ["by_magnets", "by_shape"].map(|name| last(&trajectory, name));
    assert!(shape > 0.2 * magnets, "{shape} {magnets}");
}

/// The torque is dW'/dtheta; for each phase it is L' (psi i tanh(x)/L - psi^2 ln cosh(x)/L^2) with x = L i/psi.
#[test]
fn a_switched_machine_is_turned_by_its_co_energy() {
    let trajectory = runs(&stored("switched_reluctance"));
    let angle = last(&trajectory, "theta");
    let phases = [("a'", 0.0), ("b'", -2.0 * PI / 3.0), ("d'", 2.0 * PI / 3.0)];
    let torque = phases.map(|(name, shift)| {
        let (i, along) = (last(&trajectory, name), 4.0 * angle + shift);
        let (inductance, slope) = (40e-3 + 32e-3 * along.cos(), -4.0 * 32e-3 * along.sin());
        let x = inductance * i / 0.35;
        slope * (0.35 * i * x.tanh() / inductance - 0.35 * 0.35 * x.cosh().ln() / inductance.powi(2))
    });
    close(last(&trajectory, "torque"), torque.iter().sum(), 1e-12);
    // reference: a separate integration that restarts at each switch
    close(last(&trajectory, "theta'"), 82.153_249_029, 1e-6);
}

/// The amplitude of the current is w M i_f/sqrt(R^2 + (w L)^2), with the field current i_f = U_f/R_f.
#[test]
fn a_generator_has_the_current_of_its_steady_short_circuit() {
    let trajectory = runs(&stored("wound_field"));
    let (w, field) = (2.0 * 1500.0 * PI / 30.0, 24.0 / 12.0);
    close(last(&trajectory, "f'"), field, 1e-6);
    let current = w * 0.18 * field / 0.8_f64.hypot(w * 40e-3);
    close(last(&trajectory, "current"), current, 1e-6);
    // the mechanical power is dissipated in the phases
    close(last(&trajectory, "torque") * w / 2.0, 0.8 * current * current, 1e-4);
}

/// In the steady state the voltage is U = (R + m w) i, and the torque m i^2 equals the torque c w^2 of the fan. Here i is the current, w the speed,
/// R the resistance, m the motor constant.
#[test]
fn a_series_motor_settles_where_its_fan_takes_the_torque() {
    let trajectory = runs(&stored("series_motor"));
    let [speed, current] = ["theta'", "current"].map(|name| last(&trajectory, name));
    close((1.5 + 0.1 * speed) * current, 220.0, 1e-6);
    close(0.1 * current * current, 2e-4 * speed * speed, 1e-8);
}

/// In the steady state the voltage is U = R_a i_a + m i_f w, and the torque m i_f i_a equals the load c w. Here a is the armature, f the field with
/// the current i_f = U/R_f.
#[test]
fn a_shunt_motor_settles_after_its_resistor_is_bridged() {
    let trajectory = runs(&stored("shunt_motor"));
    let [speed, field, armature] = ["theta'", "field", "armature"].map(|name| last(&trajectory, name));
    close(field, 1.0, 1e-8);
    close(0.8 * armature + 1.3 * field * speed, 220.0, 1e-6);
    close(1.3 * field * armature, 0.08 * speed, 1e-6);
}

/// L i' + (R + m W) i = U cos w t gives one phasor; the torque is m i^2.
#[test]
fn a_universal_motor_turns_the_same_way_on_alternating_voltage() {
    let trajectory = runs(&stored("universal_motor"));
    let (real, imaginary) = (8.0 + 0.12 * 600.0, W * 60e-3_f64);
    let phase = imaginary.atan2(real);
    let current = 325.0 / f64::hypot(real, imaginary) * (W * 0.2 - phase).cos();
    close(last(&trajectory, "current"), current, 1e-8);
    close(last(&trajectory, "torque"), 0.12 * current * current, 1e-8);
}
