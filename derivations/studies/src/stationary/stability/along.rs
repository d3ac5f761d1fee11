//! Stability along a family of steady motions: arc by arc, with the directions at which the verdict changes.

use super::critical::critical;
use super::family::{Cut, Family, cross, direction};
use super::judge::{BITS, Enclosed, Given, Judge, circle_point};
use super::judged::{Among, Judged};
use super::symmetry::{is_symmetric, unfelt};
use super::verdict::{Reason, StabilityVerdict};
use crate::stationary::motor::Angle;
use algebra::real::{Conic, Enclosure, Ordered, Root, Surd, Tower};
use field::{Rational, Scalar};
use mechanics::steady_rotations::Shape;
use nalgebra::Vector3;

/// The verdicts along a family for one angle of the rotor.
#[derive(Clone, Debug)]
pub struct Along {
    /// The arcs around a circle, or the zones of a sphere from the pole along the rotor's axis to the other pole.
    pub arcs: Vec<Arc>,
    /// Single directions whose verdict differs from that of the adjacent arcs, in the order of the arcs.
    pub edges: Vec<Edge>,
}

/// All members between two edges; all but one member if there is one edge, all if there is none.
#[derive(Clone, Debug)]
pub struct Arc {
    /// The direction v at both ends, if the arc has ends.
    pub ends: Option<[Vector3<f64>; 2]>,
    /// The direction v of one member, within 2^-512.
    pub member: [Enclosure; 3],
    pub judged: Judged,
}

/// A single direction.
#[derive(Clone, Debug)]
pub struct Edge {
    pub direction: Vector3<f64>,
    pub judged: Judged,
}

/// A family: its centre and angular velocity, and the axis of a circle, within 2^-bits.
pub struct Known<'a> {
    pub shape: Shape,
    pub enclosed: &'a Enclosed<'a>,
    pub axis: &'a dyn Fn(usize) -> Option<[Enclosure; 3]>,
}

/// The precision of a member's direction, bits.
const MEMBER: usize = 512;

impl Judge<'_> {
    /// The stability along a family, for each angle of a synchronous motor, otherwise once.
    pub fn along(&self, known: &Known<'_>) -> Vec<Along> {
        self.angles().into_iter().map(|angle| self.along_at(known, angle)).collect()
    }

    /// The stability along a family at one angle of a synchronous motor.
    pub(super) fn along_at(&self, known: &Known<'_>, angle: Option<&Angle>) -> Along {
        if self.merges(angle) {
            return self.whole(known, Judged::cannot_tell(self.approximation, Reason::PullOut));
        }
        let exactly = self.exactly_along(known, angle);
        exactly
            .or_else(|| self.by_symmetry(known, angle))
            .unwrap_or_else(|| self.whole(known, Judged::cannot_tell(self.approximation, Reason::Family)))
    }

    /// One verdict for all members.
    fn whole(&self, known: &Known<'_>, judged: Judged) -> Along {
        let member = self.member(known, MEMBER);
        let arcs = member.into_iter().map(|member| Arc { ends: None, member, judged: judged.clone() }).collect();
        Along { arcs, edges: Vec::new() }
    }

    /// The verdicts along the curve, which is cut at the zeros of critical functions; they are decided between and at
    /// the cuts with exact numbers.
    fn exactly_along(&self, known: &Known<'_>, angle: Option<&Angle>) -> Option<Along> {
        let (centre, speed) = (known.enclosed)(BITS[0])?;
        let speed = speed.simplest();
        let (given, momentum) = match self.given {
            Given::Speed(w) => (speed == w, None),
            Given::Momentum(p) => (true, Some(p)),
        };
        let value = self.value_as_fraction().filter(|_| given)?;
        let family = match known.shape {
            Shape::Sphere => Family::meridian(&self.energies.mixed),
            _ => Family::circle(&centre, &(known.axis)(BITS[0])?)?,
        };
        let point = circle_point(angle)?;
        let functions = self.functions(&family, speed, value, &point, momentum)?;
        let cuts = family.cuts(functions.iter().flat_map(Conic::zeros).collect())?;
        let exact = Exact { judge: self, family: &family, speed, value, point };
        let mut arcs = Vec::new();
        for sample in family.samples(&cuts)? {
            let x = Root::rational(sample.x)?;
            let member = family.enclosed(&x, sample.side, MEMBER)?;
            arcs.push(Arc { ends: None, member, judged: exact.at(&family.exactly(sample)?)? });
        }
        joined(&family, &cuts, arcs, |cut| exact.at_cut(cut))
    }

    fn functions(
        &self,
        family: &Family,
        speed: Rational,
        value: Rational,
        point: &[Surd; 2],
        momentum: Option<Rational>,
    ) -> Option<Vec<Conic>> {
        let v = family.functions()?;
        let one = v[0].integer(1);
        let number = |value: Rational| one.fraction(value);
        let [w0, v1, v2, v3, rotor_speed, ..] = self.filled(v, number(speed)?, number(value)?, None, &one)?;
        // without damping, the angle is rational or the torque does not depend on it
        let [cos, sin] = [&point[0], &point[1]].map(|c| c.as_fraction());
        let (cos, sin) = match (cos, sin) {
            (Some(cos), Some(sin)) => (cos, sin),
            _ if self.approximation.conservative => return None,
            _ => (Rational::int(1), Rational::int(0)),
        };
        let place = [w0, v1, v2, v3, rotor_speed, number(cos)?, number(sin)?];
        critical(self.approximation, self.energies, &place, momentum)
    }

    /// The verdict on one member, with enclosures, if a symmetry maps it to all others.
    fn by_symmetry(&self, known: &Known<'_>, angle: Option<&Angle>) -> Option<Along> {
        let Shape::Circle { .. } = known.shape else { return None };
        let through = direction(&(known.axis)(BITS[0])?)?;
        if !is_symmetric(self.approximation, self.energies, &through, self.value_as_fraction()) {
            return None;
        }
        let mut judged = Judged::cannot_tell(self.approximation, Reason::TooFine);
        for bits in BITS {
            let (Some(v), Some((_, speed))) = (self.member(known, bits), (known.enclosed)(bits)) else { continue };
            let (one, value) = (Enclosure::integer(1, bits), self.value.enclosure(bits));
            let half_tangent = angle.map(|angle| angle.half_tangent.as_ref().map(|t| t.enclosure(bits)));
            let Some(place) = self.filled(v.clone(), speed, value, half_tangent, &one) else { continue };
            let Some(axis) = fractions(&through, &one) else { continue };
            let pair = unfelt(self.energies, &place, &one);
            let among = Among { tangents: vec![cross(&axis, &v)], axis: Some(axis), pair };
            judged = Judged::among(self.approximation, &place, &among, &one, Enclosure::to_f64);
            if judged.verdict != StabilityVerdict::CannotTell(Reason::TooFine) {
                break;
            }
        }
        Some(self.whole(known, judged))
    }

    /// v of one member of a circle, or a direction of the sphere.
    pub fn member(&self, known: &Known<'_>, bits: usize) -> Option<[Enclosure; 3]> {
        let number = |n: i64| Enclosure::integer(n, bits);
        if known.shape == Shape::Sphere {
            return Some([number(0), number(0), number(1)]);
        }
        let ((centre, _), axis) = ((known.enclosed)(bits)?, (known.axis)(bits)?);
        let least = (0..3).min_by(|&i, &j| axis[i].to_f64().abs().total_cmp(&axis[j].to_f64().abs()))?;
        let beside = cross(&axis, &[0, 1, 2].map(|i| number(i64::from(i == least))));
        let square = |a: &[Enclosure; 3]| a.iter().fold(number(0), |sum, a| &sum + &(a * a));
        let reach = (&number(1) - &square(&centre)).over(&square(&beside))?.sqrt()?;
        Some([0, 1, 2].map(|i| &centre[i] + &(&reach * &beside[i])))
    }
}

/// Data common to the members of a family.
struct Exact<'a> {
    judge: &'a Judge<'a>,
    family: &'a Family,
    speed: Rational,
    value: Rational,
    point: [Surd; 2],
}

impl Exact<'_> {
    fn at(&self, v: &[Surd; 3]) -> Option<Judged> {
        let Exact { judge, family, speed, value, point } = self;
        let root = v.iter().find(|c| c.as_fraction().is_none()).copied().unwrap_or_else(|| Rational::int(1).into());
        let [one, speed, value] = [Rational::int(1), *speed, *value].map(|c| Tower::from(Surd::from(c)));
        let [cos, sin] = point.map(|c| Tower::beside(c, &root));
        let v = v.map(Tower::from);
        let [w0, v1, v2, v3, rotor_speed, ..] = judge.filled(v, speed, value, None, &one)?;
        let place = [w0, v1, v2, v3, rotor_speed, cos, sin];
        let approximation = judge.approximation;
        let along = if family.sphere { &judge.energies.mixed } else { &family.axis };
        let symmetric = is_symmetric(approximation, judge.energies, along, Some(self.value));
        // without weight and rotation all axes are equivalent
        let moves = !approximation.balanced || speed.sign() != Some(0);
        let axis = Some(fractions(along, &one)?)
            .filter(|axis| symmetric && moves && cross(axis, &v).iter().any(|c| c.sign() != Some(0)));
        let among = Among { tangents: family.tangents(&v)?, axis, pair: None };
        Some(Judged::among(approximation, &place, &among, &one, Tower::to_f64))
    }

    /// The verdict at a cut; undecided at an irrational one.
    fn at_cut(&self, cut: &Cut) -> Option<Judged> {
        let exactly = self.family.exactly_at(cut).map(|v| self.at(&v));
        exactly.unwrap_or_else(|| Some(Judged::cannot_tell(self.judge.approximation, Reason::Edge)))
    }
}

/// Joins adjacent arcs with equal verdicts, including the direction between them.
fn joined(family: &Family, cuts: &[Cut], arcs: Vec<Arc>, at_cut: impl Fn(&Cut) -> Option<Judged>) -> Option<Along> {
    let alike = |a: &Judged, b: &Judged| a.verdict == b.verdict && a.along == b.along;
    let place = |cut: &Cut| -> Option<Vector3<f64>> {
        Some(Vector3::from(family.enclosed(&cut.at.x, cut.at.side, 64)?.each_ref().map(Enclosure::to_f64)))
    };
    let count = arcs.len();
    let mut edges: Vec<(usize, Edge)> = Vec::new();
    for (k, cut) in cuts.iter().enumerate() {
        // each cut of a circle has an arc on both sides; the poles of a meridian have one
        let before = if family.sphere { k.checked_sub(1) } else { Some((k + count - 1) % count) };
        let behind = Some(k).filter(|k| *k < count);
        let beside: Vec<&Judged> = [before, behind].into_iter().flatten().map(|k| &arcs[k].judged).collect();
        let pole = family.sphere && cut.at.side == 0;
        let same = beside.windows(2).all(|pair| alike(pair[0], pair[1]));
        if !cut.edge && !pole && same {
            continue;
        }
        let mut judged = at_cut(cut)?;
        // here the family leaves the level of the integrals to second order: the verdict transverse to it does not
        // suffice
        if beside.iter().any(|one| one.aside < judged.aside)
            && !matches!(judged.verdict, StabilityVerdict::Unstable { .. })
        {
            judged.verdict = StabilityVerdict::CannotTell(Reason::Edge);
        }
        if !(same && beside.first().is_some_and(|one| alike(one, &judged) || pole && one.verdict == judged.verdict)) {
            edges.push((k, Edge { direction: place(cut)?, judged }));
        }
    }
    if edges.is_empty() || family.sphere && edges.iter().all(|(k, _)| *k == 0 || *k == count) {
        let first = arcs.into_iter().next()?;
        return Some(Along { arcs: vec![first], edges: edges.into_iter().map(|(_, edge)| edge).collect() });
    }
    let mut stations: Vec<(usize, Vector3<f64>)> = edges.iter().map(|(k, edge)| (*k, edge.direction)).collect();
    if family.sphere {
        // poles bound the first and the last zone, edges or not
        stations.retain(|(k, _)| *k != 0 && *k != count);
        stations.insert(0, (0, place(cuts.first()?)?));
        stations.push((count, place(cuts.last()?)?));
    }
    let next = stations.iter().skip(1).chain((!family.sphere).then(|| stations.first()).flatten());
    let bounds: Vec<(usize, [Vector3<f64>; 2])> =
        stations.iter().zip(next).map(|((k, from), (_, to))| (*k, [*from, *to])).collect();
    let arcs = bounds.into_iter().map(|(k, ends)| Arc { ends: Some(ends), ..arcs[k].clone() }).collect();
    Some(Along { arcs, edges: edges.into_iter().map(|(_, edge)| edge).collect() })
}

fn fractions<R: Ordered>(v: &Vector3<Rational>, one: &R) -> Option<[R; 3]> {
    Some([one.fraction(v.x)?, one.fraction(v.y)?, one.fraction(v.z)?])
}
