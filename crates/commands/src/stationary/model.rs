//! Steady motions of a system that is written in its file.

use super::Asked;
use crate::arguments::{Format, finite};
use crate::clock;
use crate::exit::{Exit, placed, print, warn};
use crate::progress::Progress;
use ::scenes::steady_motions::{
    Asked as Wanted, Near, NoSteadyMotions, Range, SteadyMotion, SteadyMotions, SteadyStability,
};
use ::scenes::{Task, independent_start, read_titled, unit_of, without_law};
use model::Model;
use reader::Issue;
use serde_json::{Value, json};
use std::fmt::Write;
use std::ops::ControlFlow;
use std::time::Duration;

/// A name with its range.
pub(super) fn named_range(text: &str) -> Result<(String, Range), String> {
    let accepted = || {
        "a coordinate with its range in SI units, such as x=-0.1..0.1, or with one value, x=0.1, is accepted".to_owned()
    };
    let (name, range) = text.split_once('=').ok_or_else(accepted)?;
    let (from, to) = match range.split_once("..") {
        Some((from, to)) => (finite(from)?, finite(to)?),
        None => (finite(range)?, finite(range)?),
    };
    if from > to {
        return Err(format!("{from} is not below {to}; a range that rises is accepted"));
    }
    Ok((name.trim().to_owned(), Range { from, to }))
}

/// Time that is kept for printing.
const PRINTING: Duration = Duration::from_millis(400);

/// Undecided regions that are listed; of the others the number is told.
const MOST_LISTED: usize = 6;

/// Prints all steady motions.
pub(super) fn show(asked: &Asked) -> Result<Exit, Exit> {
    let path = &asked.scene;
    let (title, mut model) = read_titled(path, Task::Vary)?;
    model.close_inputs();
    // constraints that follow from others have no reactions of their own; a start that is missing is no obstacle
    let _ = independent_start(&mut model);
    let progress = Progress::new("steady motions");
    let wanted = Wanted { ranges: asked.range.clone(), boxes: asked.boxes };
    let goes_on = || matches!(clock::goes_on(), ControlFlow::Continue(())) && clock::left() > PRINTING;
    let found = SteadyMotions::of(&model, &wanted, goes_on).map_err(|why| refused(asked, &model, why))?;
    drop(progress);
    print(&match asked.format {
        Format::Text => text(&title, &model, &found),
        Format::Json => format!("{:#}\n", object(&title, &model, &found)),
    })?;
    if !found.is_complete() {
        warn(&format!(
            "warning: {}: {} boxes are undecided; narrower ranges (--range NAME=FROM..TO) or more boxes (--boxes {}) decide more",
            path.display(),
            found.undecided.len(),
            10 * asked.boxes
        ));
        return Ok(Exit::Stopped);
    }
    Ok(Exit::Done)
}

fn refused(asked: &Asked, model: &Model, why: NoSteadyMotions) -> Exit {
    let path = &asked.scene;
    let told = |why: String| Exit::refused(format!("{}: {why}", path.display()));
    let listed = |names: &[String]| names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    match why {
        NoSteadyMotions::NotCompiled(reason) => {
            placed(path, without_law(model, &reason, "steady motions cannot be sought"))
        }
        NoSteadyMotions::OfSpeeds { at } => {
            let issue = Issue::at(at, "steady motions are not sought where a constraint holds speeds", "held here");
            placed(path, issue.accepted("constraints of positions; `linearise --about equilibrium` finds one equilibrium near the start"))
        }
        NoSteadyMotions::Changes => told(
            "its law changes at conditions, contacts or events, where steady motions are not sought; `linearise --about equilibrium` finds one \
             equilibrium near the start"
                .to_owned(),
        ),
        NoSteadyMotions::FreeFrame => told(
            "a frame turns freely, where steady motions are not sought yet; a frame with an axis, or with three angles, is accepted".to_owned(),
        ),
        NoSteadyMotions::OfTime => {
            told("its forces or constraints depend on time: no motion is steady; without time in them they are sought".to_owned())
        }
        NoSteadyMotions::Singular => told("nothing with a mass or an inertia moves with a coordinate".to_owned()),
        NoSteadyMotions::Undefined { why } => told(format!("its equations have no values: {why}")),
        NoSteadyMotions::Unknown { name, nearest: Some(nearest), .. } => {
            told(format!("--range {name}: nothing that is sought is called `{name}`; is `{nearest}` meant?"))
        }
        NoSteadyMotions::Unknown { name, accepted, .. } => {
            told(format!("--range {name}: nothing that is sought is called `{name}`; there are: {}", accepted.join(", ")))
        }
        NoSteadyMotions::AnyValue { name } => told(format!(
            "--range {name}: the equations hold for every value of `{name}`, which is not sought: one value (--range \"{name}=2\") is accepted"
        )),
        NoSteadyMotions::WithoutRange { names } => {
            let options: Vec<String> =
                names.iter().map(|name| format!("--range \"{name}=-1..1\"")).collect();
            told(format!(
                "{} {} no angle of a circle alone: ranges in SI units are needed, such as {}",
                listed(&names),
                if names.len() == 1 { "is" } else { "are" },
                options.join(" ")
            ))
        }
        NoSteadyMotions::Unequal { counts: [equations, unknowns], idle } => told(format!(
            "there are {equations} equations for {unknowns} unknowns, so that steady motions form families or are none{}",
            match idle.is_empty() {
                true => "; fewer constraints, or coordinates without one value, are accepted".to_owned(),
                false => format!("; a value for {} (--range NAME=VALUE) chooses among them", listed(&idle)),
            }
        )),
    }
}

/// Ten digits, without those that say nothing.
fn number(value: f64) -> String {
    let value = if value.abs() < 5e-16 { 0.0 } else { value };
    match value.abs() {
        size if size == 0.0 || (1e-4..1e7).contains(&size) => {
            let places = if size == 0.0 { 0 } else { (9 - size.log10().floor() as i32).max(0) as usize };
            let fixed = format!("{value:.places$}");
            if fixed.contains('.') { fixed.trim_end_matches('0').trim_end_matches('.').to_owned() } else { fixed }
        }
        _ => format!("{value:.9e}"),
    }
}

fn text(title: &str, model: &Model, found: &SteadyMotions) -> String {
    let mut out = format!("{title}\n");
    let unit = |name: &str| match unit_of(model, name).as_str() {
        "1" => String::new(),
        unit => format!(" {unit}"),
    };
    // writing to a String cannot fail
    for unknown in &found.unknowns {
        let range = unknown.range;
        let _ = match unknown.is_circle {
            true => writeln!(out, "sought: {}, the whole circle", unknown.name),
            false => {
                writeln!(out, "sought: {} from {} to {}{}", unknown.name, range.from, range.to, unit(&unknown.name))
            }
        };
    }
    for (name, value) in &found.given {
        let _ = writeln!(out, "given: {name} = {}{}", number(*value), unit(name));
    }
    for name in &found.cyclic {
        let _ = writeln!(out, "any: {name}, which occurs nowhere");
    }
    let boxes = found.examined;
    let count = match found.motions.len() {
        1 => "one steady motion".to_owned(),
        count => format!("{count} steady motions"),
    };
    let _ = match found.is_complete() {
        true => writeln!(out, "\n{count}, each alone in a box, and no other: every one of {boxes} boxes is decided"),
        false => writeln!(
            out,
            "\n{count}, each alone in a box; of {boxes} boxes {} are undecided, {:.1e} of the whole range: there may be others in them",
            found.undecided.len(),
            found.undecided_part
        ),
    };
    for (place, motion) in found.motions.iter().enumerate() {
        let values = found.unknowns.iter().zip(&motion.enclosure).map(|(unknown, [low, high])| {
            format!("{} = {}{}", unknown.name, number(0.5 * (low + high)), unit(&unknown.name))
        });
        let values = values.collect::<Vec<_>>().join(", ");
        let _ = writeln!(out, "  {}  {values}", place + 1);
        let _ = writeln!(out, "     {}", stability(motion, &found.cyclic));
    }
    for region in found.regions.iter().take(MOST_LISTED) {
        let ranges = found.unknowns.iter().zip(&region.hull).map(|(unknown, [low, high])| {
            format!("{} from {} to {}{}", unknown.name, short(*low), short(*high), unit(&unknown.name))
        });
        let _ = writeln!(out, "  ?  {}", ranges.collect::<Vec<_>>().join(", "));
        let _ = writeln!(out, "     {} undecided boxes; by numbers, {}", region.boxes, near(region.near));
    }
    if found.regions.len() > MOST_LISTED {
        let _ =
            writeln!(out, "  ?  and {} other regions (--format json lists them)", found.regions.len() - MOST_LISTED);
    }
    out
}

/// Five digits.
fn short(value: f64) -> String {
    number(format!("{value:.4e}").parse().unwrap_or(value))
}

fn near(near: Near) -> String {
    let directions = |count: usize| if count == 1 { "one direction".to_owned() } else { format!("{count} directions") };
    match near {
        Near::Nothing => "no steady motion is found there".to_owned(),
        Near::Regular => "one steady motion is there, which more boxes would show".to_owned(),
        Near::Merging(count) => {
            format!("steady motions merge there: the equations are singular in {}", directions(count))
        }
        Near::Family(count) => format!("a family: others stand beside it in {}", directions(count)),
    }
}

fn stability(motion: &SteadyMotion, cyclic: &[String]) -> String {
    match &motion.stability {
        SteadyStability::Minimum if cyclic.is_empty() => {
            "stable, proved: the potential energy has a strict minimum (Lagrange, Dirichlet)".to_owned()
        }
        SteadyStability::Minimum => format!(
            "stable but for {}, proved: the potential energy, amended by the kinetic energy at given momenta, has a strict minimum in the others \
             (Routh)",
            cyclic.join(", ")
        ),
        SteadyStability::Falls(1) => "unstable, proved: the potential energy falls in one direction".to_owned(),
        SteadyStability::Falls(count) => {
            format!("unstable, proved: the potential energy falls in {count} directions")
        }
        SteadyStability::FallsOdd(count) => format!(
            "unstable, proved: the amended potential energy falls in an odd number of directions, {count} (Thomson, Tait)"
        ),
        SteadyStability::Linear(linear) => {
            let largest = linear.eigenvalues.iter().map(|value| value[0]).fold(f64::NEG_INFINITY, f64::max);
            match linear.eigenvalues.is_empty() {
                true => linear.stability.to_string(),
                false => format!("{}; the largest real part is {largest:.6e} 1/s", linear.stability),
            }
        }
        SteadyStability::Unknown(why) => format!("stability is not known: {why}"),
    }
}

fn object(title: &str, model: &Model, found: &SteadyMotions) -> Value {
    let motion = |motion: &SteadyMotion| {
        let values =
            found.unknowns.iter().zip(&motion.enclosure).map(|(unknown, at)| (unknown.name.clone(), json!(at)));
        let (verdict, proved, eigenvalues) = match &motion.stability {
            SteadyStability::Minimum => ("stable", true, None),
            SteadyStability::Falls(_) | SteadyStability::FallsOdd(_) => ("unstable", true, None),
            SteadyStability::Linear(linear) => {
                use ::scenes::linearisation::Stability;
                let verdict = match linear.stability {
                    Stability::Unstable(_) => "unstable",
                    Stability::Asymptotic { .. } => "asymptotically stable",
                    _ => "not decided",
                };
                (verdict, false, Some(&linear.eigenvalues))
            }
            SteadyStability::Unknown(_) => ("not known", false, None),
        };
        json!({
            "enclosure": values.collect::<serde_json::Map<_, _>>(),
            "state": motion.state,
            "stability": verdict,
            "proved": proved,
            "reason": stability(motion, &found.cyclic),
            "eigenvalues": eigenvalues,
        })
    };
    json!({
        "title": title,
        "sought": found.unknowns.iter().map(|unknown| json!({
            "name": unknown.name,
            "unit": unit_of(model, &unknown.name),
            "circle": unknown.is_circle,
            "range": [unknown.range.from, unknown.range.to],
        })).collect::<Vec<_>>(),
        "given": found.given.iter().map(|(name, value)| (name.clone(), json!(value))).collect::<serde_json::Map<_, _>>(),
        "cyclic": found.cyclic,
        "complete": found.is_complete(),
        "boxes": found.examined,
        "undecided": found.undecided,
        "regions": found.regions.iter().map(|region| json!({
            "hull": region.hull,
            "boxes": region.boxes,
            "near": near(region.near),
        })).collect::<Vec<_>>(),
        "undecided_part": found.undecided_part,
        "motions": found.motions.iter().map(motion).collect::<Vec<_>>(),
    })
}
