//! Scenes of mechanisms: read by the names of data and states, run as any other problem, with what theory says beside it.

use super::erased::{Erased, Read};
use super::{Diagnosis, Ended, LIST};
use crate::ladder::Ladder;
use integrators::Reference;
use reader::{Family, Issue, Opening, Quantity, Table};
use simulation::problem::Problem;
use simulation::smooth::{Parameter, Smooth, Told};
use simulation::work_precision::{Observed, Way};
use simulation::{Axes, Choice, Run, Trajectory, run};
use std::borrow::Cow;
use std::sync::Arc;

/// A scene whose data are all admissible.
#[derive(Clone, Debug)]
pub struct MechanismScene {
    pub title: String,
    /// What happens and why it is hard.
    pub description: String,
    /// As scene files call the mechanism.
    pub name: &'static str,
    /// In the mechanism's own order.
    pub data: Vec<(&'static Quantity, f64)>,
    /// The values that the file gives of the state.
    pub start: Vec<f64>,
    mechanism: Arc<dyn Erased>,
    pub run: Run,
}

reader::submit! { reader::KnownSystems(<MechanismScene as Family>::systems) }

impl Family for MechanismScene {
    const KIND: &'static str = "a mechanism";

    fn systems() -> Vec<(&'static str, &'static str)> {
        LIST.iter().map(|entry| (entry.name, entry.summary)).collect()
    }

    fn read(opening: Opening, top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Self> {
        let Opening { title, description, system } = opening;
        let entry = LIST.iter().find(|entry| entry.name == system.value)?;
        let found = (entry.read)(top, issues);
        let columns = found.as_ref().map(|found| found.mechanism.columns());
        let names: Option<Vec<String>> =
            columns.map(|columns| columns.iter().map(|quantity| quantity.name.to_string()).collect());
        let run = run::read(top, issues, names.as_deref());
        let Read { data, start, mechanism } = found?;
        Some(MechanismScene { title, description, name: entry.name, data, start, mechanism, run: run? })
    }
}

impl Smooth for MechanismScene {
    fn title(&self) -> &str {
        &self.title
    }

    fn description(&self) -> &str {
        &self.description
    }

    fn model(&self) -> &'static str {
        self.name
    }

    fn run(&self) -> &Run {
        &self.run
    }

    fn problem(&self, _axes: Axes) -> Problem {
        MechanismScene::problem(self)
    }

    fn ways(&self) -> Vec<Way> {
        self.mechanism.ways(&self.start, self.run.span)
    }

    /// The states; the work belongs to one law among them.
    fn observed(&self, reference: &Reference) -> Vec<Observed> {
        let states = self.mechanism.states().iter().zip(&reference.sizes);
        states.map(|(quantity, size)| Observed { name: quantity.name.to_string(), size: *size }).collect()
    }

    fn parameters(&self) -> Vec<Parameter> {
        self.data.iter().map(|(quantity, value)| Parameter::of(quantity, *value)).collect()
    }

    fn column(&self, name: &str) -> Option<&'static Quantity> {
        self.mechanism.columns().into_iter().find(|quantity| quantity.name == name)
    }

    fn unit(&self, name: &str) -> Cow<'static, str> {
        self.column(name).map_or_else(|| "1".into(), |quantity| quantity.unit.clone())
    }

    fn told(&self, choice: &Choice, trajectory: &Trajectory) -> Told {
        let outcome = &trajectory.outcome;
        let ended = Ended {
            start: &self.start,
            last: &outcome.state[..self.mechanism.states().len()],
            time: outcome.time,
            left: trajectory.left.is_some(),
            method: choice.method,
            span: self.run.span,
        };
        let stopped = trajectory.stopped().is_some();
        let diagnosis = stopped.then(|| self.mechanism.diagnosis(&ended)).flatten();
        Told {
            theory: self.mechanism.theory(&self.start, choice.method, self.run.span),
            diagnosis: diagnosis.map(|Diagnosis { what, at }| match at {
                None => what.to_owned(),
                Some(at) => format!(
                    "{what}; by the closed form at t = {at:.12} s, the run's last good state is {:.1e} s from it",
                    (outcome.time - at).abs()
                ),
            }),
            closed_form: self.closed_form(trajectory),
        }
    }
}

impl MechanismScene {
    /// The initial value problem.
    pub fn problem(&self) -> Problem {
        self.mechanism.problem(&self.start, self.run.span)
    }

    /// The models under this one.
    pub fn ladder(&self) -> Ladder {
        self.mechanism.ladder(&self.start, self.run.span)
    }

    /// Runs. `progress` is told the fraction done after every step.
    pub fn simulate(&self, choice: &Choice, progress: impl FnMut(f64)) -> Trajectory {
        self.problem().simulate(choice, progress)
    }

    /// The states, the work, and what is computed from them: the columns of a run.
    pub fn columns(&self) -> Vec<&'static Quantity> {
        self.mechanism.columns()
    }

    /// `None` where there is no closed form at any instant of the run.
    fn closed_form(&self, trajectory: &Trajectory) -> Option<(&'static str, f64)> {
        let mut found: Option<(&'static str, f64)> = None;
        for (time, row) in trajectory.times.iter().zip(&trajectory.rows) {
            let Some((what, exact)) = self.mechanism.exact(&self.start, *time) else { continue };
            let distance = exact.iter().zip(row).map(|(a, b)| (a - b).abs() / a.abs().max(f64::MIN_POSITIVE));
            let largest = distance.fold(found.map_or(0.0, |(_, largest)| largest), f64::max);
            found = Some((what, largest));
        }
        found
    }
}
