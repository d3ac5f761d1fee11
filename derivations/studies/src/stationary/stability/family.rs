//! Connected families of steady directions with one angular velocity, as rational curves.
//!
//! A circle is v = c + x e1 + y e2 with |x e1|^2 + |y e2|^2 = 1 - |c|^2. On a sphere of motions stability depends only
//! on the angle from the rotor's axis: either the tensor is isotropic and the weight along the axis, or there is
//! neither rotation nor weight, and v is any direction. A meridian therefore represents the sphere.

use algebra::real::{Conic, ConicPoint, Enclosure, Ordered, Polynomial, Root, Surd};
use field::{Rational, Scalar};
use nalgebra::Vector3;

/// A circle of directions, or a meridian that represents a sphere.
#[derive(Clone, Debug)]
pub struct Family {
    centre: Vector3<Rational>,
    /// The vectors e1 and e2, orthogonal to each other and to the axis.
    across: [Vector3<Rational>; 2],
    /// The axis of the circle, or the normal of the meridian's plane.
    pub axis: Vector3<Rational>,
    /// The value 1 - |c|^2.
    room: Rational,
    /// Whether the curve represents a sphere: e1 is then the rotor's axis.
    pub sphere: bool,
}

/// A point of the curve: x, and the side y > 0 or y < 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    pub x: Rational,
    pub side: i32,
}

/// A point at which a curve is cut.
#[derive(Clone, Debug)]
pub struct Cut {
    pub at: ConicPoint,
    /// Whether a critical function vanishes here; otherwise only y does.
    pub edge: bool,
}

impl Cut {
    /// The order along the curve: x greatest, y > 0, x least, y < 0.
    fn quarter(&self) -> u8 {
        match self.at.side {
            0 if is_left(&self.at.x) => 2,
            0 => 0,
            side if side > 0 => 1,
            _ => 3,
        }
    }
}

impl Family {
    /// The circle with a rational centre and an axis with rational ratios.
    pub fn circle(centre: &[Enclosure; 3], axis: &[Enclosure; 3]) -> Option<Self> {
        let centre = Vector3::from(centre.each_ref().map(Enclosure::simplest));
        let axis = direction(axis)?;
        let room = Rational::int(1) - centre.dot(&centre);
        let on_axis = centre.cross(&axis).iter().all(|c| c.sign() == Some(0));
        (on_axis && room.sign() == Some(1)).then(|| Family { centre, across: beside(&axis), axis, room, sphere: false })
    }

    /// The meridian of a sphere through an axis.
    pub fn meridian(through: &Vector3<Rational>) -> Self {
        let [across, axis] = beside(through);
        Family {
            centre: Vector3::repeat(Rational::int(0)),
            across: [*through, across],
            axis,
            room: Rational::int(1),
            sphere: true,
        }
    }

    /// v as a function on the curve.
    pub fn functions(&self) -> Option<[Conic; 3]> {
        let [first, second] = self.squares();
        let [x, y] = Conic::coordinates(self.room / second, first / second)?;
        self.place(&x, &y)
    }

    /// v at a rational point.
    pub fn exactly(&self, at: Sample) -> Option<[Surd; 3]> {
        let [first, second] = self.squares();
        let y = Surd::root_of((self.room - first * at.x * at.x) / second)?;
        self.place(&at.x.into(), &y.times(&y.integer(at.side.into())))
    }

    /// v at an irrational point, enclosed.
    pub fn enclosed(&self, x: &Root, side: i32, bits: usize) -> Option<[Enclosure; 3]> {
        let [first, second] = self.squares();
        let x = x.enclosure(2 * bits);
        let number = |value: Rational| Enclosure::rational(value, 2 * bits);
        let square = &(&x * &x) * &number(first)?;
        let y = match side {
            0 => number(Rational::int(0))?,
            _ => (&number(self.room)? - &square).over(&number(second)?)?.sqrt()?,
        };
        self.place(&x, &(&y * &Enclosure::integer(side, 2 * bits)))
    }

    /// The curve cut at points and where y = 0, in the order along the curve, y > 0 first; for a meridian the half from
    /// pole to pole.
    pub fn cuts(&self, points: Vec<ConicPoint>) -> Option<Vec<Cut>> {
        let ends = Polynomial::from_rationals(&[-self.room, Rational::int(0), self.squares()[0]])?.real_roots();
        let seam = |x: &Root| Cut { at: ConicPoint { x: x.clone(), side: 0 }, edge: false };
        let mut cuts: Vec<Cut> = ends.iter().map(seam).collect();
        for at in points.into_iter().filter(|at| !self.sphere || at.side >= 0) {
            match cuts.iter_mut().find(|cut| cut.at.side == at.side && cut.at.x.compare(&at.x).is_eq()) {
                Some(known) => known.edge = true,
                None => cuts.push(Cut { at, edge: true }),
            }
        }
        cuts.sort_by(|a, b| {
            a.quarter().cmp(&b.quarter()).then_with(|| match a.quarter() {
                1 => b.at.x.compare(&a.at.x),
                _ => a.at.x.compare(&b.at.x),
            })
        });
        Some(cuts)
    }

    /// A point between each cut and the next one; the last point lies before the first cut.
    pub fn samples(&self, cuts: &[Cut]) -> Option<Vec<Sample>> {
        let next = cuts.iter().skip(1).chain(cuts.first());
        let all = cuts.iter().zip(next).map(|(cut, next)| {
            let side = if cut.quarter() < 2 { 1 } else { -1 };
            Some(Sample { x: fraction_between(&cut.at.x, &next.at.x)?, side })
        });
        all.filter(|sample| !self.sphere || sample.as_ref().is_none_or(|sample| sample.side > 0)).collect()
    }

    /// v at a cut, if one square root suffices.
    pub fn exactly_at(&self, cut: &Cut) -> Option<[Surd; 3]> {
        if cut.at.side == 0 {
            let x = Surd::root_of(self.room / self.squares()[0])?;
            let zero = x.integer(0);
            return self.place(&if is_left(&cut.at.x) { zero.minus(&x) } else { x }, &zero);
        }
        let x = cut.at.x.enclosure(64).simplest();
        let same = Root::rational(x)?.compare(&cut.at.x).is_eq();
        same.then(|| self.exactly(Sample { x, side: cut.at.side })).flatten()
    }

    /// Directions along the family at v: one along a circle; two on a sphere, along the parallel and along the meridian.
    pub fn tangents<R: Ordered>(&self, v: &[R; 3]) -> Option<Vec<[R; 3]>> {
        let vector = |a: &Vector3<Rational>| -> Option<[R; 3]> {
            Some([v[0].fraction(a.x)?, v[0].fraction(a.y)?, v[0].fraction(a.z)?])
        };
        if !self.sphere {
            return Some(vec![cross(&vector(&self.axis)?, v)]);
        }
        let parallel = cross(&vector(&self.across[0])?, v);
        if parallel.iter().all(|c| c.sign() == Some(0)) {
            return Some(vec![vector(&self.across[1])?, vector(&self.axis)?]);
        }
        let meridian = cross(v, &parallel);
        Some(vec![parallel, meridian])
    }

    fn place<R: Ordered>(&self, x: &R, y: &R) -> Option<[R; 3]> {
        let component = |i: usize| -> Option<R> {
            let [along, beside] = [x.times(&x.fraction(self.across[0][i])?), y.times(&y.fraction(self.across[1][i])?)];
            Some(x.fraction(self.centre[i])?.plus(&along).plus(&beside))
        };
        Some([component(0)?, component(1)?, component(2)?])
    }

    /// The squares |e1|^2, |e2|^2.
    fn squares(&self) -> [Rational; 2] {
        self.across.map(|e| e.dot(&e))
    }
}

fn is_left(x: &Root) -> bool {
    x.sign_of(&Polynomial::from_integers([0, 1])) < 0
}

/// Two vectors orthogonal to a given one and to each other.
pub fn beside(axis: &Vector3<Rational>) -> [Vector3<Rational>; 2] {
    let least = axis.map(|c| c.to_f64().abs()).imin();
    let unit = Vector3::from_fn(|i, _| Rational::int(i64::from(i == least)));
    let first = axis.cross(&unit);
    [first, axis.cross(&first)]
}

/// A rational vector with the largest component 1, where the ratios are rational.
pub fn direction(axis: &[Enclosure; 3]) -> Option<Vector3<Rational>> {
    let largest = (0..3).max_by(|&i, &j| axis[i].to_f64().abs().total_cmp(&axis[j].to_f64().abs()))?;
    let ratio = |i: usize| axis[i].over(&axis[largest]).map(|ratio| ratio.simplest());
    Some(Vector3::new(ratio(0)?, ratio(1)?, ratio(2)?))
}

/// The vector product a x b.
pub fn cross<R: Ordered>(a: &[R; 3], b: &[R; 3]) -> [R; 3] {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j].times(&b[k]).minus(&a[k].times(&b[j]))
    })
}

/// The simplest fraction between two different roots.
fn fraction_between(a: &Root, b: &Root) -> Option<Rational> {
    let mut bits = 32;
    loop {
        let (a, b) = (a.enclosure(bits), b.enclosure(bits));
        if a.is_apart_from(&b) {
            // well between them
            let both = &a.middle() + &b.middle();
            let middle = both.over(&Enclosure::integer(2, bits))?;
            let width = (&a.middle() - &b.middle()).over(&Enclosure::integer(4, bits))?;
            let (low, high) = (&middle - &width, &middle + &width);
            return Some(low.hull(&high).simplest());
        }
        bits *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn samples_lie_between_their_cuts_once_round_the_circle() {
        let axis = Vector3::new(0, 0, 1).map(Rational::int);
        let enclose = |v: Vector3<Rational>| [0, 1, 2].map(|i| Enclosure::rational(v[i], 80).unwrap());
        let family = Family::circle(&enclose(axis * Rational::new(3, 5)), &enclose(axis)).unwrap();
        let [v1, v2, _] = family.functions().unwrap();
        let points = [v1.clone(), v2.clone(), v1.minus(&v2)].iter().flat_map(Conic::zeros).collect();
        let cuts = family.cuts(points).unwrap();
        assert_eq!((cuts.len(), cuts.iter().filter(|cut| cut.edge).count()), (6, 6));
        let angle = |v: [f64; 3]| v[1].atan2(v[0]);
        let at =
            |cut: &Cut| angle(family.enclosed(&cut.at.x, cut.at.side, 60).unwrap().each_ref().map(Enclosure::to_f64));
        let places: Vec<f64> = cuts.iter().map(at).collect();
        // e1 and e2 may have either orientation about the third axis
        let sense = if (places[1] - places[0]).rem_euclid(TAU) < 3.0 { 1.0 } else { -1.0 };
        for (k, sample) in family.samples(&cuts).unwrap().into_iter().enumerate() {
            let v = family.exactly(sample).unwrap().each_ref().map(Surd::to_f64);
            assert!((v.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-12 && v[2] == 0.6);
            let turn = |to: f64| (sense * (to - places[k])).rem_euclid(TAU);
            assert!(turn(angle(v)) < turn(places[(k + 1) % 6]), "{k}");
        }
    }
}
