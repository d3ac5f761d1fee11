//! Linear equations as text, JSON and a table.

use super::Found;
use ::scenes::linearisation::{Linearisation, Standing, VariedEquations};
use model::Model;
use serde_json::json;
use std::fmt::Write;

/// Names of what rows and columns are.
pub(super) struct Names<'a> {
    coordinates: Vec<&'a str>,
    inputs: Vec<&'a str>,
    outputs: Vec<&'a str>,
}

impl<'a> Names<'a> {
    pub(super) fn of(model: &'a Model, equations: &'a VariedEquations) -> Self {
        Names {
            coordinates: model.coordinates.iter().map(|coordinate| coordinate.name.as_str()).collect(),
            inputs: equations.inputs.iter().map(String::as_str).collect(),
            outputs: model.outputs.iter().map(|output| output.name.as_str()).collect(),
        }
    }

    /// Names of the components of x.
    fn states(&self, linear: &Linearisation) -> Vec<String> {
        let coordinates = linear.coordinates.iter().map(|&place| self.coordinates[place].to_owned());
        coordinates.chain(linear.speeds.iter().map(|&place| format!("{}'", self.coordinates[place]))).collect()
    }

    /// Names of the rows and columns of a matrix.
    fn sides(&self, linear: &Linearisation, matrix: &str) -> (Vec<String>, Vec<String>) {
        let owned = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
        let states = self.states(linear);
        let rows = if matrix == "A" || matrix == "B" { states.clone() } else { owned(&self.outputs) };
        (rows, if matrix == "A" || matrix == "C" { states } else { owned(&self.inputs) })
    }
}

fn standing(standing: Standing) -> &'static str {
    match standing {
        Standing::Equilibrium => "equilibrium",
        Standing::Steady => "steady motion",
        Standing::Moving => "moving point",
    }
}

pub(super) fn text(names: &Names<'_>, found: &Found) -> String {
    let Found { linear, eigenvalues, stability, .. } = found;
    let mut text = format!("t = {} s, {}\n", linear.point.time, standing(found.standing));
    let point = &linear.point;
    let values = [("", &point.coordinates), ("'", &point.speeds), ("''", &point.accelerations)];
    for (k, name) in names.coordinates.iter().enumerate() {
        let line = values.map(|(primes, values)| format!("{name}{primes} = {}", number(values[k]).trim()));
        let _ = writeln!(text, "  {}", line.join(", "));
    }
    let _ = writeln!(text, "x = ({})", names.states(linear).join(", "));
    let dependent = names.coordinates.iter().enumerate().filter(|(place, _)| !linear.coordinates.contains(place));
    let fixed_speeds = (0..names.coordinates.len()).filter(|place| !linear.speeds.contains(place));
    let fixed: Vec<String> = dependent
        .map(|(_, name)| (*name).to_owned())
        .chain(fixed_speeds.map(|place| format!("{}'", names.coordinates[place])))
        .collect();
    if !fixed.is_empty() {
        let _ = writeln!(text, "by the constraints: {}", fixed.join(", "));
    }
    for (matrix, rows) in linear.matrices() {
        let (left, above) = names.sides(linear, matrix);
        if left.is_empty() || above.is_empty() {
            continue;
        }
        let wide = left.iter().map(|name| name.chars().count()).max().unwrap_or(0);
        let largest = rows.iter().flatten().fold(0.0, |most: f64, value| most.max(value.abs()));
        let heading: String = above.iter().map(|name| format!(" {name:>19}")).collect();
        let _ = writeln!(text, "{matrix}\n  {:wide$}{heading}", "");
        for (name, row) in left.iter().zip(rows) {
            let entries: String = row.iter().map(|value| format!(" {}", number(shown(*value, largest)))).collect();
            let _ = writeln!(text, "  {name:wide$}{entries}");
        }
    }
    text += "eigenvalues\n";
    for [re, im] in eigenvalues {
        let _ = match im {
            0.0 => writeln!(text, "  {}", number(*re)),
            im if *im < 0.0 => writeln!(text, "  {} - {} i", number(*re), number(-im).trim()),
            im => writeln!(text, "  {} + {} i", number(*re), number(*im).trim()),
        };
    }
    let _ = writeln!(text, "{stability}");
    text
}

/// An entry that rounding alone left reads as zero.
fn shown(value: f64, largest: f64) -> f64 {
    if value.abs() < 1e-14 * largest { 0.0 } else { value }
}

/// Twelve digits, in a column.
fn number(value: f64) -> String {
    let value = if value == 0.0 { 0.0 } else { value };
    let text = match value.abs() {
        size if size == 0.0 || (1e-4..1e6).contains(&size) => {
            let places = if size == 0.0 { 0 } else { 11 - size.log10().floor() as i32 };
            let fixed = format!("{value:.*}", places.max(0) as usize);
            if fixed.contains('.') { fixed.trim_end_matches('0').trim_end_matches('.').to_owned() } else { fixed }
        }
        _ => format!("{value:.11e}"),
    };
    format!("{text:>19}")
}

pub(super) fn object(names: &Names<'_>, found: &Found) -> serde_json::Value {
    let Found { linear, eigenvalues, stability, .. } = found;
    let mut object = json!({
        "time": linear.point.time,
        "point": standing(found.standing),
        "coordinates": linear.point.coordinates.as_slice(),
        "speeds": linear.point.speeds.as_slice(),
        "accelerations": linear.point.accelerations.as_slice(),
        "states": names.states(linear),
        "inputs": names.inputs,
        "outputs": names.outputs,
        "eigenvalues": eigenvalues,
        "stability": stability.to_string(),
    });
    for (name, rows) in linear.matrices() {
        object[name] = json!(rows);
    }
    object
}

/// A row for each entry of a matrix, then for each eigenvalue.
pub(super) fn csv(names: &Names<'_>, all: &[Found]) -> String {
    let mut text = "time [s],matrix,row,column,value\n".to_owned();
    for Found { linear, eigenvalues, .. } in all {
        let time = linear.point.time;
        for (matrix, rows) in linear.matrices() {
            let (left, above) = names.sides(linear, matrix);
            for (row, values) in left.iter().zip(rows) {
                for (column, value) in above.iter().zip(values) {
                    let _ = writeln!(text, "{time:?},{matrix},{row},{column},{value:?}");
                }
            }
        }
        for (place, value) in eigenvalues.iter().enumerate() {
            for (part, value) in ["real", "imaginary"].into_iter().zip(value) {
                let _ = writeln!(text, "{time:?},eigenvalue,{},{part},{value:?}", place + 1);
            }
        }
    }
    text
}
