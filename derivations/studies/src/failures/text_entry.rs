//! Entries of the catalogue of failures as text: scenes with the table `[failure]`.

use super::edge::edge;
use super::trials::{BUDGET, Trial, Tried};
use super::{Exact, Found, NotFound, Threshold, Within};
use integrators::{Failure, Method, Record, Sizes, Span, Tolerance};
use reader::{SceneError, read_text};
use scenes::FailureEntry;
use std::cell::Cell;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// The folder of entries within a folder of scenes.
pub(super) const FOLDER: &str = "failures";

/// The factor by which the bisection is finer than the comparison with theory.
const CLOSER: f64 = 10.0;

/// The entries of a folder of scenes, sorted by file name; entries that cannot be read are errors.
pub fn text_entries(folder: &Path) -> Vec<Result<(PathBuf, FailureEntry), SceneError>> {
    let Ok(files) = std::fs::read_dir(folder.join(FOLDER)) else { return Vec::new() };
    let mut files: Vec<PathBuf> = files.filter_map(|file| Some(file.ok()?.path())).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "toml"));
    files.sort();
    let entry = |file: PathBuf| match read_text(&file) {
        Ok(text) if !is_failure_entry(&text) => None,
        Ok(text) => Some(FailureEntry::parse(&file.display().to_string(), &text).map(|entry| (file, entry))),
        Err(error) => Some(Err(error)),
    };
    files.into_iter().filter_map(entry).collect()
}

/// Reads an entry from its file.
///
/// # Errors
/// All faults of the file, with their positions.
pub fn text_entry(file: &Path) -> Result<FailureEntry, SceneError> {
    FailureEntry::parse(&file.display().to_string(), &read_text(file)?)
}

/// Measures an entry: the threshold by bisection between runs, and the result of every method beyond it. `goes_on` may
/// stop the measurement.
///
/// # Errors
/// [`NotFound`] where the measurement is stopped, or the run at `fails_at` shows another failure than expected.
pub fn measure_text(
    file: &Path,
    entry: &FailureEntry,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Found, NotFound> {
    let broken_off = Cell::new(false);
    let tried = |value: f64| {
        let found = entry.tried(value, goes_on);
        broken_off.set(broken_off.get() || goes_on().is_break());
        found
    };
    let [holds, fails] = entry.between;
    let share = 1.0 / (CLOSER * f64::from(entry.within));
    let measured =
        edge(holds, fails, share, |value| !broken_off.get() && tried(value).is_some_and(|tried| tried.holds));
    let beyond = tried(fails);
    if broken_off.get() {
        return Err(NotFound::BrokenOff { scene: file.to_owned() });
    }
    let exact = match &entry.exact {
        Some(number) => Exact::Number(*number),
        None => Exact::Formula(entry.written.clone(), entry.threshold),
    };
    let threshold = Threshold {
        of: entry.of.clone().into(),
        formula: entry.formula.clone().into(),
        exact,
        unit: entry.unit.clone().into(),
        measured,
        within: Within::Share(entry.within),
    };
    let says = beyond.as_ref().map(|beyond| match (&beyond.failures[..], &beyond.stopped, &beyond.last_law) {
        ([], None, None) => "nothing: the run reaches its end".to_owned(),
        ([], None, Some(event)) => event.clone(),
        ([], Some(stopped), _) => stopped.clone(),
        (failures, ..) => failures.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "),
    });
    if let (Some(expected), Some(beyond)) = (entry.expects, &beyond)
        && !beyond.failures.iter().any(|failure| failure.kind == expected)
    {
        let what = format!("the run at `fails_at` shows no {expected}: {}", says.unwrap_or_default());
        return Err(NotFound::unsuitable(file, what, "the name of the failure that it shows, or no key `expects`,"));
    }
    let trials = trials(entry, fails);
    Ok(Found { thresholds: vec![threshold], diagnosis: says.unwrap_or_default(), trials })
}

/// Trials of every method at the parameter value that fails.
fn trials(entry: &FailureEntry, fails: f64) -> Vec<Trial> {
    let Some((problem, choice)) = entry.problem(fails) else { return Vec::new() };
    let mut tried = Tried { outputs: choice.samples, ..Tried::of(&problem, choice.tolerance) };
    if let Some(steps) = choice.method.steps() {
        tried.steps = steps;
    }
    let (outcome, right, left) = tried.run(RIGHT);
    // components that decay before the first output have their initial size
    let mut sizes = Sizes(problem.state.iter().map(|part| part.abs()).collect());
    let span = Span::new(0.0, problem.span, &problem.state).with_evaluations(BUDGET);
    problem.integrate(RIGHT, &Tolerance::both(choice.tolerance), &span, &mut sizes);
    let Sizes(sizes) = sizes;
    // a motion whose law ends cannot reach the end of the span; after the end of time or evaluations nothing is known
    let is_over = left.is_some() || outcome.failure().is_some_and(|why| !why.is_broken_off() && !is_costly(why));
    let follows = |record: &Record<f64>| match outcome.reached() {
        true => near_motion(record, &right, &sizes, choice.tolerance),
        false => !is_over,
    };
    tried.all(|record| {
        let rows = record.times.iter().zip(&record.states).map(|(time, state)| (problem.row)(*time, state));
        rows.skip(1).all(|row| entry.keeps_row(&problem.columns, &row)) && follows(record)
    })
}

/// The method of the reference run.
const RIGHT: Method = Method::RadauIIA { stages: 7 };

/// The largest relative error of a component in a successful run.
const AS_RIGHT: f64 = 0.1;

/// A component smaller than this multiple of the tolerance times the largest component is not compared.
const TOLERANCES: f64 = 1e3;

/// Whether a run is close to the reference in every component, relative to its size along the motion.
fn near_motion(record: &Record<f64>, right: &Record<f64>, sizes: &[f64], tolerance: f64) -> bool {
    let least = TOLERANCES * tolerance * sizes.iter().copied().fold(0.0, f64::max);
    let is_close = |(a, b): (&Vec<f64>, &Vec<f64>)| {
        a.iter().zip(b).zip(sizes).all(|((a, b), size)| (a - b).abs() <= AS_RIGHT * size.max(least))
    };
    record.states.len() == right.states.len() && record.states.iter().zip(&right.states).all(is_close)
}

/// Whether a run ended because its budget of evaluations was exhausted.
fn is_costly(why: Failure) -> bool {
    matches!(why, Failure::TooManyEvaluations { .. })
}

/// Whether a text is an entry of the catalogue.
fn is_failure_entry(text: &str) -> bool {
    let (top, _) = toml::de::DeTable::parse_recoverable(text);
    top.get_ref().keys().any(|key| key.get_ref() == "failure")
}
