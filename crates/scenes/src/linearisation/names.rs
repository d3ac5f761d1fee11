//! Names of the rows and columns of linear equations.

use super::{Linearisation, VariedEquations};
use model::Model;

/// Names of coordinates, speeds, displacements, inputs and outputs of a model.
#[derive(Clone, Debug)]
pub struct Names {
    /// Names of the coordinates of a state, with quaternion components.
    pub coordinates: Vec<String>,
    /// Names of the speeds of a state.
    pub speeds: Vec<String>,
    /// Names of the displacements along speeds: coordinates, and rotations of free frames about their axes.
    pub displacements: Vec<String>,
    /// Names of the inputs.
    pub inputs: Vec<String>,
    /// Names of the outputs.
    pub outputs: Vec<String>,
}

impl Names {
    /// The names of a model and of the inputs of its equations.
    pub fn of(model: &Model, equations: &VariedEquations) -> Self {
        let mut coordinates: Vec<String> = model.state_names().into_iter().map(|(name, _)| name).collect();
        let speeds = coordinates.split_off(model.positions());
        let own = model.coordinates.iter().map(|coordinate| coordinate.name.clone());
        let turns = model.free.iter().flat_map(|frame| {
            let name = &model.frames[frame.0].name;
            ["x", "y", "z"].map(|axis| format!("turn about {name}.{axis}"))
        });
        Names {
            coordinates,
            speeds,
            displacements: own.chain(turns).collect(),
            inputs: equations.inputs.clone(),
            outputs: model.outputs.iter().map(|output| output.name.clone()).collect(),
        }
    }

    /// The names of the components of the state x of a linearisation.
    pub fn states(&self, linear: &Linearisation) -> Vec<String> {
        let displacements = linear.coordinates.iter().map(|&place| self.displacements[place].clone());
        displacements.chain(linear.speeds.iter().map(|&place| self.speeds[place].clone())).collect()
    }

    /// The names of the rows, then of the columns, of the matrix "A", "B", "C" or "D".
    pub fn sides(&self, linear: &Linearisation, matrix: &str) -> (Vec<String>, Vec<String>) {
        let states = self.states(linear);
        let rows = if matrix == "A" || matrix == "B" { states.clone() } else { self.outputs.clone() };
        (rows, if matrix == "A" || matrix == "C" { states } else { self.inputs.clone() })
    }
}
