//! Circuits whose magnetic energies are given as co-energies.

use super::{close, last, motor, runs, stored};

/// The torque i^2/2 dL/dtheta turns the rotor of an inductance L0 + L2 cos(2 theta) with a current.
#[test]
fn an_inductance_that_depends_on_the_angle_turns_its_rotor() {
    let text = motor(
        "L0 = \"20 mH\"\nL2 = \"8 mH\"\n",
        "[[drive.winding]]\ninductance = \"L0 + L2*cos(2*theta)\"\n[start]\ntheta = \"0.4 rad\"\n\"motor.i\" = \"3 A\"\n",
    );
    let short = runs(&text.replace("0.05 s", "1e-4 s"));
    // without a voltage the flux is constant
    let inductance = |angle: f64| 20e-3 + 8e-3 * (2.0 * angle).cos();
    let (angle, flux) = (last(&short, "theta"), 3.0 * inductance(0.4));
    close(last(&short, "motor.q'"), flux / inductance(angle), 1e-12);
    // the magnetic energy flux^2/(2 L) becomes kinetic energy
    let kinetic = 0.5 * 1e-4 * last(&short, "theta'").powi(2);
    close(kinetic, flux * flux / 2.0 * (1.0 / inductance(0.4) - 1.0 / inductance(angle)), 1e-15);
    assert!(last(&short, "theta'") < -0.01);
}

/// The flux psi = psi0 tanh(i/i0) is the integral of the voltage: U t = psi0 tanh(i/i0).
#[test]
fn an_iron_core_saturates_by_its_co_energy() {
    let text = "title = \"core\"\n[parameters]\npsi = \"0.1 Wb\"\ni0 = \"2 A\"\nU = \"5 V\"\n[coordinates]\nq = \"C\"\n\
                [energies]\ncoenergy = \"psi*i0*ln((exp(q'/i0) + exp(-q'/i0))/2)\"\n[[force]]\nalong = \"q\"\nis = \"U\"\n[run]\nspan = \"0.015 s\"\n";
    let trajectory = runs(text);
    close(last(&trajectory, "q'"), 2.0 * (5.0 * 0.015 / 0.1_f64).atanh(), 1e-10);
}

/// The equivalent circuit of one phase: Z = Rs + i w Ls + (w Lm)^2/(Rr/s + i w Lr); the torque is p/w times the power in Rr/s.
#[test]
fn an_induction_machine_settles_where_its_circuit_says() {
    let trajectory = runs(&stored("induction_machine").replace("span = \"0.5 s\"", "span = \"2 s\""));
    let (ls, lr, lm, rs, rr, u, w) = (80e-3, 80e-3, 76e-3, 1.2, 1.0, 325.0, 314.159_26_f64);
    let speed = last(&trajectory, "theta'");
    let slip = 1.0 - 2.0 * speed / w;
    // |rr/s + i w lr|^2, from which Z follows
    let rotor = (rr / slip).powi(2) + (w * lr).powi(2);
    let real = rs + (w * lm).powi(2) * (rr / slip) / rotor;
    let imaginary = w * ls - (w * lm).powi(2) * w * lr / rotor;
    let stator = u * u / (real * real + imaginary * imaginary);
    let torque = 2.0 / w * stator * (w * lm).powi(2) / rotor * rr / slip;
    close(last(&trajectory, "torque"), torque, 1e-6);
    close(torque, 0.2 * speed, 1e-6);
}
