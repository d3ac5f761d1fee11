//! The numbers of a file for which the page has sliders: parameters, and the start.
//!
//! A slider changes the text in memory. The stages receive the changed text, and the page shows the lines in which it differs. This works for all
//! scenes whose numbers are written with units; the page shows the results that the changed file would give.

mod changed_text;

pub use changed_text::{ChangedText, changed};

use charts::page::live::Slider;
use std::f64::consts::PI;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};
use units::quantity::parse_any;

/// A number of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Datum {
    /// The path of the number in the file, as dotted keys of TOML: `parameters.m`.
    pub id: String,
    /// The value in the file, in `unit`.
    pub number: f64,
    /// The unit as written in the file; empty for a pure number.
    pub unit: String,
    /// The text before the number: `guess ` or empty.
    pub before: &'static str,
    pub place: Place,
    /// Whether the number is an initial value.
    is_start: bool,
}

/// The position of a number in the file.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// The range of its value in bytes, including the quotes.
    Written(Range<usize>),
    /// The number has no entry: this key of the table `start` is left out and means zero.
    LeftOut { key: String },
}

/// The sentence above the sliders.
pub const ABOUT: &str = "A slider goes to twice its value, of parameters from a fiftieth of it, of the start from minus twice; of angles at the \
                         start over a full turn both ways; where the value is zero, from -1 to 1. The file is not changed.";

/// The marker of an initial value that constraints may change.
const GUESS: &str = "guess ";

impl Datum {
    /// The slider for the number.
    pub fn slider(&self) -> Slider {
        Slider { id: self.id.clone(), number: self.number, unit: self.unit.clone(), range: self.range() }
    }

    /// The ends of the slider.
    fn range(&self) -> [f64; 2] {
        let twice = 2.0 * self.number;
        let turn = match self.unit.as_str() {
            "deg" => 180.0,
            "rad" => PI,
            _ => 0.0,
        };
        match self.is_start {
            true if turn > 0.0 => [-turn.max(twice.abs()), turn.max(twice.abs())],
            _ if self.number == 0.0 => [-1.0, 1.0],
            true => [-twice.abs(), twice.abs()],
            false => [(self.number / 50.0).min(twice), (self.number / 50.0).max(twice)],
        }
    }

    /// A value of the slider as text, rounded to a power of ten of about a hundredth of the range, without meaningless digits.
    pub fn written(&self, value: f64) -> String {
        let [low, high] = self.range();
        let power = ((high - low) / 200.0).log10().floor();
        match power as i32 {
            power @ -9..=5 => {
                let step = 10_f64.powi(power);
                let rounded = (value / step).round() * step;
                let digits = usize::try_from(-power).unwrap_or(0);
                // the addition removes the sign of a negative zero
                format!("{:.digits$}", rounded + 0.0)
            }
            _ => format!("{value:.3e}"),
        }
    }
}

/// The numbers of a text; empty for a text that is not valid TOML.
pub fn data(text: &str) -> Vec<Datum> {
    let Ok(entries) = DeTable::parse(text) else { return Vec::new() };
    let top = entries.get_ref();
    let mut data = Vec::new();
    let is_model = top.contains_key("coordinates");
    for (key, value) in ordered(top) {
        let is_start = key == "start";
        let is_shown = match is_model {
            true => matches!(key, "parameters" | "start"),
            false => !matches!(key, "run" | "ensemble" | "failure" | "title" | "description"),
        };
        match value.get_ref() {
            DeValue::Table(table) if is_shown => {
                let inside = ordered(table)
                    .into_iter()
                    .filter_map(|(name, value)| datum(&format!("{}.{}", dotted(key), dotted(name)), value, is_start));
                data.extend(inside);
            }
            _ if is_shown && !is_model => data.extend(datum(&dotted(key), value, false)),
            _ => {}
        }
    }
    if is_model {
        data.extend(left_out(top));
    }
    data
}

/// The entries of a table in the order of the file.
fn ordered<'a>(table: &'a DeTable<'a>) -> Vec<(&'a str, &'a Spanned<DeValue<'a>>)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries.into_iter().map(|(key, value)| (key.get_ref().as_ref(), value)).collect()
}

/// A number with its unit; `None` for any other value.
fn datum(id: &str, value: &Spanned<DeValue<'_>>, is_start: bool) -> Option<Datum> {
    let text = match value.get_ref() {
        DeValue::String(text) => text.trim().to_owned(),
        DeValue::Float(number) => number.as_str().to_owned(),
        // integers elsewhere are counts
        DeValue::Integer(number) if number.radix() == 10 && id.starts_with("parameters.") => number.as_str().to_owned(),
        _ => return None,
    };
    let (before, quantity) = match text.strip_prefix(GUESS) {
        Some(rest) => (GUESS, rest.trim_start()),
        None => ("", text.as_str()),
    };
    let (number, unit) = quantity.split_once(char::is_whitespace).unwrap_or((quantity, ""));
    let number = number.replace('_', "").parse::<f64>().ok().filter(|number| number.is_finite())?;
    let unit = unit.trim();
    let plain = !unit.contains(['"', '\\']) && !unit.contains(char::is_control);
    let place = Place::Written(value.span());
    (parse_any(quantity).is_ok() && plain).then(|| Datum {
        id: id.to_owned(),
        number,
        unit: unit.to_owned(),
        before,
        place,
        is_start,
    })
}

/// Coordinates and speeds without an entry, which start at zero. There are none where constraints, an equilibrium or quasi-velocities may
/// change the start, since an entry would then be a further condition.
fn left_out(top: &DeTable<'_>) -> Vec<Datum> {
    let table = |key: &str| match top.get(key).map(Spanned::get_ref) {
        Some(DeValue::Table(table)) => Some(table),
        _ => None,
    };
    let moves =
        ["constraint", "contact", "speeds", "drive", "circuit", "regulator"].iter().any(|key| top.contains_key(*key));
    let start = table("start");
    if moves || start.is_some_and(|start| start.contains_key("equilibrium")) {
        return Vec::new();
    }
    let Some(coordinates) = table("coordinates") else { return Vec::new() };
    let mut data = Vec::new();
    for (name, unit) in ordered(coordinates) {
        let Some(unit) = unit.get_ref().as_str() else { continue };
        let speed = match unit {
            "1" => "1/s".to_owned(),
            one if one.chars().all(char::is_alphanumeric) => format!("{one}/s"),
            _ => continue,
        };
        let own = if unit == "1" { "" } else { unit };
        for (key, unit) in [(name.to_owned(), own.to_owned()), (format!("{name}'"), speed)] {
            if start.is_none_or(|start| !start.contains_key(key.as_str())) {
                let id = format!("start.{}", dotted(&key));
                let place = Place::LeftOut { key: dotted(&key) };
                data.push(Datum { id, number: 0.0, unit, before: "", place, is_start: true });
            }
        }
    }
    data
}

/// A key in the notation of TOML, quoted where necessary.
fn dotted(key: &str) -> String {
    let is_bare = |letter: char| letter.is_ascii_alphanumeric() || matches!(letter, '_' | '-');
    match !key.is_empty() && key.chars().all(is_bare) {
        true => key.to_owned(),
        false => toml::Value::from(key).to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> Vec<(String, f64, String)> {
        data(text).into_iter().map(|datum| (datum.id, datum.number, datum.unit)).collect()
    }

    fn row(id: &str, number: f64, unit: &str) -> (String, f64, String) {
        (id.to_owned(), number, unit.to_owned())
    }

    #[test]
    fn parameters_with_a_value_and_every_start_have_a_slider() {
        let text = "coordinates = { a = \"rad\" }\nparameters = { m = \"2 kg\", k = \"N/m\", n = 3 }\n[start]\na = \"guess 4e1 deg\"\n";
        let all = [
            row("parameters.m", 2.0, "kg"),
            row("parameters.n", 3.0, ""),
            row("start.a", 40.0, "deg"),
            row("start.\"a'\"", 0.0, "rad/s"),
        ];
        assert_eq!(shown(text), all);
        assert_eq!(data(text)[2].before, "guess ");
    }

    #[test]
    fn a_start_that_constraints_may_move_has_none_unless_it_is_written() {
        let text = "[coordinates]\nx = \"m\"\ny = \"m\"\n[start]\nx = \"1 m\"\n[[constraint]]\nzero = \"x - y\"\n";
        assert_eq!(shown(text), [row("start.x", 1.0, "m")]);
    }

    #[test]
    fn a_scene_with_a_motor_has_those_of_its_tables_and_none_for_counts_and_vectors() {
        let text = "title = \"7 kg\"\ngravity = \"9.81 m/s^2\"\n[carrier]\nmass = \"1.5 kg\"\ncentre = \"2 -1 60 mm\"\nbars = 8\n[run]\nspan = \"2 s\"\n";
        assert_eq!(shown(text), [row("gravity", 9.81, "m/s^2"), row("carrier.mass", 1.5, "kg")]);
        assert_eq!(shown("not TOML ="), []);
    }

    #[test]
    fn a_value_is_written_with_the_digits_of_a_step_of_its_slider() {
        let datum = |number: f64, unit: &str, is_start| Datum {
            id: String::new(),
            number,
            unit: unit.into(),
            before: "",
            place: Place::Written(0..0),
            is_start,
        };
        assert_eq!(datum(1.0, "kg", false).written(1.234_567), "1.235");
        assert_eq!(datum(0.0, "deg", true).written(-12.34), "-12");
        assert_eq!(datum(0.0, "m", true).written(-0.000_1), "0.00");
        assert_eq!(datum(2e-12, "F", false).written(1.234_567e-12), "1.235e-12");
        assert_eq!(datum(-3.0, "N", false).range(), [-6.0, -0.06]);
    }
}
