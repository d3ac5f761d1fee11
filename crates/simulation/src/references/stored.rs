//! References stored in files: the digits, the methods, and data that identify the problem.

use super::across_events::Event;
use crate::{Problem, methods};
use field::{DoubleDouble, Over, decimal, from_decimal};
use integrators::{ENOUGH_DIGITS, Ode, Reference, Work};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use toml::{Table, Value};

/// The largest relative difference between the rates of a law and the stored rates of an equal law. A change of the
/// data by the last bit of an `f64` gives 1e-16; another order of summation in the law gives rounding in double-double.
const SAME_LAW: f64 = 1e-20;

/// The number of digits of the stored rates.
const RATE_DIGITS: f64 = 28.0;

/// A reference with data that identify its problem.
#[derive(Clone, Debug)]
pub struct Stored {
    pub reference: Reference,
    /// The initial state.
    start: Vec<f64>,
    /// The rates y' summed over the output times, which identify law and data.
    rates: Vec<DoubleDouble>,
    /// The events of a motion across events.
    pub events: Vec<Event>,
}

/// The problem of a reference: an initial state, and the rates at each output time.
pub trait Owner {
    fn start(&self) -> &[f64];

    /// Writes the rates y' at a time.
    fn rates_at(&self, time: f64, state: &[DoubleDouble], rates: &mut [DoubleDouble]);
}

impl Owner for Problem {
    fn start(&self) -> &[f64] {
        &self.state
    }

    fn rates_at(&self, time: f64, state: &[DoubleDouble], rates: &mut [DoubleDouble]) {
        let law: &dyn Ode<DoubleDouble> = &*self.law;
        law.rates(DoubleDouble::lift(time), state, rates);
    }
}

/// The path of the reference of a scene file: `references/NAME.reference` in its folder.
pub fn place(scene: &Path) -> PathBuf {
    let folder = scene.parent().unwrap_or(Path::new("")).join("references");
    folder.join(scene.file_stem().unwrap_or_default()).with_extension("reference")
}

impl Stored {
    /// The reference of a motion with its events, for storing; numbers are rounded as in the file.
    pub fn of(owner: &dyn Owner, reference: Reference, events: Vec<Event>) -> Self {
        let reference = Reference { digits: (reference.digits * 10.0).floor() / 10.0, ..reference };
        let Reference { sizes, digits, .. } = &reference;
        let rounded =
            |(number, size): (&DoubleDouble, &f64)| from_decimal(&decimals(*number, *size, *digits)).unwrap_or(*number);
        let row = |state: &[DoubleDouble]| state.iter().zip(sizes).map(rounded).collect();
        let states = reference.states.iter().map(|state| row(state)).collect();
        let event = |event: Event| {
            let time = rounded((&event.time, &event.time.hi()));
            Event { time, state: row(&event.state), ..event }
        };
        let events = events.into_iter().map(event).collect();
        let reference = Reference { states, ..reference };
        let rates = Rates::of(owner, &reference).sums;
        Stored { reference, start: owner.start().to_vec(), rates, events }
    }

    /// The reference stored for a scene file; `None` where none can be read.
    pub fn beside(scene: &Path) -> Option<Self> {
        Self::read(&std::fs::read_to_string(place(scene)).ok()?).ok()
    }

    /// Whether this is the reference of a problem, with an equal span.
    pub fn serves(&self, problem: &Problem) -> bool {
        self.reference.times.last() == Some(&problem.span) && self.belongs_to(problem)
    }

    /// Whether this is the reference of a problem, by its initial state and its rates at all output times.
    pub fn belongs_to(&self, owner: &dyn Owner) -> bool {
        if self.start != owner.start() {
            return false;
        }
        let now = Rates::of(owner, &self.reference);
        let same = |((a, b), size): ((&DoubleDouble, &DoubleDouble), f64)| (*a - *b).hi().abs() <= SAME_LAW * size;
        now.sums.len() == self.rates.len() && now.sums.iter().zip(&self.rates).zip(now.sizes()).all(same)
    }

    /// The reference as text. Every number has one digit more than the digits of agreement, so that rounding loses
    /// none.
    pub fn write(&self, scene: &str) -> String {
        let Reference { times, states, digits, sizes, methods: [one, other], work } = &self.reference;
        let mut text = format!(
            "# Reference of {scene}: the states that two methods of different families agree on in double-double.\n\
             # Made by: dalembert reference {scene}, version {}\n\
             # Digits count from the largest size of a component; one more is written than is shared.\n\n",
            env!("CARGO_PKG_VERSION")
        );
        let mut line = |key: &str, value: String| {
            // writing to a string cannot fail
            let _ = writeln!(text, "{key} = {value}");
        };
        line("digits", format!("{digits:.1}"));
        line("methods", format!("{:?}", [one, other].map(|method| methods::written(*method))));
        line("steps", format!("[{}, {}]", work[0].steps, work[1].steps));
        line("evaluations", format!("[{}, {}]", work[0].rates, work[1].rates));
        line("start", format!("{:?}", self.start));
        line("sizes", format!("{sizes:?}"));
        line("times", format!("{times:?}"));
        let row = |numbers: &[DoubleDouble], sizes: &[f64], digits: f64| {
            let written =
                numbers.iter().zip(sizes).map(|(number, size)| format!("\"{}\"", decimals(*number, *size, digits)));
            format!("[{}]", written.collect::<Vec<_>>().join(", "))
        };
        let rows: Vec<String> = states.iter().map(|state| format!("  {},\n", row(state, sizes, *digits))).collect();
        line("states", format!("[\n{}]", rows.concat()));
        let sizes: Vec<f64> = self.rates.iter().map(|rate| rate.hi().abs()).collect();
        line("rates", row(&self.rates, &sizes, RATE_DIGITS));
        if !self.events.is_empty() {
            let sizes = &self.reference.sizes;
            let event = |Event { time, state, what, regime }: &Event| {
                let time = decimals(*time, time.hi(), *digits);
                let state = row(state, sizes, *digits);
                format!("  {{ time = \"{time}\", what = {what:?}, regime = {regime:?}, state = {state} }},\n")
            };
            let events: Vec<String> = self.events.iter().map(event).collect();
            line("events", format!("[\n{}]", events.concat()));
        }
        text
    }

    /// Reads a reference from text.
    ///
    /// # Errors
    /// The fault, as text.
    pub fn read(text: &str) -> Result<Self, String> {
        let table: Table = text.parse().map_err(|error: toml::de::Error| error.message().to_owned())?;
        let digits = table.get("digits").and_then(Value::as_float).ok_or("`digits` is no number")?;
        let [one, other] = pair(&table, "methods", |value| methods::method(value.as_str()?).ok())?;
        let count = |value: &Value| u64::try_from(value.as_integer()?).ok();
        let (steps, evaluations) = (pair(&table, "steps", count)?, pair(&table, "evaluations", count)?);
        let work = |k: usize| Work { steps: steps[k], rates: evaluations[k], ..Work::default() };
        let number = |value: &Value| from_decimal(value.as_str()?);
        let start = list(&table, "start", Value::as_float)?;
        let states = list(&table, "states", |row| row.as_array()?.iter().map(number).collect::<Option<Vec<_>>>())?;
        let reference = Reference {
            times: list(&table, "times", Value::as_float)?,
            sizes: list(&table, "sizes", Value::as_float)?,
            states,
            digits,
            methods: [one, other],
            work: [work(0), work(1)],
        };
        let n = start.len();
        let whole = reference.sizes.len() == n
            && reference.times.len() == reference.states.len()
            && reference.states.iter().all(|state| state.len() == n);
        if !whole || digits < ENOUGH_DIGITS {
            return Err("a row is missing or short".to_owned());
        }
        let event = |value: &Value| {
            let text = |key| value.get(key)?.as_str().map(str::to_owned);
            let state = value.get("state")?.as_array()?.iter().map(number).collect::<Option<_>>()?;
            Some(Event { time: number(value.get("time")?)?, state, what: text("what")?, regime: text("regime")? })
        };
        let events = if table.contains_key("events") { list(&table, "events", event)? } else { Vec::new() };
        Ok(Stored { reference, start, rates: list(&table, "rates", number)?, events })
    }
}

/// A number to one more than `digits` significant digits relative to the size of its component.
pub fn decimals(number: DoubleDouble, size: f64, digits: f64) -> String {
    let places = (digits + 1.0 - size.log10()).ceil().clamp(0.0, 60.0) as usize;
    decimal(number, places).unwrap_or_default()
}

fn list<T>(table: &Table, key: &str, one: impl Fn(&Value) -> Option<T>) -> Result<Vec<T>, String> {
    let values = table.get(key).and_then(Value::as_array);
    values.and_then(|values| values.iter().map(one).collect()).ok_or_else(|| format!("`{key}` is no list of its kind"))
}

fn pair<T>(table: &Table, key: &str, one: impl Fn(&Value) -> Option<T>) -> Result<[T; 2], String> {
    list(table, key, one)?.try_into().map_err(|_| format!("`{key}` needs two entries"))
}

/// The rates y' summed over the output times of a reference, and the sums of their magnitudes.
struct Rates {
    sums: Vec<DoubleDouble>,
    magnitudes: Vec<f64>,
}

impl Rates {
    fn of(owner: &dyn Owner, reference: &Reference) -> Self {
        let zeros = vec![DoubleDouble::from(0.0); owner.start().len()];
        let mut rates = Rates { sums: zeros.clone(), magnitudes: vec![0.0; zeros.len()] };
        let mut one = zeros;
        for (time, state) in reference.times.iter().zip(&reference.states) {
            owner.rates_at(*time, state, &mut one);
            rates.sums.iter_mut().zip(&one).for_each(|(sum, one)| *sum += *one);
            rates.magnitudes.iter_mut().zip(&one).for_each(|(sum, one)| *sum += one.hi().abs());
        }
        rates
    }

    /// The sizes to which differences of components are relative; for a component that stays zero, a fraction of the
    /// largest size.
    fn sizes(&self) -> impl Iterator<Item = f64> {
        let largest = self.magnitudes.iter().copied().fold(0.0, f64::max);
        self.magnitudes.iter().map(move |size| size.max(1e-9 * largest))
    }
}
