//! `dalembert linearise --period`: Floquet multipliers of a periodic motion.

use super::{Args, Form};
use crate::exit::{Exit, print};
use crate::progress::Progress;
use ::scenes::linearisation::{Multipliers, Names, NoMultipliers, Ones, Orbit, VariedEquations};
use serde_json::{Value, json};
use std::fmt::Write;

/// Prints the Floquet multipliers, and the verdict on stability.
pub(super) fn show(asked: &Args, period: f64) -> Result<Exit, Exit> {
    let refused = |why: String| Exit::refused(format!("{}: {why}", asked.scene.display()));
    let scene = asked.run()?;
    let _progress = Progress::new("the multipliers");
    let found = Multipliers::of(&scene, period).map_err(|why| {
        let component = match why {
            NoMultipliers::Open { component, .. } => {
                let names = scene.model.state_names();
                let name = names.get(component).map_or("a component", |(name, _)| name.as_str());
                format!(" in {name}; a start on a periodic motion and its period, to seven digits, are accepted")
            }
            _ => String::new(),
        };
        refused(format!("there are no multipliers over --period {period}: {why}{component}"))
    })?;
    let equations = VariedEquations::with_inputs(&scene.model, &[], &[])
        .map_err(|_| refused("there are no linear equations".to_owned()))?;
    let states = Names::of(&scene.model, &equations).states(&found.linear);
    print(&match asked.format {
        Form::Text => text(&found, &states),
        Form::Json => format!("{:#}\n", object(&found, &states)),
        Form::Csv => csv(&found, &states),
    })?;
    Ok(Exit::Done)
}

fn reasons(Ones { cyclic, shift, energy }: Ones) -> String {
    let mut all = Vec::new();
    if cyclic > 0 {
        all.push(format!("{cyclic} of coordinates on which nothing depends"));
    }
    if shift {
        all.push("1 since the motion may begin later".to_owned());
    }
    if energy {
        all.push("1 of the energy, which is kept".to_owned());
    }
    all.join("; ")
}

fn verdict(found: &Multipliers) -> String {
    match found.orbit() {
        Orbit::Asymptotic if reasons(found.ones).is_empty() => {
            "every multiplier lies inside the unit circle: asymptotically stable, numerically".to_owned()
        }
        Orbit::Asymptotic => {
            "every other multiplier lies inside the unit circle: asymptotically stable apart from these, numerically"
                .to_owned()
        }
        Orbit::Unstable(1) => "one multiplier lies outside the unit circle: unstable, numerically".to_owned(),
        Orbit::Unstable(count) => format!("{count} multipliers lie outside the unit circle: unstable, numerically"),
        Orbit::Undecided(0) => "there is no other multiplier: linear equations do not decide stability".to_owned(),
        Orbit::Undecided(count) => format!(
            "no other multiplier lies outside the unit circle, and numerically {count} on it: linear equations do not decide stability"
        ),
    }
}

fn text(found: &Multipliers, states: &[String]) -> String {
    let mut text = format!("period {} s, to which the state returns within {:.1e}\n", found.period, found.distance);
    // writing to a String cannot fail
    let _ = writeln!(text, "x = ({})", states.join(", "));
    text += "Floquet multipliers\n";
    for [re, im] in &found.values {
        let size = re.hypot(*im);
        let _ = match im {
            0.0 => writeln!(text, "  {re:.12e}"),
            im if *im < 0.0 => writeln!(text, "  {re:.12e} - {:.12e} i, size {size:.12}", -im),
            im => writeln!(text, "  {re:.12e} + {im:.12e} i, size {size:.12}"),
        };
    }
    let _ = writeln!(text, "estimated error, from two tolerances: {:.1e}", found.error);
    let ones = reasons(found.ones);
    if !ones.is_empty() {
        let _ = writeln!(text, "multipliers that are one: {ones}");
    }
    let _ = writeln!(text, "{}", verdict(found));
    text
}

fn object(found: &Multipliers, states: &[String]) -> Value {
    let rows: Vec<Vec<f64>> = found.monodromy.row_iter().map(|row| row.iter().copied().collect()).collect();
    json!({
        "period": found.period,
        "distance": found.distance,
        "states": states,
        "monodromy": rows,
        "multipliers": found.values,
        "error": found.error,
        "ones": { "cyclic": found.ones.cyclic, "shift": found.ones.shift, "energy": found.ones.energy },
        "stability": verdict(found),
    })
}

fn csv(found: &Multipliers, states: &[String]) -> String {
    let mut text = "matrix,row,column,value\n".to_owned();
    for (row, name) in states.iter().enumerate() {
        for (column, other) in states.iter().enumerate() {
            let _ = writeln!(
                text,
                "{},{:?}",
                crate::csv::line(&["monodromy", name, other]),
                found.monodromy[(row, column)]
            );
        }
    }
    for (place, value) in found.values.iter().enumerate() {
        for (part, value) in ["real", "imaginary"].into_iter().zip(value) {
            let _ = writeln!(text, "multiplier,{},{part},{value:?}", place + 1);
        }
    }
    text
}
