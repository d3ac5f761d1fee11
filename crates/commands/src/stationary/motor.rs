//! The rotor in a steady motion: its speeds, its angles, the torque and the currents of the motor.

use serde_json::{Value, json};
use std::fmt::Write;
use studies::stationary::motor::{Angle, MotorStates, Slip};

/// The states of the rotor as text.
pub(super) fn text(motor: &MotorStates) -> String {
    let slope = |slope: i32| match slope {
        0 => "both merge here: pull-out",
        s if s < 0 => "the moment drives back to it",
        _ => "the moment drives away from it",
    };
    let mut out = String::new();
    let _ = match motor {
        MotorStates::Free => writeln!(out, "motor: none; any speed of the rotor is stationary"),
        MotorStates::Kept { speed } => writeln!(out, "motor: keeps the rotor at {} rad/s", speed.to_f64()),
        MotorStates::InStep { speed, angles, bears, fed } => {
            let without = if *fed { "" } else { ", without currents" };
            let _ = writeln!(out, "motor: in step with its field at {} rad/s{without}", speed.to_f64());
            if bears.is_some_and(|bears| bears.least == bears.greatest) {
                let _ =
                    writeln!(out, "  no equilibrium angle: no torque holds the rotor in synchronism, it can only slip");
                return out;
            }
            if angles.is_empty() {
                let _ = writeln!(
                    out,
                    "  no equilibrium angle: friction exceeds the largest torque of the field, so there is no steady motion"
                );
            }
            for angle in angles {
                let currents = currents(&angle.currents);
                let _ = writeln!(out, "  gamma0 = {:.12} rad{currents}: {}", angle.radians(), slope(angle.slope));
            }
            match bears {
                Some(bears) => writeln!(
                    out,
                    "  pull-out: the angles merge where a further load on the rotor reaches {} N m against the field or {} N m with it",
                    bears.greatest, -bears.least
                ),
                None => Ok(()),
            }
        }
        MotorStates::Slipping { speeds, extremes } => {
            let _ = writeln!(out, "motor: by its slip, without an angle");
            for slip in speeds {
                let currents = currents(&slip.currents);
                let _ = writeln!(out, "  phi' = {:.12} rad/s{currents}: {}", slip.speed.to_f64(), slope(slip.slope));
            }
            for extreme in extremes {
                let _ = writeln!(
                    out,
                    "  pull-out: two speeds merge at {:.6} rad/s where a further load on the rotor reaches {:.6e} N m",
                    extreme.speed, extreme.torque
                );
            }
            Ok(())
        }
    };
    out
}

/// The currents from a supply as text.
fn currents(of: &[f64]) -> String {
    let each: Vec<String> = of.iter().map(|current| format!("{current:.6e}")).collect();
    if each.is_empty() { String::new() } else { format!(" with the currents {} A", each.join(", ")) }
}

/// The states of the rotor as JSON.
pub(super) fn object(motor: &MotorStates) -> Value {
    let slip = |slip: &Slip| json!({ "speed": slip.speed.to_f64(), "slope": slip.slope, "currents": slip.currents });
    let angle = |angle: &Angle| json!({ "angle": angle.radians(), "slope": angle.slope, "currents": angle.currents });
    match motor {
        MotorStates::Free => json!({ "kind": "free" }),
        MotorStates::Kept { speed } => json!({ "kind": "kept", "speed": speed.to_f64() }),
        MotorStates::InStep { speed, angles, bears, fed } => json!({
            "kind": "in_step", "speed": speed.to_f64(), "fed": fed, "angles": angles.iter().map(angle).collect::<Vec<_>>(),
            "bears": bears.map(|bears| [bears.least, bears.greatest]),
        }),
        MotorStates::Slipping { speeds, extremes } => json!({
            "kind": "slipping",
            "speeds": speeds.iter().map(slip).collect::<Vec<_>>(),
            "extremes": extremes.iter().map(|e| json!({ "speed": e.speed, "torque": e.torque })).collect::<Vec<_>>(),
        }),
    }
}
