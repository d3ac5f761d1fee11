//! The search for steady motions of a system that is defined in its file, with the options that several commands share.

use super::refusals::{reason, refused};
use crate::arguments::finite;
use crate::clock::has_time;
use crate::exit::{Exit, warn};
use crate::named_value::named_value;
use crate::progress::Progress;
use ::scenes::steady_motions::{Along, Near, NoSteadyMotions, Range, SteadyMotions, SteadySearch};
use ::scenes::{SystemText, Task, independent_start, parse_with_source, unit_of};
use clap::builder::RangedU64ValueParser;
use model::{FrameId, Model, Source};
use reader::SceneError;
use std::path::Path;
use std::sync::Arc;
use units::nearest;

/// The options of a search for steady motions.
#[derive(clap::Args, Debug)]
pub struct SteadyBox {
    /// The range or the value, in SI units, of a coordinate, or of the constant speed of a cyclic coordinate or of a quasi-velocity, in a
    /// system described in its file. The default for angles is the whole circle
    #[arg(long, value_name = "NAME=FROM..TO", value_parser = named_range, num_args = 1)]
    pub range: Vec<(String, Range)>,
    /// The largest number of boxes in the search, for a system described in its file; with contacts or conditions, for each combination of
    /// their cases
    #[arg(long, value_name = "N", default_value_t = 200_000, allow_negative_numbers = true, value_parser = RangedU64ValueParser::<usize>::new().range(1..=1_000_000_000))]
    pub boxes: usize,
    /// Another value, in SI units, for a parameter, or for a coordinate or a speed at the start, in a system described in its file; may be
    /// repeated
    #[arg(id = "set", long = "set", value_name = "NAME=VALUE", value_parser = named_value)]
    pub values: Vec<(String, f64)>,
}

/// Parses a name with a range or a value.
///
/// # Errors
/// The text has another form, or the range descends.
pub fn named_range(text: &str) -> Result<(String, Range), String> {
    let accepted = || {
        "a coordinate with its range in SI units, such as x=-0.1..0.1, or with one value, x=0.1, is accepted".to_owned()
    };
    let (name, range) = text.split_once('=').ok_or_else(accepted)?;
    let number = |text: &str| {
        finite(text).map_err(|_| {
            format!(
                "`{}` is no number; numbers in SI units, without the unit, are accepted: {name}=-0.1..0.1",
                text.trim()
            )
        })
    };
    let (from, to) = match range.split_once("..") {
        Some((from, to)) => (number(from)?, number(to)?),
        None => (number(range)?, number(range)?),
    };
    if from > to {
        return Err(format!("{from} is not below {to}; FROM must be below TO"));
    }
    Ok((name.trim().to_owned(), Range { from, to }))
}

/// A system with the steady motions that a search found.
pub struct Found {
    pub title: String,
    pub model: Model,
    pub motions: SteadyMotions,
}

/// The steady motions of a system along a parameter.
pub struct AlongFound {
    pub title: String,
    pub name: String,
    /// The unit of the parameter, preceded by a space; empty for a pure number.
    pub unit: String,
    /// The units of the unknowns, each preceded by a space.
    pub units: Vec<String>,
    pub along: Along,
    /// Values at which steady motions are not searched for, with the reasons.
    pub left_out: Vec<(f64, String)>,
}

/// The title, the model and the source of a system.
pub type SoughtSystem = (String, Model, Source);

/// Reads the system of a text and prepares it for the search.
///
/// # Errors
/// All faults of the text and of its replaced values.
pub fn sought(text: &SystemText) -> Result<SoughtSystem, SceneError> {
    let (title, model, source) = parse_with_source(&text.name, &text.text, Task::Vary)?;
    let mut model = text.with_its_values(model)?;
    model.close_inputs();
    // redundant constraints are removed, since their reactions are not unique; an error is ignored, since the search needs no start
    let _ = independent_start(&mut model);
    Ok((title, model, source))
}

/// The unit of a quantity, preceded by a space; empty for a pure number.
pub fn unit(model: &Model, name: &str) -> String {
    match unit_of(model, name).as_str() {
        "1" => String::new(),
        unit => format!(" {unit}"),
    }
}

impl SteadyBox {
    /// Reads the system of a file and prepares it for the search.
    ///
    /// # Errors
    /// All faults of the file and of the values of `--set`.
    pub fn system_in(&self, path: &Path) -> Result<SoughtSystem, Exit> {
        Ok(sought(&SystemText { values: self.values.clone(), ..SystemText::read(path)? })?)
    }

    /// All steady motions of a system that was read from a file.
    ///
    /// # Errors
    /// A name has two ranges or values, or steady motions of the system are not searched for; the message states the reason.
    pub fn find(&self, path: &Path, (title, model, source): SoughtSystem) -> Result<Found, Exit> {
        self.checked()?;
        let _progress = Progress::new("steady motions");
        let motions = SteadyMotions::of(&model, &self.wanted(), has_time);
        let motions = motions.map_err(|why| refused(path, (&model, Some(&source)), why))?;
        Ok(Found { title, model, motions })
    }

    /// All steady motions of the system in a file, at values of a parameter or of the speed of a cyclic coordinate.
    ///
    /// # Errors
    /// Those of [`SteadyBox::along`], or steady motions of the system are not searched for.
    pub fn find_along(&self, path: &Path, (name, range): &(String, Range), values: usize) -> Result<AlongFound, Exit> {
        let (title, model, asked) = self.along(path, &[name])?;
        let _progress = Progress::new("steady motions");
        let along = Along::of(&model, &asked, (name, *range), values, has_time);
        let along = along.map_err(|why| refused(path, (&model, asked.text.as_deref()), why))?;
        let unit = unit(&model, name);
        let units = along.samples.first().map_or_else(Vec::new, |sample| {
            sample.found.unknowns.iter().map(|unknown| self::unit(&model, &unknown.name)).collect()
        });
        let why = |why: &NoSteadyMotions| {
            // the value is printed next to the reason
            let own = if let NoSteadyMotions::At { why, .. } = why { why } else { why };
            reason(&model, asked.text.as_deref(), own.clone()).title
        };
        let left_out = along.left_out.iter().map(|(value, own)| (*value, why(own))).collect();
        Ok(AlongFound { title, name: name.clone(), unit, units, along, left_out })
    }

    /// The system of a file, prepared such that parameters or speeds of cyclic coordinates with these names can be varied.
    ///
    /// # Errors
    /// The file has a fault, or a name cannot be varied.
    pub fn along(&self, path: &Path, names: &[&String]) -> Result<(String, Model, SteadySearch), Exit> {
        self.checked()?;
        let (title, model, source) = self.system_in(path)?;
        names.iter().try_for_each(|name| self.must_vary(path, &model, name))?;
        Ok((title, model, SteadySearch { text: Some(Arc::new(source)), ..self.wanted() }))
    }

    fn must_vary(&self, path: &Path, model: &Model, name: &String) -> Result<(), Exit> {
        if self.values.iter().any(|(own, _)| own == name) {
            return Err(Exit::refused(format!(
                "--set {name}: --along goes over values of `{name}`; leave one of the two out"
            )));
        }
        if self.range.iter().any(|(own, _)| own == name) {
            return Err(Exit::refused(format!(
                "--range {name}: --along goes over values of `{name}`; leave one of the two out"
            )));
        }
        let states: Vec<String> = model.state_names().into_iter().map(|(name, _)| name).collect();
        let (coordinates, speeds) = states.split_at(model.positions());
        let is_of_frame = |frame: &FrameId| {
            let rest = name.strip_prefix(model.frames[frame.0].name.as_str());
            matches!(rest, Some(".precession'" | ".yaw'" | ".spin'"))
        };
        if model.free.iter().any(is_of_frame) {
            return Ok(());
        }
        if coordinates.contains(name) {
            return Err(Exit::refused(format!(
                "--along {name}: {}: `{name}` is a coordinate; a parameter, or the speed of a cyclic coordinate, is accepted",
                path.display()
            )));
        }
        let known: Vec<&str> = model
            .parameters
            .iter()
            .map(|parameter| parameter.name.as_str())
            .chain(speeds.iter().map(String::as_str))
            .chain(model.quasi_velocities.iter().map(|speed| speed.name.as_str()))
            .collect();
        if !known.contains(&name.as_str()) && !name.starts_with("velocity(") {
            let nearest = nearest(name, known.iter().copied());
            return Err(Exit::refused(format!(
                "--along {name}: {}: no parameter and no speed is called `{name}`{}; there are: {}",
                path.display(),
                nearest.map_or_else(String::new, |nearest| format!("; is `{nearest}` meant?")),
                known.join(", ")
            )));
        }
        Ok(())
    }

    /// Refuses a name with two ranges or two values.
    pub(super) fn checked(&self) -> Result<(), Exit> {
        let set = |place: usize| self.values[..place].iter().any(|(before, _)| *before == self.values[place].0);
        if let Some(place) = (0..self.values.len()).find(|&place| set(place)) {
            return Err(Exit::refused(format!("--set {} is given twice; one value is accepted", self.values[place].0)));
        }
        let names = self.range.iter().map(|(name, _)| name).enumerate();
        match names.clone().find(|(place, name)| self.range[..*place].iter().any(|(before, _)| before == *name)) {
            None => Ok(()),
            Some((_, name)) => Err(Exit::refused(format!("--range {name} is given twice; one range is accepted"))),
        }
    }

    pub fn wanted(&self) -> SteadySearch {
        SteadySearch { ranges: self.range.clone(), boxes: self.boxes, ..SteadySearch::default() }
    }

    /// Prints warnings about undecided regions, with a remedy; returns the outcome of the command.
    pub fn ended(&self, path: &Path, found: &SteadyMotions) -> Exit {
        if found.is_complete() {
            return Exit::Done;
        }
        if found
            .regions
            .iter()
            .all(|region| matches!(region.near, Near::Merging(_) | Near::Undefined | Near::Dependent))
        {
            let (path, boxes) = (path.display(), found.undecided.len());
            let has = |near: fn(&Near) -> bool| found.regions.iter().any(|region| near(&region.near));
            let about = [
                (has(|near| *near == Near::Undefined), "places where the equations have no values"),
                (has(|near| *near == Near::Dependent), "places where constraints become dependent"),
                (has(|near| matches!(near, Near::Merging(_))), "degenerate steady motions"),
            ];
            let about: Vec<&str> = about.into_iter().filter(|(is_there, _)| *is_there).map(|(_, what)| what).collect();
            warn(&format!(
                "warning: {path}: undecided boxes: {boxes}; numerically they contain {}, which more boxes would not decide",
                about.join(", or ")
            ));
            return Exit::Stopped;
        }
        let remedy = match has_time() {
            true => format!("or more boxes (--boxes {}) may decide more", 10 * self.boxes),
            false => "or more time (--seconds) may decide more: the time was over".to_owned(),
        };
        warn(&format!(
            "warning: {}: undecided boxes: {}; narrower ranges (--range NAME=FROM..TO) {remedy}",
            path.display(),
            found.undecided.len()
        ));
        Exit::Stopped
    }

    /// Refuses --range and --set for a scene whose system is not defined in its file.
    pub fn refuse(&self, instead: &str) -> Result<(), Exit> {
        let ranges = self.range.iter().map(|(name, _)| ("--range", name));
        match ranges.chain(self.values.iter().map(|(name, _)| ("--set", name))).next() {
            None => Ok(()),
            Some((option, name)) => {
                Err(Exit::refused(format!("{option} {name} is about a system that is written in its file; {instead}")))
            }
        }
    }
}

impl Found {
    /// The values of the unknowns of a motion as text.
    pub fn values(&self, enclosure: &[[f64; 2]]) -> String {
        let values = self.motions.unknowns.iter().zip(enclosure).map(|(unknown, at)| {
            format!("{} = {}{}", unknown.name, enclosed(*at, unknown.range), self.unit(&unknown.name))
        });
        values.collect::<Vec<_>>().join(", ")
    }

    /// The unit of a component of the state, preceded by a space; empty for a pure number.
    pub fn unit(&self, name: &str) -> String {
        unit(&self.model, name)
    }
}

/// Values below this fraction of the range (at most of 1 SI unit) count as zero, since the rounding of data alone moves them.
const ROUNDING: f64 = 1e-14;

/// The value of an unknown as text, with as many digits as its enclosure determines, at most ten.
pub fn enclosed([low, high]: [f64; 2], range: Range) -> String {
    let middle = 0.5 * (low + high);
    let scale = range.from.abs().max(range.to.abs()).min(1.0);
    if low <= 0.0 && high >= 0.0 || middle.abs() <= ROUNDING * scale {
        return number(0.0);
    }
    let digits = (-((high - low) / middle.abs()).log10()).floor().clamp(1.0, 10.0) as usize;
    written(format!("{middle:.*e}", digits - 1).parse().unwrap_or(middle))
}

/// A number with ten significant digits, without trailing zeros.
pub fn number(value: f64) -> String {
    written(if value.abs() < 5e-16 { 0.0 } else { value })
}

fn written(value: f64) -> String {
    match value.abs() {
        size if size == 0.0 || (1e-4..1e7).contains(&size) => {
            let places = if size == 0.0 { 0 } else { (9 - size.log10().floor() as i32).max(0) as usize };
            let fixed = format!("{value:.places$}");
            if fixed.contains('.') { fixed.trim_end_matches('0').trim_end_matches('.').to_owned() } else { fixed }
        }
        _ => {
            let all = format!("{value:.9e}");
            let (digits, power) = all.split_once('e').unwrap_or((&all, "0"));
            format!("{}e{power}", digits.trim_end_matches('0').trim_end_matches('.'))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::enclosed;
    use ::scenes::steady_motions::Range;

    #[test]
    fn a_value_has_the_digits_that_its_enclosure_shows() {
        let range = Range { from: -1.0, to: 1.0 };
        assert_eq!(enclosed([-1e-12, 3e-12], range), "0");
        assert_eq!(enclosed([1.0e-15, 1.2e-15], range), "0");
        assert_eq!(enclosed([0.123_456_789_01, 0.123_456_789_01], range), "0.123456789");
        assert_eq!(enclosed([2.999, 3.001], Range { from: 1.0, to: 1e15 }), "3");
        assert_eq!(enclosed([1e-301, 1e-301], Range { from: -1e-300, to: 1e-300 }), "1e-301");
        assert_eq!(enclosed([0.123_45, 0.123_47], range), "0.123");
    }
}
