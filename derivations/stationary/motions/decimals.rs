//! A scene's bodies as the fractions that its file writes.

use crate::systems::gyrostat::{Carrier, Gyrostat, Rotor};
use field::Rational;
use nalgebra::{Matrix3, Vector3};

/// The same bodies with the decimals that were written.
pub fn decimals(bodies: &Gyrostat<f64>) -> Gyrostat<Rational> {
    let vector = |v: &Vector3<f64>| v.map(Rational::decimal);
    let matrix = |m: &Matrix3<f64>| m.map(Rational::decimal);
    let (carrier, rotor) = (&bodies.carrier, &bodies.rotor);
    Gyrostat {
        carrier: Carrier {
            mass: Rational::decimal(carrier.mass),
            centre: vector(&carrier.centre),
            inertia: matrix(&((carrier.inertia + carrier.inertia.transpose()) * 0.5)),
        },
        rotor: Rotor {
            mass: Rational::decimal(rotor.mass),
            centre: vector(&rotor.centre),
            axis: vector(&rotor.axis),
            axial: Rational::decimal(rotor.axial),
            transverse: Rational::decimal(rotor.transverse),
        },
        gravity: Rational::decimal(bodies.gravity),
    }
}
