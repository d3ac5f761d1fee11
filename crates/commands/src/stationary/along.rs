//! `dalembert stationary --along`: the steady motions at values of a parameter, and the values at which they change.

use super::Args;
use super::branches;
use super::model::motion;
use super::steady_box::{AlongFound, number};
use super::verdict::verdict;
use crate::arguments::Format;
use crate::exit::{Exit, print, warn};
use crate::output::{Form, Writes};
use ::scenes::steady_motions::{Bifurcation, Change, Range, Sample};
use serde_json::{Value, json};
use std::fmt::Write;

/// The default number of values along a parameter.
const VALUES: usize = 41;

/// Prints the number of motions at each value of the parameter, and brackets of the values at which it changes.
pub(super) fn show(asked: &Args, along: &(String, Range)) -> Result<Exit, Exit> {
    let writes = Writes { command: "stationary", force: asked.force, reads: vec![&asked.scene] };
    let output = writes.optional(asked.out.as_deref(), &[Form::Picture])?;
    let values = asked.values.unwrap_or(VALUES);
    let found = asked.steady.find_along(&asked.scene, along, values)?;
    print(&match asked.format {
        Format::Text => text(&found),
        Format::Json => format!("{:#}\n", object(&found)),
    })?;
    if let Some(output) = output {
        output.write_text(&branches::picture(&found, along.1).svg())?.tell(asked.format)?;
    }
    for (value, why) in &found.left_out {
        let path = asked.scene.display();
        warn(&format!("warning: {path}: steady motions are not sought at {} = {}: {why}", found.name, number(*value)));
    }
    let examined = found.along.samples.len() + found.left_out.len();
    let is_cut = found.along.is_cut || examined < values;
    if is_cut {
        warn(&format!(
            "warning: {}: the time was over after {examined} of {values} values, and changes between these may be missing; more time (--seconds) or \
             fewer values (--values) are accepted",
            asked.scene.display()
        ));
    }
    let open: Vec<String> = found
        .along
        .samples
        .iter()
        .filter(|sample| !sample.found.is_complete())
        .map(|sample| number(sample.value))
        .collect();
    if open.is_empty() {
        return Ok(if is_cut || !found.left_out.is_empty() { Exit::Stopped } else { Exit::Done });
    }
    warn(&format!(
        "warning: {}: boxes are undecided at {} = {}: the neighbouring values are compared instead",
        asked.scene.display(),
        found.name,
        open.join(", ")
    ));
    Ok(Exit::Stopped)
}

pub(super) fn named(change: Change) -> &'static str {
    match change {
        Change::Fold => {
            "two motions appear or vanish together (a fold, a condition that is met, or constraints that become dependent)"
        }
        Change::Pitchfork => "two motions leave a third (pitchfork)",
        Change::Transcritical => "two motions pass through each other and exchange their stability (transcritical)",
        Change::Pair => "a pair of eigenvalues crosses the imaginary axis (Hopf, or gyroscopic stability ends)",
        Change::Exchange => "stability is exchanged",
        Change::Directions => "a motion that is unstable on both sides changes its number of unstable directions",
        Change::AtSingularPlace => {
            "motions appear or vanish at a place at which the coordinates are singular (a bifurcation from this place; other coordinates describe it)"
        }
        Change::Ends => "a branch of motions ends or begins: a condition changes, or friction reaches its bound",
        Change::Leaves => "a motion leaves the ranges",
        Change::LeaveTogether => {
            "two or more motions leave or enter the ranges; wider ranges (--range) follow them further"
        }
        Change::Families => "families of motions appear or vanish, for example positions at which friction holds",
        Change::Infinite => {
            "eigenvalues become infinite, and none crosses the imaginary axis (the inertia, or the rank of the constraints, vanishes)"
        }
        Change::AtValue => "the motions differ at this value alone",
        Change::Several => "several changes at once",
    }
}

/// The numbers of motions by their stability, as text.
fn counted(sample: &Sample) -> String {
    let told: Vec<&str> = sample.found.motions.iter().map(|motion| verdict(motion, &sample.found.cyclic).0).collect();
    let count = |words: &[&str]| told.iter().filter(|told| words.contains(told)).count();
    let (stable, unstable) = (count(&["stable", "asymptotically stable"]), count(&["unstable"]));
    let open = told.len() - unstable - stable;
    let motions = match told.len() {
        0 => "no isolated motion".to_owned(),
        1 => "one motion".to_owned(),
        count => format!("{count} motions"),
    };
    let open = if open == 0 { String::new() } else { format!(", {open} undecided") };
    let families = match sample.found.families.len() {
        0 => String::new(),
        1 => ", and one family".to_owned(),
        count => format!(", and {count} families"),
    };
    let singular = match sample.found.singular_places.len() {
        0 => String::new(),
        1 => ", and one place at which the coordinates are singular".to_owned(),
        count => format!(", and {count} places at which the coordinates are singular"),
    };
    let counts = if told.is_empty() { String::new() } else { format!(": {stable} stable, {unstable} unstable{open}") };
    format!("{motions}{counts}{families}{singular}")
}

fn text(found: &AlongFound) -> String {
    let AlongFound { title, name, unit, along, .. } = found;
    let mut out = format!("{title}\n");
    // writing to a String cannot fail
    let mut last: Option<(String, f64, f64)> = None;
    let mut lines: Vec<(String, f64, f64)> = Vec::new();
    for sample in &along.samples {
        let told = match sample.found.is_complete() {
            true => counted(sample),
            false => format!("{}, and undecided boxes", counted(sample)),
        };
        match &mut last {
            Some((known, _, to)) if *known == told => *to = sample.value,
            _ => {
                lines.extend(last.take());
                last = Some((told, sample.value, sample.value));
            }
        }
    }
    lines.extend(last);
    for (told, from, to) in lines {
        let _ = match from == to {
            true => writeln!(out, "  {name} = {}{unit}: {told}", number(from)),
            false => writeln!(out, "  {name} from {} to {}{unit}: {told}", number(from), number(to)),
        };
    }
    for Bifurcation { before, at, after, change } in &along.bifurcations {
        let [middle, gap] = bracket([before.value, after.value]);
        let _ = writeln!(out, "\nat {name} = {middle} ± {gap}{unit}: {}", named(*change));
        let at =
            at.as_ref().map_or_else(String::new, |at| format!("; at {name} = {} {}", number(at.value), counted(at)));
        let _ = writeln!(out, "  before {}{at}; after {}", counted(before), counted(after));
    }
    if along.bifurcations.is_empty() {
        out += "\nat all values that are decided the motions are equally many, with as many unstable directions; between two values a change and its \
                reverse would not be seen\n";
    }
    out
}

/// The midpoint of a bracket and the bound of its error as text; the printed interval contains the bracket.
fn bracket([low, high]: [f64; 2]) -> [String; 2] {
    let middle = number(0.5 * (low + high));
    let printed: f64 = middle.parse().unwrap_or(0.5 * (low + high));
    let gap = (high - printed).max(printed - low);
    // rounded upwards to two digits
    let unit = 10f64.powf(gap.log10().floor() - 1.0);
    let gap = if gap > 0.0 { (gap / unit).ceil() * unit } else { 0.0 };
    [middle, format!("{gap:.1e}")]
}

fn object(AlongFound { title, name, unit, along, left_out, .. }: &AlongFound) -> Value {
    let sample = |sample: &Sample| {
        json!({
            "value": sample.value,
            "complete": sample.found.is_complete(),
            "singular_places": sample.found.singular_places.len(),
            "motions": sample.found.motions.iter().map(|one| motion(&sample.found, one)).collect::<Vec<_>>(),
        })
    };
    json!({
        "title": title,
        "along": name,
        "unit": unit.trim(),
        "samples": along.samples.iter().map(sample).collect::<Vec<_>>(),
        "left_out": left_out.iter().map(|(value, why)| json!({ "value": value, "why": why })).collect::<Vec<_>>(),
        "changes": along.bifurcations.iter().map(|one| json!({
            "between": [one.before.value, one.after.value],
            "what": named(one.change),
            "before": sample(&one.before),
            "at": one.at.as_ref().map(sample),
            "after": sample(&one.after),
        })).collect::<Vec<_>>(),
    })
}

#[cfg(test)]
mod tests {
    use super::bracket;

    #[test]
    fn a_printed_bracket_holds_both_of_its_ends() {
        for [low, high] in [[5.0, 5.000_000_009_3], [-5.000_000_018_6, -5.0], [0.0, 9.31e-10], [1e9, 1e9 + 1.0]] {
            let [middle, gap] = bracket([low, high]);
            let [middle, gap]: [f64; 2] = [&middle, &gap].map(|text| text.parse().expect("a number"));
            assert!(middle - gap <= low && high <= middle + gap, "{middle} {gap}");
            assert!(gap <= 0.6 * (high - low) + 1e-9 * (1.0 + middle.abs()), "{middle} {gap}");
        }
    }
}
