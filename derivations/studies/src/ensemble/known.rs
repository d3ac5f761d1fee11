//! The numbers of a scene that may vary between ensemble members: their names in files, and their locations in the
//! data.

use crate::scene::{Scene, Setup, Start};
use motor::Machine;
use reader::Quantity;
use simulation::ensemble::parametric_system::{Shape, Variable};
use std::borrow::Cow;
use std::slice::from_mut;

/// The numbers of a scene that may vary.
#[derive(Clone, Debug, PartialEq)]
pub struct Data {
    pub system: Setup,
    /// Parameters of the machine, in its own order.
    pub machine: Vec<f64>,
    pub start: Start,
}

/// The location of a datum.
#[derive(Clone, Copy, Debug)]
pub enum DatumPlace {
    Bodies(fn(&mut Setup) -> Option<&mut [f64]>),
    Machine(usize),
    Start(fn(&mut Start) -> &mut [f64]),
}

/// A datum that a file may vary: key, meaning, unit, number of components, and location.
pub(crate) struct Known {
    pub key: Cow<'static, str>,
    pub meaning: Cow<'static, str>,
    pub unit: Cow<'static, str>,
    pub components: usize,
    pub place: DatumPlace,
}

macro_rules! of_bodies {
    ($bodies:ident => $number:expr) => {
        DatumPlace::Bodies(|system| match system {
            Setup::Gyrostat($bodies) => Some($number),
            Setup::Bench { .. } => None,
        })
    };
}

impl Known {
    const fn new(
        key: &'static str,
        meaning: &'static str,
        unit: &'static str,
        components: usize,
        place: DatumPlace,
    ) -> Self {
        let [key, meaning, unit] = [Cow::Borrowed(key), Cow::Borrowed(meaning), Cow::Borrowed(unit)];
        Known { key, meaning, unit, components, place }
    }

    /// A parameter of the machine, by its index.
    fn of_machine((place, (quantity, _)): (usize, (&Quantity, f64))) -> Self {
        let Quantity { name, unit, meaning, .. } = quantity.clone();
        Known { key: name, meaning, unit, components: 1, place: DatumPlace::Machine(place) }
    }

    /// All data of a scene that may vary, by table; the top of the file has an empty name.
    pub fn of(scene: &Scene) -> Vec<(&'static str, Vec<Known>)> {
        let machine = scene.given.data().enumerate();
        let machine = machine.map(Known::of_machine).collect();
        let windings = scene.machine.windings();
        let mut start = vec![Known::new(
            "rotor_angle",
            "angle of the rotor",
            "rad",
            1,
            DatumPlace::Start(|s| from_mut(&mut s.rotor_angle)),
        )];
        if scene.machine.prescribed_speed().is_none() {
            start.push(Known::new(
                "rotor_speed",
                "relative speed of the rotor",
                "rad/s",
                1,
                DatumPlace::Start(|s| from_mut(&mut s.rotor_speed)),
            ));
        }
        if windings > 0 {
            start.push(Known::new(
                "currents",
                "row of currents",
                "A",
                windings,
                DatumPlace::Start(|s| &mut s.currents),
            ));
        }
        let axial = DatumPlace::Bodies(|system| match system {
            Setup::Gyrostat(bodies) => Some(from_mut(&mut bodies.rotor.axial)),
            Setup::Bench { axial } => Some(from_mut(axial)),
        });
        let mut rotor = vec![Known::new("axial", "moment of inertia about the axis", "kg m^2", 1, axial)];
        if let Setup::Bench { .. } = scene.system {
            return vec![("rotor", rotor), ("machine", machine), ("start", start)];
        }
        rotor.extend([
            Known::new("mass", "mass of the rotor", "kg", 1, of_bodies!(b => from_mut(&mut b.rotor.mass))),
            Known::new(
                "centre",
                "vector from O to the rotor's centre",
                "m",
                3,
                of_bodies!(b => b.rotor.centre.as_mut_slice()),
            ),
            Known::new("axis", "direction of the rotor's axis", "1", 3, of_bodies!(b => b.rotor.axis.as_mut_slice())),
            Known::new(
                "transverse",
                "moment of inertia across the axis",
                "kg m^2",
                1,
                of_bodies!(b => from_mut(&mut b.rotor.transverse)),
            ),
        ]);
        let carrier = vec![
            Known::new("mass", "mass of the carrier", "kg", 1, of_bodies!(b => from_mut(&mut b.carrier.mass))),
            Known::new(
                "centre",
                "vector from O to the carrier's centre",
                "m",
                3,
                of_bodies!(b => b.carrier.centre.as_mut_slice()),
            ),
            Known::new(
                "inertia",
                "inertia tensor of the carrier: 11 12 13 22 23 33",
                "kg m^2",
                6,
                of_bodies!(b => b.carrier.inertia.as_mut_slice()),
            ),
        ];
        start.extend([
            Known::new(
                "angular_velocity",
                "angular velocity of the carrier",
                "rad/s",
                3,
                DatumPlace::Start(|s| s.angular_velocity.as_mut_slice()),
            ),
            Known::new(
                "vertical",
                "direction of the vertical, downwards",
                "1",
                3,
                DatumPlace::Start(|s| s.vertical.as_mut_slice()),
            ),
        ]);
        let top = vec![Known::new(
            "gravity",
            "acceleration of gravity",
            "m/s^2",
            1,
            of_bodies!(b => from_mut(&mut b.gravity)),
        )];
        vec![("", top), ("carrier", carrier), ("rotor", rotor), ("machine", machine), ("start", start)]
    }
}

/// All data of a scene that may vary, in the order of result tables, with their locations.
pub(super) fn variables(scene: &Scene) -> (Vec<Variable>, Vec<DatumPlace>) {
    let mut all = Vec::new();
    for (table, known) in Known::of(scene) {
        for Known { key, meaning, unit, components, place } in known {
            let shape = match (table, &*key) {
                ("rotor", "axis") | ("start", "vertical") => Shape::Direction,
                ("carrier", "inertia") => Shape::SymmetricTensor,
                _ => Shape::Numbers(components),
            };
            all.push((Variable { table, key, meaning, unit, shape }, place));
        }
    }
    all.into_iter().unzip()
}

impl DatumPlace {
    /// Writes drawn numbers to their location; six numbers are a symmetric tensor.
    pub(super) fn put(self, drawn: &[f64], data: &mut Data) {
        let place = match self {
            DatumPlace::Bodies(of) => of(&mut data.system).unwrap_or_default(),
            DatumPlace::Machine(i) => data.machine.get_mut(i).map(from_mut).unwrap_or_default(),
            DatumPlace::Start(of) => of(&mut data.start),
        };
        match (drawn, place.len()) {
            (&[a, b, c, d, e, f], 9) => place.copy_from_slice(&[a, b, c, b, d, e, c, e, f]),
            _ => place.iter_mut().zip(drawn).for_each(|(place, drawn)| *place = *drawn),
        }
    }
}

impl Data {
    /// The data of a scene.
    pub fn of(scene: &Scene) -> Self {
        let mut start = scene.start.clone();
        start.currents.resize(scene.machine.windings(), 0.0);
        Data { system: scene.system.clone(), machine: scene.given.values().to_vec(), start }
    }
}
