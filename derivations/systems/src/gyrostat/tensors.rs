//! The two inertia tensors of the gyrostat and its weight.

use super::{Carrier, Gyrostat, Rotor};
use field::Base;
use nalgebra::{Matrix3, Vector3};

impl<P: Base> Gyrostat<P> {
    /// The inertia tensor A*, kg m^2, of all masses about O, including the rotor; computed from the mass points.
    pub fn full_tensor(&self) -> Matrix3<P> {
        let points = self.rotor_points::<P>();
        let (m, h) = (self.rotor.mass, self.rotor.centre);
        self.carrier.inertia + points.inertia() + (Matrix3::identity() * h.dot(&h) - h * h.transpose()) * m
    }

    /// The tensor A = A* - A' l l^T, kg m^2, without the rotor's moment of inertia about its axis; computed from the
    /// mass points of a rotor without it, since in the difference of the two tensors the digits that determine 1/D
    /// would cancel.
    pub fn reduced_tensor(&self) -> Matrix3<P> {
        Gyrostat { rotor: Rotor { axial: P::zero(), ..self.rotor }, ..*self }.full_tensor()
    }

    /// The vector Gamma e = g (m0 c0 + m' h), N m; the torque of the weight about O is (Gamma e) x v.
    pub fn weight(&self) -> Vector3<P> {
        self.first_moment() * self.gravity
    }

    /// The gyrostat with its data in axes whose unit vectors are the columns of `axes`.
    pub fn in_axes(&self, axes: &Matrix3<P>) -> Self {
        let back = axes.transpose();
        Gyrostat {
            carrier: Carrier {
                centre: back * self.carrier.centre,
                inertia: back * self.carrier.inertia * axes,
                ..self.carrier
            },
            rotor: Rotor { centre: back * self.rotor.centre, axis: back * self.rotor.axis, ..self.rotor },
            gravity: self.gravity,
        }
    }
}

/// The principal moments of a symmetric tensor, in ascending order, and its principal axes (columns, right-handed).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Principal {
    pub moments: Vector3<f64>,
    pub axes: Matrix3<f64>,
}

impl Principal {
    /// The principal axes, from the eigenvectors. The third axis completes a right-handed frame. The largest component
    /// of each of the first two axes is positive, so that the frame is unique.
    pub fn of(tensor: &Matrix3<f64>) -> Self {
        let eigen = tensor.symmetric_eigen();
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| eigen.eigenvalues[i].total_cmp(&eigen.eigenvalues[j]));
        let oriented = |i: usize| {
            let v: Vector3<f64> = eigen.eigenvectors.column(i).into();
            if v[v.iamax()] < 0.0 { -v } else { v }
        };
        let (first, second) = (oriented(order[0]), oriented(order[1]));
        Principal {
            moments: Vector3::from_fn(|i, _| eigen.eigenvalues[order[i]]),
            axes: Matrix3::from_columns(&[first, second, first.cross(&second)]),
        }
    }
}

/// Derived data: both tensors with their principal axes, and the weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derived {
    /// The principal axes of A.
    pub reduced: Principal,
    /// The principal axes of A*.
    pub full: Principal,
    /// The rotation matrix whose columns are the axes of A* in the axes of A.
    pub rotation: Matrix3<f64>,
    /// The position c = OC of the common centre of mass, m, in the axes of the data.
    pub centre: Vector3<f64>,
    /// Gamma = m g |c|, N m.
    pub gamma: f64,
    /// The direction e = c / |c|; zero if c is zero, since e is then undefined.
    pub direction: Vector3<f64>,
    /// The quotient D = det A / det A*.
    pub singularity: f64,
}

impl Gyrostat<f64> {
    /// Both tensors with their principal axes, and the weight.
    pub fn derived(&self) -> Derived {
        let (reduced, full) = (Principal::of(&self.reduced_tensor()), Principal::of(&self.full_tensor()));
        let centre = self.first_moment() / self.mass();
        let distance = centre.norm();
        Derived {
            reduced,
            full,
            rotation: reduced.axes.transpose() * full.axes,
            centre,
            gamma: self.mass() * self.gravity * distance,
            direction: if distance > 0.0 { centre / distance } else { Vector3::zeros() },
            singularity: reduced.moments.product() / full.moments.product(),
        }
    }
}
