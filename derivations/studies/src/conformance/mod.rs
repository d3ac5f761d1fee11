//! Conformance checks that every motor must pass, based on its laws only; each check gives a verdict.
//!
//! # Overview
//! * [`conform`]: all checks of a motor; [`page`] writes them;
//! * `power`: power balance and passivity;
//! * `frames`: the equations derived in the stator's frame, and with rotated windings;
//! * `housing`: a housing that moves, and the limit of an infinitely heavy one;
//! * `rest`: steady currents, steady states with runs, stiffness;
//! * `slopes`: the Jacobian by two routes;
//! * `units`: dimensions.
//!
//! Identities are decided symbolically for all parameters; inequalities and steady states for the given data.

#[cfg(test)]
mod deceiver;
mod frames;
mod housing;
mod instant;
mod power;
mod rest;
pub mod slopes;
mod units;

use ::units::Dimension;
use claims::finding::{Finding, PropertyVerdict};
use instant::{Doubt, Instant};
use motor::{Motor, catalogue};
use reader::Quantity;
use std::fmt::Write;

/// The verdict on a property from its proof or doubt.
fn verdict_of(proof: Result<(), Doubt>, says: &str) -> PropertyVerdict {
    match proof {
        Ok(()) => PropertyVerdict::Proved(says.to_owned()),
        Err(Doubt::Off(why)) => PropertyVerdict::Fails(why),
        Err(Doubt::Open(why)) => PropertyVerdict::Undecided(format!("the prover gave up: {why}")),
    }
}

/// All checks of a motor with its data.
pub fn conform(motor: &Motor) -> Vec<Finding> {
    let written = motor.letters();
    let dimension = |quantity: &Quantity| Dimension::of(&quantity.unit).of_expressions();
    let dimensions: Vec<_> =
        motor.data().map(|(quantity, _)| (quantity.name.to_string(), dimension(quantity))).collect();
    let instant = Instant::of(&written);
    let rest = rest::Rest::of(motor);
    let findings = [
        ("power", power::balance(&written, &instant)),
        ("passivity", power::passivity(&motor.decimals(), &written)),
        ("frame", frames::stator(&written, &instant)),
        ("windings", frames::turned_windings(&written, &instant)),
        ("housing", housing::momentum(&written, &instant)),
        ("bench", housing::bench(&written)),
        ("currents", rest::currents(&written, &instant)),
        ("stationary", rest.stationary()),
        ("stability", rest.stability()),
        ("stiffness", rest.stiffness()),
        ("jacobian", slopes::jacobian(motor)),
        ("dimensions", units::dimensions(&instant, &dimensions)),
    ];
    findings.map(|(check, verdict)| Finding { check, verdict }).into()
}

/// A motor of the catalogue with typical data of a small motor, distinct for each quantity.
pub fn sample(model: &str) -> Option<Motor> {
    let mut asked = 0;
    let value = |quantity: &Quantity| {
        asked += 1;
        let size = match &*quantity.unit {
            "rad/s" => 30.0,
            "N m" => 0.8,
            "N m s" => 0.004,
            "Wb" | "V s" => 0.06,
            "H" => 0.02,
            "ohm" => 1.5,
            "V" => 12.0,
            _ => 0.3,
        };
        // short decimals, displayed as fractions
        (1e5 * size * f64::from(20 + asked) / 20.0).round() / 1e5
    };
    catalogue::sampled(model, value, 3)
}

/// The findings on a motor as text, with the verdict in the first column.
pub fn page(title: &str, findings: &[Finding]) -> String {
    let mut page = format!("{title}\n");
    for Finding { check, verdict } in findings {
        // writing to a String cannot fail
        let _ = writeln!(page, "{:<15} {check:<11} {}", verdict.name(), verdict.says());
    }
    page
}
