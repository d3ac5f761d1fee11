//! Equations of motion for reading: derived by a chosen principle, brought to normal form, solved for nothing.

use crate::exact_turns::with_exact_turns;
use crate::konosevich2022::Letters;
use field::Circle;
use mechanics::rotation::{euler, vertical};
use motor::{Machine, Motor, drive};
use symbolic::{Hypotheses, Sym, coefficients, normal};
use systems::gyrostat::Motion;

/// A system that can be derived: name, and what it is.
pub const SYSTEMS: &[(&str, &str)] = &[
    ("gyrostat", "carrier and rotor in the principal axes of A, under the moment M on the rotor"),
    ("motor", "the synchronous motor with three damper bars, alone: moment and currents"),
];

/// A principle of mechanics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Principle {
    /// Angular momentum of the mass points, about O and about the rotor's axis.
    Momentum,
    /// Appell's equations from the acceleration energy.
    Appell,
    /// Boltzmann and Hamel: Lagrange in quasi-velocities.
    Hamel,
    /// Lagrange II in Euler's angles.
    Lagrange,
    /// Lagrange and Maxwell, with charges as coordinates: for motors.
    Maxwell,
    /// Newton's and Euler's equations projected onto partial velocities: for systems that are written in their files.
    VirtualPower,
    /// The least constraint: for systems that are written in their files.
    Gauss,
}

/// An equation: what is multiplied by accelerations (or rates of currents) on the left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equation {
    pub left: Sym,
    pub right: Sym,
}

/// Why nothing was derived.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotDerived {
    /// There is no such system.
    UnknownSystem(String),
    /// The principle does not apply to the system.
    Inapplicable { system: &'static str, accepted: &'static str },
    /// The normal form was given up.
    TooLarge(String),
}

impl std::fmt::Display for NotDerived {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::UnknownSystem(name) => {
                let known: Vec<&str> = SYSTEMS.iter().map(|(name, _)| *name).collect();
                write!(f, "there is no system `{name}`; there are: {}", known.join(", "))
            }
            Self::Inapplicable { system, accepted } => write!(f, "for `{system}` the principle may be: {accepted}"),
            Self::TooLarge(reason) => write!(f, "the equations have no normal form: {reason}"),
        }
    }
}

impl std::error::Error for NotDerived {}

/// The equations of a system by a principle.
///
/// # Errors
/// [`NotDerived`] says what would be accepted.
pub fn derive(system: &str, principle: Option<Principle>) -> Result<Vec<Equation>, NotDerived> {
    let s = Letters::default();
    match system {
        "gyrostat" => gyrostat(&s, principle.unwrap_or(Principle::Momentum)),
        "motor" => motor(&s, principle.unwrap_or(Principle::Maxwell)),
        other => Err(NotDerived::UnknownSystem(other.into())),
    }
}

fn gyrostat(s: &Letters, principle: Principle) -> Result<Vec<Equation>, NotDerived> {
    let g = s.in_axes_of_a();
    let angles = ["ψ", "θ", "φ", "φ′"].map(crate::konosevich2022::letter);
    let mut accelerations = vec![s.dw.x, s.dw.y, s.dw.z, s.ddphi];
    let residuals = match principle {
        Principle::Momentum => g.by_momentum(&s.motion()),
        Principle::Appell => g.by_appell(&s.motion()),
        Principle::Hamel => {
            let at = vertical(&euler([angles[0], angles[1], angles[2]]));
            g.by_hamel(angles, &Motion { vertical: at, ..s.motion() })
        }
        Principle::Lagrange => {
            let rates = ["ψ̇", "θ̇", "φ̇", "φ̇′"].map(crate::konosevich2022::letter);
            let second = ["ψ̈", "θ̈", "φ̈", "φ̈′"].map(crate::konosevich2022::letter);
            accelerations = second.to_vec();
            g.by_lagrange(angles, rates, second, s.moment)
        }
        Principle::Maxwell | Principle::VirtualPower | Principle::Gauss => {
            return Err(NotDerived::Inapplicable { system: "gyrostat", accepted: "momentum, appell, hamel, lagrange" });
        }
    };
    residuals.into_iter().map(|residual| split(residual, &accelerations, &s.unit_axis)).collect()
}

fn motor(s: &Letters, principle: Principle) -> Result<Vec<Equation>, NotDerived> {
    if principle != Principle::Maxwell {
        return Err(NotDerived::Inapplicable { system: "motor", accepted: "maxwell" });
    }
    let bars = 3;
    of_machine(s, &s.motor(bars), &s.currents(bars))
}

/// The motor of a scene, its parameters by their names: moment and currents by Lagrange and Maxwell.
///
/// # Errors
/// [`NotDerived::TooLarge`].
pub fn motor_of(motor: &Motor) -> Result<Vec<Equation>, NotDerived> {
    let motor = motor.letters();
    let currents: Vec<Sym> = (0..motor.windings()).map(|k| Sym::symbol(&motor.current_name(k))).collect();
    of_machine(&Letters::default(), &motor, &currents)
}

/// M and L di/dt of any motor.
fn of_machine(s: &Letters, machine: &impl Machine<Sym>, currents: &[Sym]) -> Result<Vec<Equation>, NotDerived> {
    let mut rates = vec![Sym::ZERO; currents.len()];
    let angle: Circle<Sym> = s.angle();
    let moment = drive(machine, angle, s.dgamma, currents, &mut rates);
    let mut equations =
        vec![Equation { left: s.moment, right: simplified(with_exact_turns(moment), &Hypotheses::none())? }];
    for (k, (current, rate)) in currents.iter().zip(rates).enumerate() {
        let inductance = machine.inductance(k);
        let name = Sym::named(&format!("d{current}/dt"), &format!(r"\frac{{d{}}}{{dt}}", current.latex()));
        equations.push(Equation {
            left: inductance * name,
            right: simplified(with_exact_turns(inductance * rate), &Hypotheses::none())?,
        });
    }
    Ok(equations)
}

fn simplified(expression: Sym, rules: &Hypotheses) -> Result<Sym, NotDerived> {
    normal(expression, rules).map(|form| form.to_sym()).map_err(|reason| NotDerived::TooLarge(reason.to_string()))
}

/// residual = 0 with the accelerations on the left; a common denominator is multiplied away.
fn split(residual: Sym, accelerations: &[Sym], rules: &Hypotheses) -> Result<Equation, NotDerived> {
    let form = normal(residual, rules).map_err(|reason| NotDerived::TooLarge(reason.to_string()))?;
    let terms =
        coefficients(form.numerator(), accelerations).map_err(|reason| NotDerived::TooLarge(reason.to_string()))?;
    let (mut left, mut right) = (Sym::ZERO, Sym::ZERO);
    for (exponents, coefficient) in terms {
        let mut term = simplified(coefficient, rules)?;
        if exponents.iter().all(|&e| e == 0) {
            right -= term;
            continue;
        }
        for (acceleration, exponent) in accelerations.iter().zip(exponents) {
            if exponent > 0 {
                term *= acceleration.powi(exponent as i32);
            }
        }
        left += term;
    }
    Ok(Equation { left, right: simplified(right, rules)? })
}
