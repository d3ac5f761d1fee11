//! Linear equations as text, JSON and CSV.

use crate::csv::{headed as csv_headed, line};
use crate::spectrum;
use ::scenes::linearisation::{Linear, Names, Point, Standing, VariedEquations};
use ::scenes::steady_motions::{EnclosedSpectrum, NotEnclosed};
use ::scenes::{unit_of, unit_of_rate};
use model::Model;
use nalgebra::DVector;
use serde_json::json;
use std::collections::HashMap;
use std::fmt::Write;

/// The linear equations at a point. At a steady motion, `enclosed` contains enclosures of the eigenvalues, or the reason for which there are none.
pub(super) struct Found {
    pub linear: Linear,
    pub enclosed: Option<Result<EnclosedSpectrum, NotEnclosed>>,
}

/// The names of rows and columns of the matrices, without and with units.
pub(super) struct Headed {
    names: Names,
    headed: HashMap<String, String>,
    /// The units of coordinates, of speeds and of their rates.
    units: HashMap<String, String>,
}

impl Headed {
    pub(super) fn of(model: &Model, equations: &VariedEquations) -> Self {
        let names = Names::of(model, equations);
        let shown = [&names.displacements, &names.speeds, &names.inputs, &names.outputs].into_iter().flatten();
        let headed = shown.map(|name| {
            let unit = if name.starts_with("turn about ") { "rad".to_owned() } else { unit_of(model, name) };
            (name.clone(), csv_headed(name, &unit))
        });
        let coordinates = names.coordinates.iter().map(|name| (name.clone(), unit_of(model, name)));
        let speeds = names.speeds.iter().flat_map(|name| {
            let unit = unit_of(model, name);
            let rate = unit_of_rate(&unit);
            [(name.clone(), unit), (format!("{name}'"), rate)]
        });
        let units = coordinates.chain(speeds).collect();
        Headed { headed: headed.collect(), units, names }
    }

    /// The coordinates, speeds and accelerations of a point as text. Rounding errors are shown as zero, and at a steady motion all accelerations.
    fn point(&self, point: &Point, standing: Standing) -> String {
        let still = if standing == Standing::Moving { 1.0 } else { 0.0 };
        let point = Point {
            coordinates: without_rounding(&point.coordinates),
            speeds: without_rounding(&point.speeds),
            accelerations: without_rounding(&point.accelerations) * still,
            ..point.clone()
        };
        let written = |name: &str, value: f64| {
            let unit = self.units.get(name).filter(|unit| *unit != "1");
            let unit = unit.map_or_else(String::new, |unit| format!(" {unit}"));
            format!("{name} = {}{unit}", number(value).trim())
        };
        let rates = |place: usize| {
            let name = &self.names.speeds[place];
            [written(name, point.speeds[place]), written(&format!("{name}'"), point.accelerations[place])]
        };
        let own = self.names.speeds.iter().filter(|name| name.ends_with('\'')).count();
        let mut text = String::new();
        for (place, (name, &value)) in self.names.coordinates.iter().zip(&point.coordinates).enumerate() {
            let line = if place < own {
                [&[written(name, value)][..], &rates(place)].concat()
            } else {
                vec![written(name, value)]
            };
            let _ = writeln!(text, "  {}", line.join(", "));
        }
        (own..self.names.speeds.len()).for_each(|place| {
            let _ = writeln!(text, "  {}", rates(place).join(", "));
        });
        text
    }
}

fn standing(standing: Standing) -> &'static str {
    match standing {
        Standing::Equilibrium => "equilibrium",
        Standing::SteadyCurrents => "equilibrium with steady currents",
        Standing::Steady => "steady motion",
        Standing::Moving => "moving point",
    }
}

pub(super) fn text(headed: &Headed, Found { linear: found, enclosed }: &Found) -> String {
    let Linear { linear, eigenvalues, .. } = found;
    let mut text = format!("t = {} s, {}\n", linear.point.time, standing(found.standing));
    text += &headed.point(&linear.point, found.standing);
    let states = headed.names.states(linear);
    let _ = match states.is_empty() {
        true => writeln!(text, "x is empty: the constraints determine every coordinate and every speed"),
        false => writeln!(text, "x = ({})", states.join(", ")),
    };
    let dependent = |names: &[String], free: &[usize]| -> Vec<String> {
        names.iter().enumerate().filter(|(place, _)| !free.contains(place)).map(|(_, name)| name.clone()).collect()
    };
    let fixed =
        [dependent(&headed.names.displacements, &linear.coordinates), dependent(&headed.names.speeds, &linear.speeds)]
            .concat();
    if !fixed.is_empty() {
        let _ = writeln!(text, "by the constraints: {}", fixed.join(", "));
    }
    for (matrix, rows) in linear.matrices() {
        let (left, above) = headed.names.sides(linear, matrix);
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
    if !eigenvalues.is_empty() {
        text += "eigenvalues\n";
    }
    for [re, im] in eigenvalues {
        let _ = match im {
            0.0 => writeln!(text, "  {}", number(*re)),
            im if *im < 0.0 => writeln!(text, "  {} - {} i", number(*re), number(-im).trim()),
            im => writeln!(text, "  {} + {} i", number(*re), number(*im).trim()),
        };
    }
    if let (false, Some(Ok(enclosed))) = (eigenvalues.is_empty(), enclosed) {
        text += &spectrum::lines(enclosed);
    }
    let _ = writeln!(text, "{}", verdict(found, enclosed.as_ref()));
    text
}

/// The verdict on stability: by enclosures where these decide it, or prove that the linear equations do not; otherwise by floating-point numbers.
fn verdict(
    Linear { eigenvalues, stability, .. }: &Linear,
    enclosed: Option<&Result<EnclosedSpectrum, NotEnclosed>>,
) -> String {
    match enclosed.filter(|_| !eigenvalues.is_empty()) {
        // where exact arithmetic leaves the verdict open, floating-point numbers cannot decide it either
        Some(Ok(enclosed)) if spectrum::is_decided(enclosed) || enclosed.exact.is_some() => spectrum::verdict(enclosed),
        Some(Ok(enclosed)) => {
            let stability = enclosed.by_centres().unwrap_or(*stability);
            format!("{}; by numbers, {stability}", spectrum::verdict(enclosed))
        }
        Some(Err(why)) => format!("{stability}\neigenvalues and stability are numerical, without enclosures: {why}"),
        None => stability.to_string(),
    }
}

/// The values with those replaced by zero that are rounding errors compared with the largest.
fn without_rounding(values: &DVector<f64>) -> DVector<f64> {
    values.map(|value| shown(value, values.amax()))
}

/// The value, or zero where it is a rounding error compared with the largest one.
fn shown(value: f64, largest: f64) -> f64 {
    if value.abs() < 1e-14 * largest { 0.0 } else { value }
}

/// A number with twelve significant digits, padded for a column.
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

pub(super) fn object(headed: &Headed, Found { linear: found, enclosed }: &Found) -> serde_json::Value {
    let Linear { linear, eigenvalues, .. } = found;
    let mut object = json!({
        "time": linear.point.time,
        "point": standing(found.standing),
        "coordinates": linear.point.coordinates.as_slice(),
        "speeds": linear.point.speeds.as_slice(),
        "accelerations": linear.point.accelerations.as_slice(),
        "states": headed.names.states(linear),
        "inputs": headed.names.inputs,
        "outputs": headed.names.outputs,
        "eigenvalues": eigenvalues,
        "stability": verdict(found, enclosed.as_ref()),
        "enclosed": enclosed.as_ref().and_then(|found| found.as_ref().ok()).map(spectrum::object),
        "not_enclosed": enclosed.as_ref().and_then(|found| found.as_ref().err()).map(ToString::to_string),
    });
    for (name, rows) in linear.matrices() {
        object[name] = json!(rows);
    }
    object
}

/// The CSV table: a row for each entry of a matrix, then for each eigenvalue. Names of rows and columns contain their units. The unit of an entry is that
/// of its row divided by that of its column, and per second in A and B.
pub(super) fn csv(headed: &Headed, all: &[Found]) -> String {
    let mut text = "time [s],matrix,row,column,value\n".to_owned();
    for Found { linear: Linear { linear, eigenvalues, .. }, .. } in all {
        let time = linear.point.time;
        for (matrix, rows) in linear.matrices() {
            let (left, above) = headed.names.sides(linear, matrix);
            for (row, values) in left.iter().zip(rows) {
                for (column, value) in above.iter().zip(values) {
                    let cells = [&format!("{time:?}"), matrix, &headed.headed[row], &headed.headed[column]];
                    let _ = writeln!(text, "{},{value:?}", line(&cells));
                }
            }
        }
        for (place, value) in eigenvalues.iter().enumerate() {
            for (part, value) in ["real", "imaginary"].into_iter().zip(value) {
                let _ = writeln!(text, "{time:?},eigenvalue,{},{part} [1/s],{value:?}", place + 1);
            }
        }
    }
    text
}
