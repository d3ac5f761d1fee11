//! Verdicts on the stability of stationary motions, with what each rests on, as text and JSON.

use derivations::stationary::motor::Motor;
use derivations::stationary::stability::{Integral, Judged, Reason, Verdict};
use mechanics::first_approximation::{HalfPlanes, Inertia};
use serde_json::{Value, json};
use std::fmt::Write;

/// A line for each angle of the rotor, and one for what it rests on.
pub fn text(motor: &Motor, judged: &[Judged]) -> String {
    let mut out = String::new();
    for (one, angle) in judged.iter().zip(angles(motor)) {
        let at = angle.map_or(String::new(), |angle| format!("at gamma0 = {angle:.6} rad "));
        let _ = writeln!(out, "    {at}{}: {}", name(one.verdict), because(one));
    }
    out
}

/// The same for a program.
pub fn objects(motor: &Motor, judged: &[Judged]) -> Vec<Value> {
    let each = judged.iter().zip(angles(motor)).map(|(one, angle)| {
        json!({
            "angle": angle, "verdict": name(one.verdict), "because": because(one),
            "structural_zeros": one.integrals.iter().map(|integral| letter(*integral)).collect::<Vec<_>>(),
            "polynomial": one.polynomial,
            "roots": one.roots.map(|HalfPlanes { left, axis, right, distinct }| json!({
                "left": left, "axis": axis, "distinct_on_axis": distinct, "right": right })),
            "energy": one.energy.map(|Inertia { positive, zero, negative }| json!({
                "positive": positive, "zero": zero, "negative": negative })),
            "energy_is_conserved": one.conservative,
        })
    });
    each.collect()
}

fn angles(motor: &Motor) -> Vec<Option<f64>> {
    match motor {
        Motor::InStep { angles, .. } => angles.iter().map(|angle| Some(angle.radians())).collect(),
        _ => vec![None],
    }
}

/// The name of a verdict.
pub fn name(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Stable => "stable",
        Verdict::AsymptoticallyStableModuloIntegrals => "asymptotically stable modulo the integrals",
        Verdict::Unstable { .. } => "unstable",
        Verdict::CannotTell(_) => "not decided",
    }
}

fn letter(integral: Integral) -> &'static str {
    match integral {
        Integral::Vertical => "|v|",
        Integral::Momentum => "x.v",
        Integral::RotorMomentum => "p'",
    }
}

/// What a verdict rests on.
fn because(judged: &Judged) -> String {
    let number = |n: usize, name: &str| format!("{n} {name}{}", if n == 1 { "" } else { "s" });
    let zeros: Vec<&str> = judged.integrals.iter().map(|integral| letter(*integral)).collect();
    let beside = format!("beside the zeros of {}", zeros.join(", "));
    let flow = if judged.conservative { "is conserved" } else { "never grows" };
    let energy = judged.energy.map(|Inertia { positive, zero, negative }| {
        format!("E - W p' at fixed integrals: {positive} positive, {zero} vanishing, {negative} negative squares")
    });
    match judged.verdict {
        Verdict::Stable => format!(
            "E - W p' at fixed integrals is definite ({}) and {flow}",
            judged.energy.map_or(String::new(), |energy| number(energy.positive.max(energy.negative), "square"))
        ),
        Verdict::AsymptoticallyStableModuloIntegrals => {
            let all = judged.roots.map_or(0, |roots| roots.left);
            format!("all {} lie to the left, {beside} (Routh; Lyapunov, Malkin)", number(all, "root"))
        }
        Verdict::Unstable { right } => {
            let all = judged.roots.map_or(0, |roots| roots.degree());
            let lie = if right == 1 { "lies" } else { "lie" };
            format!("{right} of {} {lie} to the right, {beside} (Routh)", number(all, "root"))
        }
        Verdict::CannotTell(reason) => {
            let why = match reason {
                Reason::Gyroscopic { .. } => {
                    "no root to the right, but some on the axis, and the energy is not definite: if it is stable, then by \
                     gyroscopic forces, and linear analysis cannot tell"
                }
                Reason::Neutral => "a further root is zero: motions merge here, or their neighbours are stationary too",
                Reason::Family => "one of a connected family, whose neighbours are stationary too",
                Reason::PullOut => "two states of the rotor merge: a further root is zero",
                Reason::TooFine => "what decides is nearer to zero than 2048 bits tell",
                Reason::NotStationary => "the zero roots of the integrals are not there: no stationary motion",
            };
            match energy {
                Some(energy) => format!("{why}; {energy}"),
                None => why.to_owned(),
            }
        }
    }
}
