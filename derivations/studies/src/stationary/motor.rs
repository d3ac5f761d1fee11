//! All steady states of a machine: speeds or angles at which its torque vanishes, exactly.

use algebra::real::{Polynomial, Root};
use field::{Circle, Rational, Scalar};
use motor::{Loaded, Machine, Motor, NoModel, RotorState, is_fed, steady_currents, torque_and_current_rates};
use symbolic::{Hypotheses, Sym, normal, univariate};

/// The steady states of a machine's rotor.
#[derive(Clone, Debug)]
pub enum MotorStates {
    /// Every speed is steady: the torque vanishes at all of them.
    Free,
    /// The prescribed speed, rad/s.
    Kept { speed: Root },
    /// Synchronous: the angles at which the torque vanishes, and whether a supply drives currents there.
    InStep { speed: Root, angles: Vec<Angle>, bears: Option<Bears>, fed: bool },
    /// Asynchronous: the speeds relative to the carrier at which the torque vanishes.
    Slipping { speeds: Vec<Slip>, extremes: Vec<Extreme> },
}

/// An angle of the rotor relative to the field.
#[derive(Clone, Debug)]
pub struct Angle {
    /// The tangent of half the angle; `None` at half a turn.
    pub half_tangent: Option<Root>,
    /// The sign of dM/dg: -1 for a restoring torque; 0 where two angles merge (pull-out, a saddle-node).
    pub slope: i32,
    /// The steady currents of a machine with a supply, A; empty otherwise.
    pub currents: Vec<f64>,
}

/// A speed of the rotor relative to the carrier.
#[derive(Clone, Debug)]
pub struct Slip {
    pub speed: Root,
    /// The sign of dM/dphi': -1 for a restoring torque; 0 where two speeds merge (pull-out, a saddle-node).
    pub slope: i32,
    /// Steady currents of a machine with a supply, A.
    pub currents: Vec<f64>,
}

/// The pull-out torques, N m, including friction at the field's speed. With an additional constant torque M the rotor
/// has a steady angle if least <= -M <= greatest; at either end two angles merge, beyond it no steady angle exists.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bears {
    pub least: f64,
    pub greatest: f64,
}

/// A local maximum or minimum of the torque over the speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The speed, rad/s.
    pub speed: f64,
    /// The torque, N m.
    pub torque: f64,
}

/// The reason why the steady states of a machine are not known.
#[derive(Clone, Debug, PartialEq)]
pub enum NoMotor {
    /// The data do not define a machine.
    Data(NoModel),
    /// The torque is not a rational function with rational coefficients.
    NotAlgebraic(String),
    /// The steady currents do not exist, or are not unique.
    NoRest,
    /// At the field's speed every angle is steady.
    AnyAngle,
}

impl std::fmt::Display for NoMotor {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Data(reason) => reason.fmt(f),
            Self::NotAlgebraic(reason) => {
                write!(f, "the motor's torque is not known as a fraction of polynomials: {reason}")
            }
            Self::AnyAngle => {
                write!(
                    f,
                    "at the field's speed every angle of the rotor is stationary: nothing holds it at one of them"
                )
            }
            Self::NoRest => write!(f, "a winding with a supply has no resistance: no current in it is stationary"),
        }
    }
}

impl std::error::Error for NoMotor {}

impl MotorStates {
    /// The steady states of a machine; its data are the decimals of the file.
    ///
    /// # Errors
    /// [`NoMotor`] with the reason why they are not known.
    pub fn of(motor: &Motor) -> Result<Self, NoMotor> {
        Self::under(motor, 0.0)
    }

    /// The steady states under a load: a constant torque (N m) against the rotor's rotation, taken as an exact decimal.
    ///
    /// # Errors
    /// [`NoMotor`] with the reason why they are not known.
    pub fn under(motor: &Motor, load: f64) -> Result<Self, NoMotor> {
        let machine = Loaded { machine: motor.decimals(), load: Sym::constant(Rational::decimal(load)) };
        let field_speed = machine.frame_speed();
        let kept = field_speed.as_constant().and_then(Root::rational);
        let kept = kept.ok_or_else(|| NoMotor::NotAlgebraic("the field's speed is no fraction".into()));
        match machine.rotor() {
            RotorState::Prescribed => Ok(MotorStates::Kept { speed: kept? }),
            RotorState::AngleAndSpeed => {
                in_step(kept?, is_fed(&machine), |angle| Resting::of(&machine, angle, Sym::ZERO))
            }
            RotorState::Speed => {
                let speed = Sym::symbol("speed");
                let angle = Circle { cos: Sym::int(1), sin: Sym::ZERO };
                slipping(&Resting::of(&machine, angle, speed - field_speed)?, speed)
            }
        }
    }

    /// The steady relative speeds of the rotor; `None` where every speed is steady.
    pub fn speeds(&self) -> Option<Vec<&Root>> {
        match self {
            MotorStates::Free => None,
            MotorStates::Kept { speed } => Some(vec![speed]),
            MotorStates::InStep { speed, angles, .. } if !angles.is_empty() => Some(vec![speed]),
            MotorStates::InStep { .. } => Some(Vec::new()),
            MotorStates::Slipping { speeds, .. } => Some(speeds.iter().map(|slip| &slip.speed).collect()),
        }
    }
}

impl Angle {
    /// The angle in radians, from -pi to pi.
    pub fn radians(&self) -> f64 {
        self.half_tangent.as_ref().map_or(std::f64::consts::PI, |t| 2.0 * t.to_f64().atan())
    }
}

/// The torque at steady currents, and these currents for machines with a supply.
struct Resting {
    torque: Sym,
    currents: Vec<Sym>,
}

impl Resting {
    fn of(machine: &impl Machine<Sym>, angle: Circle<Sym>, slip: Sym) -> Result<Self, NoMotor> {
        let mut currents = steady_currents(machine, angle, slip).ok_or(NoMotor::NoRest)?;
        let torque = torque_and_current_rates(machine, angle, slip, &currents, &mut vec![Sym::ZERO; currents.len()]);
        currents.retain(|_| is_fed(machine));
        Ok(Resting { torque, currents })
    }

    /// Torque and currents as rational functions of one unknown.
    fn fractions(&self, unknown: Sym) -> Result<(Fraction, Vec<Fraction>), NoMotor> {
        let currents = self.currents.iter().map(|&current| Fraction::of(current, unknown)).collect::<Result<_, _>>()?;
        Ok((Fraction::of(self.torque, unknown)?, currents))
    }
}

/// A rational function of one unknown.
pub(crate) struct Fraction {
    pub numerator: Polynomial,
    pub denominator: Polynomial,
}

impl Fraction {
    pub fn of(expression: Sym, unknown: Sym) -> Result<Self, NoMotor> {
        let wrong = |reason: String| NoMotor::NotAlgebraic(reason);
        let form = normal(expression, &Hypotheses::none()).map_err(|reason| wrong(reason.to_string()))?;
        let dense = |part: Sym| univariate(part, unknown).map_err(|reason| wrong(reason.to_string()));
        // both over one common denominator, which preserves their ratio
        let (above, below) = (dense(form.numerator())?, dense(form.denominator())?);
        let split = above.len();
        let all: Vec<Rational> = above.into_iter().chain(below).collect();
        let (mut whole, _) = algebra::real::Number::over_common(&all).ok_or_else(|| wrong("a datum".into()))?;
        let denominator = Polynomial::new(whole.split_off(split));
        Ok(Fraction { numerator: Polynomial::new(whole), denominator })
    }

    /// The numerator of the derivative, whose denominator is a square.
    fn slope(&self) -> Polynomial {
        &(&self.numerator.derivative() * &self.denominator) - &(&self.numerator * &self.denominator.derivative())
    }

    /// The roots at which the function is defined.
    fn roots(&self) -> impl Iterator<Item = Root> + '_ {
        self.numerator.real_roots().into_iter().filter(|root| root.sign_of(&self.denominator) != 0)
    }

    fn value(&self, at: &Root) -> Option<f64> {
        [128, 512, 2048].into_iter().find_map(|bits| {
            let x = at.enclosure(bits);
            let value = self.numerator.enclosure(&x, bits).over(&self.denominator.enclosure(&x, bits))?;
            (value.radius() <= 1e-17 * value.to_f64().abs() || bits > 512).then(|| value.to_f64())
        })
    }
}

fn in_step(
    speed: Root,
    fed: bool,
    resting: impl Fn(Circle<Sym>) -> Result<Resting, NoMotor>,
) -> Result<MotorStates, NoMotor> {
    let t = Sym::symbol("t");
    let (of_angle, currents) = resting(Circle::from_half_tangent(t))?.fractions(t)?;
    // near half a turn the angle is pi - 2 u for the half tangent 1/u
    let half_turn = Circle { cos: Sym::int(-1), sin: Sym::ZERO };
    let (turned, turned_currents) = resting(half_turn - Circle::from_half_tangent(t))?.fractions(t)?;
    if of_angle.numerator.is_zero() {
        return Err(NoMotor::AnyAngle);
    }
    let slope = of_angle.slope();
    let angle = |root: Root| Angle {
        slope: root.sign_of(&slope),
        currents: values(&currents, &root),
        half_tangent: Some(root),
    };
    let mut angles: Vec<Angle> = of_angle.roots().map(angle).collect();
    let zero = Root::rational(Rational::int(0));
    let at_zero = |p: &Polynomial| zero.as_ref().map_or(0, |zero| zero.sign_of(p));
    if at_zero(&turned.numerator) == 0 {
        // pi - 2u decreases with u
        let currents = zero.as_ref().map_or_else(Vec::new, |zero| values(&turned_currents, zero));
        angles.push(Angle { half_tangent: None, slope: -at_zero(&turned.slope()), currents });
    }
    let extremes = slope.real_roots();
    let values =
        extremes.iter().filter_map(|at| of_angle.value(at)).chain(zero.as_ref().and_then(|at| turned.value(at)));
    let bears = values.fold(None, |range: Option<Bears>, torque| {
        let range = range.unwrap_or(Bears { least: torque, greatest: torque });
        Some(Bears { least: range.least.min(torque), greatest: range.greatest.max(torque) })
    });
    Ok(MotorStates::InStep { speed, angles, bears, fed })
}

fn slipping(resting: &Resting, speed: Sym) -> Result<MotorStates, NoMotor> {
    let (of_speed, currents) = resting.fractions(speed)?;
    if of_speed.numerator.is_zero() {
        return Ok(MotorStates::Free);
    }
    let slope = of_speed.slope();
    let slip = |root: Root| Slip { slope: root.sign_of(&slope), currents: values(&currents, &root), speed: root };
    let speeds = of_speed.roots().map(slip).collect();
    let extremes = slope.real_roots();
    let extremes =
        extremes.iter().filter_map(|at| Some(Extreme { speed: at.to_f64(), torque: of_speed.value(at)? })).collect();
    Ok(MotorStates::Slipping { speeds, extremes })
}

/// The values of functions; empty where one has no value.
fn values(fractions: &[Fraction], at: &Root) -> Vec<f64> {
    fractions.iter().map(|fraction| fraction.value(at)).collect::<Option<_>>().unwrap_or_default()
}
