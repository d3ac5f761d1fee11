//! The initial state of a scene in the axes of either form, and results back in the axes of the data.

use super::{Scene, Setup, Start};
use motor::{Machine, Motor, NoModel, state_names};
use nalgebra::{Matrix3, Vector3};
use simulation::Axes;
use systems::gyrostat::Gyrostat;
use systems::gyrostat::tensors::Principal;

/// The name of the output with the rotor's relative speed, which every run has.
pub const ROTOR_SPEED: &str = "rotor_speed";

/// The principal axes of the form's tensor: A for the first form, A* for the second.
pub fn principal(axes: Axes, bodies: &Gyrostat<f64>) -> Principal {
    match axes {
        Axes::First => Principal::of(&bodies.reduced_tensor()),
        Axes::Second => Principal::of(&bodies.full_tensor()),
    }
}

impl Scene {
    /// The initial state: w and v in the axes of the form, then the rotor's state and the currents.
    pub fn state(&self, axes: Axes) -> Vec<f64> {
        let mut state = Vec::new();
        if let Setup::Gyrostat(_) = self.system {
            let to_form = self.frame(axes).transpose();
            state.extend((to_form * self.start.angular_velocity).iter());
            state.extend((to_form * self.start.vertical).iter());
        }
        state.extend(rotor_state(&self.machine, &self.start));
        state
    }

    /// Transforms w and v of a state from the axes of a form to the axes of the data, in which results of both forms
    /// are comparable.
    pub fn back(&self, axes: Axes) -> impl Fn(&mut [f64]) + use<> {
        let frame = matches!(self.system, Setup::Gyrostat(_)).then(|| self.frame(axes));
        move |state| {
            let Some(frame) = frame else { return };
            for vector in state[..6].chunks_exact_mut(3) {
                let turned = frame * Vector3::from_column_slice(vector);
                vector.copy_from_slice(turned.as_slice());
            }
        }
    }

    /// The names of the states.
    pub fn names(&self) -> Vec<String> {
        names(self.on_bench(), &self.machine)
    }

    /// The unit of a column of a run, by its name; currents of windings may have any name.
    pub fn unit(&self, name: &str) -> &'static str {
        let own = state_names(&self.machine);
        let currents = own.len() - self.machine.windings();
        if own[currents..].iter().any(|current| current == name) { "A" } else { unit(name) }
    }

    /// Whether the scene is a bench, without a carrier.
    pub fn on_bench(&self) -> bool {
        matches!(self.system, Setup::Bench { .. })
    }

    /// The scene with another motor model made from the given data.
    ///
    /// # Errors
    /// [`NoModel`] where the model cannot be made.
    pub fn with_model(&self, model: &str) -> Result<Scene, NoModel> {
        let machine = self.given.model(model)?;
        let (given, windings) = (self.start.currents.len(), machine.windings());
        let mut start = self.start.clone();
        if windings == 0 {
            start.currents.clear();
        } else if given != 0 && given != windings {
            return Err(NoModel::Currents { model: model.to_owned(), given, windings });
        }
        let mut scene = Scene { machine, start, ..self.clone() };
        let names = scene.names();
        scene.run.outputs.retain(|output| output == ROTOR_SPEED || names.contains(output));
        Ok(scene)
    }

    /// The map from a state in the axes of a form to a row of outputs: the state in the axes of the data, and the
    /// rotor's speed.
    pub(super) fn row(&self, axes: Axes) -> impl Fn(f64, &[f64]) -> Vec<f64> + use<> {
        let back = self.back(axes);
        let frame_speed = self.machine.frame_speed();
        let slip = self.names().iter().position(|name| name == "slip");
        move |_, state| {
            let mut row = state.to_vec();
            back(&mut row);
            row.push(frame_speed + slip.map_or(0.0, |slip| state[slip]));
            row
        }
    }

    /// The axes of a form as columns, in the axes of the data.
    fn frame(&self, axes: Axes) -> Matrix3<f64> {
        match (&self.system, axes) {
            (Setup::Gyrostat(bodies), axes) => principal(axes, bodies).axes,
            (Setup::Bench { .. }, _) => Matrix3::identity(),
        }
    }
}

/// The initial state of a machine: the rotor's state, then the currents.
pub fn rotor_state(machine: &Motor, start: &Start) -> Vec<f64> {
    let known = machine.rotor();
    let mut state = vec![0.0; known.dimension()];
    known.write(start.rotor_angle, start.rotor_speed - machine.frame_speed(), &mut state);
    match start.currents.len() {
        0 => state.extend(std::iter::repeat_n(0.0, machine.windings())),
        _ => state.extend(&start.currents),
    }
    state
}

/// The names of the states of a system with a machine.
pub fn names(on_bench: bool, machine: &Motor) -> Vec<String> {
    let carrier: &[&str] = if on_bench { &[] } else { &["w1", "w2", "w3", "v1", "v2", "v3"] };
    let mut names: Vec<String> = carrier.iter().map(|&name| name.into()).collect();
    names.extend(state_names(machine));
    names
}

/// The names of a run's outputs: the states and the rotor's speed.
pub fn outputs(on_bench: bool, machine: &Motor) -> Vec<String> {
    let mut names = names(on_bench, machine);
    names.push(ROTOR_SPEED.to_owned());
    names
}

/// The unit of a state or of the rotor's speed, by its name.
pub fn unit(name: &str) -> &'static str {
    match name {
        "work" => "J",
        "v1" | "v2" | "v3" => "1",
        "w1" | "w2" | "w3" | "slip" | ROTOR_SPEED => "rad/s",
        "angle" => "rad",
        _ => "A",
    }
}
