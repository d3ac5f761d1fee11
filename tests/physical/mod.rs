//! Random gyrostats composed of mass points, so that their bodies can exist, and every machine with random data.

#![allow(dead_code, reason = "each test uses its part")]

pub mod machines;
pub mod rate;
pub mod steady;

use dalembert_derivations::systems::gyrostat::{Carrier, Gyrostat, MotionInstant, Rotor};
use field::{DoubleDouble, Rational, Scalar};
use mechanics::rotation::{determinant, quaternion};
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

pub type Vector = Vector3<Rational>;

/// A configuration with a fixed seed: every run tests the same random cases.
pub fn fixed(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, rng_seed: RngSeed::Fixed(1834), failure_persistence: None, ..ProptestConfig::default() }
}

#[derive(Clone, Copy, Debug)]
pub struct MassPoint {
    pub mass: Rational,
    pub place: Vector,
}

/// Two rigid bodies as lists of mass points.
#[derive(Clone, Debug)]
pub struct Bodies {
    /// The points of the carrier; positions relative to O.
    pub carrier: Vec<MassPoint>,
    /// The points of the rotor; positions relative to C'. They form rings about the axis, each of four points, in pairs
    /// on both sides of C'.
    pub rotor: Vec<MassPoint>,
    /// The position h of the rotor's centre.
    pub centre: Vector,
    /// The unit vector l of the rotor's axis.
    pub axis: Vector,
    pub gravity: Rational,
}

impl Bodies {
    /// The data of the bodies, each computed from its definition as a sum.
    pub fn gyrostat(&self) -> Gyrostat<Rational> {
        let (mass, spin) = (total_mass(&self.rotor), inertia(&self.rotor));
        let axial = self.axis.dot(&(spin * self.axis));
        Gyrostat {
            carrier: Carrier {
                mass: total_mass(&self.carrier),
                centre: self.carrier.iter().map(|p| p.place * p.mass).sum::<Vector>() / total_mass(&self.carrier),
                inertia: inertia(&self.carrier),
            },
            rotor: Rotor {
                mass,
                centre: self.centre,
                axis: self.axis,
                axial,
                transverse: (spin.trace() - axial).half(),
            },
            gravity: self.gravity,
        }
    }
}

/// The total mass: the sum of m.
pub fn total_mass(points: &[MassPoint]) -> Rational {
    points.iter().fold(Rational::zero(), |sum, p| sum + p.mass)
}

/// The inertia tensor: the sum of m (r.r 1 - r r^T).
pub fn inertia(points: &[MassPoint]) -> Matrix3<Rational> {
    let of = |r: Vector| Matrix3::identity() * r.dot(&r) - r * r.transpose();
    points.iter().map(|p| of(p.place) * p.mass).sum()
}

fn fraction(numerators: std::ops::Range<i64>, denominator: i64) -> impl Strategy<Value = Rational> {
    numerators.prop_map(move |n| Rational::new(n, denominator))
}

pub fn vector(numerators: std::ops::Range<i64>, denominator: i64) -> impl Strategy<Value = Vector> {
    let component = || fraction(numerators.clone(), denominator);
    [component(), component(), component()].prop_map(Vector3::from)
}

/// Three orthonormal, right-handed axes as the columns of a rotation matrix.
pub fn axes() -> impl Strategy<Value = Matrix3<Rational>> {
    [-4..5i64, -4..5, -4..5, 1..5].prop_map(|q| quaternion(q.map(Rational::int)))
}

/// Between four and six mass points of the carrier that are not all on one line.
fn carrier() -> impl Strategy<Value = Vec<MassPoint>> {
    let point = (fraction(1..20, 4), vector(-9..10, 10)).prop_map(|(mass, place)| MassPoint { mass, place });
    prop::collection::vec(point, 4..7).prop_filter("not on a line", |p| !determinant(&inertia(p)).is_zero())
}

/// A ring of four points about the third axis, and its mirror image on the other side.
fn rings(frame: Matrix3<Rational>, mass: Rational, radius: Rational, height: Rational) -> Vec<MassPoint> {
    let (o, r) = (Rational::zero(), radius);
    [(r, o), (o, r), (-r, o), (o, -r)]
        .into_iter()
        .flat_map(|(x, y)| [height, -height].map(|z| MassPoint { mass, place: frame * Vector3::new(x, y, z) }))
        .collect()
}

/// Arbitrary bodies; the rotor may be anything from a disc to a drum.
pub fn bodies() -> impl Strategy<Value = Bodies> {
    let ring = || (fraction(1..12, 8), fraction(1..8, 10), fraction(0..8, 10));
    let rotor = (axes(), ring(), ring()).prop_map(|(frame, a, b)| {
        let points = [a, b].into_iter().flat_map(|(mass, radius, height)| rings(frame, mass, radius, height));
        (points.collect(), frame.column(2).into())
    });
    (carrier(), rotor, vector(-9..10, 10), fraction(0..200, 20))
        .prop_map(|(carrier, (rotor, axis), centre, gravity)| Bodies { carrier, rotor, centre, axis, gravity })
}

/// A random gyrostat whose bodies can exist.
pub fn gyrostat() -> impl Strategy<Value = Gyrostat<Rational>> {
    bodies().prop_map(|bodies| bodies.gyrostat())
}

/// The data in another scalar type.
pub fn seen<S: Scalar>(g: &Gyrostat<Rational>, number: impl Fn(Rational) -> S + Copy) -> Gyrostat<S> {
    Gyrostat {
        carrier: Carrier {
            mass: number(g.carrier.mass),
            centre: g.carrier.centre.map(number),
            inertia: g.carrier.inertia.map(number),
        },
        rotor: Rotor {
            mass: number(g.rotor.mass),
            centre: g.rotor.centre.map(number),
            axis: g.rotor.axis.map(number),
            axial: number(g.rotor.axial),
            transverse: number(g.rotor.transverse),
        },
        gravity: number(g.gravity),
    }
}

/// The gyrostat in double precision.
pub fn rounded(g: &Gyrostat<Rational>) -> Gyrostat<f64> {
    seen(g, Rational::to_f64)
}

/// The gyrostat in double-double, with the axis normalised to 31 digits instead of 16.
pub fn rounded_twice(g: &Gyrostat<Rational>) -> Gyrostat<DoubleDouble> {
    seen(g, |x| {
        let big = x.to_big().expect("no division by zero");
        let small = "the data are fractions of small numbers";
        DoubleDouble::ratio(big.numerator().try_into().expect(small), big.denominator().try_into().expect(small))
    })
}

/// A random instant, with independent velocities, accelerations and torque.
pub fn motion() -> impl Strategy<Value = MotionInstant<Rational>> {
    let number = || fraction(-30..31, 7);
    (vector(-30..31, 7), axes(), number(), vector(-30..31, 7), number(), number()).prop_map(
        |(angular_velocity, axes, rotor_speed, angular_acceleration, rotor_acceleration, torque)| MotionInstant {
            angular_velocity,
            vertical: axes.column(0).into(),
            rotor_speed,
            angular_acceleration,
            rotor_acceleration,
            torque,
        },
    )
}
