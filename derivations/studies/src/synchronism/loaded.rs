//! A motor on a bench whose load is a constant component of the state, for the continuation of equilibria and slipping
//! motions over the load.

use crate::scene::{Scene, Setup, Start};
use field::{Analytic, Circle, Over};
use integrators::Ode;
use motor::{Bench, Machine, Motor, RotorState, is_fed};
use simulation::{CompiledLaw, Law, SymbolicLaw};
use std::f64::consts::TAU;
use std::fmt;
use std::sync::Arc;
use systems::gyrostat::Gyrostat;

/// The law of a bench with the load torque, N m, as the last component of the state.
#[derive(Clone, Debug)]
pub struct UnderLoad(pub Bench<f64, Motor>);

impl<S: Over<f64> + Analytic> Ode<S> for UnderLoad {
    fn dimension(&self) -> usize {
        self.0.dimension() + 1
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        if let ([state @ .., load], [rates @ .., resting]) = (y, dy) {
            self.0.rates_under(*load, state, rates);
            *resting = S::zero();
        }
    }
}

/// A motor whose state contains the angle relative to its field, with its law under load and its characteristic
/// quantities.
#[derive(Clone)]
pub struct Loaded {
    pub machine: Motor,
    /// The rotor's moment of inertia about its axis, kg m^2.
    pub axial: f64,
    /// The law; its state is (angle, slip, currents, load).
    pub law: Arc<dyn Law>,
    pub facts: Facts,
    pub(super) own: Arc<UnderLoad>,
}

/// The characteristic quantities of a motor.
#[derive(Clone, Debug, PartialEq)]
pub struct Facts {
    /// The angular velocity W of the field, rad/s.
    pub field_speed: f64,
    /// The torque of friction at synchronism, N m.
    pub friction: f64,
    /// The pull-out torque b, N m, of the field U = -b cos g whose energy has the same range as that of the motor.
    pub hold: f64,
    /// The angular frequency sqrt(b / A') of small oscillations about synchronism, 1/s.
    pub frequency: f64,
    /// The angle of least field energy, rad.
    pub bottom: f64,
    /// The typical magnitudes of angle, slip, currents and load, for scaling.
    pub sizes: Vec<f64>,
}

impl UnderLoad {
    /// The torque M without currents, N m.
    pub(super) fn torque(&self, angle: f64, slip: f64) -> f64 {
        let machine = &self.0.machine;
        let speed = slip + machine.frame_speed();
        machine.torque_law(slip, speed) - machine.field_energy(angle.circle().moving(1.0)).slope
    }

    /// The function V of [`height`](super::energy::height) at a state that includes the load.
    pub(super) fn height(&self, y: &[f64]) -> f64 {
        y.split_last().map_or(f64::NAN, |(load, state)| super::energy::height(&self.0, *load, state))
    }
}

/// The reason why synchronism cannot be studied for a motor.
#[derive(Clone, Debug, PartialEq)]
pub enum NoField {
    /// The state of the machine does not contain an angle relative to its field.
    NoAngle { model: &'static str },
    /// A supply drives its currents, hence no energy decides synchronism.
    Fed { model: &'static str },
    /// The field energy does not depend on the angle.
    Flat { model: &'static str },
}

impl fmt::Display for NoField {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoAngle { model } => write!(
                f,
                "`{model}` does not follow its field by the angle, so that there is no step to fall out of; a synchronous machine \
                 is accepted: synchronous, equivalent_windings, multi_current"
            ),
            Self::Fed { model } => write!(
                f,
                "the field holds the rotor of `{model}` through currents that a supply feeds, so that no energy decides which starts come into \
                 step; a machine without a supply is accepted: synchronous, equivalent_windings, multi_current"
            ),
            Self::Flat { model } => {
                write!(
                    f,
                    "the field of `{model}` does not hold its rotor: every angle is an equilibrium; b0 > 0 of a synchronous machine is accepted"
                )
            }
        }
    }
}

impl std::error::Error for NoField {}

impl Loaded {
    /// The motor of a scene on a bench: only the rotor moves, the housing is at rest.
    ///
    /// # Errors
    /// [`NoField`] gives the reason why synchronism cannot be studied.
    pub fn of(scene: &Scene) -> Result<Self, NoField> {
        let axial = match &scene.system {
            Setup::Bench { axial } => *axial,
            Setup::Gyrostat(bodies) => bodies.rotor.axial,
        };
        Loaded::new(&scene.machine, axial)
    }

    /// The motor with a rotor of this moment of inertia, kg m^2.
    ///
    /// # Errors
    /// [`NoField`] gives the reason why synchronism cannot be studied.
    pub fn new(machine: &Motor, axial: f64) -> Result<Self, NoField> {
        if machine.rotor() != RotorState::AngleAndSpeed {
            return Err(NoField::NoAngle { model: machine.name() });
        }
        if is_fed(machine) {
            return Err(NoField::Fed { model: machine.name() });
        }
        let angles = || (0..SAMPLES).map(|i| TAU * f64::from(i) / f64::from(SAMPLES));
        let half_range = |of: &dyn Fn(Circle<f64>) -> f64| {
            let (low, high) = angles()
                .map(|angle| of(angle.circle()))
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
            0.5 * (high - low)
        };
        let energy = |angle: f64| machine.field_energy(angle.circle());
        let hold = half_range(&|angle| machine.field_energy(angle));
        if !(hold > 0.0 && hold.is_finite()) {
            return Err(NoField::Flat { model: machine.name() });
        }
        let bottom = angles().fold(0.0, |best, angle| if energy(angle) < energy(best) { angle } else { best });
        let frequency = (hold / axial).sqrt();
        let mut sizes = vec![1.0, frequency];
        sizes.extend((0..machine.windings()).map(|k| {
            let flux = half_range(&|angle| machine.linkage(k, angle));
            if flux > 0.0 { flux / machine.inductance(k) } else { 1.0 }
        }));
        sizes.push(hold);
        let field_speed = machine.frame_speed();
        let friction = -machine.torque_law(0.0, field_speed);
        let facts = Facts { field_speed, friction, hold, frequency, bottom, sizes };
        let law = Arc::new(UnderLoad(Bench { machine: machine.clone(), axial }));
        let compiled = Arc::new(CompiledLaw::of(Arc::clone(&law) as Arc<dyn SymbolicLaw>));
        Ok(Loaded { machine: machine.clone(), axial, law: compiled, facts, own: law })
    }
}

/// The scene's motor with another number of bars, represented by the equivalent windings, which have exactly the same
/// torque; `None` if the motor has no bars.
pub fn with_bars(scene: &Scene, bars: usize) -> Option<Scene> {
    let given = scene.given.with_count("bars", bars).ok()?;
    let machine = given.model("equivalent_windings").ok()?;
    let start = Start { currents: Vec::new(), ..scene.start.clone() };
    Some(Scene { machine, given, start, ..scene.clone() })
}

/// The scene's motor without currents, with the dimensionless damping f / sqrt(A' b); `None` if the data do not
/// suffice.
pub fn with_damping(scene: &Scene, damping: f64) -> Option<Scene> {
    let plain = scene.with_model("synchronous").ok()?;
    let motor = Loaded::of(&plain).ok()?;
    let given = plain.given.with("f", damping * motor.axial * motor.facts.frequency)?;
    Some(Scene { machine: given.model("synchronous").ok()?, given, ..plain })
}

/// The effective moment of inertia, kg m^2, of the rotor in a free carrier under a torque between the two: 1 / (1/A' +
/// l.A^-1 l). The page `synchronism` proves this formula.
pub fn giving_way(bodies: &Gyrostat<f64>) -> f64 {
    let (axis, axial) = (bodies.rotor.axis, bodies.rotor.axial);
    let carrier = bodies.reduced_tensor().lu().solve(&axis).map_or(0.0, |response| axis.dot(&response));
    1.0 / (1.0 / axial + carrier)
}

/// The number of angles of one turn at which energy and fluxes are sampled.
const SAMPLES: u32 = 256;
