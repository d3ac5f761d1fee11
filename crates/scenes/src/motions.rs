//! Prescribed motions for inverse dynamics: coordinates, free frames and currents as expressions of the time.

use crate::scene::model;
use crate::system_text::SystemText;
use crate::warnings::warn_of;
use model::{Coordinate, Entry, Fault, Model, ScalarId, Text, bare_angle};
use reader::{Issue, SceneError, tables};
use std::ops::Range;
use std::path::Path;
use symbolic::Dimension;

/// A prescribed motion; its values are expressions of the time.
#[derive(Clone, Debug, PartialEq)]
pub enum PrescribedMotion {
    /// The coordinate of index `place` is equal to `is`.
    Coordinate { place: usize, is: ScalarId },
    /// The free frame of index `frame` turns in its parent by successive rotations; each is an axis (0 to 2 for x, y, z) of the frame as turned
    /// so far, and an angle in radians.
    Turns { frame: usize, turns: Vec<(usize, ScalarId)> },
    /// A current is prescribed: the model's output of index `output` is the prescription minus the current, in amperes, and must vanish.
    Speed { output: usize },
}

/// A prescribed motion whose expressions are still text.
enum Written<'a> {
    Coordinate { place: usize, is: &'a str },
    Turns { frame: usize, turns: Vec<(usize, &'a str)> },
    Speed { is: &'a str },
}

const TURNS: &str = "turns one after the other: F = 0.3*sin(t*(2 rad/s)) about x, then (10 deg) about z";

/// Reads the system of a file together with prescribed motions. Each motion is the name of a coordinate, free frame or current, and an
/// expression of the time `t` in the language of the file.
///
/// # Errors
/// The issues of the file, or of the motions if one names no such quantity or its expression is not accepted.
pub fn read_prescribed(
    path: &Path,
    motions: &[(String, String)],
) -> Result<(Model, Vec<PrescribedMotion>), SceneError> {
    parse_prescribed(&SystemText::read(path)?, motions, &[], "--motion")
}

/// The model of a system's text, with its values, together with prescribed motions. The motions must not contain the names in `sought`
/// (unknown parameters and inputs). `called` is the name by which messages refer to the motions, such as `--motion`.
///
/// # Errors
/// The issues of the text, or of the motions if one names no such quantity or its expression is not accepted.
pub fn parse_prescribed(
    system: &SystemText,
    motions: &[(String, String)],
    sought: &[String],
    called: &str,
) -> Result<(Model, Vec<PrescribedMotion>), SceneError> {
    let SystemText { name: file, text, .. } = system;
    let behind = text.len();
    let options = Options::of(motions);
    let mut wrong: Vec<Issue> = Vec::new();
    let read = tables(file, text, |top, issues| {
        top.known(&["title", "description", "known_as", "run", "ensemble", "failure"]);
        let (own, mut source) = model(top, issues)?;
        let mut all: Vec<Written<'_>> = Vec::new();
        for (place, (name, is)) in motions.iter().enumerate() {
            let is_again = motions[..place].iter().any(|(known, _)| known == name);
            let unknown = sought.iter().find(|unknown| words(is).any(|word| word == unknown.as_str()));
            let found = match unknown {
                _ if is_again => Err(("it is prescribed twice", known(&own))),
                Some(unknown) => Err((
                    "it depends on a quantity that is sought",
                    format!("an expression of t and of parameters other than `{unknown}`"),
                )),
                None => written(&own, name, is),
            };
            match found {
                Ok(motion) => all.push(motion),
                Err((label, accepted)) => {
                    let title = format!("the motion of `{name}` is not accepted");
                    wrong.push(Issue::at(options.line(place), title, label).accepted(accepted));
                }
            }
        }
        if all.len() < motions.len() {
            return None;
        }
        let mut expression = |place: usize, part: &str, is: String| {
            let at = behind + options.expressions[place] + options.within(place, part);
            let name = Text::at(format!("motion {}", source.outputs.len()), behind);
            source.outputs.push(Entry { name, value: Text::at(is, at) });
        };
        for (place, ((name, _), motion)) in motions.iter().zip(&all).enumerate() {
            // the added zero gives the sum the dimension of the prescribed quantity, and other dimensions are refused
            match motion {
                Written::Coordinate { is, .. } => expression(place, is, format!("{is} + ({name} - {name})")),
                Written::Turns { turns, .. } => {
                    turns.iter().for_each(|(_, is)| expression(place, is, format!("{is} + (1 - 1)")));
                }
                Written::Speed { is } => expression(place, is, format!("{is} - {name}")),
            }
        }
        let told = |fault: Fault| {
            let within = |end: usize| options.text.len().min(end.saturating_sub(behind));
            let place = within(fault.span.start)..within(fault.span.end);
            let title = format!("a prescribed motion: {}", fault.title);
            let motion = options.expressions.iter().position(|start| *start == place.start);
            let dimensions =
                fault.label.strip_suffix(" on the right").and_then(|both| both.split_once(" on the left, "));
            // the prescribed quantity was added behind the expression of a coordinate or current
            match (motion, dimensions) {
                (Some(motion), Some((found, needed)))
                    if fault.span.end > behind + place.start + motions[motion].1.len() =>
                {
                    let (name, is) = &motions[motion];
                    let label = format!("`{name}` has the dimension {needed}, `{is}` the dimension {found}");
                    let accepted =
                        "an expression of this dimension; a number with a unit stands in parentheses: (20 mm)";
                    Issue::at(place, title, label).accepted(accepted)
                }
                _ => Issue::at(place, title, fault.label).accepted(fault.accepted),
            }
        };
        warn_of(file, text, &own.warnings);
        let model = Model::of(&source).map_err(|faults| wrong.extend(faults.into_iter().map(told))).ok()?;
        let place = |at: Range<usize>| at.start.saturating_sub(behind)..at.end.saturating_sub(behind);
        let of_motions = model.warnings.iter().filter(|warning| warning.span.start >= behind);
        let mut bare: Vec<Fault> =
            of_motions.map(|warning| Fault { span: place(warning.span.clone()), ..warning.clone() }).collect();
        for (place, motion) in all.iter().enumerate() {
            let Written::Turns { turns, .. } = motion else { continue };
            bare.extend(turns.iter().filter_map(|(_, is)| {
                let start = options.expressions[place] + options.within(place, is);
                bare_angle(start..start + is.len(), is, "({} deg)")
            }));
        }
        warn_of(called, &options.text, &bare);
        let mut expressions = model.outputs.iter().enumerate().skip(own.outputs.len());
        let mut next = || expressions.next().map(|(place, output)| (place, output.is));
        let mut prescribed = Vec::with_capacity(all.len());
        for motion in all {
            prescribed.push(match motion {
                Written::Coordinate { place, .. } => PrescribedMotion::Coordinate { place, is: next()?.1 },
                Written::Turns { frame, turns } => {
                    let turns = turns.into_iter().map(|(axis, _)| Some((axis, next()?.1)));
                    PrescribedMotion::Turns { frame, turns: turns.collect::<Option<_>>()? }
                }
                Written::Speed { .. } => PrescribedMotion::Speed { output: next()?.0 },
            });
        }
        Some((model, prescribed))
    });
    if !wrong.is_empty() {
        return Err(SceneError { path: called.to_owned(), text: options.text, issues: wrong });
    }
    let (model, prescribed) = read?;
    Ok((system.with_its_values(model)?, prescribed))
}

/// The motions as a text of one line each, to which messages refer.
struct Options<'a> {
    text: String,
    /// The first byte of each line; `expressions` has that of each expression.
    lines: Vec<usize>,
    expressions: Vec<usize>,
    motions: &'a [(String, String)],
}

impl<'a> Options<'a> {
    fn of(motions: &'a [(String, String)]) -> Self {
        let mut options = Options { text: String::new(), lines: Vec::new(), expressions: Vec::new(), motions };
        for (name, is) in motions {
            options.lines.push(options.text.len());
            options.text += &format!("{name} = ");
            options.expressions.push(options.text.len());
            options.text += &format!("{is}\n");
        }
        options
    }

    /// The range of bytes of a motion in the text.
    fn line(&self, place: usize) -> Range<usize> {
        let (name, is) = &self.motions[place];
        let start = self.lines[place];
        start..start + name.len() + " = ".len() + is.len()
    }

    /// The offset in bytes of `part` within a motion's expression.
    fn within(&self, place: usize, part: &str) -> usize {
        let whole = &self.motions[place].1;
        (part.as_ptr() as usize).checked_sub(whole.as_ptr() as usize).filter(|at| *at <= whole.len()).unwrap_or(0)
    }
}

/// Assigns an expression to the coordinate, current or free frame of this name; otherwise the fault, and the accepted names.
fn written<'a>(own: &Model, name: &str, is: &'a str) -> Result<Written<'a>, (&'static str, String)> {
    if let Some(place) = own.coordinates.iter().position(|one| one.name == name && is_own(one)) {
        return Ok(Written::Coordinate { place, is });
    }
    if currents(own).iter().any(|known| known == name) {
        return Ok(Written::Speed { is });
    }
    let Some(frame) = own.free.iter().position(|frame| own.frames[frame.0].name == name) else {
        return Err(("no coordinate has this name", known(own)));
    };
    let turn = |turn: &'a str| {
        let (angle, axis) = turn.rsplit_once(" about ")?;
        Some((["x", "y", "z"].iter().position(|known| *known == axis.trim())?, angle))
    };
    let turns: Option<Vec<(usize, &str)>> = is.split(", then ").map(turn).collect();
    turns.map(|turns| Written::Turns { frame, turns }).ok_or(("a free frame turns", TURNS.to_owned()))
}

/// Whether the coordinate is declared in the file; others are charges of windings, of which only the currents are known.
fn is_own(coordinate: &Coordinate) -> bool {
    !coordinate.name.contains('.')
}

/// The names of all currents that may be prescribed.
fn currents(own: &Model) -> Vec<String> {
    let of_charge = own.coordinates.iter().filter(|one| one.dimension == Dimension::current() * Dimension::time());
    let rates = of_charge.filter(|one| is_own(one)).map(|one| format!("{}'", one.name));
    let quasi = own.quasi_velocities.iter().filter(|one| one.dimension == Dimension::current());
    let of_drive = own.currents.iter().map(|(name, _)| name.clone());
    of_drive.chain(quasi.map(|one| one.name.clone())).chain(rates).collect()
}

/// The words of a text: maximal sequences of letters, digits and underscores.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_'))
}

/// The list of all quantities that may be prescribed, for messages.
fn known(own: &Model) -> String {
    let frames = own.free.iter().map(|frame| own.frames[frame.0].name.as_str());
    let coordinates = own.coordinates.iter().filter(|one| is_own(one)).map(|one| one.name.as_str());
    let names: Vec<&str> = coordinates.chain(frames).collect();
    let currents = match currents(own) {
        none if none.is_empty() => String::new(),
        some => format!("; of currents, where forces leave them open: {}", some.join(", ")),
    };
    format!("a motion for each of: {}{currents}", names.join(", "))
}
