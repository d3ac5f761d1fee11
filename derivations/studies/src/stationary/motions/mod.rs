//! All steady motions of a scene, for a given angular velocity or angular momentum about the vertical.

mod decimals;
mod found;
mod refused;

pub use decimals::{decimals, written};
pub use found::{Answer, Certificate, Found, Members};
pub use refused::NoAnswer;

use super::energies::{Energies, Kept};
use super::motor::{MotorStates, Slip};
use super::stability::Approximation;
use super::stability::along::{Along, Known};
use super::stability::judge::{Given, Judge};
use crate::scene::{Scene, Setup, Start};
use algebra::real::{Enclosure, Root};
use field::Rational;
use mechanics::steady_rotations::{Body, Census, Kind, Shape, SteadyRotation, Turning, Undecided};
use nalgebra::Vector3;
use simulation::Axes;
use systems::gyrostat::Gyrostat;

/// A scene's gyrostat and motor, prepared for the search of steady motions.
pub struct Stationary<'a> {
    scene: &'a Scene,
    bodies: &'a Gyrostat<f64>,
    pub energies: Energies<Rational>,
    approximation: Approximation,
    pub motor: MotorStates,
    pub kept: Kept,
    pub cases: Vec<Case>,
}

/// One constant value of the rotor's conserved or prescribed quantity.
pub struct Case {
    /// The relative speed, rad/s; for a free rotor its own angular momentum, N m s.
    pub value: Root,
    pub body: Body,
}

impl Case {
    fn of(energies: &Energies<Rational>, kept: Kept, value: Root) -> Option<Self> {
        let (tensor, share) = energies.quadratic(kept);
        let body = Body::new(&tensor, &share, &value, &energies.weight)?;
        Some(Case { value, body })
    }

    /// The case for a figure, where a relative error of 2^-53 is invisible: an irrational value (Kloss' torque) is
    /// rounded to double precision, since exact results at hundreds of points in its number field take minutes.
    pub fn drawn(&self, energies: &Energies<Rational>, kept: Kept) -> Option<Self> {
        let value = self.value.as_rational().unwrap_or_else(|| Rational::exactly(self.value.to_f64()));
        Case::of(energies, kept, Root::rational(value)?)
    }
}

/// The precision of directions, bits.
const BITS: usize = 64;

impl<'a> Stationary<'a> {
    /// Prepares a scene; its data are the decimals of the file.
    ///
    /// # Errors
    /// [`NoAnswer`] with the reason why its steady motions cannot be found.
    pub fn of(scene: &'a Scene) -> Result<Self, NoAnswer> {
        let Setup::Gyrostat(bodies) = &scene.system else { return Err(NoAnswer::Bench) };
        let motor = MotorStates::of(&scene.machine).map_err(NoAnswer::Motor)?;
        let energies = Energies::of(&decimals(bodies));
        let approximation = Approximation::of(&energies, &scene.machine).map_err(NoAnswer::Motor)?;
        let (kept, values) = match motor.speeds() {
            Some(speeds) => (Kept::RelativeSpeed, speeds.into_iter().cloned().collect()),
            None => {
                let spin = scene.start.angular_velocity.map(Rational::decimal).dot(&energies.mixed)
                    + Rational::decimal(scene.start.rotor_speed) * energies.axial;
                (Kept::Momentum, Root::rational(spin).into_iter().collect::<Vec<_>>())
            }
        };
        let case = |value| Case::of(&energies, kept, value).ok_or(NoAnswer::TooFine);
        let cases = values.into_iter().map(case).collect::<Result<_, _>>()?;
        Ok(Stationary { scene, bodies, energies, approximation, motor, kept, cases })
    }

    /// All steady motions with the angular velocity w (rad/s) about the vertical.
    ///
    /// # Errors
    /// [`NoAnswer`] with the reason why they cannot be found.
    pub fn at_speed(&self, w: f64) -> Result<Vec<Answer>, NoAnswer> {
        self.cases.iter().map(|case| self.answer_at_speed(case, w)).collect()
    }

    fn answer_at_speed(&self, case: &Case, w: f64) -> Result<Answer, NoAnswer> {
        let exactly = Rational::decimal(w);
        let all = case.body.rotations(exactly).ok_or(NoAnswer::NotFinite(w))?;
        let boxes = all.boxes(BITS).ok_or(NoAnswer::TooFine)?;
        let of_motion = |(motion, enclosed): (&SteadyRotation, [Enclosure; 3])| {
            let raw = Raw {
                shape: motion.shape,
                kind: motion.kind,
                given: Given::Speed(exactly),
                multiplier: Some(motion.interval().ok_or(NoAnswer::TooFine)?),
                enclosed: &|bits| Some((motion.direction(bits)?, Enclosure::rational(exactly, bits)?)),
                axis: &|bits| motion.axis(bits),
            };
            self.found(case, &raw, enclosed, w)
        };
        let found = all.motions.iter().zip(boxes).map(of_motion).collect::<Result<_, _>>()?;
        let certificate = Certificate {
            degree: all.degree,
            roots: all.roots,
            again: Some(all.roots_by_sturm()),
            morse: all.morse(),
            undecided: None,
        };
        Ok(Answer { value: case.value.to_f64(), found, certificate })
    }

    /// All steady motions with the angular momentum p (N m s) about the vertical.
    ///
    /// # Errors
    /// [`NoAnswer`] with the reason why they cannot be found.
    pub fn at_momentum(&self, p: f64) -> Result<Vec<Answer>, NoAnswer> {
        self.cases.iter().map(|case| self.answer_at_momentum(case, p)).collect()
    }

    fn answer_at_momentum(&self, case: &Case, p: f64) -> Result<Answer, NoAnswer> {
        // a rotor with its own conserved momentum contributes its part of the whole
        let exactly = Rational::decimal(p);
        let all = case.body.at_momentum(exactly).ok_or(NoAnswer::NotFinite(p))?;
        let of_motion = |motion: &Turning| {
            let (enclosed, w) = motion.direction_and_speed(BITS).ok_or(NoAnswer::TooFine)?;
            let raw = Raw {
                shape: motion.shape,
                kind: motion.kind,
                given: Given::Momentum(exactly),
                multiplier: None,
                enclosed: &|bits| motion.direction_and_speed(bits),
                axis: &|bits| motion.axis(bits),
            };
            self.found(case, &raw, enclosed, w.to_f64())
        };
        let found = all.motions.iter().map(of_motion).collect::<Result<_, _>>()?;
        let certificate =
            Certificate { degree: all.degree, roots: all.roots, again: None, morse: None, undecided: all.undecided };
        Ok(Answer { value: case.value.to_f64(), found, certificate })
    }

    /// The stability along a family with the angular velocity w (rad/s), for each angle of the rotor.
    pub fn along(&self, case: &Case, family: &SteadyRotation, w: Rational) -> Vec<Along> {
        let enclosed = |bits| Some((family.direction(bits)?, Enclosure::rational(w, bits)?));
        let axis = |bits| family.axis(bits);
        self.judge(case, Given::Speed(w)).along(&Known { shape: family.shape, enclosed: &enclosed, axis: &axis })
    }

    fn judge<'b>(&'b self, case: &'b Case, given: Given) -> Judge<'b> {
        let Stationary { approximation, energies, motor, kept, .. } = self;
        Judge { approximation, energies, motor, kept: *kept, value: &case.value, given }
    }

    /// The number of steady motions at every angular velocity, case by case.
    pub fn census(&self) -> Vec<Result<Census, Undecided>> {
        self.cases.iter().map(|case| case.body.census()).collect()
    }

    /// The angular momentum about the vertical at the scene's start, N m s.
    pub fn momentum_at_start(&self) -> f64 {
        let start = &self.scene.start;
        self.momentum(start.angular_velocity, start.rotor_speed, start.vertical)
    }

    fn momentum(&self, w: Vector3<f64>, rotor_speed: f64, v: Vector3<f64>) -> f64 {
        self.bodies.angular_momentum(w, rotor_speed)[0].dot(&v)
    }

    /// A motion with its stability, and its residual in the integrated equations.
    fn found(&self, case: &Case, raw: &Raw<'_>, enclosed: [Enclosure; 3], speed: f64) -> Result<Found, NoAnswer> {
        let judge = self.judge(case, raw.given);
        let plain = |v: &[Enclosure; 3]| Vector3::from(v.each_ref().map(Enclosure::to_f64));
        let centre = plain(&enclosed);
        let (direction, stability, family) = match raw.shape {
            Shape::Point | Shape::Pair { .. } => (centre, judge.verdicts(raw.enclosed), None),
            Shape::Circle { .. } | Shape::Sphere => {
                let circle = match raw.shape {
                    Shape::Circle { .. } => {
                        let axis = (raw.axis)(BITS).ok_or(NoAnswer::TooFine)?;
                        Some(((1.0 - centre.norm_squared()).max(0.0).sqrt(), plain(&axis)))
                    }
                    _ => None,
                };
                let known = Known { shape: raw.shape, enclosed: raw.enclosed, axis: raw.axis };
                let member = judge.member(&known, BITS).ok_or(NoAnswer::TooFine)?;
                (plain(&member), Vec::new(), Some(Members { circle, along: judge.along(&known) }))
            }
        };
        let w = direction * speed;
        let value = case.value.to_f64();
        let rotor_speed = match self.kept {
            Kept::RelativeSpeed => value,
            Kept::Momentum => {
                let energies = Energies::of(self.bodies);
                (value - energies.mixed.dot(&w)) / energies.axial
            }
        };
        Ok(Found {
            shape: raw.shape,
            kind: raw.kind,
            multiplier: raw.multiplier,
            enclosed,
            direction,
            speed,
            rotor_speed,
            momentum: self.momentum(w, rotor_speed, direction),
            stability,
            family,
            residual: self.residual(w, direction, rotor_speed),
        })
    }

    /// The largest rate at a steady state by the integrated equations, as an independent check.
    fn residual(&self, w: Vector3<f64>, v: Vector3<f64>, rotor_speed: f64) -> f64 {
        let places: Vec<(f64, &[f64])> = match &self.motor {
            MotorStates::InStep { angles, .. } => {
                angles.iter().map(|angle| (angle.radians(), &angle.currents[..])).collect()
            }
            MotorStates::Slipping { speeds, .. } => {
                let off = |slip: &&Slip| (slip.speed.to_f64() - rotor_speed).abs();
                let own = speeds.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
                vec![(0.0, own.map_or(&[], |slip| &slip.currents[..]))]
            }
            _ => vec![(0.0, &[])],
        };
        let of_place = |(rotor_angle, currents): (f64, &[f64])| {
            let start =
                Start { angular_velocity: w, vertical: v, rotor_angle, rotor_speed, currents: currents.to_vec() };
            let scene = Scene { start, ..self.scene.clone() };
            let problem = scene.problem(Axes::Second);
            let mut rates = vec![0.0; problem.state.len()];
            problem.law.rates(0.0, &problem.state, &mut rates);
            rates.iter().fold(0.0f64, |largest, rate| largest.max(rate.abs()))
        };
        places.into_iter().map(of_place).fold(0.0, f64::max)
    }
}

/// A motion found for a given angular velocity or momentum, before its stability is decided.
struct Raw<'a> {
    shape: Shape,
    kind: Kind,
    given: Given,
    multiplier: Option<[f64; 2]>,
    /// The pair (v, w0) within 2^-bits; for a circle v is its centre, for a sphere zero.
    enclosed: &'a dyn Fn(usize) -> Option<([Enclosure; 3], Enclosure)>,
    axis: &'a dyn Fn(usize) -> Option<[Enclosure; 3]>,
}
