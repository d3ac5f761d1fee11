//! The linearised motion near a steady one, with exact data: its matrix by differentiation of the law.
//!
//! The matrix is symbolic; at a motion its entries are enclosed. Eigenvalues known from the structure are split off
//! exactly:
//! * an integral I of the law f has I' f = 0 everywhere, hence I' A = 0 where f = 0: an eigenvalue 0 for each. The
//!   integrals are v.v and x.v of every gyrostat, and the own momentum of a free rotor;
//! * without slip and currents, a winding k enters only through its contribution psi_k' i_k to the torque, and
//!   contributions with equal decay rates R/L add up to one unknown: n such windings have n - 1 eigenvalues exactly
//!   -R/L; with a supply, the currents are separate states;
//! * if energy is conserved the motion is Hamiltonian on the leaf of the integrals: eigenvalues come in pairs mu, -mu.

use super::symbolic_linearisation::linearised;
use crate::scene::Scene;
use crate::stationary::motor::{MotorStates, NoMotor};
use algebra::real::Enclosure;
use field::Rational;
use mechanics::linear_stability::characteristic;
use mechanics::one_step_stability::{HalfPlane, Mode, Spectrum};
use symbolic::{Hypotheses, Sym, coefficients, normal};

/// The symbolic matrix of a scene's linearised motion near any steady one.
#[derive(Debug)]
pub struct Linearised {
    pub(super) matrix: Vec<Vec<Sym>>,
    /// The steady currents at the motion, for machines with a supply.
    pub(super) resting: Vec<Sym>,
    /// The symbols w, v, cos g, sin g, g'.
    pub(super) symbols: Vec<Sym>,
    /// The frame speed W, rad/s.
    pub(super) field_speed: Rational,
    /// Decay rates of windings, 1/s, each with the number of eigenvalues that are exactly its negative.
    pub idle: Vec<(Rational, usize)>,
    /// The number of eigenvalues that are zero because of integrals.
    pub integrals: usize,
    /// Whether energy is conserved.
    pub symmetric: bool,
}

/// The enclosed data of a steady motion.
#[derive(Clone, Debug)]
pub struct At {
    /// The angular velocity w, rad/s, and the vertical v.
    pub angular_velocity: [Enclosure; 3],
    pub vertical: [Enclosure; 3],
    /// The angle g as a point of the unit circle.
    pub angle: [Enclosure; 2],
    /// The relative rotor speed phi', rad/s.
    pub rotor_speed: Enclosure,
}

/// The reason why there is no linearisation.
#[derive(Clone, Debug, PartialEq)]
pub enum NoLinear {
    Motor(NoMotor),
    /// The rotor has windings, but no angle as a state.
    Windings,
    /// The bodies' inertia is not positive.
    Inertia,
    /// An entry is not rational.
    NotAlgebraic(Sym),
}

impl std::fmt::Display for NoLinear {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Motor(reason) => reason.fmt(f),
            Self::Windings => write!(f, "windings on a rotor whose angle is no state have no stationary currents"),
            Self::Inertia => write!(f, "the inertia of the bodies is not positive"),
            Self::NotAlgebraic(entry) => write!(f, "not a fraction of polynomials: {entry}"),
        }
    }
}

impl std::error::Error for NoLinear {}

impl Linearised {
    /// The linearisation of a scene; its data are the decimals of the file.
    ///
    /// # Errors
    /// [`NoLinear`] where there is no linearisation.
    pub fn of(scene: &Scene, motor: &MotorStates) -> Result<Self, NoLinear> {
        let free = matches!(motor, MotorStates::Free);
        linearised(&scene.system, &scene.machine, free)
    }

    /// The characteristic polynomial det(mu - A) at a motion, without the eigenvalues known from the structure, monic,
    /// with coefficients from the constant upwards. `None` where an entry is undefined, or a presumed integral is not
    /// conserved.
    pub fn polynomial(&self, at: &At, bits: usize) -> Option<Vec<Enclosure>> {
        let places = self.places(at, bits)?;
        let row = |row: &Vec<Sym>| row.iter().map(|entry| value(*entry, &self.symbols, &places, bits)).collect();
        let matrix: Vec<Vec<Enclosure>> = self.matrix.iter().map(row).collect::<Option<_>>()?;
        let mut polynomial: Vec<Enclosure> =
            characteristic(&matrix, &Enclosure::integer(1, bits)).into_iter().rev().collect();
        let rest = polynomial.split_off(self.integrals);
        polynomial.iter().all(|c| c.sign().is_none_or(|sign| sign == 0)).then_some(rest)
    }

    /// The values of the symbols at a motion.
    fn places(&self, at: &At, bits: usize) -> Option<Vec<Enclosure>> {
        let slip = &at.rotor_speed - &Enclosure::rational(self.field_speed, bits)?;
        Some([&at.angular_velocity[..], &at.vertical, &at.angle, &[slip]].concat())
    }

    /// The currents at a motion, A; empty without a supply.
    pub fn currents(&self, at: &At, bits: usize) -> Option<Vec<f64>> {
        let places = self.places(at, bits)?;
        self.resting.iter().map(|&i| value(i, &self.symbols, &places, bits).map(|i| i.to_f64())).collect()
    }

    /// The eigenvalues without those of the integrals; those of groups of windings come last.
    pub fn spectrum(&self, at: &At, bits: usize) -> Option<Spectrum> {
        let mut spectrum = Spectrum::of(&self.polynomial(at, bits)?, self.symmetric)?;
        for (rate, count) in &self.idle {
            spectrum.modes.push(Mode { place: HalfPlane::Real(Enclosure::rational(-*rate, bits)?), count: *count });
        }
        Some(spectrum)
    }
}

/// The value of a rational expression in the symbols; the torque contributions of the windings are zero at the motion.
fn value(entry: Sym, symbols: &[Sym], places: &[Enclosure], bits: usize) -> Option<Enclosure> {
    let sum = |part: Sym| {
        let mut sum = Enclosure::integer(0, bits);
        for (exponents, c) in coefficients(part, symbols).ok()? {
            let mut term = Enclosure::rational(c.as_constant()?, bits)?;
            for (place, power) in places.iter().zip(exponents) {
                for _ in 0..power {
                    term = &term * place;
                }
            }
            sum = &sum + &term;
        }
        Some(sum)
    };
    sum(entry).or_else(|| {
        let form = normal(entry, &Hypotheses::none()).ok()?;
        sum(form.numerator())?.over(&sum(form.denominator())?)
    })
}
