//! Enclosed eigenvalues as text and JSON: exact zeros with their reasons, enclosing discs, and the verdict on stability.

use ::scenes::steady_motions::{EigenvalueDisc, EnclosedSpectrum, EnclosedVerdict, Side, ZeroReason};
use serde_json::{Value, json};
use std::fmt::Write;

/// The numbers of zero eigenvalues by their reasons, as text: `5 of x, y, yaw, rear, front, on which nothing depends; 1 of the energy, which is kept`.
fn zeros(all: &[ZeroReason]) -> String {
    let named = |of: &dyn Fn(&ZeroReason) -> Option<&String>| -> Vec<&str> {
        all.iter().filter_map(of).map(String::as_str).collect()
    };
    let count = |kind: &ZeroReason| all.iter().filter(|reason| *reason == kind).count();
    let cyclic = named(&|reason| match reason {
        ZeroReason::Cyclic(name) => Some(name),
        _ => None,
    });
    let momenta = named(&|reason| match reason {
        ZeroReason::Momentum(name) => Some(name),
        _ => None,
    });
    let mut parts = Vec::new();
    if !cyclic.is_empty() {
        parts.push(format!("{} of {}, on which nothing depends", cyclic.len(), cyclic.join(", ")));
    }
    if !momenta.is_empty() {
        let are = if momenta.len() == 1 { "the momentum" } else { "the momenta" };
        let kept = if momenta.len() == 1 { "is kept" } else { "are kept" };
        parts.push(format!("{} of {are} of {}, which {kept}", momenta.len(), momenta.join(", ")));
    }
    if count(&ZeroReason::Energy) > 0 {
        parts.push("1 of the energy, which is kept".to_owned());
    }
    match count(&ZeroReason::Family) {
        0 => {}
        count => parts.push(format!("{count} of speeds, for every value of which there is a steady motion")),
    }
    match count(&ZeroReason::SpeedConstraints) {
        0 => {}
        count => parts.push(format!(
            "{count} of the constraints of speeds, which leave fewer speeds than displacements: equilibria form a family"
        )),
    }
    parts.join("; ")
}

/// A line on the zero eigenvalues, and one line for each disc.
pub(crate) fn lines(found: &EnclosedSpectrum) -> String {
    let mut out = "eigenvalues by enclosures\n".to_owned();
    // writing to a String cannot fail
    if !found.zeros.is_empty() {
        let _ = writeln!(out, "  zero, exactly: {} ({})", found.zeros.len(), zeros(&found.zeros));
    }
    for EigenvalueDisc { centre: [re, im], radius, count, side } in &found.discs {
        let count = if *count == 1 { String::new() } else { format!(", {count} of them") };
        if !radius.is_finite() {
            let _ = writeln!(out, "  not enclosed{count}");
            continue;
        }
        let place = match (side, im) {
            (Side::Axis, im) => format!("{im:?} i, on the imaginary axis"),
            (_, 0.0) => format!("{re:?}"),
            (_, im) if *im < 0.0 => format!("{re:?} - {:?} i", -im),
            (_, im) => format!("{re:?} + {im:?} i"),
        };
        let open = if *side == Side::Undecided { ", which touches the imaginary axis" } else { "" };
        let _ = writeln!(out, "  {place} within {radius:.1e}{count}{open}");
    }
    out
}

/// The verdict on stability by enclosed eigenvalues, or by Routh's criterion where the matrices are exact.
pub(crate) fn verdict(found: &EnclosedSpectrum) -> String {
    let but = match found.zeros.len() {
        0 => String::new(),
        1 => format!(" but for one zero ({})", zeros(&found.zeros)),
        count => format!(" but for {count} zeros ({})", zeros(&found.zeros)),
    };
    let beside = match found.zeros.len() {
        0 => String::new(),
        1 => format!("; one zero has a reason ({})", zeros(&found.zeros)),
        count => format!("; {count} zeros have reasons ({})", zeros(&found.zeros)),
    };
    let by = if found.exact.is_some() { "by Routh's criterion with exact fractions" } else { "by enclosures" };
    let many =
        |count: usize| if count == 1 { "one eigenvalue lies".to_owned() } else { format!("{count} eigenvalues lie") };
    match found.verdict() {
        EnclosedVerdict::Asymptotic if found.zeros.is_empty() => {
            format!("asymptotically stable, {by}: every eigenvalue lies left of the imaginary axis")
        }
        EnclosedVerdict::Asymptotic => {
            format!("every eigenvalue lies left of the imaginary axis, {by},{but}: asymptotically stable in all others")
        }
        EnclosedVerdict::Unstable(count) => format!("unstable, {by}: {} right of the imaginary axis", many(count)),
        EnclosedVerdict::Undecided { on_axis: 0, touching: 0 } => {
            format!("not decided by linear equations: every eigenvalue is zero ({})", zeros(&found.zeros))
        }
        EnclosedVerdict::Undecided { on_axis, touching: 0 } => {
            format!(
                "not decided by linear equations: {} on the imaginary axis, {by}, and none with positive real part{beside}",
                many(on_axis)
            )
        }
        EnclosedVerdict::Undecided { touching, .. } if found.exact.is_some() => format!(
            "not decided by linear equations: zeros without a known reason, by exact fractions: {touching}; no eigenvalue lies right of the \
             imaginary axis{beside}"
        ),
        EnclosedVerdict::Undecided { touching, .. } => format!(
            "not decided: the discs of {touching} eigenvalues touch the imaginary axis, and none lies completely right of it{beside}"
        ),
    }
}

/// Whether the eigenvalues decide stability, or prove that the linear equations do not decide it.
pub(crate) fn is_decided(found: &EnclosedSpectrum) -> bool {
    !matches!(found.verdict(), EnclosedVerdict::Undecided { touching, .. } if touching > 0)
}

/// The verdict in one or two words.
pub(crate) fn word(found: &EnclosedSpectrum) -> &'static str {
    match found.verdict() {
        EnclosedVerdict::Asymptotic => "asymptotically stable",
        EnclosedVerdict::Unstable(_) => "unstable",
        EnclosedVerdict::Undecided { .. } => "not decided",
    }
}

/// The eigenvalues as JSON.
pub(crate) fn object(found: &EnclosedSpectrum) -> Value {
    let reason = |reason: &ZeroReason| match reason {
        ZeroReason::Cyclic(name) => json!({ "cyclic": name }),
        ZeroReason::Momentum(name) => json!({ "momentum": name }),
        ZeroReason::Energy => json!("energy"),
        ZeroReason::Family => json!("family"),
        ZeroReason::SpeedConstraints => json!("constraints of speeds"),
    };
    let side = |side: Side| match side {
        Side::Left => "left",
        Side::Axis => "axis",
        Side::Right => "right",
        Side::Undecided => "undecided",
    };
    json!({
        "zeros": found.zeros.iter().map(reason).collect::<Vec<_>>(),
        "discs": found.discs.iter().map(|disc| json!({
            "centre": disc.centre,
            "radius": disc.radius,
            "count": disc.count,
            "side": side(disc.side),
        })).collect::<Vec<_>>(),
        "routh": found.exact.map(|exact| json!({
            "left": exact.left,
            "axis": exact.axis,
            "right": exact.right,
            "zeros_without_reason": exact.unexplained,
        })),
        "stability": word(found),
    })
}
