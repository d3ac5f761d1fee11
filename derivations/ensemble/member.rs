//! One member: its data, as the lanes take them, and its results in the axes of the data.

use super::kind::form_parameters;
use super::known::Data;
use super::{EnsembleScene, Stopped};
use crate::machines::{Catalogued, Conserved, ForMachine};
use crate::scene::System;
use crate::scene::state::rotor_state;
use nalgebra::{Matrix3, Vector3};

/// A member before its run.
#[derive(Clone, Debug)]
pub struct Member {
    /// Counted from one.
    pub number: u64,
    pub parameters: Vec<f64>,
    /// In the axes of the form.
    pub state: Vec<f64>,
    /// The axes of the form as columns, where there are some.
    frame: Option<Matrix3<f64>>,
    frame_speed: f64,
    pub conserved: Conserved,
}

impl EnsembleScene {
    /// The numbers of a member that vary, in the order of the file's list.
    pub fn drawn(&self, number: u64) -> Vec<f64> {
        self.varied.iter().flat_map(|varied| varied.drawn(self.seed, number)).collect()
    }

    /// A member.
    ///
    /// # Errors
    /// Why there is none: its bodies cannot exist, or a datum of its machine is beyond its bound.
    pub fn member(&self, number: u64) -> Result<Member, Stopped> {
        let mut data = Data::of(&self.scene);
        for varied in &self.varied {
            let drawn = varied.drawn(self.seed, number);
            if drawn.iter().any(|x| !x.is_finite()) {
                return Err(Stopped::NotFinite { datum: varied.name.clone() });
            }
            varied.put(&drawn, &mut data);
        }
        match &data.system {
            System::Gyrostat(bodies) => bodies.admissible().map_err(Stopped::Bodies)?,
            System::Bench { axial } if *axial <= 0.0 => return Err(Stopped::Axial { value: *axial }),
            System::Bench { .. } => {}
        }
        let mut known = self.scene.machine_data.clone();
        known.numbers.iter_mut().zip(&data.machine).for_each(|((_, value), new)| *value = *new);
        let machine = known.machine(self.scene.machine.name()).map_err(Stopped::Machine)?;
        let (frame_speed, conserved) = machine.clone().apply(OfMachine);
        let (frame, mut parameters) = form_parameters(&data.system, self.axes);
        parameters.extend(&data.machine);
        let mut state = Vec::with_capacity(self.kind.states());
        if let Some(frame) = frame {
            state.extend((frame.transpose() * data.start.angular_velocity).iter());
            state.extend((frame.transpose() * data.start.vertical).iter());
        }
        state.extend(rotor_state(&machine, &data.start));
        Ok(Member { number, parameters, state, frame, frame_speed, conserved })
    }
}

impl Member {
    /// A state as a row of results: in the axes of the data, then the rotor's relative speed.
    pub fn row(&self, state: &[f64], slip: Option<usize>) -> Vec<f64> {
        let mut row = state.to_vec();
        if let (Some(frame), Some(vectors)) = (self.frame, row.get_mut(..6)) {
            for vector in vectors.chunks_exact_mut(3) {
                let turned = frame * Vector3::from_column_slice(vector);
                vector.copy_from_slice(turned.as_slice());
            }
        }
        row.push(self.frame_speed + slip.map_or(0.0, |slip| state[slip]));
        row
    }

    /// Which of the invariants of its kind this member keeps.
    pub fn keeps(&self) -> [bool; 4] {
        [self.frame.is_some(), self.frame.is_some(), self.conserved.jacobi, self.conserved.spin]
    }
}

struct OfMachine;

impl ForMachine for OfMachine {
    type Output = (f64, Conserved);

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> (f64, Conserved) {
        (machine.frame_speed(), Conserved::by(&machine))
    }
}
