//! Conditions on the data: the bodies can exist, and their motion is determined.

use super::Gyrostat;
use nalgebra::{Matrix3, Vector3};
use std::fmt;

/// The violation of a condition, relative to the norm of the tensor, that counts as rounding of the input.
const ROUNDING: f64 = 1e-12;

/// A condition that the data violate, with the value.
#[derive(Clone, Debug, PartialEq)]
pub enum Inadmissible {
    /// A datum is infinite or not a number.
    NotFinite { quantity: &'static str, value: f64 },
    /// A datum must be positive.
    NotPositive { quantity: &'static str, value: f64 },
    /// The acceleration of gravity may be zero, but not negative.
    NegativeGravity { value: f64 },
    /// The vector l is not a unit vector.
    AxisNotUnit { length: f64 },
    /// The carrier's tensor is not symmetric.
    NotSymmetric { row: usize, column: usize, difference: f64 },
    /// The carrier's tensor has a negative principal moment of inertia.
    Indefinite { moment: f64 },
    /// A principal moment of inertia of the carrier exceeds the sum of the other two.
    Triangle { about: &'static str, largest: f64, sum_of_others: f64 },
    /// For the rotor A' > 2 B', which no body satisfies.
    RotorTriangle { axial: f64, twice_transverse: f64 },
    /// The carrier has no moment of inertia about the rotor's axis: A is singular, D = 0, and the motion is not
    /// determined.
    Undetermined { moment: f64 },
}

impl fmt::Display for Inadmissible {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { quantity, .. } => {
                write!(f, "{quantity} is beyond the range of numbers: a finite number is needed")
            }
            Self::NotPositive { quantity, value } => write!(f, "{quantity} > 0 is broken: it is {value}"),
            Self::NegativeGravity { value } => {
                write!(f, "g >= 0 is broken: it is {value}; the vertical already points downwards")
            }
            Self::AxisNotUnit { length } => {
                write!(f, "|l| = 1 is broken: the rotor's axis has length {length}; divide its components by that")
            }
            Self::NotSymmetric { row, column, difference } => {
                write!(f, "A0[{row}][{column}] = A0[{column}][{row}] is broken: they differ by {difference:e}")
            }
            Self::Indefinite { moment } => {
                write!(f, "A0 positive is broken: its smallest principal moment is {moment:e} kg m^2")
            }
            Self::Triangle { about, largest, sum_of_others } => write!(
                f,
                "the triangle inequality J1 <= J2 + J3 of the carrier's tensor about {about} is broken: \
                 {largest:e} > {sum_of_others:e} kg m^2; no body has such a tensor"
            ),
            Self::RotorTriangle { axial, twice_transverse } => {
                write!(
                    f,
                    "A' <= 2 B' is broken: {axial:e} > {twice_transverse:e} kg m^2; no balanced rotor has such moments"
                )
            }
            Self::Undetermined { moment } => write!(
                f,
                "D > 0 is broken: the smallest principal moment of A = A* - A' l l is {moment:e} kg m^2; a carrier \
                 without inertia about the rotor's axis has no determined motion"
            ),
        }
    }
}

impl std::error::Error for Inadmissible {}

impl Gyrostat<f64> {
    /// Checks that both bodies can exist and that their motion is determined; on failure the error lists all violated
    /// conditions.
    pub fn admissible(&self) -> Result<(), Vec<Inadmissible>> {
        let mut broken = self.not_finite();
        if broken.is_empty() {
            broken = self.too_large();
        }
        if broken.is_empty() {
            self.check_scalars(&mut broken);
            self.check_carrier(&mut broken);
        }
        if broken.is_empty() {
            self.check_motion(&mut broken);
        }
        if broken.is_empty() { Ok(()) } else { Err(broken) }
    }

    fn not_finite(&self) -> Vec<Inadmissible> {
        let (carrier, rotor) = (&self.carrier, &self.rotor);
        let scalars = [
            ("m0", carrier.mass),
            ("m'", rotor.mass),
            ("A'", rotor.axial),
            ("B'", rotor.transverse),
            ("g", self.gravity),
        ];
        let vectors = [("c0", carrier.centre), ("h", rotor.centre), ("l", rotor.axis)];
        scalars
            .into_iter()
            .chain(vectors.into_iter().flat_map(|(name, v)| [v.x, v.y, v.z].map(|x| (name, x))))
            .chain(carrier.inertia.iter().map(|&x| ("A0", x)))
            .filter(|(_, value)| !value.is_finite())
            .map(|(quantity, value)| Inadmissible::NotFinite { quantity, value })
            .collect()
    }

    /// The violations because a derived quantity overflows.
    fn too_large(&self) -> Vec<Inadmissible> {
        let carrier = &self.carrier;
        let sizes = [
            ("m0 |c0|^2", carrier.mass * carrier.centre.norm_squared()),
            ("|A0|", carrier.inertia.norm()),
            ("|A*|", self.full_tensor().norm()),
            ("m g c", self.weight().norm()),
        ];
        let beyond = sizes.into_iter().filter(|(_, value)| !value.is_finite());
        beyond.map(|(quantity, value)| Inadmissible::NotFinite { quantity, value }).collect()
    }

    fn check_scalars(&self, broken: &mut Vec<Inadmissible>) {
        let rotor = &self.rotor;
        for (quantity, value) in
            [("m0", self.carrier.mass), ("m'", rotor.mass), ("A'", rotor.axial), ("B'", rotor.transverse)]
        {
            if value <= 0.0 {
                broken.push(Inadmissible::NotPositive { quantity, value });
            }
        }
        if self.gravity < 0.0 {
            broken.push(Inadmissible::NegativeGravity { value: self.gravity });
        }
        let length = rotor.axis.norm();
        if (length - 1.0).abs() > ROUNDING {
            broken.push(Inadmissible::AxisNotUnit { length });
        }
        if rotor.axial > 2.0 * rotor.transverse * (1.0 + ROUNDING) {
            broken.push(Inadmissible::RotorTriangle { axial: rotor.axial, twice_transverse: 2.0 * rotor.transverse });
        }
    }

    /// Checks the carrier's tensors about O and about its centre of mass: both must be inertia tensors of a body.
    fn check_carrier(&self, broken: &mut Vec<Inadmissible>) {
        let tensor = self.carrier.inertia;
        let size = tensor.norm();
        for (row, column) in [(0, 1), (0, 2), (1, 2)] {
            let difference = tensor[(row, column)] - tensor[(column, row)];
            if difference.abs() > ROUNDING * size {
                broken.push(Inadmissible::NotSymmetric { row: row + 1, column: column + 1, difference });
            }
        }
        if !broken.is_empty() {
            return;
        }
        let (m, c) = (self.carrier.mass, self.carrier.centre);
        let central = tensor - (Matrix3::identity() * c.dot(&c) - c * c.transpose()) * m;
        for (about, tensor) in [("O", tensor), ("its centre of mass", central)] {
            let mut moments: Vector3<f64> = tensor.symmetric_eigenvalues();
            moments.as_mut_slice().sort_by(f64::total_cmp);
            if about == "O" && moments[0] < -ROUNDING * size {
                broken.push(Inadmissible::Indefinite { moment: moments[0] });
                return;
            }
            if moments[2] > moments[0] + moments[1] + ROUNDING * size {
                broken.push(Inadmissible::Triangle {
                    about,
                    largest: moments[2],
                    sum_of_others: moments[0] + moments[1],
                });
                return;
            }
        }
    }

    /// Checks that A is positive definite: only then can the equations of motion be solved for the accelerations.
    fn check_motion(&self, broken: &mut Vec<Inadmissible>) {
        let moment = self.reduced_tensor().symmetric_eigenvalues().min();
        if moment <= ROUNDING * self.full_tensor().norm() {
            broken.push(Inadmissible::Undetermined { moment });
        }
    }
}
