//! The verdicts on a scene's steady motions, one for each angle of the rotor.

use super::approximation::Approximation;
use super::judged::Judged;
use super::verdict::{Reason, StabilityVerdict};
use crate::stationary::energies::{Energies, Kept};
use crate::stationary::motor::{Angle, MotorStates};
use algebra::real::{Enclosure, Ordered, Polynomial, Root, Surd};
use field::{Rational, Scalar};
use nalgebra::Vector3;

/// The data of the verdicts for one value of the rotor's constant quantity.
pub struct Judge<'a> {
    pub approximation: &'a Approximation,
    pub energies: &'a Energies<Rational>,
    pub motor: &'a MotorStates,
    pub kept: Kept,
    /// The rotor speed W, rad/s, or the rotor's own momentum, N m s.
    pub value: &'a Root,
    pub given: Given,
}

/// The given quantity that all motions share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Given {
    /// The angular velocity w0, rad/s.
    Speed(Rational),
    /// The angular momentum x.v about the vertical, N m s.
    Momentum(Rational),
}

/// (v, w0) within 2^-bits, if that precision is available.
pub type Enclosed<'a> = dyn Fn(usize) -> Option<([Enclosure; 3], Enclosure)> + 'a;

/// The precisions tried, bits.
pub(super) const BITS: [usize; 4] = [256, 512, 1024, 2048];

impl Judge<'_> {
    /// One verdict for each angle of a synchronous motor, otherwise one.
    pub fn verdicts(&self, enclosed: &Enclosed<'_>) -> Vec<Judged> {
        self.angles().into_iter().map(|angle| self.verdict(enclosed, angle, &BITS)).collect()
    }

    /// The angles of a synchronous motor, otherwise a single `None`.
    pub(super) fn angles(&self) -> Vec<Option<&Angle>> {
        match self.motor {
            MotorStates::InStep { angles, .. } => angles.iter().map(Some).collect(),
            _ => vec![None],
        }
    }

    /// Whether two steady states of the rotor merge (saddle-node).
    pub(super) fn merges(&self, angle: Option<&Angle>) -> bool {
        angle.is_some_and(|angle| angle.slope == 0) || self.speeds_merge()
    }

    /// W, or the rotor's own momentum, if rational.
    pub(super) fn value_as_fraction(&self) -> Option<Rational> {
        let value = self.value.enclosure(BITS[0]).simplest();
        Root::rational(value)?.compare(self.value).is_eq().then_some(value)
    }

    /// The verdict at an angle of a synchronous motor, with increasing precisions, bits.
    pub(super) fn verdict(&self, enclosed: &Enclosed<'_>, angle: Option<&Angle>, fineness: &[usize]) -> Judged {
        if self.merges(angle) {
            return Judged::cannot_tell(self.approximation, Reason::PullOut);
        }
        let too_fine = StabilityVerdict::CannotTell(Reason::TooFine);
        let mut last = Judged::cannot_tell(self.approximation, Reason::TooFine);
        for &bits in fineness {
            let one = Enclosure::integer(1, bits);
            let Some(place) = self.place(enclosed, angle, &one, bits) else { continue };
            last = Judged::at(self.approximation, &place, &one, Enclosure::to_f64);
            if last.verdict != too_fine {
                break;
            }
            // a quantity without a sign may be exactly zero
            if bits == BITS[0]
                && let Some(place) = self.exact(enclosed, angle)
            {
                let exact = Judged::at(self.approximation, &place, &Rational::new(1, 1).into(), Surd::to_f64);
                if exact.verdict != too_fine {
                    return exact;
                }
            }
        }
        last
    }

    /// Whether two speeds of the rotor merge: the torque then has no damping slope.
    fn speeds_merge(&self) -> bool {
        let MotorStates::Slipping { speeds, .. } = self.motor else { return false };
        speeds.iter().any(|slip| slip.slope == 0 && slip.speed.compare(self.value).is_eq())
    }

    /// The state (w0, v, W, cos g, sin g), enclosed.
    fn place(
        &self,
        enclosed: &Enclosed<'_>,
        angle: Option<&Angle>,
        one: &Enclosure,
        bits: usize,
    ) -> Option<[Enclosure; 7]> {
        let (v, speed) = enclosed(bits)?;
        let value = self.value.enclosure(bits);
        self.filled(v, speed, value, angle.map(|angle| angle.half_tangent.as_ref().map(|t| t.enclosure(bits))), one)
    }

    /// The state as fractions, if it is rational: the simplest fractions in the enclosures are the state if they
    /// satisfy the conditions, which have only one solution there. The cosine may be a square root.
    fn exact(&self, enclosed: &Enclosed<'_>, angle: Option<&Angle>) -> Option<[Surd; 7]> {
        let (v, speed) = enclosed(BITS[0])?;
        let (v, speed) = (v.each_ref().map(Enclosure::simplest), speed.simplest());
        let value = self.value_as_fraction()?;
        let [speed, v1, v2, v3, rotor_speed, ..] = self.filled(v, speed, value, None, &Rational::new(1, 1))?;
        let vertical = Vector3::new(v1, v2, v3);
        let (all, _) = self.energies.momenta::<Rational>(vertical * speed, rotor_speed);
        let missing = (all * speed + self.energies.weight).cross(&vertical);
        let (zero, one) = (Rational::new(0, 1), Rational::new(1, 1));
        let as_given = match self.given {
            Given::Speed(w) => speed == w,
            Given::Momentum(p) => all.dot(&vertical) == p,
        };
        if !as_given || vertical.dot(&vertical) != one || missing.iter().any(|m| *m != zero) {
            return None;
        }
        let [cos, sin] = circle_point(angle)?;
        let [speed, v1, v2, v3, rotor_speed] = [speed, v1, v2, v3, rotor_speed].map(Surd::from);
        Some([speed, v1, v2, v3, rotor_speed, cos, sin])
    }

    /// The state; `half_tangent`: `None` without an angle, `Some(None)` at half a turn.
    pub(super) fn filled<R: Ordered>(
        &self,
        v: [R; 3],
        speed: R,
        value: R,
        half_tangent: Option<Option<R>>,
        one: &R,
    ) -> Option<[R; 7]> {
        let rotor_speed = match self.kept {
            Kept::RelativeSpeed => value,
            Kept::Momentum => {
                // p' = mixed.w + axial phi'
                let shares = (0..3).map(|i| Some(one.fraction(self.energies.mixed[i])?.times(&v[i]).times(&speed)));
                let carried = shares.collect::<Option<Vec<R>>>()?;
                let own = carried.iter().fold(value, |rest, share| rest.minus(share));
                own.over(&one.fraction(self.energies.axial)?)?
            }
        };
        let (cos, sin) = match half_tangent {
            Some(Some(t)) => {
                let square = t.times(&t);
                let norm = one.plus(&square);
                (one.minus(&square).over(&norm)?, t.plus(&t).over(&norm)?)
            }
            Some(None) => (one.integer(-1), one.integer(0)),
            None => (one.integer(1), one.integer(0)),
        };
        let [v1, v2, v3] = v;
        Some([speed, v1, v2, v3, rotor_speed, cos, sin])
    }
}

/// (cos g, sin g), if the sine is rational; (1, 0) without an angle.
pub(super) fn circle_point(angle: Option<&Angle>) -> Option<[Surd; 2]> {
    let (zero, one) = (Rational::int(0), Rational::int(1));
    match angle.map(|angle| &angle.half_tangent) {
        None => Some([one.into(), zero.into()]),
        Some(None) => Some([(-one).into(), zero.into()]),
        Some(Some(t)) => {
            let at = t.enclosure(BITS[0]);
            let unit = Enclosure::integer(1, BITS[0]);
            let norm = unit.plus(&at.times(&at));
            let sine = Enclosure::over(&at.plus(&at), &norm)?.simplest();
            // sin g = 2 t / (1 + t^2)
            let equation = [sine, Rational::int(-2), sine];
            if t.sign_of(&Polynomial::from_rationals(&equation)?) != 0 {
                return None;
            }
            let size = Surd::root_of(one - sine * sine)?;
            let acute = unit.minus(&at.times(&at)).sign()? >= 0;
            Some([if acute { size } else { size.integer(0).minus(&size) }, sine.into()])
        }
    }
}
