//! Points of linearisation of a text, its inputs, and the eigenvalues and stability there.

use super::points::Instance;
use super::{Linearisation, NotLinear, Stability, Standing, VariedEquations, eigenvalues};
use crate::readiness::{equilibrium_of, independent_at, independent_start};
use model::Model;
use reader::Issue;
use units::nearest;

/// The linear equations about one point, with eigenvalues and stability.
#[derive(Clone, Debug)]
pub struct Linear {
    pub linear: Linearisation,
    pub standing: Standing,
    /// Real and imaginary parts of the eigenvalues, 1/s.
    pub eigenvalues: Vec<[f64; 2]>,
    pub stability: Stability,
}

impl VariedEquations {
    /// About a state at a time.
    ///
    /// # Errors
    /// The reason for which there are no linear equations.
    pub fn about(&self, time: f64, state: &[f64]) -> Result<Linear, NotLinear> {
        let linear = self.linearised(self.point(time, state))?;
        let standing = self.standing(&linear)?;
        let spectrum = eigenvalues(&linear.a);
        let stability = Stability::of(&spectrum, standing != Standing::Moving);
        let eigenvalues = spectrum.values.iter().map(|value| [value.re, value.im]).collect();
        Ok(Linear { linear, standing, eigenvalues, stability })
    }
}

/// The places of parameters that are inputs; one without a value is taken about zero.
///
/// # Errors
/// The name of no parameter.
pub fn inputs_of(model: &mut Model, names: &[String]) -> Result<Vec<usize>, String> {
    let mut places = Vec::new();
    for name in names {
        // those of the file are inputs in any case
        if model.inputs.iter().any(|input| input.name == *name) {
            continue;
        }
        let Some(place) = model.parameters.iter().position(|parameter| parameter.name == *name) else {
            let known: Vec<&str> = model.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
            return Err(match nearest(name, known.iter().copied()) {
                Some(nearest) => format!("no parameter is called `{name}`; is `{nearest}` meant?"),
                None => format!("no parameter is called `{name}`; there are: {}", known.join(", ")),
            });
        };
        model.parameters[place].value.get_or_insert(0.0);
        if !places.contains(&place) {
            places.push(place);
        }
    }
    Ok(places)
}

/// The start of a model, or an equilibrium near it, with a note on the choice among several; redundant constraints are removed from the
/// model.
///
/// # Errors
/// The reason for which there is no such point, at its place in the file.
pub fn point_of(model: &mut Model, equilibrium: bool) -> Result<(Instance, Option<String>), Issue> {
    if !equilibrium {
        return independent_start(model).map(|state| ((0.0, state), None));
    }
    let found = equilibrium_of(model)?;
    independent_at(model, &found.state)?;
    let choice = found.choice().map(|choice| choice.to_string());
    Ok(((0.0, found.state), choice))
}
