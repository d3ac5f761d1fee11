//! The energies and momenta of the bodies are sums over their mass points, each of which is moved by kinematics only.

use crate::physical::{Bodies, MassPoint, Vector, bodies, fixed, inertia, motion};
use dalembert_derivations::systems::gyrostat::MotionInstant;
use field::{Rational, Scalar, Tangent};
use mechanics::differentiate::along;
use mechanics::mass::{AffineField, MassMoments};
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;
use proptest::prelude::*;

/// A mass point with its position relative to O, its absolute velocity and its absolute acceleration.
struct Moving {
    mass: Rational,
    place: Vector,
    velocity: Vector,
    acceleration: Vector,
}

/// A point's absolute velocity and acceleration, in axes that rotate at w: a' = (relative rate of a) + w x a.
fn moving(
    point: MassPoint,
    centre: Vector,
    spin: Vector3<Tangent<Rational>>,
    motion: &MotionInstant<Rational>,
) -> Moving {
    let w = Vector3::from(along(motion.angular_velocity.into(), motion.angular_acceleration.into()));
    let turn = spin.map(|s| s.value).cross(&point.place);
    let place = Vector3::from(along((centre + point.place).into(), turn.into()));
    let velocity = w.cross(&place) + spin.cross(&(place - centre.map(Tangent::fixed)));
    Moving {
        mass: point.mass,
        place: centre + point.place,
        velocity: velocity.map(|u| u.value),
        acceleration: velocity.map(|u| u.slope) + motion.angular_velocity.cross(&velocity.map(|u| u.value)),
    }
}

fn all(bodies: &Bodies, motion: &MotionInstant<Rational>) -> [Vec<Moving>; 2] {
    let speed = Tangent::moving(motion.rotor_speed, motion.rotor_acceleration);
    let spin = bodies.axis.map(Tangent::fixed) * speed;
    let carrier = bodies.carrier.iter().map(|&p| moving(p, Vector3::zeros(), Vector3::zeros(), motion)).collect();
    [carrier, bodies.rotor.iter().map(|&p| moving(p, bodies.centre, spin, motion)).collect()]
}

fn sum(points: &[Vec<Moving>; 2], of: impl Fn(&Moving) -> Rational) -> Rational {
    points.iter().flatten().fold(Rational::zero(), |sum, p| sum + p.mass * of(p))
}

fn vector_sum(points: &[Vec<Moving>; 2], of: impl Fn(&Moving) -> Vector) -> Vector {
    points.iter().flatten().map(|p| of(p) * p.mass).sum()
}

proptest! {
    #![proptest_config(fixed(64))]

    #[test]
    fn the_rotor_of_rings_has_a_symmetric_tensor(bodies in bodies()) {
        let (tensor, rotor) = (inertia(&bodies.rotor), bodies.gyrostat().rotor);
        let along = rotor.axis * rotor.axis.transpose();
        prop_assert_eq!(tensor, along * rotor.axial + (Matrix3::identity() - along) * rotor.transverse);
    }

    #[test]
    fn kinetic_and_potential_energy_are_sums_over_the_mass_points(bodies in bodies(), motion in motion()) {
        let (g, points) = (bodies.gyrostat(), all(&bodies, &motion));
        let kinetic = sum(&points, |p| p.velocity.dot(&p.velocity).half());
        prop_assert_eq!(g.kinetic_energy::<Rational>(motion.angular_velocity, motion.rotor_speed), kinetic);
        let potential = sum(&points, |p| -(g.gravity * p.place.dot(&motion.vertical)));
        prop_assert_eq!(g.potential_energy::<Rational>(motion.vertical), potential);
        prop_assert_eq!(g.mass(), sum(&points, |_| Rational::int(1)));
        prop_assert_eq!(g.weight(), vector_sum(&points, |p| p.place * g.gravity));
    }

    #[test]
    fn the_acceleration_energy_is_the_sum_over_the_mass_points(bodies in bodies(), motion in motion()) {
        let g = bodies.gyrostat();
        let (w, a) = (motion.angular_velocity, motion.angular_acceleration);
        let energy = g.acceleration_energy(w, motion.rotor_speed, a, motion.rotor_acceleration);
        let by_points = sum(&all(&bodies, &motion), |p| p.acceleration.dot(&p.acceleration).half());
        prop_assert_eq!(energy, by_points);
    }

    #[test]
    fn the_angular_momenta_are_sums_over_the_mass_points(bodies in bodies(), motion in motion()) {
        let g = bodies.gyrostat();
        let points = all(&bodies, &motion);
        let [total, spin] = g.angular_momentum(motion.angular_velocity, motion.rotor_speed);
        prop_assert_eq!(total, vector_sum(&points, |p| p.place.cross(&p.velocity)));
        let [_, rotor] = points;
        let of_rotor = vector_sum(&[vec![], rotor], |p| (p.place - bodies.centre).cross(&p.velocity));
        prop_assert_eq!(spin, of_rotor);
    }

    #[test]
    fn the_theorem_of_angular_momentum_is_newtons_law_summed(bodies in bodies(), motion in motion()) {
        let g = bodies.gyrostat();
        let points = all(&bodies, &motion);
        let moments = vector_sum(&points, |p| p.place.cross(&(p.acceleration - motion.vertical * g.gravity)));
        let [_, rotor] = points;
        let axial = vector_sum(&[vec![], rotor], |p| (p.place - bodies.centre).cross(&p.acceleration));
        let residual = [moments.x, moments.y, moments.z, axial.dot(&bodies.axis) - motion.torque];
        prop_assert_eq!(g.by_momentum(&motion), residual);
    }

    #[test]
    fn integrals_over_a_body_are_sums_over_its_mass_points(bodies in bodies(), motion in motion()) {
        let carrier = &bodies.carrier;
        let moments = bodies.gyrostat().carrier_points::<Rational>();
        let (w, v, a) = (motion.angular_velocity, motion.vertical, motion.angular_acceleration);
        let field = |offset: Vector, turn: Vector| AffineField::place(offset).turned(turn);
        let (p, q) = (field(v, w), field(a, v) + AffineField::place(w).relative());
        let at = |u: &AffineField<Rational>, r: Vector| u.origin + u.gradient * r;
        let dot = carrier.iter().fold(Rational::zero(), |sum, m| sum + m.mass * at(&p, m.place).dot(&at(&q, m.place)));
        let cross: Vector = carrier.iter().map(|m| at(&p, m.place).cross(&at(&q, m.place)) * m.mass).sum();
        prop_assert_eq!(moments.dot(&p, &q), dot);
        prop_assert_eq!(moments.cross(&p, &q), cross);
        prop_assert_eq!(moments.inertia(), inertia(carrier));
        let second: Matrix3<Rational> = carrier.iter().map(|m| m.place * m.place.transpose() * m.mass).sum();
        prop_assert_eq!(MassMoments { second, ..moments }, moments);
    }
}
