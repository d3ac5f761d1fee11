//! The linearised law with symbols for the bodies, the load and a datum of the machine; it is derived once for a whole
//! map.

use super::Region;
use crate::scene::Scene;
use crate::stationary::energies::{Energies, Kept};
use crate::stationary::motor::{Angle, MotorStates, NoMotor};
use crate::stationary::stability::approximation::Approximation;
use crate::stationary::stability::datum::{Datum, Setting};
use algebra::real::Root;
use field::Rational;
use motor::{ConstantSpeed, Loaded, Machine, Motor};
use nalgebra::{Matrix3, Vector3};
use std::sync::Arc;
use symbolic::Sym;

/// The meaning of the symbols in the law.
pub(super) struct Letters {
    /// Whether one of the two data is W itself, which then replaces the motor's own steady speed.
    prescribed: bool,
    load: bool,
    /// The index of the datum among those of the machine, if it is one of them.
    machine: Option<usize>,
    approximation: Approximation,
}

/// The motor's steady states at one value of the first datum.
pub(super) struct Ground {
    pub motor: MotorStates,
    approximation: Approximation,
    letters: Vec<Rational>,
}

/// The rotor's constant quantity, and the angle of a synchronous motor.
pub(super) struct HeldRotor<'a> {
    pub kept: Kept,
    pub value: Root,
    pub angle: Option<&'a Angle>,
}

impl Letters {
    pub fn of(scene: &Scene, data: [&Datum; 2]) -> Result<Self, NoMotor> {
        let prescribed = data.iter().any(|datum| datum.is_rotor_speed());
        let load = data.iter().any(|datum| datum.is_load());
        let machine = data.iter().find_map(|datum| datum.of_machine());
        let datum = machine.map(|place| scene.given.laws().data()[place].name.as_ref());
        let written = Written { motor: &scene.machine, load, datum };
        let approximation = written.approximation(prescribed)?;
        Ok(Letters { prescribed, load, machine, approximation })
    }
}

impl Region<'_> {
    /// The motor at one value of the first datum; computed once for all values if that datum does not belong to the
    /// motor.
    pub(super) fn ground(&self, first: f64) -> Result<Arc<Ground>, NoMotor> {
        if self.data[0].is_of_motor() {
            return self.ground_at(first).map(Arc::new);
        }
        self.common.get_or_init(|| self.ground_at(first).map(Arc::new)).clone()
    }

    fn ground_at(&self, first: f64) -> Result<Ground, NoMotor> {
        let here = self.general.with(self.data[0], first);
        let Letters { prescribed, load, machine, approximation } = &self.letters;
        let given = self.scene.given.with_data(here.data.machine.clone());
        let own = given.model(self.scene.machine.name()).map_err(NoMotor::Data)?;
        let motor = match prescribed {
            // W is given at each node
            true => MotorStates::Free,
            false => MotorStates::under(&own, here.load)?,
        };
        let mut letters = Vec::new();
        letters.extend(load.then(|| Rational::decimal(here.load)));
        letters.extend(machine.map(|place| Rational::decimal(here.data.machine[place])));
        if letters.iter().any(|value| value.sign() != Some(1) && value.sign() != Some(-1)) {
            // a datum that is zero may change the integrals
            let written = Written { motor: &own, load: false, datum: None };
            return Ok(Ground { motor, approximation: written.approximation(*prescribed)?, letters: Vec::new() });
        }
        Ok(Ground { motor, approximation: approximation.clone(), letters })
    }

    /// The rotor's steady states at which the torque is restoring, or at which two of them merge.
    pub(super) fn held<'a>(
        &self,
        ground: &'a Ground,
        here: &Setting,
        energies: &Energies<Rational>,
    ) -> Vec<HeldRotor<'a>> {
        let at = |value: Option<Root>, angle| value.map(|value| HeldRotor { kept: Kept::RelativeSpeed, value, angle });
        if self.letters.prescribed {
            let value = here.rotor_speed.and_then(|speed| Root::rational(Rational::decimal(speed)));
            return at(value, None).into_iter().collect();
        }
        match &ground.motor {
            MotorStates::Free => {
                let start = &here.data.start;
                let spin = start.angular_velocity.map(Rational::decimal).dot(&energies.mixed)
                    + Rational::decimal(start.rotor_speed) * energies.axial;
                let value = Root::rational(spin);
                value.map(|value| HeldRotor { kept: Kept::Momentum, value, angle: None }).into_iter().collect()
            }
            MotorStates::Kept { speed } => at(Some(speed.clone()), None).into_iter().collect(),
            MotorStates::InStep { speed, angles, .. } => {
                let back = angles.iter().filter(|angle| angle.slope <= 0);
                back.filter_map(|angle| at(Some(speed.clone()), Some(angle))).collect()
            }
            MotorStates::Slipping { speeds, .. } => {
                let back = speeds.iter().filter(|slip| slip.slope <= 0);
                back.filter_map(|slip| at(Some(slip.speed.clone()), None)).collect()
            }
        }
    }
}

impl Ground {
    /// The linearisation with the bodies of one node.
    pub fn approximation(&self, energies: &Energies<Rational>) -> Approximation {
        let Energies { tensor, mixed, axial, weight } = energies;
        let tensor = (0..3).flat_map(|i| (i..3).map(move |j| tensor[(i, j)]));
        let bodies = tensor.chain(mixed.iter().copied()).chain([*axial]).chain(weight.iter().copied());
        self.approximation.given(bodies.chain(self.letters.iter().copied()).collect(), energies)
    }
}

struct Written<'a> {
    motor: &'a Motor,
    load: bool,
    /// The datum that is a symbol.
    datum: Option<&'a str>,
}

impl Written<'_> {
    fn approximation(&self, prescribed: bool) -> Result<Approximation, NoMotor> {
        match prescribed {
            // the speed is one of the data
            true => self.with(&ConstantSpeed { speed: Sym::symbol("W") }, Vec::new()),
            false => {
                let machine = self.motor.over(|quantity, value| match self.datum == Some(quantity.name.as_ref()) {
                    true => Sym::symbol("datum"),
                    false => Sym::constant(Rational::decimal(value)),
                });
                let load = if self.load { Sym::symbol("load") } else { Sym::ZERO };
                let datum = self.datum.map(|_| Sym::symbol("datum"));
                let letters = self.load.then_some(load).into_iter().chain(datum).collect();
                self.with(&Loaded { machine, load }, letters)
            }
        }
    }

    fn with(&self, machine: &impl Machine<Sym>, letters: Vec<Sym>) -> Result<Approximation, NoMotor> {
        let letter = |name: &str, i: usize| Sym::symbol(&format!("{name}{}", i + 1));
        let tensor = |i: usize, j: usize| Sym::symbol(&format!("T{}{}", i.min(j) + 1, i.max(j) + 1));
        let energies = Energies {
            tensor: Matrix3::from_fn(tensor),
            mixed: Vector3::from_fn(|i, _| letter("h", i)),
            axial: Sym::symbol("axial"),
            weight: Vector3::from_fn(|i, _| letter("G", i)),
        };
        let bodies = (0..3).flat_map(|i| (i..3).map(move |j| tensor(i, j)));
        let bodies = bodies.chain(energies.mixed.iter().copied()).chain([energies.axial]);
        let all: Vec<Sym> = bodies.chain(energies.weight.iter().copied()).chain(letters).collect();
        Approximation::lettered(&energies, machine, &all)
    }
}
