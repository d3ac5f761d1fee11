//! `dalembert linearise --along NAME`: exact values of a parameter at which stability changes, by Routh's criterion.

use super::{Args, Form};
use crate::exit::{Exit, print};
use ::scenes::steady_motions::{Boundary, ExactAlong, Routh};
use ::scenes::unit_of;
use model::Model;
use serde_json::{Value, json};
use std::fmt::Write;
use units::nearest;

/// The quantity that varies: a parameter; with a range also a coordinate or a speed at the start.
#[derive(Clone, Debug)]
pub struct AlongWhat {
    pub name: String,
    /// The range of values in SI units.
    pub range: Option<[f64; 2]>,
}

/// Parses `p` or `p=0..1`.
pub(super) fn asked(text: &str) -> Result<AlongWhat, String> {
    let Some((name, range)) = text.split_once('=') else {
        return Ok(AlongWhat { name: text.trim().to_owned(), range: None });
    };
    let number = |text: &str| text.trim().parse().ok().filter(|value: &f64| value.is_finite());
    let ends = range.split_once("..").and_then(|(from, to)| Some([number(from)?, number(to)?]));
    let range = ends.filter(|[from, to]| from < to);
    let accepted = || format!("a range that rises, in SI units without the unit, such as {name}=0..1, is accepted");
    Ok(AlongWhat { name: name.trim().to_owned(), range: Some(range.ok_or_else(accepted)?) })
}

/// Prints the values of a parameter at which stability changes.
pub(super) fn show(asked: &Args, model: &Model, state: &[f64], parameter: &str) -> Result<Exit, Exit> {
    let refused = |why: String| Exit::refused(format!("{}: --along {parameter}: {why}", asked.scene.display()));
    let names: Vec<&str> = model.parameters.iter().map(|own| own.name.as_str()).collect();
    if !names.contains(&parameter) {
        return Err(refused(match nearest(parameter, names.iter().copied()) {
            Some(nearest) => format!("no parameter is called so; is `{nearest}` meant?"),
            None => format!("no parameter is called so; there are: {}", names.join(", ")),
        }));
    }
    let found = ExactAlong::of(model, state, parameter).map_err(|why| refused(why.to_string()))?;
    let unit = unit_of(model, parameter);
    print(&match asked.format {
        Form::Text => text(&found, parameter, &unit),
        Form::Json => format!("{:#}\n", object(&found, parameter, &unit)),
        Form::Csv => csv(&found, parameter),
    })?;
    Ok(Exit::Done)
}

fn stability(Routh { left, axis, right, unexplained }: Routh) -> String {
    match (right, axis, unexplained) {
        (0, 0, 0) => format!("stable: {left} eigenvalues left of the imaginary axis, none right of it"),
        (0, ..) => {
            format!("not decided: {axis} eigenvalues on the imaginary axis, {unexplained} zeros without a known reason")
        }
        (1, ..) => "unstable: one eigenvalue right of the imaginary axis".to_owned(),
        (right, ..) => format!("unstable: {right} eigenvalues right of the imaginary axis"),
    }
}

fn place(Boundary { value, exact, degree }: &Boundary) -> String {
    match exact {
        Some(exact) if exact.contains('/') => format!("{exact} = {value:?}"),
        Some(exact) => exact.clone(),
        None => format!("{value:?}, a root of a polynomial of degree {degree}"),
    }
}

fn text(found: &ExactAlong, name: &str, unit: &str) -> String {
    let unit = if unit.is_empty() || unit == "1" { String::new() } else { format!(" {unit}") };
    let mut out = format!("Routh's criterion with exact fractions, along {name}{unit}\n");
    // writing to a String cannot fail
    for (k, count) in found.counts.iter().enumerate() {
        let ends = [k.checked_sub(1).map(|k| found.boundaries[k].value), found.boundaries.get(k).map(|end| end.value)];
        let range = match ends {
            [None, None] => format!("every {name}"),
            [None, Some(high)] => format!("{name} < {high:?}"),
            [Some(low), None] => format!("{name} > {low:?}"),
            [Some(low), Some(high)] => format!("{low:?} < {name} < {high:?}"),
        };
        let _ = writeln!(out, "  {range}: {}", stability(*count));
        if let Some(boundary) = found.boundaries.get(k) {
            let _ = writeln!(out, "  at {name} = {}", place(boundary));
        }
    }
    out
}

fn object(found: &ExactAlong, name: &str, unit: &str) -> Value {
    json!({
        "along": name,
        "unit": unit,
        "boundaries": found.boundaries.iter().map(|one| json!({
            "value": one.value,
            "exact": one.exact,
            "degree": one.degree,
        })).collect::<Vec<_>>(),
        "between": found.counts.iter().map(|count| json!({
            "left": count.left,
            "axis": count.axis,
            "right": count.right,
            "zeros_without_reason": count.unexplained,
            "stability": stability(*count),
        })).collect::<Vec<_>>(),
    })
}

fn csv(found: &ExactAlong, name: &str) -> String {
    let mut text = format!("{},right before,right behind\n", crate::csv::line(&[name]));
    for (boundary, sides) in found.boundaries.iter().zip(found.counts.windows(2)) {
        let _ = writeln!(text, "{:?},{},{}", boundary.value, sides[0].right, sides[1].right);
    }
    text
}
