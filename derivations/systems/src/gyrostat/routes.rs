//! The equations of motion of the gyrostat by four principles; only the data of the bodies are common to them.
//!
//! Each principle gives four residuals that are zero along a motion: three for the carrier (torques about the body
//! axes, N m) and one for the rotor (torque about l, N m).

use super::Gyrostat;
use field::{Analytic, Base, Over, Tangent};
use mechanics::differentiate::{along, gradient};
use mechanics::mass::AffineField;
use mechanics::momentum::absolute_rate;
use mechanics::rotation::{angular_velocity, euler, euler_forms, inverse, vertical};
use mechanics::{appell::appell, hamel::boltzmann_hamel, lagrange::lagrange};
use nalgebra::{Matrix4, Vector3};

/// One instant of a motion: velocities, accelerations, the vertical, and the torque on the rotor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionInstant<S: field::Scalar> {
    /// The angular velocity w, rad/s.
    pub angular_velocity: Vector3<S>,
    /// The unit vector v of the vertical, downwards.
    pub vertical: Vector3<S>,
    /// The rotor's relative speed phi', rad/s.
    pub rotor_speed: S,
    /// The angular acceleration w', rad/s^2.
    pub angular_acceleration: Vector3<S>,
    /// The rotor's relative acceleration phi'', rad/s^2.
    pub rotor_acceleration: S,
    /// The torque M, N m.
    pub torque: S,
}

impl<P: Base> Gyrostat<P> {
    /// The angular momentum x of all mass points about O, and that of the rotor's points about C', kg m^2/s.
    pub fn angular_momentum<S: Over<P>>(&self, w: Vector3<S>, rotor_speed: S) -> [Vector3<S>; 2] {
        let [carrier, rotor] = self.velocities::<S>(w, rotor_speed);
        let own = AffineField::place(Vector3::zeros());
        let centre = AffineField::place(self.rotor.centre.map(S::lift));
        let of_carrier = self.carrier_points::<S>().cross(&own, &carrier);
        let of_rotor = self.rotor_points::<S>().cross(&centre, &rotor);
        [of_carrier + of_rotor, self.rotor_points::<S>().cross(&own, &rotor)]
    }

    /// The residuals by the theorem of angular momentum: for all mass points about O, and for the rotor's points about
    /// C' in the direction l.
    pub fn by_momentum<S: Over<P>>(&self, motion: &MotionInstant<S>) -> [S; 4] {
        let w = motion.angular_velocity;
        let moving = Vector3::from(along(w.into(), motion.angular_acceleration.into()));
        let rotor_speed = Tangent::moving(motion.rotor_speed, motion.rotor_acceleration);
        let [all, spin] = self.angular_momentum(moving, rotor_speed);
        let weight = self.first_moment().map(S::lift) * S::lift(self.gravity);
        let total = absolute_rate(all, w) - weight.cross(&motion.vertical);
        let axial = absolute_rate(spin, w).dot(&self.rotor.axis.map(S::lift)) - motion.torque;
        [total.x, total.y, total.z, axial]
    }

    /// The residuals by Appell's equations, from the acceleration energy of the mass points.
    pub fn by_appell<S: Over<P>>(&self, motion: &MotionInstant<S>) -> [S; 4] {
        let w = motion.angular_velocity.map(Tangent::fixed);
        let rotor_speed = Tangent::fixed(motion.rotor_speed);
        let a = motion.angular_acceleration;
        let left = appell(
            |[x, y, z, f]| self.acceleration_energy(w, rotor_speed, Vector3::new(x, y, z), f),
            [a.x, a.y, a.z, motion.rotor_acceleration],
        );
        // the power of the weight is linear in w; its coefficients are the generalised forces
        let power = gradient(
            |[x, y, z]| {
                let w = Vector3::new(x, y, z);
                let v = motion.vertical.map(Tangent::fixed);
                -self.potential_energy::<Tangent<S>>(v.cross(&w))
            },
            motion.angular_velocity.into(),
        );
        [left[0] - power[0], left[1] - power[1], left[2] - power[2], left[3] - motion.torque]
    }

    /// The residuals by Lagrange's equations in Euler's angles and the rotor's angle, with L = T - V, one for each
    /// coordinate. `torque` is the torque M, which is the generalised force of the rotor's angle.
    pub fn by_lagrange<S: Over<P> + Analytic>(
        &self,
        angles: [S; 4],
        rates: [S; 4],
        accelerations: [S; 4],
        torque: S,
    ) -> [S; 4] {
        let mut residual = lagrange(
            |[a, b, c, _], [da, db, dc, rotor_speed]| {
                let turning = euler(along([a, b, c], [da, db, dc]));
                let vertical = vertical(&turning.map(|x| x.value));
                let w = angular_velocity(turning);
                self.kinetic_energy(w, rotor_speed) - self.potential_energy(vertical)
            },
            angles,
            rates,
            accelerations,
        );
        residual[3] -= torque;
        residual
    }

    /// The residuals by the equations of Boltzmann and Hamel in the quasi-velocities (w, phi'), with kinematics in
    /// Euler's angles.
    pub fn by_hamel<S: Over<P> + Analytic>(&self, angles: [S; 4], motion: &MotionInstant<S>) -> [S; 4] {
        let fields = |[a, b, c, _]: [Tangent<S>; 4]| bordered(inverse(&euler_forms([a, b, c])));
        let forms = bordered(euler_forms([angles[0], angles[1], angles[2]]));
        let (w, a) = (motion.angular_velocity, motion.angular_acceleration);
        let mut residual = boltzmann_hamel(
            |[x, y, z, f]| self.kinetic_energy(Vector3::new(x, y, z), f),
            forms,
            fields,
            angles,
            [w.x, w.y, w.z, motion.rotor_speed],
            [a.x, a.y, a.z, motion.rotor_acceleration],
        );
        // X_j(V): the derivative of the potential energy along the vector field X_j
        let slope =
            gradient(|[a, b, c]| self.potential_energy(vertical(&euler([a, b, c]))), [angles[0], angles[1], angles[2]]);
        let velocities = inverse(&euler_forms([angles[0], angles[1], angles[2]]));
        let along_fields = velocities.transpose() * Vector3::from(slope);
        for i in 0..3 {
            residual[i] += along_fields[i];
        }
        residual[3] -= motion.torque;
        residual
    }
}

/// A matrix of the carrier, extended by a unit row and column for the rotor's angle.
fn bordered<S: field::Scalar>(m: nalgebra::Matrix3<S>) -> Matrix4<S> {
    let mut bordered = Matrix4::identity();
    bordered.fixed_view_mut::<3, 3>(0, 0).copy_from(&m);
    bordered
}
