//! Ensembles of a system in a file: each member has its own parameters and start.
//!
//! Members with one law run in batches; members whose law changes run one by one (`lone_members.rs`).

mod lone_members;

use crate::admissible::BodyNumbers;
use crate::compiled_system::{ENERGIES, NotCompiled};
use crate::constraint_projection::{ConstraintProjection, OfMember};
use crate::parametric_law::ParametricLaw;
use crate::readiness::{Ready, changes, ready, refused, starting, unmet_at};
use crate::row_units::columns;
use crate::scene::{Given, ModelScene};
use crate::start::{Completed, SingularPositions, StartSolver, Unmet, given, in_touch, start_speeds};
use crate::warnings::warn_of;
use integrators::{BatchSeries, Method, Projection};
use lone_members::laws_of;
use model::{Fault, Model, bare_angle, turned_further};
use reader::{SceneError, tables};
use simulation::ensemble::{
    BATCH_SIZE, Column, Drawn, EnsembleScene, IndividualMembers, Last, Member, ParametricSystem, Shape, Sizes, Stopped,
    Variable, batch_series, vary,
};
use simulation::events::Margins;
use simulation::{Axes, Choice, IvpScene, Run, RunFailure};
use std::fmt::{self, Write};
use std::ops::ControlFlow;
use std::sync::Arc;

/// A model with its run, and its law as a function of the parameters.
#[derive(Debug)]
struct ModelEnsemble {
    scene: ModelScene,
    law: Law,
    /// The projection onto the constraints for members in batches.
    projection: Option<ConstraintProjection>,
    /// The solver that completes the start of a member.
    start: StartSolver,
    /// The singular positions of closed loops; `None` without closed loops.
    singular: Option<SingularPositions>,
    /// Masses and moments of inertia as functions of the parameters.
    bodies: BodyNumbers,
    /// The target of each variable.
    targets: Vec<Target>,
}

/// The law of all members.
#[derive(Debug)]
enum Law {
    /// One law with parameters as inputs.
    Batch(Box<ParametricLaw>),
    /// Members run one by one. The text determines their laws, for the fingerprint.
    Alone(String),
}

/// A number of the model that may vary among members. Each variant holds the index of the number in the model's list.
#[derive(Clone, Copy, Debug)]
enum Target {
    /// A parameter.
    Parameter(usize),
    /// A component of the state at the start: coordinates, then speeds.
    Start(usize),
    /// A quasi-velocity at the start, by its index among those that the file gives.
    StartSpeed(usize),
    /// The orientation of the free frame with this number at the start: a rotation vector (rad) in its own axes, relative to the start of
    /// the file.
    Turn(usize),
}

/// Reads a file with `[coordinates]` and `[ensemble]`; `name` is its name in messages.
///
/// # Errors
/// The file has errors; each is given with its position.
pub fn parse_ensemble(name: &str, text: &str) -> Result<EnsembleScene, SceneError> {
    parse_ensemble_with(name, text, Given::default())
}

/// Reads a file with `[coordinates]` and `[ensemble]`, with additional data `given` by a calling program.
///
/// # Errors
/// The file has errors; each is given with its position.
pub fn parse_ensemble_with(name: &str, text: &str, given: Given) -> Result<EnsembleScene, SceneError> {
    tables(name, text, |top, issues| {
        top.known(&["failure"]);
        let scene = ModelScene::read_with(top, issues, text, given);
        let known = scene.as_ref().map(variables);
        let example = scene.as_ref().map_or_else(String::new, |scene| example(&scene.model));
        let variation = vary::read(top, issues, known.as_ref().map(|(variables, _)| &variables[..]), &example);
        let (scene, variation, (_, targets)) = (scene?, variation?, known?);
        warn_of(name, text, &[scene.model.warnings.clone(), bare_starts(&scene.model, text)].concat());
        let model = Arc::clone(&scene.model);
        let system = ModelEnsemble::of(scene, targets).map_err(|unmet| {
            issues.push(match unmet {
                Unmet::NotCompiled(NotCompiled::Changes) => changes(&model, "`ensemble` does not apply"),
                other => unmet_at(&model, other),
            });
        });
        let system = system.ok()?;
        let not_run = |_| issues.push(refused(&model, &NotCompiled::TooLong));
        EnsembleScene::new(Arc::new(system), variation).map_err(not_run).ok()
    })
}

/// All numbers of a model that may vary, and the target of each.
fn variables(scene: &ModelScene) -> (Vec<Variable>, Vec<Target>) {
    let model = &scene.model;
    let variable = |table, key: &str, meaning: String, unit: String, count: usize| Variable {
        table,
        key: key.to_owned().into(),
        meaning: meaning.into(),
        unit: unit.into(),
        shape: Shape::Numbers(count),
    };
    let parameters = model.parameters.iter().enumerate().map(|(place, parameter)| {
        let meaning = format!("parameter `{}`", parameter.name);
        (variable("parameters", &parameter.name, meaning, parameter.unit.clone(), 1), Target::Parameter(place))
    });
    let quaternions = model.coordinates.len()..model.positions();
    let names = columns(model).into_iter().take(model.positions() + model.speeds()).enumerate();
    let start = names.filter(|(place, _)| !quaternions.contains(place)).map(|(place, name)| {
        let unit = scene.unit(&name).into_owned();
        (variable("start", &name, format!("start of `{name}`"), unit, 1), Target::Start(place))
    });
    let turns = model.free.iter().enumerate().map(|(number, frame)| {
        let name = &model.frames[frame.0].name;
        let meaning = format!("turn of `{name}` about its own axes x, y, z, relative to its start");
        (variable("start", name, meaning, "rad".to_owned(), 3), Target::Turn(number))
    });
    let speeds = model.start_speeds.iter().enumerate().map(|(place, given)| {
        let name = &model.quasi_velocities[given.of].name;
        let unit = scene.unit(name).into_owned();
        (variable("start", name, format!("start of `{name}`"), unit, 1), Target::StartSpeed(place))
    });
    let currents = model.currents.iter().map(|(name, charge)| {
        let target = Target::Start(model.positions() + charge);
        (variable("start", name, format!("start of `{name}`"), "A".to_owned(), 1), target)
    });
    parameters.chain(start).chain(turns).chain(speeds).chain(currents).unzip()
}

/// Warnings for varied angles at the start whose numbers have no unit and exceed a full turn: probably degrees.
fn bare_starts(model: &Model, text: &str) -> Vec<Fault> {
    let angles = model.coordinates.iter().filter(|coordinate| coordinate.unit == "rad").map(|angle| &angle.name);
    let turns = model.free.iter().map(|frame| &model.frames[frame.0].name);
    let found = tables("", text, |top, _| {
        top.known_all();
        let mut found = Vec::new();
        let mut ensemble = top.optional_table("ensemble")?;
        let mut start = ensemble.optional_table("vary")?.optional_table("start")?;
        for name in angles.chain(turns) {
            let Some(mut law) = start.optional_table(name) else { continue };
            for key in ["from", "to", "mean", "deviation", "values"] {
                let Some(written) = law.written(key, "angle") else { continue };
                let largest = written.value.split_whitespace().map(|word| (word.parse::<f64>(), word));
                // the first word that is no number is the unit
                let numbers: Vec<(f64, &str)> = largest.map_while(|(value, word)| Some((value.ok()?, word))).collect();
                let is_bare = numbers.len() == written.value.split_whitespace().count();
                let largest = numbers.into_iter().max_by(|one, other| one.0.abs().total_cmp(&other.0.abs()));
                let bare = largest.filter(|_| is_bare).and_then(|(_, word)| {
                    bare_angle(
                        written.span.clone(),
                        word,
                        &format!("\"{} deg\"", written.value.replacen(word, "{}", 1)),
                    )
                });
                found.extend(bare);
            }
        }
        Some(found)
    });
    found.unwrap_or_default()
}

/// An example line of `[ensemble.vary]` for messages.
fn example(model: &Model) -> String {
    let (name, unit) = match (model.parameters.first(), model.coordinates.first()) {
        (Some(parameter), _) => (format!("parameters.{}", parameter.name), parameter.unit.clone()),
        (None, first) => {
            let named = first.map(|first| (format!("start.{}", first.name), first.unit.clone()));
            named.unwrap_or_else(|| ("start.x".to_owned(), "m".to_owned()))
        }
    };
    let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
    format!("{name} = {{ from = \"1{unit}\", to = \"2{unit}\" }}")
}

impl ModelEnsemble {
    fn of(scene: ModelScene, targets: Vec<Target>) -> Result<Self, Unmet> {
        let model = &scene.model;
        if model.equilibrium.is_some() {
            return Err(Unmet::NotCompiled(NotCompiled::Changes));
        }
        // batches do not support step bounds
        let has_haste = !scene.system.law().step_bounds(0.0, scene.run.span).is_empty();
        let law = match laws_of(model, has_haste) {
            Some(laws) => Law::Alone(laws),
            None => Law::Batch(Box::new(ParametricLaw::of(model).map_err(Unmet::NotCompiled)?)),
        };
        let projection = match &law {
            Law::Batch(_) => ConstraintProjection::of_members(model),
            Law::Alone(_) => None,
        };
        // other constraints may be redundant at the start of a member
        let start = StartSolver::of(&in_touch(&model.whole()))?;
        let bodies = BodyNumbers::of(model).map_err(Unmet::NotCompiled)?;
        let singular = SingularPositions::of(model, &scene.start);
        Ok(ModelEnsemble { scene, law, projection, start, singular, bodies, targets })
    }

    /// The final values of a member: state, outputs, and the change of the energy if it is conserved.
    fn end(law: &ParametricLaw, [parameters, start]: [&[f64]; 2], time: f64, state: &[f64]) -> Last {
        let energy = |outputs: &[f64]| outputs[outputs.len() - ENERGIES..].iter().sum::<f64>();
        let outputs = law.outputs(time, state, parameters);
        let mut derived = outputs.clone();
        if law.keeps_energy {
            derived.push(energy(&outputs) - energy(&law.outputs(0.0, start, parameters)));
        }
        let finite = |number: f64| number.is_finite().then_some(number);
        Last { time, state: state.to_vec(), derived: derived.into_iter().map(finite).collect() }
    }

    /// The quasi-velocities of a member at its start.
    fn speeds_of(&self, drawn: &[Drawn]) -> Vec<f64> {
        let mut speeds = start_speeds(&self.scene.model);
        for Drawn { variable, numbers } in drawn {
            if let (Target::StartSpeed(place), Some(number)) = (self.targets[*variable], numbers.first()) {
                speeds[place] = *number;
            }
        }
        speeds
    }

    /// The parameters and the completed start of a member.
    ///
    /// # Errors
    /// A body is physically impossible, the start cannot be completed, or other constraints are redundant than in the file.
    fn placed(&self, drawn: &[Drawn]) -> Result<(Vec<f64>, Vec<f64>), Stopped> {
        let model = &self.scene.model;
        let mut parameters: Vec<f64> = model.parameters.iter().filter_map(|parameter| parameter.value).collect();
        let (mut state, mut given, speeds) = (model.start_state(), given(model), self.speeds_of(drawn));
        let n = model.positions();
        let is_guess = |place: usize| {
            model.start.iter().any(|value| value.is_guess && value.order * n + value.coordinate == place)
        };
        for Drawn { variable, numbers } in drawn {
            let first = match self.targets[*variable] {
                Target::Parameter(place) => {
                    numbers.iter().take(1).for_each(|number| parameters[place] = *number);
                    continue;
                }
                Target::StartSpeed(_) => continue,
                Target::Start(place) => {
                    numbers.iter().take(1).for_each(|number| state[place] = *number);
                    place..place + 1
                }
                Target::Turn(number) => {
                    let first = model.free_position(number);
                    if let (Some(&quaternion), Some(&turn)) = (state[first..].first_chunk(), numbers.first_chunk()) {
                        state[first..first + 4].copy_from_slice(&turned_further(quaternion, turn));
                    }
                    first..first + 4
                }
            };
            // a value that is a guess in the file stays a guess
            first.for_each(|place| given[place] = !is_guess(place));
        }
        if let Some(issue) = self.bodies.impossible(model, &parameters).into_iter().next() {
            return Err(Stopped::Impossible(format!("{}: {}", issue.title, issue.label)));
        }
        let start = self.start.complete(&parameters, &speeds, state, &given);
        let Completed { state: start, implied } = start.map_err(|unmet| Stopped::Start(told(&unmet)))?;
        let of_model = |[constraint, _]: &[usize; 2]| *constraint < model.constraints.len();
        if !implied.into_iter().filter(of_model).eq(model.implied.iter().map(|implied| implied.of)) {
            return Err(Stopped::Start(
                "other constraints follow from others than at the start of the file".to_owned(),
            ));
        }
        Ok((parameters, start))
    }
}

impl ParametricSystem for ModelEnsemble {
    fn title(&self) -> &str {
        &self.scene.title
    }

    fn run(&self) -> &Run {
        &self.scene.run
    }

    fn sizes(&self) -> Sizes {
        let model = &self.scene.model;
        Sizes { states: model.positions() + model.speeds(), parameters: model.parameters.len() }
    }

    fn series(&self, order: usize) -> Option<Box<dyn BatchSeries<BATCH_SIZE> + '_>> {
        match &self.law {
            Law::Batch(law) => batch_series(&law.law, order),
            Law::Alone(_) => None,
        }
    }

    fn alone(&self) -> Option<&dyn IndividualMembers> {
        matches!(self.law, Law::Alone(_)).then_some(self)
    }

    fn member(&self, drawn: &[Drawn]) -> Result<Member<'_>, Stopped> {
        let (parameters, start) = self.placed(drawn)?;
        let (own, before) = (parameters.clone(), start.clone());
        let end = Box::new(move |time: f64, state: &[f64]| match &self.law {
            Law::Batch(law) => ModelEnsemble::end(law, [&own, &before], time, state),
            Law::Alone(_) => Last { time, state: state.to_vec(), derived: Vec::new() },
        });
        let singular = self.singular.as_ref().and_then(|singular| {
            let speeds = self.speeds_of(drawn);
            singular.of_member(&parameters, &speeds, &start)
        });
        let margins = singular.map(|singular| -> Box<Margins> {
            Box::new(move |time, state, rates| vec![singular.margin(time, state, rates)])
        });
        let projection = self.projection.as_ref().map(|projection| -> Box<dyn Projection<f64> + Send + '_> {
            Box::new(OfMember::new(projection, &start, &parameters))
        });
        Ok(Member { parameters, state: start, end, margins, projection })
    }

    fn failures(&self, drawn: &[Drawn], goes_on: &dyn Fn() -> bool) -> Vec<RunFailure> {
        let Ok((parameters, start)) = self.placed(drawn) else { return Vec::new() };
        let mut model = (*self.scene.model).clone();
        model.parameters.iter_mut().zip(parameters).for_each(|(own, value)| own.value = Some(value));
        let mut model = Arc::new(starting(&model, &start));
        let Ok(Ready { start, system, .. }) = ready(&mut model) else { return Vec::new() };
        let scene = self.scene.with(model, system, start);
        let own = scene.run.choice();
        // the failures must be those of the member's own method
        let method = if self.alone().is_some() { own.method } else { Method::Taylor };
        let choice = Choice { method, ..own };
        let trajectory = scene.problem(Axes::First).simulate_while(&choice, |_| match goes_on() {
            true => ControlFlow::Continue(()),
            false => ControlFlow::Break(()),
        });
        scene.told(&choice, &trajectory).failures
    }

    fn columns(&self) -> Vec<Column> {
        let keeps_energy = matches!(&self.law, Law::Batch(law) if law.keeps_energy);
        let change = keeps_energy.then(|| Column { name: "energy_change".to_owned(), unit: "J".to_owned() });
        let shown = columns(&self.scene.model).into_iter();
        shown.map(|name| Column { unit: self.scene.unit(&name).into_owned(), name }).chain(change).collect()
    }

    fn write_law(&self, out: &mut dyn Write) -> fmt::Result {
        let ModelEnsemble { scene: ModelScene { model, .. }, law, .. } = self;
        let values: Vec<Option<f64>> = model.parameters.iter().map(|parameter| parameter.value).collect();
        match law {
            Law::Batch(law) => write!(out, "{law:?}")?,
            Law::Alone(laws) => write!(out, "{laws} {:?}", self.scene.run.method)?,
        }
        if ConstraintProjection::is_of(model) {
            write!(out, " each step ends on the constraints")?;
        }
        write!(out, " {values:?} {:?} {:?} ", model.start, model.start_speeds)?;
        self.start.write(out)
    }

    fn name(&self) -> &str {
        self.scene.model()
    }
}

/// The reason for which a member has no start, in words.
fn told(unmet: &Unmet) -> String {
    match unmet {
        Unmet::Open(open) => open.to_string(),
        Unmet::Redundant { name, .. } => format!("{name} depends on other constraints there"),
        Unmet::Idle { name, .. } => format!("{name} has no effect there"),
        Unmet::Multiple { name, .. } => format!("the gradient of {name} is zero wherever the constraint holds"),
        Unmet::Jumping { name, .. } => format!("{name} has no derivative where it holds"),
        Unmet::Locked { name, .. } => format!("{name} cannot hold in its position"),
        Unmet::Contradiction { .. } => "two constraints contradict each other".to_owned(),
        Unmet::Gains { .. } | Unmet::Piecewise(_) | Unmet::Fixed { .. } => {
            "a constraint that no start can meet".to_owned()
        }
        Unmet::NotCompiled(reason) => reason.to_string(),
    }
}
