//! Linear-quadratic regulators: inputs that return a model to its reference motion with the least quadratic cost.
//!
//! The model is linearised along the motion from its start. Riccati's equation gives the feedback gains, and the feedback is applied to the
//! nonlinear model. Without a horizon the motion must be an equilibrium or have constant linear equations.

mod closed_loop;
mod controllability;
mod criterion;
mod horizon;
mod riccati;
mod states;
mod switched_loop;

pub use closed_loop::ClosedRun;
pub use controllability::Controllability;
pub use riccati::Stage;
pub use states::States;

use crate::changing_laws::is_watched;
use crate::linearisation::{Linearisation, Standing, VariedEquations, eigenvalues, points};
use crate::readiness::{unmet_at, without_law};
use crate::scene::ModelScene;
use crate::start::displaced;
use closed_loop::{Gains, MOST};
use criterion::{Form, forms};
use horizon::Backwards;
use integrators::Method;
use model::{Feedback, Model, Regulator};
use nalgebra::{Complex, DMatrix, DVector};
use reader::Issue;
use simulation::Choice;
use std::time::{Duration, Instant};

/// An optimal regulator of a model, with a run of the regulated nonlinear model.
#[derive(Clone, Debug)]
pub struct Regulated {
    /// Indices of the independent variations in the state: coordinates, then speeds.
    pub places: Vec<usize>,
    /// The states x of the linear equations on which the gains act.
    pub states: States,
    /// The controllability of the linear equations.
    pub controllability: Controllability,
    /// The gains K at the start, inputs by states: u = u0 - K (x - x0).
    pub gains: DMatrix<f64>,
    /// The solution P of Riccati's equation at the start; x^T P x is the optimal cost from x.
    pub value: DMatrix<f64>,
    /// The residual of the algebraic Riccati equation, relative; for a horizon, the relative change of P when the steps are halved.
    pub residual: f64,
    /// Eigenvalues of A at the start, in 1/s.
    pub open: Vec<Complex<f64>>,
    /// Eigenvalues of A - B K in 1/s; `None` for a horizon.
    pub closed: Option<Vec<Complex<f64>>>,
    /// The optimal cost x^T P x of the displaced start, by the linear equations.
    pub predicted: f64,
    /// The cost that remains at the end of the run: x^T P x without a horizon, otherwise the terminal cost.
    pub left: f64,
    /// The run of the regulated nonlinear model.
    pub run: ClosedRun,
}

/// First number of steps of a horizon; `MOST_STEPS` is the largest.
const STEPS: usize = 64;
const MOST_STEPS: usize = 8192;

/// Largest number of speeds and constraints: the program of the closed loop contains the equations of motion twice.
const MOST_UNKNOWNS: usize = 24;

/// Relative change of P between two step sizes below which the steps are short enough.
const FINE: f64 = 1e-10;

/// A mode decays if the real part of its eigenvalue is below minus this multiple of the norm of A.
const STABLE: f64 = 1e-10;

/// Largest accepted relative residual of the algebraic Riccati equation.
const LASTS: f64 = 1e-6;

/// Largest tolerance for the run of the closed loop.
const RUN: f64 = 1e-10;

/// The method for the run of the closed loop.
pub(crate) const METHOD: Method = Method::DormandPrince8;

/// The method and the tolerance for the closed loop of a scene.
pub fn loop_choice(scene: &ModelScene) -> Choice {
    Choice { method: METHOD, tolerance: scene.run.tolerance.min(RUN), ..scene.run.choice() }
}

/// The solution of Riccati's equation with its gains, residual, controllability and states.
struct Found {
    gains: Gains,
    value: DMatrix<f64>,
    residual: f64,
    controllability: Controllability,
    states: States,
}

/// A scene with its regulator, cost and linear equations.
struct Task<'a> {
    scene: &'a ModelScene,
    model: &'a Model,
    regulator: &'a Regulator,
    equations: VariedEquations,
    /// Indices of the regulator's inputs among those of the linear equations.
    chosen: Vec<usize>,
    cost: Form,
    last: Option<Form>,
}

/// Computes the regulator of a scene and runs the closed loop, within the time `allowed`.
///
/// # Errors
/// If the model is of an unsupported kind, an uncontrollable mode does not decay, Riccati's equation has no suitable solution, or the
/// displaced start violates constraints; with the place in the file.
pub fn regulated(scene: &ModelScene, allowed: Duration) -> Result<Regulated, Issue> {
    let deadline = Instant::now() + allowed;
    let task = Task::of(scene)?;
    let Task { model, regulator, .. } = task;
    let first = task.about(0.0, &scene.start)?;
    let speeds = first.speeds.iter().map(|&speed| model.positions() + speed);
    let places: Vec<usize> = first.coordinates.iter().copied().chain(speeds).collect();
    let found = match regulator.horizon {
        None => task.lasting(&first)?,
        Some(horizon) => task.over(horizon, &first, deadline)?,
    };
    let span = regulator.horizon.unwrap_or(scene.run.span);
    let states = &found.states;
    let varied = |state: &[f64], own: &[f64]| {
        let all = places.iter().map(|&place| state[place] - own[place]);
        &states.by_variations * DVector::from_iterator(places.len(), all)
    };
    let cost = |x: &DVector<f64>, value: &DMatrix<f64>| (x.transpose() * value * x)[(0, 0)];
    let moved = displaced(model, &scene.start, &regulator.displaced).map_err(|unmet| {
        let mut issue = unmet_at(model, unmet);
        issue.title = format!("the displaced start of the regulator: {}", issue.title);
        issue.accepted("deviations that constraints leave free; coordinates without one follow")
    })?;
    let predicted = cost(&varied(&moved, &scene.start), &found.value);
    let tolerance = loop_choice(scene).tolerance;
    let run = match (&found.gains, is_watched(model)) {
        (Gains::Lasting(gains), true) => {
            let feedback = task.feedback(&first, &places, states, gains);
            switched_loop::run(scene, &feedback, &moved, tolerance, deadline)?
        }
        _ => closed_loop::run(
            (model, regulator),
            (&places, states, &found.gains),
            [&scene.start, &moved],
            (span, tolerance, scene.run.samples),
            deadline,
        )
        .map_err(|why| without_law(model, &why, "this loop cannot run"))?,
    };
    let rest = vec![0.0; scene.start.len()];
    let at_end = varied(run.deviations.last().unwrap_or(&rest), &rest);
    let left = match (&task.last, regulator.horizon) {
        (_, None) => cost(&at_end, &found.value),
        (None, Some(_)) => 0.0,
        (Some(last), Some(_)) => {
            let state = run.states.last().unwrap_or(&scene.start);
            cost(&at_end, &states.form(&last.of_state(&task.about(span, state)?.variations)))
        }
    };
    let stage = states.stage(&task.stage(&first));
    let gains = found.gains.at(0.0).into_owned();
    let closed = regulator.horizon.is_none().then(|| eigenvalues(&(&stage.a - &stage.b * &gains)).values);
    let Found { value, residual, controllability, states, .. } = found;
    let open = eigenvalues(&stage.a).values;
    Ok(Regulated { places, states, controllability, gains, value, residual, open, closed, predicted, left, run })
}

impl<'a> Task<'a> {
    fn of(scene: &'a ModelScene) -> Result<Self, Issue> {
        let model = &*scene.model;
        let Some(regulator) = &model.regulator else {
            let issue = Issue::at(0..0, "this file has no [regulator]", "in this file");
            return Err(issue.accepted("add a table [regulator], such as cost = \"(x/(1 m))^2 + (u/(10 N))^2\""));
        };
        let refused = |title: String, accepted: &str| {
            Err(Issue::at(regulator.at[0].clone(), title, "this regulator").accepted(accepted.to_owned()))
        };
        if model.speeds() + model.constraints.len() > MOST_UNKNOWNS {
            let title = format!(
                "regulators of a model with more than {MOST_UNKNOWNS} speeds and constraints are not supported yet"
            );
            return refused(title, "a smaller model");
        }
        if !model.contacts.is_empty() {
            return refused(
                "regulators of a model with contacts are not supported yet".to_owned(),
                "a law without them",
            );
        }
        if is_watched(model) && regulator.horizon.is_some() {
            let title = "regulators over a horizon of a law that changes at conditions or events are not supported yet";
            return refused(title.to_owned(), "no `horizon`, about an equilibrium; or a law without them");
        }
        if !model.free.is_empty() {
            let title = "regulators of a model with free frames are not supported yet";
            return refused(title.to_owned(), "angles of frames in their place");
        }
        let (cost, last) = forms(model, regulator)?;
        let equations =
            VariedEquations::of(model, &[]).map_err(|why| without_law(model, &why, "there are no linear equations"))?;
        let place = |&input: &usize| equations.inputs.iter().position(|name| *name == model.inputs[input].name);
        let chosen: Option<Vec<usize>> = regulator.inputs.iter().map(place).collect();
        let Some(chosen) = chosen else {
            return refused("an input of this regulator moves a constraint".to_owned(), "inputs of forces");
        };
        Ok(Task { scene, model, regulator, equations, chosen, cost, last })
    }

    fn refused(&self, title: String, accepted: &str) -> Issue {
        Issue::at(self.regulator.at[0].clone(), title, "this regulator").accepted(accepted.to_owned())
    }

    fn about(&self, time: f64, state: &[f64]) -> Result<Linearisation, Issue> {
        let point = self.equations.point(time, state);
        self.equations.linearised(point).map_err(|why| why.at(self.model, time))
    }

    fn stage(&self, linear: &Linearisation) -> Stage {
        let b = DMatrix::from_fn(linear.b.nrows(), self.chosen.len(), |row, input| linear.b[(row, self.chosen[input])]);
        let [state, mixed, input] = self.cost.parts(&linear.variations);
        Stage { a: linear.a.clone(), b, state, mixed, input }
    }

    /// The states of the regulator; a fault if there are none, or more than [`MOST`] gains would be needed.
    fn states(&self, stages: &[Stage], last: Option<&DMatrix<f64>>, about: &Linearisation) -> Result<States, Issue> {
        let states = States::of(stages, last, about.coordinates.len());
        let count = states.kept.len() * self.chosen.len();
        match count {
            0 => {
                let title =
                    "neither the linear equations nor the cost depend on any variation: there is nothing to regulate"
                        .to_owned();
                Err(self.refused(title, "a cost of coordinates or their rates: (x/(1 m))^2 + (u/(10 N))^2"))
            }
            count if count > MOST => Err(self.refused(format!("this regulator has {count} gains"), "at most 256")),
            _ => Ok(states),
        }
    }

    /// The feedback about an equilibrium or a steady motion, as a part of the model.
    fn feedback(&self, about: &Linearisation, places: &[usize], states: &States, gains: &DMatrix<f64>) -> Feedback {
        let by_variations = gains * &states.by_variations;
        let inputs = self.regulator.inputs.iter().zip(&self.chosen).enumerate().map(|(k, (&input, &chosen))| {
            let mut row = vec![0.0; self.scene.start.len()];
            places.iter().zip(by_variations.row(k).iter()).for_each(|(&place, gain)| row[place] = *gain);
            (input, about.point.inputs[chosen], row)
        });
        let Form(cost) = &self.cost;
        Feedback {
            inputs: inputs.collect(),
            motion: self.scene.start.clone(),
            cost: cost.row_iter().map(|row| row.iter().copied().collect()).collect(),
        }
    }

    /// The regulator without a horizon, from the algebraic Riccati equation.
    fn lasting(&self, first: &Linearisation) -> Result<Found, Issue> {
        let standing = self.equations.standing(first).map_err(|why| why.at(self.model, 0.0))?;
        if standing == Standing::Moving {
            let title = "the motion from the start is no equilibrium, and its linear equations change";
            return Err(self.refused(
                title.to_owned(),
                "[start] with equilibrium = true, and the deviation from it under `displaced`; or a `horizon`",
            ));
        }
        let whole = self.stage(first);
        let states = self.states(std::slice::from_ref(&whole), None, first)?;
        let stage = states.stage(&whole);
        let controllability = Controllability::of_constant(&stage);
        if let Controllability::Modes(modes) = &controllability
            && let Some(mode) = modes.iter().find(|mode| mode.re >= -STABLE * stage.a.norm())
        {
            let title =
                format!("the mode with the eigenvalue {} does not decay, and no input influences it", shown(*mode));
            return Err(self.refused(title, "an input that influences the mode; or a `horizon`: a regulator for a limited time need not make the motion stable"));
        }
        let found = stage.lasting().and_then(|value| Some((stage.residual(&value)?, stage.gains(&value)?, value)));
        if let Some((rest, ..)) = &found
            && (rest.is_nan() || *rest > LASTS)
        {
            let title = format!(
                "Riccati's equation is solved only to {rest:.0e} of its largest term, which is the limit of double precision"
            );
            return Err(self.refused(title, "fewer states, or weights of more similar size; or a `horizon`"));
        }
        let is_stable = |gains: &DMatrix<f64>| {
            let closed = integrators::eigenvalues(&(&stage.a - &stage.b * gains));
            closed.is_some_and(|all| all.iter().all(|value| value.re < -STABLE * stage.a.norm()))
        };
        match found.filter(|(_, gains, _)| is_stable(gains)) {
            Some((residual, gains, value)) => {
                Ok(Found { gains: Gains::Lasting(gains), value, residual, controllability, states })
            }
            None => Err(self.refused(
                "Riccati's equation has no solution that makes the motion stable".to_owned(),
                "a cost that contains every mode that does not decay by itself; or a `horizon`",
            )),
        }
    }

    /// The regulator of a finite horizon (s), from Riccati's differential equation along the motion from the start. Steps are halved until P
    /// changes no longer.
    fn over(&self, horizon: f64, first: &Linearisation, deadline: Instant) -> Result<Found, Issue> {
        let mut steps = STEPS;
        let mut known: Option<DMatrix<f64>> = None;
        loop {
            let step = horizon / steps as f64;
            let times: Vec<f64> = (0..=2 * steps).map(|k| 0.5 * step * k as f64).collect();
            let left = deadline.saturating_duration_since(Instant::now());
            let states = points::along(self.scene, &times, left).map_err(|why| {
                let title = format!("the motion to which the loop brings back does not last: {why}");
                self.refused(title, "a shorter horizon")
            })?;
            let mut all = Vec::with_capacity(states.len());
            for (time, state) in &states {
                let linear = self.about(*time, state)?;
                if (&linear.coordinates, &linear.speeds) != (&first.coordinates, &first.speeds) {
                    let title = format!("at t = {time} s other coordinates are independent than at the start");
                    return Err(self.refused(title, "a horizon that ends before"));
                }
                all.push(linear);
            }
            let stages: Vec<Stage> = all.iter().map(|linear| self.stage(linear)).collect();
            let end = match (&self.last, all.last()) {
                (Some(last), Some(linear)) => Some(last.of_state(&linear.variations)),
                _ => None,
            };
            let states = self.states(&stages, end.as_ref(), first)?;
            let stages: Vec<Stage> = stages.iter().map(|stage| states.stage(stage)).collect();
            let n = states.kept.len();
            let end = end.map_or_else(|| DMatrix::zeros(n, n), |end| states.form(&end));
            let Some(backwards) = Backwards::of(stages, step, end) else {
                if steps < MOST_STEPS {
                    steps *= 2;
                    continue;
                }
                let title = "Riccati's equation has no finite solution over the horizon".to_owned();
                return Err(self.refused(title, "a shorter horizon, or a cost that is not negative"));
            };
            let value = backwards.first().clone();
            let size = value.amax().max(f64::MIN_POSITIVE);
            // with few instants, the set of states that influence the cost may differ
            let comparable = known.filter(|known| known.shape() == value.shape());
            let residual = comparable.map_or(f64::INFINITY, |known| (&known - &value).amax() / size);
            if residual <= FINE || steps >= MOST_STEPS {
                let (stages, step) = backwards.stages();
                let controllability = Controllability::along(stages, step);
                return Ok(Found { gains: Gains::Along(backwards), value, residual, controllability, states });
            }
            (steps, known) = (2 * steps, Some(value));
        }
    }
}

fn shown(value: Complex<f64>) -> String {
    if value.im == 0.0 { format!("{:.4} 1/s", value.re) } else { format!("{:.4} {:+.4} i 1/s", value.re, value.im) }
}
