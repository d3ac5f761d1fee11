//! A scene's bodies with the exact decimals of its file.

use field::{Base, Rational};
use nalgebra::{Matrix3, Vector3};
use systems::gyrostat::{Carrier, Gyrostat, Rotor};

/// The bodies with the exact decimals of the file.
pub fn decimals(bodies: &Gyrostat<f64>) -> Gyrostat<Rational> {
    written(bodies, Rational::decimal)
}

/// The bodies with numbers of another scalar type; the inertia tensor is symmetric.
pub fn written<P: Base>(bodies: &Gyrostat<f64>, number: impl Fn(f64) -> P) -> Gyrostat<P> {
    let vector = |v: &Vector3<f64>| v.map(&number);
    let matrix = |m: &Matrix3<f64>| m.map(&number);
    let (carrier, rotor) = (&bodies.carrier, &bodies.rotor);
    Gyrostat {
        carrier: Carrier {
            mass: number(carrier.mass),
            centre: vector(&carrier.centre),
            inertia: matrix(&((carrier.inertia + carrier.inertia.transpose()) * 0.5)),
        },
        rotor: Rotor {
            mass: number(rotor.mass),
            centre: vector(&rotor.centre),
            axis: vector(&rotor.axis),
            axial: number(rotor.axial),
            transverse: number(rotor.transverse),
        },
        gravity: number(bodies.gravity),
    }
}
