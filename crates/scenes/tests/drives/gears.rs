//! Motors with gears between bodies.

use super::{close, last, motor, runs, stored};

/// L i' = U - R i - k w and J w' = k i from rest: two exponentials.
#[test]
fn a_brushed_motor_starts_as_its_two_equations_say() {
    let text = motor(
        "L = \"2 mH\"\nR = \"0.5 ohm\"\nk = \"0.05 V s\"\n",
        "[[drive.winding]]\ninductance = \"L\"\nresistance = \"R\"\nsupply = \"U\"\nmotional = \"k\"\n[outputs]\ni = \"motor.i\"\nT = \"motor.torque\"\n",
    );
    let trajectory = runs(&text);
    let (l, r, k, j, u, t) = (2e-3_f64, 0.5, 0.05, 1e-4, 12.0, 0.05_f64);
    let (half, root) = (r / l / 2.0, ((r / l / 2.0).powi(2) - k * k / (l * j)).sqrt());
    let (fast, slow) = (-half - root, -half + root);
    let final_speed = u / k;
    let speed = final_speed * (1.0 + (fast * (slow * t).exp() - slow * (fast * t).exp()) / (slow - fast));
    let rate = final_speed * fast * slow * ((slow * t).exp() - (fast * t).exp()) / (slow - fast);
    close(last(&trajectory, "theta'"), speed, 1e-9);
    close(last(&trajectory, "i"), j * rate / k, 1e-9);
    close(last(&trajectory, "T"), j * rate, 1e-11);
}

/// The rotor turns at alpha' + n theta'; n times its torque acts on the wheel and, in the opposite direction, on the carriage.
#[test]
fn a_gear_passes_the_torque_and_its_reaction_on() {
    let geared = runs(&stored("geared_motor"));
    close(last(&geared, "momentum"), 0.0, 1e-15);
    // the same system without a drive: the rotor as a body, a pair of torques, and the current as the rate of a charge
    let text = stored("geared_motor");
    let (system, drive) = text.split_once("[[drive]]").expect("it has a drive");
    let (_, run) = drive.split_once("[run]").expect("it has a run");
    let by_hand = system
        .replace("theta = \"rad\"", "theta = \"rad\"\nq = \"C\"")
        .replace("W = \"C turned theta about z\"", "W = \"C turned theta about z\"\nM = \"C turned n*theta about z\"")
        + "[bodies.rotor]\nframe = \"M\"\ninertia = \"Jm\"\n[energies]\nkinetic = \"L/2*q'^2\"\ndissipation = \"R/2*q'^2\"\n\
           [[torque]]\nbetween = [\"carriage\", \"rotor\"]\nis = \"(k*q' - c*n*theta')*N.z\"\n[[force]]\nalong = \"q\"\nis = \"U - k*n*theta'\"\n[run]"
        + run;
    let by_hand = runs(&by_hand);
    for name in ["alpha", "theta", "alpha'", "theta'"] {
        close(last(&geared, name), last(&by_hand, name), 1e-9);
    }
    close(last(&geared, "current"), last(&by_hand, "q'"), 1e-9);
}

/// Steady state of a shunt motor: U = R i_a + m i_f w and m i_f i_a = c w, with i_f = U/R_f.
#[test]
fn windings_know_each_others_currents() {
    let text = motor(
        "La = \"2 mH\"\nRa = \"0.6 ohm\"\nLf = \"0.2 H\"\nRf = \"24 ohm\"\nm = \"50 mH\"\nc = \"1e-4 N m s\"\n",
        "torque = \"-c*motor.speed\"\n[[drive.winding]]\ncurrent = \"i_f\"\ninductance = \"Lf\"\nresistance = \"Rf\"\nsupply = \"U\"\n\
         [[drive.winding]]\ncurrent = \"i_a\"\ninductance = \"La\"\nresistance = \"Ra\"\nsupply = \"U\"\nmotional = \"m*motor.i_f\"\n\
         [outputs]\ni_a = \"motor.i_a\"\n",
    );
    let trajectory = runs(&text.replace("0.05 s", "3 s"));
    let (field, m, resistance, c, supply) = (12.0 / 24.0, 0.05, 0.6, 1e-4, 12.0);
    let speed = supply * m * field / (m * field * m * field + resistance * c);
    close(last(&trajectory, "theta'"), speed, 1e-8);
    close(last(&trajectory, "i_a"), c * speed / (m * field), 1e-8);
}

/// Constant losses and losses proportional to the transmitted torque stop the wheel after the supply is switched off, and keep it at rest.
#[test]
fn a_gear_with_losses_comes_to_rest_and_stays() {
    let text = stored("geared_motor")
        .replace(
            "torque = \"-c*motor.speed\"",
            "torque = \"-c*motor.speed - (T0 + eta*abs(k*motor.i))*sign(motor.speed)\"",
        )
        .replace("[coordinates]", "T0 = \"2 mN m\"\neta = \"0.1\"\n[coordinates]")
        .replace("supply = \"U\"", "supply = \"if(t < (0.15 s), U, 0)\"")
        .replace("span = \"0.3 s\"", "span = \"1 s\"");
    let trajectory = runs(&text);
    close(last(&trajectory, "theta'"), 0.0, 1e-12);
    close(last(&trajectory, "current"), 0.0, 1e-9);
    assert!(last(&trajectory, "theta") > 3.0);
    // U = R i + k w, and k i minus the losses balances friction
    let driven = runs(&text.replace("span = \"1 s\"", "span = \"0.14 s\""));
    let (current, speed) = (last(&driven, "current"), 10.0 * last(&driven, "theta'"));
    close(0.5 * current + 0.05 * speed, 12.0, 1e-4);
    close(0.9 * 0.05 * current, 2e-5 * speed + 2e-3, 1e-6);
}
