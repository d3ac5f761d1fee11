//! Scenes whose system is defined in their file.

mod diagnosis;
mod system_source;

pub(crate) use system_source::{model, model_with, written};

use crate::admissible::impossible;
use crate::changing_laws::{changes, is_watched};
use crate::compiled_system::{CompiledSystem, ENERGIES};
use crate::ensemble::parse_ensemble;
use crate::formulations::formulations;
use crate::inductances::impossible_inductances;
use crate::known_as::asked_for;
use crate::modes::{BROKEN, ModeValues, Modes, mode_values_lengths};
use crate::named_systems;
use crate::power_balance::metered;
use crate::quoted_keys::with_quoted_primes;
use crate::readiness::{Ready, ready, starting, without_run};
use crate::row_units::{columns, unit_of};
use crate::size::{Task, too_large};
use crate::start::{KeptConstraints, SingularPositions, consistent};
use crate::warnings::{Warn, warn_by, warn_of};
use diagnosis::failures;
use integrators::Reference;
use model::{Entry, Event, Model, Source};
use reader::{Issue, SceneError, Table, tables};
use simulation::events::Margins;
use simulation::events::{Passage, Switching};
use simulation::ivp_scene::Parameter;
use simulation::knowledge::Knowledge;
use simulation::models::{ModelReaders, Modelled, has_model, holds_model, read_models_by};
use simulation::problem::{Function, Invariant};
use simulation::work_precision::Hybrid;
use simulation::work_precision::{Configuration, Observed};
use simulation::{Axes, Choice, IvpScene, Problem, Run, RunNotes, Trajectory, run};
use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

/// A system defined in a file, with its run.
#[derive(Debug)]
pub struct ModelScene {
    /// One line that names the motion.
    pub title: String,
    /// A sentence on the motion and its difficulty.
    pub description: String,
    pub model: Arc<Model>,
    /// The source from which the model was elaborated.
    pub(crate) source: Arc<Source>,
    /// The compiled law at the start.
    pub system: Arc<CompiledSystem>,
    /// The state at time zero: coordinates, then speeds, in SI units. It satisfies the constraints.
    pub start: Vec<f64>,
    /// Span, samples, method and tolerance of the run.
    pub run: Run,
    /// The description of each event: its name, or its line in the file.
    events: Vec<String>,
    /// The line in the file of each condition.
    condition_lines: Vec<usize>,
    /// The text and the line of each function with a restricted domain, such as `sqrt`, or with a range that overflows, such as `exp`.
    domains: Vec<(String, usize)>,
    /// If no motion or more than one continues from the start: a message with the line and the accepted values.
    without_motion: Option<String>,
    /// Additional knowledge about the system that `known_as` names.
    pub(crate) knowledge: Option<&'static Knowledge>,
}

/// Data that a calling program adds to the text of a scene.
#[derive(Clone, Debug, Default)]
pub struct Given {
    /// The run of a text without the table `[run]`; the title may then be missing.
    pub run: Option<Run>,
    /// Values of parameters, and of coordinates and speeds at the start, in SI units, by name.
    pub values: Vec<(String, f64)>,
    /// Outputs that are added to those of the text.
    pub outputs: Vec<Entry>,
}

/// The names whose values may be changed, as a sentence for messages.
pub(crate) const VALUES: &str =
    "names of parameters, and of coordinates and speeds whose starts are single numbers, are accepted";

/// Registers the reader of files with `[coordinates]` for every command; `warn` receives the warnings about a text.
pub fn register(warn: Warn) {
    warn_by(warn);
    let scene = |name: &str, text: &str| -> Result<Arc<dyn Modelled>, SceneError> {
        let scene = ModelScene::parse(name, text)?;
        warn_of(name, text, &scene.model.warnings);
        Ok(Arc::new(scene))
    };
    read_models_by(ModelReaders {
        scene,
        ensemble: parse_ensemble,
        runs: named_systems::runs,
        knows: named_systems::knows,
    });
}

/// Description of the key `title`, for messages.
pub(crate) const TITLE: &str = "one line that says what happens";

/// Description of the key `known_as`, for messages.
pub(crate) const KNOWN_AS: &str = "name of a system about which the program has knowledge";

impl ModelScene {
    /// Reads the scene in `text`; messages refer to it as `name`.
    ///
    /// # Errors All faults of the text, each with its place.
    pub fn parse(name: &str, text: &str) -> Result<Self, SceneError> {
        ModelScene::parse_with(name, text, Given::default())
    }

    /// Reads the scene in `text` with additional data of a calling program.
    ///
    /// # Errors All faults of the text and of the additional values, each with its place.
    pub fn parse_with(name: &str, text: &str, given: Given) -> Result<Self, SceneError> {
        let scene = tables(name, text, |top, issues| {
            // `parse_ensemble` reads these tables
            top.known(&["ensemble", "failure"]);
            ModelScene::read_with(top, issues, text, given)
        });
        scene.map_err(with_quoted_primes)
    }

    /// Reads a scene from the tables of a file and from data of a calling program; faults are added to `issues`.
    pub(crate) fn read_with(top: &mut Table<'_>, issues: &mut Vec<Issue>, text: &str, given: Given) -> Option<Self> {
        let title = match &given.run {
            None => top.text("title", TITLE).value,
            // a run that a program provides needs no title
            Some(_) => top.optional_text("title", TITLE).map_or_else(String::new, |title| title.value),
        };
        let title = title.split_whitespace().collect::<Vec<_>>().join(" ");
        let description = top.optional_text("description", "what happens and why it is hard");
        let known_as = top.optional_text("known_as", KNOWN_AS);
        let (mut model, source) = model_with(top, issues, given.outputs)
            .map_or((None, None), |(model, source)| (Some(Arc::new(model)), Some(Arc::new(source))));
        if let Some(model) = &mut model
            && let Err(why) = Arc::make_mut(model).set_values(&given.values)
        {
            issues.push(Issue { span: None, title: why, label: String::new(), help: Some(VALUES.to_owned()) });
        }
        let names = model.as_deref().map(columns);
        // `[run]` of a scene with a built-in law refers to the outputs of that law, which are not known here
        let has_own_law = has_model(text) && !holds_model(text);
        let known = names.as_deref().filter(|_| !has_own_law);
        let run = match top.has("run") {
            true if has_own_law => run::read(top, issues, known).map(|run| Run { outputs: Vec::new(), ..run }),
            true => run::read(top, issues, known),
            false if given.run.is_some() => given.run,
            // an issue already says that a key of [run] is in another table
            false if issues.iter().any(|issue| issue.help.as_deref().is_some_and(|help| help.contains("[run]"))) => {
                None
            }
            false => {
                top.known(&["run"]);
                issues.push(without_run(text));
                None
            }
        };
        let (mut model, source) = (model.take()?, source?);
        let knowledge = known_as.and_then(|name| asked_for((&model, &columns(&model)), &name, written, issues));
        if model.regulator.is_some() {
            Arc::make_mut(&mut model).close_regulated_inputs();
        }
        if let Some(issue) = too_large(&model, Task::Run) {
            issues.push(issue);
            return None;
        }
        let bodies = impossible(&model);
        let exist = bodies.is_empty();
        issues.extend(bodies);
        let ready = exist.then(|| ready(&mut model))?;
        let Ready { start, system, without_motion } = ready.map_err(|issue| issues.push(issue)).ok()?;
        if let Some(issue) = impossible_inductances(&model, &start) {
            issues.push(issue);
            return None;
        }
        let description = description.map_or_else(String::new, |text| text.value.trim().to_owned());
        let events = model.events.iter().map(|event| called(event, text)).collect();
        let condition_lines = model.switch_places.iter().map(|place| line_of(text, place.start)).collect();
        let domain = |domain: &model::Domain| {
            (text.get(domain.at.clone()).unwrap_or_default().to_owned(), line_of(text, domain.at.start))
        };
        let domains = model.domains.iter().map(domain).collect();
        let without_motion = without_motion.map(|issue| {
            let line = line_of(text, issue.span.map_or(0, |span| span.start));
            format!("line {line}: {}; accepted is {}", issue.label, issue.help.unwrap_or_default())
        });
        let run = run?;
        Some(ModelScene {
            title,
            description,
            model,
            source,
            system,
            start,
            run,
            events,
            condition_lines,
            domains,
            without_motion,
            knowledge,
        })
    }
}

impl ModelScene {
    /// The scene with another model, its law at the start, and its start.
    pub(crate) fn with(&self, model: Arc<Model>, system: Arc<CompiledSystem>, start: Vec<f64>) -> Self {
        let ModelScene { title, description, run, events, condition_lines, domains, knowledge, .. } = self;
        let (title, description) = (title.clone(), description.clone());
        let (run, events, condition_lines) = (run.clone(), events.clone(), condition_lines.clone());
        let (source, without_motion) = (Arc::clone(&self.source), None);
        ModelScene {
            title,
            description,
            model,
            source,
            system,
            start,
            run,
            events,
            condition_lines,
            domains: domains.clone(),
            without_motion,
            knowledge: *knowledge,
        }
    }

    /// The scene with a run of another length, in seconds.
    pub(crate) fn with_span(&self, span: f64) -> Self {
        let mut scene = self.with(Arc::clone(&self.model), Arc::clone(&self.system), self.start.clone());
        scene.run.span = span;
        ModelScene { without_motion: self.without_motion.clone(), ..scene }
    }

    /// The description of each event: its name, or its line in the file.
    pub(crate) fn event_names(&self) -> &[String] {
        &self.events
    }

    /// The text and the line of each function with a restricted domain or with a range that overflows.
    pub(crate) fn domain_texts(&self) -> &[(String, usize)] {
        &self.domains
    }

    /// The problem of the run, and the modes of a law that changes at conditions, contacts or events.
    pub(crate) fn switched(&self) -> (Problem, Option<Arc<Modes>>) {
        let (shown, kept) = (Arc::clone(&self.system), Arc::clone(&self.system));
        let watched = is_watched(&self.model);
        let modes = watched.then(|| Arc::new(Modes::of(&self.model, &self.events, &self.condition_lines)));
        let of_mode = modes.clone();
        let row = move |time: f64, state: &[f64]| {
            let current = of_mode.as_ref().and_then(|modes| modes.current());
            [state, &current.as_ref().unwrap_or(&shown).outputs(time, state)].concat()
        };
        let mut invariants = Vec::new();
        if self.system.keeps_energy {
            let energies = |system: &CompiledSystem, time: f64, state: &[f64]| -> [f64; ENERGIES] {
                let outputs = system.outputs(time, state);
                outputs.last_chunk().copied().unwrap_or([f64::NAN; ENERGIES])
            };
            let (of_size, [_, first]) = (Arc::clone(&kept), energies(&kept, 0.0, &self.start));
            let energy = move |time: f64, state: &[f64]| energies(&kept, time, state).iter().sum();
            let size = move |time: f64, state: &[f64]| {
                let [kinetic, potential] = energies(&of_size, time, state);
                kinetic.abs() + (potential - first).abs()
            };
            invariants.push(Invariant { name: "energy", value: Box::new(energy), size: Some(Box::new(size)) });
        }
        let law = self.system.law();
        let law = if watched { law } else { self.system.projected(law) };
        let problem = Problem {
            law,
            state: self.start.clone(),
            metered: 0,
            span: self.run.span,
            invariants,
            columns: columns(&self.model),
            row: Box::new(row),
            residual: self.residual(),
            margins: self.margins(),
            switching: modes.clone().map(|modes| modes as Arc<dyn Switching>),
        };
        (problem, modes)
    }

    /// The problem of the run with extended rows: [`ModelScene::mode_values`] further values are those of switches and friction in the current
    /// mode, from which sketches are drawn.
    pub fn problem_with_mode_values(&self) -> Problem {
        let (mut problem, modes) = self.switched();
        if let Some(values) = modes.map(ModeValues::of) {
            let row = problem.row;
            problem.row = Box::new(move |time, state| [row(time, state), values.at(time, state)].concat());
        }
        problem
    }

    /// The number of additional values in each row of [`ModelScene::problem_with_mode_values`].
    pub fn mode_values(&self) -> usize {
        mode_values_lengths(&self.model).iter().sum()
    }

    /// The largest residual of the constraints as a function of time and state; `None` for a model without constraints that are enforced.
    fn residual(&self) -> Option<Box<Function>> {
        if self.model.constraints.iter().all(|constraint| constraint.gains.is_some()) {
            return None;
        }
        let (model, kept) = (Arc::clone(&self.model), OnceLock::new());
        Some(Box::new(move |time: f64, state: &[f64]| {
            kept.get_or_init(|| KeptConstraints::of(&model)).residual(time, state)
        }))
    }

    /// Margins along a run: the distance of a state from a singular position of the constraints, then the margins known for the system.
    fn margins(&self) -> Box<Margins> {
        let singular = SingularPositions::of(&self.model, &self.start);
        let names: Vec<String> = self.model.state_names().into_iter().map(|(name, _)| name).collect();
        let known = self.knowledge.and_then(|knowledge| (knowledge.margins)(self, &names));
        Box::new(move |time, state, rates| {
            let known = known.iter().flat_map(|known| known(time, state, rates));
            singular.iter().map(|singular| singular.margin(time, state, rates)).chain(known).collect()
        })
    }
}

/// The number of the line that contains a byte, from 1.
fn line_of(text: &str, byte: usize) -> usize {
    text.get(..byte).unwrap_or(text).matches('\n').count() + 1
}

/// The description of an event for messages: its name, or its line.
pub(crate) fn called(event: &Event, text: &str) -> String {
    match event.name.as_str() {
        "" => format!("the event in line {}", line_of(text, event.at.start)),
        name => format!("the event `{name}`"),
    }
}

impl IvpScene for ModelScene {
    fn title(&self) -> &str {
        &self.title
    }

    fn description(&self) -> &str {
        &self.description
    }

    fn model(&self) -> &'static str {
        match self.system.is_code() {
            true => "as written in its file",
            false => {
                "as written in its file; too long for machine code, or for an unknown processor: several times as slow"
            }
        }
    }

    fn has_own_names(&self) -> bool {
        true
    }

    fn run(&self) -> &Run {
        &self.run
    }

    fn problem(&self, _axes: Axes) -> Problem {
        self.switched().0
    }

    fn metered(&self, axes: Axes) -> Problem {
        metered(&self.system, self.problem(axes))
    }

    fn told(&self, choice: &Choice, trajectory: &Trajectory) -> RunNotes {
        let ended = trajectory.passages.last().filter(|passage| passage.then.is_none());
        let diagnosis = match (ended, trajectory.left) {
            (Some(Passage { what, .. }), None) => Some(format!("{what} ends the run")),
            (Some(Passage { what, .. }), Some(BROKEN)) => Some(what.clone()),
            _ if !trajectory.has_begun() => self.without_motion.clone(),
            _ => None,
        };
        let known = self.knowledge.map(|knowledge| knowledge.told(self, choice, trajectory)).unwrap_or_default();
        RunNotes { diagnosis: known.diagnosis.or(diagnosis), failures: failures(self, choice, trajectory), ..known }
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

    fn ways(&self) -> Vec<Configuration> {
        let meets = |model: &Model| consistent(&starting(model, &self.start)).is_ok();
        formulations(&self.model, || self.problem(Axes::First), meets)
    }

    fn hybrid(&self) -> Option<&dyn Hybrid> {
        changes(&self.model).then_some(self)
    }

    fn observed(&self, reference: &Reference) -> Vec<Observed> {
        let names = columns(&self.model);
        names.into_iter().zip(&reference.sizes).map(|(name, size)| Observed { name, size: *size }).collect()
    }

    fn unit(&self, name: &str) -> Cow<'static, str> {
        unit_of(&self.model, name).into()
    }
}
