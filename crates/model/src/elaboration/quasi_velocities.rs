//! Quasi-velocities: names, dimensions and start values. Their independence is checked after the whole system is known.

use super::names::wrong_dimension;
use super::{Elaborator, Sound};
use crate::quasi_velocities::faults;
use crate::{Entry, Fault, Model, Output, QuasiVelocity, ScalarId, StartSpeed, Trace};
use symbolic::{Dimension, apart};

impl Elaborator<'_> {
    /// Adds a quasi-velocity such as `v = "velocity(G) . A.x"`.
    pub(super) fn quasi_velocity(&mut self, Entry { name, value }: &Entry) -> Sound<ScalarId> {
        let is = self.scalar_value(value, &format!("the quasi-velocity `{}`", name.text), None)?;
        let dimension = self.dimension_of(is.0).unwrap_or_else(Dimension::none);
        self.model.quasi_velocities.push(QuasiVelocity { name: name.text.clone(), is, dimension, at: name.span() });
        Ok(is)
    }

    /// Returns the index of the quasi-velocity with this name.
    pub(super) fn quasi_velocity_of(&self, name: &str) -> Option<usize> {
        self.model.quasi_velocities.iter().position(|speed| speed.name == name)
    }

    /// Returns whether a fault in the definition of a quasi-velocity is known.
    pub(super) fn is_faulty(&self, name: &str) -> bool {
        let definition = self.source.speeds.iter().find(|entry| entry.name.text == name);
        definition.is_some_and(|Entry { name, value }| {
            let own = [name.span(), value.span()];
            self.faults
                .iter()
                .any(|fault| own.iter().any(|own| fault.span.start < own.end && own.start < fault.span.end))
        })
    }

    /// Adds every quasi-velocity to the outputs.
    pub(super) fn show_quasi_velocities(&mut self) {
        let shown =
            |speed: &QuasiVelocity| Output { name: speed.name.clone(), is: speed.is, dimension: speed.dimension };
        let shown: Vec<Output> = self.model.quasi_velocities.iter().map(shown).collect();
        self.model.outputs.extend(shown);
    }

    /// Reads the start value of a quasi-velocity, such as `v = "1 m/s"` under `[start]`.
    pub(super) fn start_speed(&mut self, of: usize, Entry { name, value }: &Entry) -> Sound<StartSpeed> {
        if self.model.start_speeds.iter().any(|known| known.of == of) {
            let title = format!("`{}` starts twice", name.text);
            return Err(Box::new(Fault::at(name.span(), title, "again", "one value")));
        }
        let needed = self.model.quasi_velocities[of].dimension;
        let unit = self.model.quasi_velocities[of].unit();
        let fault = |label: String| {
            let title = format!("the start of the quasi-velocity `{}` cannot be read", name.text);
            let accepted = format!(
                "a number with a unit of the dimension {needed}, such as \"0.3{}\"; guesses are of coordinates and their rates",
                if unit == "1" { String::new() } else { format!(" {unit}") }
            );
            Box::new(Fault::at(value.span(), title, label, accepted))
        };
        if value.text.trim_start().starts_with("guess ") {
            return Err(fault("a guess".to_owned()));
        }
        let (si, found) = units::quantity::parse_any(&value.text).map_err(|wrong| fault(wrong.to_string()))?;
        let found = found.of_expressions();
        if found != needed {
            return Err(fault(wrong_dimension(&value.text, found)));
        }
        Ok(StartSpeed { of, value: si, at: value.span() })
    }

    /// Checks that the quasi-velocities determine all speeds, unless there are other faults.
    pub(super) fn quasi_velocities(&mut self) {
        if !self.faults.is_empty() || !self.headless.is_empty() || self.model.quasi_velocities.is_empty() {
            return;
        }
        let model = &self.model;
        let (found, may_heal) = apart(|| faults(&Trace::of(model)));
        if may_heal {
            self.model.unsettled = found;
        } else {
            self.faults.extend(found);
        }
    }
}

impl Model {
    /// Repeats the check of the quasi-velocities after redundant constraints were removed.
    pub fn settle(&mut self) {
        if !self.unsettled.is_empty() {
            self.unsettled = apart(|| faults(&Trace::of(self)).0);
        }
    }
}
