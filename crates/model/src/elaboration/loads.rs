//! Gravity, energies, constraints, outputs and the start. Forces and torques are in the module `forces`.

use super::names::wrong_dimension;
use super::one_sided_loads::Load;
use super::rates::accelerated;
use super::value::Value;
use super::{Elaborator, GRAVITY, Sound, mismatch};
use crate::parts::TURNING;
use crate::{
    Along, Constraint, ConstraintSource, Entry, Fault, GeneralisedForce, LoadSource, Output, ScalarId, StartValue,
    Text, Zero,
};
use field::Rational;
use symbolic::Dimension;

pub(super) fn newton() -> Dimension {
    Dimension::mass() * Dimension::length() / Dimension::time().power(Rational::new(2, 1))
}

pub(super) fn joule() -> Dimension {
    newton() * Dimension::length()
}

impl Elaborator<'_> {
    pub(super) fn loads(&mut self) {
        if let Some(gravity) = &self.source.gravity {
            let needed = Dimension::length() / Dimension::time().power(Rational::new(2, 1));
            let found = self.vector_value(gravity, GRAVITY, Some(needed));
            self.model.gravity = self.kept(found);
        }
        self.rotors();
        for energy in &self.source.energies {
            let found = self.energy(energy);
            let found = self.under("energies", &energy.name, found);
            self.kept(found);
        }
        self.windings();
        for force in &self.source.forces {
            if let Some(along) = &force.along {
                let found = self.generalised(along, force);
                let found = self.beside(found, [&force.is]);
                if let Some(generalised) = self.kept(found) {
                    self.loads.push((Load::Generalised(self.model.generalised.len()), force.is.span()));
                    self.model.generalised.push(generalised);
                }
                continue;
            }
            let found = self.force(force);
            let found = self.beside(found, [&force.is]);
            if let Some(found) = self.kept(found) {
                self.loads.push((Load::Force(self.model.forces.len()), force.is.span()));
                self.model.forces.push(found);
            }
        }
        for torque in &self.source.torques {
            let found = self.torque(torque);
            let found = self.beside(found, [&torque.is]);
            if let Some(found) = self.kept(found) {
                self.loads.push((Load::Torque(self.model.torques.len()), torque.is.span()));
                self.model.torques.push(found);
            }
        }
        let (torques, forces) = std::mem::take(&mut self.driving);
        for (torque, at) in torques {
            let place = self.model.torques.len();
            self.loads.extend(at.map(|at| (Load::Torque(place), at)));
            self.model.torques.push(torque);
        }
        self.model.generalised.extend(forces);
        for constraint in &self.source.constraints {
            let found = self.constraint(constraint);
            let found = self.beside(found, constraint.gains.iter().flatten().chain(&constraint.zero));
            self.kept(found);
        }
        for (place, contact) in self.source.contacts.iter().enumerate() {
            let found = self.contact(place, contact);
            if let Some(contact) = self.kept(found) {
                self.model.contacts.push(contact);
            }
        }
        for (number, one_way) in self.source.one_ways.iter().enumerate() {
            let found = self.one_way(self.source.contacts.len() + number, one_way);
            if let Some(contact) = self.kept(found) {
                self.model.contacts.push(contact);
            }
        }
        self.show_quasi_velocities();
        self.shows_loads = true;
        for output in &self.source.outputs {
            let found = self.output(output);
            let found = self.under("outputs", &output.name, found);
            self.kept(found);
        }
        self.shows_loads = false;
    }

    fn energy(&mut self, Entry { name, value }: &Entry) -> Sound<()> {
        let needed = match name.text.as_str() {
            "dissipation" => joule() / Dimension::time(),
            _ => joule(),
        };
        let what = super::rates::called(&name.text);
        let id = self.scalar_value(value, &what, None)?;
        // an energy of a wrong order has a wrong dimension too
        if let Some(fault) = accelerated(&name.text, self.orders.of(id.0), value.span()) {
            return Err(Box::new(fault));
        }
        self.must_measure(&value.span(), id.0, &what, Some(needed))?;
        let energies = &mut self.model.energies;
        match name.text.as_str() {
            "kinetic" => energies.kinetic = Some(id),
            "potential" => energies.potential = Some(id),
            "dissipation" => energies.dissipation = Some(id),
            "coenergy" => energies.coenergy = Some(id),
            other => {
                let accepted = "kinetic, potential, dissipation, coenergy";
                return Err(Box::new(Fault::at(
                    name.span(),
                    format!("no energy is called `{other}`"),
                    "not known",
                    accepted,
                )));
            }
        }
        Ok(())
    }

    /// Reads a generalised force such as `along = "theta"`; its unit is power per unit of the coordinate's rate.
    fn generalised(&mut self, along: &Text, load: &LoadSource) -> Sound<GeneralisedForce> {
        if load.on.is_some() || load.between.is_some() {
            let accepted = "along = \"theta\" alone: a generalised force acts on a coordinate, not at a place";
            return Err(Box::new(Fault::at(
                along.span(),
                "this force acts along a coordinate and at a place",
                "here",
                accepted,
            )));
        }
        let what = format!("the generalised force along `{}`", along.text);
        if let Some(of) = self.quasi_velocity_of(&along.text) {
            let needed = joule() / Dimension::time() / self.model.quasi_velocities[of].dimension;
            let is = self.scalar_value(&load.is, &what, Some(needed))?;
            return Ok(GeneralisedForce { along: Along::QuasiVelocity(of), is });
        }
        let (speed, order) = self.of_state(along)?;
        if order == 1 && speed < self.model.coordinates.len() {
            let accepted = format!("along = \"{}\"", self.model.coordinates[speed].name);
            return Err(Box::new(Fault::at(
                along.span(),
                "a generalised force acts along a coordinate",
                "a speed",
                accepted,
            )));
        }
        let needed = joule() / self.dimension_of_state(speed, 0);
        Ok(GeneralisedForce { along: Along::Speed(speed), is: self.scalar_value(&load.is, &what, Some(needed))? })
    }

    fn constraint(&mut self, constraint: &ConstraintSource) -> Sound<()> {
        let name = constraint.name.as_ref().map(|name| name.text.clone());
        let gains = match &constraint.gains {
            Some(gains) => Some(self.gains(gains)?),
            None => None,
        };
        let gains_at =
            constraint.gains.as_deref().and_then(|gains| Some(gains.first()?.span().start..gains.last()?.span().end));
        for text in &constraint.zero {
            if super::events::compared(text).is_some() {
                let accepted = "an expression that is zero; contacts, which hold one side, are not supported yet";
                let title = "a constraint is an equation";
                return Err(Box::new(Fault::at(text.span(), title, "an inequality", accepted)));
            }
            let zero = match self.value(text)? {
                Value::Scalar(zero) => Zero::Scalar(zero),
                Value::Vector(zero) => Zero::Vector(zero),
                other => {
                    return Err(mismatch(&text.span(), "a constraint", "a scalar or a vector that is zero", &other));
                }
            };
            let part = match zero {
                Zero::Scalar(zero) => zero.0,
                Zero::Vector(zero) => zero.0,
            };
            let dimension = self.dimension_of(part).unwrap_or_else(Dimension::none);
            let (name, gains, at) = (name.clone(), gains.clone(), text.span());
            let gains_at = gains_at.clone().unwrap_or_else(|| at.clone());
            self.model.constraints.push(Constraint { name, zero, dimension, gains, gains_at, at });
        }
        Ok(())
    }

    /// Reads the gains g1, g2 of f'' + g1 f' + g2 f = 0, or g1 of f' + g1 f = 0.
    fn gains(&mut self, texts: &[Text]) -> Sound<Vec<ScalarId>> {
        let mut gains = Vec::new();
        for (order, text) in texts.iter().enumerate() {
            let per = Dimension::time().power(Rational::new(order as i64 + 1, 1));
            gains.push(self.scalar_value(text, "a gain", Some(Dimension::none() / per))?);
        }
        Ok(gains)
    }

    fn output(&mut self, Entry { name, value }: &Entry) -> Sound<()> {
        let is = self.scalar_value(value, &format!("the output `{}`", name.text), None)?;
        let dimension = self.dimension_of(is.0).unwrap_or(Dimension::none());
        // quasi-velocities are outputs already
        if self.model.outputs.iter().any(|known| known.name == name.text && known.is == is) {
            return Ok(());
        }
        if let Some(taken) = self.column_of(&name.text) {
            let title = format!("the output `{}` has the name of {taken}", name.text);
            let label = "a run has a column of this name";
            return Err(Box::new(Fault::at(name.span(), title, label, "a name of its own for each output")));
        }
        self.model.outputs.push(Output { name: name.text.clone(), is, dimension });
        Ok(())
    }

    /// Returns a description of the existing column of a run with this name.
    fn column_of(&self, name: &str) -> Option<&'static str> {
        let is_state = || self.model.state_names().iter().any(|(own, _)| own == name);
        match name {
            "time" => Some("the column of times"),
            "kinetic_energy" | "potential_energy" => Some("an energy of the run"),
            _ if self.quasi_velocity_of(name).is_some() => Some("a quasi-velocity"),
            _ if self.model.outputs.iter().any(|output| output.name == name) => Some("another output"),
            _ if is_state() => Some("a coordinate or a speed"),
            _ => None,
        }
    }

    pub(super) fn start(&mut self) {
        for entry in &self.source.start {
            if self.places_by_angles(&entry.name.text) {
                continue;
            }
            if let Some(of) = self.quasi_velocity_of(&entry.name.text) {
                // a start value that contradicts a wrong definition is not reported separately
                if self.is_faulty(&entry.name.text) {
                    continue;
                }
                let found = self.start_speed(of, entry);
                let found = self.kept(found);
                self.model.start_speeds.extend(found);
                continue;
            }
            let found = match self.free_frame(&entry.name.text) {
                Some(number) => self.orientation(number, entry),
                None => self.start_value(entry).map(|start| vec![start]),
            };
            let found = self.under("start", &entry.name, found);
            let found = self.kept(found).unwrap_or_default();
            self.model.start.extend(found);
        }
    }

    /// Reads the name of a coordinate or, with a prime, of its speed. Returns the index and the order of differentiation, 0 or 1.
    pub(super) fn of_state(&self, name: &Text) -> Sound<(usize, usize)> {
        let base = name.text.trim_end_matches(['\'', '′']);
        let primes = name.text[base.len()..].chars().count();
        let coordinate = self.model.coordinates.iter().position(|known| known.name == base);
        if let (Some(coordinate), 0 | 1) = (coordinate, primes) {
            return Ok((coordinate, primes));
        }
        let of_drive = name.text.split_once('.').and_then(|(drive, current)| {
            let drive = self.drives.iter().find(|known| known.name == drive)?;
            drive.currents.iter().find(|(known, _)| known == current).map(|(_, charge)| *charge)
        });
        if let Some(charge) = of_drive {
            return Ok((charge, 1));
        }
        let of_free = name.text.rsplit_once('.').and_then(|(frame, part)| {
            let part = TURNING.iter().position(|known| *known == part)?;
            Some(self.model.free_speed(self.free_frame(frame)?) + part)
        });
        if let Some(speed) = of_free {
            return Ok((speed, 1));
        }
        if let Some(of) = self.quasi_velocity_of(&name.text) {
            let title = format!("`{}` is a quasi-velocity", self.model.quasi_velocities[of].name);
            let accepted = "a coordinate, its rate such as x', or F.wx of a free frame";
            return Err(Box::new(Fault::at(name.span(), title, "no part of the state", accepted)));
        }
        let known: Vec<String> = self.model.state_names().into_iter().map(|(name, _)| name).collect();
        // the orientation of a frame is not a single coordinate; a name without a component denotes the frame
        let frames = self.model.free.iter().map(|frame| self.model.frames[frame.0].name.clone());
        let known: Vec<String> = match name.text.contains('.') {
            true => known,
            false => known.into_iter().filter(|known| !known.contains('.')).chain(frames).collect(),
        };
        let quasi = self.model.quasi_velocities.iter().map(|speed| speed.name.clone());
        let known: Vec<String> = known.into_iter().chain(quasi).collect();
        let known = known.iter().map(String::as_str).filter(|name| !name.contains(".q"));
        Err(Box::new(super::unknown(&self.broken, name.span(), &name.text, "coordinate", known)))
    }

    /// Returns the dimension of a coordinate (order 0) or speed (order 1). The angular velocity of a free frame has no coordinate; its dimension is 1/time.
    pub(super) fn dimension_of_state(&self, coordinate: usize, order: usize) -> Dimension {
        let own = self.model.coordinates.get(coordinate).map_or(Dimension::none(), |known| known.dimension);
        if order == 0 { own } else { own / Dimension::time() }
    }

    /// Reads a start value, such as `theta = "30 deg"` or `theta' = "guess 2 rad/s"`.
    fn start_value(&mut self, Entry { name, value }: &Entry) -> Sound<StartValue> {
        let (coordinate, order) = self.of_state(name)?;
        if self.model.start.iter().any(|known| (known.coordinate, known.order) == (coordinate, order)) {
            return Err(Box::new(Fault::at(
                name.span(),
                format!("`{}` starts twice", name.text),
                "again",
                "one value",
            )));
        }
        let needed = self.dimension_of_state(coordinate, order);
        let (is_guess, number) = match value.text.trim().strip_prefix("guess ") {
            Some(rest) => (true, rest),
            None => (false, value.text.as_str()),
        };
        let of_own = self.model.coordinates.get(coordinate).map_or("rad", |known| known.unit.as_str());
        let unit = match (of_own, order) {
            ("1", 0) => String::new(),
            (own, 0) => format!(" {own}"),
            (own, _) => format!(" {own}/s"),
        };
        let fault = |label: String| {
            let title = format!("the start of `{}` cannot be read", name.text);
            let accepted =
                format!("a number with a unit of the dimension {needed}, such as \"0.3{unit}\" or \"guess 0.3{unit}\"");
            Box::new(Fault::at(value.span(), title, label, accepted))
        };
        let (si, found) = units::quantity::parse_any(number).map_err(|wrong| fault(wrong.to_string()))?;
        let found = found.of_expressions();
        if found != needed {
            return Err(fault(wrong_dimension(number, found)));
        }
        if order == 0 && self.model.coordinates[coordinate].unit == "rad" {
            self.judge_angle(value.span(), number, "\"{} deg\"");
        }
        Ok(StartValue { coordinate, order, value: si, is_guess })
    }
}
