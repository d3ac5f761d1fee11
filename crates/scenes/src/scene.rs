//! A scene whose system is written in its file.

use crate::admissible::impossible;
use crate::compiled_system::{CompiledSystem, ENERGIES, NotCompiled};
use crate::ensemble::parse_ensemble;
use crate::equilibrium::{NoEquilibrium, equilibrium};
use crate::first_motion::missing;
use crate::modes::{Modes, Refused};
use crate::row_units::{coherent, rate_unit};
use crate::start::{Open, Unmet, consistent};
use crate::text;
use derivations::scene::atlas::{Formulation, Observed, Standing, Way};
use derivations::scene::file::{read_text, tables};
use derivations::scene::problem::Invariant;
use derivations::scene::read::Table;
use derivations::scene::smooth::Parameter;
use derivations::scene::switching::Switching;
use derivations::scene::{Axes, Issue, ModelReaders, Modelled, Problem, Run, SceneError, Smooth, read_models_by, run};
use integrators::Reference;
use model::equations::Level;
use model::{Model, Source, StartValue};
use std::borrow::Cow;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

/// A system that is data, with a run.
#[derive(Debug)]
pub struct ModelScene {
    pub title: String,
    /// The motion in one sentence, and why it is hard.
    pub description: String,
    pub model: Arc<Model>,
    pub system: Arc<CompiledSystem>,
    /// Coordinates, then speeds, at time zero: the constraints hold.
    pub start: Vec<f64>,
    pub run: Run,
}

/// Makes every command read files with `[coordinates]`.
pub fn register() {
    let scene = |name: &str, text: &str| -> Result<Arc<dyn Modelled>, SceneError> {
        Ok(Arc::new(ModelScene::parse(name, text)?))
    };
    read_models_by(ModelReaders { scene, ensemble: parse_ensemble });
}

/// Reads the system of a file, and leaves its run alone: for what needs neither values nor a run.
///
/// # Errors
/// All that is wrong with the system, each at its place.
pub fn read_model(path: &Path) -> Result<Model, SceneError> {
    let text = read_text(path)?;
    let model = tables(&path.display().to_string(), &text, |top, issues| {
        top.known(&["title", "description", "run", "ensemble"]);
        model(top, issues).map(|(model, _)| model)
    });
    model.map_err(text::with_quoted_primes)
}

/// The system of a file with its source; what is wrong with it goes into the list.
pub(crate) fn model(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<(Model, Source)> {
    let source = text::source(top);
    let faults = match Model::of(&source) {
        Ok(model) => return Some((model, source)),
        Err(faults) => faults,
    };
    // what could not be read explains what is missing
    if !top.has_issues() {
        issues.extend(faults.into_iter().map(text::issue));
    }
    None
}

impl ModelScene {
    /// Reads a file; `name` is what messages call it.
    ///
    /// # Errors
    /// All that is wrong with it, each at its place.
    pub fn parse(name: &str, text: &str) -> Result<Self, SceneError> {
        let scene = tables(name, text, |top, issues| {
            // members are read by `parse_ensemble`
            top.known(&["ensemble"]);
            ModelScene::read(top, issues, text)
        });
        scene.map_err(text::with_quoted_primes)
    }

    /// Reads the tables of a file; what is wrong goes into the list.
    pub(crate) fn read(top: &mut Table<'_>, issues: &mut Vec<Issue>, text: &str) -> Option<Self> {
        let title = top.text("title", "one line that says what happens").value;
        let title = title.split_whitespace().collect::<Vec<_>>().join(" ");
        let description = top.optional_text("description", "what happens and why it is hard");
        let model = model(top, issues).map(|(model, _)| Arc::new(model));
        let names = model.as_deref().map(columns);
        let run = match top.has("run") {
            true => run::read(top, issues, names.as_deref()),
            false => {
                issues.push(without_run(text));
                None
            }
        };
        let model = model?;
        let bodies = impossible(&model);
        let exist = bodies.is_empty();
        issues.extend(bodies);
        let ready = exist.then(|| ready(&model))?;
        let (start, system) = ready.map_err(|issue| issues.push(issue)).ok()?;
        let description = description.map_or_else(String::new, |text| text.value.trim().to_owned());
        Some(ModelScene { title, description, model, system, start, run: run? })
    }
}

/// A system that has no law.
pub(crate) fn refused(model: &Model, reason: &NotCompiled) -> Issue {
    let (place, label, accepted) = place_of(model, reason);
    Issue::at(place, format!("this system cannot run: {reason}"), label).accepted(accepted)
}

/// The fault of a file that says nothing of its run, where that would stand: at the end.
fn without_run(text: &str) -> Issue {
    let end = text.trim_end().len();
    let issue = Issue::at(end..end, "the table [run] is missing", "the file ends here");
    issue.accepted("[run] with span = \"10 s\"; `derive` and `prove` need none")
}

/// The start, completed, and the law that runs from it.
fn ready(model: &Arc<Model>) -> Result<(Vec<f64>, Arc<CompiledSystem>), Issue> {
    // before the law: what depends on others makes it singular
    let start = start_of(model)?;
    let system = Modes::of(model).first(&start).map_err(|why| match why {
        Refused::Law(reason) => refused(model, &reason),
        Refused::Motion { why, switch } => {
            let place = switch.map_or(0..0, |switch| model.switch_places[switch].clone());
            let issue = Issue::at(place, format!("this system cannot start: {why}"), "this is at zero at the start");
            issue.accepted(
                "another start: the conditions of `if`, `sign`, `abs`, `min`, `max` and `table` choose its law",
            )
        }
    })?;
    match missing(model, &system, &start) {
        Some(issue) => Err(issue),
        None => Ok((start, system)),
    }
}

/// The state at time zero: as the file gives it, completed so that constraints hold; or an equilibrium, where it asks for one.
///
/// # Errors
/// Why there is none, at its place.
pub fn start_of(model: &Model) -> Result<Vec<f64>, Issue> {
    let completed = match &model.equilibrium {
        None => consistent(model),
        Some(_) => consistent(&at_rest(model, false)?),
    };
    completed.map_err(|unmet| unmet_at(model, unmet))
}

/// What a start does not meet, at its place.
pub(crate) fn unmet_at(model: &Model, unmet: Unmet) -> Issue {
    match unmet {
        Unmet::Open(open) => inconsistent(&open),
        Unmet::Redundant { at, .. } => {
            let title = "this constraint follows from those before it";
            let issue = Issue::at(at, title, "at the start it holds no direction of its own");
            issue.accepted("constraints that are independent: leave this one out")
        }
        Unmet::Gains { at, level } => {
            let (kind, accepted) = match level {
                Level::Position => ("positions has two gains", "gains = [\"2*a\", \"b^2\"]: f'' + 2 a f' + b^2 f = 0"),
                Level::Speed => ("speeds has one gain", "gains = [\"a\"]: f' + a f = 0"),
            };
            Issue::at(at, format!("a programmed constraint of {kind}"), "this one").accepted(accepted)
        }
        Unmet::Piecewise(at) => {
            let issue = Issue::at(at, "a constraint that changes at a condition is not there yet", "this one");
            issue.accepted("constraints without `if`, `sign`, `abs`, `min`, `max` and `table`")
        }
        Unmet::NotCompiled(reason) => refused(model, &reason),
    }
}

/// The equilibrium near the coordinates at the start, all of which may move.
///
/// # Errors
/// Why there is none.
pub fn equilibrium_of(model: &Model) -> Result<Vec<f64>, Issue> {
    Ok(at_rest(model, true)?.start_state())
}

/// The model with an equilibrium as its start.
fn at_rest(model: &Model, all: bool) -> Result<Model, Issue> {
    let found = equilibrium(model, all).map_err(|why| {
        let at = model.equilibrium.clone().unwrap_or_default();
        match why {
            NoEquilibrium::NotCompiled(reason) => refused(model, &reason),
            NoEquilibrium::Moves { speed } => {
                let issue = Issue::at(at, "an equilibrium has no speeds", format!("{speed} is not zero"));
                issue.accepted("speeds that are zero or left out; without `equilibrium` any speeds are accepted")
            }
            NoEquilibrium::NotFound { equation, residual } => {
                let label = format!("{equation} leave {residual:.6e} in SI units at the best point that was found");
                let issue = Issue::at(at, "no equilibrium is found near this start", label);
                issue.accepted("coordinates nearer to one, written as guesses so that they may move: \"guess 0.3 rad\"")
            }
        }
    })?;
    let n = model.positions();
    let value =
        |(place, &value): (usize, &f64)| StartValue { coordinate: place % n, order: place / n, value, is_guess: false };
    let mut rested = model.clone();
    rested.start = found.state.iter().enumerate().map(value).collect();
    Ok(rested)
}

/// Where a system says why it cannot run, what stands there, and what would be accepted.
fn place_of(model: &Model, reason: &NotCompiled) -> (Range<usize>, &'static str, &'static str) {
    let equations = "`dalembert derive` writes its equations down without running them";
    let coordinate = |name: &str| model.coordinates.iter().find(|one| one.name == name).map(|one| one.at.clone());
    let (place, label, accepted) = match reason {
        NotCompiled::Open { what: "parameter", name } => {
            let place = model.parameters.iter().find(|one| one.name == *name).map(|one| one.at.clone());
            (place, "a unit alone", "a number with its unit, such as \"2 kg\"; `derive` and `prove` need none")
        }
        NotCompiled::Open { name, .. } => {
            let place = model.inputs.iter().find(|one| one.name == *name).map(|one| one.at.clone());
            (
                place,
                "a unit alone",
                "u = { unit = \"N\", value = \"(2 N)*sin(t*(3 rad/s))\" }; `derive` and `prove` need none",
            )
        }
        NotCompiled::Tilted { body } => {
            let place = model.bodies.iter().find(|one| one.name == *body).map(|one| one.at.clone());
            (place, "this body", "inertia = { axes = \"C\", principal = [\"A\", \"B\", \"C\"] }")
        }
        NotCompiled::Massless { coordinate: name } => {
            (coordinate(name), "this coordinate", "a body that moves with it, or a constraint that determines it")
        }
        NotCompiled::NotHeld { switch } => (model.switch_places.get(*switch).cloned(), "this condition", equations),
        _ => (None, "in this file", equations),
    };
    (place.unwrap_or(0..0), label, accepted)
}

/// A constraint that the start does not meet.
fn inconsistent(Open { at, name, residual, moved, level }: &Open) -> Issue {
    if let [first, ..] = moved.as_slice() {
        let list = moved.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        let title = format!("{name} was not met from this start");
        let label = match residual {
            Some(residual) => format!("moving {list} left {residual:.6e}, and not zero"),
            None => format!("moving {list} led to where it has no value"),
        };
        return Issue::at(at.clone(), title, label).accepted(format!(
            "another guess in [start], such as {} = \"guess ...\" nearer to a position that exists; or other given values",
            key(first)
        ));
    }
    let what = if *level == Level::Position { "the coordinates" } else { "the speeds" };
    let title = format!("{name} does not hold at the start");
    let label = match residual {
        Some(residual) => format!("{residual:.6e} by {what} that [start] gives, and not zero"),
        None => format!("it has no value by {what} that [start] gives"),
    };
    Issue::at(at.clone(), title, label).accepted(
        "values in [start] that agree; one that is left out, or written as \"guess 0.3 rad\", is completed so that constraints hold",
    )
}

/// A name as a key of TOML.
fn key(name: &str) -> String {
    let is_bare = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    if is_bare { name.to_owned() } else { format!("\"{name}\"") }
}

/// Names of a row: coordinates, speeds, outputs, energies.
pub(crate) fn columns(model: &Model) -> Vec<String> {
    let state = model.state_names().into_iter().map(|(name, _)| name);
    let outputs = model.outputs.iter().map(|output| output.name.clone());
    state.chain(outputs).chain(["kinetic_energy".to_owned(), "potential_energy".to_owned()]).collect()
}

impl Modelled for ModelScene {}

impl Smooth for ModelScene {
    fn title(&self) -> &str {
        &self.title
    }

    fn description(&self) -> &str {
        &self.description
    }

    fn model(&self) -> &'static str {
        "as written in its file"
    }

    fn run(&self) -> &Run {
        &self.run
    }

    fn problem(&self, _axes: Axes) -> Problem {
        let (shown, kept) = (Arc::clone(&self.system), Arc::clone(&self.system));
        let changes = !(self.model.switches.is_empty() && self.model.events.is_empty());
        let modes = changes.then(|| Arc::new(Modes::of(&self.model)));
        let of_mode = modes.clone();
        let row = move |time: f64, state: &[f64]| {
            let current = of_mode.as_ref().and_then(|modes| modes.current());
            [state, &current.as_ref().unwrap_or(&shown).outputs(time, state)].concat()
        };
        let mut invariants = Vec::new();
        if self.system.keeps_energy {
            let energy = move |time: f64, state: &[f64]| {
                let outputs = kept.outputs(time, state);
                outputs[outputs.len() - ENERGIES..].iter().sum()
            };
            invariants.push(Invariant { name: "energy", value: Box::new(energy) });
        }
        Problem {
            law: self.system.law(),
            state: self.start.clone(),
            span: self.run.span,
            invariants,
            columns: columns(&self.model),
            row: Box::new(row),
            margins: Box::new(|_, _| Vec::new()),
            switching: modes.map(|modes| modes as Arc<dyn Switching>),
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        let datum = |parameter: &model::Parameter| Parameter {
            name: parameter.name.clone().into(),
            value: parameter.value.map_or_else(String::new, |value| value.to_string()),
            unit: if parameter.unit == "1" { "".into() } else { parameter.unit.clone().into() },
            meaning: "parameter".into(),
        };
        self.model.parameters.iter().map(datum).collect()
    }

    fn ways(&self) -> Vec<Way> {
        vec![Way::of(Formulation::Minimal, "", Standing::Own, self.problem(Axes::First))]
    }

    fn observed(&self, reference: &Reference) -> Vec<Observed> {
        let names = columns(&self.model);
        names.into_iter().zip(&reference.sizes).map(|(name, size)| Observed { name, size: *size }).collect()
    }

    fn unit(&self, name: &str) -> Cow<'static, str> {
        let rate = |unit: &str| unit.strip_suffix("/s").map_or_else(|| coherent(unit), |of| rate_unit(&coherent(of)));
        let found = self.model.state_names().into_iter().find_map(|(own, unit)| (own == name).then(|| rate(&unit)));
        let energy = || ["kinetic_energy", "potential_energy"].contains(&name).then(|| "J".to_owned());
        let output = || {
            let output = self.model.outputs.iter().find(|output| output.name == name)?;
            Some(coherent(&output.dimension.to_string()))
        };
        found.or_else(energy).or_else(output).unwrap_or_else(|| "1".to_owned()).into()
    }
}
