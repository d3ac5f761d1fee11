//! The data of a scene and of its motions by name, and the scene with other values.

use crate::ensemble::known::{Data, DatumPlace, Known};
use crate::scene::{Scene, Setup};
use crate::stationary::energies::Energies;
use crate::stationary::motions::{decimals, written};
use field::Rational;
use std::borrow::Cow;
use std::fmt;
use symbolic::Sym;

/// A datum of a scene or of its motion.
#[derive(Clone, Debug)]
pub struct Datum {
    pub name: String,
    pub unit: Cow<'static, str>,
    pub(super) place: Where,
}

#[derive(Clone, Debug)]
pub(super) enum Where {
    /// A constant torque against the rotor's rotation, N m.
    Load,
    /// The angular velocity w0, rad/s.
    Speed,
    /// The rotor speed W, rad/s, instead of the motor's own steady speed.
    RotorSpeed,
    /// Components of a datum of the scene.
    Data { place: DatumPlace, components: Vec<usize> },
}

/// The data of a scene with changed values.
#[derive(Clone)]
pub(super) struct Setting {
    pub data: Data,
    pub load: f64,
    pub speed: f64,
    pub rotor_speed: Option<f64>,
}

/// No datum has this name.
#[derive(Clone, Debug, PartialEq)]
pub struct Unknown {
    pub name: String,
    pub known: Vec<String>,
}

impl fmt::Display for Unknown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no datum has the name `{}`; accepted: {}", self.name, self.known.join(", "))
    }
}

impl std::error::Error for Unknown {}

impl Datum {
    /// The datum with a name of files or the command line: `load`, `omega0`, `rotor_speed`, `gravity`,
    /// `carrier.centre.3`, `carrier.inertia.12`, `machine.field_speed` and others.
    ///
    /// # Errors
    /// [`Unknown`] with all accepted names.
    pub fn named(scene: &Scene, name: &str) -> Result<Self, Unknown> {
        let all = Self::all(scene);
        let known = || all.iter().map(|datum| datum.name.clone()).collect();
        all.iter()
            .find(|datum| datum.name == name)
            .cloned()
            .ok_or_else(|| Unknown { name: name.to_owned(), known: known() })
    }

    fn all(scene: &Scene) -> Vec<Self> {
        let of_motion = [
            ("load", "N m", Where::Load),
            ("omega0", "rad/s", Where::Speed),
            ("rotor_speed", "rad/s", Where::RotorSpeed),
        ];
        let mut all: Vec<Datum> = of_motion
            .into_iter()
            .map(|(name, unit, place)| Datum { name: name.into(), unit: unit.into(), place })
            .collect();
        for (table, known) in Known::of(scene).into_iter().filter(|(table, _)| *table != "start") {
            for Known { key, unit, components, place, .. } in known {
                let name = if table.is_empty() { key.into_owned() } else { format!("{table}.{key}") };
                // a symmetric tensor has each off-diagonal component twice
                let parts: Vec<(String, Vec<usize>)> = match components {
                    1 => vec![(name, vec![0])],
                    6 => [[1, 1], [1, 2], [1, 3], [2, 2], [2, 3], [3, 3]]
                        .map(|[i, j]| (format!("{name}.{i}{j}"), vec![3 * i + j - 4, 3 * j + i - 4]))
                        .into(),
                    count => (1..=count).map(|i| (format!("{name}.{i}"), vec![i - 1])).collect(),
                };
                all.extend(parts.into_iter().map(|(name, components)| Datum {
                    name,
                    unit: unit.clone(),
                    place: Where::Data { place, components },
                }));
            }
        }
        all
    }

    pub(super) fn is_load(&self) -> bool {
        matches!(self.place, Where::Load)
    }

    pub(super) fn is_speed(&self) -> bool {
        matches!(self.place, Where::Speed)
    }

    pub(super) fn is_rotor_speed(&self) -> bool {
        matches!(self.place, Where::RotorSpeed)
    }

    /// The index among the data of the machine.
    pub(super) fn of_machine(&self) -> Option<usize> {
        match self.place {
            Where::Data { place: DatumPlace::Machine(place), .. } => Some(place),
            _ => None,
        }
    }

    pub(super) fn is_of_motor(&self) -> bool {
        matches!(self.place, Where::Load | Where::Data { place: DatumPlace::Machine(_), .. })
    }
}

impl Setting {
    pub fn with(&self, datum: &Datum, value: f64) -> Self {
        let mut set = self.clone();
        match &datum.place {
            Where::Load => set.load = value,
            Where::Speed => set.speed = value,
            Where::RotorSpeed => set.rotor_speed = Some(value),
            Where::Data { place: DatumPlace::Machine(place), .. } => set.data.machine[*place] = value,
            Where::Data { place: DatumPlace::Bodies(of), components } => {
                if let Some(numbers) = of(&mut set.data.system) {
                    components.iter().for_each(|k| numbers[*k] = value);
                }
            }
            Where::Data { place: DatumPlace::Start(_), .. } => {}
        }
        set
    }

    /// T and V with exact data.
    pub fn energies(&self) -> Option<Energies<Rational>> {
        match &self.data.system {
            Setup::Gyrostat(bodies) => Some(Energies::of(&decimals(bodies))),
            Setup::Bench { .. } => None,
        }
    }

    /// T and V as expressions; data that are NaN become the unknown.
    pub fn energies_in(&self, unknown: Sym) -> Option<Energies<Sym>> {
        let number = |x: f64| if x.is_nan() { unknown } else { Sym::constant(Rational::decimal(x)) };
        match &self.data.system {
            Setup::Gyrostat(bodies) => Some(Energies::of(&written(bodies, number))),
            Setup::Bench { .. } => None,
        }
    }
}
