//! Linearisation of a system at its start or at an equilibrium, with eigenvalues and stability.

use super::points::Instance;
use super::{Linearisation, NotLinear, Stability, Standing, VariedEquations, eigenvalues};
use crate::readiness::{equilibrium_of, independent_at, independent_start};
use model::Model;
use reader::Issue;
use units::nearest;

/// The linear equations about one point, with eigenvalues and stability.
#[derive(Clone, Debug)]
pub struct Linear {
    /// The matrices of the linear equations.
    pub linear: Linearisation,
    /// The kind of point: equilibrium, steady motion, or neither.
    pub standing: Standing,
    /// Real and imaginary parts of the eigenvalues, 1/s.
    pub eigenvalues: Vec<[f64; 2]>,
    /// Stability in the first approximation.
    pub stability: Stability,
}

impl VariedEquations {
    /// The linear equations at a time (s) and a state (coordinates, then speeds).
    ///
    /// # Errors
    /// [`NotLinear`] with the reason.
    pub fn about(&self, time: f64, state: &[f64]) -> Result<Linear, NotLinear> {
        let linear = self.linearised(self.point(time, state))?;
        let standing = self.standing(&linear)?;
        let spectrum = eigenvalues(&linear.a);
        let stability = Stability::of(&spectrum, standing != Standing::Moving);
        let eigenvalues = spectrum.values.iter().map(|value| [value.re, value.im]).collect();
        Ok(Linear { linear, standing, eigenvalues, stability })
    }
}

/// The indices of the parameters with these names, for use as inputs. Names of inputs of the model are skipped; a parameter without a
/// value gets the value zero.
///
/// # Errors
/// No parameter or input has the name.
pub fn inputs_of(model: &mut Model, names: &[String]) -> Result<Vec<usize>, String> {
    let mut places = Vec::new();
    for name in names {
        // inputs of the model are inputs in any case
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

/// The point of linearisation: the start of a model or, with `equilibrium`, an equilibrium near it, with a sentence on the choice among
/// several. Redundant constraints are removed from the model.
///
/// # Errors
/// The start cannot be completed, or no equilibrium is found; the issue has its position in the file.
pub fn point_of(model: &mut Model, equilibrium: bool) -> Result<(Instance, Option<String>), Issue> {
    if !equilibrium {
        return independent_start(model).map(|state| ((0.0, state), None));
    }
    let found = equilibrium_of(model)?;
    independent_at(model, &found.state)?;
    let choice = found.choice().map(|choice| choice.to_string());
    Ok(((0.0, found.state), choice))
}
