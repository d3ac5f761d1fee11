//! Verdicts on the stability of steady motions, with their reasons, as text and JSON.

use charts::significant;
use mechanics::linear_stability::{HalfPlanes, Inertia};
use nalgebra::Vector3;
use serde_json::{Value, json};
use std::fmt::Write;
use studies::stationary::motor::MotorStates;
use studies::stationary::stability::{Along, Integral, Judged, Reason, StabilityVerdict};

/// The verdicts as text, one line with the reason for each angle of the rotor.
pub fn text(motor: &MotorStates, judged: &[Judged]) -> String {
    let mut out = String::new();
    for (one, angle) in judged.iter().zip(angles(motor)) {
        let at = angle.map_or(String::new(), |angle| format!("at gamma0 = {angle:.6} rad "));
        let _ = writeln!(out, "    {at}{}: {}", name(one.verdict), because(one));
    }
    out
}

/// The verdicts along a family of motions as text: a line for each arc with one verdict, and for each direction with a verdict of its own.
pub fn along(motor: &MotorStates, along: &[Along]) -> String {
    let mut out = String::new();
    for (one, angle) in along.iter().zip(angles(motor)) {
        if let Some(angle) = angle {
            let _ = writeln!(out, "    at gamma0 = {angle:.6} rad");
        }
        for arc in &one.arcs {
            let place = match arc.ends {
                Some([from, to]) => format!("from v = {} to {}", components(from), components(to)),
                None if one.edges.is_empty() => "all of it".to_owned(),
                None => "all else".to_owned(),
            };
            let _ = writeln!(out, "    {place}: {}: {}", named(&arc.judged), because(&arc.judged));
        }
        for edge in &one.edges {
            let _ = writeln!(
                out,
                "    at v = {}: {}: {}",
                components(edge.direction),
                named(&edge.judged),
                because(&edge.judged)
            );
        }
    }
    out
}

fn components(v: Vector3<f64>) -> String {
    format!("({:.8}, {:.8}, {:.8})", v.x, v.y, v.z)
}

/// The verdicts along a family of motions as JSON: arcs and single directions for each angle of the rotor.
pub fn along_objects(motor: &MotorStates, along: &[Along]) -> Vec<Value> {
    let of_angle = |(one, angle): (&Along, Option<f64>)| {
        let arcs = one.arcs.iter().map(|arc| {
            let ends = arc.ends.map(|ends| ends.map(|v| [v.x, v.y, v.z]));
            json!({ "ends": ends, "member": arc.member.each_ref().map(|v| v.to_f64()), "judged": object(&arc.judged) })
        });
        let edges = one.edges.iter().map(|edge| {
            let v = edge.direction;
            json!({ "direction": [v.x, v.y, v.z], "judged": object(&edge.judged) })
        });
        json!({ "angle": angle, "arcs": arcs.collect::<Vec<_>>(), "edges": edges.collect::<Vec<_>>() })
    };
    along.iter().zip(angles(motor)).map(of_angle).collect()
}

/// The verdicts as JSON, one object for each angle of the rotor.
pub fn objects(motor: &MotorStates, judged: &[Judged]) -> Vec<Value> {
    let each = judged.iter().zip(angles(motor)).map(|(one, angle)| {
        let mut object = object(one);
        object["angle"] = json!(angle);
        object
    });
    each.collect()
}

fn object(one: &Judged) -> Value {
    json!({
        "verdict": name(one.verdict), "because": because(one),
        "structural_zeros": one.integrals.iter().map(|integral| letter(*integral)).collect::<Vec<_>>(),
        "zeros_along_the_family": one.along,
        "polynomial": one.polynomial,
        "roots": one.roots.map(|HalfPlanes { left, axis, right, distinct }| json!({
            "left": left, "axis": axis, "distinct_on_axis": distinct, "right": right })),
        "energy": one.energy.map(|Inertia { positive, zero, negative }| json!({
            "positive": positive, "zero": zero, "negative": negative })),
        "energy_is_conserved": one.conservative,
        "growth": one.growth,
    })
}

/// The name of a verdict; for a member of a family with the remark that it applies to the family.
fn named(judged: &Judged) -> String {
    let family = if judged.along > 0 { ", as a family" } else { "" };
    format!("{}{family}", name(judged.verdict))
}

fn angles(motor: &MotorStates) -> Vec<Option<f64>> {
    match motor {
        MotorStates::InStep { angles, .. } => angles.iter().map(|angle| Some(angle.radians())).collect(),
        _ => vec![None],
    }
}

/// The name of a verdict.
pub fn name(verdict: StabilityVerdict) -> &'static str {
    match verdict {
        StabilityVerdict::Stable => "stable",
        StabilityVerdict::AsymptoticallyStableModuloIntegrals => "asymptotically stable modulo the integrals",
        StabilityVerdict::Unstable { .. } => "unstable",
        StabilityVerdict::CannotTell(_) => "not decided",
    }
}

fn letter(integral: Integral) -> &'static str {
    match integral {
        Integral::Vertical => "|v|",
        Integral::Momentum => "x.v",
        Integral::RotorMomentum => "p'",
        Integral::Axis => "x.n",
        Integral::Size => "|x|",
    }
}

/// The rate of growth in 1/s below which it is reported as negligible: a deviation grows by the factor e in thirty years.
const SLOW: f64 = 1e-9;

/// A sentence on the growth rate of the fastest deviation, from its enclosure in 1/s.
fn grows([low, high]: [f64; 2]) -> String {
    let rate = 0.5 * (low + high);
    if rate >= SLOW {
        let plain = (1e-3..1e6).contains(&rate);
        let rate = if plain { significant(rate, 2) } else { format!("{rate:.1e}") };
        return format!("the fastest deviation grows by {rate} 1/s");
    }
    let rate = if low > 0.0 { format!("{rate:.1e}") } else { format!("less than {high:.1e}") };
    format!(
        "no deviation grows by more than {rate} 1/s, which is too slow to be observed; one more digit of the data may change its sign"
    )
}

/// The reason for a verdict.
fn because(judged: &Judged) -> String {
    let number = |n: usize, name: &str| format!("{n} {name}{}", if n == 1 { "" } else { "s" });
    let family = [(1, "the family"), (2, "the family (twice)")]
        .into_iter()
        .filter(|(n, _)| *n == judged.along)
        .map(|(_, name)| name);
    let zeros: Vec<&str> = judged.integrals.iter().map(|integral| letter(*integral)).chain(family).collect();
    let others = format!("other than the zeros of {}", zeros.join(", "));
    let flow = if judged.conservative { "is conserved" } else { "never grows" };
    let energy = judged.energy.map(|Inertia { positive, zero, negative }| {
        format!("E - W p' at fixed integrals: {positive} positive, {zero} vanishing, {negative} negative squares")
    });
    match judged.verdict {
        StabilityVerdict::Stable => format!(
            "E - W p' at fixed integrals is definite ({}) and {flow}",
            judged.energy.map_or(String::new(), |energy| number(energy.positive.max(energy.negative), "square"))
        ),
        StabilityVerdict::AsymptoticallyStableModuloIntegrals => {
            let all = judged.roots.map_or(0, |roots| roots.left);
            format!("all {} {others} have negative real parts (Routh; Lyapunov, Malkin)", number(all, "root"))
        }
        StabilityVerdict::Unstable { right } => {
            let all = judged.roots.map_or(0, |roots| roots.degree());
            let have = if right == 1 { "has a positive real part" } else { "have positive real parts" };
            let growth = judged.growth.map_or_else(String::new, |growth| format!("; {}", grows(growth)));
            format!("{right} of {} {others} {have} (Routh){growth}", number(all, "root"))
        }
        StabilityVerdict::CannotTell(reason) => {
            let why = match reason {
                Reason::Gyroscopic { .. } => {
                    "no root has a positive real part, but some are imaginary, and the energy is not definite: if the motion is stable, \
                     then by gyroscopic forces, and linear analysis does not decide"
                }
                Reason::Neutral => "a further root is zero: motions merge here, or neighbouring motions are steady too",
                Reason::Family => "the numbers of the family are not rational, and no symmetry explains the family",
                Reason::Edge => "on a boundary of stability: the deciding quantity is zero",
                Reason::PullOut => "two states of the rotor merge: a further root is zero",
                Reason::TooFine => "the deciding quantity is too close to zero for 2048 bits",
                Reason::NotStationary => "not a steady motion: the zero roots of the integrals are missing",
            };
            match energy {
                Some(energy) => format!("{why}; {energy}"),
                None => why.to_owned(),
            }
        }
    }
}
