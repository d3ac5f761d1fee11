//! Results of long computations as plain data, which can be sent between processes. Objects are JSON in the format that the commands of the program
//! print.

use crate::errors::{refused, scene_error};
use crate::time_limit::{end_after, left};
use crate::wording::{in_python, of_python};
use dalembert::commands::{
    Charted, ChosenModel, SteadyMotionsResult, charted, chosen_model, finding_object, steady_motions, unjudged_object,
};
use dalembert::manuscript::{Finding, PaperText};
use dalembert::scenes::steady_motions::{Range, SteadySearch};
use dalembert::scenes::{Given, SystemText, parse_ensemble_with};
use dalembert::simulation::Run;
use dalembert::simulation::ensemble::{EnsembleScene, Row};
use dalembert::simulation::models::Modelled;
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::ops::{ControlFlow, RangeInclusive};
use std::path::PathBuf;
use std::sync::Arc;
use std::thread::available_parallelism;
use std::time::Instant;

/// Judges the claims of a paper: of a file, or of a text with the path of its file. `tell` is called with each claim that has been judged.
#[pyfunction]
pub fn judge_paper<'py>(
    py: Python<'py>,
    path: PathBuf,
    text: Option<String>,
    seconds: f64,
    tell: Py<PyAny>,
) -> PyResult<Bound<'py, PyDict>> {
    let paper = py.detach(|| match text {
        Some(text) => PaperText::parse(&path, text),
        None => PaperText::read(&path),
    });
    let paper = paper.map_err(|error| scene_error(py, &error))?;
    let about = PyDict::new(py);
    about.set_item("title", &paper.title)?;
    about.set_item("citation", &paper.citation)?;
    about.set_item("summary", &paper.summary)?;
    about.set_item("claims", paper.claims.len())?;
    tell.call1(py, (about.clone(),))?;
    let end = end_after(seconds);
    let (mut told, mut failed) = (0, None);
    let hear = |findings: &[Finding]| {
        for finding in findings.iter().skip(told) {
            let heard = Python::attach(|py| tell.call1(py, (object(finding),)).map(drop));
            failed = failed.take().or(heard.err());
        }
        told = findings.len();
    };
    let goes_on = || Instant::now() < end;
    let found = py.detach(|| paper.findings(false, hear, goes_on)).map_err(|error| scene_error(py, &error))?;
    if let Some(failed) = failed {
        return Err(failed);
    }
    about.set_item("findings", found.findings.iter().map(object).collect::<Vec<_>>())?;
    about.set_item(
        "unread",
        found.unjudged.iter().map(|claim| unjudged_object(claim).to_string()).collect::<Vec<_>>(),
    )?;
    Ok(about)
}

/// A claim as JSON, and a sentence if its verdict is not the one that the file expects.
fn object(finding: &Finding) -> (String, Option<String>) {
    (finding_object(finding).to_string(), finding.as_expected().err())
}

/// The steady motions within ranges, as JSON and as text.
pub fn steady(
    py: Python<'_>,
    text: &SystemText,
    ranges: Vec<(String, f64, f64)>,
    boxes: usize,
    seconds: f64,
) -> PyResult<(String, String)> {
    let ranges = ranges.into_iter().map(|(name, from, to)| (name, Range { from, to })).collect();
    let asked = SteadySearch { ranges, boxes, ..SteadySearch::default() };
    let end = end_after(seconds);
    let found = py.detach(|| steady_motions(text, &asked, || Instant::now() < end));
    let SteadyMotionsResult { text, object } = found.map_err(|error| scene_error(py, &of_python(error)))?;
    Ok((object.to_string(), text))
}

/// The choice of a model, as JSON, as text, and as an SVG picture.
pub fn chosen(
    py: Python<'_>,
    (scene, name): (&Arc<dyn Modelled>, &str),
    tolerance: f64,
    outputs: Vec<String>,
) -> PyResult<(String, String, String)> {
    let found = py.detach(|| chosen_model(scene, tolerance, outputs));
    let ChosenModel { text, object, picture } = found.map_err(|why| refused(py, name, why))?;
    Ok((object.to_string(), text, picture))
}

/// The errors and costs of all methods, as JSON, as text, and as SVG pictures over evaluations and over time.
pub fn chart(
    py: Python<'_>,
    (scene, name): (&Arc<dyn Modelled>, &str),
    seconds: f64,
) -> PyResult<(String, String, [String; 2])> {
    let end = end_after(seconds);
    let found = py.detach(|| charted(scene, || left(end)));
    let Charted { text, object, pictures } = found.map_err(|why| refused(py, name, in_python(why.trim_end())))?;
    Ok((object.to_string(), text, pictures))
}

/// The ensemble that a text defines; `run` applies to a text without a table [run].
pub fn ensemble_scene(py: Python<'_>, text: &SystemText, run: Run) -> PyResult<EnsembleScene> {
    let given = Given { run: Some(run), values: text.values.clone(), ..Given::default() };
    let scene = py.detach(|| parse_ensemble_with(&text.name, &text.text, given));
    scene.map_err(|error| scene_error(py, &error))
}

/// Members of an ensemble: the columns with their units, a row of numbers for each member, and the reasons of stopped members.
pub fn ensemble<'py>(
    py: Python<'py>,
    scene: &EnsembleScene,
    members: RangeInclusive<u64>,
    threads: Option<usize>,
    seconds: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let threads = threads.unwrap_or_else(|| available_parallelism().map_or(1, usize::from));
    let end = end_after(seconds);
    let (mut numbers, mut stopped) = (Vec::new(), Vec::new());
    let columns: Vec<(String, String)> = scene
        .headings()
        .into_iter()
        .filter(|heading| !matches!(heading.as_str(), "member" | "stopped" | "fingerprint"))
        .map(|heading| match heading.strip_suffix(']').and_then(|heading| heading.rsplit_once(" [")) {
            Some((name, unit)) => (name.to_owned(), unit.to_owned()),
            None => (heading, "1".to_owned()),
        })
        .collect();
    let width = columns.len();
    let take = |row: Row| {
        let length = numbers.len() + width;
        numbers.extend(&row.drawn);
        numbers.push(row.last.as_ref().map_or(f64::NAN, |last| last.time));
        numbers.push(row.steps as f64);
        if let Some(last) = &row.last {
            numbers.extend(&last.state);
            numbers.extend(last.derived.iter().map(|value| value.unwrap_or(f64::NAN)));
        }
        numbers.resize(length, f64::NAN);
        stopped.push(row.stopped);
        if Instant::now() < end { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let asked = members.end() + 1 - members.start();
    py.detach(|| scene.run(members, threads, take));
    let told = PyDict::new(py);
    let rows = stopped.len();
    told.set_item("members", asked)?;
    told.set_item("columns", columns)?;
    told.set_item("rows", PyArray1::from_vec(py, numbers).reshape([rows, width])?)?;
    told.set_item("stopped", stopped)?;
    Ok(told)
}
