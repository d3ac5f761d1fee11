//! Exact gyrostats that exist as bodies, as examples and counterexamples.
//!
//! The rotor has m' = 1 kg, its centre in O, and A' = B'; the carrier has 100 kg. A* is then the carrier's tensor plus
//! A' times the identity, so that its principal axes are those of the data.

use super::letters::Letters;
use claims::Point;
use field::{Rational, Scalar};
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;
use systems::gyrostat::{Carrier, Gyrostat, MotionInstant, Rotor};

/// A gyrostat with a direction of rotation, a field speed and, where needed, an angular velocity about the vertical.
#[derive(Clone, Copy, Debug)]
pub struct Example {
    /// The statement that the example illustrates or refutes.
    pub name: &'static str,
    pub gyrostat: Gyrostat<Rational>,
    /// The weight Gamma, N m.
    pub gamma: Rational,
    /// The direction e of the centre of mass.
    pub direction: Vector3<Rational>,
    /// The vertical nu, in body axes.
    pub vertical: Vector3<Rational>,
    /// The field speed W, rad/s.
    pub field_speed: Rational,
    /// The angular velocity w0, rad/s; `None` where the statement concerns all values.
    pub angular_velocity: Option<Rational>,
}

/// A vector with integer components over a common denominator.
fn vector(components: [i64; 3], denominator: i64) -> Vector3<Rational> {
    Vector3::from(components.map(|c| Rational::new(c, denominator)))
}

struct Data {
    /// The principal moments of A*.
    full: [i64; 3],
    axis: Vector3<Rational>,
    gamma: i64,
    direction: Vector3<Rational>,
    vertical: Vector3<Rational>,
    angular_velocity: Option<Rational>,
}

impl Data {
    /// The example with these data, A' = B' = 1 and W = 1.
    fn example(self, name: &'static str) -> Example {
        let (mass, gravity) = (Rational::int(100), Rational::int(10));
        let gamma = Rational::int(self.gamma);
        let gyrostat = Gyrostat {
            carrier: Carrier {
                mass,
                centre: self.direction * (gamma / (mass * gravity)),
                inertia: Matrix3::from_diagonal(&vector(self.full.map(|a| a - 1), 1)),
            },
            rotor: Rotor {
                mass: Rational::int(1),
                centre: Vector3::zeros(),
                axis: self.axis,
                axial: Rational::int(1),
                transverse: Rational::int(1),
            },
            gravity,
        };
        Example {
            name,
            gyrostat,
            gamma,
            direction: self.direction,
            vertical: self.vertical,
            field_speed: Rational::int(1),
            angular_velocity: self.angular_velocity,
        }
    }
}

/// Statement 3B: a spherical A* without weight; the rotor's axis is the only axis of rotation.
pub fn spherical() -> Example {
    balanced([3, 3, 3]).example("spherical tensor, balanced; vertical across the rotor's axis")
}

/// Statement 3B: A2* = A3*, the rotor along the axis of symmetry, the vertical perpendicular to it.
pub fn symmetric() -> Example {
    balanced([4, 3, 3]).example("symmetric tensor, balanced; vertical across the rotor's axis")
}

fn balanced(full: [i64; 3]) -> Data {
    Data {
        full,
        axis: vector([1, 0, 0], 1),
        gamma: 0,
        direction: vector([1, 0, 0], 1),
        vertical: vector([0, 3, 4], 5),
        angular_velocity: None,
    }
}

/// Statement 3C: distinct principal moments, the vertical along a principal axis other than the rotor's.
pub fn principal_axis() -> Example {
    Data {
        full: [3, 4, 5],
        axis: vector([2, 1, 2], 3),
        gamma: 0,
        direction: vector([1, 0, 0], 1),
        vertical: vector([1, 0, 0], 1),
        angular_velocity: None,
    }
    .example("three different moments, balanced; vertical along a principal axis")
}

/// Statement 3D: a rotation whose angular velocity has the sign opposite to the printed formula.
pub fn opposite_sign() -> Example {
    Data {
        full: [3, 4, 5],
        axis: vector([4, 3, 0], 5),
        gamma: 0,
        direction: vector([1, 0, 0], 1),
        vertical: vector([3, 4, 0], 5),
        // w0 = -A' W (l1 nu2 - l2 nu1) / ((A1 - A2) nu1 nu2) = (7/25) / (12/25)
        angular_velocity: Some(Rational::new(7, 12)),
    }
    .example("balanced, rotor's axis and vertical in one principal plane")
}

/// Statement 5: a spherical A*, l perpendicular to e: a rotation exists although Pi* is not identically zero.
pub fn across() -> Example {
    Data {
        full: [3, 3, 3],
        axis: vector([1, 0, 0], 1),
        gamma: 4,
        direction: vector([0, 1, 0], 1),
        // nu is parallel to A' W w0 l + Gamma e = (3, 4, 0)
        vertical: vector([3, 4, 0], 5),
        angular_velocity: Some(Rational::int(3)),
    }
    .example("spherical tensor, centre of mass across the rotor's axis")
}

/// Statement 5: a spherical A*, l = e: (7.4) and (7.7) hold for every direction and angular velocity, (6.5) does not.
pub fn along() -> Example {
    Data {
        full: [3, 3, 3],
        axis: vector([1, 0, 0], 1),
        gamma: 4,
        direction: vector([1, 0, 0], 1),
        vertical: vector([3, 4, 0], 5),
        angular_velocity: Some(Rational::int(1)),
    }
    .example("spherical tensor, centre of mass on the rotor's axis")
}

/// Statement 6: rotor, centre of mass and vertical in one principal plane: S* = Pi* = V* = 0, and w0 is determined.
pub fn plane() -> Example {
    in_a_plane([3, 4, 0]).example("rotor's axis, centre of mass and vertical in one principal plane")
}

/// Remark 3: nu3 = 0 and the first two of (6.5) hold, the third does not.
pub fn two_of_three() -> Example {
    in_a_plane([4, 3, 0]).example("first two relations hold, the third does not")
}

fn in_a_plane(vertical: [i64; 3]) -> Data {
    Data {
        full: [3, 4, 5],
        axis: vector([1, 0, 0], 1),
        gamma: 4,
        direction: vector([0, 1, 0], 1),
        vertical: vector(vertical, 5),
        angular_velocity: Some(Rational::int(1)),
    }
}

/// (7.11) on the spherical line at a principal axis: S* = V* = 0 but Pi* != 0, and no rotation exists.
pub fn on_the_line() -> Example {
    Data {
        full: [3, 4, 5],
        axis: vector([2, 1, 2], 3),
        gamma: 4,
        direction: vector([2, 2, 1], 3),
        vertical: vector([1, 0, 0], 1),
        angular_velocity: None,
    }
    .example("three different moments; vertical along a principal axis")
}

/// (5.2): a thin rod of mass 3 kg and length 1 m from O along the rotor's axis, with the rotor at its end: D = 0.
pub fn rod() -> Gyrostat<Rational> {
    let (one, three) = (Rational::int(1), Rational::int(3));
    Gyrostat {
        carrier: Carrier {
            mass: three,
            centre: vector([1, 0, 0], 2),
            inertia: Matrix3::from_diagonal(&vector([0, 1, 1], 1)),
        },
        rotor: Rotor {
            mass: one,
            centre: vector([1, 0, 0], 1),
            axis: vector([1, 0, 0], 1),
            axial: one,
            transverse: one,
        },
        gravity: Rational::int(10),
    }
}

/// All examples on steady motions.
pub fn all() -> Vec<Example> {
    vec![
        spherical(),
        symmetric(),
        principal_axis(),
        opposite_sign(),
        across(),
        along(),
        plane(),
        on_the_line(),
        two_of_three(),
    ]
}

impl Example {
    /// The values of the paper's symbols.
    pub fn point(&self, s: &Letters) -> Point {
        let full = self.gyrostat.full_tensor();
        let rotor = self.gyrostat.rotor;
        let vectors = [(s.l, rotor.axis), (s.e, self.direction), (s.nu, self.vertical), (s.a_star, full.diagonal())];
        let scalars = [(s.axial, rotor.axial), (s.big_gamma, self.gamma), (s.omega_field, self.field_speed)];
        Point::of(
            vectors
                .into_iter()
                .flat_map(|(names, values)| (0..3).map(move |i| (names[i], values[i])))
                .chain(scalars)
                .chain(self.angular_velocity.map(|value| (s.omega0, value))),
        )
    }

    /// The rotation about the vertical with a given angular velocity (rad/s); the rotor has the field's speed and no
    /// torque.
    pub fn rotation(&self, angular_velocity: Rational) -> MotionInstant<Rational> {
        MotionInstant {
            angular_velocity: self.vertical * angular_velocity,
            vertical: self.vertical,
            rotor_speed: self.field_speed,
            angular_acceleration: Vector3::zeros(),
            rotor_acceleration: Rational::zero(),
            torque: Rational::zero(),
        }
    }

    /// The residual torques about O of this rotation (N m), by the theorem of angular momentum.
    pub fn residual_torques(&self, angular_velocity: Rational) -> Vector3<Rational> {
        let [x, y, z, _] = self.gyrostat.by_momentum(&self.rotation(angular_velocity));
        Vector3::new(x, y, z)
    }
}
