//! Parameters, coordinates, definitions, frames and points.

use super::order::Definition;
use super::value::Value;
use super::{Elaborator, MOST, Named, Sound, mismatch};
use crate::arena::Scalar;
use crate::expression::Form;
use crate::{
    Coordinate, Defined, Entry, Fault, Frame, FrameId, Input, InputSource, Moves, Parameter, Point, PointId, Text, Turn,
};
use symbolic::Dimension;

impl Elaborator<'_> {
    /// Reads parameters and coordinates, which depend on no other names.
    pub(super) fn letters(&mut self) {
        for entry in &self.source.parameters {
            let found = self.parameter(entry);
            let found = found.map_err(|fault| self.elsewhere(&entry.value, fault));
            let found = self.under("parameters", &entry.name, found);
            if let Some(parameter) = self.kept_as(&entry.name, found) {
                let dimension = parameter.dimension;
                self.model.parameters.push(parameter);
                let letter = self.scalar(Scalar::Parameter(self.model.parameters.len() - 1), Some(dimension));
                self.give(&entry.name, Named::Value(Value::Scalar(letter)));
            }
        }
        for entry in &self.source.coordinates {
            let found = self.unit(&entry.value, "a coordinate has a unit", "x = \"m\", theta = \"rad\"");
            let found = found.map_err(|fault| self.elsewhere(&entry.value, fault));
            let found = self.under("coordinates", &entry.name, found);
            let Some((dimension, unit)) = self.kept_as(&entry.name, found) else { continue };
            self.judge_unit(&entry.name.text, &entry.value, &unit);
            let (name, at) = (entry.name.text.clone(), entry.name.span());
            self.model.coordinates.push(Coordinate { name, dimension, unit, at });
            let letter = self.scalar(Scalar::Coordinate(self.model.coordinates.len() - 1), Some(dimension));
            self.give(&entry.name, Named::Value(Value::Scalar(letter)));
        }
        let counts = [
            ("coordinates", self.source.coordinates.len()),
            ("parameters", self.source.parameters.len()),
            ("speeds", self.source.speeds.len()),
            ("frames", self.source.frames.len()),
            ("points", self.source.points.len()),
            ("bodies", self.source.bodies.len()),
        ];
        for (kind, count) in counts.into_iter().filter(|(_, count)| *count > MOST) {
            let accepted = format!("at most {MOST} of each kind");
            self.faults.push(Fault::at(0..0, format!("{count} {kind}"), "too many", accepted));
        }
        let turns_freely = |entry: &Entry| entry.value.text.trim_end().ends_with(" free");
        if self.source.coordinates.is_empty() && !self.source.frames.iter().any(turns_freely) {
            let accepted = "[coordinates] names what moves: theta = \"rad\"; or a frame turns freely: F = \"N free\"";
            self.faults.push(Fault::at(0..0, "the system has no coordinates", "nothing moves", accepted));
        }
    }

    /// Replaces the fault of a text that is not a unit by a hint to the table where the text belongs.
    fn elsewhere(&self, text: &Text, fault: Box<Fault>) -> Box<Fault> {
        let accepted = if is_frame(&text.text) {
            "a frame stands under [frames]"
        } else if units::quantity::parse_any(&text.text).is_ok() {
            "a unit alone, \"rad\"; the value at time zero stands under [start]"
        } else if self.has_names(text) {
            "an expression stands under [definitions], a point under [points]"
        } else {
            return fault;
        };
        Box::new(Fault { accepted: accepted.to_owned(), ..*fault })
    }

    /// Returns whether a text is an expression that contains names of the system.
    fn has_names(&self, text: &Text) -> bool {
        let Ok(expression) = crate::expression::read(&text.text) else { return false };
        let source = self.source;
        let entries = [
            &source.parameters,
            &source.coordinates,
            &source.speeds,
            &source.definitions,
            &source.frames,
            &source.points,
        ];
        let known = |name: &String| {
            super::is_reserved(name) || entries.iter().any(|table| table.iter().any(|entry| entry.name.text == *name))
        };
        expression.parts.len() > 1
            && expression.parts.iter().any(|form| match form {
                Form::Name(name) | Form::Member { of: name, .. } => known(name),
                _ => false,
            })
    }

    fn unit(&self, text: &Text, what: &str, accepted: &str) -> Sound<(Dimension, String)> {
        let fault = |label: String| Box::new(Fault::at(text.span(), what, label, accepted));
        match units::Unit::parse(&text.text) {
            Ok(unit) if !text.text.trim().is_empty() => {
                Ok((unit.dimension().of_expressions(), coherent(unit, &text.text)))
            }
            Ok(_) => Err(fault("nothing stands here".to_owned())),
            Err(wrong) => Err(fault(wrong.to_string())),
        }
    }

    /// Warns about a unit in which no column of a run is given: units of coordinates and inputs only declare dimensions.
    fn judge_unit(&mut self, name: &str, written: &Text, coherent: &str) {
        let unit = written.text.trim();
        if unit == coherent {
            return;
        }
        let title = format!("`{name}` is computed and shown in {coherent}, not in {unit}");
        let accepted = format!("\"{coherent}\" here; numbers may have any unit: (20 {unit})");
        self.model.warnings.push(Fault::at(written.span(), title, "a unit names the dimension", accepted));
    }

    /// Reads a parameter: `"2 kg"` has a value, `"N/m"` or `"[1]"` has none.
    fn parameter(&self, Entry { name, value }: &Entry) -> Sound<Parameter> {
        let trimmed = value.text.trim();
        let bracketed = trimmed.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')).map(str::trim);
        let text = bracketed.unwrap_or(trimmed);
        let number = text.split_whitespace().next().map(units::quantity::finite).filter(|_| bracketed.is_none());
        let fault = |label: String| {
            let title = format!("the parameter `{}` cannot be read", name.text);
            Box::new(Fault::at(
                value.span(),
                title,
                label,
                "a number and its unit (\"2 kg\"), or a unit alone, which leaves it without a value (\"kg\"; of a number \"[1]\")",
            ))
        };
        let (dimension, value_in_si) = match number {
            Some(Ok(_)) => {
                let (si, dimension) = units::quantity::parse_any(text).map_err(|wrong| fault(wrong.to_string()))?;
                (dimension, Some(si))
            }
            Some(Err(wrong @ units::NoQuantity::NotFinite { .. })) => return Err(fault(wrong.to_string())),
            _ => {
                let unit = units::Unit::parse(text).map_err(|wrong| fault(wrong.to_string()))?;
                if text.is_empty() {
                    return Err(fault("nothing stands here".to_owned()));
                }
                (unit.dimension(), None)
            }
        };
        let number_ends = if value_in_si.is_some() { text.find(char::is_whitespace) } else { Some(0) };
        let unit = number_ends.map_or("", |end| text[end..].trim());
        let unit = units::Unit::parse(unit).map_or_else(|_| dimension.coherent(), |parsed| coherent(parsed, unit));
        let written = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let (dimension, at) = (dimension.of_expressions(), name.span());
        Ok(Parameter { name: name.text.clone(), dimension, unit, written, value: value_in_si, at })
    }

    /// Elaborates one definition, after those it depends on.
    pub(super) fn define(&mut self, definition: Definition) {
        match definition {
            Definition::Value(at) => {
                let entry = &self.source.definitions[at];
                let found = match is_frame(&entry.value.text) {
                    true => self.turned(entry).map(Value::Frame),
                    false => self.value(&entry.value),
                };
                let found = self.under("definitions", &entry.name, found);
                if let Some(value) = self.kept_as(&entry.name, found) {
                    self.keep_definition(&entry.name.text, value);
                    self.give(&entry.name, Named::Value(value));
                }
            }
            Definition::Frame(at) => {
                let entry = &self.source.frames[at];
                let found = self.turned(entry);
                let found = self.under("frames", &entry.name, found);
                if let Some(frame) = self.kept_as(&entry.name, found) {
                    self.give(&entry.name, Named::Value(Value::Frame(frame)));
                }
            }
            Definition::Input(at) => {
                let input = &self.source.inputs[at];
                let found = self.input(input);
                let found = self.beside(found, &input.value);
                if let Some(input_read) = self.kept_as(&input.name, found) {
                    let dimension = input_read.dimension;
                    self.model.inputs.push(input_read);
                    let letter = self.scalar(Scalar::Input(self.model.inputs.len() - 1), Some(dimension));
                    self.give(&input.name, Named::Value(Value::Scalar(letter)));
                }
            }
            Definition::Speed(at) => {
                let entry = &self.source.speeds[at];
                let found = self.quasi_velocity(entry);
                let found = self.under("speeds", &entry.name, found);
                if let Some(is) = self.kept_as(&entry.name, found) {
                    self.give(&entry.name, Named::Value(Value::Scalar(is)));
                }
            }
            Definition::Point(at) => {
                let entry = &self.source.points[at];
                let found = self.placed(entry);
                let found = self.under("points", &entry.name, found);
                if let Some(base) = self.kept_as(&entry.name, found) {
                    self.give(&entry.name, Named::Value(Value::Point { base, way: None }));
                }
            }
            Definition::Body(at) => {
                let body = &self.source.bodies[at];
                let found = self.moved(body);
                let found = self.beside(found, body.turns.iter().chain(&body.centre));
                if let Some(body_id) = self.kept_as(&body.name, found) {
                    self.give(&body.name, Named::Body(body_id));
                }
            }
        }
    }

    /// Stores a vector or a point for later queries.
    fn keep_definition(&mut self, name: &str, value: Value) {
        let defined = match value {
            Value::Vector(vector) => Defined::Vector(vector),
            Value::Point { base, way } => {
                let order = way.and_then(|way| self.orders.of(way.0)).unwrap_or(0);
                let moves = if order == 0 { Moves::ByCoordinates } else { Moves::BySpeeds };
                Defined::Point { base, way, moves }
            }
            Value::Scalar(_) | Value::Frame(_) => return,
        };
        self.model.definitions.push((name.to_owned(), defined));
    }

    /// Reads an input, such as `u = { unit = "N", value = "if(t < (2 s), Fmax, 0)" }`.
    fn input(&mut self, InputSource { name, unit: written, value }: &InputSource) -> Sound<Input> {
        let (dimension, unit) =
            self.unit(written, "an input has a unit", "u = { unit = \"N\", value = \"F*sin(w*t)\" }")?;
        self.judge_unit(&name.text, written, &unit);
        let what = format!("the input `{}`", name.text);
        let value = match value {
            Some(value) => Some(self.scalar_value(value, &what, Some(dimension))?),
            None => None,
        };
        Ok(Input { name: name.text.clone(), dimension, unit, value, at: name.span() })
    }

    fn placed(&mut self, entry: &Entry) -> Sound<PointId> {
        match self.value(&entry.value)? {
            Value::Point { base, way: Some(way) } => {
                self.model.points.push(Point { name: entry.name.text.clone(), base: Some((base, way)) });
                Ok(PointId(self.model.points.len() - 1))
            }
            Value::Point { base, way: None } => Ok(base),
            other => Err(mismatch(&entry.value.span(), &format!("`{}`", entry.name.text), "a point", &other)),
        }
    }

    /// Reads a frame, such as `N turned theta about z` or `A turned -lean about x`.
    fn turned(&mut self, entry: &Entry) -> Sound<FrameId> {
        let text = &entry.value;
        let wrong = |title: &str, label: &str| {
            Box::new(Fault::at(
                text.span(),
                title.to_owned(),
                label.to_owned(),
                "for example \"N turned theta about z\", or \"N free\"",
            ))
        };
        if let Some(parent) = text.text.trim_end().strip_suffix(" free") {
            let parent = self.frame(&text.slice(0..parent.len()))?;
            if let Some(angles) = self.source.angles.get(self.by_angles.len()) {
                return Ok(self.turned_by_angles(&entry.name, parent, angles));
            }
            let frame = self.new_frame(&entry.name.text, parent, Turn::Free { number: self.model.free.len() });
            self.model.free.push(frame);
            return Ok(frame);
        }
        let parsed = text
            .text
            .split_once(" turned ")
            .and_then(|(parent, rest)| Some((parent, rest, rest.rsplit_once(" about ")?)));
        let Some((parent, rest, (angle, axis))) = parsed else {
            return Err(wrong("a frame is `N turned ANGLE about z`, or `N free`", "this is neither"));
        };
        let angle_start = text.text.len() - rest.len();
        let parent = self.frame(&text.slice(0..parent.len()))?;
        let angle_text = text.slice(angle_start..angle_start + angle.len());
        let Some(axis) = ["x", "y", "z"].iter().position(|name| *name == axis.trim()) else {
            let title = format!("`{}` is not an axis of the frame's parent", axis.trim());
            return Err(wrong(&title, "x, y or z is accepted"));
        };
        let angle = self.scalar_value(&angle_text, "the angle of a turn", Some(Dimension::none()))?;
        self.judge_angle_text(&angle_text);
        Ok(self.new_frame(&entry.name.text, parent, Turn::About { axis, angle }))
    }

    pub(super) fn new_frame(&mut self, name: &str, parent: FrameId, turn: Turn) -> FrameId {
        self.model.frames.push(Frame { name: name.to_owned(), parent: Some((parent, turn)) });
        FrameId(self.model.frames.len() - 1)
    }
}

/// Returns the coherent SI unit in which values are given, in the notation of the file where that is coherent.
fn coherent(unit: units::Unit, text: &str) -> String {
    let ([times, per], dimension) = (unit.factors(), unit.dimension());
    match text.split_whitespace().collect::<Vec<_>>().join(" ") {
        own if times == per && !own.is_empty() => own,
        own if dimension.is_number() => (if own.is_empty() { "1" } else { "rad" }).to_owned(),
        _ => with_slash(&dimension.coherent()),
    }
}

/// Writes `kg s^-1` as `kg/s`. A unit with several negative powers, or without positive ones, is unchanged.
fn with_slash(unit: &str) -> String {
    let (below, above): (Vec<&str>, Vec<&str>) = unit.split(' ').partition(|power| power.contains("^-"));
    match below.as_slice() {
        [below] if !above.is_empty() => {
            let below = below.replace("^-1", "").replace("^-", "^");
            format!("{}/{below}", above.join(" "))
        }
        _ => unit.to_owned(),
    }
}

/// Returns whether the text of a definition is a frame.
fn is_frame(text: &str) -> bool {
    text.contains(" turned ") || text.trim_end().ends_with(" free")
}
