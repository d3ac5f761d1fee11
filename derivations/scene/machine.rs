//! The machine of a scene, and other machines made of the same data.

use super::issue::{Issue, nearest};
use super::read::Table;
use crate::machines::{AnyMachine, Catalogued, ForMachine, Quantity, RotorState, Source};
use std::convert::Infallible;
use std::fmt;

/// More bars than any damper has.
const MOST: usize = 1000;

/// The data of a machine as a scene gives them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MachineData {
    /// In the machine's own order.
    pub numbers: Vec<(&'static Quantity, f64)>,
    /// (name, meaning, count).
    pub counts: Vec<(&'static str, &'static str, usize)>,
    /// W of a machine whose rotor follows the stator's field: the speed that a machine of constant speed keeps.
    synchronous_speed: Option<f64>,
}

/// Why a machine cannot be made of the data of a scene.
#[derive(Clone, Debug, PartialEq)]
pub enum NoModel {
    /// No machine has this name.
    Unknown { name: String },
    /// A datum that the scene does not give.
    Missing { model: String, datum: &'static str, meaning: &'static str, unit: &'static str },
    /// The scene starts with currents, and the other machine has other windings.
    Currents { model: String, given: usize, windings: usize },
}

/// The table `[machine]`.
pub fn read(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<(AnyMachine, MachineData)> {
    let mut table = top.table("machine", "the machine: `model` and its parameters");
    let model = table.text("model", "name of the machine");
    let mut source = FromTable { table, data: MachineData::default() };
    let machine = AnyMachine::read(&model.value, &mut source).map(|Ok(machine)| machine);
    let FromTable { mut table, mut data } = source;
    if machine.is_none() {
        if !model.value.is_empty() {
            let issue = Issue::at(model.span, format!("unknown machine `{}`", model.value), "not known");
            table.report(issue.accepted(known_machines(&model.value)));
        }
        // its keys cannot be judged
        table.known_all();
    }
    let sound = table.exists() && !table.has_issues();
    let found = issues.len();
    issues.extend(table.finish());
    let machine = machine.filter(|_| sound && issues.len() == found)?;
    data.synchronous_speed = machine.clone().apply(SynchronousSpeed);
    Some((machine, data))
}

impl MachineData {
    /// Another machine, made of these data.
    pub fn machine(&self, model: &str) -> Result<AnyMachine, NoModel> {
        AnyMachine::read(model, &mut FromData { model, data: self })
            .unwrap_or_else(|| Err(NoModel::Unknown { name: model.to_owned() }))
    }

    /// A parameter of a model in SI units.
    ///
    /// # Errors
    /// [`NoModel::Missing`].
    pub fn number(&self, model: &str, quantity: &'static Quantity) -> Result<f64, NoModel> {
        let Quantity { name, unit, meaning, .. } = *quantity;
        let kept = if name == "speed" { self.synchronous_speed } else { None };
        let missing = || NoModel::Missing { model: model.to_owned(), datum: name, meaning, unit };
        let given = self.numbers.iter().find(|(given, _)| given.name == name).map(|(_, value)| *value);
        given.or(kept).ok_or_else(missing)
    }

    /// A count of a model.
    ///
    /// # Errors
    /// [`NoModel::Missing`].
    pub fn count(&self, model: &str, name: &'static str, meaning: &'static str) -> Result<usize, NoModel> {
        let missing = || NoModel::Missing { model: model.to_owned(), datum: name, meaning, unit: "1" };
        self.counts.iter().find(|(given, ..)| *given == name).map(|(.., count)| *count).ok_or_else(missing)
    }

    /// The machines that can be made of these data.
    pub fn ladder(&self) -> Vec<&'static str> {
        AnyMachine::LIST.iter().map(|(name, _)| *name).filter(|name| self.machine(name).is_ok()).collect()
    }
}

/// Reads what a machine asks for, and keeps it. What is wrong is noted in the table and replaced by a harmless value.
struct FromTable<'a> {
    table: Table<'a>,
    data: MachineData,
}

impl Source for FromTable<'_> {
    type Error = Infallible;

    fn quantity(&mut self, quantity: &'static Quantity) -> Result<f64, Infallible> {
        let value = self.table.scalar(quantity.name, quantity.meaning, quantity.unit).value;
        self.data.numbers.push((quantity, value));
        Ok(value)
    }

    fn count(&mut self, name: &'static str, meaning: &'static str) -> Result<usize, Infallible> {
        let value = self.table.count(name, meaning, 1, MOST).value;
        self.data.counts.push((name, meaning, value));
        Ok(value)
    }
}

struct FromData<'a> {
    model: &'a str,
    data: &'a MachineData,
}

impl Source for FromData<'_> {
    type Error = NoModel;

    fn quantity(&mut self, quantity: &'static Quantity) -> Result<f64, NoModel> {
        self.data.number(self.model, quantity)
    }

    fn count(&mut self, name: &'static str, meaning: &'static str) -> Result<usize, NoModel> {
        self.data.count(self.model, name, meaning)
    }
}

struct SynchronousSpeed;

impl ForMachine for SynchronousSpeed {
    type Output = Option<f64>;

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> Option<f64> {
        (M::ROTOR == RotorState::AngleAndSpeed).then(|| machine.frame_speed())
    }
}

/// The known machines, the one that was probably meant first.
fn known_machines(name: &str) -> String {
    let names = || AnyMachine::LIST.iter().map(|(name, _)| *name);
    let list = names().collect::<Vec<_>>().join(", ");
    match nearest(name, names()) {
        Some(nearest) => format!("is `{nearest}` meant? Known: {list}"),
        None => format!("known: {list}"),
    }
}

impl fmt::Display for NoModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { name } => write!(f, "unknown machine `{name}`; {}", known_machines(name)),
            Self::Missing { model, datum, meaning, unit } => {
                write!(f, "`{model}` needs `{datum}` ({meaning}, {unit}), which the scene's [machine] does not give")
            }
            Self::Currents { model, given, windings } => write!(
                f,
                "the scene starts with {given} currents, and `{model}` has {windings} windings; \
                 leave `currents` out to start without"
            ),
        }
    }
}

impl std::error::Error for NoModel {}
