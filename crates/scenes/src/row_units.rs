//! Names and units of the columns in rows of runs and in other tables.

use model::Model;
use model::equations::{Equation, Level};
use symbolic::Dimension;

/// The name of the column with the work of all loads.
pub(crate) const WORK: &str = "work";

/// Before the name of an energy where the model has a coordinate of this name.
const OF_RUN: &str = "run.";

/// The names of the columns: coordinates, speeds, outputs, kinetic and potential energy.
pub(crate) fn columns(model: &Model) -> Vec<String> {
    let outputs = model.outputs.iter().map(|output| output.name.clone());
    let mut columns: Vec<String> = model.state_names().into_iter().map(|(name, _)| name).chain(outputs).collect();
    for energy in ["kinetic_energy", "potential_energy"] {
        let is_taken = columns.iter().any(|name| name == energy);
        columns.push(if is_taken { format!("{OF_RUN}{energy}") } else { energy.to_owned() });
    }
    columns
}

/// The coherent SI unit of a quantity with the given unit: m for mm, rad for deg. Runs give values in this unit.
pub(crate) fn coherent(unit: &str) -> String {
    match units::Unit::parse(unit) {
        Ok(parsed) if parsed.factors() == [1.0, 1.0] && unit != parsed.dimension().to_string() => unit.to_owned(),
        Ok(parsed) if parsed.dimension().is_number() && unit != "1" => "rad".to_owned(),
        Ok(parsed) => parsed.dimension().coherent(),
        Err(_) => unit.to_owned(),
    }
}

/// A number with at most seven significant digits and its unit, for messages.
pub(crate) fn measured(value: f64, unit: &str) -> String {
    let rounded: f64 = format!("{value:.6e}").parse().unwrap_or(value);
    let number = match rounded.abs() {
        size if size == 0.0 || (1e-4..1e6).contains(&size) => rounded.to_string(),
        _ => format!("{rounded:e}"),
    };
    if unit == "1" { number } else { format!("{number} {unit}") }
}

/// The unit of the time derivative of a quantity: A for C, V for Wb, m/s for m, m/s^2 for m/s.
pub(crate) fn rate_unit(unit: &str) -> String {
    match unit {
        "C" => return "A".to_owned(),
        "Wb" => return "V".to_owned(),
        _ => {}
    }
    if let Some(of) = unit.strip_suffix("/s") {
        return format!("{of}/s^2");
    }
    let rate = format!("{unit}/s");
    match units::Unit::parse(&rate) {
        Ok(parsed) if unit.contains('/') => parsed.dimension().coherent(),
        _ => rate,
    }
}

/// The unit in which runs and tables give the quantity `name` of a model: a state, output, energy, parameter, input or component of a body's
/// velocity; `1` for a quantity without a unit or an unknown name.
pub fn unit_of(model: &Model, name: &str) -> String {
    let rate = |unit: &str| unit.strip_suffix("/s").map_or_else(|| coherent(unit), |of| rate_unit(&coherent(of)));
    let state = model.state_names().into_iter().find_map(|(own, unit)| (own == name).then(|| rate(&unit)));
    let plain = name.strip_prefix(OF_RUN).unwrap_or(name);
    let energy = || ["kinetic_energy", "potential_energy", WORK].contains(&plain).then(|| "J".to_owned());
    let output = || {
        let output = model.outputs.iter().find(|output| output.name == name)?;
        Some(coherent(&output.dimension.to_string()))
    };
    let parameter = || Some(model.parameters.iter().find(|parameter| parameter.name == name)?.unit.clone());
    let input = || Some(coherent(&model.inputs.iter().find(|input| input.name == name)?.unit));
    let known = state.or_else(output).or_else(energy).or_else(parameter).or_else(input);
    let component = || Some(model.clone().body_velocities().into_iter().find(|own| own.name == name)?.unit());
    known.or_else(component).unwrap_or_else(|| "1".to_owned())
}

/// The unit of the time derivative of a quantity in a coherent unit: m/s^2 for m/s.
pub fn unit_of_rate(unit: &str) -> String {
    rate_unit(unit)
}

/// The unit of a generalised force: energy divided by the dimension `along` of its coordinate.
pub(crate) fn force_unit(along: Dimension) -> String {
    let (length, time) = (Dimension::length(), Dimension::time());
    coherent(&(Dimension::mass() * length * length / (time * time) / along).to_string())
}

/// The unit of a constraint's multiplier: energy, or for constraints of speeds power, divided by the unit of the constraint.
pub(crate) fn multiplier_unit(model: &Model, constraint: &Equation) -> String {
    let zero = model.constraints.iter().find(|own| own.at == constraint.at);
    let zero = zero.map_or_else(Dimension::none, |own| own.dimension);
    let (length, time) = (Dimension::length(), Dimension::time());
    let energy = Dimension::mass() * length * length / (time * time);
    let multiplier = match constraint.level {
        Level::Position => energy / zero,
        Level::Speed => energy / time / zero,
    };
    coherent(&multiplier.to_string())
}
