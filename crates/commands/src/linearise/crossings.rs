//! `dalembert linearise --along NAME=FROM..TO`: brackets of the values at which eigenvalues cross the imaginary axis, by enclosures. For each
//! value the motion is that from the start, or, with `--about equilibrium`, the equilibrium found from there.

use super::{Args, Form};
use crate::clock::has_time;
use crate::exit::{Exit, print, warn};
use ::scenes::linearisation::point_of;
use ::scenes::steady_motions::{Crossings, EnclosedSpectrum, EnclosedVerdict, Judged, NotEnclosed};
use ::scenes::{set_values, unit_of};
use model::Model;
use serde_json::{Value, json};
use std::fmt::Write;

/// Prints the brackets of the crossings.
pub(super) fn show(asked: &Args, model: &Model, name: &str, range: [f64; 2]) -> Result<Exit, Exit> {
    let refused = |why: String| Exit::refused(format!("{}: --along {name}: {why}", asked.scene.display()));
    let at = |value: f64| -> Result<(Model, Vec<f64>), String> {
        let mut model = model.clone();
        set_values(&mut model, &[(name.to_owned(), value)])?;
        let ((_, state), _) =
            point_of(&mut model, asked.about == super::About::Equilibrium).map_err(|issue| issue.title)?;
        Ok((model, state))
    };
    // an unacceptable name or start is refused before the search begins
    at(range[0]).map_err(refused)?;
    let spectrum = |value: f64| {
        let (model, state) = at(value).map_err(|_| NotEnclosed::NoMotion)?;
        EnclosedSpectrum::following(&model, &state, has_time)
    };
    let found = Crossings::of(range, spectrum, has_time);
    for (value, why) in &found.open {
        warn(&format!("warning: {}: no enclosures at {name} = {value}: {why}", asked.scene.display()));
    }
    let unit = unit_of(model, name);
    print(&match asked.format {
        Form::Text => text(&found, name, &unit),
        Form::Json => format!("{:#}\n", object(&found, name, &unit)),
        Form::Csv => csv(&found, name),
    })?;
    Ok(if found.open.is_empty() { Exit::Done } else { Exit::Stopped })
}

fn word(Judged { verdict, zeros, .. }: &Judged) -> String {
    match *verdict {
        EnclosedVerdict::Asymptotic => match zeros {
            0 => "asymptotically stable, every eigenvalue left of the imaginary axis".to_owned(),
            1 => "every eigenvalue but one zero with a reason left of the imaginary axis".to_owned(),
            count => format!("every eigenvalue but {count} zeros with reasons left of the imaginary axis"),
        },
        EnclosedVerdict::Unstable(1) => "unstable, one eigenvalue right of the imaginary axis".to_owned(),
        EnclosedVerdict::Unstable(count) => format!("unstable, {count} eigenvalues right of the imaginary axis"),
        EnclosedVerdict::Undecided { on_axis: 0, touching: 0 } => {
            "not decided, every eigenvalue is a zero with a reason".to_owned()
        }
        EnclosedVerdict::Undecided { on_axis, touching: 0 } => {
            let many = if on_axis == 1 { "one eigenvalue".to_owned() } else { format!("{on_axis} eigenvalues") };
            format!("not decided, {many} on the imaginary axis and none right of it")
        }
        EnclosedVerdict::Undecided { touching, .. } => {
            let many = if touching == 1 { "one eigenvalue".to_owned() } else { format!("{touching} eigenvalues") };
            format!("not decided, {many} not separated from the imaginary axis, and none right of it")
        }
    }
}

fn text(found: &Crossings, name: &str, unit: &str) -> String {
    let unit = if unit.is_empty() || unit == "1" { String::new() } else { format!(" {unit}") };
    let mut out = format!("eigenvalues by enclosures, along {name}{unit}\n");
    // writing to a String cannot fail
    for judged in &found.samples {
        let Judged { value, foremost: [re, im], .. } = judged;
        let foremost = match re.is_finite() {
            true => format!("the largest real part is {re:.6e} 1/s, of {:.6} rad/s", im.abs()),
            false => "every eigenvalue is a zero with a reason".to_owned(),
        };
        let _ = writeln!(out, "  {name} = {value:?}: {}; {foremost}", word(judged));
    }
    for [before, after] in &found.changes {
        let _ = writeln!(out, "between {name} = {:?} and {:?}", before.value, after.value);
        let _ = writeln!(out, "  {}, then {}", word(before), word(after));
        let is_decided = |judged: &Judged| !matches!(judged.verdict, EnclosedVerdict::Undecided { .. });
        let kind = if !is_decided(before) && !is_decided(after) {
            "eigenvalues come to the axis, or leave it".to_owned()
        } else if before.foremost[1] != 0.0 && after.foremost[1] != 0.0 {
            format!("a pair crosses the axis at {:.12} rad/s", after.foremost[1].abs())
        } else {
            "a real eigenvalue crosses the axis".to_owned()
        };
        let _ = writeln!(out, "  {kind}");
    }
    let _ = match found.changes.len() {
        0 if found.samples.len() < 2 => writeln!(
            out,
            "changes cannot be found: fewer than two values were judged; along a parameter `dalembert stationary --along {name}=FROM..TO` looks for the \
             steady motions at each value"
        ),
        0 if !found.open.is_empty() => writeln!(out, "no change between the values that were judged"),
        0 => writeln!(out, "no change between these values"),
        _ => writeln!(out, "two changes between neighbours of these values would not be seen"),
    };
    out
}

fn object(found: &Crossings, name: &str, unit: &str) -> Value {
    let one = |judged: &Judged| {
        let foremost = Some(judged.foremost).filter(|[re, _]| re.is_finite());
        json!({ "value": judged.value, "stability": word(judged), "largest_real_part": foremost })
    };
    json!({
        "along": name,
        "unit": unit,
        "samples": found.samples.iter().map(one).collect::<Vec<_>>(),
        "changes": found.changes.iter().map(|ends| ends.each_ref().map(one)).collect::<Vec<_>>(),
        "open": found.open.iter().map(|(value, why)| json!({ "value": value, "why": why.to_string() })).collect::<Vec<_>>(),
    })
}

fn csv(found: &Crossings, name: &str) -> String {
    let mut text = format!("{},real part,imaginary part,stability\n", crate::csv::line(&[name]));
    for judged in found.samples.iter().chain(found.changes.iter().flatten()) {
        let Judged { value, foremost: [re, im], .. } = judged;
        let parts = if re.is_finite() { format!("{re:?},{im:?}") } else { ",".to_owned() };
        let _ = writeln!(text, "{value:?},{parts},{}", crate::csv::line(&[&word(judged)]));
    }
    text
}
