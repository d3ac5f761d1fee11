//! The gyrostat used in the timings, and the windings of its motor.

use dalembert_derivations::machines::multi_current::Windings;
use dalembert_derivations::systems::gyrostat::{Carrier, Gyrostat, Rotor};
use nalgebra::{Matrix3, Vector3};

pub fn gyrostat() -> Gyrostat<f64> {
    Gyrostat {
        carrier: Carrier {
            mass: 1.5,
            centre: Vector3::new(0.01, -0.02, 0.05),
            inertia: Matrix3::new(0.02, 0.001, -0.002, 0.001, 0.03, 0.0005, -0.002, 0.0005, 0.025),
        },
        rotor: Rotor {
            mass: 0.4,
            centre: Vector3::new(0.0, 0.03, 0.04),
            axis: Vector3::new(2.0, -1.0, 2.0) / 3.0,
            axial: 3e-4,
            transverse: 2e-4,
        },
        gravity: 9.81,
    }
}

pub fn windings() -> Windings<f64> {
    Windings {
        field_speed: 30.0,
        b0: 0.05,
        a1: 0.01,
        l1: 0.01,
        r1: 1.0,
        a2: 0.01,
        l2: 0.01,
        r2: 1.0,
        mu: 1e-4,
        f: 1e-4,
    }
}
