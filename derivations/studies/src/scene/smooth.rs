//! The interface of a scene with a motor to all commands ([`IvpScene`]), and its runs.

use super::Scene;
use integrators::{Method, Reference};
use motor::{Count, has_known_flow};
use simulation::ivp_scene::Parameter;
use simulation::work_precision::{Configuration, Observed};
use simulation::{Axes, Choice, IvpScene, Problem, Run, RunNotes, Trajectory};
use std::borrow::Cow;

impl Scene {
    /// The method, tolerance and outputs of the scene.
    pub fn choice(&self) -> Choice {
        self.run.choice()
    }

    /// Runs the scene. `progress` receives the fraction done after every step.
    pub fn simulate(&self, choice: &Choice, progress: impl FnMut(f64)) -> Trajectory {
        self.problem(choice.axes).simulate(choice, progress)
    }
}

impl IvpScene for Scene {
    fn title(&self) -> &str {
        &self.title
    }

    fn description(&self) -> &str {
        &self.description
    }

    fn model(&self) -> &'static str {
        self.machine.name()
    }

    fn run(&self) -> &Run {
        &self.run
    }

    fn problem(&self, axes: Axes) -> Problem {
        Scene::problem(self, axes)
    }

    fn metered(&self, axes: Axes) -> Problem {
        Scene::metered(self, axes)
    }

    fn unit(&self, name: &str) -> Cow<'static, str> {
        Scene::unit(self, name).into()
    }

    fn told(&self, choice: &Choice, trajectory: &Trajectory) -> RunNotes {
        let known = has_known_flow(&self.machine);
        let refused = matches!(choice.method, Method::Split { .. }) && !known;
        let theory = refused.then(|| {
            let model = self.machine.name();
            format!(
                "`{model}` has no pieces: a supply, brushes or turning axes tie its currents to the speed at any angle"
            )
        });
        let off = self.closed_form::<f64>().map(|known| {
            let samples = || trajectory.times.iter().zip(&trajectory.rows);
            let size = samples().map(|(_, row)| known.shown_in_row(row).abs()).fold(f64::MIN_POSITIVE, f64::max);
            let off = samples().map(|(time, row)| (known.shown_in_row(row) - known.at(*time)).abs());
            (known.name, off.fold(0.0, f64::max) / size)
        });
        let theory = theory.into_iter().chain(self.runs_away(trajectory)).collect();
        RunNotes { theory, closed_form: off, ..RunNotes::default() }
    }

    fn ways(&self) -> Vec<Configuration> {
        self.all_ways()
    }

    fn observed(&self, reference: &Reference) -> Vec<Observed> {
        self.observables(reference)
    }

    fn parameters(&self) -> Vec<Parameter> {
        let numbers = self.given.data().map(|(quantity, value)| Parameter::of(quantity, value));
        let counts = self.given.laws().counts().iter();
        let count = |&(Count { name, meaning }, count): &(Count, usize)| {
            let (value, unit) = (count.to_string(), "".into());
            Parameter { name: name.into(), value, unit, meaning: meaning.into() }
        };
        numbers.chain(counts.map(count)).collect()
    }
}
