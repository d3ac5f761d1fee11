//! Every stationary motion of a scene, for a given angular velocity or a given angular momentum about the vertical.

use super::energies::{Energies, Kept};
use super::motor::{Motor, NoMotor, Slip};
use super::stability::judge::{Given, Judge};
use super::stability::{Approximation, Judged, Reason};
use crate::scene::{Axes, Scene, Start, System};
use crate::systems::gyrostat::Gyrostat;
use field::Rational;
use mechanics::uniform::{Body, Census, Kind, Shape, Undecided};
use nalgebra::{Matrix3, Vector3};
use std::fmt;
use symbolic::real::{Enclosure, Ordered, Root};

/// A scene's gyrostat and motor, ready to be asked.
pub struct Stationary<'a> {
    scene: &'a Scene,
    bodies: &'a Gyrostat<f64>,
    energies: Energies<Rational>,
    approximation: Approximation,
    pub motor: Motor,
    pub kept: Kept,
    pub cases: Vec<Case>,
}

/// One constant value of what the rotor keeps.
pub struct Case {
    /// Its relative speed, rad/s; of a free rotor its own momentum, N m s.
    pub value: Root,
    pub body: Body,
}

/// All that goes with one case.
pub struct Answer {
    /// As [`Case::value`].
    pub value: f64,
    pub found: Vec<Found>,
    pub certificate: Certificate,
}

/// Why none is missing.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// Of the polynomial whose real roots were isolated, and their number.
    pub degree: usize,
    pub roots: usize,
    /// Their number by Sturm's theorem, where it was counted again.
    pub again: Option<usize>,
    /// Minima - saddles + maxima, 2 on a sphere.
    pub morse: Option<i32>,
    /// What may hide further motions: then completeness is not claimed.
    pub undecided: Vec<Undecided>,
}

/// A stationary motion, or a connected family of them.
#[derive(Clone, Debug)]
pub struct Found {
    pub shape: Shape,
    pub kind: Kind,
    /// lambda, N m, where it was isolated for a given angular velocity: the ends of its interval
    pub multiplier: Option<[f64; 2]>,
    /// v in the axes of the data, enclosed; of a circle its centre
    pub enclosed: [Enclosure; 3],
    /// v of the motion, or of one of the family
    pub direction: Vector3<f64>,
    /// w, rad/s
    pub speed: f64,
    /// phi', rad/s
    pub rotor_speed: f64,
    /// the angular momentum about the vertical, N m s
    pub momentum: f64,
    /// of a circle: its radius, and the axis about which it lies
    pub circle: Option<(f64, Vector3<f64>)>,
    /// what becomes of small deviations: for each angle of a motor in step, else once
    pub stability: Vec<Judged>,
    /// the largest rate of the equations that run, at this state and every angle of the rotor, rad/s^2, A/s
    pub residual: f64,
}

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq)]
pub enum NoAnswer {
    /// A motor on a bench has no carrier.
    Bench,
    Motor(NoMotor),
    /// A number is infinite or no number.
    NotFinite(f64),
    /// More bits than are tried would be needed to tell motions apart.
    TooFine,
}

/// Bits to which directions are enclosed.
const BITS: usize = 64;

impl<'a> Stationary<'a> {
    /// The data are the decimals that were written.
    ///
    /// # Errors
    /// [`NoAnswer`].
    pub fn of(scene: &'a Scene) -> Result<Self, NoAnswer> {
        let System::Gyrostat(bodies) = &scene.system else { return Err(NoAnswer::Bench) };
        let motor = Motor::of(&scene.machine, &scene.machine_data).map_err(NoAnswer::Motor)?;
        let energies = Energies::of(&decimals(bodies));
        let approximation =
            Approximation::of(&energies, &scene.machine, &scene.machine_data).map_err(NoAnswer::Motor)?;
        let (kept, values) = match motor.speeds() {
            Some(speeds) => (Kept::RelativeSpeed, speeds.into_iter().cloned().collect()),
            None => {
                let spin = scene.start.angular_velocity.map(Rational::decimal).dot(&energies.mixed)
                    + Rational::decimal(scene.start.rotor_speed) * energies.axial;
                (Kept::Momentum, Root::rational(spin).into_iter().collect::<Vec<_>>())
            }
        };
        let (tensor, share) = energies.quadratic(kept);
        let case = |value: Root| {
            let body = Body::new(&tensor, &share, &value, &energies.weight).ok_or(NoAnswer::TooFine)?;
            Ok(Case { value, body })
        };
        let cases = values.into_iter().map(case).collect::<Result<_, _>>()?;
        Ok(Stationary { scene, bodies, energies, approximation, motor, kept, cases })
    }

    /// All with the angular velocity w, rad/s, about the vertical.
    ///
    /// # Errors
    /// [`NoAnswer`].
    pub fn at_speed(&self, w: f64) -> Result<Vec<Answer>, NoAnswer> {
        self.cases.iter().map(|case| self.answer_at_speed(case, w)).collect()
    }

    fn answer_at_speed(&self, case: &Case, w: f64) -> Result<Answer, NoAnswer> {
        let all = case.body.rotations(Rational::decimal(w)).ok_or(NoAnswer::NotFinite(w))?;
        let boxes = all.boxes(BITS).ok_or(NoAnswer::TooFine)?;
        let value = case.value.to_f64();
        let mut found = Vec::new();
        for (motion, enclosed) in all.motions.iter().zip(boxes) {
            let circle = match motion.shape {
                Shape::Circle { .. } => {
                    let (radius, axis) = (motion.radius(BITS), motion.axis(BITS));
                    let axis = axis.ok_or(NoAnswer::TooFine)?.each_ref().map(Enclosure::to_f64);
                    Some((radius.ok_or(NoAnswer::TooFine)?.to_f64(), Vector3::from(axis)))
                }
                _ => None,
            };
            let multiplier = Some(motion.interval().ok_or(NoAnswer::TooFine)?);
            let speed = |bits| Enclosure::integer(1, bits).fraction(Rational::decimal(w));
            let at = |bits| Some((motion.direction(bits)?, speed(bits)?));
            let stability = self.verdicts(case, Given::Speed(Rational::decimal(w)), motion.shape, &at);
            found.push(self.found(motion.shape, motion.kind, multiplier, enclosed, w, circle, value, stability));
        }
        let certificate = Certificate {
            degree: all.degree,
            roots: all.roots[0],
            again: Some(all.roots[1]),
            morse: all.morse(),
            undecided: Vec::new(),
        };
        Ok(Answer { value, found, certificate })
    }

    /// All with the angular momentum p, N m s, about the vertical.
    ///
    /// # Errors
    /// [`NoAnswer`].
    pub fn at_momentum(&self, p: f64) -> Result<Vec<Answer>, NoAnswer> {
        self.cases.iter().map(|case| self.answer_at_momentum(case, p)).collect()
    }

    fn answer_at_momentum(&self, case: &Case, p: f64) -> Result<Answer, NoAnswer> {
        // a rotor that keeps its own momentum carries its part of the whole
        let all = case.body.at_momentum(Rational::decimal(p)).ok_or(NoAnswer::NotFinite(p))?;
        let value = case.value.to_f64();
        let mut found = Vec::new();
        for motion in &all.motions {
            let (enclosed, w) = motion.direction_and_speed(BITS).ok_or(NoAnswer::TooFine)?;
            let centre = Vector3::from(enclosed.each_ref().map(Enclosure::to_f64));
            let circle = match motion.shape {
                Shape::Circle { .. } => {
                    let axis = motion.axis(BITS).ok_or(NoAnswer::TooFine)?.each_ref().map(Enclosure::to_f64);
                    Some(((1.0 - centre.norm_squared()).max(0.0).sqrt(), Vector3::from(axis)))
                }
                _ => None,
            };
            let given = Given::Momentum(Rational::decimal(p));
            let stability = self.verdicts(case, given, motion.shape, &|bits| motion.direction_and_speed(bits));
            found.push(self.found(motion.shape, motion.kind, None, enclosed, w.to_f64(), circle, value, stability));
        }
        let certificate = Certificate {
            degree: all.degree,
            roots: all.roots,
            again: None,
            morse: None,
            undecided: all.undecided.clone(),
        };
        Ok(Answer { value, found, certificate })
    }

    fn verdicts(
        &self,
        case: &Case,
        given: Given,
        shape: Shape,
        at: &dyn Fn(usize) -> Option<([Enclosure; 3], Enclosure)>,
    ) -> Vec<Judged> {
        if matches!(shape, Shape::Circle { .. } | Shape::Sphere) {
            return vec![Judged::cannot_tell(&self.approximation, Reason::Family)];
        }
        let Stationary { approximation, energies, motor, kept, .. } = self;
        Judge { approximation, energies, motor, kept: *kept, value: &case.value, given }.verdicts(at)
    }

    /// How many there are for every angular velocity, case by case.
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

    #[expect(clippy::too_many_arguments, reason = "a motion as it was found, from both kinds of answers")]
    fn found(
        &self,
        shape: Shape,
        kind: Kind,
        multiplier: Option<[f64; 2]>,
        enclosed: [Enclosure; 3],
        speed: f64,
        circle: Option<(f64, Vector3<f64>)>,
        value: f64,
        stability: Vec<Judged>,
    ) -> Found {
        let centre = Vector3::from(enclosed.each_ref().map(Enclosure::to_f64));
        let direction = match (shape, circle) {
            (Shape::Sphere, _) => Vector3::z(),
            (_, Some((radius, axis))) => {
                let across = axis.cross(&Vector3::ith(axis.iamin(), 1.0)).normalize();
                centre + across * radius
            }
            _ => centre,
        };
        let w = direction * speed;
        let rotor_speed = match self.kept {
            Kept::RelativeSpeed => value,
            Kept::Momentum => {
                let energies = Energies::of(self.bodies);
                (value - energies.mixed.dot(&w)) / energies.axial
            }
        };
        let momentum = self.momentum(w, rotor_speed, direction);
        let residual = self.residual(w, direction, rotor_speed);
        Found {
            shape,
            kind,
            multiplier,
            enclosed,
            direction,
            speed,
            rotor_speed,
            momentum,
            circle,
            stability,
            residual,
        }
    }

    /// The second route: the equations that run, at the state that was found.
    fn residual(&self, w: Vector3<f64>, v: Vector3<f64>, rotor_speed: f64) -> f64 {
        let places: Vec<(f64, &[f64])> = match &self.motor {
            Motor::InStep { angles, .. } => angles.iter().map(|angle| (angle.radians(), &angle.currents[..])).collect(),
            Motor::Slipping { speeds, .. } => {
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

impl Certificate {
    /// Whether none is missing, proved.
    pub fn is_complete(&self) -> bool {
        self.undecided.is_empty()
            && self.again.is_none_or(|again| again == self.roots)
            && self.morse.is_none_or(|sum| sum == 2)
    }
}

/// The same bodies with the decimals that were written.
pub fn decimals(bodies: &Gyrostat<f64>) -> Gyrostat<Rational> {
    let vector = |v: &Vector3<f64>| v.map(Rational::decimal);
    let matrix = |m: &Matrix3<f64>| m.map(Rational::decimal);
    let (carrier, rotor) = (&bodies.carrier, &bodies.rotor);
    Gyrostat {
        carrier: crate::systems::gyrostat::Carrier {
            mass: Rational::decimal(carrier.mass),
            centre: vector(&carrier.centre),
            inertia: matrix(&((carrier.inertia + carrier.inertia.transpose()) * 0.5)),
        },
        rotor: crate::systems::gyrostat::Rotor {
            mass: Rational::decimal(rotor.mass),
            centre: vector(&rotor.centre),
            axis: vector(&rotor.axis),
            axial: Rational::decimal(rotor.axial),
            transverse: Rational::decimal(rotor.transverse),
        },
        gravity: Rational::decimal(bodies.gravity),
    }
}

impl fmt::Display for NoAnswer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bench => {
                write!(
                    f,
                    "a motor on a bench has no carrier that could turn; a scene with system = \"gyrostat\" is accepted"
                )
            }
            Self::Motor(reason) => reason.fmt(f),
            Self::NotFinite(value) => write!(f, "{value} is not finite; a finite number is accepted"),
            Self::TooFine => write!(f, "motions lie closer together than 4096 bits tell apart"),
        }
    }
}

impl std::error::Error for NoAnswer {}
