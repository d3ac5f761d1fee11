//! The search for steady motions of a system that is written in its file, with the options that commands share.

use crate::arguments::finite;
use crate::clock::has_time;
use crate::exit::{Exit, placed, warn};
use crate::progress::Progress;
use ::scenes::steady_motions::{Along, Asked, Near, NoSteadyMotions, Range, SteadyMotions};
use ::scenes::{SystemText, Task, independent_start, parse_with_source, unit_of, without_law};
use clap::Args;
use clap::builder::RangedU64ValueParser;
use model::{FrameId, Model, Source};
use reader::{Issue, SceneError};
use std::path::Path;
use std::sync::Arc;
use units::nearest;

/// The options of a search for steady motions.
#[derive(Args, Debug)]
pub struct SteadyBox {
    /// The range or the value, in SI units, of a coordinate, or of the constant speed of a cyclic coordinate or of a quasi-velocity, in a
    /// system that is written in its file. The default for angles is the whole circle
    #[arg(long, value_name = "NAME=FROM..TO", value_parser = named_range, num_args = 1)]
    pub range: Vec<(String, Range)>,
    /// The largest number of boxes in the search, for a system that is written in its file
    #[arg(long, value_name = "N", default_value_t = 200_000, allow_negative_numbers = true, value_parser = RangedU64ValueParser::<usize>::new().range(1..=1_000_000_000))]
    pub boxes: usize,
}

/// Reads a name with its range.
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
        return Err(format!("{from} is not below {to}; a range that rises is accepted"));
    }
    Ok((name.trim().to_owned(), Range { from, to }))
}

/// A system with its steady motions.
pub struct Found {
    pub title: String,
    pub model: Model,
    pub motions: SteadyMotions,
}

/// Steady motions along a parameter.
pub struct AlongFound {
    pub title: String,
    pub name: String,
    /// The unit of the parameter, with a space before it.
    pub unit: String,
    /// The units of the unknowns.
    pub units: Vec<String>,
    pub along: Along,
}

/// Reads the system of a file, prepared for the search, with its source.
pub fn system_in(path: &Path) -> Result<SoughtSystem, Exit> {
    Ok(sought(&SystemText::read(path)?)?)
}

/// The title, the model and the source of a system.
pub type SoughtSystem = (String, Model, Source);

/// Reads the system of a text, prepared for the search.
pub(super) fn sought(text: &SystemText) -> Result<SoughtSystem, SceneError> {
    let (title, model, source) = parse_with_source(&text.name, &text.text, Task::Vary)?;
    let mut model = text.with_its_values(model)?;
    model.close_inputs();
    // redundant constraints are removed, since their reactions are not unique; the search needs no start
    let _ = independent_start(&mut model);
    Ok((title, model, source))
}

/// The unit of a quantity, with a space before it.
pub fn unit(model: &Model, name: &str) -> String {
    match unit_of(model, name).as_str() {
        "1" => String::new(),
        unit => format!(" {unit}"),
    }
}

impl SteadyBox {
    /// All steady motions of the system that was read from a file.
    pub fn find(&self, path: &Path, (title, model, _): SoughtSystem) -> Result<Found, Exit> {
        self.checked()?;
        let _progress = Progress::new("steady motions");
        let motions = SteadyMotions::of(&model, &self.wanted(), has_time).map_err(|why| refused(path, &model, why))?;
        Ok(Found { title, model, motions })
    }

    /// All steady motions of the system in a file at values of a parameter, or of the speed of a cyclic coordinate.
    pub fn find_along(&self, path: &Path, (name, range): &(String, Range), values: usize) -> Result<AlongFound, Exit> {
        let (title, model, asked) = self.along(path, &[name])?;
        let _progress = Progress::new("steady motions");
        let along = Along::of(&model, &asked, (name, *range), values, has_time);
        let along = along.map_err(|why| refused(path, &model, why))?;
        let unit = unit(&model, name);
        let units = along.samples.first().map_or_else(Vec::new, |sample| {
            sample.found.unknowns.iter().map(|unknown| self::unit(&model, &unknown.name)).collect()
        });
        Ok(AlongFound { title, name: name.clone(), unit, units, along })
    }

    /// The system of a file, prepared to take other values for parameters or speeds of cyclic coordinates with these names.
    pub fn along(&self, path: &Path, names: &[&String]) -> Result<(String, Model, Asked), Exit> {
        self.checked()?;
        let (title, model, source) = system_in(path)?;
        names.iter().try_for_each(|name| self.must_vary(path, &model, name))?;
        Ok((title, model, Asked { text: Some(Arc::new(source)), ..self.wanted() }))
    }

    fn must_vary(&self, path: &Path, model: &Model, name: &String) -> Result<(), Exit> {
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
                "--along {name}: {}: no parameter is called so, nor the speed of a coordinate{}",
                path.display(),
                nearest.map_or_else(String::new, |nearest| format!("; is `{nearest}` meant?"))
            )));
        }
        Ok(())
    }

    /// Refuses a name with two ranges.
    pub(super) fn checked(&self) -> Result<(), Exit> {
        let names = self.range.iter().map(|(name, _)| name).enumerate();
        match names.clone().find(|(place, name)| self.range[..*place].iter().any(|(before, _)| before == *name)) {
            None => Ok(()),
            Some((_, name)) => Err(Exit::refused(format!("--range {name} is given twice; one range is accepted"))),
        }
    }

    pub fn wanted(&self) -> Asked {
        Asked { ranges: self.range.clone(), boxes: self.boxes, ..Asked::default() }
    }

    /// Prints warnings on undecided regions, with a remedy; returns the outcome of the command.
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
                "warning: {path}: undecided boxes: {boxes}, about {}, by numbers: more boxes would not decide them",
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

    /// Refuses a range for a scene that has no system in its file.
    pub fn refuse(&self, instead: &str) -> Result<(), Exit> {
        match self.range.first() {
            None => Ok(()),
            Some((name, _)) => {
                Err(Exit::refused(format!("--range {name} is about a system that is written in its file; {instead}")))
            }
        }
    }
}

impl Found {
    /// The values of a motion's unknowns as text.
    pub fn values(&self, enclosure: &[[f64; 2]]) -> String {
        let values = self.motions.unknowns.iter().zip(enclosure).map(|(unknown, [low, high])| {
            format!("{} = {}{}", unknown.name, number(0.5 * (low + high)), self.unit(&unknown.name))
        });
        values.collect::<Vec<_>>().join(", ")
    }

    /// The unit of a component of the state, with a space before it.
    pub fn unit(&self, name: &str) -> String {
        unit(&self.model, name)
    }
}

pub fn refused(path: &Path, model: &Model, why: NoSteadyMotions) -> Exit {
    unsought(path, reason(model, why))
}

/// The error for a fault of the system, at its place in the file, or of the command's options.
pub(super) fn unsought(path: &Path, issue: Issue) -> Exit {
    match issue.span {
        Some(_) => placed(path, issue),
        None => Exit::refused(format!("{}: {}", path.display(), issue.title)),
    }
}

/// The reason for which steady motions are not searched for, with its place in the text where it has one.
pub(super) fn reason(model: &Model, why: NoSteadyMotions) -> Issue {
    let told = |why: String| Issue { span: None, title: why, label: String::new(), help: None };
    let listed = |names: &[String]| names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    match why {
        NoSteadyMotions::NotCompiled(reason) => {
            without_law(model, &reason, "steady motions cannot be sought")
        }
        NoSteadyMotions::OfSpeeds { at } => {
            let issue = Issue::at(at, "steady motions are not sought with this constraint", "it holds speeds, or is led to zero");
            issue.accepted("constraints of positions, and up to six that are linear in the speeds, quasi-velocities among them; `linearise --about equilibrium` finds one equilibrium near the start")
        }
        NoSteadyMotions::Changes => told(
            "some of its speeds have no inertia, and equations of their own determine them: steady motions are not sought there; \
             `linearise --about equilibrium` finds one equilibrium near the start"
                .to_owned(),
        ),
        NoSteadyMotions::Contacts { at } => {
            let issue = Issue::at(at, "steady motions are not sought with this contact", "a diode, a freewheel, a guide that the coordinates keep, or a contact that slides in two directions or on two sides");
            issue.accepted("contacts that coordinates can open, and friction as a force with `sign` of a speed; `linearise --about equilibrium` finds one equilibrium near the start")
        }
        NoSteadyMotions::ManyConditions { conditions, most } => told(format!(
            "its law has {conditions} conditions, which have more than {most} combinations of cases; fewer conditions are accepted"
        )),
        NoSteadyMotions::FreeFrame { why } => told(format!(
            "a frame turns freely, and steady motions are not sought here: {why}; a frame with an axis, or with three angles, is accepted"
        )),
        NoSteadyMotions::OfTime => {
            told("its forces or constraints depend on time: no motion is steady; without time in them they are sought".to_owned())
        }
        NoSteadyMotions::Singular => told("nothing with a mass or an inertia moves with a coordinate".to_owned()),
        NoSteadyMotions::Undefined { why } => told(format!("its equations have no values: {why}")),
        NoSteadyMotions::Unknown { name, accepted, .. } if accepted.contains(&format!("{name}'")) => told(format!(
            "--range {name}: `{name}` is cyclic: no equation depends on it, so that it may have any value; its speed `{name}'` may have a range"
        )),
        NoSteadyMotions::Unknown { name, nearest: Some(nearest), .. } => {
            told(format!("--range {name}: nothing that is sought is called `{name}`; is `{nearest}` meant?"))
        }
        NoSteadyMotions::Unknown { name, accepted, .. } => {
            told(format!("--range {name}: nothing that is sought is called `{name}`; there are: {}", accepted.join(", ")))
        }
        NoSteadyMotions::Sought { name, value } => {
            let aside = 0.01 * if value == 0.0 { 1.0 } else { value.abs() };
            told(format!(
                "one value of `{name}`, {}, is not accepted: an equation asks for its value, which a number meets to rounding alone; a range is \
                 accepted (--range \"{name}={}..{}\"), and --along over a parameter",
                number(value),
                number(value - aside),
                number(value + aside)
            ))
        }
        NoSteadyMotions::WithoutRange { names } => {
            let options: Vec<String> =
                names.iter().map(|name| format!("--range \"{name}=-1..1\"")).collect();
            told(format!(
                "{} {} no angle of a circle alone: ranges in SI units are needed, such as {}",
                listed(&names),
                if names.len() == 1 { "is" } else { "are" },
                options.join(" ")
            ))
        }
        NoSteadyMotions::Unequal { counts: [equations, unknowns], idle } => told(format!(
            "its equations, {equations}, are more than its unknowns, {unknowns}: there is no steady motion, but by chance; a value for {} \
             (--range NAME=VALUE) chooses among them",
            listed(&idle)
        )),
    }
}

/// A number with ten digits, without trailing zeros.
pub fn number(value: f64) -> String {
    let value = if value.abs() < 5e-16 { 0.0 } else { value };
    match value.abs() {
        size if size == 0.0 || (1e-4..1e7).contains(&size) => {
            let places = if size == 0.0 { 0 } else { (9 - size.log10().floor() as i32).max(0) as usize };
            let fixed = format!("{value:.places$}");
            if fixed.contains('.') { fixed.trim_end_matches('0').trim_end_matches('.').to_owned() } else { fixed }
        }
        _ => format!("{value:.9e}"),
    }
}
