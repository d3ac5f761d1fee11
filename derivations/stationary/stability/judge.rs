//! The verdicts on a scene's stationary motions, one for each angle of the rotor.

use super::approximation::Approximation;
use super::verdict::{Judged, Reason, Verdict};
use crate::stationary::energies::{Energies, Kept};
use crate::stationary::motor::{Angle, Motor};
use field::Rational;
use nalgebra::Vector3;
use symbolic::real::{Enclosure, Ordered, Root};

/// What decides for one constant value of what the rotor keeps.
pub struct Judge<'a> {
    pub approximation: &'a Approximation,
    pub energies: &'a Energies<Rational>,
    pub motor: &'a Motor,
    pub kept: Kept,
    /// W, or the rotor's own momentum.
    pub value: &'a Root,
}

/// (v, w0) within 2^-bits, where so many bits are to be had.
type Enclosed<'a> = dyn Fn(usize) -> Option<([Enclosure; 3], Enclosure)> + 'a;

/// Bits that are tried.
const BITS: [usize; 4] = [256, 512, 1024, 2048];

impl Judge<'_> {
    /// One verdict for each angle of a motor in step, else one.
    pub fn verdicts(&self, enclosed: &Enclosed<'_>) -> Vec<Judged> {
        match self.motor {
            Motor::InStep { angles, .. } => angles.iter().map(|angle| self.verdict(enclosed, Some(angle))).collect(),
            _ => vec![self.verdict(enclosed, None)],
        }
    }

    fn verdict(&self, enclosed: &Enclosed<'_>, angle: Option<&Angle>) -> Judged {
        let merging = angle.is_some_and(|angle| angle.slope == 0) || self.speeds_merge();
        if merging {
            return Judged::cannot_tell(self.approximation, Reason::PullOut);
        }
        if let Some(place) = self.exact(enclosed, angle) {
            let judged = Judged::at(self.approximation, &place, &Rational::new(1, 1), |x| x.to_f64());
            if judged.verdict != Verdict::CannotTell(Reason::TooFine) {
                return judged;
            }
        }
        let mut last = Judged::cannot_tell(self.approximation, Reason::TooFine);
        for bits in BITS {
            let one = Enclosure::integer(1, bits);
            let Some(place) = self.place(enclosed, angle, &one, bits) else { continue };
            last = Judged::at(self.approximation, &place, &one, Enclosure::to_f64);
            if last.verdict != Verdict::CannotTell(Reason::TooFine) {
                break;
            }
        }
        last
    }

    /// Two speeds of the rotor in one: no slope of the moment damps.
    fn speeds_merge(&self) -> bool {
        let Motor::Slipping { speeds, .. } = self.motor else { return false };
        speeds.iter().any(|slip| slip.slope == 0 && slip.speed.compare(self.value).is_eq())
    }

    /// (w0, v, W, cos g, sin g), enclosed.
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

    /// The same as fractions, where they are fractions: the simplest in an enclosure are tried, and are it if they satisfy
    /// the conditions, which have only one solution there.
    fn exact(&self, enclosed: &Enclosed<'_>, angle: Option<&Angle>) -> Option<[Rational; 7]> {
        let (v, speed) = enclosed(BITS[0])?;
        let (v, speed) = (v.each_ref().map(Enclosure::simplest), speed.simplest());
        let equal = |root: &Root| -> Option<Rational> {
            let value = root.enclosure(BITS[0]).simplest();
            Root::rational(value)?.compare(root).is_eq().then_some(value)
        };
        let value = equal(self.value)?;
        let half_tangent = match angle {
            Some(Angle { half_tangent: Some(t), .. }) => Some(Some(equal(t)?)),
            Some(_) => Some(None),
            None => None,
        };
        let place = self.filled(v, speed, value, half_tangent, &Rational::new(1, 1))?;
        let [speed, v1, v2, v3, rotor_speed, ..] = place;
        let vertical = Vector3::new(v1, v2, v3);
        let (all, _) = self.energies.momenta::<Rational>(vertical * speed, rotor_speed);
        let missing = (all * speed + self.energies.weight).cross(&vertical);
        let zero = Rational::new(0, 1);
        let holds = vertical.dot(&vertical) == Rational::new(1, 1) && missing.iter().all(|m| *m == zero);
        holds.then_some(place)
    }

    /// `half_tangent`: none without an angle, an empty one at half a turn.
    fn filled<R: Ordered>(
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
