//! A start that deviates from a given state.

use super::{Completed, Unmet, consistent};
use model::{Model, StartValue};

/// A state with some components changed and the others adjusted so that constraints hold. Each change is the index of a coordinate, the order 0 (the
/// coordinate) or 1 (its speed), and the amount in SI units.
///
/// # Errors
/// The constraint that cannot be satisfied with these changes.
pub fn displaced(model: &Model, state: &[f64], by: &[(usize, usize, f64)]) -> Result<Vec<f64>, Unmet> {
    let n = model.positions();
    let value = |(place, &value): (usize, &f64)| {
        let own = by.iter().find(|(coordinate, order, _)| order * n + coordinate == place);
        let added = own.map_or(0.0, |(.., added)| *added);
        StartValue { coordinate: place % n, order: place / n, value: value + added, is_guess: own.is_none() }
    };
    let mut beside = model.clone();
    beside.start_speeds.clear();
    beside.equilibrium = None;
    beside.start = state.iter().enumerate().map(value).collect();
    let Completed { state, .. } = consistent(&beside)?;
    Ok(state)
}
