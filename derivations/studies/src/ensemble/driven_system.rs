//! A scene with a motor as a parametric system: ensemble members have different bodies, machines and starts; results
//! are in the axes of the data.

use super::kind::{INVARIANT_UNITS, INVARIANTS, Kind, form_parameters};
use super::known::{Data, DatumPlace, variables};
use crate::scene::state::{ROTOR_SPEED, rotor_state};
use crate::scene::{Scene, Setup};
use integrators::BatchSeries;
use motor::{Conserved, Machine};
use nalgebra::{Matrix3, Vector3};
use reader::{Family, Issue, Opening, Table};
use simulation::ensemble::parametric_system::{BATCH_SIZE, Column, Drawn, Member, ParametricSystem, Sizes};
use simulation::ensemble::{EnsembleScene, Last, Stopped, vary};
use simulation::{Axes, Run};
use std::fmt::{self, Write};
use std::sync::Arc;
use symbolic::Untapeable;
use systems::gyrostat::admissible::Inadmissible;

/// A scene with a motor, with its law for symbolic data.
#[derive(Debug)]
struct DrivenSystem {
    scene: Scene,
    kind: Kind,
    axes: Axes,
    /// The location of each variable in the data.
    places: Vec<DatumPlace>,
    /// The index of the slip among the states, if it is one.
    slip: Option<usize>,
}

/// Reads the rest of a scene with a motor and its table `[ensemble]`. Faults are added to `issues`.
pub(super) fn read(opening: Opening, top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<EnsembleScene> {
    let place = opening.system.span.clone();
    let scene = Scene::read(opening, top, issues);
    let known = scene.as_ref().map(variables);
    let example = "rotor.axial = { from = \"1 g cm^2\", to = \"2 g cm^2\" }";
    let variation = vary::read(top, issues, known.as_ref().map(|(variables, _)| &variables[..]), example);
    let (scene, variation, (_, places)) = (scene?, variation?, known?);
    let not_written = |wrong: String| Issue::at(place.clone(), "the law cannot be written down", wrong);
    let system = DrivenSystem::of(scene, places).map_err(|wrong| issues.push(not_written(wrong.to_string()))).ok()?;
    EnsembleScene::new(Arc::new(system), variation).map_err(|long| issues.push(not_written(long.to_string()))).ok()
}

impl DrivenSystem {
    fn of(scene: Scene, places: Vec<DatumPlace>) -> Result<Self, Untapeable> {
        let axes = Axes::Second;
        let kind = Kind::record(&scene.system, &scene.machine, axes)?;
        let slip = scene.names().iter().position(|name| name == "slip");
        Ok(DrivenSystem { scene, kind, axes, places, slip })
    }
}

impl ParametricSystem for DrivenSystem {
    fn title(&self) -> &str {
        &self.scene.title
    }

    fn run(&self) -> &Run {
        &self.scene.run
    }

    fn sizes(&self) -> Sizes {
        Sizes { states: self.kind.states(), parameters: self.kind.parameters() }
    }

    fn series(&self, order: usize) -> Option<Box<dyn BatchSeries<BATCH_SIZE> + '_>> {
        self.kind.series(order)
    }

    /// # Errors
    /// Bodies that cannot exist, or a datum of the machine beyond its bound.
    fn member(&self, drawn: &[Drawn]) -> Result<Member<'_>, Stopped> {
        let mut data = Data::of(&self.scene);
        for Drawn { variable, numbers } in drawn {
            if let Some(place) = self.places.get(*variable) {
                place.put(numbers, &mut data);
            }
        }
        match &data.system {
            Setup::Gyrostat(bodies) => bodies.admissible().map_err(|broken| impossible(&broken))?,
            Setup::Bench { axial } if *axial <= 0.0 => {
                return Err(Stopped::Impossible(format!("A' > 0 is broken: it is {axial}")));
            }
            Setup::Bench { .. } => {}
        }
        let given = self.scene.given.with_data(data.machine.clone());
        let machine = given.model(self.scene.machine.name()).map_err(|reason| Stopped::Machine(reason.to_string()))?;
        let (frame_speed, conserved) = (machine.frame_speed(), Conserved::by(&machine));
        let (frame, mut parameters) = form_parameters(&data.system, self.axes);
        parameters.extend(&data.machine);
        let mut state = Vec::with_capacity(self.kind.states());
        if let Some(frame) = frame {
            state.extend((frame.transpose() * data.start.angular_velocity).iter());
            state.extend((frame.transpose() * data.start.vertical).iter());
        }
        state.extend(rotor_state(&machine, &data.start));
        let shown =
            Shown { system: self, start: state.clone(), parameters: parameters.clone(), frame, frame_speed, conserved };
        Ok(Member {
            parameters,
            state,
            end: Box::new(move |time, state| shown.end(time, state)),
            margins: None,
            projection: None,
        })
    }

    fn columns(&self) -> Vec<Column> {
        let state = self.scene.names().into_iter().chain([ROTOR_SPEED.to_owned()]);
        let state = state.map(|name| Column { unit: self.scene.unit(&name).to_owned(), name });
        let kept = INVARIANTS.iter().zip(INVARIANT_UNITS);
        state.chain(kept.map(|(name, unit)| Column { name: format!("{name}_change"), unit: unit.to_owned() })).collect()
    }

    fn write_law(&self, out: &mut dyn Write) -> fmt::Result {
        let DrivenSystem { scene, kind, axes, .. } = self;
        write!(out, "{kind:?} {:?} {axes:?}", Data::of(scene))
    }

    fn name(&self) -> &str {
        self.scene.machine.name()
    }
}

/// The data of a member for its result columns.
struct Shown<'a> {
    system: &'a DrivenSystem,
    start: Vec<f64>,
    parameters: Vec<f64>,
    /// The axes of the form as columns; `None` for a bench.
    frame: Option<Matrix3<f64>>,
    frame_speed: f64,
    conserved: Conserved,
}

impl Shown<'_> {
    fn end(&self, time: f64, state: &[f64]) -> Last {
        let [before, after] = [&self.start[..], state].map(|state| self.kept(state));
        let keeps = self.keeps();
        let change = |i: usize| (keeps[i] && (after[i] - before[i]).is_finite()).then_some(after[i] - before[i]);
        Last { time, state: self.row(state), derived: (0..keeps.len()).map(change).collect() }
    }

    /// The values of the invariants at a state.
    fn kept(&self, state: &[f64]) -> [f64; 4] {
        let mut kept = [0.0; 4];
        self.system.kind.invariants().evaluate(&[state, &self.parameters].concat(), &mut kept);
        kept
    }

    /// The row of a state in the axes of the data, then the rotor's relative speed.
    fn row(&self, state: &[f64]) -> Vec<f64> {
        let mut row = state.to_vec();
        if let (Some(frame), Some(vectors)) = (self.frame, row.get_mut(..6)) {
            for vector in vectors.chunks_exact_mut(3) {
                let turned = frame * Vector3::from_column_slice(vector);
                vector.copy_from_slice(turned.as_slice());
            }
        }
        row.push(self.frame_speed + self.system.slip.map_or(0.0, |slip| state[slip]));
        row
    }

    /// For each invariant, whether the member conserves it.
    fn keeps(&self) -> [bool; 4] {
        [self.frame.is_some(), self.frame.is_some(), self.conserved.jacobi, self.conserved.spin]
    }
}

/// The message on bodies that cannot exist.
fn impossible(broken: &[Inadmissible]) -> Stopped {
    let broken: Vec<String> = broken.iter().map(Inadmissible::to_string).collect();
    Stopped::Impossible(broken.join("; "))
}
