//! The machine of a scene, and other machines made of the same data.

use super::issue::Issue;
use super::read::{Table, in_unit};

use super::written;
use crate::machines::text::{self, Laws};
use crate::machines::{Allowed, AnyMachine, Bound, Catalogued, ForMachine, Quantity, RotorState, Source};
use std::borrow::Cow;
use std::convert::Infallible;
use std::fmt;
use std::sync::Arc;
use symbolic::{Dimension, Sym};
use units::{Dimension as Unit, nearest};

/// More bars than any damper has.
const MOST: usize = 1000;

/// The data of a machine as a scene gives them.
#[derive(Clone, Debug, Default)]
pub struct MachineData {
    /// In the machine's own order.
    pub numbers: Vec<(Quantity, f64)>,
    /// (name, meaning, count).
    pub counts: Vec<(&'static str, &'static str, usize)>,
    /// Of a motor that is written in the scene.
    pub laws: Option<Arc<Laws>>,
    /// The data beyond their bounds that the scene asks for.
    pub allowed: Allowed,
    /// W of a machine whose rotor follows the stator's field: the speed that a machine of constant speed keeps.
    synchronous_speed: Option<f64>,
}

/// Why a machine cannot be made of the data of a scene.
#[derive(Clone, Debug, PartialEq)]
pub enum NoModel {
    /// No machine has this name.
    Unknown { name: String },
    /// The motor whose laws stand in a scene, where none do.
    NoLaws,
    /// A datum that the scene does not give.
    Missing { model: String, datum: Cow<'static, str>, meaning: Cow<'static, str>, unit: Cow<'static, str> },
    /// A datum beyond its bound.
    Beyond { datum: Box<Quantity>, value: f64 },
    /// A resistance or an inductance that follows from a written motor's data, beyond its bound: of which current.
    Winding { current: String, what: &'static str, unit: &'static str, bound: Bound, value: f64 },
    /// The scene starts with currents, and the other machine has other windings.
    Currents { model: String, given: usize, windings: usize },
}

/// The table `[machine]`.
pub fn read(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<(AnyMachine, MachineData)> {
    let mut table = top.table("machine", "the machine: `model` and its parameters");
    let model = table.text("model", "name of the machine");
    if model.value == text::NAME {
        return written::read(table, issues);
    }
    let data = MachineData { allowed: table.allowed(), ..MachineData::default() };
    let mut source = FromTable { table, data };
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
    /// A machine of the list, with this value for each quantity and this count for each number of bars; and its data.
    pub fn sampled(
        model: &str,
        value: impl FnMut(&Quantity) -> f64,
        count: usize,
    ) -> Option<(AnyMachine, MachineData)> {
        let data = MachineData { allowed: Allowed::ALL, ..MachineData::default() };
        let mut source = Sampled { value, count, data };
        let Ok(machine) = AnyMachine::read(model, &mut source)?;
        let mut data = source.data;
        data.synchronous_speed = machine.clone().apply(SynchronousSpeed);
        Some((machine, data))
    }

    /// Of a motor that is written in a scene, with its parameters in their order; and the motor.
    pub(super) fn written(laws: Laws, values: &[f64], allowed: Allowed) -> (AnyMachine, Self) {
        let laws = Arc::new(laws);
        let numbers: Vec<_> = laws.parameters().iter().cloned().zip(values.iter().copied()).collect();
        let mut given = values.iter().copied();
        let read = AnyMachine::written(Arc::clone(&laws), |_| Ok::<f64, Infallible>(given.next().unwrap_or_default()));
        let Ok(machine) = read;
        let synchronous_speed = machine.clone().apply(SynchronousSpeed);
        (machine, MachineData { numbers, counts: Vec::new(), laws: Some(laws), allowed, synchronous_speed })
    }
}

impl MachineData {
    /// Another machine, made of these data.
    ///
    /// # Errors
    /// Why it cannot be made: a datum that is missing or beyond its bound.
    pub fn machine(&self, model: &str) -> Result<AnyMachine, NoModel> {
        let unknown = match model {
            text::NAME => NoModel::NoLaws,
            _ => NoModel::Unknown { name: model.to_owned() },
        };
        let machine = AnyMachine::read(model, &mut FromData { model, data: self }).unwrap_or(Err(unknown))?;
        machine.clone().apply(Bounded { allowed: self.allowed })?;
        Ok(machine)
    }

    /// A parameter of a model in SI units.
    ///
    /// # Errors
    /// [`NoModel::Missing`], [`NoModel::Beyond`].
    pub fn number(&self, model: &str, quantity: &Quantity) -> Result<f64, NoModel> {
        let kept = if quantity.name == "speed" { self.synchronous_speed } else { None };
        let given = self.numbers.iter().find(|(given, _)| given.name == quantity.name).map(|(_, value)| *value);
        let value = given.or(kept).ok_or_else(|| {
            let Quantity { name, unit, meaning, .. } = quantity.clone();
            NoModel::Missing { model: model.to_owned(), datum: name, meaning, unit }
        })?;
        match quantity.bound.holds(value, self.allowed) {
            true => Ok(value),
            false => Err(NoModel::Beyond { datum: Box::new(quantity.clone()), value }),
        }
    }

    /// A count of a model.
    ///
    /// # Errors
    /// [`NoModel::Missing`].
    pub fn count(&self, model: &str, name: &'static str, meaning: &'static str) -> Result<usize, NoModel> {
        let missing = || NoModel::Missing {
            model: model.to_owned(),
            datum: name.into(),
            meaning: meaning.into(),
            unit: "1".into(),
        };
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

    fn quantity(&mut self, quantity: &Quantity) -> Result<f64, Infallible> {
        let value = self.table.datum(quantity).value;
        self.data.numbers.push((quantity.clone(), value));
        Ok(value)
    }

    fn count(&mut self, name: &'static str, meaning: &'static str) -> Result<usize, Infallible> {
        let value = self.table.count(name, meaning, 1, MOST).value;
        self.data.counts.push((name, meaning, value));
        Ok(value)
    }
}

/// Answers whatever a machine asks for, and keeps it.
struct Sampled<F> {
    value: F,
    count: usize,
    data: MachineData,
}

impl<F: FnMut(&Quantity) -> f64> Source for Sampled<F> {
    type Error = Infallible;

    fn quantity(&mut self, quantity: &Quantity) -> Result<f64, Infallible> {
        let value = (self.value)(quantity);
        self.data.numbers.push((quantity.clone(), value));
        Ok(value)
    }

    fn count(&mut self, name: &'static str, meaning: &'static str) -> Result<usize, Infallible> {
        self.data.counts.push((name, meaning, self.count));
        Ok(self.count)
    }
}

/// A symbol for every parameter, with its dimension.
pub struct Named<'a> {
    data: &'a MachineData,
    pub dimensions: Vec<(String, Dimension)>,
}

impl<'a> Named<'a> {
    /// Counts and laws are those of the data.
    pub fn new(data: &'a MachineData) -> Self {
        Named { data, dimensions: Vec::new() }
    }
}

impl Source<Sym> for Named<'_> {
    type Error = Infallible;

    fn quantity(&mut self, quantity: &Quantity) -> Result<Sym, Infallible> {
        self.dimensions.push((quantity.name.to_string(), Unit::of(&quantity.unit).of_expressions()));
        Ok(Sym::symbol(&quantity.name))
    }

    fn count(&mut self, name: &'static str, _: &'static str) -> Result<usize, Infallible> {
        Ok(self.data.counts.iter().find(|(given, ..)| *given == name).map_or(1, |(.., count)| *count))
    }

    fn laws(&mut self) -> Option<Arc<Laws>> {
        self.data.laws.clone()
    }
}

struct FromData<'a> {
    model: &'a str,
    data: &'a MachineData,
}

impl Source for FromData<'_> {
    type Error = NoModel;

    fn quantity(&mut self, quantity: &Quantity) -> Result<f64, NoModel> {
        self.data.number(self.model, quantity)
    }

    fn count(&mut self, name: &'static str, meaning: &'static str) -> Result<usize, NoModel> {
        self.data.count(self.model, name, meaning)
    }

    fn laws(&mut self) -> Option<Arc<Laws>> {
        self.data.laws.clone()
    }
}

/// Whether the circuits of a machine can exist, or are asked for.
struct Bounded {
    allowed: Allowed,
}

impl ForMachine for Bounded {
    type Output = Result<(), NoModel>;

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> Result<(), NoModel> {
        for winding in 0..machine.windings() {
            let inductance = ("inductance", "H", Bound::Positive, machine.inductance(winding));
            let resistance = ("resistance", "ohm", Bound::Resistance, machine.resistance(winding));
            for (what, unit, bound, value) in [inductance, resistance] {
                if !bound.holds(value, self.allowed) {
                    let current = machine.current_name(winding);
                    return Err(NoModel::Winding { current, what, unit, bound, value });
                }
            }
        }
        Ok(())
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
    let names = || AnyMachine::LIST.iter().map(|(name, _)| *name).chain([text::NAME]);
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
            Self::NoLaws => write!(
                f,
                "`{}` is the motor whose laws stand in a scene, and none stand here; a scene with `model = \"{0}\"` is accepted",
                text::NAME
            ),
            Self::Beyond { datum, value } => {
                let Quantity { name, meaning, unit, bound } = &**datum;
                let (unit, broken, accepted) = (in_unit(unit), bound.broken(), bound.accepted(*value));
                write!(f, "`{name}`, {meaning}, {broken}: it is {value}{unit}; {accepted}")
            }
            Self::Winding { current, what, unit, bound, value } => {
                let (broken, accepted) = (bound.broken(), bound.accepted(*value));
                write!(f, "the {what} of the winding of `{current}` {broken}: it is {value} {unit}; {accepted}")
            }
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
