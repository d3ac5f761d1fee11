//! The search for the steady motions at two values of the data, with a verdict on each.

use super::Region;
use super::law::{Ground, HeldRotor};
use super::node::{Family, Here, NodeMotions};
use crate::scene::Setup;
use crate::stationary::energies::Energies;
use crate::stationary::stability::along::Known;
use crate::stationary::stability::approximation::Approximation;
use crate::stationary::stability::datum::Setting;
use crate::stationary::stability::judge::{Given, Judge};
use crate::stationary::stability::verdict::StabilityVerdict;
use algebra::real::{Enclosure, Root};
use field::Rational;
use mechanics::steady_rotations::{self, Body, Data, Kind, count, followed, sharpened};
use nalgebra::Vector3;

/// The quantities that the search and the verdicts need, at two values of the data.
pub(super) struct Spot<'a> {
    region: &'a Region<'a>,
    ground: &'a Ground,
    setting: Setting,
    energies: Energies<Rational>,
    approximation: Approximation,
}

/// A motion before its verdict.
pub(super) struct Raw<'a> {
    pub state: usize,
    pub kind: Kind,
    pub place: steady_rotations::EnclosedPoint,
    pub value: Enclosure,
    found: Found,
    held: &'a HeldRotor<'a>,
}

/// A motion found by root isolation, or continued to an irrational W from a nearby rational number.
enum Found {
    Isolated(steady_rotations::SteadyRotation),
    Carried,
}

/// The precision of coordinates, bits: a product of two numbers fits into two 64-bit words.
pub(super) const BITS: usize = 56;
/// The precision at which motions are counted and folds isolated, bits.
const FINE: usize = 96;
/// The precisions that are tried in turn for the sign of a number, bits.
const FINENESS: [usize; 5] = [128, 256, 512, 1024, 2048];

impl<'a> Spot<'a> {
    /// The search at two values of the data; `None` if no bodies with these data exist.
    pub fn of(region: &'a Region<'a>, ground: &'a Ground, values: [f64; 2]) -> Option<Self> {
        let setting = region.setting(values);
        let Setup::Gyrostat(bodies) = &setting.data.system else { return None };
        bodies.admissible().ok()?;
        let energies = setting.energies()?;
        let approximation = ground.approximation(&energies);
        Some(Spot { region, ground, setting, energies, approximation })
    }

    pub fn held(&self) -> Vec<HeldRotor<'a>> {
        self.region.held(self.ground, &self.setting, &self.energies)
    }

    /// The motions with their verdicts; `None` if they cannot be separated with the precisions that are tried.
    pub fn place(&self) -> Option<NodeMotions> {
        let held = self.held();
        if held.is_empty() {
            return Some(NodeMotions::PulledOut);
        }
        let (mut isolated, mut families) = (Vec::new(), Vec::new());
        for (state, held) in held.iter().enumerate() {
            let (motions, along) = self.motions(state, held)?;
            isolated.extend(motions.into_iter().map(|raw| self.judged(&raw)));
            families.extend(along);
        }
        Some(NodeMotions::Motions { isolated, families })
    }

    /// All isolated motions with one steady state of the rotor, and the connected families.
    pub fn motions<'b>(&self, state: usize, held: &'b HeldRotor<'b>) -> Option<(Vec<Raw<'b>>, Vec<Family>)> {
        if held.value.as_rational().is_none()
            && let Some(carried) = self.carried(state, held)
        {
            return Some((carried, Vec::new()));
        }
        let body = self.body(held, &held.value)?;
        let all = body.rotations(Rational::decimal(self.setting.speed))?;
        let value = held.value.enclosure(BITS);
        let raw = |motion: &steady_rotations::SteadyRotation| {
            let place = enclosed(motion, BITS)?;
            let found = Found::Isolated(motion.clone());
            Some(Raw { state, kind: motion.kind, place, value: value.clone(), found, held })
        };
        let isolated = all.motions[..all.isolated()].iter().map(raw).collect::<Option<_>>()?;
        let families = all.motions[all.isolated()..].iter().map(|family| (family.shape, self.along(held, family)));
        Some((isolated, families.collect()))
    }

    fn body(&self, held: &HeldRotor<'_>, value: &Root) -> Option<Body> {
        let (tensor, share) = self.energies.quadratic(held.kept);
        Body::new(&tensor, &share, value, &self.energies.weight)
    }

    /// The angular velocities, rad/s, at which motions merge; `None` if not all are known, or if W is irrational, for
    /// which the computation would take too long.
    pub fn folds(&self, held: &HeldRotor<'_>) -> Option<Vec<f64>> {
        held.value.as_rational()?;
        let folds = self.body(held, &held.value)?.folds();
        let all =
            folds.motions.iter().map(|fold| Some(fold.direction_and_speed(FINE)?.1.to_f64())).collect::<Option<_>>();
        all.filter(|_| folds.undecided.is_none())
    }

    /// The motions at an irrational W, continued from those at a nearby rational number. If the number of motions is
    /// constant between the two, these are all motions; `None` if that is not known.
    fn carried<'b>(&self, state: usize, held: &'b HeldRotor<'b>) -> Option<Vec<Raw<'b>>> {
        let value = held.value.enclosure(FINE);
        let beside = Rational::exactly(held.value.to_f64());
        let between = |t: &Enclosure| {
            let from = Enclosure::rational(beside, FINE)?;
            self.data(held, &(&from + &(t * &(&value - &from))))
        };
        let all = self.body(held, &Root::rational(beside)?)?.rotations(Rational::decimal(self.setting.speed))?;
        let whole = Enclosure::integer(0, FINE).hull(&Enclosure::integer(1, FINE));
        let same = count(&between(&whole)?)? == all.motions.len();
        let raw = |motion: &steady_rotations::SteadyRotation| {
            let place = followed(&between, &enclosed(motion, FINE)?)?;
            let place = place.each_ref().map(|z| z * &Enclosure::integer(1, BITS));
            Some(Raw {
                state,
                kind: motion.kind,
                place,
                value: held.value.enclosure(BITS),
                found: Found::Carried,
                held,
            })
        };
        if same { all.motions.iter().map(raw).collect() } else { None }
    }

    /// K and b for a value of the rotor's constant quantity.
    fn data(&self, held: &HeldRotor<'_>, value: &Enclosure) -> Option<Data> {
        let number = |x: Rational| Enclosure::rational(x, value.bits());
        let (tensor, share) = self.energies.quadratic(held.kept);
        let w = Rational::decimal(self.setting.speed);
        let matrix = (tensor * (w * w)).map(number);
        let (spin, weight) = ((share * w).map(number), self.energies.weight.map(number));
        let entry = |i: usize, j: usize| matrix[(i, j)].clone();
        let rows: Vec<[Enclosure; 3]> =
            (0..3).map(|i| Some([entry(i, 0)?, entry(i, 1)?, entry(i, 2)?])).collect::<Option<_>>()?;
        let b = |i: usize| Some(&(spin[i].as_ref()? * value) + weight[i].as_ref()?);
        Some((rows.try_into().ok()?, [b(0)?, b(1)?, b(2)?]))
    }

    pub fn judged(&self, raw: &Raw<'_>) -> Here {
        let speed = Rational::decimal(self.setting.speed);
        let enclosed = |bits: usize| {
            let v = match &raw.found {
                Found::Isolated(motion) => motion.direction(bits)?,
                Found::Carried => {
                    let finer = raw.place.each_ref().map(|z| z.clone().finer(bits));
                    let place = sharpened(&self.data(raw.held, &raw.held.value.enclosure(bits))?, finer)?;
                    let [v1, v2, v3, _] = place;
                    [v1, v2, v3]
                }
            };
            Some((v, Enclosure::rational(speed, bits)?))
        };
        let verdict = self.judge(raw.held).verdict(&enclosed, raw.held.angle, &FINENESS).verdict;
        let direction = Vector3::from_fn(|i, _| raw.place[i].to_f64());
        let (place, value) = (raw.place.clone(), raw.value.clone());
        Here { state: raw.state, kind: raw.kind, direction, verdict, place, value }
    }

    fn judge<'b>(&'b self, held: &'b HeldRotor<'b>) -> Judge<'b> {
        let (approximation, energies, motor) = (&self.approximation, &self.energies, &self.ground.motor);
        let given = Given::Speed(Rational::decimal(self.setting.speed));
        Judge { approximation, energies, motor, kept: held.kept, value: &held.value, given }
    }

    /// The verdicts that occur along a family.
    fn along(&self, held: &HeldRotor<'_>, family: &steady_rotations::SteadyRotation) -> Vec<StabilityVerdict> {
        let speed = Rational::decimal(self.setting.speed);
        let enclosed = |bits| Some((family.direction(bits)?, Enclosure::rational(speed, bits)?));
        let axis = |bits| family.axis(bits);
        let known = Known { shape: family.shape, enclosed: &enclosed, axis: &axis };
        let along = self.judge(held).along_at(&known, held.angle);
        let mut all: Vec<StabilityVerdict> = along.arcs.iter().map(|arc| arc.judged.verdict).collect();
        all.dedup();
        all
    }
}

impl Raw<'_> {
    /// Whether this motion may be the one that is known to be unique in a box, because their enclosures overlap.
    pub fn is_in(&self, place: &steady_rotations::EnclosedPoint) -> bool {
        self.place.iter().zip(place).all(|(a, b)| !a.is_apart_from(b))
    }
}

fn enclosed(motion: &steady_rotations::SteadyRotation, bits: usize) -> Option<steady_rotations::EnclosedPoint> {
    let [v1, v2, v3] = motion.direction(bits)?;
    Some([v1, v2, v3, motion.multiplier(bits)?])
}
