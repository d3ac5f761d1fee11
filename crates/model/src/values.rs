//! Changes of the values of parameters and of the start.

use crate::parts::{Model, StartValue};
use units::nearest;

impl Model {
    /// Sets parameters, and coordinates and speeds at the start, in SI units.
    ///
    /// # Errors
    /// A name is unknown, belongs to a free frame, or to a parameter that is permanently zero.
    pub fn set_values<N: AsRef<str>>(&mut self, values: &[(N, f64)]) -> Result<(), String> {
        for (name, value) in values {
            let (name, value) = (name.as_ref(), *value);
            if let Some(place) = self.parameters.iter().position(|parameter| parameter.name == name) {
                if self.absent.contains(&place) {
                    return Err(format!("`{name}` is left out of this model, and has no other value"));
                }
                let parameter = &mut self.parameters[place];
                parameter.value = Some(value);
                let unit = if parameter.unit == "1" { String::new() } else { format!(" {}", parameter.unit) };
                parameter.written = format!("{value}{unit}");
                continue;
            }
            let own = self.coordinates.len();
            let place = self.state_names().iter().position(|(known, _)| known == name);
            let found = match place {
                Some(place) if place < own => (place, 0),
                Some(place) if (self.positions()..self.positions() + own).contains(&place) => {
                    (place - self.positions(), 1)
                }
                Some(_) => return Err(format!("`{name}` belongs to a free frame, whose start stands in its text")),
                None => return Err(self.not_called(name)),
            };
            let (coordinate, order) = found;
            self.start.retain(|start| (start.coordinate, start.order) != found);
            self.start.push(StartValue { coordinate, order, value, is_guess: false });
        }
        Ok(())
    }

    /// Returns the message on an unknown name, with the names that can be set.
    fn not_called(&self, name: &str) -> String {
        let (states, own) = (self.state_names(), self.coordinates.len());
        let is_of_start = |place: &usize| *place < own || (self.positions()..self.positions() + own).contains(place);
        let given = (0..self.parameters.len()).filter(|place| !self.absent.contains(place));
        let parameters = given.map(|place| self.parameters[place].name.as_str());
        let of_start = (0..states.len()).filter(is_of_start).map(|place| states[place].0.as_str());
        let known: Vec<&str> = parameters.chain(of_start).collect();
        let meant = nearest(name, known.iter().copied()).map_or_else(String::new, |own| format!("; is `{own}` meant?"));
        format!("nothing is called `{name}`{meant}; there are: {}", known.join(", "))
    }
}
