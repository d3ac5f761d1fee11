//! The table `[machine]` of a scene, and other motors with its data.

use crate::{Count, Machine, Motor, TooLong, catalogue, text, text_motor};
use reader::{Allowed, Bound, Issue, Quantity, Table, in_unit};
use std::borrow::Cow;
use std::fmt;
use units::nearest;

/// The largest count of bars.
const MOST: usize = 1000;

/// The reason why a motor cannot be made from the data of a scene.
#[derive(Clone, Debug, PartialEq)]
pub enum NoModel {
    /// No machine has this name.
    Unknown { name: String },
    /// The scene has no motor laws as text.
    NoLaws,
    /// The laws are too long for a program.
    Long(TooLong),
    /// The scene does not give a datum.
    Missing { model: String, datum: Cow<'static, str>, meaning: Cow<'static, str>, unit: Cow<'static, str> },
    /// A value is outside the bound of its datum.
    Beyond { datum: Box<Quantity>, value: f64 },
    /// A resistance or an inductance, computed from the data of a motor as text, is outside its bound.
    Winding { current: String, what: &'static str, unit: &'static str, bound: Bound, value: f64 },
    /// The scene has initial currents, and the other motor has a different number of windings.
    Currents { model: String, given: usize, windings: usize },
}

/// Reads the table `[machine]`. Faults are added to `issues`.
pub fn read(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Motor> {
    let mut table = top.table("machine", "the machine: `model` and its parameters");
    let model = table.text("model", "name of the machine");
    if catalogue::is_ambiguous(&model.value) {
        let title = format!("several motors are called `{}`", model.value);
        table.report(Issue::at(model.span, title, "which one?").accepted("catalogues of motors whose names differ"));
        table.known_all();
        issues.extend(table.finish());
        return None;
    }
    if model.value == text::NAME {
        return text_motor::read(table, issues);
    }
    let Some(entry) = catalogue::entry(&model.value) else {
        if !model.value.is_empty() {
            let issue = Issue::at(model.span, format!("unknown machine `{}`", model.value), "not known");
            table.report(issue.accepted(known_machines(&model.value)));
        }
        // the keys of an unknown model cannot be checked
        table.known_all();
        issues.extend(table.finish());
        return None;
    };
    let (span, allowed) = (table.span(), table.allowed());
    let data = entry.data.iter().map(|quantity| table.datum(quantity).value).collect();
    let count = |&Count { name, meaning }: &Count| table.count(name, meaning, 1, MOST).value;
    let counts: Vec<usize> = entry.counts.iter().map(count).collect();
    let sound = table.exists() && !table.has_issues();
    let found = issues.len();
    issues.extend(table.finish());
    if !sound || issues.len() > found {
        return None;
    }
    match entry.laws(&counts) {
        Ok(laws) => Some(Motor::new(laws, data, allowed)),
        Err(long) => {
            issues.push(Issue::at(span, format!("a law has {long}"), "with these counts").accepted("smaller counts"));
            None
        }
    }
}

impl Motor {
    /// The motor `model` with the data of this motor; the motor itself if that is its name.
    ///
    /// # Errors
    /// [`NoModel`] where a datum is missing or outside its bound.
    pub fn model(&self, model: &str) -> Result<Motor, NoModel> {
        if model == self.name() {
            return self.checked(self.values().to_vec());
        }
        let entry = catalogue::entry(model).ok_or_else(|| match model {
            text::NAME => NoModel::NoLaws,
            _ => NoModel::Unknown { name: model.to_owned() },
        })?;
        let data = entry.data.iter().map(|quantity| self.number(model, quantity)).collect::<Result<_, _>>()?;
        let count = |&Count { name, meaning }: &Count| {
            let missing = || NoModel::Missing {
                model: model.to_owned(),
                datum: name.into(),
                meaning: meaning.into(),
                unit: "1".into(),
            };
            self.count(name).ok_or_else(missing)
        };
        let counts = entry.counts.iter().map(count).collect::<Result<Vec<usize>, _>>()?;
        let laws = entry.laws(&counts).map_err(NoModel::Long)?;
        bounded(Motor::new(laws, data, self.allowed))
    }

    /// The motor with other data, in order.
    ///
    /// # Errors
    /// [`NoModel::Beyond`] or [`NoModel::Winding`] for data outside their bounds.
    pub fn checked(&self, data: Vec<f64>) -> Result<Motor, NoModel> {
        let motor = self.with_data(data);
        motor.data().try_for_each(|(quantity, value)| within(quantity, value, self.allowed).map(|_| ()))?;
        bounded(motor)
    }

    /// The motor with another count, such as that of its bars.
    ///
    /// # Errors
    /// [`NoModel::Unknown`] where the motor has no such count, or is not in the catalogue.
    pub fn with_count(&self, name: &str, number: usize) -> Result<Motor, NoModel> {
        let counts = self.laws().counts().iter();
        let counts: Vec<usize> = counts.map(|(count, own)| if count.name == name { number } else { *own }).collect();
        let entry = catalogue::entry(self.name()).filter(|_| self.count(name).is_some());
        let entry = entry.ok_or_else(|| NoModel::Unknown { name: self.name().to_owned() })?;
        let laws = entry.laws(&counts).map_err(NoModel::Long)?;
        Ok(Motor::new(laws, self.values().to_vec(), self.allowed))
    }

    /// The names of the motors of the catalogue that can be made from the data of this motor.
    pub fn models(&self) -> Vec<&'static str> {
        catalogue::entries().into_iter().map(|entry| entry.name).filter(|name| self.model(name).is_ok()).collect()
    }

    /// The value of a datum of another motor, in SI units.
    fn number(&self, model: &str, quantity: &Quantity) -> Result<f64, NoModel> {
        let kept = if quantity.name == "speed" { self.synchronous_speed() } else { None };
        let value = self.datum(&quantity.name).or(kept).ok_or_else(|| {
            let Quantity { name, unit, meaning, .. } = quantity.clone();
            NoModel::Missing { model: model.to_owned(), datum: name, meaning, unit }
        })?;
        within(quantity, value, self.allowed)
    }
}

/// The value, if its bound admits it.
fn within(quantity: &Quantity, value: f64, allowed: Allowed) -> Result<f64, NoModel> {
    match quantity.bound.holds(value, allowed) {
        true => Ok(value),
        false => Err(NoModel::Beyond { datum: Box::new(quantity.clone()), value }),
    }
}

/// The motor, if its inductances and resistances are within bounds or the file allows others.
fn bounded(motor: Motor) -> Result<Motor, NoModel> {
    for winding in 0..motor.windings() {
        let inductance = ("inductance", "H", Bound::Positive, motor.inductance(winding));
        let resistance = ("resistance", "ohm", Bound::Resistance, motor.resistance(winding));
        for (what, unit, bound, value) in [inductance, resistance] {
            if !bound.holds(value, motor.allowed) {
                let current = motor.current_name(winding);
                return Err(NoModel::Winding { current, what, unit, bound, value });
            }
        }
    }
    Ok(motor)
}

/// The names of all machines for a message, beginning with the most similar one.
fn known_machines(name: &str) -> String {
    let names = || catalogue::entries().into_iter().map(|entry| entry.name).chain([text::NAME]);
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
            Self::Long(long) => write!(f, "a law has {long}; smaller counts are accepted"),
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
