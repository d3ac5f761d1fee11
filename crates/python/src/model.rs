//! The class of a model: a text that was read, and all operations on it.

use crate::callables::{JacobianMatrix, NamedLaw, RightHandSide};
use crate::equations::Equations;
use crate::errors::{refused, scene_error};
use crate::interruptible::interruptible;
use crate::judgement::Judgement;
use crate::linear::LinearEquations;
use crate::motions;
use crate::peer::checked;
use crate::results;
use crate::trajectory::{Beside, NativeTrajectory};
use dalembert::integrators::Method;
use dalembert::manuscript::PeerEquations;
use dalembert::model::{self, Trace, judgements};
use dalembert::scenes::{Given, ModelScene, SystemText, Task};
use dalembert::simulation::models::Modelled;
use dalembert::simulation::run::most_samples;
use dalembert::simulation::{Axes, Choice, Run, methods, run};
use dalembert::symbolic;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

/// A system in a text, with replaced values of parameters and of the start.
#[pyclass(frozen, module = "dalembert._native")]
pub struct NativeModel {
    text: SystemText,
    model: Arc<model::Model>,
    #[pyo3(get)]
    title: String,
    /// The scene for runs, created at its first use.
    scene: OnceLock<Arc<dyn Modelled>>,
}

/// The interval at which Python is asked whether Ctrl-C was pressed.
const LOOK: Duration = Duration::from_millis(50);

/// The default run of a text without a table [run]: 10 s with 200 samples.
fn usual() -> Run {
    Run {
        span: 10.0,
        samples: 200,
        tolerance: 1e-8,
        method: Method::DormandPrince8,
        through_singular_positions: false,
        outputs: Vec::new(),
    }
}

impl NativeModel {
    fn read(py: Python<'_>, text: SystemText) -> PyResult<Self> {
        let read = py.detach(|| dalembert::scenes::parse_titled(&text.name, &text.text, Task::Run));
        let (title, model) = read.map_err(|error| scene_error(py, &error))?;
        Ok(NativeModel { text, model: Arc::new(model), title, scene: OnceLock::new() })
    }

    fn scene(&self, py: Python<'_>) -> PyResult<&Arc<dyn Modelled>> {
        if let Some(scene) = self.scene.get() {
            return Ok(scene);
        }
        let given = Given { run: Some(usual()), values: self.text.values.clone(), ..Given::default() };
        let SystemText { name, text, .. } = self.text.clone();
        let made = interruptible(py, move || ModelScene::parse_with(&name, &text, given))?;
        let made = made.map_err(|error| scene_error(py, &error))?;
        Ok(self.scene.get_or_init(|| Arc::new(made)))
    }

    /// The right-hand side of the model; an error if the law changes at events.
    fn law(&self, py: Python<'_>) -> PyResult<NamedLaw> {
        let scene = self.scene(py)?;
        if scene.hybrid().is_some() {
            let why = "the law of this model changes at events, so that it has no single right-hand side; `run` follows the events";
            return Err(refused(py, &self.text.name, why));
        }
        let problem = scene.problem(Axes::First);
        let states = problem.columns[..problem.state.len()].to_vec();
        Ok(NamedLaw { law: problem.law, file: self.text.name.clone(), states })
    }
}

#[pymethods]
impl NativeModel {
    #[staticmethod]
    fn from_text(py: Python<'_>, text: String, name: String) -> PyResult<Self> {
        NativeModel::read(py, SystemText { name, text, values: Vec::new() })
    }

    #[staticmethod]
    fn from_file(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let text = SystemText::read(&path).map_err(|error| scene_error(py, &error))?;
        NativeModel::read(py, text)
    }

    #[getter]
    fn text(&self) -> &str {
        &self.text.text
    }

    #[getter]
    fn name(&self) -> &str {
        &self.text.name
    }

    /// The replaced values, in SI units.
    #[getter]
    fn values(&self) -> Vec<(String, f64)> {
        self.text.values.clone()
    }

    /// The parameters: name, value in SI units, unit.
    #[getter]
    fn parameters(&self) -> Vec<(String, Option<f64>, String)> {
        let value =
            |name: &str| self.text.values.iter().rev().find(|(known, _)| known == name).map(|(_, value)| *value);
        let datum = |one: &model::Parameter| (one.name.clone(), value(&one.name).or(one.value), one.unit.clone());
        self.model.parameters.iter().map(datum).collect()
    }

    /// The names of coordinates and speeds, with their units.
    #[getter]
    fn states(&self) -> Vec<(String, String)> {
        self.model.state_names()
    }

    /// The names of the inputs.
    #[getter]
    fn inputs(&self) -> Vec<String> {
        self.model.inputs.iter().map(|input| input.name.clone()).collect()
    }

    /// The number of coordinates among the states.
    #[getter]
    fn positions(&self) -> usize {
        self.model.positions()
    }

    /// The state at time zero, completed such that constraints hold, in SI units.
    fn start(&self, py: Python<'_>) -> PyResult<Vec<f64>> {
        Ok(self.scene(py)?.problem(Axes::First).state)
    }

    /// The system with other values, in SI units, of parameters and of the start.
    fn with_values(&self, py: Python<'_>, values: Vec<(String, f64)>) -> PyResult<Self> {
        let names = self.model.parameters.iter().map(|one| one.name.clone());
        let names: Vec<String> = names.chain(self.states().into_iter().map(|(name, _)| name)).collect();
        for (name, value) in &values {
            if !names.contains(name) {
                let meant = dalembert::units::nearest(name, names.iter().map(String::as_str));
                let meant = meant.map_or_else(String::new, |nearest| format!(" is `{nearest}` meant?"));
                let why = format!("nothing is called `{name}`;{meant} known are {}", names.join(", "));
                return Err(refused(py, &self.text.name, why));
            }
            if !value.is_finite() {
                return Err(refused(py, &self.text.name, format!("`{name}` is {value}; a finite number is accepted")));
            }
        }
        let (model, title) = (Arc::clone(&self.model), self.title.clone());
        let values = [self.text.values.clone(), values].concat();
        let text = SystemText { values, ..self.text.clone() };
        text.with_its_values((*model).clone()).map_err(|error| scene_error(py, &error))?;
        Ok(NativeModel { text, model, title, scene: OnceLock::new() })
    }

    fn derive(&self, py: Python<'_>, principle: Option<&str>) -> PyResult<Equations> {
        Equations::of(py, &self.text, principle)
    }

    fn prove(&self, py: Python<'_>) -> PyResult<Vec<Judgement>> {
        let text = self.text.clone();
        let model = interruptible(py, move || text.for_judgement())?.map_err(|error| scene_error(py, &error))?;
        let found = interruptible(py, move || symbolic::apart(|| judgements(&Trace::of(&model))))?;
        Ok(found.into_iter().map(Judgement).collect())
    }

    /// Compares equations of motion of another program, given as texts in the language of models, with those of this model. The result contains the
    /// verdict, a sentence, divisors that must not vanish, and a finding on each equation.
    #[allow(clippy::too_many_arguments)]
    fn check<'py>(
        &self,
        py: Python<'py>,
        letters: Vec<(String, String)>,
        speeds: Vec<String>,
        accelerations: Vec<String>,
        multipliers: Vec<String>,
        abbreviations: Vec<(String, String)>,
        kinematics: Vec<String>,
        constraints: Vec<String>,
        equations: Vec<(String, String)>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let peer = PeerEquations {
            letters,
            speeds,
            accelerations,
            multipliers,
            abbreviations,
            kinematics,
            constraints,
            equations,
        };
        checked(py, &self.text, &peer)
    }

    /// The steady motions within ranges of coordinates and speeds, as JSON and as text.
    fn stationary(
        &self,
        py: Python<'_>,
        ranges: Vec<(String, f64, f64)>,
        boxes: usize,
        seconds: f64,
    ) -> PyResult<(String, String)> {
        results::steady(py, &self.text, ranges, boxes, seconds)
    }

    /// The cheapest model that meets a tolerance in outputs, as JSON, as text and as an SVG picture.
    fn choose(&self, py: Python<'_>, tolerance: f64, outputs: Vec<String>) -> PyResult<(String, String, String)> {
        results::chosen(py, (self.scene(py)?, &self.text.name), tolerance, outputs)
    }

    /// The errors and costs of all methods, as JSON, as text, and as SVG pictures over evaluations and over time.
    fn chart(&self, py: Python<'_>, seconds: f64) -> PyResult<(String, String, [String; 2])> {
        results::chart(py, (self.scene(py)?, &self.text.name), seconds)
    }

    /// The number of members in the table [ensemble] of the text.
    fn ensemble_members(&self, py: Python<'_>) -> PyResult<u64> {
        Ok(results::ensemble_scene(py, &self.text, usual())?.members)
    }

    /// Runs members of the ensemble in the text, from the first to the last given number; without numbers all members.
    fn ensemble<'py>(
        &self,
        py: Python<'py>,
        members: Option<(u64, u64)>,
        threads: Option<usize>,
        seconds: f64,
    ) -> PyResult<Bound<'py, PyDict>> {
        let scene = results::ensemble_scene(py, &self.text, usual())?;
        let (first, last) = members.unwrap_or((1, scene.members));
        if !(1 <= first && first <= last && last <= scene.members) {
            let why = format!("members from {first} to {last} are asked for; from 1 to {} are there", scene.members);
            return Err(refused(py, &self.text.name, why));
        }
        results::ensemble(py, &scene, first..=last, threads, seconds)
    }

    /// The forces along prescribed motions (names with expressions in the time) for unknowns, at instants in seconds.
    fn inverse<'py>(
        &self,
        py: Python<'py>,
        motions: Vec<(String, String)>,
        unknowns: Vec<String>,
        times: Vec<f64>,
    ) -> PyResult<Bound<'py, PyDict>> {
        motions::inverse(py, &self.text, &motions, &unknowns, &times)
    }

    /// The optimal regulator by the table [regulator] of the text, as JSON and as text.
    fn regulate(&self, py: Python<'_>, seconds: f64) -> PyResult<(String, String)> {
        motions::regulate(py, &self.text, usual(), seconds)
    }

    /// The consistent regimes at the start, as JSON and as text.
    fn regimes(&self, py: Python<'_>) -> PyResult<(String, String)> {
        motions::regimes(py, &self.text, &self.title)
    }

    /// The motion to the digits on which two methods agree, as JSON and as text.
    fn reference(&self, py: Python<'_>, span: Option<f64>, seconds: f64) -> PyResult<(String, String)> {
        motions::reference(py, &self.text, usual(), span, seconds)
    }

    fn linearise(&self, py: Python<'_>, equilibrium: bool, inputs: Vec<String>) -> PyResult<LinearEquations> {
        LinearEquations::of(py, &self.text, equilibrium, &inputs)
    }

    fn rhs(&self, py: Python<'_>) -> PyResult<RightHandSide> {
        Ok(RightHandSide(self.law(py)?.into()))
    }

    fn jacobian(&self, py: Python<'_>) -> PyResult<JacobianMatrix> {
        Ok(JacobianMatrix(self.law(py)?.into()))
    }

    /// Runs the model; for arguments that are None the values of the text apply.
    #[pyo3(signature = (span, method, tolerance, samples, seconds))]
    fn run(
        &self,
        py: Python<'_>,
        span: Option<f64>,
        method: Option<&str>,
        tolerance: Option<f64>,
        samples: Option<usize>,
        seconds: f64,
    ) -> PyResult<NativeTrajectory> {
        let wrong = |why: String| refused(py, &self.text.name, why);
        let scene = self.scene(py)?;
        let own = scene.run();
        let span = span.unwrap_or(own.span);
        if !(span.is_finite() && span > 0.0) {
            return Err(wrong(format!("`span` is {span}; a positive time in seconds is accepted")));
        }
        if !(seconds.is_finite() && seconds > 0.0) {
            return Err(wrong(format!("`seconds` is {seconds}; a positive time in seconds is accepted")));
        }
        let method = match method {
            None => own.method,
            Some(name) => methods::method(name).map_err(|(why, accepted)| wrong(format!("{why}: {accepted}")))?,
        };
        if matches!(method, Method::Split { .. }) {
            return Err(wrong(
                "splittings are for gyrostats and motors with pieces; other methods are accepted".to_owned(),
            ));
        }
        let tolerance = tolerance.unwrap_or(own.tolerance);
        run::check_tolerance(tolerance)
            .map_err(|why| wrong(format!("`tolerance`: {why}; from 1e-14 to below 1 is accepted")))?;
        let mut problem = py.detach(|| scene.metered(Axes::First));
        if let Some(why) = problem.outside(0.0, &problem.state) {
            return Err(wrong(format!(
                "the law does not hold at the start: {why}; a start from which it holds is accepted"
            )));
        }
        problem.span = span;
        let most = most_samples(problem.columns.len());
        let samples = samples.unwrap_or(own.samples);
        if !(1..=most).contains(&samples) {
            return Err(wrong(format!("`samples` is {samples}; a whole number from 1 to {most} is accepted")));
        }
        let allowed = Duration::try_from_secs_f64(seconds).map_err(|why| wrong(format!("`seconds`: {why}")))?;
        let through_singular_positions = own.through_singular_positions;
        let choice = Choice { method, tolerance, axes: Axes::First, samples, allowed, through_singular_positions };
        let (mut looked, mut interrupted) = (Instant::now(), None);
        let (trajectory, told, steps) = py.detach(|| {
            let trajectory = problem.simulate_while(&choice, |_| {
                if looked.elapsed() > LOOK {
                    looked = Instant::now();
                    interrupted = Python::attach(|py| py.check_signals()).err();
                }
                if interrupted.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            });
            let told = scene.told(&choice, &trajectory);
            let steps =
                problem.check_by_step_halving(&choice, &trajectory, || match Python::attach(|py| py.check_signals()) {
                    Ok(()) => ControlFlow::Continue(()),
                    Err(error) => {
                        interrupted = Some(error);
                        ControlFlow::Break(())
                    }
                });
            (trajectory, told, steps)
        });
        if let Some(interrupted) = interrupted {
            return Err(interrupted);
        }
        let units = trajectory.names.iter().map(|name| scene.unit(name).into_owned()).collect();
        let states = problem.state.len() - problem.metered;
        let beside = Beside { units, method: method.to_string(), tolerance, states, told, steps };
        NativeTrajectory::of(py, trajectory, beside)
    }
}
