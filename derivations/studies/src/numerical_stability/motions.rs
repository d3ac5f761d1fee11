//! The steady motions of a scene, each with an enclosure and an initial state for runs.

use super::linear::{At, Linearised, NoLinear};
use crate::scene::{Scene, Setup, Start};
use crate::stationary::energies::{Energies, Kept};
use crate::stationary::motions::{NoAnswer, Stationary, decimals};
use crate::stationary::motor::{Angle, MotorStates};
use crate::stationary::stability::{Reason, StabilityVerdict};
use algebra::real::{Enclosure, Root};
use field::Rational;
use mechanics::one_step_stability::{HalfPlane as Location, Mode, Spectrum};
use mechanics::steady_rotations::{Kind, Shape};
use nalgebra::Vector3;
use num_traits::Zero;
use std::fmt;

/// A steady motion and its eigenvalues.
#[derive(Clone, Debug)]
pub struct Stationed {
    /// The kind of the critical point of W for the motion of the carrier; `None` on a bench.
    pub kind: Option<Kind>,
    pub rotor: Rotor,
    /// Whether the carrier is at rest, exactly.
    pub rests: bool,
    /// The direction v, if the motion represents members of a family with one verdict.
    pub member: Option<Vector3<f64>>,
    pub at: At,
    /// The initial state for runs.
    pub start: Start,
    /// The eigenvalues; `None` where some coincide, or have a vanishing real part without a known reason.
    pub spectrum: Option<Spectrum>,
}

/// The rotor's motion.
#[derive(Clone, Debug, PartialEq)]
pub enum Rotor {
    /// Synchronous at this angle, rad; `held`: the torque is restoring.
    InStep { angle: f64, held: bool },
    /// At this speed relative to the carrier, rad/s.
    At { speed: f64 },
}

/// All steady motions with one angular velocity; families are represented by one member for each part with one verdict.
pub struct AllStationed {
    pub linear: Linearised,
    pub motions: Vec<Stationed>,
    /// The number of families without a verdict, which are omitted.
    pub families: usize,
}

/// The reason why no motions are known.
#[derive(Clone, Debug, PartialEq)]
pub enum NoMotions {
    Answer(NoAnswer),
    Linear(NoLinear),
}

impl fmt::Display for NoMotions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Answer(reason) => reason.fmt(f),
            Self::Linear(reason) => reason.fmt(f),
        }
    }
}

impl std::error::Error for NoMotions {}

impl From<NoAnswer> for NoMotions {
    fn from(reason: NoAnswer) -> Self {
        Self::Answer(reason)
    }
}

/// The precision of the enclosures, bits.
const BITS: usize = 384;

impl AllStationed {
    /// The steady motions of a scene with the angular velocity w (rad/s) about the vertical, which a bench ignores.
    ///
    /// # Errors
    /// [`NoMotions`] with the reason why they are not known.
    pub fn of(scene: &Scene, w: f64) -> Result<Self, NoMotions> {
        match &scene.system {
            Setup::Gyrostat(_) => Self::turning(scene, w),
            Setup::Bench { .. } => Self::on_bench(scene),
        }
    }

    fn turning(scene: &Scene, w: f64) -> Result<Self, NoMotions> {
        let all = Stationary::of(scene)?;
        let linear = Linearised::of(scene, &all.motor).map_err(NoMotions::Linear)?;
        let speed = Rational::decimal(w);
        let w_exact = Enclosure::rational(speed, BITS).ok_or(NoAnswer::NotFinite(w))?;
        let rests = speed.is_zero();
        let (mut motions, mut families) = (Vec::new(), 0);
        for case in &all.cases {
            let rotations = case.body.rotations(speed).ok_or(NoAnswer::NotFinite(w))?;
            let boxes = rotations.boxes(BITS).ok_or(NoAnswer::TooFine)?;
            for (motion, vertical) in rotations.motions.iter().zip(boxes) {
                let turning = |vertical: &[Enclosure; 3]| vertical.each_ref().map(|v| v * &w_exact);
                let places_at = |w: &[Enclosure; 3]| {
                    let rotor_speed = own_speed(scene, all.kept, &case.value, w).ok_or(NoAnswer::TooFine)?;
                    places(&all.motor, &rotor_speed).into_iter().collect::<Option<Vec<_>>>().ok_or(NoAnswer::TooFine)
                };
                if !matches!(motion.shape, Shape::Circle { .. } | Shape::Sphere) {
                    let w = turning(&vertical);
                    let own =
                        Own { kind: Some(motion.kind), rests, vertical: &vertical, angular_velocity: &w, family: None };
                    motions.extend(places_at(&w)?.into_iter().map(|place| place.motion(&own, &linear)));
                    continue;
                }
                // for each angle of the rotor, a member of each part of the family
                for (angle, along) in all.along(case, motion, speed).into_iter().enumerate() {
                    let unknown = StabilityVerdict::CannotTell(Reason::Family);
                    families += usize::from(along.arcs.iter().any(|arc| arc.judged.verdict == unknown));
                    for arc in along.arcs.iter().filter(|arc| arc.judged.verdict != unknown) {
                        let w = turning(&arc.member);
                        let family = arc.judged.zeros.checked_sub(linear.integrals);
                        let own =
                            Own { kind: Some(motion.kind), rests, vertical: &arc.member, angular_velocity: &w, family };
                        let place = places_at(&w)?.into_iter().nth(angle);
                        motions.extend(place.map(|place| place.motion(&own, &linear)));
                    }
                }
            }
        }
        Ok(AllStationed { linear, motions, families })
    }

    fn on_bench(scene: &Scene) -> Result<Self, NoMotions> {
        let motor = MotorStates::of(&scene.machine).map_err(NoAnswer::Motor)?;
        let linear = Linearised::of(scene, &motor).map_err(NoMotions::Linear)?;
        let rests = || [0; 3].map(|n| Enclosure::integer(n, BITS));
        let speeds: Vec<Root> = match motor.speeds() {
            Some(speeds) => speeds.into_iter().cloned().collect(),
            None => Root::rational(Rational::decimal(scene.start.rotor_speed)).into_iter().collect(),
        };
        let mut motions = Vec::new();
        for speed in speeds {
            for place in places(&motor, &speed.enclosure(BITS)) {
                let place = place.ok_or(NoAnswer::TooFine)?;
                let own = Own { kind: None, rests: true, vertical: &rests(), angular_velocity: &rests(), family: None };
                motions.push(place.motion(&own, &linear));
            }
        }
        Ok(AllStationed { linear, motions, families: 0 })
    }
}

/// The relative rotor speed phi' of a motion, rad/s.
fn own_speed(scene: &Scene, kept: Kept, value: &Root, w: &[Enclosure; 3]) -> Option<Enclosure> {
    let (Kept::Momentum, Setup::Gyrostat(bodies)) = (kept, &scene.system) else { return Some(value.enclosure(BITS)) };
    let energies = Energies::of(&decimals(bodies));
    let mut rest = value.enclosure(BITS);
    for (share, w) in energies.mixed.iter().zip(w) {
        rest = &rest - &(&Enclosure::rational(*share, BITS)? * w);
    }
    rest.over(&Enclosure::rational(energies.axial, BITS)?)
}

/// The angle and speed of the rotor.
struct Place {
    rotor: Rotor,
    angle: [Enclosure; 2],
    /// The relative speed phi', rad/s.
    speed: Enclosure,
}

/// All angles of the rotor with a speed; `None` for one that cannot be enclosed.
fn places(motor: &MotorStates, speed: &Enclosure) -> Vec<Option<Place>> {
    let number = |n: i64| Enclosure::integer(n, BITS);
    match motor {
        MotorStates::InStep { angles, .. } => {
            let of = |angle: &Angle| {
                let point = match &angle.half_tangent {
                    Some(t) => {
                        let t = t.enclosure(BITS);
                        let square = &t * &t;
                        let below = &number(1) + &square;
                        [(&number(1) - &square).over(&below)?, (&t + &t).over(&below)?]
                    }
                    None => [number(-1), number(0)],
                };
                let rotor = Rotor::InStep { angle: angle.radians(), held: angle.slope < 0 };
                Some(Place { rotor, angle: point, speed: speed.clone() })
            };
            angles.iter().map(of).collect()
        }
        _ => {
            let rotor = Rotor::At { speed: speed.to_f64() };
            vec![Some(Place { rotor, angle: [number(1), number(0)], speed: speed.clone() })]
        }
    }
}

/// The carrier's part of a motion.
struct Own<'a> {
    kind: Option<Kind>,
    rests: bool,
    vertical: &'a [Enclosure; 3],
    angular_velocity: &'a [Enclosure; 3],
    /// For a family: the number of zero eigenvalues besides those of the integrals.
    family: Option<usize>,
}

impl Place {
    fn motion(self, own: &Own<'_>, linear: &Linearised) -> Stationed {
        let plain = |v: &[Enclosure; 3]| Vector3::from(v.each_ref().map(Enclosure::to_f64));
        let angle = if let Rotor::InStep { angle, .. } = self.rotor { angle } else { 0.0 };
        let vertical = plain(own.vertical);
        let at = At {
            angular_velocity: own.angular_velocity.clone(),
            vertical: own.vertical.clone(),
            angle: self.angle,
            rotor_speed: self.speed,
        };
        let start = Start {
            angular_velocity: plain(own.angular_velocity),
            vertical,
            rotor_angle: angle,
            rotor_speed: at.rotor_speed.to_f64(),
            currents: linear.currents(&at, BITS).unwrap_or_default(),
        };
        let spectrum = match own.family {
            None => linear.spectrum(&at, BITS),
            Some(zeros) => across(linear, &at, zeros),
        };
        Stationed {
            kind: own.kind,
            rotor: self.rotor,
            rests: own.rests,
            member: own.family.map(|_| vertical),
            at,
            start,
            spectrum,
        }
    }
}

/// The eigenvalues transverse to a family, without its zeros and those of the integrals.
fn across(linear: &Linearised, at: &At, zeros: usize) -> Option<Spectrum> {
    let mut polynomial = linear.polynomial(at, BITS)?;
    let rest = polynomial.split_off(zeros.min(polynomial.len()));
    if polynomial.iter().any(|c| c.sign().is_some_and(|sign| sign != 0)) {
        return None;
    }
    let mut spectrum = Spectrum::of(&rest, linear.symmetric)?;
    for (rate, count) in &linear.idle {
        spectrum.modes.push(Mode { place: Location::Real(Enclosure::rational(-*rate, BITS)?), count: *count });
    }
    Some(spectrum)
}
