//! Forces along a motion, regulators, regimes at the start and references as plain data, which can be sent between processes. Objects
//! are JSON in the format that the commands of the program print.

use crate::errors::{refused, scene_error};
use crate::time_limit::{end_after, left};
use crate::wording::of_python;
use dalembert::commands::{
    ForceTable, ReferenceResult, RegimesResult, RegulatorResult, WantedForces, consistent_regimes, forces_along,
    reference_solution, regulator,
};
use dalembert::reader::SceneError;
use dalembert::scenes::{Given, ModelScene, SystemText, Task};
use dalembert::simulation::Run;
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The forces along a prescribed motion: columns with their units, and a row of numbers for each instant.
pub fn inverse<'py>(
    py: Python<'py>,
    text: &SystemText,
    motions: &[(String, String)],
    unknowns: &[String],
    times: &[f64],
) -> PyResult<Bound<'py, PyDict>> {
    let wanted = WantedForces { motions, unknowns, times, called: "motions" };
    let found = py.detach(|| forces_along(text, &wanted)).map_err(|error| scene_error(py, &of_python(error)))?;
    let ForceTable { columns, rows, unknowns, multipliers, left_out } = found;
    left_out.iter().for_each(|warning| crate::warn(&format!("{}: {warning}", text.name)));
    let told = PyDict::new(py);
    let shape = [rows.len(), columns.len()];
    told.set_item("columns", columns)?;
    told.set_item("unknowns", unknowns)?;
    told.set_item("multipliers", multipliers)?;
    told.set_item("rows", PyArray1::from_vec(py, rows.concat()).reshape(shape)?)?;
    Ok(told)
}

/// The optimal regulator by the table [regulator] of the text, as JSON and as text.
pub fn regulate(py: Python<'_>, text: &SystemText, run: Run, seconds: f64) -> PyResult<(String, String)> {
    let end = end_after(seconds);
    let found = py.detach(|| {
        let scene = scene(text, run)?;
        regulator(&scene, left(end)).map_err(|issue| text.with_issue(issue))
    });
    let RegulatorResult { text, object } = found.map_err(|error| scene_error(py, &of_python(error)))?;
    Ok((object.to_string(), text))
}

/// The consistent regimes at the start, as JSON and as text.
pub fn regimes(py: Python<'_>, text: &SystemText, title: &str) -> PyResult<(String, String)> {
    let found = py.detach(|| {
        let model = text.model(Task::Run)?;
        consistent_regimes(title, model).map_err(|issue| text.with_issue(issue))
    });
    let RegimesResult { text, object, .. } = found.map_err(|error| scene_error(py, &of_python(error)))?;
    Ok((object.to_string(), text))
}

/// The motion up to the end of a span to the digits on which two methods agree, as JSON and as text.
pub fn reference(
    py: Python<'_>,
    text: &SystemText,
    run: Run,
    span: Option<f64>,
    seconds: f64,
) -> PyResult<(String, String)> {
    let end = end_after(seconds);
    let scene = py.detach(|| scene(text, run));
    let mut scene = scene.map_err(|error| scene_error(py, &of_python(error)))?;
    scene.run.span = span.unwrap_or(scene.run.span);
    let found = py.detach(|| reference_solution(&scene, left(end)));
    let ReferenceResult { text, object } = found.map_err(|why| refused(py, &text.name, why))?;
    Ok((object.to_string(), text))
}

/// The scene of a text; `run` applies to a text without a table [run].
fn scene(text: &SystemText, run: Run) -> Result<ModelScene, SceneError> {
    let given = Given { run: Some(run), values: text.values.clone(), ..Given::default() };
    ModelScene::parse_with(&text.name, &text.text, given)
}
