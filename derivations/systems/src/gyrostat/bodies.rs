//! The bodies of the gyrostat and their energies.

use field::{Base, Over, Scalar};
use mechanics::mass::{AffineField, MassMoments};
use nalgebra::{Matrix3, Vector3};

/// The carrier: the body with the fixed point O.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carrier<P: Scalar> {
    /// The mass m0, kg.
    pub mass: P,
    /// The position c0 = OC0 of the centre of mass, m.
    pub centre: Vector3<P>,
    /// The inertia tensor A0 about O, kg m^2; off-diagonal components include the minus sign: A12 = -integral of x y
    /// dm.
    pub inertia: Matrix3<P>,
}

/// The rotor: a body that is statically and dynamically balanced about its axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotor<P: Scalar> {
    /// The mass m', kg.
    pub mass: P,
    /// The position h = OC' of the centre of mass, m.
    pub centre: Vector3<P>,
    /// The unit vector l of the axis.
    pub axis: Vector3<P>,
    /// The moment of inertia A' about the axis, kg m^2.
    pub axial: P,
    /// The moment of inertia B', kg m^2, about any axis through C' perpendicular to the rotor's axis.
    pub transverse: P,
}

/// Carrier and rotor in the field of gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gyrostat<P: Scalar> {
    pub carrier: Carrier<P>,
    pub rotor: Rotor<P>,
    /// The acceleration of gravity g, m/s^2.
    pub gravity: P,
}

impl<P: Base> Gyrostat<P> {
    /// The kinetic energy T = 1/2 w.A0 w + 1/2 m' |w x h|^2 + 1/2 w'.J' w' with w' = w + phi' l (Koenig's theorem), J.
    pub fn kinetic_energy<S: Over<P>>(&self, w: Vector3<S>, rotor_speed: S) -> S {
        let Rotor { mass, centre, axis, axial, transverse } = self.rotor.lift::<S>();
        let centre_velocity = w.cross(&centre);
        let spin = w + axis * rotor_speed;
        let along = spin.dot(&axis);
        let across = spin - axis * along;
        let carrier = w.dot(&(self.carrier.inertia.map(S::lift) * w));
        (carrier
            + mass * centre_velocity.dot(&centre_velocity)
            + axial * along * along
            + transverse * across.dot(&across))
        .half()
    }

    /// The potential energy -g v.(m0 c0 + m' h), J.
    pub fn potential_energy<S: Over<P>>(&self, vertical: Vector3<S>) -> S {
        -vertical.dot(&self.first_moment().map(S::lift)) * S::lift(self.gravity)
    }

    /// The first moment of mass m0 c0 + m' h, kg m.
    pub fn first_moment(&self) -> Vector3<P> {
        self.carrier.centre * self.carrier.mass + self.rotor.centre * self.rotor.mass
    }

    /// The total mass m0 + m', kg.
    pub fn mass(&self) -> P {
        self.carrier.mass + self.rotor.mass
    }

    /// The moments of mass of the carrier about O.
    pub fn carrier_points<S: Over<P>>(&self) -> MassMoments<S> {
        let Carrier { mass, centre, inertia } = &self.carrier;
        MassMoments::from_inertia(S::lift(*mass), centre.map(S::lift), inertia.map(S::lift))
    }

    /// The moments of mass of the rotor about C'. Since the rotor is balanced, they do not depend on its angle.
    pub fn rotor_points<S: Over<P>>(&self) -> MassMoments<S> {
        let Rotor { mass, axis, axial, transverse, .. } = self.rotor.lift::<S>();
        let along = axis * axis.transpose();
        let inertia = along * axial + (Matrix3::identity() - along) * transverse;
        MassMoments::from_inertia(mass, Vector3::zeros(), inertia)
    }

    /// The velocity fields: w x r for the carrier, and w x (h + r) + phi' l x r for the rotor.
    pub fn velocities<S: Over<P>>(&self, w: Vector3<S>, rotor_speed: S) -> [AffineField<S>; 2] {
        let rotor = self.rotor.lift::<S>();
        let (own, rotors) = (AffineField::place(Vector3::zeros()), AffineField::place(rotor.centre));
        [own.turned(w), rotors.turned(w) + rotors.relative().turned(rotor.axis * rotor_speed)]
    }

    /// The acceleration energy S = 1/2 integral of a.a dm over both bodies, J/s^2, from the accelerations of the mass
    /// points. Those of the rotor include the Coriolis terms and the terms of its own rotation.
    pub fn acceleration_energy<S: Over<P>>(
        &self,
        w: Vector3<S>,
        rotor_speed: S,
        w_rate: Vector3<S>,
        rotor_acceleration: S,
    ) -> S {
        let rotor = self.rotor.lift::<S>();
        let (own, place) = (AffineField::place(Vector3::zeros()), AffineField::place(rotor.centre));
        let relative = place.relative();
        let spin = rotor.axis * rotor_speed;
        let carrier = own.turned(w_rate) + own.turned(w).turned(w);
        let rotors = place.turned(w_rate)
            + place.turned(w).turned(w)
            + relative.turned(rotor.axis * rotor_acceleration)
            + relative.turned(spin).turned(spin)
            + relative.turned(spin).turned(w * S::int(2));
        (self.carrier_points::<S>().dot(&carrier, &carrier) + self.rotor_points::<S>().dot(&rotors, &rotors)).half()
    }
}

impl<P: Base> Rotor<P> {
    /// The rotor with its data converted to another scalar type.
    pub fn lift<S: Over<P>>(&self) -> Rotor<S> {
        Rotor {
            mass: S::lift(self.mass),
            centre: self.centre.map(S::lift),
            axis: self.axis.map(S::lift),
            axial: S::lift(self.axial),
            transverse: S::lift(self.transverse),
        }
    }
}
