//! Stability maps of the steady rotation about the common axis of rotor and weight, over any two data of a scene, given
//! by name; each map also shows where the motor has a steady state.
//!
//! The first datum takes numerical values: at each of them the motor's steady state, and hence W, is computed. The
//! second datum remains a symbol: if T and V, or the speeds, are polynomials in it, then b and a^2 - 4 b are too.
//! Whether this holds is checked by evaluating the law with the second datum as a symbol.

use super::datum::{Datum, Setting, Where};
use super::map::{Column, OneAxis};
use super::reduced::Reduced;
use crate::ensemble::known::Data;
use crate::scene::Scene;
use crate::stationary::energies::Energies;
use crate::stationary::motor::{Bears, MotorStates, NoMotor};
use algebra::real::Root;
use field::{Rational, Scalar};
use std::fmt;
use symbolic::{Hypotheses, NotPolynomial, Sym, normal};

/// The reason why there is no map.
#[derive(Clone, Debug, PartialEq)]
pub enum NoPlane {
    Bench,
    /// The motor's steady state depends on the second datum.
    NotPolynomial(String),
    /// One of the polynomials whose signs decide is not polynomial in the second datum, because of this quantity.
    Bent {
        name: String,
        part: String,
    },
    /// At this value of the first datum the rotor's axis, the weight and a principal axis of inertia are not parallel.
    Oblique {
        name: String,
        value: f64,
    },
    NoMotor(String),
}

/// The map at one value of the first datum.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    Decided(Column),
    /// The motor has no steady speed: the load exceeds its pull-out torque.
    PulledOut,
}

/// A stability map over two data of a scene.
pub struct Plane<'a> {
    scene: &'a Scene,
    data: Data,
    first: &'a Datum,
    second: &'a Datum,
    /// The angular velocity w0, rad/s, unless it is one of the two data.
    speed: f64,
    /// Whether the angular velocity points along the rotor's axis, or opposite to it.
    along: bool,
}

/// The number of parts of a range at whose ends it is tested whether rotor axis, weight and principal axis are
/// parallel.
const LOOKED: u32 = 12;

impl<'a> Plane<'a> {
    /// The map over two data, with the angular velocity w0, rad/s, along the rotor's axis or opposite to it.
    ///
    /// # Errors
    /// [`NoPlane`] gives the reason why there is no map.
    pub fn of(scene: &'a Scene, [first, second]: [&'a Datum; 2], speed: f64, along: bool) -> Result<Self, NoPlane> {
        if scene.on_bench() {
            return Err(NoPlane::Bench);
        }
        if second.is_of_motor() {
            return Err(NoPlane::NotPolynomial(second.name.clone()));
        }
        Ok(Plane { scene, data: Data::of(scene), first, second, speed, along })
    }

    /// The map at one value of the first datum, with the second datum in a range.
    ///
    /// # Errors
    /// [`NoPlane`] gives the reason why there is no map.
    pub fn cell(&self, value: f64, [low, high]: [f64; 2]) -> Result<Cell, NoPlane> {
        let all = Setting { data: self.data.clone(), load: 0.0, speed: self.speed, rotor_speed: None };
        let here = all.with(self.first, value);
        let rotor_speed = match self.kept(&here)? {
            Ok(kept) => kept,
            Err(cell) => return Ok(cell),
        };
        let axis_at = |at: f64| {
            let energies = here.with(self.second, at).energies();
            energies.as_ref().and_then(|energies| OneAxis::about(energies, self.along))
        };
        let unknown = Sym::symbol("x");
        let set = here.with(self.second, f64::NAN);
        let number = |x: f64| if x.is_nan() { unknown } else { Sym::constant(Rational::decimal(x)) };
        // an irrational W enters as a second unknown
        let (own, fraction) = (Sym::symbol("W"), rotor_speed.as_rational());
        let speeds = match self.second.place {
            Where::RotorSpeed => [number(set.speed), unknown],
            _ => [number(set.speed), fraction.map_or(own, Sym::constant)],
        };
        let along = set.energies_in(unknown).and_then(tidy).and_then(|energies| OneAxis::about(&energies, self.along));
        let Some(along) = along else {
            let mut values = (0..=LOOKED).map(|k| low + (high - low) * f64::from(k) / f64::from(LOOKED));
            let value = values.find(|at| axis_at(*at).is_none()).unwrap_or(low);
            return Err(NoPlane::Oblique { name: self.second.name.clone(), value });
        };
        let [speed, kept] = speeds;
        let over = along.motion(speed, kept);
        let Some(rotor_speed) = fraction else {
            let column = Column::with_kept(&over, [unknown, own], &rotor_speed, [low, high]);
            return self.decided(column, low);
        };
        let motion = |at: Rational| -> Option<Reduced<Rational>> {
            let value = at.to_f64();
            let set = here.with(self.second, value);
            let speed = if matches!(self.second.place, Where::Speed) { at } else { Rational::decimal(set.speed) };
            let kept = if matches!(self.second.place, Where::RotorSpeed) { at } else { rotor_speed };
            Some(axis_at(value)?.motion(speed, kept))
        };
        self.decided(Column::of(&over, unknown, [low, high], &motion), low)
    }

    fn decided(&self, column: Result<Option<Column>, NotPolynomial>, low: f64) -> Result<Cell, NoPlane> {
        let column = column
            .map_err(|NotPolynomial(part)| NoPlane::Bent { name: self.second.name.clone(), part: part.to_string() })?;
        column.map(Cell::Decided).ok_or_else(|| NoPlane::Oblique { name: self.second.name.clone(), value: low })
    }

    /// The rotor's speed W, or the cell to draw where the motor has no steady speed.
    fn kept(&self, here: &Setting) -> Result<Result<Root, Cell>, NoPlane> {
        let fraction = |value: Rational| {
            let undefined = || NoPlane::NoMotor("the rotor's speed is no number".into());
            Root::rational(value).map(Ok).ok_or_else(undefined)
        };
        if matches!(self.second.place, Where::RotorSpeed) {
            return fraction(Rational::int(0));
        }
        if let Some(speed) = here.rotor_speed {
            return fraction(Rational::decimal(speed));
        }
        let speed = match self.motor(here)? {
            MotorStates::Free => return fraction(Rational::decimal(here.data.start.rotor_speed)),
            MotorStates::Kept { speed } => Some(speed),
            MotorStates::InStep { speed, angles, .. } => Some(speed).filter(|_| !angles.is_empty()),
            MotorStates::Slipping { speeds, .. } => {
                speeds.into_iter().find(|slip| slip.slope < 0).map(|slip| slip.speed)
            }
        };
        let Some(speed) = speed else { return Ok(Err(Cell::PulledOut)) };
        // the root may be rational without the polynomial showing it
        let simplest = speed.enclosure(256).simplest();
        let same = Root::rational(simplest).filter(|root| root.compare(&speed).is_eq());
        Ok(Ok(same.unwrap_or(speed)))
    }

    fn motor(&self, here: &Setting) -> Result<MotorStates, NoPlane> {
        let given = self.scene.given.with_data(here.data.machine.clone());
        let motor = given.model(self.scene.machine.name()).map_err(NoMotor::Data);
        let states = motor.and_then(|motor| MotorStates::under(&motor, here.load));
        states.map_err(|reason| NoPlane::NoMotor(reason.to_string()))
    }

    /// The loads, N m, that the motor can carry, if the first datum is the load.
    pub fn bears(&self) -> Option<Bears> {
        let here = Setting { data: self.data.clone(), load: 0.0, speed: self.speed, rotor_speed: None };
        match (&self.first.place, self.motor(&here)) {
            (Where::Load, Ok(MotorStates::InStep { bears, .. })) => bears,
            _ => None,
        }
    }
}

/// The energies with each entry in normal form.
fn tidy(energies: Energies<Sym>) -> Option<Energies<Sym>> {
    let reduced = |entry: Sym| normal(entry, &Hypotheses::none()).map_or(Sym::UNDEFINED, |form| form.to_sym());
    let Energies { tensor, mixed, axial, weight } = energies;
    let tidied = Energies {
        tensor: tensor.map(reduced),
        mixed: mixed.map(reduced),
        axial: reduced(axial),
        weight: weight.map(reduced),
    };
    let all = tidied.tensor.iter().chain(&tidied.mixed).chain(&tidied.weight).chain([&tidied.axial]);
    all.into_iter().all(|entry| *entry != Sym::UNDEFINED).then_some(tidied)
}

impl fmt::Display for NoPlane {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bench => {
                write!(f, "a motor on a bench has no carrier; a scene with system = \"gyrostat\" is accepted")
            }
            Self::NotPolynomial(name) => write!(
                f,
                "`{name}` changes what the motor keeps, so that a verdict is no polynomial in it; it is accepted as the first of \
                 the two data"
            ),
            Self::Bent { name, part } => write!(
                f,
                "a verdict is no polynomial in `{name}`, because of {part}; it is accepted as the first of the two data"
            ),
            Self::Oblique { name, value } => write!(
                f,
                "where {name} is {value}, rotor, weight and a principal axis do not lie along one line; a gyrostat whose \
                 rotor, centre of mass and principal axis agree is accepted"
            ),
            Self::NoMotor(reason) => write!(f, "{reason}"),
        }
    }
}

impl std::error::Error for NoPlane {}
