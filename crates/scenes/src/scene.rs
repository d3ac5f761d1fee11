//! A scene whose system is written in its file.

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

/// A system that is written in a file, with its run.
#[derive(Debug)]
pub struct ModelScene {
    pub title: String,
    /// The motion in one sentence, and why it is hard.
    pub description: String,
    pub model: Arc<Model>,
    /// The source that the model was elaborated from.
    pub(crate) source: Arc<Source>,
    pub system: Arc<CompiledSystem>,
    /// The state at time zero, coordinates, then speeds, which satisfies the constraints.
    pub start: Vec<f64>,
    pub run: Run,
    /// Each event by its name, or by its line in the file.
    events: Vec<String>,
    /// The line of each condition.
    condition_lines: Vec<usize>,
    /// The text and the line of each function that has values on one side of zero alone.
    domains: Vec<(String, usize)>,
    /// The place in the file and the accepted values, where no motion goes on from the start, or several do.
    without_motion: Option<String>,
    /// Theory beyond the equations, where the file has `known_as`.
    pub(crate) knowledge: Option<&'static Knowledge>,
}

/// Data that a calling program adds to a text.
#[derive(Clone, Debug, Default)]
pub struct Given {
    /// The run for a text without `[run]`; such a text needs no title.
    pub run: Option<Run>,
    /// Values of parameters, and of coordinates and speeds at the start, in SI units.
    pub values: Vec<(String, f64)>,
    /// Outputs in addition to those of the text.
    pub outputs: Vec<Entry>,
}

/// A sentence on the names whose values may be changed.
pub(crate) const VALUES: &str =
    "names of parameters, and of coordinates and speeds whose starts are single numbers, are accepted";

/// Registers the reader of files with `[coordinates]` for every command; `warn` gets warnings of doubtful texts.
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

/// The key `title` in words.
pub(crate) const TITLE: &str = "one line that says what happens";

/// The key `known_as` in words.
pub(crate) const KNOWN_AS: &str = "name of a system about which the program has knowledge";

impl ModelScene {
    /// Reads a file; `name` is what messages call it.
    ///
    /// # Errors
    /// All faults of the file, each at its place.
    pub fn parse(name: &str, text: &str) -> Result<Self, SceneError> {
        ModelScene::parse_with(name, text, Given::default())
    }

    /// Reads a file, with additional data from a calling program.
    ///
    /// # Errors
    /// All faults of the file, each at its place.
    pub fn parse_with(name: &str, text: &str, given: Given) -> Result<Self, SceneError> {
        let scene = tables(name, text, |top, issues| {
            // members are read by `parse_ensemble`
            top.known(&["ensemble", "failure"]);
            ModelScene::read_with(top, issues, text, given)
        });
        scene.map_err(with_quoted_primes)
    }

    /// Reads the tables of a file, with what a program gives beside the text; what is wrong goes into the list.
    pub(crate) fn read_with(top: &mut Table<'_>, issues: &mut Vec<Issue>, text: &str, given: Given) -> Option<Self> {
        let title = match &given.run {
            None => top.text("title", TITLE).value,
            // equations need no title, and neither does a run that another program asks for
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
        // outputs of a scene with a law of its own have the names of that
        let has_own_law = has_model(text) && !holds_model(text);
        let known = names.as_deref().filter(|_| !has_own_law);
        let run = match top.has("run") {
            true if has_own_law => run::read(top, issues, known).map(|run| Run { outputs: Vec::new(), ..run }),
            true => run::read(top, issues, known),
            false if given.run.is_some() => given.run,
            // keys of the run under another heading are told there
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
    /// The scene with another model, its law at the start, and that start.
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

    /// The scene with a run of another length, s.
    pub(crate) fn with_span(&self, span: f64) -> Self {
        let mut scene = self.with(Arc::clone(&self.model), Arc::clone(&self.system), self.start.clone());
        scene.run.span = span;
        ModelScene { without_motion: self.without_motion.clone(), ..scene }
    }

    /// Each event by its name, or by its line in the file.
    pub(crate) fn event_names(&self) -> &[String] {
        &self.events
    }

    /// The text and the line of each function that has values on one side of zero alone.
    pub(crate) fn domain_texts(&self) -> &[(String, usize)] {
        &self.domains
    }

    /// The problem of the run, with the modes of a law that changes.
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

    /// The problem of the run, whose rows end with the values that its mode determines, which sketches need: of switches, and of friction.
    pub fn problem_with_mode_values(&self) -> Problem {
        let (mut problem, modes) = self.switched();
        if let Some(values) = modes.map(ModeValues::of) {
            let row = problem.row;
            problem.row = Box::new(move |time, state| [row(time, state), values.at(time, state)].concat());
        }
        problem
    }

    /// The number of values that the mode adds to each row of such a problem.
    pub fn mode_values(&self) -> usize {
        mode_values_lengths(&self.model).iter().sum()
    }

    /// The largest residual of the constraints; none of a model without constraints.
    fn residual(&self) -> Option<Box<Function>> {
        if self.model.constraints.iter().all(|constraint| constraint.gains.is_some()) {
            return None;
        }
        let (model, kept) = (Arc::clone(&self.model), OnceLock::new());
        Some(Box::new(move |time: f64, state: &[f64]| {
            kept.get_or_init(|| KeptConstraints::of(&model)).residual(time, state)
        }))
    }

    /// The distance of a state from where its constraints determine the motion no longer, then those that are known of the system.
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

/// The number of the line in which a byte stands.
fn line_of(text: &str, byte: usize) -> usize {
    text.get(..byte).unwrap_or(text).matches('\n').count() + 1
}

/// An event by its name, or by its line.
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
