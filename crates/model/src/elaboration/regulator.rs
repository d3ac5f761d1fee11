//! The cost function of an optimal regulator, its inputs and its initial deviations.

use super::orders::ACCELERATIONS;
use super::{Elaborator, Sound};
use crate::{Entry, Fault, Regulator, RegulatorSource, ScalarId, Text};
use symbolic::Dimension;

impl Elaborator<'_> {
    pub(super) fn regulator(&mut self) {
        let Some(source) = &self.source.regulator else { return };
        let found = self.regulator_of(source);
        self.model.regulator = self.kept(found);
    }

    fn regulator_of(&mut self, source: &RegulatorSource) -> Sound<Regulator> {
        let mut inputs = Vec::new();
        for name in &source.inputs {
            let place = self.model.inputs.iter().position(|input| input.name == name.text);
            let known = || self.model.inputs.iter().map(|input| input.name.as_str()).collect::<Vec<_>>().join(", ");
            let Some(place) = place else {
                let title = format!("no input is called `{}`", name.text);
                let accepted = format!("names of [inputs]: {}", known());
                return Err(Box::new(Fault::at(name.span(), title, "not known", accepted)));
            };
            if !inputs.contains(&place) {
                inputs.push(place);
            }
        }
        if source.inputs.is_empty() {
            inputs = (0..self.model.inputs.len()).collect();
        }
        if inputs.is_empty() {
            let title = "a regulator has an input to choose";
            let accepted = "[inputs] with u = \"N\", and a force that holds u";
            return Err(Box::new(Fault::at(source.at.clone(), title, "there are none", accepted)));
        }
        let cost = self.cost(&source.cost)?;
        let last = source.last.as_ref().map(|last| self.cost(last)).transpose()?;
        let horizon = match &source.horizon {
            None => None,
            Some(text) => Some(self.quantity(text, "the horizon", Dimension::time())?),
        };
        if let (Some(text), Some(horizon)) = (&source.horizon, horizon)
            && horizon <= 0.0
        {
            let title = "the horizon of a regulator is positive";
            return Err(Box::new(Fault::at(text.span(), title, "it is not", "horizon = \"5 s\"")));
        }
        if let (Some(last), None) = (&source.last, horizon) {
            let title = "a cost of the end belongs to a horizon";
            return Err(Box::new(Fault::at(
                last.span(),
                title,
                "`horizon` is missing",
                "horizon = \"5 s\" in the same table",
            )));
        }
        let mut displaced = Vec::new();
        for Entry { name, value } in &source.displaced {
            let (coordinate, order) = self.of_state(name)?;
            let needed = self.dimension_of_state(coordinate, order);
            let value = self.quantity(value, &format!("the deviation of `{}`", name.text), needed)?;
            displaced.push((coordinate, order, value));
        }
        let at = [source.cost.span(), source.last.as_ref().map_or_else(|| source.at.clone(), Text::span)];
        Ok(Regulator { inputs, cost, last, horizon, displaced, at })
    }

    fn cost(&mut self, text: &Text) -> Sound<ScalarId> {
        let found = self.scalar_value(text, "the cost of a regulator", None)?;
        if self.orders.of(found.0).is_some_and(|order| order >= ACCELERATIONS) {
            let title = "the cost of a regulator holds accelerations or reactions";
            let accepted = "coordinates, their rates, inputs and parameters";
            return Err(Box::new(Fault::at(text.span(), title, "not supported yet", accepted)));
        }
        Ok(found)
    }

    /// Reads a number with a unit of the given dimension, in SI units.
    fn quantity(&self, text: &Text, what: &str, needed: Dimension) -> Sound<f64> {
        let fault = |label: String| {
            let accepted = format!("a number with a unit of the dimension {needed}");
            Box::new(Fault::at(text.span(), format!("{what} cannot be read"), label, accepted))
        };
        let (value, found) = units::quantity::parse_any(&text.text).map_err(|wrong| fault(wrong.to_string()))?;
        let found = found.of_expressions();
        if found == needed { Ok(value) } else { Err(fault(format!("this has the dimension {found}"))) }
    }
}
