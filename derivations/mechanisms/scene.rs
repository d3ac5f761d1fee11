//! Scenes of mechanisms: read by the names of data and states, run as any other problem, with what theory says beside it.

use super::rewritten::{Rewritten, ready};
use super::{Balanced, Diagnosis, Ended, LIST, Mechanism};
use crate::machines::Quantity;
use crate::scene::atlas::{Observed, Standing, Way};
use crate::scene::file::{Family, Opening};
use crate::scene::problem::{Invariant, Problem};
use crate::scene::read::{At, Table};
use crate::scene::smooth::{Parameter, Smooth, Told};
use crate::scene::{Axes, Choice, Issue, Run, Trajectory, run};
use integrators::{Method, Reference};
use std::convert::Infallible;
use std::fmt::Debug;
use std::ops::Range;
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

/// A mechanism in the list.
pub struct Entry {
    name: &'static str,
    summary: &'static str,
    read: fn(&mut Table<'_>, &mut Vec<Issue>) -> Option<Read>,
}

/// What a file says of a mechanism and its start.
struct Read {
    data: Vec<(&'static Quantity, f64)>,
    start: Vec<f64>,
    mechanism: Arc<dyn Erased>,
}

/// The entry of a mechanism.
pub const fn entry<M: Mechanism>() -> Entry {
    Entry { name: M::NAME, summary: M::SUMMARY, read: read::<M> }
}

/// A mechanism, its type forgotten once its data are known.
trait Erased: Debug + Send + Sync {
    fn problem(&self, start: &[f64], span: f64) -> Problem;
    fn ways(&self, start: &[f64], span: f64) -> Vec<Way>;
    fn states(&self) -> &'static [Quantity];
    fn columns(&self) -> Vec<&'static Quantity>;
    fn diagnosis(&self, run: &Ended<'_>) -> Option<Diagnosis>;
    fn exact(&self, start: &[f64], time: f64) -> Option<(&'static str, Vec<f64>)>;
    fn theory(&self, start: &[f64], method: Method, span: f64) -> Vec<String>;
}

/// The last state: what has been done on the mechanism.
const WORK: Quantity = Quantity::any("work", "J", "work done on the mechanism");

impl<M: Mechanism> Erased for M {
    fn problem(&self, start: &[f64], span: f64) -> Problem {
        let count = M::STATE.len();
        let mut state = self.state(start);
        state.push(0.0);
        let law = ready(Balanced(self.clone()));
        let (energetic, showing, judging) = (self.clone(), self.clone(), self.clone());
        let balance = move |time: f64, y: &[f64]| energetic.energy(time, &y[..count]) - y[count];
        Problem {
            law,
            state,
            span,
            invariants: vec![Invariant { name: "energy_less_work", value: Box::new(balance) }],
            columns: self.columns().iter().map(|quantity| quantity.name.to_owned()).collect(),
            row: Box::new(move |time, y| [y, &showing.shown(time, &y[..count])].concat()),
            outside: Box::new(move |y| judging.outside(&y[..count])),
        }
    }

    fn ways(&self, start: &[f64], span: f64) -> Vec<Way> {
        let own = Way::of(M::FORMULATION, "", Standing::Own, self.problem(start, span));
        let columns: Vec<String> = M::STATE.iter().map(|quantity| quantity.name.to_owned()).collect();
        let other = |Rewritten { formulation, law, state, whole }| Way {
            formulation,
            model: "",
            standing: Standing::Exact,
            law,
            state,
            sizes: Vec::new(),
            columns: columns.clone(),
            row: Box::new(move |_, y| whole(y)),
        };
        std::iter::once(own).chain(self.rewritten(start).into_iter().map(other)).collect()
    }

    fn states(&self) -> &'static [Quantity] {
        M::STATE
    }

    fn columns(&self) -> Vec<&'static Quantity> {
        M::STATE.iter().chain([&WORK]).chain(M::SHOWN).collect()
    }

    fn diagnosis(&self, run: &Ended<'_>) -> Option<Diagnosis> {
        Mechanism::diagnosis(self, run)
    }

    fn exact(&self, start: &[f64], time: f64) -> Option<(&'static str, Vec<f64>)> {
        Mechanism::exact(self, start, time)
    }

    fn theory(&self, start: &[f64], method: Method, span: f64) -> Vec<String> {
        Mechanism::theory(self, start, method, span)
    }
}

/// The tables `[data]` and `[start]`.
fn read<M: Mechanism>(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Read> {
    let mut places: Vec<(&'static str, f64, Range<usize>)> = Vec::new();
    let mut table = top.table("data", "the mechanism's data, each with its unit");
    let mut data = Vec::new();
    let Ok(mechanism) = M::read::<Infallible>(&mut |quantity| {
        let value = number(&mut table, quantity, &mut places);
        data.push((quantity, value));
        Ok(value)
    });
    let mut sound = table.exists() && !table.has_issues();
    issues.extend(table.finish());
    let mut table = top.table("start", "the initial state");
    let start: Vec<f64> = M::START.iter().map(|quantity| number(&mut table, quantity, &mut places)).collect();
    sound &= table.exists() && !table.has_issues();
    issues.extend(table.finish());
    // data that are already known to be wrong have been replaced, and say nothing about the mechanism
    if !sound {
        return None;
    }
    for amiss in mechanism.amiss(&start) {
        let found = places.iter().find(|(name, ..)| *name == amiss.name);
        let (label, span) =
            found.map_or_else(Default::default, |(_, value, span)| (format!("it is {value}"), span.clone()));
        issues.push(Issue::at(span, amiss.what, label).accepted(amiss.accepted));
        sound = false;
    }
    sound.then(|| Read { data, start, mechanism: Arc::new(mechanism) })
}

/// A quantity, judged by its own bound.
fn number(
    table: &mut Table<'_>,
    quantity: &'static Quantity,
    places: &mut Vec<(&'static str, f64, Range<usize>)>,
) -> f64 {
    let At { value, span } = table.scalar(quantity.name, quantity.meaning, quantity.unit);
    if quantity.positive && value <= 0.0 {
        let title = format!("`{}`, the {}, must be positive", quantity.name, quantity.meaning);
        table.report(Issue::at(span.clone(), title, format!("it is {value}")).accepted("a positive value is accepted"));
    }
    places.push((quantity.name, value, span));
    value
}

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
            columns.map(|columns| columns.iter().map(|quantity| quantity.name.to_owned()).collect());
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
        states.map(|(quantity, size)| Observed { name: quantity.name.to_owned(), size: *size }).collect()
    }

    fn parameters(&self) -> Vec<Parameter> {
        self.data.iter().map(|(quantity, value)| Parameter::of(quantity, *value)).collect()
    }

    fn column(&self, name: &str) -> Option<&'static Quantity> {
        self.mechanism.columns().into_iter().find(|quantity| quantity.name == name)
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
