//! The stationary motions of a scene, each with its place enclosed and a start for runs.

use super::linear::{At, Linearised, NoLinear};
use crate::scene::{Scene, Start, System};
use crate::stationary::energies::{Energies, Kept};
use crate::stationary::motions::{NoAnswer, Stationary, decimals};
use crate::stationary::motor::{Angle, Motor};
use field::Rational;
use mechanics::discrete::Spectrum;
use mechanics::uniform::{Kind, Shape};
use nalgebra::Vector3;
use std::fmt;
use symbolic::real::{Enclosure, Root};

/// One stationary motion and its eigenvalues.
#[derive(Clone, Debug)]
pub struct Stationed {
    /// The carrier: what W is there; `None` on a bench.
    pub kind: Option<Kind>,
    pub rotor: Rotor,
    pub at: At,
    /// For runs.
    pub start: Start,
    /// `None` where eigenvalues coincide, or have a vanishing real part for no known reason.
    pub spectrum: Option<Spectrum>,
}

/// What the rotor does.
#[derive(Clone, Debug, PartialEq)]
pub enum Rotor {
    /// In step with the field, at this angle, rad, and whether the moment drives back to it.
    InStep { angle: f64, held: bool },
    /// At this speed relative to the carrier, rad/s.
    At { speed: f64 },
}

/// All isolated stationary motions with one angular velocity.
pub struct AllStationed {
    pub linear: Linearised,
    pub motions: Vec<Stationed>,
    /// Families of motions, which are left out: their eigenvalues differ from place to place.
    pub families: usize,
}

/// Why there are none.
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

/// Bits of everything that is enclosed.
const BITS: usize = 384;

impl AllStationed {
    /// Of a scene with the angular velocity w, rad/s, about the vertical; on a bench there is none to be given.
    ///
    /// # Errors
    /// [`NoMotions`].
    pub fn of(scene: &Scene, w: f64) -> Result<Self, NoMotions> {
        match &scene.system {
            System::Gyrostat(_) => Self::turning(scene, w),
            System::Bench { .. } => Self::on_bench(scene),
        }
    }

    fn turning(scene: &Scene, w: f64) -> Result<Self, NoMotions> {
        let all = Stationary::of(scene)?;
        let linear = Linearised::of(scene, &all.motor).map_err(NoMotions::Linear)?;
        let speed = Rational::decimal(w);
        let w_exact = Enclosure::rational(speed, BITS).ok_or(NoAnswer::NotFinite(w))?;
        let (mut motions, mut families) = (Vec::new(), 0);
        for case in &all.cases {
            let rotations = case.body.rotations(speed).ok_or(NoAnswer::NotFinite(w))?;
            let boxes = rotations.boxes(BITS).ok_or(NoAnswer::TooFine)?;
            for (motion, vertical) in rotations.motions.iter().zip(boxes) {
                if matches!(motion.shape, Shape::Circle { .. } | Shape::Sphere) {
                    families += 1;
                    continue;
                }
                let angular_velocity = vertical.each_ref().map(|v| v * &w_exact);
                let rotor_speed =
                    own_speed(scene, all.kept, &case.value, &angular_velocity).ok_or(NoAnswer::TooFine)?;
                for place in places(&all.motor, &rotor_speed) {
                    let place = place.ok_or(NoAnswer::TooFine)?;
                    motions.push(place.motion(Some(motion.kind), &vertical, &angular_velocity, &linear));
                }
            }
        }
        Ok(AllStationed { linear, motions, families })
    }

    fn on_bench(scene: &Scene) -> Result<Self, NoMotions> {
        let motor = Motor::of(&scene.machine, &scene.machine_data).map_err(NoAnswer::Motor)?;
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
                motions.push(place.motion(None, &rests(), &rests(), &linear));
            }
        }
        Ok(AllStationed { linear, motions, families: 0 })
    }
}

/// phi' of a motion.
fn own_speed(scene: &Scene, kept: Kept, value: &Root, w: &[Enclosure; 3]) -> Option<Enclosure> {
    let (Kept::Momentum, System::Gyrostat(bodies)) = (kept, &scene.system) else { return Some(value.enclosure(BITS)) };
    let energies = Energies::of(&decimals(bodies));
    let mut rest = value.enclosure(BITS);
    for (share, w) in energies.mixed.iter().zip(w) {
        rest = &rest - &(&Enclosure::rational(*share, BITS)? * w);
    }
    rest.over(&Enclosure::rational(energies.axial, BITS)?)
}

/// Where the rotor is.
struct Place {
    rotor: Rotor,
    angle: [Enclosure; 2],
    /// phi'
    speed: Enclosure,
}

/// All places of the rotor that go with a speed; `None` for one that cannot be enclosed.
fn places(motor: &Motor, speed: &Enclosure) -> Vec<Option<Place>> {
    let number = |n: i64| Enclosure::integer(n, BITS);
    match motor {
        Motor::InStep { angles, .. } => {
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

impl Place {
    fn motion(
        self,
        kind: Option<Kind>,
        vertical: &[Enclosure; 3],
        angular_velocity: &[Enclosure; 3],
        linear: &Linearised,
    ) -> Stationed {
        let plain = |v: &[Enclosure; 3]| Vector3::from(v.each_ref().map(Enclosure::to_f64));
        let angle = if let Rotor::InStep { angle, .. } = self.rotor { angle } else { 0.0 };
        let (turning, down) = (plain(angular_velocity), plain(vertical));
        let (angular_velocity, vertical) = (angular_velocity.clone(), vertical.clone());
        let at = At { angular_velocity, vertical, angle: self.angle, rotor_speed: self.speed };
        let start = Start {
            angular_velocity: turning,
            vertical: down,
            rotor_angle: angle,
            rotor_speed: at.rotor_speed.to_f64(),
            currents: linear.currents(&at, BITS).unwrap_or_default(),
        };
        let spectrum = linear.spectrum(&at, BITS);
        Stationed { kind, rotor: self.rotor, at, start, spectrum }
    }
}
